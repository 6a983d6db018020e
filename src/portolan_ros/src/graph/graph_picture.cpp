// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/graph_picture.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "portolan/graph/keyframe_maps.hpp"
#include "portolan_ros/picture.hpp"

namespace portolan {

namespace {

constexpr double kSide = 1400.0;  // [pixel]
constexpr double kMargin = 1.0;   // [m]
constexpr Picture::Colour kPaper{252, 252, 250};
constexpr Picture::Colour kSurface{150, 150, 150};
constexpr Picture::Colour kWay{24, 140, 62};
constexpr Picture::Colour kLoop{38, 90, 220};
constexpr Picture::Colour kRejected{220, 50, 47};

bool is_far(const Arc& arc) { return arc.kind == ArcKind::loop || arc.kind == ArcKind::given; }

Picture::Colour colour(const Arc& arc) {
  if (arc.state != ArcState::accepted) return kRejected;
  return is_far(arc) ? kLoop : kWay;
}

/// A part of the map's plane on paper, y upwards.
class Chart {
 public:
  explicit Chart(const Eigen::AlignedBox2d& box)
      : corner_(box.min().x() - kMargin, box.max().y() + kMargin),
        size_(box.sizes().array() + 2.0 * kMargin),
        scale_(kSide / size_.maxCoeff()),
        picture_(static_cast<std::size_t>(size_.x() * scale_) + 1,
                 static_cast<std::size_t>(size_.y() * scale_) + 1, kPaper) {}

  void point(const Eigen::Vector2d& p_map, Picture::Colour colour) {
    const Eigen::Vector2d at = pixel(p_map);
    picture_.set(std::llround(std::floor(at.x())), std::llround(std::floor(at.y())), colour);
  }

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Picture::Colour colour) {
    const Eigen::Vector2d a = pixel(from);
    const Eigen::Vector2d b = pixel(to);
    picture_.line(a.x(), a.y(), b.x(), b.y(), colour);
  }

  std::string png() const { return picture_.png(); }

 private:
  Eigen::Vector2d pixel(const Eigen::Vector2d& p_map) const {
    return {(p_map.x() - corner_.x()) * scale_, (corner_.y() - p_map.y()) * scale_};
  }

  Eigen::Vector2d corner_;  // upper left [m]
  Eigen::Vector2d size_;    // [m]
  double scale_;            // [pixel/m]
  Picture picture_;
};

Eigen::Vector2d place(const GraphPose& pose) { return pose.T_map_pose.translation().head<2>(); }

}  // namespace

std::vector<Eigen::Vector2d> surfaces_of(const PoseGraph& graph) {
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

std::string graph_picture(const Graph& graph, const std::vector<Eigen::Vector2d>& surfaces) {
  if (graph.poses().empty()) return {};
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : surfaces) box.extend(p);
  for (const GraphPose& pose : graph.poses()) box.extend(place(pose));
  Chart chart(box);
  for (const Eigen::Vector2d& p : surfaces) chart.point(p, kSurface);
  for (const bool accepted : {false, true}) {
    for (const Arc& arc : graph.arcs()) {
      if ((arc.state == ArcState::accepted) != accepted) continue;
      chart.line(place(graph.at(arc.from)), place(graph.at(arc.to)), colour(arc));
    }
  }
  return chart.png();
}

}  // namespace portolan
