// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/truth_files.hpp"

#include <iomanip>
#include <locale>
#include <sstream>

namespace portolan::sim {

namespace {

constexpr int kFormatVersion = 1;
constexpr const char* kNoCovariance = "[0, 0, 0, 0, 0, 0, 0, 0, 0]";

std::ostringstream yaml_stream() {
  std::ostringstream yaml;
  yaml.imbue(std::locale::classic());
  yaml << std::setprecision(12);
  return yaml;
}

std::string flow(const Eigen::Vector3d& p) {
  std::ostringstream yaml = yaml_stream();
  yaml << "[" << p.x() << ", " << p.y() << ", " << p.z() << "]";
  return yaml.str();
}

std::string landmarks_yaml(const World& world) {
  std::ostringstream yaml = yaml_stream();
  yaml << "version: " << kFormatVersion
       << "\nframe_id: map\nlandmarks:" << (world.landmarks().empty() ? " []\n" : "\n");
  for (const auto& [id, p_map] : world.landmarks()) {
    yaml << "  - {id: " << id << ", mean: " << flow(p_map) << ", covariance: " << kNoCovariance
         << ", sightings: 0, kind: truth}\n";
  }
  return yaml.str();
}

std::string beacons_yaml(const World& world) {
  std::ostringstream yaml = yaml_stream();
  yaml << "version: " << kFormatVersion
       << "\nframe_id: map\nbeacons:" << (world.beacons().empty() ? " []\n" : "\n");
  for (const auto& [id, p_map] : world.beacons()) {
    yaml << "  - {id: " << id << ", ranges: 0, modes: [{weight: 1, mean: " << flow(p_map)
         << ", covariance: " << kNoCovariance << "}]}\n";
  }
  return yaml.str();
}

}  // namespace

FileSet grid_files(const std::string& name, const TruthGrid& grid) {
  const MapPicture picture = to_picture(grid);
  return {{name + ".yaml", to_map_yaml(picture, name + ".pgm")}, {name + ".pgm", to_pgm(picture)}};
}

FileSet mark_files(const World& world) {
  return {{"landmarks.yaml", landmarks_yaml(world)}, {"beacons.yaml", beacons_yaml(world)}};
}

std::string to_tum(const Trajectory& trajectory) {
  std::ostringstream tum;
  tum.imbue(std::locale::classic());
  tum << std::fixed << std::setprecision(9);
  for (const auto& [stamp, pose] : trajectory) {
    const Eigen::Quaterniond q(pose.linear());
    const auto count = stamp.time_since_epoch().count();
    tum << count / 1000000000 << "." << std::setw(9) << std::setfill('0') << count % 1000000000;
    for (const double value : {pose.translation().x(), pose.translation().y(),
                               pose.translation().z(), q.x(), q.y(), q.z(), q.w()}) {
      tum << " " << value;
    }
    tum << "\n";
  }
  return tum.str();
}

}  // namespace portolan::sim
