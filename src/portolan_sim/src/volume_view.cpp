// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/volume_view.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "portolan/sim/optical_frame.hpp"

namespace portolan::sim {

namespace {

bool are_close(const Pose& a, const Pose& b, double spacing) {
  constexpr double kTurn = 0.3;  // [rad]
  const Pose moved = a.inverse() * b;
  return moved.translation().norm() < spacing && rotation_angle(moved) < kTurn;
}

Eigen::Array3i voxel_of(const Eigen::Vector3d& p_map, double side) {
  return (p_map / side).array().floor().cast<int>();
}

}  // namespace

VolumeView::VolumeView(const VoxelLattice& lattice, const Eigen::AlignedBox3d& space, double reach)
    : side_(lattice.resolution()), reach_(reach), low_(voxel_of(space.min(), side_)) {
  size_ = voxel_of(space.max(), side_) + 1 - low_;
  voxels_.assign(static_cast<std::size_t>(size_.cast<std::int64_t>().prod()), Voxel::unseen);
}

void VolumeView::look(const World& world, const AnySensor& sensor, const Pose& T_map_base,
                      double spacing) {
  const std::string frame = mounts(sensor).front().frame;
  const auto last = looked_from_.find(frame);
  if (last != looked_from_.end() && are_close(last->second, T_map_base, spacing)) return;
  looked_from_[frame] = T_map_base;
  if (const auto* lidar = std::get_if<Lidar>(&sensor)) {
    look_with<Lidar>(world, lidar->options(), T_map_base);
  } else if (const auto* camera = std::get_if<DepthCamera>(&sensor)) {
    look_with<DepthCamera>(world, camera->options(), T_map_base);
  }
}

template <class Sensor>
void VolumeView::look_with(const World& world, typename Sensor::Options options,
                           const Pose& T_map_base) {
  options.noise.range_stddev = options.noise.stddev_per_metre = 0.0;
  options.noise.dropout = options.noise.outliers = 0.0;
  Pose T_map_sensor = T_map_base * mount(options);
  if constexpr (std::is_same_v<Sensor, DepthCamera>) T_map_sensor = T_map_sensor * T_body_optical();
  const OrganizedCloud seen = Sensor(options, 0).sense(world, T_map_sensor);
  for (const Eigen::Vector3f& p : seen.cloud.points) {
    if (p.allFinite()) look_along(T_map_sensor, p.cast<double>(), true);
  }
  for (const Eigen::Vector3f& direction : seen.cloud.no_returns) {
    look_along(T_map_sensor, options.noise.range_max * direction.cast<double>(), false);
  }
}

void VolumeView::look_along(const Pose& T_map_sensor, const Eigen::Vector3d& p_sensor,
                            bool returns) {
  constexpr double kBehindSurface = 1e-3;  // [m]
  const double range = p_sensor.norm();
  const Eigen::Vector3d direction = T_map_sensor.linear() * (p_sensor / range);
  const double end = std::min(range, reach_);
  for (double at = 0.0; at < end; at += 0.5 * side_) {
    mark(T_map_sensor.translation() + at * direction, Voxel::free);
  }
  if (returns && range <= reach_) {
    mark(T_map_sensor.translation() + (range + kBehindSurface) * direction, Voxel::surface);
  }
}

void VolumeView::mark(const Eigen::Vector3d& p_map, Voxel what) {
  const Eigen::Array3i at = voxel_of(p_map, side_) - low_;
  if ((at < 0).any() || (at >= size_).any()) return;
  const std::int64_t i =
      at.x() + std::int64_t{size_.x()} * (at.y() + std::int64_t{size_.y()} * at.z());
  Voxel& voxel = voxels_[static_cast<std::size_t>(i)];
  voxel = std::max(voxel, what);
}

Eigen::Vector3d VolumeView::centre(std::size_t i) const {
  const auto at = static_cast<std::int64_t>(i);
  const std::int64_t width = size_.x();
  const std::int64_t depth = size_.y();
  const Eigen::Array3i voxel(static_cast<int>(at % width), static_cast<int>(at / width % depth),
                             static_cast<int>(at / width / depth));
  return ((voxel + low_).cast<double>() + 0.5).matrix() * side_;
}

}  // namespace portolan::sim
