// SPDX-License-Identifier: BSD-3-Clause
#include "mrpt_graph.hpp"

#include <mrpt/graphs/CNetworkOfPoses.h>
#include <mrpt/graphslam/levmarq.h>

#include <memory>

namespace portolan::bench {

namespace {

Pose pose(const mrpt::poses::CPose2D& p) { return planar_pose(p.x(), p.y(), p.phi()); }
Pose pose(const mrpt::poses::CPose3D& p) {
  return Pose(p.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>().asEigen());
}

mrpt::math::CMatrixDouble44 matrix(const Pose& T) {
  return mrpt::math::CMatrixDouble44(T.matrix());
}

template <class Network>
struct Converted {
  using Constraint = typename Network::constraint_t;
  using Mean = std::decay_t<decltype(std::declval<Constraint>().mean)>;

  explicit Converted(const Graph& graph) {
    constexpr bool kIsPlanar = std::is_same_v<Mean, mrpt::poses::CPose2D>;
    for (const GraphPose& given : graph.poses()) {
      network.nodes[static_cast<mrpt::graphs::TNodeID>(given.id)] =
          typename Network::global_pose_t(mean(given.T_map_pose));
    }
    network.root = static_cast<mrpt::graphs::TNodeID>(graph.poses().front().id);
    for (const Arc& arc : graph.arcs()) {
      Constraint constraint;
      constraint.mean = mean(arc.T_from_to);
      // MRPT's turns of a 3D pose are yaw, pitch and roll.
      const std::array<int, 6> order =
          kIsPlanar ? std::array<int, 6>{0, 1, 5, 0, 0, 0} : std::array<int, 6>{0, 1, 2, 5, 4, 3};
      for (int i = 0; i < constraint.cov_inv.rows(); ++i) {
        for (int j = 0; j < constraint.cov_inv.cols(); ++j) {
          constraint.cov_inv(i, j) = arc.information(order[static_cast<std::size_t>(i)],
                                                     order[static_cast<std::size_t>(j)]);
        }
      }
      network.insertEdgeAtEnd(static_cast<mrpt::graphs::TNodeID>(arc.from),
                              static_cast<mrpt::graphs::TNodeID>(arc.to), constraint);
    }
  }

  static Mean mean(const Pose& T) {
    if constexpr (std::is_same_v<Mean, mrpt::poses::CPose2D>) {
      return {T.translation().x(), T.translation().y(), yaw(T)};
    } else {
      return mrpt::poses::CPose3D(matrix(T));
    }
  }

  Network network;
};

template <class Network>
std::function<void()> optimizer(const Graph& graph, Graph& result) {
  const auto start = std::make_shared<const Converted<Network>>(graph);
  return [start, &result] {
    Network network = start->network;
    mrpt::graphslam::TResultInfoSpaLevMarq info;
    mrpt::graphslam::optimize_graph_spa_levmarq(network, info);
    std::size_t i = 0;
    for (const auto& [id, node] : network.nodes) result.move(i++, pose(node));
  };
}

}  // namespace

std::function<void()> mrpt_optimizer(const Graph& graph, Graph& result) {
  return graph.space() == GraphSpace::planar
             ? optimizer<mrpt::graphs::CNetworkOfPoses2DInf>(graph, result)
             : optimizer<mrpt::graphs::CNetworkOfPoses3DInf>(graph, result);
}

}  // namespace portolan::bench
