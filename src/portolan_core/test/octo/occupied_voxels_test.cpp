// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/occupied_voxels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

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
  const auto voxels = occupied_voxels(map, Shown{});
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
  EXPECT_EQ(occupied_voxels(map, Shown{}).size(), 3U);
  EXPECT_EQ(occupied_voxels(map, Shown{{0.5, 1.5}}).size(), 1U);
  EXPECT_EQ(occupied_voxels(map, Shown{{0.09, 1.02}}).size(), 2U);
}

/// The reference: every pair of them.
bool touches_another(const std::vector<octomap::OcTreeKey>& voxels, const octomap::OcTreeKey& a) {
  return std::any_of(voxels.begin(), voxels.end(), [&](const octomap::OcTreeKey& b) {
    int apart = 0;
    for (unsigned i = 0; i < 3; ++i) apart = std::max(apart, std::abs(int{a[i]} - int{b[i]}));
    return apart == 1;
  });
}

TEST(OccupiedVoxels, that_stand_alone_are_hidden_on_request) {
  Random random(7);
  OctoMapper::Options options;
  options.resolution = 0.1;
  OctoMapper map(options);
  for (int i = 0; i < 3; ++i) {
    map.insert(random_cloud(random, 150, 1.2, 0.1), random_pose(random, 0.3));
  }
  const HeightBand band{-0.8, 0.7};
  const std::vector<octomap::OcTreeKey> all = occupied_voxels(map, Shown{});
  std::vector<octomap::OcTreeKey> expected;
  for (const octomap::OcTreeKey& key : occupied_voxels(map, Shown{band})) {
    if (touches_another(all, key)) expected.push_back(key);
  }
  const auto kept = occupied_voxels(map, Shown{band, true});
  EXPECT_EQ(kept, expected);
  EXPECT_GT(kept.size(), 20U);
  EXPECT_LT(kept.size(), occupied_voxels(map, Shown{band}).size());
}

TEST(OccupiedVoxels, at_the_edge_of_the_octree_have_no_neighbours_beyond) {
  OctoMapper::Options options;
  options.resolution = 1.0;
  OctoMapper map(options);
  PointCloud cloud;
  const auto edge = static_cast<float>(VoxelLattice::kMiddle);
  cloud.points = {{edge - 0.5F, 0.5F, 0.5F}, {0.5F - edge, 0.5F, 0.5F}};
  map.insert(cloud, Pose::Identity());
  EXPECT_EQ(occupied_voxels(map, Shown{}).size(), 2U);
  EXPECT_TRUE(occupied_voxels(map, Shown{{}, true}).empty());
}

}  // namespace
}  // namespace portolan::octo_test
