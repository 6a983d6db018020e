// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/diagnosis.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <string>

namespace portolan {

namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

void add_counts(const Tally& tally, DiagnosticStatusWrapper& status) {
  status.add(tally.noun() + " received", tally.received());
  status.add(tally.noun() + " used", tally.used());
  const auto reasons = enum_names(Drop{});
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    const std::uint64_t count = tally.dropped(static_cast<Drop>(i));
    if (count > 0) status.add(tally.noun() + " dropped: " + reasons[i], count);
  }
}

}  // namespace

void Diagnosis::fill(const std::vector<Tally>& tallies, DiagnosticStatusWrapper& status) {
  past_.resize(tallies.size());
  std::string line;
  bool any_used = false;
  bool starving = false;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    line += (line.empty() ? "" : "; ") + tallies[i].sentence();
    any_used = any_used || tallies[i].used() > 0;
    starving = is_starving(i, tallies[i]) || starving;
    add_counts(tallies[i], status);
  }
  const bool good = any_used && !starving;
  status.summary(good ? DiagnosticStatus::OK : DiagnosticStatus::WARN, line);
}

bool Diagnosis::is_starving(std::size_t input, const Tally& tally) {
  constexpr std::size_t kCalls = 5;
  std::deque<Tally>& past = past_[input];
  const bool starving =
      !past.empty() && tally.lost() > past.front().lost() && tally.used() == past.front().used();
  past.push_back(tally);
  if (past.size() > kCalls) past.pop_front();
  return starving;
}

}  // namespace portolan
