// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "portolan/grid/grid_mapper.hpp"

namespace portolan {

/// Random options, poses and observations for grid maps, odd ones among them; a sensor reaches some
/// 60 cells, whatever their size.
class RandomObservations {
 public:
  explicit RandomObservations(std::uint32_t seed) : random_(seed) {}

  GridOptions options() {
    GridOptions o;
    o.resolution = std::pow(10.0, uniform(-3.0, 1.0));
    o.prior = chance(0.5) ? 0.5 : uniform(0.3, 0.6);
    o.quantum = uniform(0.04, 0.3);
    o.p_min = uniform(0.01, 0.19);
    o.p_max = uniform(0.66, 0.99);
    o.fusion = static_cast<Fusion>(below(3));
    o.max_extent = 1e4 * o.resolution;
    for (InverseSensorModel* model :
         {static_cast<InverseSensorModel*>(&o.laser), static_cast<InverseSensorModel*>(&o.sonar),
          static_cast<InverseSensorModel*>(&o.cloud)}) {
      model->p_occupied = uniform(0.7, 0.95);
      model->p_free = uniform(0.05, 0.2);
      model->max_range = uniform(5.0, 60.0) * o.resolution;
      model->no_return = chance(0.5) ? NoReturn::clear : NoReturn::ignore;
    }
    o.laser.beam_model = chance(0.7) ? BeamModel::sector : BeamModel::ray;
    o.laser.margin = chance(0.5) ? 0.0 : uniform(0.0, 3.0) * o.resolution;
    o.sonar.margin = uniform(0.0, 3.0) * o.resolution;
    o.cloud.min_z = uniform(-10.0, 5.0) * o.resolution;
    o.cloud.max_z = o.cloud.min_z + uniform(1.0, 30.0) * o.resolution;
    return o;
  }

  /// A pose near the origin: on a round place and heading, planar, or tilted.
  Pose pose(const GridOptions& o) {
    if (chance(0.3)) {
      return planar_pose(0.5 * static_cast<double>(below(9)) * o.resolution,
                         -0.25 * static_cast<double>(below(9)) * o.resolution,
                         M_PI / 4.0 * static_cast<double>(below(8)));
    }
    Pose T = planar_pose(uniform(-90.0, 90.0) * o.resolution, uniform(-90.0, 90.0) * o.resolution,
                         uniform(-3.2, 3.2));
    T.translation().z() = uniform(-5.0, 20.0) * o.resolution;
    if (chance(0.3)) T.rotate(Eigen::AngleAxisd(uniform(-0.1, 0.1), Eigen::Vector3d::UnitY()));
    if (chance(0.2)) T.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
    return T;
  }

  GridMapper::Observation observation(const GridOptions& o) {
    switch (below(4)) {
      case 0:
        return echo(o);
      case 1:
        return cloud(o);
      default:
        return scan(o);
    }
  }

  RangeScan scan(const GridOptions& o) {
    RangeScan scan;
    const std::size_t beams = 1 + below(chance(0.5) ? 200 : 12);
    scan.angle_min = uniform(-3.2, 3.2);
    scan.angle_increment = step(beams);
    scan.range_min = chance(0.5) ? 0.0 : o.resolution;
    scan.range_max = uniform(20.0, 70.0) * o.resolution;
    double range = uniform(1.0, 60.0);
    for (std::size_t i = 0; i < beams; ++i) {
      if (chance(0.1)) range = uniform(0.0, 60.0);
      range = std::abs(range + uniform(-1.0, 1.0));
      scan.ranges.push_back(chance(0.1) ? odd() : static_cast<float>(range * o.resolution));
    }
    if (chance(0.3)) {
      scan.T_first_last = planar_pose(uniform(-4.0, 4.0) * o.resolution,
                                      uniform(-4.0, 4.0) * o.resolution, uniform(-0.5, 0.5));
    }
    return scan;
  }

  RangeEcho echo(const GridOptions& o) {
    const double aperture = chance(0.2)   ? 2.0 * M_PI
                            : chance(0.5) ? uniform(0.05, 1.0)
                                          : uniform(0.05, 6.28);
    return {chance(0.1) ? static_cast<double>(odd()) : uniform(0.0, 50.0) * o.resolution, 0.0,
            45.0 * o.resolution, aperture};
  }

  PointCloud cloud(const GridOptions& o) {
    PointCloud cloud;
    for (std::size_t i = 1 + below(60); i > 0; --i) {
      cloud.points.emplace_back((direction() * uniform(0.0, 60.0) * o.resolution).cast<float>());
      if (chance(0.05)) cloud.points.back().x() = odd();
    }
    for (std::size_t i = below(30); i > 0; --i) {
      cloud.no_returns.emplace_back(direction().cast<float>());
    }
    return cloud;
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

 private:
  // Full circles, with the last beam beside or upon the first one, overlapping ones, and others.
  double step(std::size_t beams) {
    const double n = static_cast<double>(beams);
    const double sign = chance(0.3) ? -1.0 : 1.0;
    switch (below(5)) {
      case 0:
        return sign * 2.0 * M_PI / n;
      case 1:
        return sign * 2.0 * M_PI / std::max(1.0, n - 1.0);
      case 2:
        return sign * uniform(6.5, 9.0) / n;
      case 3:
        return sign * M_PI / 180.0;
      default:
        return sign * uniform(0.001, std::min(2.0, 60.0 / n));
    }
  }

  Eigen::Vector3d direction() {
    return Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-0.3, 0.3)).normalized();
  }

  float odd() {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    constexpr float kOdd[] = {kInf, -kInf, std::numeric_limits<float>::quiet_NaN(),
                              0.0F, -1.0F, 1e30F};
    return kOdd[below(6)];
  }

  std::mt19937 random_;
};

}  // namespace portolan
