// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "grid/random_observations.hpp"
#include "grid/reference_grid.hpp"

namespace portolan {
namespace {

void expect_equal(const GridMapper& map, const ReferenceGrid& reference) {
  std::size_t known = 0;
  for (GridLayer layer : map.layers()) {
    const CellRect& rect = map.bounds(layer);
    for (int y = rect.min.y - 2; y < rect.max.y + 2; ++y) {
      for (int x = rect.min.x - 2; x < rect.max.x + 2; ++x) {
        const std::optional<double> p = map.probability(layer, {x, y});
        const std::optional<double> expected = reference.probability(layer, {x, y});
        known += expected ? 1 : 0;
        ASSERT_EQ(p.has_value(), expected.has_value())
            << "layer " << static_cast<int>(layer) << " cell " << x << ", " << y;
        if (!p) continue;
        ASSERT_NEAR(*p, *expected, 1e-12)
            << "layer " << static_cast<int>(layer) << " cell " << x << ", " << y;
      }
    }
  }
  EXPECT_EQ(known, reference.size());
}

class GridReference : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(GridReference, EqualsTheFastMapCellByCell) {
  RandomObservations random(GetParam());
  const GridOptions options = random.options();
  GridMapper map(options);
  ReferenceGrid reference(options);
  for (int i = 0; i < 12; ++i) {
    const auto z = random.observation(options);
    const Pose T_map_sensor = random.pose(options);
    const Outcome outcome = map.insert(z, T_map_sensor);
    EXPECT_EQ(outcome, Outcome::inserted);
    reference.insert(z, T_map_sensor);
    ASSERT_NO_FATAL_FAILURE(expect_equal(map, reference))
        << "observation " << i << " of kind " << z.index();
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, GridReference, ::testing::Range(0U, 100U));

}  // namespace
}  // namespace portolan
