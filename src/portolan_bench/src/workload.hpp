// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/grid/grid_mapper.hpp"

namespace portolan::bench {

/// What one sensor saw from known poses, to be drawn into a map by ours and by others.
struct Workload {
  struct Reading {
    GridMapper::Observation z;
    Pose T_map_sensor;
  };

  std::string name;
  double max_range = 0.0;  // [m]
  std::vector<Reading> readings;

  /// What lies within reach of the sensor, wherever it stood, and 2 m more.
  Eigen::AlignedBox2d extent() const;
};

/// Rooms of 6 m with doors, and a hall of 30 m x 20 m with pillars; `beams` over `aperture` [rad],
/// ranges with 1 cm of noise, +Inf beyond `max_range`.
Workload rooms(int beams, double aperture, double max_range);
Workload hall(int beams, double aperture, double max_range);

/// Echoes of a sonar of 30 degrees, all with this range [m]: from one place again and again, or on
/// the way through such rooms, where caches know the map less and branches the cone.
Workload pings(double range, bool on_the_way);

/// The workloads of scans, synthetic ones and, where it is found, the real log: the file that
/// PORTOLAN_RAWLOG names, or the one that MRPT's data package installs.
const std::vector<Workload>& workloads();

}  // namespace portolan::bench
