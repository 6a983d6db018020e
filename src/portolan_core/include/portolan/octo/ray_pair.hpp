// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__SSE2__) && !defined(PORTOLAN_NO_SSE2)
#include <emmintrin.h>
#endif

#include "portolan/octo/ray_walk.hpp"

namespace portolan {

/// Two rays on their way, one in each lane of a vector, so that they go on together and without a
/// branch on the direction of a step, which no processor could foretell.
class RayPair {
 public:
  static constexpr std::integral_constant<int, 0> kFirst{};
  static constexpr std::integral_constant<int, 1> kSecond{};

#if defined(__SSE2__) && !defined(PORTOLAN_NO_SSE2)
  /// Puts a ray in a lane; its cells count from the voxel whose cell is `corner`.
  template <int lane>
  void load(std::integral_constant<int, lane> /*lane*/, const RayWalk& ray, RayWalk::Cell corner) {
    set<lane>(t_x_, ray.t[0]);
    set<lane>(t_y_, ray.t[1]);
    set<lane>(t_z_, ray.t[2]);
    set<lane>(delta_x_, ray.t_delta[0]);
    set<lane>(delta_y_, ray.t_delta[1]);
    set<lane>(delta_z_, ray.t_delta[2]);
    set<lane>(step_x_, ray.step[0]);
    set<lane>(step_y_, ray.step[1]);
    set<lane>(step_z_, ray.step[2]);
    set<lane>(length_, ray.length);
    set<lane>(cell_, ray.start - corner);
    end_[lane] = ray.end - corner;
    past_ &= ~(1 << lane);
  }

  template <int lane>
  RayWalk::Cell cell(std::integral_constant<int, lane> /*lane*/) const {
    const __m128i low = lane == 0 ? cell_ : _mm_unpackhi_epi64(cell_, cell_);
    return static_cast<RayWalk::Cell>(_mm_cvtsi128_si64(low));
  }

  /// Whether the ray of a lane has come to its last voxel, or past its end beside it.
  template <int lane>
  bool is_over(std::integral_constant<int, lane> which) const {
    return cell(which) == end_[lane] || (past_ >> lane & 1) != 0;
  }

  /// Goes on to the next voxel of each ray.
  void step() {
    const __m128d x_before_y = _mm_cmplt_pd(t_x_, t_y_);
    const __m128d in_x = _mm_and_pd(x_before_y, _mm_cmplt_pd(t_x_, t_z_));
    const __m128d in_y = _mm_andnot_pd(x_before_y, _mm_cmplt_pd(t_y_, t_z_));
    const __m128d in_x_or_y = _mm_or_pd(in_x, in_y);
    t_x_ = _mm_add_pd(t_x_, _mm_and_pd(delta_x_, in_x));
    t_y_ = _mm_add_pd(t_y_, _mm_and_pd(delta_y_, in_y));
    t_z_ = _mm_add_pd(t_z_, _mm_andnot_pd(in_x_or_y, delta_z_));
    const __m128d step = _mm_or_pd(_mm_or_pd(_mm_and_pd(step_x_, in_x), _mm_and_pd(step_y_, in_y)),
                                   _mm_andnot_pd(in_x_or_y, step_z_));
    cell_ = _mm_add_epi64(cell_, _mm_castpd_si128(step));
    past_ = _mm_movemask_pd(
        _mm_and_pd(_mm_cmpgt_pd(t_x_, length_),
                   _mm_and_pd(_mm_cmpgt_pd(t_y_, length_), _mm_cmpgt_pd(t_z_, length_))));
  }

 private:
  template <int lane>
  static void set(__m128d& pair, double value) {
    pair = lane == 0 ? _mm_loadl_pd(pair, &value) : _mm_loadh_pd(pair, &value);
  }
  template <int lane>
  static void set(__m128d& pair, RayWalk::Cell value) {
    set<lane>(pair,
              _mm_cvtsd_f64(_mm_castsi128_pd(_mm_cvtsi64_si128(static_cast<std::int64_t>(value)))));
  }
  template <int lane>
  static void set(__m128i& pair, RayWalk::Cell value) {
    __m128d bits = _mm_castsi128_pd(pair);
    set<lane>(bits, value);
    pair = _mm_castpd_si128(bits);
  }

  __m128d t_x_{}, t_y_{}, t_z_{};              // length of the ray at its next borders
  __m128d delta_x_{}, delta_y_{}, delta_z_{};  // from border to border
  __m128d step_x_{}, step_y_{}, step_z_{};     // bits of a Cell
  __m128d length_{};
  __m128i cell_{};
  RayWalk::Cell end_[2] = {};
  int past_ = 3;  // a bit for each lane
#else
  template <int lane>
  void load(std::integral_constant<int, lane> /*lane*/, const RayWalk& ray, RayWalk::Cell corner) {
    rays_[lane] = ray;
    rays_[lane].start -= corner;
    rays_[lane].end -= corner;
    is_past_[lane] = false;
  }

  template <int lane>
  RayWalk::Cell cell(std::integral_constant<int, lane> /*lane*/) const {
    return rays_[lane].start;
  }

  template <int lane>
  bool is_over(std::integral_constant<int, lane> /*lane*/) const {
    return is_past_[lane] || rays_[lane].start == rays_[lane].end;
  }

  void step() {
    for (std::size_t lane = 0; lane < 2; ++lane) {
      auto& [t, t_delta, steps, length, cell, end] = rays_[lane];
      const std::size_t axis = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
      t[axis] += t_delta[axis];
      cell += steps[axis];
      is_past_[lane] = t[0] > length && t[1] > length && t[2] > length;
    }
  }

 private:
  RayWalk rays_[2] = {};  // `start` is where a ray has come to
  bool is_past_[2] = {true, true};
#endif
};

}  // namespace portolan
