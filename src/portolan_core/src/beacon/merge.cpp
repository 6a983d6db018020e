// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/merge.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace portolan {

namespace {

constexpr double kCrowdsShare = 0.6;  // of the distance: neighbours in a ring must stay thin
constexpr double kLinearTimes = 2.5;  // of it: where distances bend less than by `kBend` of their
constexpr double kBend = 0.15;        // deviations, one Gaussian does for two
constexpr std::size_t kFew = 10;      // so few: all pairs each time
constexpr std::size_t kCrowded = 60;  // up to here: all pairs every few turns
constexpr std::size_t kTurns = 8;

double squared_distance(const Eigen::Vector3d& step, const Eigen::Matrix3d& spread) {
  constexpr double kFlat = 1e-12;  // [m^2]; a planar place has no extent in z
  return step.dot((spread + kFlat * Eigen::Matrix3d::Identity()).llt().solve(step));
}

struct Pair {
  Eigen::Vector3d x;
  Eigen::Matrix3d Q;
};

// Mean and covariance of the pair.
Pair paired(const Hypothesis& a, const Hypothesis& b) {
  const double share = a.weight / (a.weight + b.weight);
  const Eigen::Vector3d step = b.x - a.x;
  return {a.x + (1.0 - share) * step,
          share * a.Q + (1.0 - share) * b.Q + share * (1.0 - share) * step * step.transpose()};
}

// Whether the distance from the antenna stays all but linear within the pair: a Gaussian of
// variance t^2 across a sphere of radius r bends away from it by t^2 / (2 r).
bool is_linear(const Pair& pair, const PosedRange& z) {
  const Eigen::Vector3d v = pair.x - z.p_map;
  const double squared = v.squaredNorm();
  const double along = v.dot(pair.Q * v) / squared;
  const double bend = 0.5 * (pair.Q.trace() - along) / std::sqrt(squared);
  return bend * bend < kBend * kBend * (along + z.stddev * z.stddev);
}

bool are_close(const Hypothesis& a, const Hypothesis& b, double distance) {
  if (a.is_polar != b.is_polar) return false;
  // No direction is wider than the trace, which is cheap: most pairs end here.
  const double widest = a.Q.trace() + b.Q.trace();
  if ((a.x - b.x).squaredNorm() > distance * distance * widest) return false;
  return squared_distance(a.x - b.x, a.Q + b.Q) < distance * distance;
}

bool are_one(const Hypothesis& a, const Hypothesis& b, double distance, const PosedRange& z) {
  if (!are_close(a, b, kLinearTimes * distance)) return false;
  return are_close(a, b, distance) || (!a.is_polar && is_linear(paired(a, b), z));
}

// The pair, with what the heavier one knows of the calibration.
void absorb(Hypothesis& a, const Hypothesis& b) {
  const double weight = a.weight + b.weight;
  const double share = a.weight / weight;
  const Pair pair = paired(a, b);
  a.x = pair.x;
  a.Q = pair.Q;
  a.G = share * a.G + (1.0 - share) * b.G;
  if (share < 0.5) a.calibration = b.calibration;
  a.weight = weight;
  a.log_weight = std::log(weight);
}

void merge_neighbours(double distance, std::vector<Hypothesis>& hypotheses) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < hypotheses.size(); ++i) {
    if (are_close(hypotheses[kept], hypotheses[i], distance)) {
      absorb(hypotheses[kept], hypotheses[i]);
    } else if (++kept != i) {
      hypotheses[kept] = hypotheses[i];
    }
  }
  hypotheses.resize(kept + 1);
}

void merge_all(double distance, const PosedRange& z, std::vector<Hypothesis>& hypotheses) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    std::size_t kept = i + 1;
    for (std::size_t j = i + 1; j < hypotheses.size(); ++j) {
      if (are_one(hypotheses[i], hypotheses[j], distance, z)) {
        absorb(hypotheses[i], hypotheses[j]);
      } else {
        if (kept != j) hypotheses[kept] = hypotheses[j];
        ++kept;
      }
    }
    hypotheses.resize(kept);
  }
}

}  // namespace

double mahalanobis_distance(const Hypothesis& a, const Hypothesis& b,
                            const RangeCalibration& calibration) {
  const Eigen::Vector3d step = a.mean(calibration) - b.mean(calibration);
  return std::sqrt(squared_distance(step, a.covariance(calibration) + b.covariance(calibration)));
}

void merge_close(double distance, std::size_t turn, const PosedRange& z,
                 std::vector<Hypothesis>& hypotheses) {
  if (hypotheses.size() < 2 || distance == 0.0) return;
  merge_neighbours(kCrowdsShare * distance, hypotheses);
  const std::size_t size = hypotheses.size();
  if (size <= kFew || (size <= kCrowded && turn % kTurns == 0)) {
    merge_all(distance, z, hypotheses);
  }
}

}  // namespace portolan
