// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/grid_mapper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "portolan/grid/cell_rows.hpp"

namespace portolan {
namespace {

using Picture = std::vector<std::string>;

GridOptions coarse() {
  GridOptions options;
  options.resolution = 1.0;
  return options;
}

// Rows from high y to low y: ' ' never observed, '.' free, '#' occupied.
Picture picture(const GridMapper& map, const CellRect& rect) {
  const std::vector<std::int8_t> cells = map.occupancy(rect);
  Picture rows(static_cast<std::size_t>(rect.height()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t row = rows.size() - 1 - i / static_cast<std::size_t>(rect.width());
    rows[row] += cells[i] < 0 ? ' ' : cells[i] < 50 ? '.' : '#';
  }
  return rows;
}

RangeScan scan(std::vector<float> ranges, double angle_min, double increment) {
  return {angle_min, increment, 0.0, 25.0, std::move(ranges), Pose::Identity()};
}

TEST(GridMapper, DrawsAScanAsTheRegionUpToItsEchoes) {
  GridMapper map(coarse());
  // Three beams at -45, 0 and 45 degrees meet a wall at x = 4.5.
  const auto far = static_cast<float>(4.5 * std::sqrt(2.0));
  EXPECT_EQ(map.insert(scan({far, 4.5F, far}, -M_PI / 4, M_PI / 4), planar_pose(0.5, 0.5, 0.0)),
            Outcome::inserted);
  EXPECT_EQ(picture(map, {{0, -5}, {7, 7}}),
            (Picture{"       ", "   . # ", "  ...  ", "  ...  ", " ....  ", " ....  ", ".....# ",
                     " ....  ", " ....  ", "  ...  ", "  ...# ", "   .   "}));
}

TEST(GridMapper, DrawsThinRaysOnRequest) {
  GridOptions options = coarse();
  options.laser.beam_model = BeamModel::ray;
  GridMapper map(options);
  map.insert(scan({4.0F, 4.0F}, 0.0, M_PI / 2), planar_pose(0.5, 0.5, 0.0));
  EXPECT_EQ(picture(map, {{0, 0}, {5, 5}}), (Picture{"#    ", ".    ", ".    ", ".    ", "....#"}));
}

TEST(GridMapper, DrawsTheConeOfASonar) {
  GridOptions options = coarse();
  options.sonar.max_range = 5.0;
  GridMapper map(options);
  map.insert(RangeEcho{4.0, 0.1, 5.0, M_PI / 2}, planar_pose(0.0, 0.0, M_PI / 4));
  EXPECT_EQ(picture(map, {{-1, -1}, {6, 6}}),
            (Picture{"       ", "       ", " ###   ", " ..##  ", " ...#  ", " ...#  ", "       "}));
}

TEST(GridMapper, SaysNothingWhereNothingReturnedUnlessAsked) {
  const float inf = std::numeric_limits<float>::infinity();
  GridOptions options = coarse();
  options.laser.max_range = 3.0;
  GridMapper ignoring(options);
  EXPECT_EQ(ignoring.insert(scan({inf, inf}, 0.0, 0.1), Pose::Identity()), Outcome::inserted);
  EXPECT_TRUE(ignoring.layers().empty());
  options.laser.no_return = NoReturn::clear;
  options.laser.beam_model = BeamModel::ray;
  GridMapper clearing(options);
  clearing.insert(scan({inf}, 0.0, 0.1), planar_pose(0.5, 0.5, 0.0));
  EXPECT_EQ(picture(clearing, {{0, 0}, {5, 1}}), (Picture{"...  "}));
}

TEST(GridMapper, RejectsWildPosesAndRefusesMalformedData) {
  GridMapper map(coarse());
  const auto z = scan({4.0F}, 0.0, 0.1);
  EXPECT_EQ(map.insert(z, planar_pose(1001.0, 0.0, 0.0)), Outcome::rejected);
  EXPECT_EQ(map.insert(z, planar_pose(0.0, NAN, 0.0)), Outcome::rejected);
  EXPECT_EQ(map.insert(z, Pose(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()))),
            Outcome::rejected);
  EXPECT_EQ(map.insert(scan({}, 0.0, 0.1), Pose::Identity()), Outcome::unusable);
  EXPECT_EQ(map.insert(RangeEcho{1.0, 0.0, 2.0, 0.0}, Pose::Identity()), Outcome::unusable);
  EXPECT_EQ(map.insert(PointCloud{}, Pose::Identity()), Outcome::unusable);
  EXPECT_EQ(map.revision(), 0U);
  EXPECT_TRUE(map.bounds().empty());
}

TEST(GridMapper, SaturatesAtItsLimits) {
  GridMapper map(coarse());
  for (int i = 0; i < 100; ++i) map.insert(scan({4.0F}, 0.0, 0.1), planar_pose(0.5, 0.5, 0.0));
  EXPECT_NEAR(*map.probability({2, 0}), 0.02, 0.002);
  EXPECT_NEAR(*map.probability({4, 0}), 0.98, 0.002);
}

TEST(GridMapper, TellsWhatChangedSinceARevision) {
  GridMapper map(coarse());
  map.insert(scan({4.0F}, 0.0, 0.1), planar_pose(0.5, 0.5, 0.0));
  const std::uint64_t before = map.revision();
  EXPECT_TRUE(map.changed_since(before).empty());
  map.insert(scan({4.0F}, 0.0, 0.1), planar_pose(500.5, 0.5, 0.0));
  const CellRect changed = map.changed_since(before);
  EXPECT_TRUE(changed.contains({504, 0}));
  EXPECT_LT(changed.width(), 2 * TileMap::kSide + 1);
  EXPECT_TRUE(map.changed_since(0).contains({4, 0}));
}

TEST(GridMapper, TakesMemoryByVisitedArea) {
  GridMapper near(coarse());
  GridMapper far(coarse());
  for (double x : {-900.0, 0.0, 900.0}) {
    near.insert(scan({4.0F}, 0.0, 0.1), planar_pose(x / 900.0, 0.5, 0.0));
    far.insert(scan({4.0F}, 0.0, 0.1), planar_pose(x, x, 0.0));
  }
  EXPECT_LT(byte_size(far), byte_size(near) + 10 * sizeof(TileMap::Tile));
}

// Glass lets the laser through and a curtain swallows the sonar's ping.
TEST(GridMapper, KeepsGlassSeenBySonarAndACurtainSeenByLaser) {
  GridOptions options;
  options.sonar.no_return = NoReturn::clear;
  GridMapper map(options);
  const Pose to_glass = planar_pose(0.025, 0.025, 0.0);
  const Pose to_curtain = planar_pose(0.025, 0.025, M_PI);
  for (int i = 0; i < 20; ++i) {
    map.insert(scan({6.0F, 6.0F, 6.0F}, -0.1, 0.1), to_glass);
    map.insert(RangeEcho{2.0, 0.02, 5.0, 0.5}, to_glass);
    map.insert(scan({2.0F, 2.0F, 2.0F}, -0.1, 0.1), to_curtain);
    map.insert(RangeEcho{std::numeric_limits<double>::infinity(), 0.02, 5.0, 0.5}, to_curtain);
  }
  const Cell glass{40, 0};
  const Cell curtain{-40, 0};
  EXPECT_LT(*map.probability(GridLayer::laser, glass), 0.1);
  EXPECT_LT(*map.probability(GridLayer::sonar, curtain), 0.1);
  EXPECT_GT(*map.probability(glass), 0.9);
  EXPECT_GT(*map.probability(curtain), 0.9);
  EXPECT_LT(*map.probability({20, 0}), 0.1);
  EXPECT_LT(*map.probability({-20, 0}), 0.1);
}

// Figure 8b: a sonar that turns on a circle in a box sees all but the circle's inside.
TEST(GridMapper, LeavesARoundUnknownRegionInsideATurningSonar) {
  constexpr double kHalfBox = 0.46;
  constexpr double kRadius = 0.12;
  GridOptions options;
  options.resolution = 0.02;
  options.sonar.margin = 0.02;
  GridMapper map(options);
  for (int i = 0; i < 720; ++i) {
    const double heading = i * M_PI / 90.0;
    const double x = kRadius * std::cos(heading);
    const double y = kRadius * std::sin(heading);
    double range = std::numeric_limits<double>::infinity();
    for (double off = -0.25; off <= 0.25; off += 0.01) {  // the nearest wall within the cone
      const double c = std::cos(heading + off);
      const double s = std::sin(heading + off);
      range = std::min(
          {range, (std::copysign(kHalfBox, c) - x) / c, (std::copysign(kHalfBox, s) - y) / s});
    }
    map.insert(RangeEcho{range, 0.02, 2.5, 0.5}, planar_pose(x, y, heading));
  }
  for (int y = -22; y < 22; ++y) {
    for (int x = -22; x < 22; ++x) {
      const double radius = std::hypot(x + 0.5, y + 0.5) * options.resolution;
      const auto p = map.probability({x, y});
      if (radius < kRadius - 0.02) {
        EXPECT_FALSE(p.has_value()) << x << ", " << y;
      } else if (radius > kRadius + 0.02 && radius < 0.42) {
        EXPECT_LT(p.value_or(1.0), 0.2) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(map.probability({22, 0}).value_or(0.0), 0.8);  // 0.45 m: a wall
  EXPECT_GT(map.probability({0, -23}).value_or(0.0), 0.8);
}

TEST(UpdateCells, IsTheSameWithAndWithoutWideVectors) {
  std::uint64_t state = 1;
  const auto random = [&state] {
    return state = state * 6364136223846793005U + 1442695040888963407U;
  };
  const CellUpdate update = LogOdds(GridOptions{}).update(LaserModel{});
  for (int round = 0; round < 50; ++round) {
    TileMap::Tile tile;
    TileBits free, occupied;
    for (CellByte& cell : tile.cells) cell = static_cast<CellByte>(random() >> 56);
    for (std::size_t i = 0; i < free.size(); ++i) {
      free[i] = i % 4 == 0 ? ~std::uint64_t{0} : i % 4 == 1 ? 0 : random();
      occupied[i] = i % 3 == 0 ? 0 : random() & random();
    }
    TileMap::Tile portable = tile;
    update_cells(tile, free, occupied, update);
    cell_rows_detail::update_cells_portably(portable, free, occupied, update);
    EXPECT_EQ(tile.cells, portable.cells);
  }
}

}  // namespace
}  // namespace portolan
