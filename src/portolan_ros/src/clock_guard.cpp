// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/clock_guard.hpp"

namespace portolan {

bool ClockGuard::ran_back(Time now) {
  const bool back = newest_ && now + tolerance_ < *newest_;
  if (!newest_ || now > *newest_ || back) newest_ = now;
  return back;
}

}  // namespace portolan
