// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/sensor_models.hpp"

#include <cmath>

#include "portolan/pose.hpp"

namespace portolan {

namespace {

using Row = Eigen::RowVector3d;

double range_in_plane(const Eigen::Vector3d& l) { return l.head<2>().norm(); }

double azimuth(const Eigen::Vector3d& l) { return std::atan2(l.y(), l.x()); }

double elevation(const Eigen::Vector3d& l) { return std::atan2(l.z(), range_in_plane(l)); }

Row range_in_plane_by_l(const Eigen::Vector3d& l) {
  return Row(l.x(), l.y(), 0.0) / range_in_plane(l);
}

Row azimuth_by_l(const Eigen::Vector3d& l) {
  return Row(-l.y(), l.x(), 0.0) / l.head<2>().squaredNorm();
}

Row elevation_by_l(const Eigen::Vector3d& l) {
  const double in_plane = range_in_plane(l);
  return Row(-l.x() * l.z() / in_plane, -l.y() * l.z() / in_plane, in_plane) / l.squaredNorm();
}

}  // namespace

PolarModel::Vector PolarModel::h(const Eigen::Vector3d& l) {
  return {range_in_plane(l), azimuth(l)};
}

PolarModel::Jacobian PolarModel::H(const Eigen::Vector3d& l) {
  return (Jacobian() << range_in_plane_by_l(l), azimuth_by_l(l)).finished();
}

PolarModel::Vector PolarModel::difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], wrap_angle(a[1] - b[1])};
}

SphericalModel::Vector SphericalModel::h(const Eigen::Vector3d& l) {
  return {l.norm(), azimuth(l), elevation(l)};
}

SphericalModel::Jacobian SphericalModel::H(const Eigen::Vector3d& l) {
  return (Jacobian() << l.transpose() / l.norm(), azimuth_by_l(l), elevation_by_l(l)).finished();
}

SphericalModel::Vector SphericalModel::difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], wrap_angle(a[1] - b[1]), a[2] - b[2]};
}

AzimuthModel::Vector AzimuthModel::h(const Eigen::Vector3d& l) { return Vector(azimuth(l)); }

AzimuthModel::Jacobian AzimuthModel::H(const Eigen::Vector3d& l) { return azimuth_by_l(l); }

AzimuthModel::Vector AzimuthModel::difference(const Vector& a, const Vector& b) {
  return Vector(wrap_angle(a[0] - b[0]));
}

DirectionModel::Vector DirectionModel::h(const Eigen::Vector3d& l) {
  return {azimuth(l), elevation(l)};
}

DirectionModel::Jacobian DirectionModel::H(const Eigen::Vector3d& l) {
  return (Jacobian() << azimuth_by_l(l), elevation_by_l(l)).finished();
}

DirectionModel::Vector DirectionModel::difference(const Vector& a, const Vector& b) {
  return {wrap_angle(a[0] - b[0]), a[1] - b[1]};
}

PixelModel::Vector PixelModel::h(const Eigen::Vector3d& l) const {
  return {camera.fx * l.x() / l.z() + camera.cx, camera.fy * l.y() / l.z() + camera.cy};
}

PixelModel::Jacobian PixelModel::H(const Eigen::Vector3d& l) const {
  const double z2 = l.z() * l.z();
  Jacobian H;
  H << camera.fx / l.z(), 0.0, -camera.fx * l.x() / z2,  //
      0.0, camera.fy / l.z(), -camera.fy * l.y() / z2;
  return H;
}

}  // namespace portolan
