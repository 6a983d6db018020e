// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/grid/grid_layer.hpp"
#include "portolan/observation/range_reading.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// How a grid map believes one kind of sensor: the inverse sensor model of the chapter.
struct InverseSensorModel {
  double p_occupied = 0.75;
  double p_free = 0.25;
  double max_range = 30.0;
  NoReturn no_return = NoReturn::ignore;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("p_occupied", self.p_occupied, "P(cell occupied | it lies where the echo came from)",
          between(0.0, 1.0));
    visit("p_free", self.p_free, "P(cell occupied | the beam passed it)", between(0.0, 1.0));
    visit("max_range", self.max_range,
          "usable range: beyond it an echo only says free up to it [m]", above(0.0));
    visit("no_return", self.no_return, "what a beam without return says");
  }
};

/// The laser's inverse sensor model.
struct LaserModel : InverseSensorModel {
  BeamModel beam_model = BeamModel::sector;
  double margin = 0.05;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    InverseSensorModel::describe(self, visit);
    visit("beam_model", self.beam_model, "what is free: sectors of one angular step, or thin rays");
    visit("margin", self.margin,
          "half depth d of what is taken as occupied along neighbouring echoes [m]; "
          "an echo's cell always is",
          at_least(0.0));
  }
};

/// The sonar's inverse sensor model.
struct SonarModel : InverseSensorModel {
  double margin = 0.05;

  SonarModel() {
    // Cones are wide and often deceived: many must agree, and far ones say little.
    p_occupied = 0.6;
    p_free = 0.45;
    max_range = 2.2;
  }

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    InverseSensorModel::describe(self, visit);
    visit("margin", self.margin,
          "half depth d of the arc about an echo that is taken as occupied [m]; "
          "at least half a cell",
          at_least(0.0));
  }
};

/// The inverse sensor model of point clouds, and which slice of them is mapped.
struct CloudModel : InverseSensorModel {
  double min_z = 0.1;
  double max_z = 1.5;

  CloudModel() { max_range = 10.0; }

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    InverseSensorModel::describe(self, visit);
    visit("min_z", self.min_z, "lower end of the slice, in the map frame [m]");
    visit("max_z", self.max_z, "upper end of the slice, in the map frame [m]");
    visit.require(self.min_z < self.max_z, "min_z must be below max_z");
  }
};

}  // namespace portolan
