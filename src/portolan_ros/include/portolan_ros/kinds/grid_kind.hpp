// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "portolan/grid/grid_mapper.hpp"
#include "portolan/map_file.hpp"
#include "portolan_ros/convert/point_cloud.hpp"
#include "portolan_ros/convert/ranges.hpp"
#include "portolan_ros/kinds/grid_outputs.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {

/// The occupancy grid as nodes and tools see it: what goes in, what comes out, which files.
struct GridKind {
  using Mapper = GridMapper;
  using OutputOptions = GridOutputOptions;
  using Outputs = GridOutputs;

  static constexpr const char* kName = "occupancy_grid";
  static constexpr const char* kFileName = "map";
  static constexpr const char* kLegend =
      "Black: occupied. White: free. Grey: between them; the even grey all around: never seen. "
      "Blue: "
      "the robot's way.";

  /// Calls `add(name, noun, converter)` for each input.
  template <class Add>
  static void inputs(Add&& add) {
    add("scan", "scans", &ros_convert::range_scan);
    add("sonar", "echoes", &ros_convert::range_echo);
    add("cloud_in", "clouds", &ros_convert::point_cloud);
  }

  /// The files of the fused map and of each layer; nothing where nothing has been observed. Throws
  /// std::runtime_error for over `max_cells`.
  static FileSet save(const GridMapper& map, const std::string& name,
                      const MapperNodeOptions<GridKind>& options);

  /// Throws std::runtime_error with path and reason.
  static GridMapper load(const std::filesystem::path& folder, const std::string& name,
                         const MapperNodeOptions<GridKind>& options);

  /// A PNG of the fused map and of each layer, with the robot's way in it.
  static FileSet pictures(const GridMapper& map, const std::string& name,
                          const std::vector<Pose>& T_map_base);
};

}  // namespace portolan
