// SPDX-License-Identifier: BSD-3-Clause
// The 3D mapper in the office, against the office itself.
#include <gtest/gtest.h>

#include "portolan/remapper.hpp"
#include "portolan/sim/simulation.hpp"
#include "portolan/sim/volume_score.hpp"
#include "portolan/sim/world_file.hpp"

namespace portolan::sim {
namespace {

SimulationOptions office(double drift) {
  SimulationOptions options;
  options.world = read_world(PORTOLAN_WORLDS "/office.yaml");
  options.path = {{5.5, 5.0}, {5.5, 9.2}, {14.5, 9.2}, {14.5, 5.0}, {5.5, 5.0}, {5.5, 7.0}};
  options.odometry.alpha1 = options.odometry.alpha2 = 0.0;
  options.odometry.alpha3 = options.odometry.alpha4 = 0.0;
  options.odometry.turn_per_metre = drift;
  options.lasers.clear();
  options.sonar_rings.clear();
  return options;
}

SimulationOptions with_lidar(SimulationOptions options) {
  Lidar::Options lidar;
  lidar.rate = 1.0;
  lidar.columns = 360;
  options.lidars = {lidar};
  return options;
}

SimulationOptions with_camera(SimulationOptions options) {
  DepthCamera::Options camera;
  camera.rate = 2.0;
  camera.field_of_view = 1.5;
  options.depth_cameras = {camera};
  return options;
}

OctoMapper::Options mapper(double max_range, NoReturn no_return) {
  OctoMapper::Options options;
  options.resolution = 0.1;
  options.sensor_model.max_range = max_range;
  options.no_return = no_return;
  return options;
}

/// A drive to the end of the path: the map, what could be seen, and how odometry drifted.
struct Tour {
  Tour(const SimulationOptions& options, const OctoMapper::Options& mapper)
      : simulation(options),
        remapper(RemapperOptions(), mapper),
        view(VoxelLattice(mapper.resolution),
             {Eigen::Vector3d(-1.0, -1.0, -0.5), Eigen::Vector3d(21.0, 15.0, 3.0)},
             mapper.sensor_model.max_range) {
    while (!simulation.path_finished()) {
      for (const Event& event : simulation.step(seconds(0.1))) take(event);
    }
  }

  void take(const Event& event) {
    const Pose T_map_base = simulation.T_map_base().at(event.stamp);
    if (const auto* odometry = std::get_if<Event::Odometry>(&event.payload)) {
      T_odom_base = odometry->T_odom_base;
      if (knots.empty() || event.stamp > knots.back().stamp + seconds(0.5)) {
        knots.push_back({event.stamp, T_map_base * T_odom_base.inverse()});
      }
    }
    const auto* organized = std::get_if<OrganizedCloud>(&event.payload);
    if (organized == nullptr) return;
    const Pose T_base_sensor = mounts(simulation.sensors().front()).back().T_base_frame;
    remapper.observe(event.stamp, T_odom_base * T_base_sensor, organized->cloud);
    view.look(simulation.world(), simulation.sensors().front(), T_map_base, 0.5);
  }

  VolumeScore score() const { return sim::score(remapper.map(), simulation.world(), view); }

  Simulation simulation;
  Remapper<OctoMapper> remapper;
  VolumeView view;
  Pose T_odom_base = Pose::Identity();
  std::vector<Correction::Knot> knots;
};

void expect_good(const VolumeScore& score) {
  EXPECT_GT(score.occupied_precision.value(), 0.98);
  EXPECT_GT(score.occupied_recall.value(), 0.98);
  EXPECT_GT(score.free_precision.value(), 0.98);
  EXPECT_GT(score.free_recall.value(), 0.95);
  EXPECT_GT(score.occupied_recall.of, 2000u);
  EXPECT_GT(score.free_recall.of, 20000u);
}

TEST(OctoOffice, IsMappedByALidar) {
  expect_good(Tour(with_lidar(office(0.0)), mapper(8.0, NoReturn::ignore)).score());
}

TEST(OctoOffice, IsMappedByADepthCamera) {
  const SimulationOptions options = with_camera(office(0.0));
  expect_good(Tour(options, mapper(5.0, NoReturn::clear)).score());
  // What returned nothing is not free for those who do not say so.
  const VolumeScore silent = Tour(options, mapper(5.0, NoReturn::ignore)).score();
  EXPECT_LT(silent.free_recall.value(), 0.9);
  EXPECT_GT(silent.free_precision.value(), 0.98);
}

TEST(OctoOffice, LosesItsDoubleWallsWhenTheLoopIsClosed) {
  Tour tour(with_lidar(office(0.01)), mapper(8.0, NoReturn::ignore));
  const VolumeScore before = tour.score();
  tour.remapper.correct(Correction(tour.knots));
  tour.remapper.finish();
  const VolumeScore after = tour.score();
  EXPECT_LT(before.occupied_precision.value(), 0.9);
  EXPECT_LT(before.free_precision.value(), 0.98);
  expect_good(after);
}

}  // namespace
}  // namespace portolan::sim
