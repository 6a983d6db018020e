// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "portolan/landmark/landmark_mapper.hpp"
#include "portolan/map_file.hpp"
#include "portolan_ros/convert/landmarks.hpp"
#include "portolan_ros/kinds/landmark_finder.hpp"
#include "portolan_ros/kinds/landmark_outputs.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {

/// The map of landmarks as nodes and tools see it: what goes in, what comes out, which files.
struct LandmarkKind {
  using Mapper = LandmarkMapper;
  using Filter = LandmarkFinder;
  using OutputOptions = LandmarkOutputOptions;
  using Outputs = LandmarkOutputs;

  static constexpr const char* kName = "landmarks";
  static constexpr const char* kFileName = "landmarks";
  static constexpr const char* kLegend =
      "Each with its number where there is room, in its ellipse of two deviations. Blue: the "
      "robot's way. Faint "
      "lines stand 1 m apart, or 10 m in maps wider than that.";

  /// Calls `add(name, noun, converter)` for each input. Scans have a topic of their own, since not
  /// every scanner sees landmarks.
  template <class Add>
  static void inputs(Add&& add) {
    add("camera_info", "calibrations", &ros_convert::camera_info);
    add("landmark_sightings", "sightings", &ros_convert::landmark_sightings);
    add("image_features", "images", &ros_convert::image_features);
    add("landmark_scan", "scans", &ros_convert::intensity_scan);
  }

  /// `<name>.yaml`; nothing where nothing has been observed.
  static FileSet save(const LandmarkMapper& map, const std::string& name,
                      const MapperNodeOptions<LandmarkKind>& options);

  /// Throws std::runtime_error with path and reason.
  static LandmarkMapper load(const std::filesystem::path& folder, const std::string& name,
                             const MapperNodeOptions<LandmarkKind>& options);

  /// A PNG from above, with the robot's way in it; orange where the depth is uncertain.
  static FileSet pictures(const LandmarkMapper& map, const std::string& name,
                          const std::vector<Pose>& T_map_base);

  /// What became of single sightings, by name.
  static std::map<std::string, std::uint64_t> counts(const LandmarkMapper& map);
};

}  // namespace portolan
