// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/octomap.hpp"

#include <sensor_msgs/PointField.h>

#include <array>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>

namespace portolan::ros_convert {

namespace {

octomap_msgs::Octomap message(const octomap::OcTree& tree, const std::ostringstream& nodes) {
  const std::string bytes = nodes.str();
  octomap_msgs::Octomap message;
  message.id = tree.getTreeType();
  message.resolution = tree.getResolution();
  message.data.assign(bytes.begin(), bytes.end());
  return message;
}

sensor_msgs::PointField coordinate(const char* name, std::uint32_t offset) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = sensor_msgs::PointField::FLOAT32;
  field.count = 1;
  return field;
}

}  // namespace

octomap_msgs::Octomap octomap_binary(const octomap::OcTree& tree) {
  std::ostringstream nodes;
  tree.writeBinaryData(nodes);
  octomap_msgs::Octomap result = message(tree, nodes);
  result.binary = 1;
  return result;
}

octomap_msgs::Octomap octomap_full(const octomap::OcTree& tree) {
  std::ostringstream nodes;
  tree.writeData(nodes);
  return message(tree, nodes);
}

sensor_msgs::PointCloud2 voxel_centers(const std::vector<octomap::OcTreeKey>& voxels,
                                       const VoxelLattice& lattice) {
  sensor_msgs::PointCloud2 cloud;
  cloud.fields = {coordinate("x", 0), coordinate("y", 4), coordinate("z", 8)};
  cloud.point_step = 12;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(voxels.size());
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = 1;
  cloud.data.resize(12 * voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const octomap::point3d p = lattice.centre(voxels[i]);
    const std::array<float, 3> xyz = {p.x(), p.y(), p.z()};
    std::memcpy(&cloud.data[12 * i], xyz.data(), 12);
  }
  return cloud;
}

nav_msgs::OccupancyGrid projected_map(Projection::Grid grid) {
  nav_msgs::OccupancyGrid message;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin.position.x = grid.x;
  message.info.origin.position.y = grid.y;
  message.info.origin.orientation.w = 1.0;
  message.data = std::move(grid.cells);
  return message;
}

}  // namespace portolan::ros_convert
