// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/grid_mapper.hpp"

#include <cmath>

#include "portolan/grid/draw.hpp"
#include "portolan/grid/fuse.hpp"

namespace portolan {

namespace {

constexpr int kSide = TileMap::kSide;

template <class T>
constexpr GridLayer kLayerOf = GridLayer::laser;
template <>
constexpr GridLayer kLayerOf<RangeEcho> = GridLayer::sonar;
template <>
constexpr GridLayer kLayerOf<PointCloud> = GridLayer::cloud;

// Sets every cell of a footprint to `value`.
CellUpdate assign(CellByte value) {
  return {value, 255, static_cast<CellByte>(255 - value), 0, value};
}

Cell tile_of(Cell cell) { return {cell.x >> TileMap::kSideLog2, cell.y >> TileMap::kSideLog2}; }

// Calls visit(tile index, part of the rectangle in that tile).
template <class Visit>
void for_each_tile(const CellRect& rect, Visit visit) {
  if (rect.empty()) return;
  const Cell first = tile_of(rect.min);
  const Cell last = tile_of({rect.max.x - 1, rect.max.y - 1});
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) {
      const CellRect tile{{x * kSide, y * kSide}, {(x + 1) * kSide, (y + 1) * kSide}};
      visit(Cell{x, y}, intersected(rect, tile));
    }
  }
}

// P(occupied) in percent of every byte.
std::array<std::int8_t, 256> percent_table(const LogOdds& log_odds) {
  std::array<std::int8_t, 256> percent;
  percent[kNeverObserved] = -1;
  for (int cell = 1; cell < 256; ++cell) {
    const double p = log_odds.probability(static_cast<CellByte>(cell));
    percent[static_cast<std::size_t>(cell)] = static_cast<std::int8_t>(std::lround(100.0 * p));
  }
  return percent;
}

// Makes the rows of a rectangle, with cell_of(tile index) giving a function that gives the byte of
// a place in that tile.
template <class CellOf>
std::vector<CellByte> make_rows(const CellRect& rect, CellOf cell_of) {
  const auto width = static_cast<std::size_t>(rect.width());
  std::vector<CellByte> rows(width * static_cast<std::size_t>(rect.height()), kNeverObserved);
  for_each_tile(rect, [&](Cell tile, const CellRect& part) {
    const auto cell_in = cell_of(tile);
    for (int y = part.min.y; y < part.max.y; ++y) {
      CellByte* row = &rows[static_cast<std::size_t>(y - rect.min.y) * width];
      for (int x = part.min.x; x < part.max.x; ++x) {
        const int place = (y & (kSide - 1)) * kSide + (x & (kSide - 1));
        row[x - rect.min.x] = cell_in(static_cast<std::size_t>(place));
      }
    }
  });
  return rows;
}

std::vector<std::int8_t> percents(const std::vector<CellByte>& cells, const LogOdds& log_odds) {
  const std::array<std::int8_t, 256> percent = percent_table(log_odds);
  std::vector<std::int8_t> rows(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) rows[i] = percent[cells[i]];
  return rows;
}

void write(TileMap& map, Cell cell, CellByte byte, std::uint64_t revision) {
  TileMap::Tile& tile = map.at(tile_of(cell));
  tile.row(cell.y & (kSide - 1))[cell.x & (kSide - 1)] = byte;
  tile.revision = revision;
}

CellByte cell_in(const TileMap::Tile* tile, std::size_t place) {
  return tile ? tile->cells[place] : kNeverObserved;
}

}  // namespace

GridMapper::GridMapper(const Options& options)
    : options_(checked(options)), log_odds_(options_), cone_(options_) {
  sheets_[index(GridLayer::laser)].update = log_odds_.update(options_.laser);
  sheets_[index(GridLayer::sonar)].update = log_odds_.update(options_.sonar);
  sheets_[index(GridLayer::cloud)].update = log_odds_.update(options_.cloud);
}

GridMapper::GridMapper(const Options& options, const std::vector<KeptLayer>& layers)
    : GridMapper(options) {
  ++revision_;
  for (const KeptLayer& kept : layers) {
    Sheet& sheet = sheets_[index(kept.layer)];
    sheet.bounds = kept.rect;
    std::size_t i = 0;
    for (Cell cell = kept.rect.min; cell.y < kept.rect.max.y; ++cell.y) {
      for (cell.x = kept.rect.min.x; cell.x < kept.rect.max.x; ++cell.x, ++i) {
        if (kept.cells[i] == kNeverObserved) continue;
        write(sheet.tiles, cell, kept.cells[i], revision_);
        if (options_.fusion != Fusion::latest || kept.is_latest.empty()) continue;
        const auto latest = static_cast<CellByte>(index(kept.layer) + 1);
        if (kept.is_latest[i]) write(latest_, cell, latest, revision_);
      }
    }
  }
}

