// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "beacon/scenario.hpp"
#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/beacon/range_update.hpp"
#include "portolan/testing/numeric_jacobian.hpp"

namespace portolan {
namespace {

using beacon_test::Dice;

// One EKF over the calibration and two beacons together, as in any textbook: the slow reference.
class JointFilter {
 public:
  JointFilter(const Eigen::Vector3d& calibration_variance, const Eigen::Matrix3d& Q,
              const std::vector<Eigen::Vector3d>& beacons)
      : x_(3 + 3 * static_cast<int>(beacons.size())), P_(x_.size(), x_.size()) {
    x_.setZero();
    P_.setZero();
    x_[0] = 1.0;
    P_.topLeftCorner<3, 3>() = calibration_variance.asDiagonal();
    for (std::size_t i = 0; i < beacons.size(); ++i) {
      x_.segment<3>(at(i)) = beacons[i];
      P_.block<3, 3>(at(i), at(i)) = Q;
    }
  }

  // Poses that turn too far make beacon i seem to turn about the middle of a step.
  void turn(std::size_t i, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d arm = (to - from).norm() * (x_.segment<3>(at(i)) - 0.5 * (from + to));
    Eigen::MatrixXd F = Eigen::MatrixXd::Identity(x_.size(), x_.size());
    F.block<3, 1>(at(i), 2) = Eigen::Vector3d(-arm.y(), arm.x(), 0.0);
    x_ = F * x_;
    P_ = F * P_ * F.transpose();
  }

  void update(std::size_t i, const PosedRange& z) {
    const Eigen::Matrix3d P_m = given_calibration(i);
    const DistancePrediction d = predict_distance(x_.segment<3>(at(i)), P_m, z.p_map);
    Eigen::RowVectorXd H = Eigen::RowVectorXd::Zero(x_.size());
    H[0] = d.mean;
    H[1] = 1.0;
    H.segment<3>(at(i)) = x_[0] * d.H;
    const double bent = x_[0] * x_[0] * (d.variance - d.H * P_m * d.H.transpose());
    const double S = H * P_ * H.transpose() + bent + z.stddev * z.stddev;
    const Eigen::VectorXd K = P_ * H.transpose() / S;
    x_ += K * (z.range - x_[0] * d.mean - x_[1]);
    P_ -= S * K * K.transpose();
  }

  Eigen::Vector3d beacon(std::size_t i) const { return x_.segment<3>(at(i)); }
  Eigen::Matrix3d covariance(std::size_t i) const { return P_.block<3, 3>(at(i), at(i)); }
  Eigen::Vector3d calibration() const { return x_.head<3>(); }
  Eigen::Matrix3d calibration_covariance() const { return P_.topLeftCorner<3, 3>(); }

 private:
  static int at(std::size_t i) { return 3 + 3 * static_cast<int>(i); }

  Eigen::Matrix3d given_calibration(std::size_t i) const {
    const Eigen::Matrix3d P_mc = P_.block<3, 3>(at(i), 0);
    return covariance(i) - P_mc * calibration_covariance().inverse() * P_mc.transpose();
  }

