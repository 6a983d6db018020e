// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/ray_marks.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

using Blocks = std::map<std::tuple<int, int, int>, std::pair<VoxelMask, VoxelMask>>;

constexpr double kResolution = 0.1;

/// What marks say after rays in all directions, of which some are longer; taken twice, to see that
/// nothing remains of the first time.
Blocks marked(RayMarks marks) {
  const VoxelLattice lattice(kResolution);
  const octomap::point3d origin(0.31F, -0.12F, 0.05F);
  const RayStart start(lattice, origin);
  Blocks blocks;
  for (const unsigned seed : {1U, 2U}) {
    Random random(seed);
    std::vector<octomap::point3d> ends;
    RayMarks::Box box;
    box.extend(*start.key());
    for (int i = 0; i < 600; ++i) {
      const double reach = i % 10 == 0 ? 9.0 : 3.0;
      const auto far = [&] { return static_cast<float>(uniform(random, -reach, reach)); };
      const float x = far();
      const float y = far();
      ends.emplace_back(x, y, far());
      box.extend(*lattice.key(ends.back()));
    }
    marks.start(box, *start.key());
    for (const octomap::point3d& end : ends) {
      marks.mark_crossed(start, end, *lattice.key(end));
      marks.mark_end(*lattice.key(end));
    }
    blocks.clear();
    marks.take([&](BlockKey key, const VoxelMask& crossed, const VoxelMask& hit) {
      const bool is_new = blocks.try_emplace({key.x, key.y, key.z}, crossed, hit).second;
      EXPECT_TRUE(is_new);
    });
  }
  return blocks;
}

TEST(RayMarks, bytes_bits_and_the_table_say_the_same) {
  const Blocks by_bytes = marked(RayMarks(RayMarks::Limits{1 << 28, 1 << 28}));
  EXPECT_GT(by_bytes.size(), 900U);
  EXPECT_EQ(marked(RayMarks(RayMarks::Limits{0, 1 << 28})), by_bytes);
  // Only a part fits into the volume.
  EXPECT_EQ(marked(RayMarks(RayMarks::Limits{1 << 28, 1 << 18})), by_bytes);
  EXPECT_EQ(marked(RayMarks(RayMarks::Limits{0, 1 << 18})), by_bytes);
}

}  // namespace
}  // namespace portolan::octo_test
