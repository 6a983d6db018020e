// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <octomap/OcTree.h>
#include <octomap_msgs/Octomap.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "portolan/octo/projection.hpp"

// Headers are left to the caller.
namespace portolan::ros_convert {

/// The tree with free and occupied leaves only, for readers that call OcTree::readBinaryData.
octomap_msgs::Octomap octomap_binary(const octomap::OcTree& tree);

/// The tree with its log-odds, for readers that call OcTree::readData.
octomap_msgs::Octomap octomap_full(const octomap::OcTree& tree);

/// The middles of voxels: fields x, y, z [m].
sensor_msgs::PointCloud2 voxel_centers(const std::vector<octomap::OcTreeKey>& voxels,
                                       const VoxelLattice& lattice);

/// The map seen from above: 100 occupied, 0 free, -1 unknown.
nav_msgs::OccupancyGrid projected_map(Projection::Grid grid);

}  // namespace portolan::ros_convert
