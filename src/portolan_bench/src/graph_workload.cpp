// SPDX-License-Identifier: BSD-3-Clause
#include "graph_workload.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "portolan/graph/g2o_file.hpp"

namespace portolan::bench {

namespace {

// Measures relative poses of a walk whose true poses are known.
class Walk {
 public:
  Walk(GraphSpace space, double length, double turn)
      : graph_(space), length_(length), turn_(turn) {}

  void go_to(const Pose& T_world_robot) {
    GraphPose pose;
    pose.id = static_cast<PoseId>(truth_.size());
    truth_.push_back(T_world_robot);
    graph_.add(pose);
    if (truth_.size() == 1) return graph_.move(0, T_world_robot);
    const std::size_t last = truth_.size() - 2;
    measure(last, last + 1, ArcKind::odometry);
    graph_.move(last + 1, graph_.poses()[last].T_map_pose * graph_.arcs().back().T_from_to);
  }

  void measure(std::size_t from, std::size_t to, ArcKind kind) {
    Arc arc;
    arc.from = static_cast<PoseId>(from);
    arc.to = static_cast<PoseId>(to);
    arc.kind = kind;
    arc.T_from_to = truth_[from].inverse() * truth_[to] * noise();
    arc.information.diagonal().head<3>().setConstant(1.0 / (length_ * length_));
    arc.information.diagonal().tail<3>().setConstant(1.0 / (turn_ * turn_));
    graph_.add(arc);
  }

  std::size_t size() const { return truth_.size(); }
  const Graph& graph() const { return graph_; }

 private:
  Pose noise() {
    const bool planar = graph_.space() == GraphSpace::planar;
    Eigen::Matrix<double, 6, 1> v;
    for (int i = 0; i < 6; ++i) v[i] = normal_(random_) * (i < 3 ? length_ : turn_);
    if (planar) return planar_pose(v[0], v[1], v[5]);
    const double angle = v.tail<3>().norm();
    return Eigen::Translation3d(v.head<3>()) * Eigen::AngleAxisd(angle, v.tail<3>() / angle);
  }

  std::vector<Pose> truth_;
  Graph graph_;
  double length_;
  double turn_;
  std::mt19937_64 random_{7};
  std::normal_distribution<double> normal_;
};

// A walk through blocks of streets that recognises crossings where it has been before.
Graph streets(std::size_t poses, int side) {
  Walk walk(GraphSpace::planar, 0.05, 0.02);
  std::mt19937_64 random(3);
  std::map<std::pair<int, int>, std::size_t> visited;
  int x = 0;
  int y = 0;
  std::size_t heading = 0;
  constexpr std::array<std::pair<int, int>, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  while (walk.size() < poses) {
    walk.go_to(planar_pose(x, y, M_PI_2 * static_cast<double>(heading)));
    const auto [place, is_new] = visited.try_emplace({x, y}, walk.size() - 1);
    if (!is_new && place->second + 1 < walk.size() - 1) {
      walk.measure(place->second, walk.size() - 1, ArcKind::loop);
    }
    place->second = walk.size() - 1;
    const auto away = [&](std::size_t h) {
      return std::abs(x + kSteps[h].first) > side || std::abs(y + kSteps[h].second) > side;
    };
    if (random() % 3 == 0) heading = (heading + 1 + 2 * (random() % 2)) % 4;
    while (away(heading)) heading = (heading + 1) % 4;
    x += kSteps[heading].first;
    y += kSteps[heading].second;
  }
  return walk.graph();
}

// Laps up a sphere, each pose seen again from the lap above.
Graph sphere(std::size_t laps, std::size_t poses_of_lap) {
  constexpr double kRadius = 50.0;
  Walk walk(GraphSpace::spatial, 0.05, 0.01);
  for (std::size_t i = 0; i < laps * poses_of_lap; ++i) {
    const double around = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(poses_of_lap);
    const double up =
        M_PI * (static_cast<double>(i) / static_cast<double>(laps * poses_of_lap) - 0.5);
    walk.go_to(Eigen::AngleAxisd(around, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(-up, Eigen::Vector3d::UnitY()) *
               Eigen::Translation3d(kRadius, 0.0, 0.0));
    if (i >= poses_of_lap) walk.measure(i - poses_of_lap, i, ArcKind::loop);
  }
  return walk.graph();
}

}  // namespace

std::vector<GraphWorkload> graph_workloads() {
  std::vector<GraphWorkload> all = {{"streets_3500", streets(3500, 20)},
                                    {"streets_10000", streets(10000, 40)},
                                    {"sphere_2500", sphere(50, 50)}};
  const char* files = std::getenv("PORTOLAN_POSE_GRAPHS");
  std::istringstream paths(files == nullptr ? "" : files);
  for (std::string path; std::getline(paths, path, ':');) {
    Graph graph = load_graph(path);
    if (graph.poses().empty()) throw std::runtime_error(path + ": holds no poses");
    all.push_back({std::filesystem::path(path).stem().string(), std::move(graph)});
  }
  return all;
}

}  // namespace portolan::bench
