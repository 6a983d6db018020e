// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <stdexcept>

#include "portolan/octo/octree_reader.hpp"
#include "portolan_ros/kinds/octo_kind.hpp"
#include "portolan_ros/report.hpp"

/// Draws a saved octomap, whatever its resolution, as a picture from above and from the side.
int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("usage: draw_octomap MAP.ot OUT.png");
  using namespace portolan;
  const std::filesystem::path map = argv[1];
  MapperNodeOptions<OctoKind> options;
  const std::string file = load_file(map, static_cast<std::size_t>(1e9));
  options.mapper.resolution = read_octree_header(file).resolution;
  const OctoMapper mapper =
      read_octo_files({{map.filename().string(), file}}, map.stem().string(), options.mapper);
  const FileSet pictures = OctoKind::pictures(mapper, "map", {});
  if (pictures.empty()) throw std::runtime_error(map.string() + ": the map is empty");
  const std::filesystem::path out = argv[2];
  save_files(out.has_parent_path() ? out.parent_path() : ".",
             {{out.filename().string(), pictures.at("map.png")}});
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
