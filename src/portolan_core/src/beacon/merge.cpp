// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/merge.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace portolan {

namespace {

constexpr double kCrowdsShare = 0.6;  // of the distance: neighbours in a ring must stay thin
constexpr std::size_t kFew = 10;      // so few: all pairs each time
constexpr std::size_t kCrowded = 60;  // up to here: all pairs every few turns
constexpr std::size_t kTurns = 8;

double squared_distance(const Eigen::Vector3d& step, const Eigen::Matrix3d& spread) {
  constexpr double kFlat = 1e-12;  // [m^2]; a planar place has no extent in z
  return step.dot((spread + kFlat * Eigen::Matrix3d::Identity()).llt().solve(step));
}

bool are_close(const Hypothesis& a, const Hypothesis& b, double squared) {
  if (a.is_polar != b.is_polar) return false;
  // No direction is wider than the trace, which is cheap: most pairs end here.
  const double widest = a.Q.trace() + b.Q.trace();
  if ((a.x - b.x).squaredNorm() > squared * widest) return false;
  return squared_distance(a.x - b.x, a.Q + b.Q) < squared;
}

// Weight, mean and covariance of the pair; what the heavier one knows of the calibration.
void absorb(Hypothesis& a, const Hypothesis& b) {
  const double weight = a.weight + b.weight;
  const double share = a.weight / weight;
  const Eigen::Vector3d step = b.x - a.x;
  a.Q = share * a.Q + (1.0 - share) * b.Q + share * (1.0 - share) * step * step.transpose();
  a.x += (1.0 - share) * step;
  a.G = share * a.G + (1.0 - share) * b.G;
  if (share < 0.5) a.calibration = b.calibration;
  a.weight = weight;
  a.log_weight = std::log(weight);
}

void merge_neighbours(double squared, std::vector<Hypothesis>& hypotheses) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < hypotheses.size(); ++i) {
    if (are_close(hypotheses[kept], hypotheses[i], squared)) {
      absorb(hypotheses[kept], hypotheses[i]);
    } else if (++kept != i) {
      hypotheses[kept] = hypotheses[i];
    }
  }
  hypotheses.resize(kept + 1);
}

void merge_all(double squared, std::vector<Hypothesis>& hypotheses) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    std::size_t kept = i + 1;
    for (std::size_t j = i + 1; j < hypotheses.size(); ++j) {
      if (are_close(hypotheses[i], hypotheses[j], squared)) {
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

void merge_close(double distance, std::size_t turn, std::vector<Hypothesis>& hypotheses) {
  if (hypotheses.size() < 2 || distance == 0.0) return;
  const double in_a_crowd = kCrowdsShare * distance;
  merge_neighbours(in_a_crowd * in_a_crowd, hypotheses);
  const std::size_t size = hypotheses.size();
  if (size <= kFew || (size <= kCrowded && turn % kTurns == 0)) {
    merge_all(distance * distance, hypotheses);
  }
}

}  // namespace portolan
