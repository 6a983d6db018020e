// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/leap_guard.hpp"

#include <algorithm>
#include <utility>

namespace portolan {

StampVerdict LeapGuard::judge(Time stamp) {
  const std::optional<Time> doubtful = std::exchange(doubtful_, std::nullopt);
  if (!newest_ || are_close(stamp, *newest_)) {
    newest_ = newest_ ? std::max(*newest_, stamp) : stamp;
    return StampVerdict::good;
  }
  if (!doubtful || !are_close(stamp, *doubtful)) {
    doubtful_ = stamp;
    return StampVerdict::doubtful;
  }
  const bool back = stamp < *newest_;
  newest_ = stamp;
  return back ? StampVerdict::ran_back : StampVerdict::good;
}

}  // namespace portolan
