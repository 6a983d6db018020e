// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "portolan/grid/cell.hpp"

namespace portolan {

/// A grid map as map_server's files hold it.
struct MapPicture {
  static constexpr std::uint8_t kFree = 254;
  static constexpr std::uint8_t kOccupied = 0;
  static constexpr std::uint8_t kUnknown = 205;
  static constexpr double kOccupiedThresh = 0.65;  ///< above it a cell is taken for occupied
  static constexpr double kFreeThresh = 0.196;     ///< below it for free

  CellRect rect;
  double resolution = 0.0;           ///< [m]
  std::vector<std::uint8_t> pixels;  ///< rows from low y to high y
  std::string mode = "trinary";
  double occupied_thresh = kOccupiedThresh;
  double free_thresh = kFreeThresh;

  /// map_server's rule, in [0, 1]; pixels of negated pictures are turned when they are read.
  double probability(std::uint8_t pixel) const;
};

std::string to_pgm(const MapPicture& picture);
std::string to_map_yaml(const MapPicture& picture, const std::string& image);

/// The picture's file name, as the YAML says it. Throws std::runtime_error with `file` in it.
std::string image_of(const std::string& yaml, const std::string& file);

/// The picture, all but its pixels checked against the PGM's size. Throws std::runtime_error with
/// the names of the files in it.
MapPicture read_map_picture(const std::string& yaml, const std::string& file,
                            const std::string& pgm, const std::string& image);

}  // namespace portolan
