// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "portolan/beacon/hypothesis.hpp"

namespace portolan {

/// How an antenna's poses lose their way: at random, and by turning too far.
struct PoseDrift {
  double drift = 0.0;  ///< how far they stray per root of the way [m/sqrt(m)]
  bool turns = false;  ///< whether they may turn too far, by the calibration's `turn`
};

/// What stands still seems to move while poses drift: carries a hypothesis along a leg of the way.
/// It widens, and where the calibration's turn is not known it depends on it more. `c` is the
/// calibration at which to look, `origin` that of polar places; planar ones stay in their plane.
void carry(const Travel& leg, const PoseDrift& drift, const RangeCalibration& c, bool planar,
           const Eigen::Vector3d& origin, Hypothesis& hypothesis);

}  // namespace portolan
