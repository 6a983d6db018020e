// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/octo/ray_four.hpp"
#include "portolan/octo/ray_pair.hpp"

namespace portolan {

/// Calls mark(cell) for every voxel that the rays cross before their last ones, counted from the
/// voxel whose cell is `corner`.
template <class Mark>
void walk_by_two(const std::vector<RayWalk>& rays, RayWalk::Cell corner, Mark mark) {
  RayPair pair;
  std::size_t next = 0;
  const auto go_on = [&](auto lane) {
    if (pair.is_over(lane)) {
      if (next == rays.size()) return false;
      pair.load(lane, rays[next++], corner);
    }
    mark(pair.cell(lane));
    return true;
  };
  bool first = go_on(RayPair::kFirst);
  bool second = go_on(RayPair::kSecond);
  while (first && second) {
    pair.step();
    first = go_on(RayPair::kFirst);
    second = go_on(RayPair::kSecond);
  }
  while (first) {
    pair.step();
    first = go_on(RayPair::kFirst);
  }
  while (second) {
    pair.step();
    second = go_on(RayPair::kSecond);
  }
}

/// The same, as fast as the processor can; a cell may be marked more than once.
template <class Mark>
void walk(const std::vector<RayWalk>& rays, RayWalk::Cell corner, Mark mark) {
#if defined(PORTOLAN_HAS_RAY_FOUR)
  if (rays.size() >= 4 && __builtin_cpu_supports("avx2")) return walk_by_four(rays, corner, mark);
#endif
  walk_by_two(rays, corner, mark);
}

}  // namespace portolan
