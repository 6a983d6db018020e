// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "portolan/grid/chain_edges.hpp"
#include "portolan/grid/footprint.hpp"
#include "portolan/grid/scan_beams.hpp"

namespace portolan {

/// Draws the beams of a scan; the sectors of one turn as the outline of the whole visible region,
/// which takes a small part of the time of drawing them one by one.
class ScanFan {
 public:
  /// Draws a scan into a footprint that it opens. False, and nothing is drawn, where that would be
  /// larger than any footprint.
  bool draw(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options,
            Footprint& footprint);

 private:
  struct Edge {
    FinePoint a;
    FinePoint b;  // with the centre they are the corners of a sector
  };
  void make_sectors();
  void join_all();
  void add_overlapping(std::size_t i, std::size_t next);
  void add_half(std::size_t i, double side);
  void join_echoes();
  void draw_rays(Footprint& footprint) const;
  void draw_overlapping(Footprint& footprint) const;
  void draw_rims(Footprint& footprint);
  void draw_echoes(Footprint& footprint);
  void draw_strips(Footprint& footprint) const;
  std::size_t next(std::size_t i) const { return i + 1 < beams_.size() ? i + 1 : 0; }
  bool is_in_first_turn(std::size_t i, std::size_t next) const {
    return i < beams_.first_turn() && next < beams_.first_turn() &&
           !(next == 0 && beams_.is_swept());
  }

  ScanBeams beams_;
  // By beam, of it and the next one: is the line between their ends in the outline, and that of a
  // strip between their echoes?
  std::vector<std::uint8_t> is_rim_;
  std::vector<std::uint8_t> is_strip_;
  std::vector<std::uint8_t> is_end_;  // of a chain
  ChainEdges rims_;
  std::vector<Edge> outline_;             // the rest of it: where chains of sectors end
  std::vector<Edge> overlapping_;         // sectors beyond the first turn
  std::vector<std::size_t> more_strips_;  // beyond the first turn
  FineBounds bounds_;
};

}  // namespace portolan
