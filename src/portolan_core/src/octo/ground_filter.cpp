// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/ground_filter.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace portolan {

namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr std::size_t kTrials = 200;
constexpr std::size_t kSample = 2000;      // points that vote on a trial
constexpr std::size_t kFewestPoints = 10;  // in a plane

/// The points that could lie in an allowed plane, in the base's frame.
Points candidates(const PointCloud& cloud, const Pose& T_base_sensor, const GroundFilter& filter) {
  Points points;
  for (const Eigen::Vector3f& p_sensor : cloud.points) {
    if (!p_sensor.allFinite()) continue;
    const Eigen::Vector3d p = T_base_sensor * p_sensor.cast<double>();
    const double reach = std::tan(filter.angle) * p.head<2>().norm() +
                         filter.plane_distance / std::cos(filter.angle) + filter.distance;
    if (std::abs(p.z()) <= reach) points.push_back(p);
  }
  return points;
}

bool is_allowed(const Plane& plane, const GroundFilter& filter) {
  return plane.normal.z() >= std::cos(filter.angle) &&
         std::abs(plane.offset) <= filter.plane_distance;
}

Plane facing_up(const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
  const Eigen::Vector3d up = normal.z() < 0.0 ? Eigen::Vector3d(-normal) : normal;
  return {up, -up.dot(p)};
}

std::optional<Plane> through(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  if (normal.norm() < 1e-9) return std::nullopt;
  return facing_up(normal.normalized(), a);
}

std::size_t count_near(const Points& points, const Plane& plane, double distance) {
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(),
      [&](const Eigen::Vector3d& p) { return std::abs(plane.height(p)) <= distance; }));
}

/// At most `kSample` of the points, evenly.
Points sample(const Points& points) {
  const std::size_t stride = points.size() / kSample + 1;
  Points some;
  for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
  return some;
}

std::optional<Plane> best_of_trials(const Points& points, const GroundFilter& filter) {
  const Points voters = sample(points);
  std::mt19937 random(1);  // the same cloud has the same ground
  std::optional<Plane> best;
  std::size_t most = 0;
  for (std::size_t i = 0; i < kTrials; ++i) {
    const auto pick = [&] { return points[random() % points.size()]; };
    const Eigen::Vector3d a = pick();
    const Eigen::Vector3d b = pick();
    const std::optional<Plane> plane = through(a, b, pick());
    if (!plane || !is_allowed(*plane, filter)) continue;
    const std::size_t votes = count_near(voters, *plane, filter.distance);
    if (votes > most) best = plane;
    most = std::max(most, votes);
  }
  return best;
}

/// The plane that fits the points near a first guess best.
Plane refined(const Points& points, const Plane& guess, double distance) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double count = 0.0;
  for (const Eigen::Vector3d& p : points) {
    if (std::abs(guess.height(p)) > distance) continue;
    mean += p;
    squares += p * p.transpose();
    count += 1.0;
  }
  if (count < 3.0) return guess;
  mean /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares / count -
                                                              mean * mean.transpose());
  return facing_up(solver.eigenvectors().col(0), mean);
}

}  // namespace

std::optional<Plane> find_ground(const PointCloud& cloud, const Pose& T_base_sensor,
                                 const GroundFilter& filter) {
  const Points points = candidates(cloud, T_base_sensor, filter);
  if (points.size() < kFewestPoints) return std::nullopt;
  std::optional<Plane> ground = best_of_trials(points, filter);
  if (!ground) return std::nullopt;
  const Plane better = refined(points, *ground, filter.distance);
  if (is_allowed(better, filter)) ground = better;
  const std::size_t fewest = std::max(kFewestPoints, cloud.points.size() / 100);
  if (count_near(points, *ground, filter.distance) < fewest) return std::nullopt;
  return ground;
}

GroundedCloud split_ground(const PointCloud& cloud, const Pose& T_base_sensor,
                           const GroundFilter& filter) {
  const Plane ground = find_ground(cloud, T_base_sensor, filter).value_or(Plane{});
  GroundedCloud split;
  split.obstacles.no_returns = cloud.no_returns;
  for (const Eigen::Vector3f& p : cloud.points) {
    const double height = ground.height(T_base_sensor * p.cast<double>());
    auto& part = std::abs(height) <= filter.distance ? split.ground : split.obstacles.points;
    part.push_back(p);
  }
  return split;
}

}  // namespace portolan
