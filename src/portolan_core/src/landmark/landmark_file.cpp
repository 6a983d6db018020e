// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/landmark_file.hpp"

#include <yaml-cpp/yaml.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
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

std::string shown_ray(const Place& ray) {
  return "    ray:\n      coordinates: " + listed(ray.mean) +
         "\n      covariance: " + listed(ray.covariance) +
         "\n      origin: " + listed(ray.T_map_ray.translation()) +
         "\n      axes: " + listed(ray.T_map_ray.linear()) + "\n";
}

/// The height of a flat landmark is not known; what is assumed of it is kept beside the map's z.
std::string shown_height(const LandmarkEstimate& landmark) {
  return "    height: {mean: " + format_double(landmark.place.mean.z()) +
         ", covariance: " + listed(landmark.place.covariance.col(2)) + "}\n";
}

std::string shown(const LandmarkEstimate& landmark, const LandmarkTrack& track) {
  const auto form = static_cast<std::size_t>(landmark.form);
  const bool is_ray = landmark.place.form == PlaceForm::ray;
  std::string text = "  - id: " + std::to_string(landmark.id) +
                     "\n    mean: " + listed(landmark.mean) +
                     "\n    covariance: " + listed(landmark.covariance) +
                     "\n    sightings: " + std::to_string(landmark.sightings) +
                     "\n    existence: " + format_double(landmark.existence) +
                     "\n    evidence: " + format_double(track.log_odds()) +
                     "\n    kind: " + enum_names(landmark.form).at(form) + "\n";
  if (!track.has_height()) text += "    flat: true\n";
  if (is_ray) return text + shown_ray(landmark.place);
  const Eigen::Matrix3d& independent = landmark.place.covariance;
  if (landmark.covariance(2, 2) == 0.0 && independent(2, 2) != 0.0) text += shown_height(landmark);
  if (landmark.covariance(0, 0) != independent(0, 0))
    text += "    independent: " + listed(independent) + "\n";
  return text;
}

void read_ray(const YAML::Node& node, const std::string& name, Place& place) {
  place.form = PlaceForm::ray;
  place.mean = matrix<3, 1>(node["coordinates"], name + ": ray: coordinates");
  place.covariance = covariance(node["covariance"], name + ": ray: covariance");
  place.T_map_ray.translation() = matrix<3, 1>(node["origin"], name + ": ray: origin");
  place.T_map_ray.linear() = matrix<3, 3>(node["axes"], name + ": ray: axes");
  require(is_valid(place.T_map_ray), name + ": ray: axes are no rotation");
}

void read_height(const YAML::Node& node, const std::string& name, Place& place) {
  place.mean.z() = finite_number(node["mean"], name + ": height: mean");
  const Eigen::Vector3d column = matrix<3, 1>(node["covariance"], name + ": height: covariance");
  place.covariance.col(2) = column;
  place.covariance.row(2) = column.transpose();
}

double read_evidence(const YAML::Node& node) {
  if (node["evidence"].IsDefined()) return finite_number(node["evidence"], "evidence");
  if (!node["existence"].IsDefined()) return 0.0;
  const double existence = finite_number(node["existence"], "existence");
  require(existence > 0.0 && existence <= 1.0, "existence must be in (0, 1]");
  constexpr double kSurest = 1.0 - 1e-12;
  return std::log(std::min(existence, kSurest) / (1.0 - std::min(existence, kSurest)));
}

LandmarkTrack read_track(const YAML::Node& node, const std::string& name) {
  Place place;
  place.mean = matrix<3, 1>(node["mean"], name + ": mean");
  place.covariance = covariance(node["covariance"], name + ": covariance");
  if (node["height"].IsDefined()) read_height(node["height"], name, place);
  if (node["independent"].IsDefined())
    place.covariance = covariance(node["independent"], name + ": independent");
  if (node["ray"].IsDefined()) read_ray(node["ray"], name, place);
  const YAML::Node sightings = node["sightings"];
  const YAML::Node flat = node["flat"];
  return {place, sightings.IsDefined() ? sightings.as<std::size_t>() : 1, read_evidence(node),
          !(flat.IsDefined() && flat.as<bool>())};
}

LandmarkMapper read_map(const std::string& text, const LandmarkOptions& options) {
  std::set<LandmarkId> ids;
  std::vector<std::pair<LandmarkId, LandmarkTrack>> tracks;
  const auto take = [&](const YAML::Node& head, const YAML::Node& node) {
    check_version(head, kVersion, "landmarks");
    require(node.IsMap() && node["id"].IsDefined(), "a landmark has no id");
    const auto id = node["id"].as<LandmarkId>();
    const std::string name = "landmark " + std::to_string(id);
    require(id != LandmarkSighting::kUnknown, name + ": -1 says unknown");
    require(ids.insert(id).second, name + " is there twice");
    tracks.emplace_back(id, read_track(node, name));
  };
  const YAML::Node root = read_items(text, "landmarks", take);
  check_version(root, kVersion, "landmarks");
  require(root["landmarks"].IsDefined() && root["landmarks"].IsSequence(), "landmarks is missing");
  return LandmarkMapper::restored(options, tracks);
}

}  // namespace

std::string to_yaml(const LandmarkMapper& mapper) {
  std::string text = "version: " + std::to_string(kVersion) + "\nlandmarks:";
  const std::vector<LandmarkEstimate> landmarks = mapper.estimates();
  text += landmarks.empty() ? " []\n" : "\n";
  for (const LandmarkEstimate& landmark : landmarks)
    text += shown(landmark, mapper.store().at(landmark.id).track);
  return text;
}

LandmarkMapper landmarks_from_yaml(const std::string& text, const LandmarkOptions& options) {
  try {
    return read_map(text, options);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace portolan
