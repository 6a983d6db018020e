// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/still_clock.hpp"

namespace portolan {

bool StillClock::stands(Time now, RealTime real) {
  if (now_ != now) {
    now_ = now;
    since_ = real;
  }
  return real - since_ >= kPatience;
}

}  // namespace portolan
