// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/map_file.hpp"
#include "portolan_ros/convert/beacons.hpp"
#include "portolan_ros/kinds/beacon_outputs.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {

/// The map of beacons as nodes and tools see it: what goes in, what comes out, which files.
struct BeaconKind {
  using Mapper = BeaconMapper;
  using OutputOptions = BeaconOutputOptions;
  using Outputs = BeaconOutputs;

  static constexpr const char* kName = "beacons";
  static constexpr const char* kFileName = "beacons";
  static constexpr const char* kLegend =
      "Every place where each may be, as ellipses of two deviations, the likelier the stronger. "
      "Green: one place. Orange: several; the red line is where to drive to know. Blue: the "
      "robot's "
      "way. Faint lines stand 1 m apart, or 10 m in maps wider than that.";

  /// Calls `add(name, noun, converter)` for each input.
  template <class Add>
  static void inputs(Add&& add) {
    add("beacon_ranges", "rangings", &ros_convert::beacon_ranges);
  }

  /// `<name>.yaml`; nothing where nothing has been observed.
  static FileSet save(const BeaconMapper& map, const std::string& name,
                      const MapperNodeOptions<BeaconKind>& options);

  /// Throws std::runtime_error with path and reason.
  static BeaconMapper load(const std::filesystem::path& folder, const std::string& name,
                           const MapperNodeOptions<BeaconKind>& options);

  /// A PNG from above of all modes, with the robot's way in it.
  static FileSet pictures(const BeaconMapper& map, const std::string& name,
                          const std::vector<Pose>& T_map_base);

  /// What became of the ranges, by name.
  static std::map<std::string, std::uint64_t> counts(const BeaconMapper& map);
};

}  // namespace portolan
