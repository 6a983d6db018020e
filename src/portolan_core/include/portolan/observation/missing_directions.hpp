// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace portolan {

/// Where an organised cloud holds no point: unit vectors in the sensor's frame, row by row.
struct MissingDirections {
  std::vector<Eigen::Vector3f> nothing_returned;  ///< a point at infinity along the ray: +Inf
  std::vector<Eigen::Vector3f> unknown;           ///< NaN
};

/// The directions of the places that hold no finite point, by what these say (REP 117 and 118):
/// nothing within reach, or no reading. A point at infinity against its ray, which is -Inf along
/// it, was too near and is among neither.
///
/// `points`: rows of `width` places, one after the other. The rays' directions are found from the
/// points that returned, as those of a pinhole camera (looking along z, or along x) or of a laser
/// that turns evenly about z with a row for each ring. Empty where neither fits to within half a
/// place; a laser's ring of which fewer than two points returned stays silent.
MissingDirections missing_directions(const std::vector<Eigen::Vector3f>& points, std::size_t width);

}  // namespace portolan
