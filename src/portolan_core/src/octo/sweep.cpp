// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/sweep.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

using octomap::point3d;

bool is_finite(const point3d& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

point3d transformed(const Pose& T_map_sensor, const Eigen::Vector3f& p_sensor) {
  const auto& T = T_map_sensor.matrix();
  const Eigen::Vector3d p = p_sensor.cast<double>();
  const auto row = [&](int i) {
    return static_cast<float>(T(i, 0) * p.x() + T(i, 1) * p.y() + T(i, 2) * p.z() + T(i, 3));
  };
  return {row(0), row(1), row(2)};
}

point3d origin_of(const Pose& T_map_sensor) {
  return transformed(T_map_sensor, Eigen::Vector3f::Zero());
}

std::uint64_t packed(const octomap::OcTreeKey& key) {
  return key[0] | std::uint64_t{key[1]} << 16 | std::uint64_t{key[2]} << 32;
}

/// One point, the centre, for each voxel that holds some; those beyond the octree as they are.
std::vector<point3d> discretized(const std::vector<point3d>& points, const VoxelLattice& lattice) {
  std::vector<point3d> kept;
  std::vector<std::uint64_t> voxels;
  for (const point3d& p : points) {
    if (const auto key = lattice.key(p)) {
      voxels.push_back(packed(*key));
    } else {
      kept.push_back(p);
    }
  }
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  for (const std::uint64_t voxel : voxels) {
    const auto part = [voxel](int shift) { return static_cast<octomap::key_type>(voxel >> shift); };
    kept.push_back(lattice.centre(octomap::OcTreeKey(part(0), part(16), part(32))));
  }
  return kept;
}

}  // namespace

point3d to_map(const Pose& T_map_sensor, const Eigen::Vector3f& p_sensor) {
  return transformed(T_map_sensor, p_sensor);
}

void Sweep::add(const PointCloud& cloud, const Pose& T_map_sensor) {
  add_points(cloud.points, T_map_sensor, Kind::obstacle);
  for (const Eigen::Vector3f& direction : cloud.no_returns) {
    add_no_return(T_map_sensor, direction, model_.max_range);
  }
}

void Sweep::add(const GroundedCloud& cloud, const Pose& T_map_sensor) {
  add(cloud.obstacles, T_map_sensor);
  add_points(cloud.ground, T_map_sensor, Kind::ground);
}

void Sweep::add(const RangeScan& scan, const Pose& T_map_sensor) {
  const bool moves = !scan.T_first_last.matrix().isIdentity(0.0);
  const double last = std::max(1.0, static_cast<double>(scan.ranges.size()) - 1.0);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const auto place = static_cast<double>(i);
    const double angle = scan.angle_min + place * scan.angle_increment;
    const Pose T_map_beam =
        moves ? T_map_sensor * interpolate(Pose::Identity(), scan.T_first_last, place / last)
              : T_map_sensor;
    add_beam(scan, angle, static_cast<double>(scan.ranges[i]), T_map_beam);
  }
}

inline void Sweep::add_point(const point3d& origin, const point3d& p_map, Kind kind) {
  if (!is_finite(p_map)) {
    ++counts_.not_finite;
    return;
  }
  const double distance = (p_map - origin).norm();
  if (model_.min_range > 0.0 && distance < model_.min_range) {
    ++counts_.too_near;
  } else if (model_.max_range >= 0.0 && !(distance <= model_.max_range)) {
    const point3d direction = (p_map - origin).normalized();
    add_free(origin, origin + direction * static_cast<float>(model_.max_range));
    ++counts_.beyond_range;
  } else if (const auto key = lattice_.key(p_map); !key) {
    ++counts_.outside_octree;
  } else {
    rays_.push_back({origin, p_map, kind == Kind::obstacle, key});
    ++(kind == Kind::obstacle ? counts_.hits : counts_.ground);
  }
}

void Sweep::add_points(const std::vector<Eigen::Vector3f>& points, const Pose& T_map_sensor,
                       Kind kind) {
  const point3d origin = origin_of(T_map_sensor);
  rays_.reserve(rays_.size() + points.size());
  std::vector<point3d> in_map;
  in_map.reserve(points.size());
  for (const Eigen::Vector3f& p : points) in_map.push_back(transformed(T_map_sensor, p));
  if (discretize_) in_map = discretized(in_map, lattice_);
  for (const point3d& p : in_map) add_point(origin, p, kind);
}

void Sweep::add_no_return(const Pose& T_map_sensor, const Eigen::Vector3f& direction,
                          double reach) {
  if (no_return_ == NoReturn::ignore || !direction.allFinite()) {
    ++counts_.silent;
    return;
  }
  const point3d origin = origin_of(T_map_sensor);
  const Pose rotation(T_map_sensor.linear());
  add_free(origin, origin + transformed(rotation, direction) * static_cast<float>(reach));
  ++counts_.no_returns;
}

void Sweep::add_beam(const RangeScan& scan, double angle, double range, const Pose& T_map_beam) {
  const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
  switch (range_reading(range, scan.range_min, scan.range_max)) {
    case RangeReading::hit: {
      const Eigen::Vector3f p_sensor = (range * direction).cast<float>();
      return add_point(origin_of(T_map_beam), transformed(T_map_beam, p_sensor), Kind::obstacle);
    }
    case RangeReading::nothing_returned:
      return add_no_return(T_map_beam, direction.cast<float>(),
                           std::min(scan.range_max, model_.max_range));
    case RangeReading::no_information:
      ++counts_.silent;
  }
}

}  // namespace portolan
