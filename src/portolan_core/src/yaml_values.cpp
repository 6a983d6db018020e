// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/yaml_values.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace portolan::yaml_values {

void check_version(const YAML::Node& head, int version, const std::string& things) {
  require(head.IsMap() && head["version"].IsDefined(), "no version: not a map of " + things);
  require(head["version"].as<int>() == version, "version must be " + std::to_string(version));
}

double finite_number(const YAML::Node& node, const std::string& name) {
  require(node.IsDefined() && node.IsScalar(), name + " is missing");
  const auto value = node.as<double>();
  require(std::isfinite(value), name + " is not finite");
  return value;
}

Eigen::Matrix3d covariance(const YAML::Node& node, const std::string& name) {
  const Eigen::Matrix3d read = matrix<3, 3>(node, name);
  const double size = read.norm();
  require((read - read.transpose()).norm() <= 1e-9 * size, name + " is not symmetric");
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(read, Eigen::EigenvaluesOnly);
  require(solver.eigenvalues().minCoeff() >= -1e-9 * size, name + " has negative eigenvalues");
  return read;
}

}  // namespace portolan::yaml_values
