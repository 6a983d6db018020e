// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "portolan/grid/cell.hpp"
#include "portolan/grid/edge_plane.hpp"
#include "portolan/grid/fine_walk.hpp"
#include "portolan/grid/tile_map.hpp"

namespace portolan {

template <class Rows>
class RowUpdate;

/// The cells that one observation frees and those that it occupies, as bits; drawn here first, then
/// put into a map, so that each cell is updated at most once and occupied wins over free.
///
/// Geometry is rounded to 1/1024 of a cell once; from there on all is decided in exact integers: a
/// cell is in a polygon when its centre is, by the even-odd rule, where a centre on a left or lower
/// edge is in and on a right or upper one is not.
class Footprint {
 public:
  static constexpr int kFineLog2 = FinePoint::kCellLog2;
  static constexpr int kFine = FinePoint::kCell;
  static constexpr int kMaxSide = 8500;  ///< [cell]: keeps the walks exact

  /// The anchor that all points are counted from, in 1/1024 of a cell from the map's origin.
  struct Anchor {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };

  /// Starts an empty footprint whose points lie in [min, max]. False, and nothing is started, where
  /// that is larger than any sensor's reach.
  bool open(Anchor anchor, FinePoint min, FinePoint max);

  /// An edge of the outline of the free region. The edges of all closed outlines together decide by
  /// the even-odd rule.
  void outline(FinePoint a, FinePoint b) {
    edges(toggled_, is_toggled_).toggle(in_window(a), in_window(b));
  }

  /// The same of the occupied region.
  void outline_occupied(FinePoint a, FinePoint b) {
    edges(struck_, is_struck_).toggle(in_window(a), in_window(b));
  }

  /// Frees a polygon whatever it overlaps. Not between `outline`s.
  void fill(const FinePoint* corners, int count) { fill(free_, corners, count); }

  /// Occupies a polygon. Not between `outline`s.
  void fill_occupied(const FinePoint* corners, int count) { fill(occupied_, corners, count); }

  /// Frees the cells under a thin line: of every row that it crosses steeply, or of every column
  /// that it crosses otherwise, the cell that holds the line at the middle of that row or column.
  void ray(FinePoint a, FinePoint b);

  /// Occupies the cell that holds the point.
  void occupy(FinePoint p) { cell_pen().set(p); }

  /// Draws into one plane of a footprint, and holds all that takes, so that many strokes need not
  /// look it up anew. Of use until the footprint is opened again.
  struct Pen {
    EdgePlane plane;
    FinePoint shift;

    FinePoint in_window(FinePoint p) const { return {p.x + shift.x, p.y + shift.y}; }
    void toggle(FinePoint a, FinePoint b) const { plane.toggle(in_window(a), in_window(b)); }
    void set(FinePoint p) const {
      p = in_window(p);
      plane.set(p.x >> kFineLog2, p.y >> kFineLog2);
    }
  };
  Pen outline_pen() { return {edges(toggled_, is_toggled_), shift_}; }  ///< see `outline`
  Pen occupied_outline_pen() { return {edges(struck_, is_struck_), shift_}; }
  Pen cell_pen() { return {edges(occupied_, is_occupied_), shift_}; }  ///< see `occupy`

  /// Puts the footprint into a map, whose tiles get this revision; the footprint is empty then.
  /// Returns the cells that it covers at most.
  CellRect apply(TileMap& map, const CellUpdate& update, std::uint64_t revision);

 private:
  using Word = std::uint64_t;

  EdgePlane edges(std::vector<Word>& plane, std::vector<std::uint8_t>& marks) {
    return {plane.data(), marks.data(), rows_};
  }

  FinePoint in_window(FinePoint p) const { return {p.x + shift_.x, p.y + shift_.y}; }
  Word& word(std::vector<Word>& plane, int column, int row) {
    return plane[std::size_t(column >> 6) * std::size_t(rows_) + std::size_t(row)];
  }
  std::size_t tile_at(int column, int row) const {
    return std::size_t(column >> 6) * std::size_t(rows_ >> 6) + std::size_t(row >> 6);
  }
  void fill(std::vector<Word>& into, const FinePoint* corners, int count);
  void settle(std::vector<Word>& into, FinePoint min, FinePoint max);
  template <class Rows>
  bool put(TileMap& map, const RowUpdate<Rows>& update, std::uint64_t revision, Rows);
  static Word* marked(std::vector<Word>& plane, std::vector<std::uint8_t>& marks, std::size_t tile);

  CellRect covered_;   // in the map
  Cell tile_;          // index of the window's lowest tile
  FinePoint shift_;    // from the anchor to the window's corner
  int strips_ = 0;     // width of the window in words
  int rows_ = 0;       // height of the window in cells, whole tiles
  int first_row_ = 0;  // the covered rows within the window
  int end_row_ = 0;
  // Planes of bits: strips of 64 columns, each with its rows one after the other.
  std::vector<Word> toggled_;  // is the number of edges left of the cell odd?
  std::vector<Word> struck_;   // the same of the occupied region
  std::vector<Word> free_;
  std::vector<Word> occupied_;
  // By tile: does the plane hold something there?
  std::vector<std::uint8_t> is_toggled_;
  std::vector<std::uint8_t> is_struck_;
  std::vector<std::uint8_t> is_free_;
  std::vector<std::uint8_t> is_occupied_;
};

}  // namespace portolan
