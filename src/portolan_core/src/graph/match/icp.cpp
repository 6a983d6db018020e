// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/icp.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

// What the partners say of a small motion of the source: H v = -g.
struct Equations {
  TangentMatrix H = TangentMatrix::Zero();
  Tangent g = Tangent::Zero();
  double weight = 0.0;
  double squares = 0.0;  // weighted, of residuals [m^2]
  int partners = 0;
};

// Geman-McClure: 1 on the surface, 1/4 at `kernel`.
double weight_of(double residual, double kernel) {
  const double ratio = residual * residual / (kernel * kernel);
  return 1.0 / ((1.0 + ratio) * (1.0 + ratio));
}

struct Partner {
  Eigen::Vector3d normal;  // of the target's surface, in the source's frame
  double residual = 0.0;   // signed distance from the target's surface [m]
};

std::optional<Partner> partner_of(const SurfaceIndex& target, const Surface& source, std::size_t i,
                                  const Pose& T, double reach, double min_cosine) {
  const Eigen::Vector3d p_target = T * source.points[i];
  const auto j = target.nearest(p_target, reach);
  if (!j) return std::nullopt;
  const Eigen::Vector3d& n = target.surface().normals[*j];
  const Eigen::Vector3d normal = T.linear().transpose() * n;
  const bool faces = !source.normals[i].isZero(0.0);
  if (faces && normal.dot(source.normals[i]) < min_cosine) return std::nullopt;
  return Partner{normal, n.dot(p_target - target.surface().points[*j])};
}

// r = n . (T exp(v) p - q), so dr/dv = [m; p x m] with m = R^T n.
Equations equations(const SurfaceIndex& target, const Surface& source, const Pose& T, double reach,
                    double kernel, std::size_t stride, const IcpOptions& options) {
  Equations sum;
  for (std::size_t i = 0; i < source.size(); i += stride) {
    const auto partner = partner_of(target, source, i, T, reach, options.min_cosine);
    if (!partner) continue;
    Tangent J;
    J << partner->normal, source.points[i].cross(partner->normal);
    const double w = weight_of(partner->residual, kernel);
    sum.H.selfadjointView<Eigen::Lower>().rankUpdate(J, w);
    sum.g += w * partner->residual * J;
    sum.weight += w;
    sum.squares += w * partner->residual * partner->residual;
    ++sum.partners;
  }
  sum.H = sum.H.selfadjointView<Eigen::Lower>();
  return sum;
}

// The ways in which the source can move, turns measured by the way of its points at mean range:
// each column a unit motion, and how much the surfaces hold it.
struct Directions {
  Eigen::Matrix<double, 6, Eigen::Dynamic> motions;
  Eigen::VectorXd constraint;  // mean squared cosine between motion and normals
};

Directions directions(const Equations& sum, GraphSpace space, double mean_range) {
  static const std::vector<Eigen::Index> kPlanar = {0, 1, 5};
  static const std::vector<Eigen::Index> kSpatial = {0, 1, 2, 3, 4, 5};
  const std::vector<Eigen::Index>& free = space == GraphSpace::planar ? kPlanar : kSpatial;
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(6, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index axis = free[static_cast<std::size_t>(k)];
    unit(axis, k) = axis < 3 ? 1.0 : 1.0 / mean_range;
  }
  const Eigen::MatrixXd H = unit.transpose() * sum.H * unit / std::max(sum.weight, 1e-12);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(H);
  return {unit * solver.eigenvectors(), solver.eigenvalues()};
}

// Gauss-Newton's step, not along what is open.
Tangent step(const Equations& sum, const Directions& along, const IcpOptions& options) {
  Tangent v = Tangent::Zero();
  for (Eigen::Index k = 0; k < along.constraint.size(); ++k) {
    if (along.constraint[k] < options.min_constraint) continue;
    const auto motion = along.motions.col(k);
    v -= motion * (motion.dot(sum.g) / (along.constraint[k] * sum.weight));
  }
  return v;
}

Pose moved(const Pose& T, const Tangent& v) {
  Pose result = T;
  result.translation() += T.linear() * v.head<3>();
  const double angle = v.tail<3>().norm();
  if (angle > 0.0) {
    const Eigen::AngleAxisd turn(angle, v.tail<3>() / angle);
    const Eigen::Quaterniond q(T.linear() * turn.toRotationMatrix());
    result.linear() = q.normalized().toRotationMatrix();
  }
  return result;
}

double mean_range(const Surface& surface) {
  double squares = 0.0;
  for (const Eigen::Vector3d& p : surface.points) squares += p.squaredNorm();
  return std::sqrt(std::max(squares / static_cast<double>(surface.size()), 1e-4));
}

// Variance of a held direction: residuals over the points that hold it, and the bias.
void judge(const Equations& sum, const Directions& along, const IcpOptions& options, Match& match) {
  const double variance = sum.squares / sum.weight;
  Eigen::MatrixXd duals = along.motions.transpose()
                              .completeOrthogonalDecomposition()
                              .pseudoInverse();  // a dual's product with its motion is 1
  for (Eigen::Index k = 0; k < along.constraint.size(); ++k) {
    const double constraint = along.constraint[k];
    if (constraint < options.min_constraint) {
      match.open.emplace_back(along.motions.col(k).normalized());
      continue;
    }
    const double var = variance / (constraint * sum.weight) + options.bias * options.bias;
    match.information += duals.col(k) * duals.col(k).transpose() / var;
  }
}

void measure_fit(const SurfaceIndex& target, const Surface& source, const IcpOptions& options,
                 Match& match) {
  const double on_surface = 2.0 * options.kernel;
  double squares = 0.0;
  int fitting = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const auto partner =
        partner_of(target, source, i, match.T_target_source, 4.0 * on_surface, options.min_cosine);
    if (!partner || std::abs(partner->residual) > on_surface) continue;
    squares += partner->residual * partner->residual;
    ++fitting;
  }
  match.overlap = source.empty() ? 0.0 : fitting / static_cast<double>(source.size());
  match.rms = fitting > 0 ? std::sqrt(squares / fitting) : 0.0;
}

bool is_small(const Tangent& v, double range) {
  constexpr double kSmall = 1e-3;  // far below what any scan is good for [m]
  return v.head<3>().norm() < kSmall && v.tail<3>().norm() * range < kSmall;
}

}  // namespace

Match icp(const SurfaceIndex& target, const Surface& source, const Pose& T_target_source,
          GraphSpace space, const IcpOptions& options) {
  Match match;
  match.T_target_source = T_target_source;
  if (source.empty() || target.surface().empty()) return match;
  const double range = mean_range(source);
  const auto coarse = static_cast<std::size_t>(options.coarse_points);
  double reach = options.reach;
  while (match.iterations < options.max_iterations && !match.converged) {
    constexpr double kNarrowing = 0.7;
    const bool narrow = reach <= 4.0 * options.kernel;
    const double kernel = narrow ? options.kernel : 0.5 * reach;
    const std::size_t stride = narrow ? 1 : 1 + source.size() / coarse;
    const Equations sum =
        equations(target, source, match.T_target_source, reach, kernel, stride, options);
    if (sum.partners * static_cast<int>(stride) < options.min_points) return match;
    const Directions along = directions(sum, space, range);
    const Tangent v = step(sum, along, options);
    match.T_target_source = moved(match.T_target_source, v);
    ++match.iterations;
    match.converged = narrow && is_small(v, range);
    if (match.converged) judge(sum, along, options, match);
    reach = std::max(reach * kNarrowing, 4.0 * options.kernel);
  }
  measure_fit(target, source, options, match);
  return match;
}

}  // namespace portolan
