// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/tally_summary.hpp"

#include <algorithm>

namespace portolan {

YAML::Node counts_of(const std::vector<Tally>& tallies) {
  YAML::Node inputs;
  const auto reasons = enum_names(Drop{});
  for (const Tally& tally : tallies) {
    YAML::Node counts = inputs[tally.noun()];
    counts["messages"] = tally.received();
    counts["used"] = tally.used();
    for (std::size_t i = 0; i < reasons.size(); ++i) {
      const std::uint64_t count = tally.dropped(static_cast<Drop>(i));
      if (count > 0) counts["dropped"][reasons[i]] = count;
    }
    counts["in_words"] = tally.sentence();
  }
  return inputs;
}

std::string sentence_of(const std::vector<Tally>& tallies) {
  std::string text;
  for (const Tally& tally : tallies) {
    if (tally.received() > 0) text += (text.empty() ? "" : "; ") + tally.sentence();
  }
  return text.empty() ? "nothing received" : text;
}

bool used_anything(const std::vector<Tally>& tallies) {
  return std::any_of(tallies.begin(), tallies.end(), [](const Tally& t) { return t.used() > 0; });
}

}  // namespace portolan
