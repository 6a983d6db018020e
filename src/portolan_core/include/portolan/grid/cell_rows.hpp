// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "portolan/grid/tile_map.hpp"

namespace portolan {

/// One bit for each cell of a tile, a word for each of its rows.
using TileBits = std::array<std::uint64_t, TileMap::kSide>;

/// Updates the cells of a tile whose bits are set, Eq. 7: once each, where occupied wins over free.
/// With the widest vectors that the processor has; the result does not depend on it.
void update_cells(TileMap::Tile& tile, const TileBits& free, const TileBits& occupied,
                  const CellUpdate& by);

namespace cell_rows_detail {

/// The same without the vectors of particular processors.
void update_cells_portably(TileMap::Tile& tile, const TileBits& free, const TileBits& occupied,
                           const CellUpdate& by);

}  // namespace cell_rows_detail

}  // namespace portolan
