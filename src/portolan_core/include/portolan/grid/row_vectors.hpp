// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

// clang passes no wide vector from a function that is compiled for less, not even to an inlined
// one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PORTOLAN_HAS_WIDE_ROWS
#endif

namespace portolan {

// A few rows of cells at once, as vectors of the compiler, which become those of the processor that
// a function is compiled for.

/// Rows by two, for any processor.
struct TwoRows {
  static constexpr int kCount = 2;
  using Doubles = double __attribute__((vector_size(16)));
  using Words = std::uint64_t __attribute__((vector_size(16)));
};

/// Rows by four, for AVX2.
struct FourRows {
  static constexpr int kCount = 4;
  using Doubles = double __attribute__((vector_size(32)));
  using Words = std::uint64_t __attribute__((vector_size(32)));
};

/// Rows by eight, for AVX-512.
struct EightRows {
  static constexpr int kCount = 8;
  using Doubles = double __attribute__((vector_size(64)));
  using Words = std::uint64_t __attribute__((vector_size(64)));
};

#ifdef PORTOLAN_HAS_WIDE_ROWS

namespace row_vectors_detail {

inline const bool kHasAvx512 = __builtin_cpu_supports("avx512bw") != 0 &&
                               __builtin_cpu_supports("avx512dq") != 0 &&
                               __builtin_cpu_supports("avx512vl") != 0;
inline const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;

template <class Work>
[[gnu::target("avx512f,avx512bw,avx512dq,avx512vl"), gnu::flatten]] auto by_eight(Work work) {
  return work(EightRows{});
}

template <class Work>
[[gnu::target("avx2"), gnu::flatten]] auto by_four(Work work) {
  return work(FourRows{});
}

}  // namespace row_vectors_detail

#endif

/// Calls work(rows), which takes its rows so many at a time: with the widest vectors that the
/// processor has.
template <class Work>
auto with_widest_rows(Work work) {
#ifdef PORTOLAN_HAS_WIDE_ROWS
  if (row_vectors_detail::kHasAvx512) return row_vectors_detail::by_eight(work);
  if (row_vectors_detail::kHasAvx2) return row_vectors_detail::by_four(work);
#endif
  return work(TwoRows{});
}

}  // namespace portolan
