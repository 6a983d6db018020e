// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <octomap/OcTree.h>

#include <random>
#include <sstream>
#include <string>

#include "portolan/octo/octo_mapper.hpp"
#include "portolan/octo/octree_mirror.hpp"

namespace portolan::octo_test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Pose random_pose(Random& random, double extent) {
  const auto coordinate = [&](double limit) { return uniform(random, -limit, limit); };
  const Eigen::Vector3d axis(coordinate(1.0), coordinate(1.0), coordinate(1.0));
  return Eigen::Translation3d(coordinate(extent), coordinate(extent), coordinate(extent)) *
         Eigen::AngleAxisd(coordinate(3.0), axis.normalized());
}

/// Points around the sensor, some on the axes and on borders of voxels, where rounding decides.
inline PointCloud random_cloud(Random& random, std::size_t size, double reach, double resolution) {
  PointCloud cloud;
  for (std::size_t i = 0; i < size; ++i) {
    Eigen::Vector3d p(uniform(random, -reach, reach), uniform(random, -reach, reach),
                      uniform(random, -reach, reach));
    if (i % 7 == 0) p = (p / resolution).array().round().matrix() * resolution;
    if (i % 11 == 0) p[static_cast<int>(i % 3)] = 0.0;
    if (i % 13 == 0) p = Eigen::Vector3d::Unit(static_cast<int>(i % 3)) * p.x();
    cloud.points.emplace_back(p.cast<float>());
  }
  return cloud;
}

inline octomap::OcTree empty_tree(const OctoMapper::Options& options) {
  octomap::OcTree tree(options.resolution);
  configure(tree, options.sensor_model);
  tree.setOccupancyThres(options.occupancy_threshold);
  return tree;
}

/// The reference: the library itself.
inline void insert(octomap::OcTree& tree, const OctoMapper::Options& options,
                   const PointCloud& cloud, const Pose& T_map_sensor) {
  octomap::Pointcloud points;
  for (const Eigen::Vector3f& p : cloud.points) points.push_back(to_map(T_map_sensor, p));
  tree.insertPointCloud(points, to_map(T_map_sensor, Eigen::Vector3f::Zero()),
                        options.sensor_model.max_range, false, options.discretize);
}

/// How many voxels are known.
inline std::size_t count_of_known(const OctoMapper& map) {
  std::size_t known = 0;
  map.blocks().for_each([&](BlockKey /*key*/, const VoxelBlock& block) {
    for (std::size_t i = 0; i < block.log_odds.size(); ++i) known += block.is_known(i) ? 1 : 0;
  });
  return known;
}

/// Every node of the tree, leaves and inner ones, bit by bit.
inline std::string bytes(const octomap::OcTree& tree) {
  std::ostringstream out;
  tree.writeData(out);
  return out.str();
}

}  // namespace portolan::octo_test
