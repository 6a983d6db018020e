// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "portolan/grid/row_vectors.hpp"
#include "portolan/grid/tile_map.hpp"

#ifdef PORTOLAN_HAS_WIDE_ROWS
#include <immintrin.h>
#endif

namespace portolan {

namespace row_update_detail {

// For each byte the eight bytes of 0 or 0xFF that its bits say.
constexpr std::array<std::uint64_t, 256> make_spread() {
  std::array<std::uint64_t, 256> spread{};
  for (std::size_t bits = 0; bits < 256; ++bits) {
    for (std::size_t i = 0; i < 8; ++i) {
      if ((bits >> i) & 1) spread[bits] |= std::uint64_t{0xFF} << (8 * i);
    }
  }
  return spread;
}
inline constexpr std::array<std::uint64_t, 256> kSpread = make_spread();

}  // namespace row_update_detail

/// Updates the cells of a few rows whose bits are set, Eq. 7: once each, where occupied wins over
/// free. One for each kind of vectors; all of them do the same.
template <class Rows>
class RowUpdate {
 public:
  using Words = typename Rows::Words;

  explicit RowUpdate(const CellUpdate& update) : update_(update) {}

  /// In the rows of a tile from this one on; false where no bit is set.
  bool operator()(CellByte* row, Words free, Words occupied) const {
    free &= ~occupied;
    std::uint64_t any = 0;
    for (int i = 0; i < Rows::kCount; ++i, row += TileMap::kSide) {
      any |= free[i] | occupied[i];
      if (free[i] == ~std::uint64_t{0}) {
        free_whole(row);
      } else if (free[i] != 0) {
        free_some(row, free[i]);
      }
      occupy(row, occupied[i]);
    }
    return any != 0;
  }

 private:
  static constexpr std::size_t kSide = TileMap::kSide;

  CellByte known(CellByte cell) const { return cell == kNeverObserved ? update_.prior : cell; }
  CellByte freed(CellByte cell) const {
    return static_cast<CellByte>(std::max(known(cell), update_.free_floor) - update_.free_step);
  }
  CellByte hit(CellByte cell) const {
    const CellByte low = std::min(known(cell), update_.occupied_ceiling);
    return static_cast<CellByte>(low + update_.occupied_step);
  }

  void free_whole(CellByte* row) const {
    for (std::size_t i = 0; i < kSide; ++i) row[i] = freed(row[i]);
  }

  void free_some(CellByte* row, std::uint64_t bits) const {
    alignas(kSide) std::array<std::uint8_t, kSide> mask;
    for (std::size_t i = 0; i < kSide; i += 8, bits >>= 8) {
      std::memcpy(&mask[i], &row_update_detail::kSpread[bits & 0xFF], 8);
    }
    for (std::size_t i = 0; i < kSide; ++i) {
      row[i] = static_cast<CellByte>((freed(row[i]) & mask[i]) | (row[i] & ~mask[i]));
    }
  }

  void occupy(CellByte* row, std::uint64_t bits) const {
    for (; bits != 0; bits &= bits - 1) {
      CellByte& cell = row[__builtin_ctzll(bits)];
      cell = hit(cell);
    }
  }

  CellUpdate update_;
};

#ifdef PORTOLAN_HAS_WIDE_ROWS

/// A row is one register and its bits are one mask.
template <>
class RowUpdate<EightRows> {
 public:
  using Words = EightRows::Words;

  explicit RowUpdate(const CellUpdate& update) : update_(update) {}

  [[gnu::target("avx512f,avx512bw")]] bool operator()(CellByte* row, Words free,
                                                      Words occupied) const {
    const Words any = free | occupied;
    if (_mm512_test_epi64_mask((__m512i)any, (__m512i)any) == 0) return false;
    const __m512i prior = _mm512_set1_epi8(static_cast<char>(update_.prior));
    const __m512i floor = _mm512_set1_epi8(static_cast<char>(update_.free_floor));
    const __m512i down = _mm512_set1_epi8(static_cast<char>(update_.free_step));
    const __m512i ceiling = _mm512_set1_epi8(static_cast<char>(update_.occupied_ceiling));
    const __m512i up = _mm512_set1_epi8(static_cast<char>(update_.occupied_step));
    free &= ~occupied;
    const Bits freed_bits(free);
    const Bits hit_bits(occupied);
    for (int i = 0; i < EightRows::kCount; ++i, row += TileMap::kSide) {
      const __m512i before = _mm512_load_si512(row);
      const __m512i known =
          _mm512_mask_mov_epi8(before, _mm512_testn_epi8_mask(before, before), prior);
      const __m512i freed =
          _mm512_mask_sub_epi8(before, freed_bits[i], _mm512_max_epu8(known, floor), down);
      const __m512i after =
          _mm512_mask_add_epi8(freed, hit_bits[i], _mm512_min_epu8(known, ceiling), up);
      _mm512_store_si512(row, after);
    }
    return true;
  }

 private:
  /// The words of a vector by way of memory: from there they come to the mask registers sooner than
  /// by shuffles, which compilers prefer.
  class Bits {
   public:
    explicit Bits(Words words) { std::memcpy(words_.data(), &words, sizeof(words)); }
    std::uint64_t operator[](int i) const {
      return static_cast<const volatile std::uint64_t*>(words_.data())[i];
    }

   private:
    std::array<std::uint64_t, EightRows::kCount> words_;
  };

  CellUpdate update_;
};

#endif

}  // namespace portolan
