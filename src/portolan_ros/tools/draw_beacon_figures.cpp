// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/beacon/polar.hpp"
#include "portolan/map_file.hpp"
#include "portolan/pose.hpp"
#include "portolan_ros/kinds/beacon_picture.hpp"
#include "portolan_ros/report.hpp"

namespace {

using portolan::BeaconEstimate;
using portolan::BeaconMapper;
using portolan::BeaconOptions;
using portolan::BeaconScene;
using portolan::Hypothesis;

constexpr int kStraight = 12;  // steps before the turn
const Eigen::Vector3d kBeacon(3.5, 2.5, 0.0);

/// Straight ahead along x, then a turn to the left.
Eigen::Vector3d way(int step) {
  constexpr double kStep = 0.5;  // [m]
  if (step < kStraight) return {kStep * step, 0.0, 0.0};
  const double turn = 0.25 * (step - kStraight + 1);
  return {kStep * (kStraight - 1) + 2.0 * std::sin(turn), 2.0 * (1.0 - std::cos(turn)), 0.0};
}

/// A robot on that way that hears the beacon after each step.
class Drive {
 public:
  explicit Drive(const BeaconOptions& options) : mapper_(options) {}

  void go_to(int last) {
    constexpr double kStddev = 0.15;  // [m]
    for (; step_ <= last; ++step_) {
      const Eigen::Vector3d p = way(step_);
      way_.push_back(p);
      const double range = (kBeacon - p).norm() + kStddev * normal();
      portolan::BeaconRanges z;
      z.ranges.push_back({1, range, kStddev});
      mapper_.insert(z, portolan::planar_pose(p.x(), p.y(), 0.0));
    }
  }

  const BeaconMapper& mapper() const { return mapper_; }

  BeaconScene scene() const {
    BeaconScene scene;
    scene.way = way_;
    scene.truth = {kBeacon};
    scene.extent = Eigen::AlignedBox2d(Eigen::Vector2d(-5.0, -5.0), Eigen::Vector2d(8.5, 5.0));
    return scene;
  }

 private:
  /// Near enough to normal, and the same on every standard library.
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine_()) / 4294967296.0;
    return sum;
  }

  std::mt19937 engine_{11};
  BeaconMapper mapper_;
  std::vector<Eigen::Vector3d> way_;
  int step_ = 0;
};

BeaconOptions known_poses_and_device() {
  BeaconOptions options;
  options.drift = 0.0;
  options.calibration.scale_stddev = 0.0;
  options.calibration.bias_stddev = 0.0;
  options.calibration.turn_stddev = 0.0;
  return options;
}

/// Each Gaussian in distance and direction as a beacon of its own, numbered from 1.
std::vector<BeaconEstimate> gaussians_of(const BeaconMapper& mapper) {
  const portolan::BeaconTrack& track = mapper.tracks().begin()->second;
  std::vector<BeaconEstimate> all;
  for (const Hypothesis& hypothesis : track.hypotheses()) {
    std::vector<Hypothesis> parts;
    if (hypothesis.is_polar) {
      append_straightened(hypothesis, track.origin(), mapper.calibration(), parts);
    } else {
      parts.push_back(hypothesis);
    }
    BeaconEstimate estimate;
    estimate.id = static_cast<portolan::BeaconId>(all.size() + 1);
    estimate.ambiguous = track.is_ambiguous();
    std::size_t heaviest = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].weight > parts[heaviest].weight) heaviest = i;
    }
    std::swap(parts[0], parts[heaviest]);
    for (const Hypothesis& part : parts) {
      estimate.modes.push_back(
          {part.weight, part.mean(mapper.calibration()), part.covariance(mapper.calibration())});
    }
    all.push_back(estimate);
  }
  return all;
}

constexpr std::size_t kSide = 640;  // [pixel]

/// After the first range, three more, the straight way, and the turn.
portolan::FileSet figure_11() {
  portolan::FileSet files;
  Drive drive(known_poses_and_device());
  for (const int last : {0, 3, kStraight - 1, kStraight + 5}) {
    drive.go_to(last);
    BeaconScene scene = drive.scene();
    scene.beacons = drive.mapper().estimates();
    files["figure_11_" + std::to_string(files.size() + 1) + ".png"] =
        beacon_picture(scene, kSide).png();
  }
  return files;
}

/// After the first range, two more, and the straight way.
portolan::FileSet figure_12() {
  portolan::FileSet files;
  BeaconOptions options = known_poses_and_device();
  options.parametrization = portolan::BeaconParametrization::polar;
  Drive drive(options);
  for (const int last : {0, 1, kStraight - 1}) {
    drive.go_to(last);
    BeaconScene scene = drive.scene();
    scene.beacons = gaussians_of(drive.mapper());
    files["figure_12_" + std::to_string(files.size() + 1) + ".png"] =
        beacon_picture(scene, kSide).png();
  }
  return files;
}

constexpr const char* kUsage =
    "usage: draw_beacon_figures FOLDER\n"
    "Draws the panels of the chapter's Figures 11 and 12.\n";

}  // namespace

int main(int argc, char** argv) try {
  if (const auto code = portolan::exit_with_usage(argc, argv, 1, 1, kUsage)) return *code;
  portolan::FileSet files = figure_11();
  files.merge(figure_12());
  std::filesystem::create_directories(argv[1]);
  portolan::save_files(argv[1], files);
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
