// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/beacon_kind.hpp"

#include <stdexcept>

#include "portolan/beacon/beacon_file.hpp"
#include "portolan_ros/kinds/beacon_picture.hpp"

namespace portolan {

FileSet BeaconKind::save(const BeaconMapper& map, const std::string& name,
                         const MapperNodeOptions<BeaconKind>& /*options*/) {
  if (map.tracks().empty()) return {};
  return {{name + ".yaml", to_yaml(map)}};
}

BeaconMapper BeaconKind::load(const std::filesystem::path& folder, const std::string& name,
                              const MapperNodeOptions<BeaconKind>& options) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 28;
  const std::string file = name + ".yaml";
  const std::string text = load_files(folder, {file}, kMaxBytes).at(file);
  try {
    return beacons_from_yaml(text, options.mapper);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error((folder / file).string() + ": " + error.what());
  }
}

FileSet BeaconKind::pictures(const BeaconMapper& map, const std::string& name,
                             const std::vector<Pose>& T_map_base) {
  constexpr std::size_t kSide = 1000;  // [pixel]
  BeaconScene scene;
  scene.beacons = map.estimates();
  if (scene.beacons.empty()) return {};
  for (const Pose& pose : T_map_base) scene.way.emplace_back(pose.translation());
  return {{name + ".png", beacon_picture(scene, kSide).png()}};
}

std::map<std::string, std::uint64_t> BeaconKind::counts(const BeaconMapper& map) {
  return {{"beacons", map.tracks().size()},
          {"ranges taken", map.counts().taken},
          {"ranges dropped: malformed", map.counts().malformed},
          {"ranges dropped: too long", map.counts().too_long},
          {"ranges dropped: beacons too many", map.counts().refused}};
}

}  // namespace portolan
