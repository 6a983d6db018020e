// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>
#include <octomap/octomap_utils.h>

#include "portolan/options.hpp"

namespace portolan {

/// What one ray tells of the voxels that it crosses and of the one that it ends in; names and
/// defaults of octomap_server.
struct SensorModel {
  double hit = 0.7;
  double miss = 0.4;
  double min = 0.12;
  double max = 0.97;
  double min_range = -1.0;
  double max_range = -1.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("hit", self.hit, "P(occupied | a ray ended there)", between(0.5, 1.0));
    visit("miss", self.miss, "P(occupied | a ray went through)", between(0.0, 0.5));
    visit("min", self.min, "no voxel is held to be freer than this probability", between(0.0, 0.5));
    visit("max", self.max, "no voxel is held to be more occupied than this probability",
          between(0.5, 1.0));
    visit("min_range", self.min_range, "points nearer than this are ignored [m]; below 0: none");
    visit("max_range", self.max_range,
          "points further than this only clear the way so far [m]; below 0: no limit");
  }
};

/// A sensor model in log-odds, as octomap::OcTree computes with them.
struct LogOddsModel {
  float hit;
  float miss;
  float min;
  float max;

  explicit LogOddsModel(const SensorModel& model)
      : hit(octomap::logodds(model.hit)),
        miss(octomap::logodds(model.miss)),
        min(octomap::logodds(model.min)),
        max(octomap::logodds(model.max)) {}
};

/// Gives an octree this sensor model.
inline void configure(octomap::OcTree& tree, const SensorModel& model) {
  tree.setProbHit(model.hit);
  tree.setProbMiss(model.miss);
  tree.setClampingThresMin(model.min);
  tree.setClampingThresMax(model.max);
}

}  // namespace portolan
