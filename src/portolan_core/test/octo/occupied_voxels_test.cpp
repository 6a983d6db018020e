// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/occupied_voxels.hpp"

#include <gtest/gtest.h>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

TEST(OccupiedVoxels, are_those_that_the_library_holds_to_be_occupied) {
  Random random(6);
  OctoMapper::Options options;
  options.resolution = 0.1;
  OctoMapper map(options);
  for (int i = 0; i < 5; ++i) {
    map.insert(random_cloud(random, 200, 2.0, 0.1), random_pose(random, 0.5));
  }
  octomap::OcTree tree = octree(map);
  tree.expand();
  std::size_t expected = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    expected += tree.isNodeOccupied(*leaf) ? 1 : 0;
  }
  const auto voxels = occupied_voxels(map, HeightBand{});
  EXPECT_EQ(voxels.size(), expected);
  for (const auto& key : voxels) EXPECT_TRUE(tree.isNodeOccupied(tree.search(key)));
}

TEST(OccupiedVoxels, outside_of_the_band_do_not_count) {
  OctoMapper::Options options;
  options.resolution = 0.1;
  OctoMapper map(options);
  PointCloud cloud;
  cloud.points = {{1.05F, 0, 0.05F}, {1.05F, 0, 1.05F}, {1.05F, 0, 2.05F}};
  map.insert(cloud, Pose::Identity());
  EXPECT_EQ(occupied_voxels(map, HeightBand{}).size(), 3U);
  EXPECT_EQ(occupied_voxels(map, HeightBand{0.5, 1.5}).size(), 1U);
  EXPECT_EQ(occupied_voxels(map, HeightBand{0.09, 1.02}).size(), 2U);
}

TEST(OccupiedVoxels, that_stand_alone_are_speckles) {
  const octomap::OcTreeKey by_face(10, 10, 10), beside(11, 10, 10);
  const octomap::OcTreeKey by_corner(20, 20, 20), across(21, 21, 21);
  const octomap::OcTreeKey alone(30, 30, 30), near_but_alone(32, 30, 30);
  const octomap::OcTreeKey row_end(40, 40, 65535), next_row(40, 41, 0);
  const std::vector<octomap::OcTreeKey> kept = without_speckles(
      {by_face, beside, by_corner, across, alone, near_but_alone, row_end, next_row});
  EXPECT_EQ(kept, (std::vector<octomap::OcTreeKey>{by_face, beside, by_corner, across}));
}

}  // namespace
}  // namespace portolan::octo_test