  Eigen::VectorXd x_;
  Eigen::MatrixXd P_;
};

Eigen::Vector3d antenna_after(int step) {
  return {4.0 * std::cos(0.05 * step), 3.0 * std::sin(0.05 * step), 0.0};
}

// Where what stands still seems to be after a step of poses that turn too far.
std::vector<Eigen::Vector3d> turned(std::vector<Eigen::Vector3d> places, double turn,
                                    const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double angle = turn * (to - from).norm();
  const Eigen::Vector3d center = 0.5 * (from + to);
  for (Eigen::Vector3d& p : places) {
    p = center + Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * (p - center);
  }
  return places;
}

// The largest differences between the mapper and the large filter after 300 ranges.
struct Differences {
  double calibration = 0.0;
  double calibration_covariance = 0.0;
  double place = 0.0;
  double covariance = 0.0;
};

// The mapper that knows what the large filter knows to begin with.
BeaconMapper begun(const Eigen::Vector3d& variance, const Eigen::Matrix3d& Q,
                   const std::vector<Eigen::Vector3d>& start) {
  BeaconOptions options;
  options.learn_noise = false;
  options.drift = 0.0;
  options.outliers.share = 1e-12;
  CalibrationPrior prior;
  prior.information = variance.cwiseInverse().asDiagonal();
  std::map<BeaconId, BeaconTrack> tracks;
  for (BeaconId id = 0; id < 2; ++id) {
    Hypothesis h;
    h.x = start[id];
    h.Q = Q;
    tracks.emplace(id, BeaconTrack::restored({h}, 1, 0, 0, options));
  }
  return BeaconMapper::restored(options, prior, 0.0, 1.0, std::move(tracks));
}

// Two beacons that a robot sees from poses that turn too far by `turn` [rad/m].
Differences compare(double turn, double turn_variance) {
  const Eigen::Vector3d variance(0.05 * 0.05, 0.2 * 0.2, turn_variance);
  const Eigen::Matrix3d Q = Eigen::Vector3d(0.04, 0.05, 0.0).asDiagonal();
  std::vector<Eigen::Vector3d> truth = {{6.0, 2.0, 0.0}, {-3.0, 5.0, 0.0}};
  const std::vector<Eigen::Vector3d> start = {{6.1, 1.9, 0.0}, {-3.2, 5.1, 0.0}};
  JointFilter joint(variance, Q, start);

  BeaconMapper mapper = begun(variance, Q, start);

  Dice dice(11);
  for (int step = 0; step < 300; ++step) {
    const BeaconId id = static_cast<BeaconId>(step % 3 == 0);
    PosedRange z;
    const Eigen::Vector3d from = antenna_after(step - 1);
    z.p_map = antenna_after(step);
    if (step > 0) {
      for (std::size_t i = 0; i < 2; ++i) joint.turn(i, from, z.p_map);
      truth = turned(truth, turn, from, z.p_map);
    }
    z.range = 1.03 * (truth[id] - z.p_map).norm() + 0.1 + dice.normal(0.1);
    z.stddev = 0.1;
    joint.update(id, z);
    mapper.insert(beacon_test::one_range(id, z.range, z.stddev),
                  beacon_test::antenna_at(z.p_map.x(), z.p_map.y()));
  }
  const RangeCalibration c = mapper.calibration();
  EXPECT_NEAR(c.scale, 1.03, 0.01);
  EXPECT_NEAR(c.turn, turn, 3.0 * std::sqrt(c.covariance(2, 2)) + 1e-9);
  Differences differences;
  differences.calibration = (Eigen::Vector3d(c.scale, c.bias, c.turn) - joint.calibration()).norm();
  differences.calibration_covariance = (c.covariance - joint.calibration_covariance()).norm();
  const auto estimates = mapper.estimates();
  for (std::size_t i = 0; i < 2; ++i) {
    const BeaconMode& mode = estimates[i].modes[0];
    differences.place = std::max(differences.place, (mode.mean - joint.beacon(i)).norm());
    differences.covariance =
        std::max(differences.covariance, (mode.covariance - joint.covariance(i)).norm());
    EXPECT_LT((mode.mean - truth[i]).norm(), 0.1);
  }
  return differences;
}

TEST(JointEstimate, OfBeaconsAndDeviceEqualsOneLargeFilter) {
  const Differences differences = compare(0.0, 1e-18);
  EXPECT_LT(differences.calibration, 1e-6);
  EXPECT_LT(differences.calibration_covariance, 1e-7);
  EXPECT_LT(differences.place, 1e-6);
  EXPECT_LT(differences.covariance, 1e-7);
}

TEST(JointEstimate, OfATurnThatPosesLackTooIsThatOfOneLargeFilterToFirstOrder) {
  const Differences differences = compare(0.002, 0.003 * 0.003);
  EXPECT_LT(differences.calibration, 3e-3);
  EXPECT_LT(differences.calibration_covariance, 1e-5);
  EXPECT_LT(differences.place, 5e-3);
  EXPECT_LT(differences.covariance, 1e-4);
}

TEST(PredictDistance, JacobianIsTheDerivative) {
  Dice dice(1);
  for (int i = 0; i < 100; ++i) {
    const auto random = [&] {
      return Eigen::Vector3d(dice.normal(5.0), dice.normal(5.0), dice.normal(5.0));
    };
    const Eigen::Vector3d mean = random();
    const Eigen::Vector3d p_map = random();
    const auto h = [&](const Eigen::Vector3d& m) {
      return Eigen::Matrix<double, 1, 1>((m - p_map).norm());
    };
    const auto numeric = testing::numeric_jacobian(h, mean);
    const DistancePrediction d = predict_distance(mean, Eigen::Matrix3d::Identity(), p_map);
    EXPECT_LT((d.H - numeric).norm(), 1e-6);
  }
}

TEST(PredictDistance, SecondOrderMomentsAreThoseOfSamples) {
  Dice dice(2);
  const Eigen::Vector3d mean(4.0, 1.0, -0.5);
  const Eigen::Vector3d deviations(0.5, 0.8, 0.3);
  double sum = 0.0;
  double squares = 0.0;
  const int samples = 200000;
  for (int i = 0; i < samples; ++i) {
    const Eigen::Vector3d m =
        mean + Eigen::Vector3d(dice.normal(0.5), dice.normal(0.8), dice.normal(0.3));
    sum += m.norm();
    squares += m.squaredNorm();
  }
  const double sampled = sum / samples;
  const DistancePrediction d =
      predict_distance(mean, deviations.cwiseAbs2().asDiagonal(), Eigen::Vector3d::Zero());
  EXPECT_NEAR(d.mean, sampled, 0.01);
  EXPECT_NEAR(d.variance, squares / samples - sampled * sampled, 0.02);
  EXPECT_GT(d.mean, mean.norm() + 0.05);
}

}  // namespace
}  // namespace portolan
