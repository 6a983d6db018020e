// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

namespace portolan {

/// Somebody's word that nothing stands in a box: known voxels with their centre in it become free.
/// It is an observation like any other, posed and kept, so it bends with what was seen at the time.
struct ClearBox {
  Eigen::AlignedBox3d box;  ///< along the axes of the frame that it is posed in [m]
};

/// What it occupies in memory [byte].
inline std::size_t byte_size(const ClearBox& box) { return sizeof(box); }

}  // namespace portolan
