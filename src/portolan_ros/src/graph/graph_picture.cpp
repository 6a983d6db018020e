// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "portolan/graph/keyframe_maps.hpp"
#include "portolan_ros/graph/graph_keeper.hpp"
#include "portolan_ros/picture.hpp"

namespace portolan {

namespace {

constexpr double kSide = 1400.0;  // [pixel]
constexpr Picture::Colour kPaper{252, 252, 250};
constexpr Picture::Colour kSurface{150, 150, 150};
constexpr Picture::Colour kWay{24, 140, 62};
constexpr Picture::Colour kLoop{38, 90, 220};
constexpr Picture::Colour kRejected{220, 50, 47};

std::vector<Eigen::Vector2d> surfaces(const PoseGraph& graph) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < graph.keyframes().size(); ++i) {
    const Keyframe& keyframe = graph.keyframes()[i];
    const Pose T = graph.graph().poses()[i].T_map_pose * keyframe.T_base_sensor;
    for (const Eigen::Vector3d& p : scan_surface(keyframe.scan, graph.options().surfaces).points) {
      points.emplace_back((T * p).head<2>());
    }
  }
  return points;
}

bool is_far(const Arc& arc) { return arc.kind == ArcKind::loop || arc.kind == ArcKind::given; }

Picture::Colour colour(const Arc& arc) {
  if (arc.state != ArcState::accepted) return kRejected;
  return is_far(arc) ? kLoop : kWay;
}

}  // namespace

std::string graph_picture(const PoseGraph& graph) {
  if (graph.keyframes().empty()) return {};
  const std::vector<Eigen::Vector2d> points = surfaces(graph);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : points) box.extend(p);
  for (const GraphPose& pose : graph.graph().poses()) {
    box.extend(Eigen::Vector2d(pose.T_map_pose.translation().head<2>()));
  }
  const Eigen::Vector2d corner(box.min().x() - 1.0, box.max().y() + 1.0);
  const Eigen::Vector2d size = box.sizes().array() + 2.0;
  const double scale = kSide / size.maxCoeff();
  Picture picture(static_cast<std::size_t>(size.x() * scale) + 1,
                  static_cast<std::size_t>(size.y() * scale) + 1, kPaper);
  const auto pixel = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d((p.x() - corner.x()) * scale, (corner.y() - p.y()) * scale);
  };
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d at = pixel(p);
    picture.set(static_cast<std::int64_t>(at.x()), static_cast<std::int64_t>(at.y()), kSurface);
  }
  const Graph& all = graph.graph();
  for (const bool accepted : {false, true}) {
    for (const Arc& arc : all.arcs()) {
      if ((arc.state == ArcState::accepted) != accepted) continue;
      const auto at = [&](PoseId id) {
        return pixel(all.at(id).T_map_pose.translation().head<2>());
      };
      const Eigen::Vector2d a = at(arc.from);
      const Eigen::Vector2d b = at(arc.to);
      picture.line(a.x(), a.y(), b.x(), b.y(), colour(arc));
    }
  }
  return picture.png();
}

}  // namespace portolan
