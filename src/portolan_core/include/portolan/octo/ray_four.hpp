// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(PORTOLAN_NO_AVX2)
#define PORTOLAN_HAS_RAY_FOUR

#include <immintrin.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "portolan/octo/ray_walk.hpp"

#pragma GCC push_options
#pragma GCC target("avx2")

namespace portolan {

/// Four rays on their way, as a `RayPair` has two, for processors with AVX2: whether they have it
/// is asked at run time. A lane whose ray is over and has no successor idles where a ray began.
class RayFour {
 public:
  static constexpr int kLanes = 4;

  /// Puts a ray in a lane; its cells count from the voxel whose cell is `corner`.
  void load(int lane, const RayWalk& ray, RayWalk::Cell corner) {
    const __m256d here = only(lane);
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
    const __m256d x_before_y = _mm256_cmp_pd(t_x_, t_y_, _CMP_LT_OQ);
    const __m256d in_x = _mm256_and_pd(x_before_y, _mm256_cmp_pd(t_x_, t_z_, _CMP_LT_OQ));
    const __m256d in_y = _mm256_andnot_pd(x_before_y, _mm256_cmp_pd(t_y_, t_z_, _CMP_LT_OQ));
    const __m256d in_x_or_y = _mm256_or_pd(in_x, in_y);
    t_x_ = _mm256_add_pd(t_x_, _mm256_and_pd(delta_x_, in_x));
    t_y_ = _mm256_add_pd(t_y_, _mm256_and_pd(delta_y_, in_y));
    t_z_ = _mm256_add_pd(t_z_, _mm256_andnot_pd(in_x_or_y, delta_z_));
    const __m256d step =
        _mm256_blendv_pd(step_z_, _mm256_blendv_pd(step_y_, step_x_, in_x), in_x_or_y);
    cell_ = _mm256_castsi256_pd(
        _mm256_add_epi64(_mm256_castpd_si256(cell_), _mm256_castpd_si256(step)));
    const __m256d past = _mm256_and_pd(_mm256_cmp_pd(t_x_, length_, _CMP_GT_OQ),
                                       _mm256_and_pd(_mm256_cmp_pd(t_y_, length_, _CMP_GT_OQ),
                                                     _mm256_cmp_pd(t_z_, length_, _CMP_GT_OQ)));
    const __m256i at_end =
        _mm256_cmpeq_epi64(_mm256_castpd_si256(cell_), _mm256_castpd_si256(end_));
    return _mm256_movemask_pd(_mm256_or_pd(past, _mm256_castsi256_pd(at_end)));
  }

  /// Calls mark(cell) for each lane.
  template <class Mark>
  void mark_cells(Mark mark) const {
    alignas(32) RayWalk::Cell cells[4];
    _mm256_store_pd(reinterpret_cast<double*>(cells), cell_);
    for (const RayWalk::Cell cell : cells) mark(cell);
  }

 private:
  static __m256d only(int lane) {
    const __m256i lanes = _mm256_setr_epi64x(0, 1, 2, 3);
    return _mm256_castsi256_pd(_mm256_cmpeq_epi64(lanes, _mm256_set1_epi64x(lane)));
  }
  static void set(__m256d& four, double value, __m256d here) {
    four = _mm256_blendv_pd(four, _mm256_set1_pd(value), here);
  }
  static void set(__m256d& four, RayWalk::Cell bits, __m256d here) {
    const __m256i all = _mm256_set1_epi64x(static_cast<std::int64_t>(bits));
    four = _mm256_blendv_pd(four, _mm256_castsi256_pd(all), here);
  }

  __m256d t_x_{}, t_y_{}, t_z_{};              // length of the ray at its next borders
  __m256d delta_x_{}, delta_y_{}, delta_z_{};  // from border to border
  __m256d step_x_{}, step_y_{}, step_z_{};     // bits of a Cell
  __m256d length_{};
  __m256d cell_{}, end_{};  // bits of a Cell
};

}  // namespace portolan

#pragma GCC pop_options

#endif
