// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/projection.hpp"

#include <gtest/gtest.h>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

/// The reference: every voxel of the map, one by one.
std::int8_t column(const OctoMapper& map, const HeightBand& band, float x, float y) {
  std::int8_t value = -1;
  for (int z = VoxelLattice::kMiddle - 100; z < VoxelLattice::kMiddle + 100; ++z) {
    if (!band.contains(map.lattice(), z)) continue;
    const auto log_odds = map.log_odds({x, y, static_cast<float>(map.lattice().centre(z))});
    if (log_odds && *log_odds >= 0.0F) return 100;
    if (log_odds) value = 0;
  }
  return value;
}

void expect_same(const OctoMapper& map, const HeightBand& band, const Projection::Grid& grid) {
  ASSERT_EQ(grid.cells.size(), grid.width * grid.height);
  std::size_t known = 0;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const double x = grid.x + grid.resolution * (static_cast<double>(i % grid.width) + 0.5);
    const std::size_t row = i / grid.width;
    const double y = grid.y + grid.resolution * (static_cast<double>(row) + 0.5);
    ASSERT_EQ(grid.cells[i], column(map, band, static_cast<float>(x), static_cast<float>(y)))
        << x << " " << y;
    known += grid.cells[i] >= 0 ? 1 : 0;
  }
  EXPECT_GT(known, 50U);
}

TEST(Projection, equals_a_walk_through_all_voxels_after_every_cloud) {
  Random random(4);
  OctoMapper::Options options;
  options.resolution = 0.2;
  for (const HeightBand& band : {HeightBand{}, HeightBand{-0.3, 0.9}, HeightBand{0.1, 0.15}}) {
    OctoMapper map(options);
    Projection projection(band);
    for (int i = 0; i < 6; ++i) {
      map.insert(random_cloud(random, 60, 4.0, 0.2), random_pose(random, 1.0));
      projection.follow(map, 0);
      expect_same(map, band, projection.grid());
    }
  }
}

TEST(Projection, starts_anew_with_another_map) {
  Random random(5);
  OctoMapper::Options options;
  options.resolution = 0.2;
  OctoMapper first(options);
  OctoMapper second(options);
  first.insert(random_cloud(random, 100, 5.0, 0.2), random_pose(random, 1.0));
  second.insert(random_cloud(random, 100, 3.0, 0.2), random_pose(random, 1.0));
  Projection projection(HeightBand{});
  projection.follow(first, 0);
  projection.follow(second, 1);
  expect_same(second, HeightBand{}, projection.grid());
}

TEST(Projection, of_nothing_has_no_cells) {
  Projection projection(HeightBand{});
  projection.follow(OctoMapper(OctoMapper::Options{}), 0);
  EXPECT_TRUE(projection.grid().cells.empty());
  EXPECT_THROW(Projection(HeightBand{1.0, 1.0}), OptionsError);
}

}  // namespace
}  // namespace portolan::octo_test
