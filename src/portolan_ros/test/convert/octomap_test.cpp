// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/octomap.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>
#include <string>

#include "octo_maps.hpp"
#include "portolan/octo/octree_mirror.hpp"

namespace portolan::ros_convert {
namespace {

std::stringstream nodes_of(const octomap_msgs::Octomap& message) {
  std::stringstream nodes;
  nodes.write(reinterpret_cast<const char*>(message.data.data()),
              static_cast<std::streamsize>(message.data.size()));
  return nodes;
}

// The readers: what users of the published message do to get their tree.
octomap::OcTree read_binary(const octomap_msgs::Octomap& message) {
  octomap::OcTree tree(message.resolution);
  std::stringstream nodes = nodes_of(message);
  tree.readBinaryData(nodes);
  return tree;
}

octomap::OcTree read_full(const octomap_msgs::Octomap& message) {
  octomap::OcTree tree(message.resolution);
  std::stringstream nodes = nodes_of(message);
  tree.readData(nodes);
  return tree;
}

TEST(OctomapMessage, FullCarriesEveryLeafAndItsLogOdds) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const octomap::OcTree tree = octree(octo_map(seed));
    const octomap_msgs::Octomap message = octomap_full(tree);
    EXPECT_FALSE(message.binary);
    EXPECT_EQ(message.id, "OcTree");
    EXPECT_DOUBLE_EQ(message.resolution, 0.1);
    const octomap::OcTree read = read_full(message);
    EXPECT_GT(read.size(), 1000u);
    EXPECT_TRUE(read == tree);
  }
}

TEST(OctomapMessage, BinaryCarriesWhichLeavesAreOccupied) {
  const octomap::OcTree tree = octree(octo_map(6));
  const octomap_msgs::Octomap message = octomap_binary(tree);
  EXPECT_TRUE(message.binary);
  EXPECT_EQ(message.id, "OcTree");
  const octomap::OcTree read = read_binary(message);
  EXPECT_EQ(read.getNumLeafNodes(), tree.getNumLeafNodes());
  std::size_t occupied = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const octomap::OcTreeNode* node = read.search(leaf.getKey(), leaf.getDepth());
    ASSERT_NE(node, nullptr);
    EXPECT_EQ(read.isNodeOccupied(node), tree.isNodeOccupied(*leaf));
    occupied += tree.isNodeOccupied(*leaf) ? 1 : 0;
  }
  EXPECT_GT(occupied, 100u);
}

TEST(OctomapMessage, OfNothingHoldsNoBytes) {
  const octomap::OcTree tree = octree(OctoMapper(octo_options()));
  EXPECT_TRUE(octomap_full(tree).data.empty());
  EXPECT_TRUE(octomap_binary(tree).data.empty());
}

TEST(VoxelCenters, LieInTheMiddle) {
  const VoxelLattice lattice(0.5);
  const octomap::OcTreeKey first(32768, 32767, 32770);
  const octomap::OcTreeKey second(0, 65535, 32768);
  const sensor_msgs::PointCloud2 cloud = voxel_centers({first, second}, lattice);
  ASSERT_EQ(cloud.width * cloud.height, 2u);
  ASSERT_EQ(cloud.data.size(), std::size_t{cloud.row_step});
  std::array<float, 6> xyz;
  std::memcpy(xyz.data(), cloud.data.data(), sizeof(xyz));
  EXPECT_EQ(xyz, (std::array<float, 6>{0.25F, -0.25F, 1.25F, -16383.75F, 16383.75F, 0.25F}));
  EXPECT_EQ(voxel_centers({}, lattice).width, 0u);
}

TEST(ProjectedMap, KeepsItsCells) {
  const nav_msgs::OccupancyGrid message = projected_map({0.25, -1.0, 2.0, 2, 1, {100, -1}});
  EXPECT_FLOAT_EQ(message.info.resolution, 0.25F);
  EXPECT_EQ(message.info.width, 2u);
  EXPECT_EQ(message.info.height, 1u);
  EXPECT_DOUBLE_EQ(message.info.origin.position.x, -1.0);
  EXPECT_DOUBLE_EQ(message.info.origin.position.y, 2.0);
  EXPECT_DOUBLE_EQ(message.info.origin.orientation.w, 1.0);
  EXPECT_EQ(message.data, (std::vector<std::int8_t>{100, -1}));
}

}  // namespace
}  // namespace portolan::ros_convert
