// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/octo_kind.hpp"

#include <vector>

#include "portolan/octo/octo_files.hpp"
#include "portolan_ros/kinds/octo_picture.hpp"

namespace portolan {

FileSet OctoKind::save(const OctoMapper& map, const std::string& name,
                       const MapperNodeOptions<OctoKind>& options) {
  if (map.blocks().size() == 0) return {};
  return map_files(map, name, options.node.map_frame);
}

OctoMapper OctoKind::load(const std::filesystem::path& folder, const std::string& name,
                          const MapperNodeOptions<OctoKind>& options) {
  const OctoFileOptions& how = options.output.files;
  recover(folder);
  const bool has_log_odds = std::filesystem::exists(folder / (name + ".ot"));
  std::vector<std::string> names = {name + (has_log_odds ? ".ot" : ".bt")};
  if (std::filesystem::exists(folder / (name + ".yaml"))) names.push_back(name + ".yaml");
  const FileSet files = load_files(folder, names, static_cast<std::size_t>(1e6 * how.max_memory));
  return read_octo_files(files, name, options.mapper, how);
}

FileSet OctoKind::pictures(const OctoMapper& map, const std::string& name,
                           const std::vector<Pose>& T_map_base) {
  if (map.blocks().size() == 0) return {};
  return {{name + ".png", octo_picture(map, T_map_base).png()}};
}

std::map<std::string, std::uint64_t> OctoKind::counts(const OctoMapper& map) {
  const PointCounts& counts = map.counts();
  return {{"points that hit", counts.hits},
          {"points beyond the maximum range", counts.beyond_range},
          {"points on the ground", counts.ground},
          {"rays without return", counts.no_returns},
          {"points too near", counts.too_near},
          {"points not finite", counts.not_finite},
          {"points outside of the octree", counts.outside_octree},
          {"rays that say nothing", counts.silent}};
}

}  // namespace portolan
