// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "octo/octo_fixture.hpp"
#include "portolan/octo/ray_start.hpp"
#include "portolan/octo/walk_rays.hpp"

namespace portolan::octo_test {
namespace {

using Cells = std::vector<RayWalk::Cell>;

/// What the library crosses; empty where it refuses the ray.
Cells expected(const octomap::OcTree& tree, const octomap::point3d& origin,
               const octomap::point3d& end) {
  octomap::KeyRay ray;
  octomap::OcTreeKey key_origin;
  octomap::OcTreeKey key_end;
  Cells cells;
  const bool inside =
      tree.coordToKeyChecked(origin, key_origin) && tree.coordToKeyChecked(end, key_end);
  if (!inside) return cells;
  tree.computeRayKeys(origin, end, ray);
  for (const auto& key : ray) cells.push_back(RayWalk::Axes().cell(key));
  return cells;
}

std::optional<RayWalk> ray_walk(const VoxelLattice& lattice, const octomap::point3d& origin,
                                const octomap::point3d& end) {
  const auto key_end = lattice.key(end);
  if (!key_end) return std::nullopt;
  return RayStart(lattice, origin).walk_to(end, *key_end, RayWalk::Axes());
}

Cells walked(const VoxelLattice& lattice, const octomap::point3d& origin,
             const octomap::point3d& end) {
  Cells cells;
  if (const auto ray = ray_walk(lattice, origin, end)) {
    walk({*ray}, 0, [&](RayWalk::Cell cell) { cells.push_back(cell); });
  }
  return cells;
}

/// A coordinate as sensors give them, or one where rounding decides.
float coordinate(Random& random, double resolution) {
  const double x = uniform(random, -8.0, 8.0);
  switch (random() % 6) {
    case 0:
      return static_cast<float>(std::round(x / resolution) * resolution);
    case 1:
      return std::nextafter(static_cast<float>(std::round(x / resolution) * resolution), 9.F);
    case 2:
      return static_cast<float>((std::round(x / resolution) + 0.5) * resolution);
    case 3:
      return random() % 4 == 0 ? 0.0F : static_cast<float>(1e-6 * x);
    default:
      return static_cast<float>(x);
  }
}

octomap::point3d point(Random& random, double resolution) {
  const auto next = [&] { return coordinate(random, resolution); };
  const float x = next();
  const float y = next();
  return {x, y, next()};
}

TEST(RayPair, crosses_what_the_library_crosses_in_the_same_order) {
  Random random(1);
  for (const double resolution : {0.05, 0.1, 0.2, 0.37, 1.0}) {
    const VoxelLattice lattice(resolution);
    const octomap::OcTree tree(resolution);
    for (int i = 0; i < 4000; ++i) {
      const octomap::point3d origin = point(random, resolution);
      octomap::point3d end = point(random, resolution);
      if (i % 9 == 0) end.x() = origin.x();
      if (i % 9 == 1) end = origin + octomap::point3d(end.x(), 0.0F, 0.0F);
      ASSERT_EQ(walked(lattice, origin, end), expected(tree, origin, end))
          << origin << " to " << end << " at " << resolution;
    }
  }
}

// Rays of more than 100000 voxels overflow the library's buffer, so the longest here have 27000.
TEST(RayPair, crosses_the_same_at_the_ends_of_the_octree) {
  Random random(2);
  const VoxelLattice lattice(0.1);
  const octomap::OcTree tree(0.1);
  for (int i = 0; i < 300; ++i) {
    const auto far = [&] { return static_cast<float>(uniform(random, -3290.0, 3290.0)); };
    const auto on = [&] { return static_cast<float>(uniform(random, -900.0, 900.0)); };
    const octomap::point3d origin(far(), far(), far());
    const octomap::point3d end = origin + octomap::point3d(on(), on(), on());
    ASSERT_EQ(walked(lattice, origin, end), expected(tree, origin, end)) << origin << " " << end;
  }
}

std::set<RayWalk::Cell> as_set(const Cells& cells) { return {cells.begin(), cells.end()}; }

/// Checks a way to walk many rays, of at least so many, against each ray alone.
template <class WalkAll>
void expect_the_same_as_alone(std::size_t least, WalkAll walk_all) {
  Random random(3);
  const VoxelLattice lattice(0.1);
  for (std::size_t count = least; count < least + 40; ++count) {
    std::vector<RayWalk> rays;
    Cells alone;
    while (rays.size() < count) {
      const octomap::point3d origin = point(random, 0.1);
      const octomap::point3d end = point(random, 0.1);
      const Cells cells = walked(lattice, origin, end);
      alone.insert(alone.end(), cells.begin(), cells.end());
      if (const auto ray = ray_walk(lattice, origin, end)) rays.push_back(*ray);
    }
    Cells together;
    walk_all(rays, [&](RayWalk::Cell cell) { together.push_back(cell); });
    ASSERT_EQ(as_set(together), as_set(alone));
  }
}

TEST(RayPair, many_rays_at_once_cross_what_each_crosses_alone) {
  expect_the_same_as_alone(0, [](const auto& rays, auto mark) { walk(rays, 0, mark); });
  expect_the_same_as_alone(0, [](const auto& rays, auto mark) { walk_by_two(rays, 0, mark); });
#if defined(PORTOLAN_HAS_RAY_FOUR)
  using walk_rays_detail::walk_by_eight;
  if (!walk_rays_detail::kHasAvx2) GTEST_SKIP() << "no AVX2 here";
  expect_the_same_as_alone(8, [](const auto& rays, auto mark) { walk_by_eight(rays, 0, mark); });
#endif
}

TEST(RayPair, comes_to_an_end_where_the_library_would_not) {
  const VoxelLattice lattice(0.1);
  const octomap::point3d below(-1e-30F, -1e-30F, -1e-30F);
  const octomap::point3d above(1e-30F, 1e-30F, 1e-30F);
  EXPECT_TRUE(walked(lattice, below, above).empty());
}

}  // namespace
}  // namespace portolan::octo_test
