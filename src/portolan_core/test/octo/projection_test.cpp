// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/projection.hpp"

#include <gtest/gtest.h>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

bool is_occupied(const OctoMapper& map, const octomap::point3d& p) {
  const auto log_odds = map.log_odds(p);
  return log_odds && *log_odds >= 0.0F;
}

bool is_speckle(const OctoMapper& map, const octomap::point3d& p) {
  const auto step = static_cast<float>(map.lattice().resolution());
  for (int i = 0; i < 27; ++i) {
    const int x = i % 3 - 1;
    const int y = i / 3 % 3 - 1;
    const int z = i / 9 - 1;
    const octomap::point3d way(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    if (i != 13 && is_occupied(map, p + way * step)) return false;
  }
  return true;
}

/// The reference: every voxel of the map, one by one.
std::int8_t column(const OctoMapper& map, const Shown& shown, float x, float y) {
  std::int8_t value = -1;
  for (int z = VoxelLattice::kMiddle - 100; z < VoxelLattice::kMiddle + 100; ++z) {
    if (!shown.band.contains(map.lattice(), z)) continue;
    const octomap::point3d p(x, y, static_cast<float>(map.lattice().centre(z)));
    if (is_occupied(map, p) && !(shown.hides_speckles && is_speckle(map, p))) return 100;
    if (map.log_odds(p)) value = 0;
  }
  return value;
}

void expect_same(const OctoMapper& map, const Shown& shown, const Projection::Grid& grid) {
  ASSERT_EQ(grid.cells.size(), grid.width * grid.height);
  std::size_t known = 0;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const double x = grid.x + grid.resolution * (static_cast<double>(i % grid.width) + 0.5);
    const std::size_t row = i / grid.width;
    const double y = grid.y + grid.resolution * (static_cast<double>(row) + 0.5);
    ASSERT_EQ(grid.cells[i], column(map, shown, static_cast<float>(x), static_cast<float>(y)))
        << x << " " << y;
    known += grid.cells[i] >= 0 ? 1 : 0;
  }
  EXPECT_GT(known, 50U);
}

TEST(Projection, equals_a_walk_through_all_voxels_after_every_cloud) {
  Random random(4);
  OctoMapper::Options options;
  options.resolution = 0.2;
  const std::vector<Shown> all = {
      {}, {{-0.3, 0.9}}, {{0.1, 0.15}}, {{}, true}, {{-0.3, 0.9}, true}};
  for (const Shown& shown : all) {
    OctoMapper map(options);
    Projection projection(shown);
    for (int i = 0; i < 6; ++i) {
      map.insert(random_cloud(random, 60, 4.0, 0.2), random_pose(random, 1.0));
      projection.follow(map, 0);
      expect_same(map, shown, projection.grid());
      EXPECT_EQ(projection.area(), static_cast<double>(projection.grid().cells.size()));
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
  Projection projection(Shown{});
  projection.follow(first, 0);
  projection.follow(second, 1);
  expect_same(second, Shown{}, projection.grid());
}

TEST(Projection, of_nothing_has_no_cells) {
  Projection projection(Shown{});
  projection.follow(OctoMapper(OctoMapper::Options{}), 0);
  EXPECT_TRUE(projection.grid().cells.empty());
  EXPECT_EQ(projection.area(), 0.0);
  EXPECT_THROW(Projection(Shown{{1.0, 1.0}}), OptionsError);
}

}  // namespace
}  // namespace portolan::octo_test
