// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace portolan::sim {

/// How a differential drive moves: straight on and turning, in the robot's own frame.
struct Velocity {
  double forward = 0.0;  ///< [m/s]
  double turn = 0.0;     ///< counter-clockwise [rad/s]
};

}  // namespace portolan::sim
