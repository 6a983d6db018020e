// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace portolan {

/// Where an organised cloud saw nothing: unit vectors in the sensor's frame for the places that
/// hold no finite point, row by row.
///
/// `points`: rows of `width` places, one after the other. The rays' directions are found from the
/// points that returned, as those of a pinhole camera (looking along z, or along x) or of a laser
/// that turns evenly about z with a row for each ring. Empty where neither fits to within half a
/// place; a laser's ring of which fewer than two points returned stays silent.
std::vector<Eigen::Vector3f> missing_directions(const std::vector<Eigen::Vector3f>& points,
                                                std::size_t width);

}  // namespace portolan
