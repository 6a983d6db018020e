// SPDX-License-Identifier: BSD-3-Clause
#include "ceres_graph.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <array>
#include <vector>

namespace portolan::bench {

namespace {

struct PlanarResidual {
  Eigen::Vector3d measured;
  Eigen::Matrix3d root;

  template <class T>
  bool operator()(const T* from, const T* to, T* residual) const {
    const T c = cos(from[2]);
    const T s = sin(from[2]);
    const T dx = to[0] - from[0];
    const T dy = to[1] - from[1];
    const T x = c * dx + s * dy - measured[0];
    const T y = c * dy - s * dx - measured[1];
    const double cz = std::cos(measured[2]);
    const double sz = std::sin(measured[2]);
    const T turn = to[2] - from[2] - measured[2];
    Eigen::Map<Eigen::Matrix<T, 3, 1>> r(residual);
    r << cz * x + sz * y, cz * y - sz * x, turn - 2.0 * M_PI * floor((turn + M_PI) / (2.0 * M_PI));
    r = root.cast<T>() * r;
    return true;
  }
};

struct SpatialResidual {
  Eigen::Vector3d t_measured;
  Eigen::Quaterniond q_measured;
  TangentMatrix root;

  template <class T>
  bool operator()(const T* from, const T* to, T* residual) const {
    using Point = Eigen::Map<const Eigen::Matrix<T, 3, 1>>;
    using Turn = Eigen::Map<const Eigen::Quaternion<T>>;
    const Turn q_from(from + 3);
    const Eigen::Quaternion<T> back = q_measured.conjugate().cast<T>();
    const Eigen::Matrix<T, 3, 1> t = q_from.conjugate() * (Point(to) - Point(from));
    Eigen::Quaternion<T> q = back * (q_from.conjugate() * Turn(to + 3));
    if (q.w() < T(0.0)) q.coeffs() = -q.coeffs();
    Eigen::Map<Eigen::Matrix<T, 6, 1>> r(residual);
    r << back * (t - t_measured.cast<T>()), T(2.0) * q.vec();
    r = root.cast<T>() * r;
    return true;
  }
};

using Parameters = std::array<double, 7>;  // x, y and heading, or x, y, z and x, y, z, w

Parameters parameters(const Pose& pose, GraphSpace space) {
  const auto& t = pose.translation();
  if (space == GraphSpace::planar) return {t.x(), t.y(), yaw(pose), 0.0, 0.0, 0.0, 0.0};
  const Eigen::Quaterniond q(pose.linear());
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

Pose pose(const Parameters& x, GraphSpace space) {
  if (space == GraphSpace::planar) return planar_pose(x[0], x[1], x[2]);
  return Eigen::Translation3d(x[0], x[1], x[2]) *
         Eigen::Quaterniond(x[6], x[3], x[4], x[5]).normalized();
}

ceres::CostFunction* residual(const Arc& arc, GraphSpace space) {
  const TangentMatrix& m = arc.information;
  if (space == GraphSpace::planar) {
    Eigen::Matrix3d planar;
    planar << m.topLeftCorner<2, 2>(), m.block<2, 1>(0, 5), m.block<1, 2>(5, 0), m(5, 5);
    const Parameters z = parameters(arc.T_from_to, space);
    return new ceres::AutoDiffCostFunction<PlanarResidual, 3, 3, 3>(
        new PlanarResidual{{z[0], z[1], z[2]}, planar.llt().matrixU()});
  }
  return new ceres::AutoDiffCostFunction<SpatialResidual, 6, 7, 7>(new SpatialResidual{
      arc.T_from_to.translation(), Eigen::Quaterniond(arc.T_from_to.linear()), m.llt().matrixU()});
}

void add_pose(ceres::Problem& problem, double* x, GraphSpace space) {
  if (space == GraphSpace::planar) return problem.AddParameterBlock(x, 3);
#if CERES_VERSION_MAJOR * 100 + CERES_VERSION_MINOR >= 201
  problem.AddParameterBlock(
      x, 7,
      new ceres::ProductManifold<ceres::EuclideanManifold<3>, ceres::EigenQuaternionManifold>());
#else
  problem.AddParameterBlock(
      x, 7,
      new ceres::ProductParameterization(new ceres::IdentityParameterization(3),
                                         new ceres::EigenQuaternionParameterization()));
#endif
}

}  // namespace

void optimize_with_ceres(Graph& graph) {
  std::vector<Parameters> poses;
  for (const GraphPose& given : graph.poses()) {
    poses.push_back(parameters(given.T_map_pose, graph.space()));
  }
  ceres::Problem problem;
  for (Parameters& x : poses) add_pose(problem, x.data(), graph.space());
  for (const Arc& arc : graph.arcs()) {
    problem.AddResidualBlock(residual(arc, graph.space()), nullptr,
                             poses[*graph.find(arc.from)].data(),
                             poses[*graph.find(arc.to)].data());
  }
  problem.SetParameterBlockConstant(poses[0].data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 200;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (std::size_t i = 0; i < poses.size(); ++i) graph.move(i, pose(poses[i], graph.space()));
}

}  // namespace portolan::bench
