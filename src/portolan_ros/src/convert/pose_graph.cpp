// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/pose_graph.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "portolan/pose_covariance.hpp"
#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/convert/eigen_messages.hpp"

namespace portolan::ros_convert {

namespace {

using visualization_msgs::Marker;

struct Style {
  const char* name;
  float red, green, blue;
};

constexpr std::array<Style, 6> kStyles{{{"odometry", 0.5F, 0.5F, 0.5F},
                                        {"scan", 0.1F, 0.6F, 0.2F},
                                        {"loop", 0.1F, 0.3F, 0.9F},
                                        {"given", 0.9F, 0.5F, 0.05F},
                                        {"rejected", 0.85F, 0.1F, 0.1F},
                                        {"disabled", 0.2F, 0.1F, 0.1F}}};

std::size_t style_of(const Arc& arc) {
  if (arc.state == ArcState::rejected) return 4;
  if (arc.state == ArcState::disabled) return 5;
  return static_cast<std::size_t>(arc.kind);
}

geometry_msgs::Point point(const Pose& T) { return vector<geometry_msgs::Point>(T.translation()); }

Marker marker(const Style& style, std::int32_t type, double width, const std::string& map_frame) {
  Marker marker;
  marker.header.frame_id = map_frame;
  marker.ns = style.name;
  marker.type = type;
  constexpr double kAboveTheMap = 0.05;  // [m]: in one plane with it, rviz would draw either
  marker.pose.position.z = kAboveTheMap;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = width;
  marker.color.r = style.red;
  marker.color.g = style.green;
  marker.color.b = style.blue;
  marker.color.a = 1.0F;
  return marker;
}

bool can_be_taken_out(const Arc& arc) {
  const bool is_loop = arc.kind == ArcKind::loop || arc.kind == ArcKind::given;
  return is_loop && arc.state == ArcState::accepted;
}

// Half-way along the arc.
Marker index_marker(const Graph& graph, std::size_t index, const std::string& map_frame) {
  constexpr double kHeight = 0.3;  // of a letter [m]
  const Arc& arc = graph.arcs()[index];
  Marker text = marker({"indices", 0.1F, 0.1F, 0.4F}, Marker::TEXT_VIEW_FACING, kHeight, map_frame);
  text.id = static_cast<std::int32_t>(index);
  text.text = std::to_string(index);
  const Eigen::Vector3d p_map =
      (graph.at(arc.from).T_map_pose.translation() + graph.at(arc.to).T_map_pose.translation()) /
      2.0;
  text.pose.position = vector<geometry_msgs::Point>(p_map);
  text.pose.position.z += kHeight;
  return text;
}

}  // namespace

portolan_msgs::GraphArc graph_arc(const Graph& graph, std::size_t index) {
  const Arc& arc = graph.arcs().at(index);
  portolan_msgs::GraphArc message;
  message.index = static_cast<std::uint32_t>(index);
  message.from = arc.from;
  message.to = arc.to;
  message.pose = pose(arc.T_from_to);
  fill(arc.information, message.information);
  message.kind = static_cast<std::uint8_t>(arc.kind);
  message.state = static_cast<std::uint8_t>(arc.state);
  message.reason = enum_names(ArcReason{}).at(static_cast<std::size_t>(arc.reason));
  return message;
}

portolan_msgs::PoseGraph pose_graph(const PoseGraph& graph, const std::string& map_frame) {
  portolan_msgs::PoseGraph message;
  message.header.frame_id = map_frame;
  for (const GraphPose& from : graph.graph().poses()) {
    portolan_msgs::GraphPose to;
    to.id = from.id;
    to.stamp = time(from.stamp);
    to.pose = pose(from.T_map_pose);
    message.poses.push_back(to);
  }
  for (std::size_t i = 0; i < graph.graph().arcs().size(); ++i) {
    message.arcs.push_back(graph_arc(graph.graph(), i));
  }
  message.doubts = "none";
  if (graph.report()) {
    message.chi2 = graph.report()->chi2;
    message.degrees_of_freedom = static_cast<std::uint32_t>(graph.report()->degrees_of_freedom);
    message.doubts = to_string(graph.report()->doubts);
  }
  return message;
}

nav_msgs::Path path(const Graph& graph, const std::string& map_frame) {
  nav_msgs::Path message;
  message.header.frame_id = map_frame;
  for (const GraphPose& from : graph.poses()) {
    geometry_msgs::PoseStamped to;
    to.header.frame_id = map_frame;
    to.header.stamp = time(from.stamp);
    to.pose = pose(from.T_map_pose);
    message.poses.push_back(to);
  }
  return message;
}

std::optional<UncertainPose> guess(const geometry_msgs::PoseWithCovariance& message) {
  using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  constexpr double kVariance = 0.25;         // as rviz states it [m^2]
  constexpr double kTurnVariance = 0.06854;  // likewise: 15 degrees [rad^2]
  PoseCovariance covariance = Eigen::Map<const RowMajor>(message.covariance.data());
  const Pose T = pose(message.pose);
  if (covariance.isZero(0.0)) {
    covariance.diagonal() << kVariance, kVariance, 0.0, 0.0, 0.0, kTurnVariance;
  }
  if (!is_valid(T) || !is_stated(covariance)) return std::nullopt;
  const Pose T_map_base = planar_pose(T.translation().x(), T.translation().y(), yaw(T));
  return UncertainPose{T_map_base, turned(covariance, T_map_base.linear().transpose())};
}

visualization_msgs::MarkerArray graph_markers(const Graph& graph, const std::string& map_frame) {
  visualization_msgs::MarkerArray all;
  for (const Style& style : kStyles) {
    all.markers.push_back(marker(style, Marker::LINE_LIST, 0.05, map_frame));
  }
  for (const Arc& arc : graph.arcs()) {
    Marker& lines = all.markers[style_of(arc)];
    lines.points.push_back(point(graph.at(arc.from).T_map_pose));
    lines.points.push_back(point(graph.at(arc.to).T_map_pose));
  }
  Marker dots = marker({"keyframes", 0.1F, 0.1F, 0.1F}, Marker::POINTS, 0.1, map_frame);
  for (const GraphPose& from : graph.poses()) dots.points.push_back(point(from.T_map_pose));
  all.markers.push_back(dots);
  const auto is_empty = [](const Marker& one) { return one.points.empty(); };
  all.markers.erase(std::remove_if(all.markers.begin(), all.markers.end(), is_empty),
                    all.markers.end());
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    if (can_be_taken_out(graph.arcs()[i])) all.markers.push_back(index_marker(graph, i, map_frame));
  }
  Marker before;
  before.header.frame_id = map_frame;
  before.action = Marker::DELETEALL;
  all.markers.insert(all.markers.begin(), before);
  return all;
}

}  // namespace portolan::ros_convert
