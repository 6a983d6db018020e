// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/cone_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace portolan {
namespace {

// Cones of any place, direction, aperture and reach, every other one with its sides along axes and
// its apex at a centre or corner.
ConeRows random_cone(std::mt19937& random) {
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const bool is_round = any(random) < 0.5;
  const int wedges = 1 + static_cast<int>(4.0 * any(random));
  const double step = is_round ? M_PI / 2.0 : M_PI / 2.0 * any(random);
  const double start = is_round ? 0.0 : 2.0 * M_PI * any(random);
  const auto side = [&](int i) {
    const double angle = start + i * step;
    return FinePoint{static_cast<std::int32_t>(std::lround(1e5 * std::cos(angle))),
                     static_cast<std::int32_t>(std::lround(1e5 * std::sin(angle)))};
  };
  ConeRows cone;
  for (int i = 0; i < wedges; ++i) cone.add(side(i), side(i + 1));
  const int cells = static_cast<int>(60.0 * any(random));
  const std::int64_t reach = std::int64_t{cells} * FinePoint::kCell;
  cone.set_radii(std::max(std::int64_t{0}, reach - 2 * FinePoint::kCell), reach);
  const int grain = is_round ? FinePoint::kCell / 2 : 1;
  std::uniform_int_distribution<int> place(-200 * FinePoint::kCell / grain,
                                           200 * FinePoint::kCell / grain);
  cone.apex = {std::int64_t{grain} * place(random), std::int64_t{grain} * place(random)};
  const Cell apex{static_cast<std::int32_t>(cone.apex.x >> FinePoint::kCellLog2),
                  static_cast<std::int32_t>(cone.apex.y >> FinePoint::kCellLog2)};
  cone.covered = {{apex.x - cells, apex.y - cells}, {apex.x + cells + 1, apex.y + cells + 1}};
  return cone;
}

TEST(ConeRows, AreTheSameWithAndWithoutVectorsOfTheProcessor) {
  std::mt19937 random(1);
  const CellUpdate update = LogOdds(GridOptions{}).update(SonarModel{});
  std::size_t drawn = 0;
  for (std::uint64_t round = 0; round < 500; ++round) {
    const ConeRows cone = random_cone(random);
    TileMap map;
    TileMap portable;
    EXPECT_EQ(cone.apply(map, update, round), cone.apply_portably(portable, update, round));
    ASSERT_EQ(map.tiles().size(), portable.tiles().size()) << "round " << round;
    for (const TileMap::Tile& tile : map.tiles()) {
      const TileMap::Tile* other = portable.find(tile.index);
      ASSERT_NE(other, nullptr) << "round " << round;
      EXPECT_EQ(tile.revision, other->revision);
      ASSERT_TRUE(tile.cells == other->cells) << "round " << round;
      drawn += 1;
    }
  }
  EXPECT_GT(drawn, 500U);
}

}  // namespace
}  // namespace portolan
