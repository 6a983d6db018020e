// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "beacon_bag.hpp"
#include "mrpt_beacons.hpp"

namespace portolan::bench {
namespace {

/// What to compare, as the command line says.
struct Comparison {
  std::string log;
  std::string truth;
  std::string poses;
  bool align = false;
};

using Errors = std::map<BeaconId, double>;  // [m]

Comparison parsed(const std::vector<std::string>& words) {
  Comparison comparison;
  std::vector<std::string> files;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--align") {
      comparison.align = true;
    } else if (words[i] == "--poses" && i + 1 < words.size()) {
      comparison.poses = words[++i];
    } else {
      files.push_back(words[i]);
    }
  }
  if (files.size() != 2) {
    throw std::invalid_argument("usage: compare_beacons [--align] [--poses POSES] LOG TRUTH");
  }
  comparison.log = files[0];
  comparison.truth = files[1];
  return comparison;
}

// Lines `row x y yaw`: the robot after each action.
std::vector<Pose> read_poses(const std::string& path) {
  std::vector<Pose> poses;
  std::ifstream table(path);
  double row = 0.0;
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
  while (table >> row >> x >> y >> yaw) poses.push_back(planar_pose(x, y, yaw));
  if (poses.empty()) throw std::runtime_error(path + ": holds no lines `row x y yaw`");
  return poses;
}

BeaconWorkload read(const Comparison& what) {
  const std::string ending = ".bag";
  const std::string& log = what.log;
  const bool is_bag = log.size() > ending.size() &&
                      log.compare(log.size() - ending.size(), ending.size(), ending) == 0;
  if (is_bag && !what.poses.empty()) throw std::invalid_argument("--poses is for rawlogs");
  BeaconWorkload load = is_bag ? beacon_bag(log)
                               : beacon_rawlog(log, what.poses.empty() ? std::vector<Pose>{}
                                                                       : read_poses(what.poses));
  load.truth = read_places(what.truth);
  return load;
}

// Turned and shifted to lie as near to `to` as can be, column by column, in least squares.
Eigen::Matrix2Xd aligned(const Eigen::Matrix2Xd& from, const Eigen::Matrix2Xd& to) {
  const Eigen::Matrix2Xd a = from.colwise() - from.rowwise().mean();
  const Eigen::Matrix2Xd b = to.colwise() - to.rowwise().mean();
  const double along = a.cwiseProduct(b).sum();
  const double across = (a.row(0).cwiseProduct(b.row(1)) - a.row(1).cwiseProduct(b.row(0))).sum();
  const Eigen::Rotation2Dd turn(std::atan2(across, along));
  return (turn.toRotationMatrix() * a).colwise() + to.rowwise().mean();
}

Errors errors(const Places& found, const Places& truth, bool align) {
  std::vector<BeaconId> ids;
  for (const auto& [id, place] : found) {
    if (truth.count(id) > 0) ids.push_back(id);
  }
  Eigen::Matrix2Xd from(2, ids.size());
  Eigen::Matrix2Xd to(2, ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    from.col(static_cast<Eigen::Index>(i)) = found.at(ids[i]).head<2>();
    to.col(static_cast<Eigen::Index>(i)) = truth.at(ids[i]).head<2>();
  }
  if (align) from = aligned(from, to);
  Errors errors;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    errors[ids[i]] = (from - to).col(static_cast<Eigen::Index>(i)).norm();
  }
  return errors;
}

// The peer takes one deviation for all ranges, which decides how it fares: its errors by that [m].
std::map<double, Errors> errors_of_peer(BeaconWorkload load, bool align) {
  std::map<double, Errors> all;
  for (const double stddev : {0.02, 0.05, 0.1, 0.2, 0.3, 0.6, 1.0, 1.8}) {
    load.stddev = stddev;
    all[stddev] = errors(mrpt_beacons(load)(), load.truth, align);
  }
  return all;
}

void print(const std::string& label, const Errors& errors) {
  std::cout << std::setw(14) << label;
  double sum = 0.0;
  for (const auto& [id, error] : errors) {
    sum += error;
    std::cout << std::setw(9) << error;
  }
  std::cout << std::setw(9) << sum / static_cast<double>(errors.size()) << "\n";
}

void compare(const Comparison& what) {
  const BeaconWorkload load = read(what);
  const Errors ours = errors(places(map_beacons(BeaconOptions{}, load)), load.truth, what.align);
  if (ours.empty()) throw std::runtime_error(what.truth + ": names none of the log's beacons");
  std::cout << std::fixed << std::setprecision(3) << "errors [m] of  ";
  for (const auto& [id, error] : ours) std::cout << std::setw(8) << id << " ";
  std::cout << "    mean\n";
  print("ours", ours);
  for (const auto& [stddev, peers] : errors_of_peer(load, what.align)) {
    print("MRPT, " + std::to_string(stddev).substr(0, 4) + " m", peers);
  }
}

}  // namespace
}  // namespace portolan::bench

int main(int argc, char** argv) try {
  portolan::bench::compare(portolan::bench::parsed({argv + 1, argv + argc}));
  return 0;
} catch (const std::invalid_argument& error) {
  std::cerr << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
