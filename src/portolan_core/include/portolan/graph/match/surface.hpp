// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "portolan/pose.hpp"

namespace portolan {

/// Points on the surfaces around a robot, each with the way its surface faces: what is matched.
struct Surface {
  std::vector<Eigen::Vector3d> points;   ///< [m]
  std::vector<Eigen::Vector3d> normals;  ///< towards the sensor, length 1; zero where unknown

  std::size_t size() const { return points.size(); }
  bool empty() const { return points.empty(); }

  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    points.push_back(point);
    normals.push_back(normal);
  }
};

/// Adds what is seen in another frame.
void append(const Surface& surface, const Pose& T_all_surface, Surface& all);

/// The first point of each cube of this side [m], in the order they come in.
Surface thinned(const Surface& surface, double side);

}  // namespace portolan
