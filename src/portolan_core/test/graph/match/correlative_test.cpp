// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/correlative.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graph/match/flat_world.hpp"
#include "portolan/graph/match/scan_surface.hpp"

namespace portolan {
namespace {

Surface seen(const FlatWorld& world, const Pose& T_map_sensor, std::uint64_t seed,
             int beams = 180) {
  std::mt19937_64 random(seed);
  return scan_surface(world.scan(T_map_sensor, beams, 0.01, random), SurfaceOptions{});
}

// The best score of the window by trying every pose of it, from the definition.
double best_by_trying(const Surface& target, const Surface& source, const Pose& T_guess,
                      const SearchWindow& window, const CorrelativeOptions& options) {
  const ScorePyramid scores(target.points, options.resolution, options.blur, 1);
  double radius = 0.0;
  for (const Eigen::Vector3d& p : source.points) radius = std::max(radius, p.head<2>().norm());
  const int turns = static_cast<int>(std::ceil(window.turn / (options.resolution / radius)));
  const int cells = static_cast<int>(std::ceil(window.reach / options.resolution));
  int best = 0;
  for (int k = -turns; k <= turns; ++k) {
    const Eigen::AngleAxisd turn(k * window.turn / turns, Eigen::Vector3d::UnitZ());
    for (int x = -cells; x <= cells; ++x) {
      for (int y = -cells; y <= cells; ++y) {
        int sum = 0;
        for (const Eigen::Vector3d& p : source.points) {
          const Eigen::Vector3d q =
              turn.toRotationMatrix() * T_guess.linear() * p + T_guess.translation();
          sum += scores.score(0, scores.cell_of(q.head<2>()) + ScorePyramid::Cell(x, y));
        }
        best = std::max(best, sum);
      }
    }
  }
  return best / (255.0 * static_cast<double>(source.size()));
}

TEST(ScorePyramid, IsNoLargerThanWhatAScannerReaches) {
  const double nan = std::nan("");
  const ScorePyramid scores({{1.0, 2.0, 0.0}, {1e7, 0.0, 0.0}, {0.0, nan, 0.0}}, 0.05, 0.05, 3);
  EXPECT_EQ(scores.score(0, scores.cell_of({1.0, 2.0})), 255);
  EXPECT_EQ(scores.score(0, scores.cell_of({1e7, 0.0})), 0);
}

TEST(CorrelativeMatcher, IsAsGoodAsTryingEveryPose) {
  CorrelativeOptions options;
  options.max_points = 1000;
  options.min_score = 0.01;
  const SearchWindow window{0.7, 0.25};
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Pose T = planar_pose(0.3 - 0.1 * static_cast<double>(seed), 0.2, 0.1);
    const Surface target = seen(room(), Pose::Identity(), seed);
    const Surface source = seen(room(), T, seed + 100);
    const Pose guess = planar_pose(0.1, 0.0, 0.0);
    const auto found =
        CorrelativeMatcher(target, window.reach, options).search(source, guess, window);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->score, best_by_trying(target, source, guess, window, options));
  }
}

TEST(CorrelativeMatcher, FindsFarAndTurned) {
  const Pose T = planar_pose(1.2, -0.8, 0.7);
  const auto found = CorrelativeMatcher(seen(room(), Pose::Identity(), 1), 2.0, {})
                         .search(seen(room(), T, 2), Pose::Identity(), {2.0, 0.8});
  ASSERT_TRUE(found);
  const Pose error = T.inverse() * found->T_target_source;
  EXPECT_LT(error.translation().norm(), 0.15);
  EXPECT_LT(std::abs(yaw(error)), 0.05);
  EXPECT_LT(found->rival, 0.92 * found->score);
}

TEST(CorrelativeMatcher, SeesRivalsAlongACorridor) {
  const Surface target = seen(corridor(), Pose::Identity(), 1, 3600);
  const Surface source = seen(corridor(), planar_pose(0.5, 0, 0), 2);
  const auto found =
      CorrelativeMatcher(target, 3.0, {}).search(source, Pose::Identity(), {3.0, 0.2});
  ASSERT_TRUE(found);
  EXPECT_GT(found->rival, 0.95 * found->score);
}

TEST(CorrelativeMatcher, FindsNothingWhereNothingIs) {
  const Surface target = seen(room(), Pose::Identity(), 1);
  const CorrelativeMatcher matcher(target, 1.0, {});
  EXPECT_FALSE(matcher.search(Surface{}, Pose::Identity(), {1.0, 0.2}));
  EXPECT_FALSE(matcher.search(target, planar_pose(500.0, 0.0, 0.0), {1.0, 0.2}));
  EXPECT_FALSE(CorrelativeMatcher(Surface{}, 1.0, {}).search(target, Pose::Identity(), {1.0, 0.2}));
}

}  // namespace
}  // namespace portolan
