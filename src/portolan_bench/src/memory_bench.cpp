// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <deque>

#include "portolan/grid/cell_rows.hpp"

namespace portolan::bench {
namespace {

/// What the machine allows at most: all cells of many tiles updated, nothing to decide.
void update_whole_tiles(benchmark::State& state) {
  std::deque<TileMap::Tile> tiles(static_cast<std::size_t>(state.range(0)));
  const CellUpdate update = LogOdds(GridOptions{}).update(LaserModel{});
  TileBits free;
  free.fill(~std::uint64_t{0});
  const TileBits occupied{};
  for (auto _ : state) {
    for (TileMap::Tile& tile : tiles) {
      update_cells(tile, free, occupied, update);
    }
    benchmark::ClobberMemory();
  }
  const double cells = static_cast<double>(state.range(0)) * TileMap::kSide * TileMap::kSide;
  state.counters["ns_per_cell"] = benchmark::Counter(
      cells * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(update_whole_tiles)->Name("limit_update/tiles")->Arg(4)->Arg(64)->Arg(16384);

}  // namespace
}  // namespace portolan::bench
