// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "portolan/grid/grid_mapper.hpp"
#include "portolan/map_file.hpp"

namespace portolan {

/// What the pixels of a saved grid tell, as map_server's key `mode` names it.
enum class GridFileMode {
  trinary,  ///< 0 occupied, 254 free, 205 neither or never observed
  scale,    ///< P(occupied) = (255 - pixel) / 255; 205 never observed
};

constexpr std::array<const char*, 2> enum_names(GridFileMode) { return {"trinary", "scale"}; }

/// The map as map_server's files: `<name>.yaml` with `<name>.pgm`, all layers fused, and the same
/// of each layer as `<name>_<layer>`. The layers are fused as they come back from their files: in
/// trinary mode one that is unsure of a cell counts as not having seen it. So what is loaded and
/// saved again gives equal files. Throws std::runtime_error where the map is empty.
FileSet grid_files(const GridMapper& map, const std::string& name, GridFileMode mode);

/// The map of `<name>.yaml`: its layers where it lists them, else its picture as the laser's layer.
/// Pixels count as map_server reads them. The origin is rounded to whole cells. Throws
/// std::runtime_error with path and reason: a file is missing or malformed, has another resolution
/// than the options, an origin that is turned, or too many pixels.
GridMapper load_grid(const std::filesystem::path& folder, const std::string& name,
                     const GridMapper::Options& options);

}  // namespace portolan
