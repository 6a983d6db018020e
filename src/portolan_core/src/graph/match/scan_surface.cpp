// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/scan_surface.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "portolan/observation/range_reading.hpp"

namespace portolan {

namespace {

struct Echo {
  Eigen::Vector3d point;   // [m]
  Eigen::Vector3d origin;  // of the beam [m]
  std::size_t beam = 0;
};

std::vector<Echo> echoes(const RangeScan& scan, double max_range) {
  const bool still = scan.T_first_last.matrix().isIdentity(0.0);
  const double last = static_cast<double>(scan.ranges.size()) - 1.0;
  std::vector<Echo> found;
  found.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = static_cast<double>(scan.ranges[i]);
    if (range_reading(range, scan.range_min, scan.range_max) != RangeReading::hit) continue;
    if (range > max_range) continue;
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Eigen::Vector3d point(range * std::cos(angle), range * std::sin(angle), 0.0);
    if (still) {
      found.push_back({point, Eigen::Vector3d::Zero(), i});
    } else {
      const Pose T_first_beam =
          interpolate(Pose::Identity(), scan.T_first_last, static_cast<double>(i) / last);
      found.push_back({T_first_beam * point, T_first_beam.translation(), i});
    }
  }
  return found;
}

bool continues(const Echo& a, const Echo& b, double max_gap) {
  const std::size_t apart = a.beam > b.beam ? a.beam - b.beam : b.beam - a.beam;
  return apart <= 2 && (a.point - b.point).norm() <= max_gap;
}

// Mean and scatter of the echoes on one surface with the i-th, in the scan's plane.
class Patch {
 public:
  void add(const Eigen::Vector2d& p) {
    sum_ += p;
    squares_ += p * p.transpose();
    ++count_;
  }
  // The direction across the line that fits best; zero where no line does.
  Eigen::Vector2d normal() const {
    if (count_ < 3) return Eigen::Vector2d::Zero();
    const Eigen::Vector2d mean = sum_ / count_;
    const Eigen::Matrix2d scatter = squares_ / count_ - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(scatter);
    constexpr double kFlat = 0.1;  // squared ratio of thickness to length that still is a line
    if (solver.eigenvalues()[0] > kFlat * solver.eigenvalues()[1]) return Eigen::Vector2d::Zero();
    return solver.eigenvectors().col(0);
  }

 private:
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
  double count_ = 0.0;
};

// The nearest echo to each side always counts, further ones as far as they are within reach.
Eigen::Vector3d normal_at(const std::vector<Echo>& all, std::size_t i,
                          const SurfaceOptions& options) {
  const Eigen::Vector3d& center = all[i].point;
  Patch patch;
  patch.add(Eigen::Vector2d::Zero());
  const auto add = [&](std::size_t from, std::size_t to, bool nearest) {
    if (!continues(all[from], all[to], options.max_gap)) return false;
    const Eigen::Vector3d offset = all[to].point - center;
    if (!nearest && offset.norm() > options.reach) return false;
    patch.add(offset.head<2>());
    return true;
  };
  for (std::size_t k = i; k > 0 && add(k, k - 1, k == i); --k) {
  }
  for (std::size_t k = i; k + 1 < all.size() && add(k, k + 1, k == i); ++k) {
  }
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  normal.head<2>() = patch.normal();
  return normal.dot(all[i].origin - center) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace

Surface scan_surface(const RangeScan& scan, const SurfaceOptions& options) {
  Surface surface;
  if (!is_usable(scan)) return surface;
  const std::vector<Echo> all = echoes(scan, options.max_range);
  const Echo* last = nullptr;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (last != nullptr && (all[i].point - last->point).norm() < options.spacing) continue;
    surface.add(all[i].point, normal_at(all, i, options));
    last = &all[i];
  }
  return surface;
}

}  // namespace portolan
