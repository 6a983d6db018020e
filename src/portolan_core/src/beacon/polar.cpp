// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/polar.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace portolan {

namespace {

constexpr double kLinearTo = 0.2;     // share of the range's deviation that may be curvature
constexpr double kStraightTo = 0.15;  // share of a mode's thickness that may be its bend
constexpr int kAzimuth = 1;
constexpr int kElevation = 2;

constexpr double kSpacing = 1.7;       // of the parts of a split, in their deviations
constexpr double kSplitAtLeast = 0.7;  // deviation of the parts, of the whole's
constexpr double kReach = 3.5;         // deviations of the whole that the parts cover

// The lower triangular root of a covariance that may be flat in some directions.
Eigen::Matrix3d root(const Eigen::Matrix3d& Q) {
  Eigen::Matrix3d L = Eigen::Matrix3d::Zero();
  for (int j = 0; j < 3; ++j) {
    const double rest = Q(j, j) - L.row(j).head(j).squaredNorm();
    if (rest <= 1e-15 * Q(j, j)) continue;
    L(j, j) = std::sqrt(rest);
    for (int i = j + 1; i < 3; ++i) {
      L(i, j) = (Q(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
    }
  }
  return L;
}

double distance_to(const Eigen::Vector3d& polar, const Eigen::Vector3d& origin,
                   const Eigen::Vector3d& p_map) {
  return (from_polar(polar, origin) - p_map).norm();
}

// How far the distance bends away from its tangent a deviation along one angle [m].
double curvature(const Eigen::Vector3d& mean, const Eigen::Matrix3d& Q, int angle,
                 const Eigen::Vector3d& origin, const Eigen::Vector3d& p_map) {
  if (Q(angle, angle) == 0.0) return 0.0;
  const Eigen::Vector3d step = Q.col(angle) / std::sqrt(Q(angle, angle));
  const double center = distance_to(mean, origin, p_map);
  return std::abs(distance_to(mean + step, origin, p_map) +
                  distance_to(mean - step, origin, p_map) - 2.0 * center) /
         2.0;
}

// The part of a Gaussian that stands `offset` deviations along one angle and is `narrow` times as
// wide there as the whole.
Hypothesis part_of(const Hypothesis& whole, int angle, double offset, double narrow) {
  const Eigen::Vector3d step = whole.Q.col(angle) / std::sqrt(whole.Q(angle, angle));
  Hypothesis h = whole;
  h.x += offset * step;
  h.Q -= (1.0 - narrow * narrow) * step * step.transpose();
  return h;
}

// Replaces hypothesis i by a row of narrower ones along an angle; false where that would be more
// than `max_modes`. N(0, 1) is the sum of N(offset, narrow^2) weighted by N(offset; 0, 1 -
// narrow^2).
bool split(std::size_t i, int angle, double narrow, std::size_t max_modes,
           std::vector<Hypothesis>& hypotheses) {
  narrow = std::min(narrow, kSplitAtLeast);
  const int side = static_cast<int>(std::ceil(kReach / (kSpacing * narrow)));
  if (hypotheses.size() + 2 * static_cast<std::size_t>(side) > max_modes) return false;
  const auto share = [&](int k) {
    const double offset = k * kSpacing * narrow;
    return std::exp(-0.5 * offset * offset / (1.0 - narrow * narrow));
  };
  double total = 0.0;
  for (int k = -side; k <= side; ++k) total += share(k);
  const Hypothesis whole = hypotheses[i];
  for (int k = -side; k <= side; ++k) {
    Hypothesis part = part_of(whole, angle, k * kSpacing * narrow, narrow);
    part.weight *= share(k) / total;
    part.log_weight += std::log(share(k) / total);
    if (k == -side) {
      hypotheses[i] = part;
    } else {
      hypotheses.push_back(part);
    }
  }
  return true;
}

// The angle along which to split first, and by how much a deviation of it bends the place off its
// tangent [m].
struct Bend {
  int angle;
  double size;
};

Bend bend_of(const Eigen::Vector3d& polar, const Eigen::Matrix3d& Q) {
  const double level = polar[0] * std::cos(polar[2]);  // radius of the circle of azimuth
  const double azimuth = 0.5 * level * Q(kAzimuth, kAzimuth);
  const double elevation = 0.5 * polar[0] * Q(kElevation, kElevation);
  return azimuth >= elevation ? Bend{kAzimuth, azimuth} : Bend{kElevation, elevation};
}

bool is_straight(const Hypothesis& h, const RangeCalibration& c) {
  return bend_of(h.mean(c), h.Q).size <= kStraightTo * std::sqrt(h.Q(0, 0));
}

Hypothesis straightened(const Hypothesis& polar, const Eigen::Vector3d& origin,
                        const RangeCalibration& c) {
  Hypothesis h = polar;
  const Eigen::Vector3d mean = polar.mean(c);
  const Eigen::Matrix3d J = polar_jacobian(mean);
  h.is_polar = false;
  h.Q = J * polar.Q * J.transpose();
  h.G = J * polar.G;
  h.x = from_polar(mean, origin) - h.G * c.deviation;
  return h;
}

}  // namespace

Eigen::Vector3d from_polar(const Eigen::Vector3d& polar, const Eigen::Vector3d& origin) {
  const double level = polar[0] * std::cos(polar[2]);
  return origin + Eigen::Vector3d(level * std::cos(polar[1]), level * std::sin(polar[1]),
                                  polar[0] * std::sin(polar[2]));
}

Eigen::Matrix3d polar_jacobian(const Eigen::Vector3d& polar) {
  const double sin_a = std::sin(polar[1]);
  const double cos_a = std::cos(polar[1]);
  const double sin_e = std::sin(polar[2]);
  const double cos_e = std::cos(polar[2]);
  const double r = polar[0];
  Eigen::Matrix3d J;
  J << cos_e * cos_a, -r * cos_e * sin_a, -r * sin_e * cos_a,  //
      cos_e * sin_a, r * cos_e * cos_a, -r * sin_e * sin_a,    //
      sin_e, 0.0, r * cos_e;
  return J;
}

DistancePrediction predict_distance_polar(const Eigen::Vector3d& mean, const Eigen::Matrix3d& Q,
                                          const Eigen::Vector3d& origin,
                                          const Eigen::Vector3d& p_map) {
  const Eigen::Matrix3d steps = std::sqrt(3.0) * root(Q);
  std::array<double, 6> distances;
  DistancePrediction prediction;
  for (int i = 0; i < 6; ++i) {
    const double sign = i < 3 ? 1.0 : -1.0;
    distances[static_cast<std::size_t>(i)] =
        distance_to(mean + sign * steps.col(i % 3), origin, p_map);
    prediction.mean += distances[static_cast<std::size_t>(i)] / 6.0;
  }
  for (int i = 0; i < 6; ++i) {
    const double sign = i < 3 ? 1.0 : -1.0;
    const double off = distances[static_cast<std::size_t>(i)] - prediction.mean;
    prediction.variance += off * off / 6.0;
    prediction.cross += sign * off / 6.0 * steps.col(i % 3);
  }
  const Eigen::Vector3d v = from_polar(mean, origin) - p_map;
  prediction.H = v.transpose() / std::max(v.norm(), 1e-9) * polar_jacobian(mean);
  return prediction;
}

void split_polar(const Eigen::Vector3d& p_map, double stddev, const Eigen::Vector3d& origin,
                 const RangeCalibration& c, std::size_t max_modes,
                 std::vector<Hypothesis>& hypotheses) {
  for (std::size_t i = 0; i < hypotheses.size();) {
    const Eigen::Vector3d mean = hypotheses[i].mean(c);
    const Eigen::Matrix3d& Q = hypotheses[i].Q;
    const bool polar = hypotheses[i].is_polar;
    const double azimuth = polar ? curvature(mean, Q, kAzimuth, origin, p_map) : 0.0;
    const double elevation = polar ? curvature(mean, Q, kElevation, origin, p_map) : 0.0;
    const double most = std::max(azimuth, elevation);
    const int angle = azimuth >= elevation ? kAzimuth : kElevation;
    const double limit = kLinearTo * stddev;
    if (most <= limit || !split(i, angle, std::sqrt(limit / most), max_modes, hypotheses)) ++i;
  }
}

void straighten_polar(const Eigen::Vector3d& origin, const RangeCalibration& c,
                      std::vector<Hypothesis>& hypotheses) {
  for (Hypothesis& h : hypotheses) {
    if (h.is_polar && is_straight(h, c)) h = straightened(h, origin, c);
  }
}

void append_straightened(const Hypothesis& polar, const Eigen::Vector3d& origin,
                         const RangeCalibration& c, std::vector<Hypothesis>& straight) {
  constexpr std::size_t kEnough = 2000;
  std::vector<Hypothesis> parts{polar};
  for (std::size_t i = 0; i < parts.size();) {
    const Bend bend = bend_of(parts[i].mean(c), parts[i].Q);
    const double narrow = std::sqrt(kStraightTo * std::sqrt(parts[i].Q(0, 0)) / bend.size);
    if (is_straight(parts[i], c) || !split(i, bend.angle, narrow, kEnough, parts)) {
      straight.push_back(straightened(parts[i++], origin, c));
    }
  }
}

}  // namespace portolan
