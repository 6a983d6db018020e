// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/cone_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace portolan {
namespace {

constexpr std::size_t kSide = TileMap::kSide;

// Cones of any direction, aperture and reach, every other one with its sides along axes.
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
  const auto reach = static_cast<std::int64_t>(60.0 * FinePoint::kCell * any(random));
  cone.set_radii(std::max(std::int64_t{0}, reach - 2 * FinePoint::kCell), reach);
  return cone;
}

TEST(ConeRows, AreTheSameWithAndWithoutVectorsOfTheProcessor) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> halves(-60, 180);
  std::size_t drawn = 0;
  for (int round = 0; round < 500; ++round) {
    const ConeRows cone = random_cone(random);
    const double x = 0.5 * halves(random);
    const double y = 0.5 * halves(random);
    TileBits free{}, occupied{}, portably_free{}, portably_occupied{};
    const bool any = draw_rows(cone, x, y, 0, kSide, free, occupied);
    EXPECT_EQ(any, cone_rows_detail::draw_rows_portably(cone, x, y, 0, kSide, portably_free,
                                                        portably_occupied));
    drawn += any ? 1 : 0;
    for (std::size_t i = 0; i < kSide; ++i) {
      ASSERT_EQ(free[i], portably_free[i]) << "round " << round << " row " << i;
      ASSERT_EQ(occupied[i], portably_occupied[i]) << "round " << round << " row " << i;
    }
  }
  EXPECT_GT(drawn, 100U);
}

}  // namespace
}  // namespace portolan
