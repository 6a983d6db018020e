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
#include "portolan/grid/row_update_avx512.hpp"
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

}  // namespace portolan
