// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "portolan/grid/cell.hpp"
#include "portolan/grid/echo_cone.hpp"
#include "portolan/grid/footprint.hpp"
#include "portolan/grid/grid_layer.hpp"
#include "portolan/grid/grid_options.hpp"
#include "portolan/grid/log_odds.hpp"
#include "portolan/grid/scan_fan.hpp"
#include "portolan/grid/tile_map.hpp"
#include "portolan/observation/point_cloud.hpp"
#include "portolan/observation/range_echo.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/outcome.hpp"
#include "portolan/pose.hpp"

namespace portolan {

/// What the observation occupies in memory [byte].
std::size_t byte_size(const std::variant<RangeScan, RangeEcho, PointCloud>& z);

/// Where the plane is free and where something stands, cell by cell, from scans, cones and clouds:
/// the occupancy grid of Eqs. 2-8.
///
/// Cell (x, y) reaches from x * resolution to (x + 1) * resolution [m], and y alike. Each kind of
/// sensor has its layer; the map is the fusion of the layers that observed a cell.
class GridMapper {
 public:
  using Options = GridOptions;
  using Observation = std::variant<RangeScan, RangeEcho, PointCloud>;

  /// Throws OptionsError with every fault at once.
  explicit GridMapper(const Options& options);

  /// A map that was kept as the cells of its layers: rows of `rect` in each, from low y to high y.
  struct KeptLayer {
    GridLayer layer{};
    CellRect rect;
    std::vector<CellByte> cells;
    std::vector<bool> is_latest;  ///< did it observe the cell last? May be empty.
  };
  GridMapper(const Options& options, const std::vector<KeptLayer>& layers);

  /// Updates each cell that the observation frees or occupies once, Eq. 7; draw.hpp says which.
  /// Poses are projected to the plane. Rejected: a pose that is not finite and rigid, stands beyond
  /// max_extent or tilts more than max_tilt. Unusable: an observation that is malformed.
  Outcome insert(const Observation& z, const Pose& T_map_sensor);

  const Options& options() const { return options_; }

  /// The layers that hold something, in order.
  std::vector<GridLayer> layers() const;

  /// The smallest known rectangle around what was observed: by one layer, and by all.
  CellRect bounds(GridLayer layer) const { return sheet(layer).bounds; }
  CellRect bounds() const;

  /// P(occupied) of a cell, Eq. 8: in one layer, and fused; none where nobody observed it.
  std::optional<double> probability(GridLayer layer, Cell cell) const;
  std::optional<double> probability(Cell cell) const;

  /// The cells of a rectangle, rows from low y to high y, each from low x to high x: P(occupied)
  /// in percent, -1 where nobody observed it. Of one layer, and fused.
  std::vector<std::int8_t> occupancy(GridLayer layer, const CellRect& rect) const;
  std::vector<std::int8_t> occupancy(const CellRect& rect) const;

  /// The same as bytes, which `log_odds` translates.
  std::vector<CellByte> cells(GridLayer layer, const CellRect& rect) const;
  std::vector<CellByte> cells(const CellRect& rect) const;
  const LogOdds& log_odds() const { return log_odds_; }

  /// Counts the insertions that changed the map.
  std::uint64_t revision() const { return revision_; }

  /// A rectangle around all that changed after the map had this revision: in a layer, and in any.
  CellRect changed_since(std::uint64_t revision, GridLayer layer) const;
  CellRect changed_since(std::uint64_t revision) const;

  friend std::size_t byte_size(const GridMapper& map);

 private:
  struct Sheet {
    TileMap tiles;
    CellRect bounds;
    CellUpdate update;
  };

  static std::size_t index(GridLayer layer) { return static_cast<std::size_t>(layer); }
  const Sheet& sheet(GridLayer layer) const { return sheets_[index(layer)]; }
  bool may_stand_at(const Pose& T_map_sensor) const;
  CellByte fused(Cell cell) const;

  Options options_;
  LogOdds log_odds_;
  std::array<Sheet, kGridLayers.size()> sheets_;
  TileMap latest_;  // 1 + the layer that observed the cell last; kept for Fusion::latest alone
  std::uint64_t revision_ = 0;
  ScanFan fan_;
  Footprint footprint_;  // empty between insertions
  EchoCone cone_;
};

/// What the map occupies in memory [byte].
std::size_t byte_size(const GridMapper& map);

}  // namespace portolan
