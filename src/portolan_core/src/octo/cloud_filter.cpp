// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/cloud_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace portolan {

namespace {

using Points = std::vector<Eigen::Vector3f>;

template <class Predicate>
void keep_if(Points& points, Predicate keeps) {
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Eigen::Vector3f& p) { return !keeps(p); }),
               points.end());
  points.shrink_to_fit();
}

/// Tells apart cubes that lie within 2^20 of the middle; further away some share a number.
std::uint64_t cube_of(const Eigen::Vector3d& p, double cell) {
  const auto part = [cell](double x) {
    const double cells = std::clamp(std::floor(x / cell), -1e15, 1e15);
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(cells)) & 0x1fffff;
  };
  return part(p.x()) | part(p.y()) << 21 | part(p.z()) << 42;
}

void thin(Points& points, double cell, double scale) {
  std::unordered_set<std::uint64_t> taken;
  taken.reserve(points.size());
  keep_if(points, [&](const Eigen::Vector3f& p) {
    return p.allFinite() && taken.insert(cube_of(scale * p.cast<double>(), cell)).second;
  });
}

}  // namespace

PointCloud pass_through(PointCloud cloud, const Pose& T_f_sensor, const PassThrough& box) {
  const Eigen::Array3d min(box.min_x, box.min_y, box.min_z);
  const Eigen::Array3d max(box.max_x, box.max_y, box.max_z);
  keep_if(cloud.points, [&](const Eigen::Vector3f& p_sensor) {
    const Eigen::Array3d p = (T_f_sensor * p_sensor.cast<double>()).array();
    return p_sensor.allFinite() && (p >= min).all() && (p <= max).all();
  });
  return cloud;
}

PointCloud thinned(PointCloud cloud, double cell, double reach) {
  if (!(cell > 0.0)) return cloud;
  thin(cloud.points, cell, 1.0);
  thin(cloud.no_returns, cell, std::max(reach, 0.0));
  return cloud;
}

}  // namespace portolan
