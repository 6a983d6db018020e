// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(PORTOLAN_NO_AVX512)
#define PORTOLAN_HAS_RAY_EIGHT

#include <immintrin.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "portolan/octo/ray_walk.hpp"

#pragma GCC push_options
#pragma GCC target("avx512f")

namespace portolan {

/// Eight rays on their way, as a `RayFour` has four, for processors with AVX-512: whether they have
/// it is asked at run time.
class RayEight {
 public:
  static constexpr int kLanes = 8;

  /// Puts a ray in a lane; its cells count from the voxel whose cell is `corner`.
  void load(int lane, const RayWalk& ray, RayWalk::Cell corner) {
    const auto here = static_cast<__mmask8>(1 << lane);
    set(t_x_, ray.t[0], here);
    set(t_y_, ray.t[1], here);
    set(t_z_, ray.t[2], here);
    set(delta_x_, ray.t_delta[0], here);
    set(delta_y_, ray.t_delta[1], here);
    set(delta_z_, ray.t_delta[2], here);
    set(step_x_, ray.step[0], here);
    set(step_y_, ray.step[1], here);
    set(step_z_, ray.step[2], here);
    set(length_, ray.length, here);
    set(cell_, ray.start - corner, here);
    set(end_, ray.end - corner, here);
  }

  void idle(int lane, RayWalk::Cell cell) {
    load(lane, RayWalk{{}, {}, {}, std::numeric_limits<double>::infinity(), cell, cell - 1}, 0);
  }

  /// Goes on to the next voxel of each ray. A bit for each lane whose ray has come to its last
  /// voxel, or past its end beside it.
  int step() {
    const __mmask8 x_before_y = _mm512_cmp_pd_mask(t_x_, t_y_, _CMP_LT_OQ);
    const __mmask8 in_x = _mm512_mask_cmp_pd_mask(x_before_y, t_x_, t_z_, _CMP_LT_OQ);
    const __mmask8 y_first = _mm512_cmp_pd_mask(t_y_, t_z_, _CMP_LT_OQ);
    const auto in_y = static_cast<__mmask8>(y_first & ~x_before_y);
    const auto in_z = static_cast<__mmask8>(~(in_x | in_y));
    t_x_ = _mm512_mask_add_pd(t_x_, in_x, t_x_, delta_x_);
    t_y_ = _mm512_mask_add_pd(t_y_, in_y, t_y_, delta_y_);
    t_z_ = _mm512_mask_add_pd(t_z_, in_z, t_z_, delta_z_);
    cell_ = _mm512_mask_add_epi64(cell_, in_x, cell_, step_x_);
    cell_ = _mm512_mask_add_epi64(cell_, in_y, cell_, step_y_);
    cell_ = _mm512_mask_add_epi64(cell_, in_z, cell_, step_z_);
    const __mmask8 past_x = _mm512_cmp_pd_mask(t_x_, length_, _CMP_GT_OQ);
    const __mmask8 past_xy = _mm512_mask_cmp_pd_mask(past_x, t_y_, length_, _CMP_GT_OQ);
    const __mmask8 past = _mm512_mask_cmp_pd_mask(past_xy, t_z_, length_, _CMP_GT_OQ);
    return past | _mm512_cmpeq_epi64_mask(cell_, end_);
  }

  /// Calls mark(cell) for each lane.
  template <class Mark>
  void mark_cells(Mark mark) const {
    alignas(64) RayWalk::Cell cells[kLanes];
    _mm512_store_si512(cells, cell_);
    for (const RayWalk::Cell cell : cells) mark(cell);
  }

 private:
  static void set(__m512d& eight, double value, __mmask8 here) {
    eight = _mm512_mask_mov_pd(eight, here, _mm512_set1_pd(value));
  }
  static void set(__m512i& eight, RayWalk::Cell bits, __mmask8 here) {
    eight = _mm512_mask_set1_epi64(eight, here, static_cast<std::int64_t>(bits));
  }

  __m512d t_x_{}, t_y_{}, t_z_{};              // length of the ray at its next borders
  __m512d delta_x_{}, delta_y_{}, delta_z_{};  // from border to border
  __m512i step_x_{}, step_y_{}, step_z_{};
  __m512d length_{};
  __m512i cell_{}, end_{};
};

}  // namespace portolan

#pragma GCC pop_options

#endif
