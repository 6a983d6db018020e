// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "portolan/remapper.hpp"
#include "portolan/sim/simulation.hpp"
#include "portolan/sim/world_file.hpp"
#include "portolan_ros/kinds/octo_kind.hpp"
#include "portolan_ros/report.hpp"

namespace {

using namespace portolan;

constexpr double kKnots = 0.2;  // [s] from one knot of the correction to the next

sim::SimulationOptions robot_in(const YAML::Node& robot, const std::string& world_yaml) {
  sim::SimulationOptions options;
  read_options(robot["robot_sim"], options);
  options.world = sim::read_world(world_yaml);
  return options;
}

MapperNodeOptions<OctoKind> mapper_of(const YAML::Node& robot) {
  MapperNodeOptions<OctoKind> options;
  if (robot["octomap"]) read_options(robot["octomap"], options);
  return options;
}

/// A robot whose odometry drifts draws its map by it, and notes what a pose graph ought to find.
class Drive {
 public:
  Drive(const sim::SimulationOptions& robot, const MapperNodeOptions<OctoKind>& options)
      : simulation_(robot), remapper_(options.pipeline.remapper, options.mapper) {}

  void go_to_the_end() {
    while (!simulation_.path_finished()) {
      for (const sim::Event& event : simulation_.step(seconds(0.1))) take(event);
    }
  }

  Correction correction() const { return Correction(knots_); }
  Remapper<OctoMapper>& remapper() { return remapper_; }

 private:
  void take(const sim::Event& event) {
    if (const auto* odometry = std::get_if<sim::Event::Odometry>(&event.payload)) {
      T_odom_base_ = odometry->T_odom_base;
      if (knots_.empty() || event.stamp >= knots_.back().stamp + seconds(kKnots)) {
        const Pose T_map_base = simulation_.T_map_base().at(event.stamp);
        knots_.push_back({event.stamp, T_map_base * T_odom_base_.inverse()});
      }
    }
    const auto* organized = std::get_if<sim::OrganizedCloud>(&event.payload);
    if (organized == nullptr) return;
    PointCloud cloud = organized->cloud;
    cloud.points.shrink_to_fit();
    remapper_.observe(event.stamp, T_odom_base_ * T_base(event.frame), std::move(cloud));
  }

  /// Where the sensor with this frame sits.
  Pose T_base(const std::string& frame) const {
    for (const sim::AnySensor& sensor : simulation_.sensors()) {
      const sim::Mount mount = sim::mounts(sensor).back();
      if (mount.frame == frame) return mount.T_base_frame;
    }
    throw std::logic_error("no sensor has the frame " + frame);
  }

  sim::Simulation simulation_;
  Remapper<OctoMapper> remapper_;
  Pose T_odom_base_ = Pose::Identity();
  std::vector<Correction::Knot> knots_;
};

FileSet files_of(const OctoMapper& map, const std::string& name,
                 const MapperNodeOptions<OctoKind>& options) {
  FileSet files = OctoKind::save(map, name, options);
  files.merge(OctoKind::pictures(map, name, {}));
  return files;
}

constexpr const char* kUsage =
    "usage: close_octomap_loop WORLD.yaml ROBOT.yaml OUT_FOLDER\n"
    "Draws an octree by odometry that drifts, and again once it is told where the robot really "
    "was.\n";

}  // namespace

/// Drives a robot whose odometry drifts, then tells the mapper where it really was, as a pose graph
/// does when it closes a loop. Writes both maps with pictures, before.* and after.*, into a folder,
/// and says what redrawing took.
int main(int argc, char** argv) try {
  if (const auto code = exit_with_usage(argc, argv, 3, 3, kUsage)) return *code;
  const YAML::Node robot = YAML::LoadFile(argv[2]);
  const MapperNodeOptions<OctoKind> options = mapper_of(robot);
  Drive drive(robot_in(robot, argv[1]), options);
  drive.go_to_the_end();
  Remapper<OctoMapper>& remapper = drive.remapper();
  FileSet files = files_of(remapper.map(), "before", options);
  const auto start = std::chrono::steady_clock::now();
  remapper.correct(drive.correction());
  remapper.finish();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  files.merge(files_of(remapper.map(), "after", options));
  std::filesystem::create_directories(argv[3]);
  save_files(argv[3], files);
  std::printf("%zu clouds in a log of %.1f MB redrawn in %.2f s; the map takes %.1f MB\n",
              remapper.log_size(), static_cast<double>(remapper.log_bytes()) * 1e-6, taken.count(),
              static_cast<double>(byte_size(remapper.map())) * 1e-6);
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
