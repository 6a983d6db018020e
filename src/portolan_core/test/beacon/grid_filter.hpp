// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "portolan/beacon/beacon_estimate.hpp"

namespace portolan::beacon_test {

/// Bayes' rule for one beacon on a grid over the plane, straight from Eq. 36: exact up to its
/// cells, and slow.
class GridFilter {
 public:
  GridFilter(double half_width, double cell)
      : cells_(static_cast<int>(2.0 * half_width / cell)),
        cell_(cell),
        half_width_(half_width),
        p_(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_), 1.0) {}

  void update(const Eigen::Vector2d& antenna, double range, double stddev) {
    double total = 0.0;
    for (std::size_t i = 0; i < p_.size(); ++i) {
      const double u = ((center(i) - antenna).norm() - range) / stddev;
      p_[i] *= std::exp(-0.5 * u * u);
      total += p_[i];
    }
    for (double& p : p_) p /= total;
  }

  /// Half the integral of the difference to a sum of Gaussians, in [0, 1].
  double total_variation(const std::vector<BeaconMode>& modes) const {
    const std::vector<Gaussian> mixture = gaussians(modes);
    double sum = 0.0;
    for (std::size_t i = 0; i < p_.size(); ++i) {
      sum += std::abs(p_[i] - density(mixture, center(i)) * cell_ * cell_);
    }
    return 0.5 * sum;
  }

 private:
  Eigen::Vector2d center(std::size_t i) const {
    const int row = static_cast<int>(i) / cells_;
    const int column = static_cast<int>(i) % cells_;
    return Eigen::Vector2d(column + 0.5, row + 0.5) * cell_ -
           Eigen::Vector2d::Constant(half_width_);
  }

  struct Gaussian {
    Eigen::Vector2d mean;
    Eigen::Matrix2d information;
    double peak;
    double reach;  // ten deviations and more [m]
  };

  static std::vector<Gaussian> gaussians(const std::vector<BeaconMode>& modes) {
    std::vector<Gaussian> all;
    for (const BeaconMode& mode : modes) {
      const Eigen::Matrix2d P = mode.covariance.topLeftCorner<2, 2>();
      all.push_back({mode.mean.head<2>(), P.inverse(),
                     mode.weight / (2.0 * M_PI * std::sqrt(P.determinant())),
                     10.0 * std::sqrt(P.trace())});
    }
    return all;
  }

  static double density(const std::vector<Gaussian>& modes, const Eigen::Vector2d& p) {
    double sum = 0.0;
    for (const Gaussian& mode : modes) {
      const Eigen::Vector2d step = p - mode.mean;
      if (step.squaredNorm() > mode.reach * mode.reach) continue;
      sum += mode.peak * std::exp(-0.5 * step.dot(mode.information * step));
    }
    return sum;
  }

  int cells_;
  double cell_;
  double half_width_;
  std::vector<double> p_;
};

}  // namespace portolan::beacon_test
