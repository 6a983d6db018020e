// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/travel.hpp"

#include "portolan/beacon/polar.hpp"

namespace portolan {

namespace {

void widen(double variance, bool planar, Hypothesis& h) {
  Eigen::Vector3d spread(1.0, 1.0, planar ? 0.0 : 1.0);
  if (h.is_polar) spread.tail<2>() /= h.x[0] * h.x[0];  // of angles
  h.Q.diagonal() += variance * spread;
}

// How a place moves that is seen from poses that turn too far by 1 rad/m [m^2/rad].
Eigen::Vector3d turned(const Travel& leg, const Eigen::Vector3d& place) {
  const Eigen::Vector3d arm = leg.way * place - leg.moment;
  return {-arm.y(), arm.x(), 0.0};
}

// The same in distance [m], azimuth and elevation [rad].
Eigen::Vector3d turned_polar(const Travel& leg, const Eigen::Vector3d& polar,
                             const Eigen::Vector3d& origin) {
  const Eigen::Matrix3d J = polar_jacobian(polar);  // its columns are orthogonal
  const Eigen::Vector3d lengths = J.colwise().squaredNorm();
  const Eigen::Vector3d step = turned(leg, from_polar(polar, origin));
  return (J.transpose() * step).cwiseQuotient(lengths.cwiseMax(1e-12));
}

}  // namespace

void carry(const Travel& leg, const PoseDrift& drift, const RangeCalibration& c, bool planar,
           const Eigen::Vector3d& origin, Hypothesis& hypothesis) {
  if (drift.drift > 0.0) widen(drift.drift * drift.drift * leg.way, planar, hypothesis);
  if (!drift.turns) return;
  const Eigen::Vector3d mean = hypothesis.mean(c);
  const Eigen::Vector3d step =
      hypothesis.is_polar ? turned_polar(leg, mean, origin) : turned(leg, mean);
  hypothesis.G.col(2) += step;
  hypothesis.x += (c.turn - c.deviation[2]) * step;  // as far as was known before
}

}  // namespace portolan
