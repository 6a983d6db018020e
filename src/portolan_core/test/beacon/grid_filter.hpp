// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <vector>

#include "portolan/beacon/beacon_estimate.hpp"

namespace portolan::beacon_test {

/// Bayes' rule for one beacon on a grid over the plane or a cube, straight from Eq. 36: exact up to
/// its cells, and slow.
template <int Dimensions>
class GridFilter {
 public:
  using Point = Eigen::Matrix<double, Dimensions, 1>;

  GridFilter(double half_width, double cell)
      : side_(static_cast<std::size_t>(2.0 * half_width / cell)),
        cell_(cell),
        half_width_(half_width),
        p_(power(side_), 1.0) {}

  void update(const Point& antenna, double range, double stddev) {
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
    const double volume = power(cell_);
    double sum = 0.0;
    for (std::size_t i = 0; i < p_.size(); ++i) {
      sum += std::abs(p_[i] - density(mixture, center(i)) * volume);
    }
    return 0.5 * sum;
  }

 private:
  using Matrix = Eigen::Matrix<double, Dimensions, Dimensions>;

  template <class Number>
  static Number power(Number base) {
    Number product = 1;
    for (int d = 0; d < Dimensions; ++d) product *= base;
    return product;
  }

  Point center(std::size_t i) const {
    Point center;
    for (int d = 0; d < Dimensions; ++d, i /= side_) {
      center[d] = (static_cast<double>(i % side_) + 0.5) * cell_ - half_width_;
    }
    return center;
  }

  struct Gaussian {
    Point mean;
    Matrix information;
    double peak;
    double reach;  // ten deviations and more [m]
  };

  static std::vector<Gaussian> gaussians(const std::vector<BeaconMode>& modes) {
    std::vector<Gaussian> all;
    all.reserve(modes.size());
    for (const BeaconMode& mode : modes) {
      const Matrix P = mode.covariance.topLeftCorner<Dimensions, Dimensions>();
      all.push_back({mode.mean.head<Dimensions>(), P.inverse(),
                     mode.weight / std::sqrt(power(2.0 * M_PI) * P.determinant()),
                     10.0 * std::sqrt(P.trace())});
    }
    return all;
  }

  static double density(const std::vector<Gaussian>& modes, const Point& p) {
    double sum = 0.0;
    for (const Gaussian& mode : modes) {
      const Point step = p - mode.mean;
      if (step.squaredNorm() > mode.reach * mode.reach) continue;
      sum += mode.peak * std::exp(-0.5 * step.dot(mode.information * step));
    }
    return sum;
  }

  std::size_t side_;  // in cells
  double cell_;
  double half_width_;
  std::vector<double> p_;
};

}  // namespace portolan::beacon_test
