// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "portolan/octo/octo_files.hpp"
#include "portolan/sim/simulation_options.hpp"
#include "portolan/sim/volume_score.hpp"
#include "portolan/sim/world_file.hpp"
#include "portolan_ros/report.hpp"

namespace {

using namespace portolan;

constexpr double kSpacing = 0.5;  // of the places from which the truth is looked at [m]

/// The map with the options that it was drawn with.
OctoMapper load(const std::filesystem::path& yaml) {
  const std::string name = yaml.stem().string();
  const FileSet files =
      load_files(yaml.parent_path(), {name + ".ot", name + ".yaml"}, std::size_t{1} << 31);
  YAML::Node drawn_with = YAML::Load(files.at(name + ".yaml"));
  drawn_with.remove("format");
  drawn_with.remove("map_frame");
  OctoMapper::Options options;
  read_options(drawn_with, options);
  return read_octo_files(files, name, options);
}

std::vector<sim::AnySensor> sensors(const std::string& robot_yaml) {
  sim::SimulationOptions robot;
  read_options(YAML::LoadFile(robot_yaml)["robot_sim"], robot);
  return sensors_of(robot);
}

/// The poses of a TUM file, without their stamps.
std::vector<Pose> poses(const std::string& tum) {
  std::ifstream file(tum);
  std::vector<Pose> poses;
  std::string stamp;
  Eigen::Vector3d p;
  Eigen::Quaterniond q;
  while (file >> stamp >> p.x() >> p.y() >> p.z() >> q.x() >> q.y() >> q.z() >> q.w()) {
    poses.emplace_back(Eigen::Translation3d(p) * q.normalized());
  }
  if (poses.empty()) throw std::runtime_error(tum + ": no poses");
  return poses;
}

/// All obstacles and a little more, from below the floor to above the ceiling.
Eigen::AlignedBox3d space(const sim::World& world) {
  Eigen::AlignedBox3d box;
  for (const sim::Obstacle& obstacle : world.obstacles()) {
    const Eigen::Vector2d half = half_extent(obstacle);
    box.extend(Eigen::Vector3d(obstacle.center.x() - half.x(), obstacle.center.y() - half.y(),
                               std::min(0.0, obstacle.bottom)));
    box.extend(Eigen::Vector3d(obstacle.center.x() + half.x(), obstacle.center.y() + half.y(),
                               obstacle.top));
  }
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(0.3);
  return {box.min() - margin, box.max() + margin};
}

sim::VolumeView view_of(const sim::World& world, const OctoMapper& map,
                        const std::vector<sim::AnySensor>& sensors,
                        const std::vector<Pose>& T_map_base) {
  const double max_range = map.options().sensor_model.max_range;
  sim::VolumeView view(map.lattice(), space(world), max_range > 0.0 ? max_range : 1e3);
  for (const Pose& pose : T_map_base) {
    for (const sim::AnySensor& sensor : sensors) view.look(world, sensor, pose, kSpacing);
  }
  return view;
}

constexpr const char* kUsage =
    "usage: score_octomap NAME MAP.yaml WORLD.yaml ROBOT.yaml TRAJECTORY.tum\n"
    "Compares an octree with the world: prints a row of a Markdown table, precision and recall of\n"
    "occupied voxels and of free ones.\n";

}  // namespace

/// Prints a row of a Markdown table: name, precision and recall of occupied voxels, and of free
/// ones. The truth is what lidars and depth cameras of the robot could see from its true path.
int main(int argc, char** argv) try {
  if (const auto code = exit_with_usage(argc, argv, 5, 5, kUsage)) return *code;
  const OctoMapper map = load(argv[2]);
  const sim::World world(sim::read_world(argv[3]));
  const sim::VolumeView view = view_of(world, map, sensors(argv[4]), poses(argv[5]));
  const sim::VolumeScore score = sim::score(map, world, view);
  std::printf("| %s | %.3f | %.3f | %.3f | %.3f |\n", argv[1], score.occupied_precision.value(),
              score.occupied_recall.value(), score.free_precision.value(),
              score.free_recall.value());
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
