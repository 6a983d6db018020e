// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/random_observations.hpp"

namespace portolan {

/// Two maps that no query can tell apart.
inline bool equal_maps(const GridMapper& a, const GridMapper& b) {
  if (a.layers() != b.layers() || !(a.bounds() == b.bounds())) return false;
  for (GridLayer layer : a.layers()) {
    const CellRect rect = a.bounds(layer);
    if (!(rect == b.bounds(layer)) || a.cells(layer, rect) != b.cells(layer, rect)) return false;
  }
  return a.cells(a.bounds()) == b.cells(b.bounds());
}

/// What the laws need to know of GridMapper.
class GridMapperCase {
 public:
  using Mapper = GridMapper;

  explicit GridMapperCase(std::uint32_t seed) : random_(seed), options_(random_.options()) {}

  const GridOptions& options() const { return options_; }
  GridMapper::Observation observation() { return random_.observation(options_); }
  Pose pose() { return random_.pose(options_); }
  static bool equal(const GridMapper& a, const GridMapper& b) { return equal_maps(a, b); }

 private:
  RandomObservations random_;
  GridOptions options_;
};

}  // namespace portolan
