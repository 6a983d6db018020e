// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/spare_keyframes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "graph/round_drive.hpp"

namespace portolan {
namespace {

constexpr std::size_t kAll = 10000;

// Keyframes half a metre apart: straight on for `away`, then to and fro over four metres.
struct Path {
  explicit Path(std::size_t away, std::size_t count) {
    double x = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double phase = static_cast<double>((i - std::min(i, away)) % 16);
      x = i < away ? -0.5 * static_cast<double>(away - i) : 4.0 - std::abs(0.5 * phase - 4.0);
      add(planar_pose(x, 0.25, i >= away && phase > 8.0 ? M_PI : 0.0));
    }
  }

  void add(const Pose& T) {
    const std::size_t i = keyframes.size();
    Keyframe keyframe;
    keyframe.stamp = Time{seconds(static_cast<double>(i))};
    keyframe.T_odom_base = T;
    keyframe.travelled = 0.5 * static_cast<double>(i);
    keyframes.push_back(keyframe);
    graph.add(GraphPose{static_cast<PoseId>(i), keyframe.stamp, T, i == 0});
    UncertainPose step;
    step.covariance.diagonal() << 1e-4, 1e-4, 0.0, 0.0, 0.0, 1e-4;
    steps.push_back(step);
  }

  std::size_t arc(PoseId from, PoseId to, ArcKind kind, ArcState state) {
    Arc made;
    made.from = from;
    made.to = to;
    made.kind = kind;
    made.state = state;
    return graph.add(made);
  }

  std::vector<std::size_t> spare(std::size_t most) const {
    return spare_keyframes({keyframes, graph}, steps, most, {});
  }

  std::vector<Keyframe> keyframes;
  Graph graph;
  std::vector<UncertainPose> steps;
};

bool contains(const std::vector<std::size_t>& all, std::size_t one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

TEST(SpareKeyframes, AreNoNeighboursAndNotAtTheEnds) {
  const Path path(40, 400);
  const std::vector<std::size_t> spare = path.spare(kAll);
  ASSERT_GT(spare.size(), 100U);
  EXPECT_GT(spare.front(), 0U);
  EXPECT_LT(path.keyframes[spare.back()].travelled, path.keyframes.back().travelled - 29.0);
  const auto adjacent = [](std::size_t a, std::size_t b) { return b <= a + 1; };
  EXPECT_EQ(std::adjacent_find(spare.begin(), spare.end(), adjacent), spare.end());
  EXPECT_EQ(path.spare(7).size(), 7U);
}

TEST(SpareKeyframes, GoFirstWhereTheRobotHasComeBackAndTheOldestOfThem) {
  const Path path(100, 400);
  const std::vector<std::size_t> spare = path.spare(20);
  ASSERT_EQ(spare.size(), 20U);
  EXPECT_GE(spare.front(), 99U);
  EXPECT_LT(spare.back(), 200U);
  EXPECT_TRUE(Path(40, 60).spare(kAll).empty());
}

TEST(SpareKeyframes, AreNotHeldByArcsThatSomebodyMayWant) {
  Path path(0, 400);
  const auto is_spare = [&](PoseId from, PoseId to, ArcKind kind, ArcState state) {
    Path other = path;
    other.arc(from, to, kind, state);
    const auto spare = other.spare(kAll);
    return contains(spare, index_of(from)) && contains(spare, index_of(to));
  };
  const std::vector<std::size_t> free = path.spare(kAll);
  const auto a = static_cast<PoseId>(free[3]);
  const auto b = static_cast<PoseId>(free[60]);
  EXPECT_TRUE(is_spare(a, b, ArcKind::loop, ArcState::rejected));
  EXPECT_TRUE(is_spare(a, b, ArcKind::loop, ArcState::accepted));
  EXPECT_FALSE(is_spare(a, b, ArcKind::loop, ArcState::disabled));
  EXPECT_FALSE(is_spare(a, b, ArcKind::given, ArcState::accepted));
  EXPECT_FALSE(is_spare(a, b, ArcKind::given, ArcState::rejected));
  path.arc(a, 395, ArcKind::loop, ArcState::rejected);  // what is newest may still confirm it
  EXPECT_FALSE(contains(path.spare(kAll), index_of(a)));
}

TEST(SpareKeyframes, GoLastWhereOdometryWentAstray) {
  Path path(0, 400);
  const std::vector<std::size_t> before = path.spare(100);
  const std::size_t one = before[5];
  for (std::size_t i = one; i < path.keyframes.size(); ++i) {
    path.graph.move(i, planar_pose(0.1, 0.0, 0.0) * path.keyframes[i].T_odom_base);
  }
  EXPECT_FALSE(contains(path.spare(100), one));
  EXPECT_TRUE(contains(path.spare(100), before[20]));
}

TEST(SpareKeyframes, AreNotAtTheEndsOfAGap) {
  Path path(0, 400);
  const std::size_t one = path.spare(kAll)[5];
  for (const std::size_t gap : {one, one + 1}) {
    Path torn = path;
    torn.steps[gap].covariance(0, 0) = 1.0;
    EXPECT_FALSE(contains(torn.spare(kAll), gap));
    EXPECT_FALSE(contains(torn.spare(kAll), gap - 1));
  }
}

}  // namespace
}  // namespace portolan
