// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/local_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graph/match/flat_world.hpp"

namespace portolan {
namespace {

Keyframe keyframe_in(const FlatWorld& world, const Pose& T_map_base, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Keyframe keyframe;
  keyframe.T_odom_base = T_map_base;
  keyframe.scan = world.scan(T_map_base, 360, 0.01, random);
  return keyframe;
}

LocalMap map_of(const Keyframe& keyframe) {
  LocalMapMaker maker(SurfaceOptions{});
  maker.add(keyframe, Pose::Identity());
  return std::move(maker).make();
}

TEST(LocalMap, PutsKeyframesTogetherAtTheirPoses) {
  const Keyframe a = keyframe_in(room(), Pose::Identity(), 1);
  Keyframe b = keyframe_in(room(), planar_pose(1.0, 0.5, 0.3), 2);
  b.T_base_sensor.translation().z() = 0.4;
  LocalMapMaker maker(SurfaceOptions{});
  maker.add(a, Pose::Identity());
  maker.add(b, planar_pose(1.0, 0.5, 0.3));
  const LocalMap both = std::move(maker).make();
  EXPECT_EQ(both.views.size(), 2U);
  EXPECT_LT(both.surface.size(), map_of(a).surface.size() + map_of(b).surface.size());
  for (const Eigen::Vector3d& p : both.surface.points) {
    EXPECT_DOUBLE_EQ(p.z(), 0.0);
    EXPECT_LT(std::abs(p.x()), 4.1);
    EXPECT_LT(std::abs(p.y()), 3.1);
  }
}

TEST(LocalMap, LeavesOutWhatABentGraphHasPutFarAway) {
  const Keyframe a = keyframe_in(room(), Pose::Identity(), 1);
  LocalMapMaker maker(SurfaceOptions{});
  maker.add(a, Pose::Identity());
  maker.add(a, planar_pose(1e7, 0.0, 0.0));
  maker.add(a, planar_pose(0.0, std::nan(""), 0.0));
  const LocalMap map = std::move(maker).make();
  EXPECT_EQ(map.views.size(), 1U);
  EXPECT_EQ(map.surface.size(), map_of(a).surface.size());
}

TEST(LocalMap, LeavesOutKeyframesThatForgotWhatTheySaw) {
  const Keyframe a = keyframe_in(room(), Pose::Identity(), 1);
  LocalMapMaker maker(SurfaceOptions{});
  maker.add(Keyframe{}, Pose::Identity());
  maker.add(a, Pose::Identity());
  const LocalMap map = std::move(maker).make();
  EXPECT_EQ(map.views.size(), 1U);
  EXPECT_GT(agreement(map, map_of(a), Pose::Identity(), 0.1).shared, 0.9);
}

TEST(Agreement, IsFullInTheSamePlaceAndLowElsewhere) {
  const Pose T_a_b = planar_pose(0.8, -0.4, 0.5);
  const Keyframe a = keyframe_in(room(), Pose::Identity(), 1);
  const Keyframe b = keyframe_in(room(), T_a_b, 2);
  const LocalMap map_a = map_of(a);
  const LocalMap map_b = map_of(b);
  const Agreement right = agreement(map_a, map_b, T_a_b, 0.1);
  EXPECT_GT(right.shared, 0.6);
  EXPECT_GT(right.agreed, 0.95);
  const Agreement wrong = agreement(map_a, map_b, planar_pose(-0.3, -0.4, 0.5), 0.1);
  EXPECT_LT(wrong.agreed, 0.75);
}

TEST(Agreement, SaysNothingOfWhatIsHidden) {
  FlatWorld near;
  near.box(-1, -1, 1, 1);
  FlatWorld far;
  far.box(-5, -5, 5, 5);
  const Keyframe a = keyframe_in(near, Pose::Identity(), 1);
  const Keyframe b = keyframe_in(far, Pose::Identity(), 2);
  const Agreement different = agreement(map_of(a), map_of(b), Pose::Identity(), 0.1);
  EXPECT_LT(different.shared, 0.5);  // the far walls are hidden from the near room
  EXPECT_LT(different.agreed, 0.05);
}

}  // namespace
}  // namespace portolan
