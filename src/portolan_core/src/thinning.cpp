// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/thinning.hpp"

namespace portolan {

bool Thinning::admits(Time stamp, const Pose& T_odom_sensor, SensorId sensor) const {
  const auto last = last_.find(sensor);
  return last == last_.end() || has_changed_enough(last->second, {stamp, T_odom_sensor});
}

void Thinning::remember(Time stamp, const Pose& T_odom_sensor, SensorId sensor) {
  last_[sensor] = {stamp, T_odom_sensor};
}

bool Thinning::has_changed_enough(const Entry& last, const Entry& now) const {
  const Pose moved = last.T_odom_sensor.inverse() * now.T_odom_sensor;
  const double passed = to_seconds(now.stamp - last.stamp);
  const auto reached = [](double limit, double value) { return limit > 0.0 && value >= limit; };
  const bool asks_for_nothing =
      options_.min_travel == 0.0 && options_.min_turn == 0.0 && options_.min_interval == 0.0;
  return asks_for_nothing || passed < 0.0 ||
         reached(options_.min_travel, moved.translation().norm()) ||
         reached(options_.min_turn, rotation_angle(moved)) ||
         reached(options_.min_interval, passed);
}

}  // namespace portolan
