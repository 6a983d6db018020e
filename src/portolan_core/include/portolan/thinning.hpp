// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>

#include "portolan/options.hpp"
#include "portolan/pose.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// Tells the sensors of one robot apart; any numbering will do.
using SensorId = std::uint32_t;

/// The doorkeeper of a map: lets a sensor's next observation in when the sensor has travelled,
/// turned or waited enough since its last one.
class Thinning {
 public:
  struct Options {
    double min_travel = 0.0;
    double min_turn = 0.0;
    double min_interval = 0.0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("min_travel", self.min_travel,
            "insert again once the sensor has moved so far [m]; 0: do not wait for it",
            at_least(0.0));
      visit("min_turn", self.min_turn,
            "insert again once the sensor has turned so far [rad]; 0: do not wait for it",
            at_least(0.0));
      visit("min_interval", self.min_interval,
            "insert again once so much time has passed [s]; 0: do not wait for it", at_least(0.0));
    }
  };

  explicit Thinning(const Options& options) : options_(checked(options)) {}

  /// Whether the observation may enter. An option at 0 asks for nothing: with all three at 0
  /// everything enters, otherwise the first of those above 0 that is fulfilled opens the door.
  /// Time that runs back opens it too.
  bool admits(Time stamp, const Pose& T_odom_sensor, SensorId sensor) const;

  /// The sensor's observation entered: its next one is measured from here.
  void remember(Time stamp, const Pose& T_odom_sensor, SensorId sensor);

 private:
  struct Entry {
    Time stamp;
    Pose T_odom_sensor;
  };

  bool has_changed_enough(const Entry& last, const Entry& now) const;

  Options options_;
  std::map<SensorId, Entry> last_;
};

}  // namespace portolan
