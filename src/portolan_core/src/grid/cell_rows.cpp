// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/cell_rows.hpp"

#include "portolan/grid/row_update.hpp"

namespace portolan {

namespace {

template <class Rows>
void update(TileMap::Tile& tile, const TileBits& free, const TileBits& occupied,
            const CellUpdate& update) {
  const RowUpdate<Rows> update_rows(update);
  for (std::size_t row = 0; row < TileMap::kSide; row += Rows::kCount) {
    typename Rows::Words few_free;
    typename Rows::Words few_occupied;
    std::memcpy(&few_free, &free[row], sizeof(few_free));
    std::memcpy(&few_occupied, &occupied[row], sizeof(few_occupied));
    update_rows(tile.row(static_cast<int>(row)), few_free, few_occupied);
  }
}

}  // namespace

void update_cells(TileMap::Tile& tile, const TileBits& free, const TileBits& occupied,
                  const CellUpdate& by) {
  with_widest_rows([&](auto rows) { update<decltype(rows)>(tile, free, occupied, by); });
}

void cell_rows_detail::update_cells_portably(TileMap::Tile& tile, const TileBits& free,
                                             const TileBits& occupied, const CellUpdate& by) {
  update<TwoRows>(tile, free, occupied, by);
}

}  // namespace portolan
