// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "portolan/sim/any_sensor.hpp"
#include "portolan/sim/truth_grid.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// What a sensor could have seen so far: the part of the truth that its map can be measured by.
/// Free where its wave passed level, occupied where it met a surface, unknown where it never came.
class View {
 public:
  /// Over the cells of the truth.
  explicit View(const TruthGrid& truth);

  /// Adds all that a perfect laser or sonar ring sees from here, in every direction of its field
  /// of view, not only along its beams. Other sensors see nothing here. A place less than two cells
  /// and 0.05 rad from the last one that the same sensor looked from adds nothing.
  void look(const World& world, const AnySensor& sensor, const Pose& T_map_base);

  const TruthGrid& grid() const { return grid_; }

 private:
  void look(const World& world, const Laser& laser, const Pose& T_map_base);
  void look(const World& world, const SonarRing& ring, const Pose& T_map_base);
  template <class Other>
  void look(const World& /*world*/, const Other& /*sensor*/, const Pose& /*T_map_base*/) {}
  void look_along(const World& world, const Ray& ray, Wave wave, double reach);

  TruthGrid grid_;
  std::map<std::string, Pose> looked_from_;  // by frame of the sensor
};

}  // namespace portolan::sim
