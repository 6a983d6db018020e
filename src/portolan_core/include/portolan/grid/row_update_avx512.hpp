// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>

#include "portolan/grid/row_vectors.hpp"
#include "portolan/grid/tile_map.hpp"

namespace portolan {

template <class Rows>
class RowUpdate;

/// The update of eight rows: each is one register, and its bits are one mask.
template <>
class RowUpdate<EightRows> {
 public:
  using Words = EightRows::Words;

  explicit RowUpdate(const CellUpdate& update) : update_(update) {}

  [[gnu::target("avx512f,avx512bw")]] bool operator()(CellByte* row, Words free,
                                                      Words occupied) const {
    if (is_zero(free | occupied)) return false;
    if (is_zero(occupied)) {
      free_rows(row, free);
    } else {
      update_rows(row, free & ~occupied, occupied);
    }
    return true;
  }

 private:
  /// The words of a vector by way of memory: from there they come to the mask registers sooner than
  /// by shuffles, which compilers prefer.
  class Bits {
   public:
    [[gnu::target("avx512f,avx512bw")]] explicit Bits(Words words) {
      // gcc 12's AddressSanitizer does not keep the alignment that gcc then counts on.
      void* to = words_.data();
      asm("" : "+r"(to));
      _mm512_storeu_si512(to, reinterpret_cast<__m512i>(words));
    }
    std::uint64_t operator[](int i) const {
      return static_cast<const volatile std::uint64_t*>(words_.data())[i];
    }

   private:
    std::array<std::uint64_t, EightRows::kCount> words_;
  };

  [[gnu::target("avx512f,avx512bw")]] static bool is_zero(Words words) {
    const auto bits = reinterpret_cast<__m512i>(words);
    return _mm512_test_epi64_mask(bits, bits) == 0;
  }

  [[gnu::target("avx512f,avx512bw")]] static __m512i all(CellByte byte) {
    return _mm512_set1_epi8(static_cast<char>(byte));
  }

  [[gnu::target("avx512f,avx512bw")]] static __m512i known(__m512i cells, __m512i prior) {
    return _mm512_mask_mov_epi8(cells, _mm512_testn_epi8_mask(cells, cells), prior);
  }

  [[gnu::target("avx512f,avx512bw")]] void free_rows(CellByte* row, Words free) const {
    const __m512i prior = all(update_.prior);
    const __m512i floor = all(update_.free_floor);
    const __m512i down = all(update_.free_step);
    const Bits bits(free);
    for (int i = 0; i < EightRows::kCount; ++i, row += TileMap::kSide) {
      const __m512i cells = _mm512_load_si512(row);
      const __m512i high = _mm512_max_epu8(known(cells, prior), floor);
      _mm512_store_si512(row, _mm512_mask_sub_epi8(cells, bits[i], high, down));
    }
  }

  [[gnu::target("avx512f,avx512bw")]] void update_rows(CellByte* row, Words free,
                                                       Words occupied) const {
    const __m512i prior = all(update_.prior);
    const __m512i floor = all(update_.free_floor);
    const __m512i down = all(update_.free_step);
    const __m512i ceiling = all(update_.occupied_ceiling);
    const __m512i up = all(update_.occupied_step);
    const Bits free_bits(free);
    const Bits occupied_bits(occupied);
    for (int i = 0; i < EightRows::kCount; ++i, row += TileMap::kSide) {
      const __m512i cells = _mm512_load_si512(row);
      const __m512i before = known(cells, prior);
      const __m512i high = _mm512_max_epu8(before, floor);
      const __m512i low = _mm512_min_epu8(before, ceiling);
      const __m512i freed = _mm512_mask_sub_epi8(cells, free_bits[i], high, down);
      _mm512_store_si512(row, _mm512_mask_add_epi8(freed, occupied_bits[i], low, up));
    }
  }

  CellUpdate update_;
};

}  // namespace portolan
