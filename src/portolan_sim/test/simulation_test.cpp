// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "sim_fixtures.hpp"

namespace portolan::sim {
namespace {

using namespace std::chrono_literals;

/// A room with all kinds of sensors, so coarse that they are quick.
SimulationOptions everything() {
  SimulationOptions options;
  options.seed = 7;
  options.world = room(6.0);
  options.world.tour = {{1, 1}, {4, 1}, {4, 4}};
  for (int id = 1; id <= 5; ++id) {
    options.world.landmarks.push_back({id, {0.1, id - 0.5, 0.4}});
    options.world.beacons.push_back({id, {5.9, id - 0.5, 1.0}});
  }
  options.lidars.resize(1);
  options.lidars[0].columns = 30;
  options.depth_cameras.resize(1);
  options.depth_cameras[0].width = options.depth_cameras[0].height = 8;
  options.landmark_sensors.resize(1);
  options.cameras.resize(1);
  options.beacon_receivers.resize(1);
  return options;
}

struct Print {
  std::ostream& out;

  void operator()(const Event::Odometry& z) const {
    out << z.T_odom_base.matrix() << z.covariance << z.velocity.forward << z.velocity.turn;
  }
  void operator()(const Event::Truth& z) const { out << z.T_map_base.matrix(); }
  void operator()(const Event::Scan& z) const {
    for (const float range : z.scan.ranges) out << range << ' ';
    out << z.scan.T_first_last.matrix() << z.time_increment;
  }
  void operator()(const RangeEcho& z) const { out << z.range; }
  void operator()(const OrganizedCloud& z) const {
    for (const auto& point : z.cloud.points) out << point.transpose() << ' ';
  }
  void operator()(const LandmarkSightings& z) const {
    for (const auto& s : z.sightings) out << s.id << s.range << s.azimuth << s.elevation << ' ';
  }
  void operator()(const ImageFeatures& z) const {
    for (const auto& f : z.features) out << f.id << ' ' << f.u << ' ' << f.v << ' ';
  }
  void operator()(const BeaconRanges& z) const {
    for (const auto& r : z.ranges) out << r.id << ' ' << r.range << ' ';
  }
};

/// All that was said about a topic, every bit of it.
std::string said(const std::vector<Event>& events, const std::string& topic = "") {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Event& event : events) {
    if (!topic.empty() && event.topic != topic) continue;
    out << event.stamp.time_since_epoch().count() << event.topic << event.frame;
    std::visit(Print{out}, event.payload);
    out << '\n';
  }
  return out.str();
}

TEST(Simulation, TheSameSeedGivesTheSameRunAndAnotherOneAnother) {
  SimulationOptions options = everything();
  const std::string first = said(Simulation(options).step(3s));
  EXPECT_EQ(first, said(Simulation(options).step(3s)));
  options.seed = 8;
  EXPECT_NE(first, said(Simulation(options).step(3s)));
}

TEST(Simulation, TheStepDoesNotMatter) {
  Simulation whole(everything());
  Simulation pieces(everything());
  std::vector<Event> events;
  while (pieces.now() < Time{13s}) {
    for (Event& event : pieces.step(70ms)) events.push_back(std::move(event));
  }
  EXPECT_EQ(said(whole.step(pieces.now() - Time{10s})), said(events));
}

TEST(Simulation, OneSensorMoreChangesNothingForTheOthers) {
  SimulationOptions few = everything();
  few.lidars.clear();
  few.sonar_rings.clear();
  few.beacon_receivers.clear();
  const auto all = Simulation(everything()).step(3s);
  const auto some = Simulation(few).step(3s);
  for (const char* topic :
       {"odom", "ground_truth", "scan", "landmark_sightings", "image_features"}) {
    EXPECT_FALSE(said(some, topic).empty());
    EXPECT_EQ(said(all, topic), said(some, topic)) << topic;
  }
}

TEST(Simulation, EverySensorMeasuresAtItsRate) {
  SimulationOptions options = everything();
  options.lasers[0].rate = 7.0;
  options.sonar_rings[0].in_turn = true;
  std::map<std::string, int> count;
  for (const Event& event : Simulation(options).step(10s)) ++count[event.topic];
  EXPECT_EQ(count["scan"], 70);
  EXPECT_EQ(count["sonar"], 5 * 8 * 10);
  EXPECT_EQ(count["odom"], 500);
  EXPECT_EQ(count["cloud_in"], 200);
  EXPECT_EQ(count["beacon_ranges"], 50);
}

TEST(Simulation, EventsComeInTheOrderInWhichTheyAreKnown) {
  SimulationOptions options = everything();
  options.lasers[0].sweep_time = 0.08;
  Simulation simulation(options);
  Time last;
  int sweeps = 0;
  for (const Event& event : simulation.step(2s)) {
    EXPECT_GE(event.known, last);
    EXPECT_GE(event.known, event.stamp);
    last = event.known;
    if (event.topic == "scan") {
      ++sweeps;
      EXPECT_EQ(event.known - event.stamp, Duration{80ms});
    }
  }
  EXPECT_EQ(sweeps, 20);
}

TEST(Simulation, ASweepKnowsByOdometryHowTheLaserMoved) {
  SimulationOptions options = everything();
  options.lasers[0].sweep_time = 0.1;
  options.odometry = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0};
  Simulation simulation(options);
  simulation.step(3s);
  for (const Event& event : simulation.step(1s)) {
    if (event.topic != "scan") continue;
    const RangeScan& scan = std::get<Event::Scan>(event.payload).scan;
    EXPECT_NEAR(scan.T_first_last.translation().x(), 0.05, 1e-6);
  }
}

