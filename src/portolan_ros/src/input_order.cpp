// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/input_order.hpp"

#include <algorithm>

namespace portolan {

void InputOrder::note(std::size_t input, Time stamp) {
  oldest_ = oldest_ ? std::min(*oldest_, stamp) : stamp;
  newest_[input] = newest_[input] ? std::max(*newest_[input], stamp) : stamp;
}

bool InputOrder::is_in_turn(std::size_t input, Time stamp) const {
  for (std::size_t other = 0; other < newest_.size(); ++other) {
    if (other == input) continue;
    const std::optional<Time>& newest = newest_[other];
    const bool has_passed = newest && *newest >= stamp;
    const bool is_silent = stamp - newest.value_or(oldest_.value_or(stamp)) > kSilence;
    if (!has_passed && !is_silent) return false;
  }
  return true;
}

void InputOrder::clear() {
  oldest_.reset();
  std::fill(newest_.begin(), newest_.end(), std::nullopt);
}

}  // namespace portolan
