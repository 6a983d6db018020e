// SPDX-License-Identifier: BSD-3-Clause
#include <rosbag/bag.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "../nodes/robot_messages.hpp"
#include "../nodes/truth_recorder.hpp"
#include "portolan/sim/world_file.hpp"
#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/report.hpp"

namespace {

using namespace portolan;
using namespace portolan::sim;

constexpr Duration kAfterEnd = std::chrono::milliseconds(500);  // as the node does

/// A drive whose messages go into a bag, each at the time when a node would publish it.
class Recording {
 public:
  Recording(const RobotSimOptions& node, const SimulationOptions& robot, const std::string& bag)
      : simulation_(robot), truth_(node, simulation_), messages_(node, simulation_.sensors()) {
    bag_.open(bag, rosbag::bagmode::Write);
    const Time now = simulation_.now();
    bag_.write("/tf_static", ros_convert::time(now),
               messages_.mounts_at(now, simulation_.sensors()));
  }

  void go_to_the_end() {
    while (!simulation_.path_finished()) go_on(Simulation::kTick);
    go_on(kAfterEnd);
    bag_.close();
    if (truth_.wanted()) truth_.write(simulation_);
  }

  double seconds_driven() const {
    return to_seconds(simulation_.now() - Time{}) - simulation_.options().start_time;
  }

 private:
  void go_on(Duration duration) {
    for (const Event& event : simulation_.step(duration)) {
      truth_.record(simulation_, event);
      messages_.for_each(event, [&](const std::string& topic, const auto& message) {
        const std::string slash = topic.front() == '/' ? "" : "/";
        bag_.write(slash + topic, ros_convert::time(event.known), message);
      });
    }
  }

  Simulation simulation_;
  TruthRecorder truth_;
  RobotMessages messages_;
  rosbag::Bag bag_;
};

constexpr const char* kUsage =
    "usage: record_drive WORLD.yaml ROBOT.yaml OUT.bag [TRUTH_FOLDER]\n"
    "Records what the simulated robot says on its path through a world; see worlds/ and robots/ "
    "of\n"
    "portolan_bringup.\n";

}  // namespace

/// Records what the simulated robot says on its path through a world, as fast as it can be worked
/// out and without a ROS master: the messages that robot_sim publishes for the same robot file.
int main(int argc, char** argv) try {
  if (const auto code = exit_with_usage(argc, argv, 3, 4, kUsage)) return *code;
  RobotSimOptions node;
  SimulationOptions robot;
  read_options(YAML::LoadFile(argv[2])["robot_sim"], node, robot);
  robot.world = read_world(argv[1], node.wall_height);
  node.truth_directory = argc == 5 ? argv[4] : "";
  if (robot.drive != sim::Drive::path) throw std::invalid_argument("drive: path is wanted");
  Recording drive(node, robot, argv[3]);
  drive.go_to_the_end();
  std::printf("%.1f s of simulated time in %s\n", drive.seconds_driven(), argv[3]);
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
