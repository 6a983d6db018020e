// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "portolan/octo/octo_mapper.hpp"
#include "portolan/pose.hpp"
#include "portolan_ros/picture.hpp"

namespace portolan {

/// A 3D map as an X-ray shows it, from above and, below that, from the side (x to the right): the
/// more occupied voxels lie behind each other, the darker. White: nothing occupied there; grey:
/// nothing known. With the robot's way. The map must hold something.
Picture octo_picture(const OctoMapper& map, const std::vector<Pose>& T_map_base);

}  // namespace portolan