TEST(Simulation, OdometryBeginsAtTheTruthOrAtZero) {
  SimulationOptions options = everything();
  options.odometry = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0};
  for (const OdometryOrigin origin : {OdometryOrigin::map, OdometryOrigin::start}) {
    options.odometry_origin = origin;
    Simulation simulation(options);
    const bool at_truth = origin == OdometryOrigin::map;
    const Pose T_map_odom = at_truth ? Pose::Identity() : simulation.T_map_start();
    for (const Event& event : simulation.step(5s)) {
      if (event.topic != "odom") continue;
      const Pose T_odom_base = std::get<Event::Odometry>(event.payload).T_odom_base;
      const Pose T_map_base = simulation.T_map_base().at(event.stamp);
      if (event.stamp < simulation.now() - 1s) continue;  // forgotten by now
      EXPECT_TRUE((T_map_odom * T_odom_base).isApprox(T_map_base, 1e-6));
    }
  }
}

TEST(Simulation, FollowsThePathToItsEnd) {
  SimulationOptions options = everything();
  Simulation simulation(options);
  EXPECT_FALSE(simulation.path_finished());
  simulation.step(30s);
  EXPECT_TRUE(simulation.path_finished());
  const Eigen::Vector3d end = simulation.robot().T_map_base().translation();
  EXPECT_LT((end - Eigen::Vector3d(4, 4, 0)).norm(), 0.1);
}

TEST(Simulation, ObeysCommandsUntilTheyGrowOld) {
  SimulationOptions options = everything();
  options.drive = Drive::command;
  options.start = {1.0, 3.0, 0.0};
  Simulation simulation(options);
  EXPECT_TRUE(simulation.T_map_start().isApprox(planar_pose(1.0, 3.0, 0.0)));
  simulation.command({0.4, 0.0});
  simulation.step(5s);
  EXPECT_EQ(simulation.robot().velocity().forward, 0.0);
  const double driven = simulation.robot().T_map_base().translation().x() - 1.0;
  EXPECT_NEAR(driven, 0.4 * 0.5, 0.02);
  EXPECT_FALSE(simulation.path_finished());
}

TEST(Simulation, TwoSensorsMayNotShareAFrame) {
  SimulationOptions options = everything();
  options.lasers.resize(2);
  try {
    Simulation simulation(options);
    FAIL() << "two lasers in one frame were taken";
  } catch (const OptionsError& error) {
    EXPECT_NE(std::string(error.what()).find("laser"), std::string::npos);
  }
}

TEST(Simulation, OptionsAreReadFromYaml) {
  SimulationOptions options;
  read_options(YAML::Load("{seed: 3, drive: command, lasers: [{frame: front, beams: 10}], "
                          "sonar_rings: [], world: {boxes: [{center: [1, 2], material: soft}]}}"),
               options);
  EXPECT_EQ(options.drive, Drive::command);
  EXPECT_EQ(options.lasers.at(0).beams, 10);
  EXPECT_EQ(options.lasers.at(0).topic, "scan");
  EXPECT_TRUE(options.sonar_rings.empty());
  EXPECT_EQ(options.world.boxes.at(0).material, Material::soft);
  EXPECT_THROW(read_options(YAML::Load("{lasers: [{beans: 10}]}"), options), OptionsError);
}

}  // namespace
}  // namespace portolan::sim
