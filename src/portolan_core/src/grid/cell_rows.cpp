// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/cell_rows.hpp"

#include <algorithm>
#include <cstring>

#include "portolan/grid/row_vectors.hpp"

#ifdef PORTOLAN_HAS_WIDE_ROWS
#include <immintrin.h>
#endif

namespace portolan {

namespace {

constexpr int kSide = TileMap::kSide;
constexpr std::uint64_t kWholeRow = ~std::uint64_t{0};

CellByte known(CellByte cell, CellByte prior) { return cell == kNeverObserved ? prior : cell; }
CellByte freed(CellByte cell, const CellUpdate& u) {
  return static_cast<CellByte>(std::max(known(cell, u.prior), u.free_floor) - u.free_step);
}
CellByte hit(CellByte cell, const CellUpdate& u) {
  return static_cast<CellByte>(std::min(known(cell, u.prior), u.occupied_ceiling) +
                               u.occupied_step);
}

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
constexpr std::array<std::uint64_t, 256> kSpread = make_spread();

struct Mask {
  alignas(kSide) std::array<std::uint8_t, kSide> bytes;

  explicit Mask(std::uint64_t bits) {
    for (std::size_t i = 0; i < kSide; i += 8, bits >>= 8) {
      std::memcpy(&bytes[i], &kSpread[bits & 0xFF], 8);
    }
  }
};

void free_whole_row(CellByte* row, const CellUpdate& u) {
  for (int i = 0; i < kSide; ++i) row[i] = freed(row[i], u);
}

void free_row(CellByte* row, std::uint64_t free, const CellUpdate& u) {
  const Mask mask(free);
  for (std::size_t i = 0; i < kSide; ++i) {
    const std::uint8_t f = mask.bytes[i];
    row[i] = static_cast<CellByte>((freed(row[i], u) & f) | (row[i] & ~f));
  }
}

void occupy_row(CellByte* row, std::uint64_t occupied, const CellUpdate& u) {
  for (; occupied != 0; occupied &= occupied - 1) {
    CellByte& cell = row[__builtin_ctzll(occupied)];
    cell = hit(cell, u);
  }
}

#ifdef PORTOLAN_HAS_WIDE_ROWS

// A row is one register and its bits are one mask.
__attribute__((target("avx512bw"))) void update_cells_avx512(TileMap::Tile& tile,
                                                             const TileBits& free,
                                                             const TileBits& occupied,
                                                             std::size_t begin, std::size_t end,
                                                             const CellUpdate& u) {
  const __m512i prior = _mm512_set1_epi8(static_cast<char>(u.prior));
  const __m512i floor = _mm512_set1_epi8(static_cast<char>(u.free_floor));
  const __m512i down = _mm512_set1_epi8(static_cast<char>(u.free_step));
  const __m512i ceiling = _mm512_set1_epi8(static_cast<char>(u.occupied_ceiling));
  const __m512i up = _mm512_set1_epi8(static_cast<char>(u.occupied_step));
  for (std::size_t i = begin; i < end; ++i) {
    const auto y = static_cast<int>(i);
    const std::uint64_t known_free = free[i] & ~occupied[i];
    if ((known_free | occupied[i]) == 0) continue;
    CellByte* row = tile.row(y);
    const __m512i before = _mm512_load_si512(row);
    const __m512i known =
        _mm512_mask_mov_epi8(before, _mm512_testn_epi8_mask(before, before), prior);
    const __m512i freed =
        _mm512_mask_sub_epi8(before, known_free, _mm512_max_epu8(known, floor), down);
    const __m512i after =
        _mm512_mask_add_epi8(freed, occupied[i], _mm512_min_epu8(known, ceiling), up);
    _mm512_store_si512(row, after);
  }
}

#endif

}  // namespace

void cell_rows_detail::update_cells_portably(TileMap::Tile& tile, const TileBits& free,
                                             const TileBits& occupied, std::size_t begin,
                                             std::size_t end, const CellUpdate& update) {
  const CellUpdate u = update;
  for (std::size_t i = begin; i < end; ++i) {
    const auto y = static_cast<int>(i);
    const std::uint64_t known_free = free[i] & ~occupied[i];
    if (known_free == kWholeRow) {
      free_whole_row(tile.row(y), u);
    } else if (known_free != 0) {
      free_row(tile.row(y), known_free, u);
    }
    occupy_row(tile.row(y), occupied[i], u);
  }
}

void update_cells(TileMap::Tile& tile, const TileBits& free, const TileBits& occupied,
                  std::size_t begin, std::size_t end, const CellUpdate& update) {
#ifdef PORTOLAN_HAS_WIDE_ROWS
  if (row_vectors_detail::kHasAvx512) {
    return update_cells_avx512(tile, free, occupied, begin, end, update);
  }
#endif
  cell_rows_detail::update_cells_portably(tile, free, occupied, begin, end, update);
}

}  // namespace portolan
