// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/octo/ray_eight.hpp"
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

namespace walk_rays_detail {

/// The same for at least as many rays as lie in two groups, which take turns, since a step of one
/// waits for itself longer than it works.
template <class Group, class Mark>
void walk_in_groups(const std::vector<RayWalk>& rays, RayWalk::Cell corner, Mark mark) {
  Group first;
  Group second;
  std::size_t next = 0;
  int walking = 2 * Group::kLanes;
  const auto put = [&](Group& group, int lane) {
    if (next < rays.size()) return group.load(lane, rays[next++], corner);
    group.idle(lane, rays.front().start - corner);
    --walking;
  };
  for (int lane = 0; lane < Group::kLanes; ++lane) {
    put(first, lane);
    put(second, lane);
  }
  first.mark_cells(mark);
  second.mark_cells(mark);
  while (walking > 0) {
    auto over_first = static_cast<unsigned>(first.step());
    auto over_second = static_cast<unsigned>(second.step());
    for (; over_first != 0; over_first &= over_first - 1) put(first, __builtin_ctz(over_first));
    for (; over_second != 0; over_second &= over_second - 1)
      put(second, __builtin_ctz(over_second));
    first.mark_cells(mark);
    second.mark_cells(mark);
  }
}

#if defined(PORTOLAN_HAS_RAY_FOUR)
inline const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;

template <class Mark>
[[gnu::target("avx2"), gnu::flatten]] void walk_by_eight(const std::vector<RayWalk>& rays,
                                                         RayWalk::Cell corner, Mark mark) {
  walk_in_groups<RayFour>(rays, corner, mark);
}
#endif

#if defined(PORTOLAN_HAS_RAY_EIGHT)
inline const bool kHasAvx512 = __builtin_cpu_supports("avx512f") != 0;

template <class Mark>
[[gnu::target("avx512f"), gnu::flatten]] void walk_by_sixteen(const std::vector<RayWalk>& rays,
                                                              RayWalk::Cell corner, Mark mark) {
  walk_in_groups<RayEight>(rays, corner, mark);
}
#endif

}  // namespace walk_rays_detail

/// The same, as fast as the processor can; a cell may be marked more than once.
template <class Mark>
void walk(const std::vector<RayWalk>& rays, RayWalk::Cell corner, Mark mark) {
#if defined(PORTOLAN_HAS_RAY_EIGHT)
  if (rays.size() >= 16 && walk_rays_detail::kHasAvx512) {
    return walk_rays_detail::walk_by_sixteen(rays, corner, mark);
  }
#endif
#if defined(PORTOLAN_HAS_RAY_FOUR)
  if (rays.size() >= 8 && walk_rays_detail::kHasAvx2) {
    return walk_rays_detail::walk_by_eight(rays, corner, mark);
  }
#endif
  walk_by_two(rays, corner, mark);
}

}  // namespace portolan
