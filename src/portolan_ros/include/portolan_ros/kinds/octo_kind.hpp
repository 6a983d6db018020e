// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "portolan/map_file.hpp"
#include "portolan/octo/octo_mapper.hpp"
#include "portolan_ros/convert/point_cloud.hpp"
#include "portolan_ros/convert/ranges.hpp"
#include "portolan_ros/kinds/octo_filter.hpp"
#include "portolan_ros/kinds/octo_outputs.hpp"
#include "portolan_ros/kinds/octo_services.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {

/// The 3D map as nodes and tools see it: what goes in, what comes out, which files.
struct OctoKind {
  using Mapper = OctoMapper;
  using Filter = OctoFilter;
  using OutputOptions = OctoOutputOptions;
  using Outputs = OctoOutputs;
  using Services = OctoServices;

  static constexpr const char* kName = "octomap";
  static constexpr const char* kFileName = "octomap";
  static constexpr const char* kLegend =
      "From above, and below that from the side: the more occupied voxels lie behind each other, "
      "the "
      "darker. Grey: never seen. Red: the robot's way.";

  /// Calls `add(name, noun, converter)` for each input.
  template <class Add>
  static void inputs(Add&& add) {
    add("cloud_in", "clouds", &ros_convert::organized_cloud);
    add("scan", "scans", &ros_convert::range_scan);
  }

  /// The octree as `.ot` and `.bt`, and the YAML beside them; nothing where nothing was observed.
  static FileSet save(const OctoMapper& map, const std::string& name,
                      const MapperNodeOptions<OctoKind>& options);

  /// From the `.ot` file, or else the `.bt` file. Throws std::runtime_error with path and reason.
  static OctoMapper load(const std::filesystem::path& folder, const std::string& name,
                         const MapperNodeOptions<OctoKind>& options);

  /// A PNG with the map seen from above and, below that, from the side, with the robot's way.
  static FileSet pictures(const OctoMapper& map, const std::string& name,
                          const std::vector<Pose>& T_map_base);

  /// What became of the points, by name.
  static std::map<std::string, std::uint64_t> counts(const OctoMapper& map);
};

}  // namespace portolan
