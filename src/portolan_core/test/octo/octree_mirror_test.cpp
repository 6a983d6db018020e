// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octree_mirror.hpp"

#include <gtest/gtest.h>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

TEST(OctreeMirror, of_nothing_is_empty) {
  const OctoMapper map{OctoMapper::Options{}};
  OctreeMirror mirror(map.options());
  mirror.follow(map, 0);
  EXPECT_EQ(mirror.tree().size(), 0U);
  EXPECT_EQ(octree(map).getRoot(), nullptr);
}

TEST(OctreeMirror, starts_anew_with_another_map) {
  Random random(1);
  OctoMapper::Options options;
  OctoMapper first(options);
  OctoMapper second(options);
  first.insert(random_cloud(random, 100, 3.0, 0.05), random_pose(random, 1.0));
  second.insert(random_cloud(random, 100, 2.0, 0.05), random_pose(random, 1.0));
  OctreeMirror mirror(options);
  mirror.follow(first, 0);
  mirror.follow(second, 1);
  EXPECT_EQ(bytes(mirror.tree()), bytes(octree(second)));
  mirror.follow(OctoMapper(options), 2);
  EXPECT_EQ(mirror.tree().size(), 0U);
  mirror.follow(first, 3);
  EXPECT_EQ(bytes(mirror.tree()), bytes(octree(first)));
}

TEST(OctreeMirror, opens_and_closes_pruned_nodes_as_voxels_change) {
  OctoMapper::Options options;
  options.resolution = 0.1;
  OctoMapper map(options);
  OctreeMirror mirror(options);
  const ClearBox all{{Eigen::Vector3d(-9, -9, -9), Eigen::Vector3d(9, 9, 9)}};
  Random random(2);
  PointCloud dense = random_cloud(random, 3000, 0.6, 0.1);
  for (int i = 0; i < 6; ++i) {
    map.insert(dense, Pose::Identity());
    mirror.follow(map, 0);
    ASSERT_EQ(bytes(mirror.tree()), bytes(octree(map)));
    map.insert(all, Pose::Identity());  // all known voxels are equal now
    mirror.follow(map, 0);
    ASSERT_EQ(bytes(mirror.tree()), bytes(octree(map)));
    EXPECT_LT(mirror.tree().getNumLeafNodes(), count_of_known(map) / 2);
  }
}

}  // namespace
}  // namespace portolan::octo_test
