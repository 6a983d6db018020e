// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace portolan {

/// The sheets of a grid map: one for each kind of sensor, since they see different things.
enum class GridLayer {
  laser,  ///< planar scans
  sonar,  ///< cones
  cloud,  ///< slices of point clouds
};

constexpr std::array<const char*, 3> enum_names(GridLayer) { return {"laser", "sonar", "cloud"}; }

/// All of them, in order.
inline constexpr std::array<GridLayer, 3> kGridLayers = {GridLayer::laser, GridLayer::sonar,
                                                         GridLayer::cloud};

/// How the layers that observed a cell make one map.
enum class Fusion {
  max,     ///< the most occupied one counts: what any sensor sees stands
  sum,     ///< their evidence adds up, as if all sensors saw the same things
  latest,  ///< the one that observed the cell last counts
};

constexpr std::array<const char*, 3> enum_names(Fusion) { return {"max", "sum", "latest"}; }

/// What a planar scan says between its beams.
enum class BeamModel {
  sector,  ///< each beam stands for the angular step about it
  ray,     ///< a beam says something about the cells under it alone
};

constexpr std::array<const char*, 2> enum_names(BeamModel) { return {"sector", "ray"}; }

}  // namespace portolan
