// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "portolan/grid/edge_plane.hpp"
#include "portolan/grid/fine_walk.hpp"

namespace portolan {

/// Points of a chain, one after the other.
struct FinePoints {
  std::vector<std::int32_t> x;
  std::vector<std::int32_t> y;
  FinePoint at(std::size_t i) const { return {x[i], y[i]}; }
};

/// Toggles the edges between neighbours of a chain of points, most of which are short.
///
/// Whether an edge passes the centre of a row, and of how many, is random, and branches on that
/// would cost more than all the rest. So all edges go through each step together: which ones count,
/// how each runs, then the first row of every edge, the second row of those that have one, and so
/// on.
class ChainEdges {
 public:
  /// Those from point i to point i + 1 where `is_marked[i]` is 1; all points are shifted so.
  void toggle(const FinePoints& points, const std::vector<std::uint8_t>& is_marked, FinePoint shift,
              const EdgePlane& plane);

 private:
  void choose(const FinePoints& points, const std::vector<std::uint8_t>& is_marked,
              FinePoint shift);
  void toggle_long(const FinePoints& points, FinePoint shift, const EdgePlane& plane);
  void start(const FinePoints& points, FinePoint shift);
  void toggle_rows(EdgePlane plane);

  std::vector<std::int32_t> first_row_;  // above each point
  std::vector<std::uint8_t> passes_;     // by edge: does it pass the centre of a row?
  std::vector<std::uint32_t> edges_;     // that do and are short, by their first point
  // Of those, see fine_walk::Walk.
  std::vector<std::int32_t> row_;
  std::vector<std::int32_t> end_;
  std::vector<std::int64_t> position_;
  std::vector<std::int64_t> step_;
};

}  // namespace portolan
