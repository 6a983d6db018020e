// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/pose.hpp"

namespace portolan::sim {

/// From a camera's optical frame (x right, y down, z forward) to its body (x forward, z up).
inline Pose T_body_optical() {
  Pose T = Pose::Identity();
  T.linear() << 0.0, 0.0, 1.0,  //
      -1.0, 0.0, 0.0,           //
      0.0, -1.0, 0.0;
  return T;
}

}  // namespace portolan::sim
