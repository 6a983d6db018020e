// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "portolan/grid/grid_mapper.hpp"
#include "portolan/map_file.hpp"

namespace portolan {

/// What the pixels of a saved map keep.
enum class PixelMode {
  trinary,  ///< free, occupied or unknown, for map_server and its like
  scale,    ///< probabilities, to within 1/255
};

constexpr std::array<const char*, 2> enum_names(PixelMode) { return {"trinary", "scale"}; }

/// The map as map_server's pairs of YAML and PGM: the fused one as NAME.yaml and NAME.pgm, and each
/// layer as NAME_LAYER.yaml and NAME_LAYER.pgm; NAME.yaml names its layers. Pixel 205 is unknown in
/// both modes. Throws std::runtime_error where nothing has been observed.
FileSet map_files(const GridMapper& map, PixelMode mode, const std::string& name = "map");

/// The map in such files, and again the same files when it is saved in the same mode with the same
/// options. A fused map alone, of whatever origin, becomes the laser layer. Throws
/// std::runtime_error with the file's name and the reason: not of this format or version, sizes
/// that do not fit, numbers that are not finite, a resolution other than the options', an origin
/// that is turned or no corner of a cell. Throws OptionsError as the mapper does.
GridMapper read_map_files(const FileSet& files, const std::string& name,
                          const GridMapper::Options& options);

/// The same from a folder: NAME.yaml, the layers that it names, and their pictures; what an older
/// map left beside them is not read. Throws also as `load_files` does.
GridMapper load_map(const std::filesystem::path& folder, const std::string& name,
                    const GridMapper::Options& options);

}  // namespace portolan
