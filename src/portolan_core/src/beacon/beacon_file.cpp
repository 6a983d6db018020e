// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/beacon_file.hpp"

#include <yaml-cpp/yaml.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

#include "portolan/yaml_items.hpp"
#include "portolan/yaml_values.hpp"

namespace portolan {

namespace {

constexpr int kVersion = 1;
using options_detail::format_double;

using yaml_values::check_version;
using yaml_values::covariance;
using yaml_values::finite_number;
using yaml_values::listed;
using yaml_values::matrix;
using yaml_values::read_items;
using yaml_values::require;

std::string shown(const BeaconMode& mode) {
  return "      - weight: " + format_double(mode.weight) + "\n        mean: " + listed(mode.mean) +
         "\n        covariance: " + listed(mode.covariance) + "\n";
}

std::string shown(const BeaconEstimate& beacon) {
  std::string text = "  - id: " + std::to_string(beacon.id) +
                     "\n    ranges: " + std::to_string(beacon.ranges) +
                     "\n    outliers: " + std::to_string(beacon.outliers) +
                     "\n    restarts: " + std::to_string(beacon.restarts) + "\n    modes:\n";
  for (const BeaconMode& mode : beacon.modes) text += shown(mode);
  return text;
}

Hypothesis read_mode(const YAML::Node& node, const std::string& name) {
  Hypothesis hypothesis;
  const double weight = finite_number(node["weight"], name + ": weight");
  require(weight > 0.0 && weight <= 1.0 + 1e-9, name + ": weight must be in (0, 1]");
  hypothesis.weight = weight;
  hypothesis.log_weight = std::log(weight);
  hypothesis.x = matrix<3, 1>(node["mean"], name + ": mean");
  hypothesis.Q = covariance(node["covariance"], name + ": covariance");
  return hypothesis;
}

std::size_t read_count(const YAML::Node& node) {
  return node.IsDefined() ? node.as<std::size_t>() : 0;
}

BeaconTrack read_track(const YAML::Node& node, const std::string& name,
                       const BeaconOptions& options) {
  require(node["ranges"].IsDefined(), name + ": ranges is missing");
  require(node["modes"].IsDefined() && node["modes"].IsSequence() && node["modes"].size() > 0,
          name + " has no modes");
  std::vector<Hypothesis> hypotheses;
  double total = 0.0;
  for (const YAML::Node& mode : node["modes"]) {
    require(mode.IsMap(), name + ": a mode is no map of keys");
    hypotheses.push_back(read_mode(mode, name));
    total += hypotheses.back().weight;
  }
  require(std::abs(total - 1.0) < 1e-6, name + ": weights do not sum to 1");
  return BeaconTrack::restored(std::move(hypotheses), read_count(node["ranges"]),
                               read_count(node["outliers"]), read_count(node["restarts"]), options);
}

CalibrationPrior read_calibration(const YAML::Node& node, CalibrationPrior prior) {
  if (!node.IsDefined()) return prior;
  prior.scale = finite_number(node["scale"], "calibration: scale");
  prior.bias = finite_number(node["bias"], "calibration: bias");
  prior.turn = finite_number(node["turn"], "calibration: turn");
  prior.information = matrix<3, 3>(node["information"], "calibration: information");
  require(prior.scale > 0.0, "calibration: scale must be above 0");
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(prior.information);
  require(solver.eigenvalues().minCoeff() > 0.0, "calibration: information is not positive");
  return prior;
}

double read_at_least(double least, const YAML::Node& root, const std::string& name,
                     double otherwise) {
  if (!root[name].IsDefined()) return otherwise;
  const double value = finite_number(root[name], name);
  require(value >= least, name + " must be at least " + format_double(least));
  return value;
}

BeaconMapper read_map(const std::string& text, const BeaconOptions& options) {
  std::map<BeaconId, BeaconTrack> tracks;
  const auto take = [&](const YAML::Node& head, const YAML::Node& node) {
    check_version(head, kVersion, "beacons");
    require(node.IsMap() && node["id"].IsDefined(), "a beacon has no id");
    const auto id = node["id"].as<BeaconId>();
    const std::string name = "beacon " + std::to_string(id);
    require(tracks.emplace(id, read_track(node, name, options)).second, name + " is there twice");
  };
  const YAML::Node root = read_items(text, "beacons", take);
  check_version(root, kVersion, "beacons");
  require(root["beacons"].IsDefined() && root["beacons"].IsSequence(), "beacons is missing");
  const BeaconMapper fresh(options);
  const CalibrationPrior prior = read_calibration(root["calibration"], fresh.knowledge());
  return BeaconMapper::restored(options, prior, read_at_least(0.0, root, "drift", fresh.drift()),
                                read_at_least(1.0, root, "noise", fresh.noise()),
                                std::move(tracks));
}

}  // namespace

std::string to_yaml(const BeaconMapper& mapper) {
  const CalibrationPrior known = mapper.knowledge();
  std::string text =
      "version: " + std::to_string(kVersion) + "\ndrift: " + format_double(mapper.drift()) +
      "\nnoise: " + format_double(mapper.noise()) +
      "\ncalibration:\n  scale: " + format_double(known.scale) +
      "\n  bias: " + format_double(known.bias) + "\n  turn: " + format_double(known.turn) +
      "\n  information: " + listed(known.information) + "\nbeacons:";
  const std::vector<BeaconEstimate> beacons = mapper.estimates();
  text += beacons.empty() ? " []\n" : "\n";
  for (const BeaconEstimate& beacon : beacons) text += shown(beacon);
  return text;
}

BeaconMapper beacons_from_yaml(const std::string& text, const BeaconOptions& options) {
  try {
    return read_map(text, options);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace portolan