Outcome GridMapper::insert(const Observation& z, const Pose& T_map_sensor) {
  if (!may_stand_at(T_map_sensor)) return Outcome::rejected;
  GridLayer layer{};
  const auto draw_it = [&](const auto& seen) {
    using Seen = std::decay_t<decltype(seen)>;
    layer = kLayerOf<Seen>;
    if constexpr (std::is_same_v<Seen, RangeScan>) {
      return draw(seen, T_map_sensor, options_, fan_, footprint_);
    } else if constexpr (std::is_same_v<Seen, RangeEcho>) {
      return cone_.place(seen, T_map_sensor);
    } else {
      return draw(seen, T_map_sensor, options_, footprint_);
    }
  };
  const Outcome outcome = std::visit(draw_it, z);
  if (outcome != Outcome::inserted) return outcome;
  ++revision_;
  Sheet& sheet = sheets_[index(layer)];
  const CellUpdate set = assign(static_cast<CellByte>(index(layer) + 1));
  const bool keeps_latest = options_.fusion == Fusion::latest;
  CellRect covered;
  if (layer == GridLayer::sonar) {
    if (keeps_latest) cone_.apply(latest_, set, revision_);
    covered = cone_.apply(sheet.tiles, sheet.update, revision_);
  } else {
    if (keeps_latest) Footprint(footprint_).apply(latest_, set, revision_);
    covered = footprint_.apply(sheet.tiles, sheet.update, revision_);
  }
  sheet.bounds = united(sheet.bounds, covered);
  return outcome;
}

bool GridMapper::may_stand_at(const Pose& T_map_sensor) const {
  return is_valid(T_map_sensor) && std::abs(T_map_sensor(0, 3)) <= options_.max_extent &&
         std::abs(T_map_sensor(1, 3)) <= options_.max_extent;
}

std::vector<GridLayer> GridMapper::layers() const {
  std::vector<GridLayer> layers;
  for (GridLayer layer : kGridLayers) {
    if (!sheet(layer).bounds.empty()) layers.push_back(layer);
  }
  return layers;
}

CellRect GridMapper::bounds() const {
  CellRect bounds;
  for (const Sheet& sheet : sheets_) bounds = united(bounds, sheet.bounds);
  return bounds;
}

std::optional<double> GridMapper::probability(GridLayer layer, Cell cell) const {
  const CellByte byte = sheet(layer).tiles.cell(cell);
  if (byte == kNeverObserved) return std::nullopt;
  return log_odds_.probability(byte);
}

std::optional<double> GridMapper::probability(Cell cell) const {
  const CellByte byte = fused(cell);
  if (byte == kNeverObserved) return std::nullopt;
  return log_odds_.probability(byte);
}

CellByte GridMapper::fused(Cell cell) const {
  CellStack stack;
  for (GridLayer layer : kGridLayers) stack[index(layer)] = sheet(layer).tiles.cell(cell);
  return fuse(options_.fusion, log_odds_, stack, latest_.cell(cell));
}

std::vector<CellByte> GridMapper::cells(GridLayer layer, const CellRect& rect) const {
  return make_rows(rect, [&](Cell index) {
    const TileMap::Tile* tile = sheet(layer).tiles.find(index);
    return [tile](std::size_t place) { return cell_in(tile, place); };
  });
}

std::vector<CellByte> GridMapper::cells(const CellRect& rect) const {
  const std::vector<GridLayer> held = layers();
  if (held.size() == 1) return cells(held.front(), rect);
  return make_rows(rect, [&](Cell tile_index) {
    std::array<const TileMap::Tile*, kGridLayers.size()> tiles;
    for (GridLayer layer : kGridLayers) tiles[index(layer)] = sheet(layer).tiles.find(tile_index);
    const TileMap::Tile* latest = latest_.find(tile_index);
    return [this, tiles, latest](std::size_t place) {
      CellStack stack;
      for (std::size_t i = 0; i < stack.size(); ++i) stack[i] = cell_in(tiles[i], place);
      return fuse(options_.fusion, log_odds_, stack, cell_in(latest, place));
    };
  });
}

std::vector<std::int8_t> GridMapper::occupancy(GridLayer layer, const CellRect& rect) const {
  return percents(cells(layer, rect), log_odds_);
}

std::vector<std::int8_t> GridMapper::occupancy(const CellRect& rect) const {
  return percents(cells(rect), log_odds_);
}

CellRect GridMapper::changed_since(std::uint64_t revision, GridLayer layer) const {
  CellRect changed;
  for (const TileMap::Tile& tile : sheet(layer).tiles.tiles()) {
    if (tile.revision > revision) changed = united(changed, tile.rect());
  }
  return intersected(changed, sheet(layer).bounds);
}

CellRect GridMapper::changed_since(std::uint64_t revision) const {
  CellRect changed;
  for (GridLayer layer : kGridLayers) changed = united(changed, changed_since(revision, layer));
  return changed;
}

std::size_t byte_size(const std::variant<RangeScan, RangeEcho, PointCloud>& z) {
  const auto held = [](const auto& seen) { return byte_size(seen) - sizeof(seen); };
  return sizeof(z) + std::visit(held, z);
}

std::size_t byte_size(const GridMapper& map) {
  std::size_t bytes = sizeof(map) + byte_size(map.latest_) - sizeof(map.latest_);
  for (const GridMapper::Sheet& sheet : map.sheets_) {
    bytes += byte_size(sheet.tiles) - sizeof(sheet.tiles);
  }
  return bytes;
}

}  // namespace portolan
