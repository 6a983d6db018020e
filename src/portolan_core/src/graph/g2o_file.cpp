// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/g2o_file.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <stdexcept>

#include "graph/g2o_reader.hpp"
#include "graph/text_numbers.hpp"

namespace portolan {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
const std::array<int, 3> kPlanar = {0, 1, 5};  // of a tangent

template <class Numbers>
std::string listed(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) text += " " + to_text(number);
  return text;
}

std::string spatial_text(const Pose& pose) {
  const Eigen::Quaterniond q = rounded_quaternion(pose);
  const auto& t = pose.translation();
  return listed(std::array<double, 7>{t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()});
}

std::string pose_text(const Pose& pose, GraphSpace space) {
  if (space == GraphSpace::spatial) return spatial_text(pose);
  const auto& t = pose.translation();
  return listed(std::array<double, 3>{t.x(), t.y(), rounded_heading(pose)});
}

std::string information_text(const TangentMatrix& information, GraphSpace space) {
  std::string text;
  const int size = space == GraphSpace::planar ? 3 : 6;
  for (int i = 0; i < size; ++i) {
    for (int j = i; j < size; ++j) {
      const int row = size == 3 ? kPlanar[static_cast<std::size_t>(i)] : i;
      const int column = size == 3 ? kPlanar[static_cast<std::size_t>(j)] : j;
      text += " " + to_text(information(row, column));
    }
  }
  return text;
}

template <class Enum>
std::string name(Enum value) {
  return std::string(" ") + enum_names(value)[static_cast<std::size_t>(value)];
}

// What a reader would not know from the arc's line.
std::string note(const Arc& arc) {
  const ArcKind kind = arc.to - 1 == arc.from ? ArcKind::odometry : ArcKind::loop;
  const bool plain = arc.kind == kind && arc.reason == ArcReason::none;
  if (arc.state == ArcState::accepted && plain) return "";
  const char* end = arc.state == ArcState::accepted ? "\n" : " ";
  return "# portolan" + name(arc.kind) + name(arc.state) + name(arc.reason) + end;
}

std::map<PoseId, Time> parse_stamps(const std::string& text) {
  std::map<PoseId, Time> stamps;
  std::istringstream lines(text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line);
    std::string id;
    std::string stamp;
    std::string rest;
    if (!(words >> id) || id[0] == '#') continue;
    const bool two = (words >> stamp) && !(words >> rest);
    const std::optional<PoseId> pose = integer_in(id);
    const std::optional<Time> time = two ? stamp_in(stamp) : std::nullopt;
    if (!pose || !time || !stamps.emplace(*pose, *time).second) {
      throw std::runtime_error("stamps, line " + std::to_string(number) +
                               ": must be an id, once, and a stamp in seconds");
    }
  }
  return stamps;
}

}  // namespace

std::string to_g2o(const Graph& graph) {
  const bool planar = graph.space() == GraphSpace::planar;
  const std::string vertex = planar ? "VERTEX_SE2 " : "VERTEX_SE3:QUAT ";
  const std::string edge = planar ? "EDGE_SE2 " : "EDGE_SE3:QUAT ";
  std::string text;
  for (const GraphPose& pose : graph.poses()) {
    text += vertex + std::to_string(pose.id) + pose_text(pose.T_map_pose, graph.space()) + "\n";
  }
  for (const GraphPose& pose : graph.poses()) {
    if (pose.fixed) text += "FIX " + std::to_string(pose.id) + "\n";
  }
  for (const Arc& arc : graph.arcs()) {
    text += note(arc) + edge + std::to_string(arc.from) + " " + std::to_string(arc.to) +
            pose_text(arc.T_from_to, graph.space()) +
            information_text(arc.information, graph.space()) + "\n";
  }
  return text;
}

Graph graph_from_g2o(const std::string& g2o, const std::string& stamps) {
  G2oReader reader(parse_stamps(stamps));
  std::size_t begin = 0;
  while (begin < g2o.size()) {
    const std::size_t end = std::min(g2o.find('\n', begin), g2o.size());
    reader.read(g2o.substr(begin, end - begin));
    begin = end + 1;
  }
  return reader.graph();
}

std::string stamps_text(const Graph& graph) {
  std::string text;
  for (const GraphPose& pose : graph.poses()) {
    text += std::to_string(pose.id) + " " + to_text(pose.stamp) + "\n";
  }
  return text;
}

std::string to_tum(const Graph& graph) {
  std::vector<GraphPose> poses = graph.poses();
  std::stable_sort(poses.begin(), poses.end(),
                   [](const GraphPose& a, const GraphPose& b) { return a.stamp < b.stamp; });
  std::string text;
  for (const GraphPose& pose : poses) {
    text += to_text(pose.stamp) + spatial_text(pose.T_map_pose) + "\n";
  }
  return text;
}

FileSet graph_files(const Graph& graph, const std::string& name) {
  return {{name + ".g2o", to_g2o(graph)}, {name + ".stamps", stamps_text(graph)}};
}

Graph load_graph(const std::filesystem::path& g2o) try {
  std::filesystem::path stamps = g2o;
  stamps.replace_extension(".stamps");
  if (stamps == g2o || !std::filesystem::exists(stamps)) {
    return graph_from_g2o(load_file(g2o, kMaxBytes));
  }
  const std::filesystem::path folder = g2o.has_parent_path() ? g2o.parent_path() : ".";
  const FileSet files = load_files(folder, {g2o.filename(), stamps.filename()}, kMaxBytes);
  return graph_from_g2o(files.at(g2o.filename()), files.at(stamps.filename()));
} catch (const std::runtime_error& error) {
  const std::string what = error.what();
  const bool named = what.find(g2o.filename().string()) != std::string::npos;
  throw std::runtime_error(named ? what : g2o.string() + ": " + what);
}

}  // namespace portolan
