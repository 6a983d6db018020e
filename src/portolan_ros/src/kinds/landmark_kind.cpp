// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/landmark_kind.hpp"

#include <cstdlib>
#include <stdexcept>

#include "portolan/landmark/landmark_file.hpp"
#include "portolan_ros/kinds/beacon_picture.hpp"

namespace portolan {

FileSet LandmarkKind::save(const LandmarkMapper& map, const std::string& name,
                           const MapperNodeOptions<LandmarkKind>& /*options*/) {
  if (map.estimates().empty()) return {};
  return {{name + ".yaml", to_yaml(map)}};
}

LandmarkMapper LandmarkKind::load(const std::filesystem::path& folder, const std::string& name,
                                  const MapperNodeOptions<LandmarkKind>& options) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
  const std::string file = name + ".yaml";
  const std::string text = load_files(folder, {file}, kMaxBytes).at(file);
  try {
    return landmarks_from_yaml(text, options.mapper);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error((folder / file).string() + ": " + error.what());
  }
}

FileSet LandmarkKind::pictures(const LandmarkMapper& map, const std::string& name,
                               const std::vector<Pose>& T_map_base) {
  constexpr std::size_t kSide = 1000;  // [pixel]
  BeaconScene scene;                   // a landmark is drawn like a beacon that has one place
  for (const LandmarkEstimate& landmark : map.estimates()) {
    if (landmark.form == LandmarkForm::direction) continue;
    BeaconEstimate drawn;
    drawn.id = static_cast<BeaconId>(std::abs(std::int64_t{landmark.id}));
    drawn.ambiguous = landmark.form != LandmarkForm::point;
    drawn.modes.push_back({1.0, landmark.mean, landmark.covariance});
    scene.beacons.push_back(drawn);
  }
  if (scene.beacons.empty()) return {};
  for (const Pose& pose : T_map_base) scene.way.emplace_back(pose.translation());
  return {{name + ".png", beacon_picture(scene, kSide).png()}};
}

std::map<std::string, std::uint64_t> LandmarkKind::counts(const LandmarkMapper& map) {
  const LandmarkCounts& counts = map.counts();
  return {{"landmarks", map.estimates().size()},     {"landmarks merged", counts.merged},
          {"landmarks forgotten", counts.forgotten}, {"landmarks moved", counts.moved},
          {"sightings malformed", counts.malformed}, {"sightings repeated", counts.repeated},
          {"sightings refused", counts.refused},     {"sightings that were taken", counts.taken},
          {"sightings wrong", counts.wrong}};
}

}  // namespace portolan
