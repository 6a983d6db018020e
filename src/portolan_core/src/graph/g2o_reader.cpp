// SPDX-License-Identifier: BSD-3-Clause
#include "graph/g2o_reader.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "graph/text_numbers.hpp"
#include "portolan/graph/spanning_tree.hpp"

namespace portolan {

namespace {

const std::array<int, 3> kPlanar = {0, 1, 5};  // of a tangent

[[noreturn]] void refuse(std::size_t line, const std::string& fault) {
  throw std::runtime_error("line " + std::to_string(line) + ": " + fault);
}

std::vector<std::string> words_of(const std::string& line) {
  constexpr const char* kSpace = " \t\r\f\v";
  std::vector<std::string> words;
  for (std::size_t end = 0;;) {
    const std::size_t begin = line.find_first_not_of(kSpace, end);
    if (begin == std::string::npos) return words;
    end = std::min(line.find_first_of(kSpace, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
  }
}

// The value of that name.
template <class Enum>
bool named(const std::string& word, Enum& value) {
  const auto names = enum_names(value);
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) return false;
  value = static_cast<Enum>(found - names.begin());
  return true;
}

std::size_t pose_size(GraphSpace space) { return space == GraphSpace::planar ? 3 : 7; }
std::size_t information_size(GraphSpace space) { return space == GraphSpace::planar ? 6 : 21; }

// Calls that name no arc or pose get the number of their line.
template <class Call>
void at_line(std::size_t line, const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& fault) {
    refuse(line, fault.what());
  }
}

}  // namespace

void G2oReader::require(bool holds, const std::string& fault) const {
  if (!holds) refuse(line_, fault);
}

double G2oReader::number(const std::string& word) const {
  const std::optional<double> value = number_in(word);
  require(value.has_value(), "'" + word + "' is no finite number");
  return *value;
}

PoseId G2oReader::id(const std::string& word) const {
  const std::optional<std::int64_t> value = integer_in(word);
  require(value.has_value(), "'" + word + "' is no id");
  return *value;
}

void G2oReader::read(const std::string& line) {
  ++line_;
  const Words words = words_of(line);
  if (words.empty()) return;
  if (words[0][0] == '#') return read_comment(words);
  read_words(words);
}

void G2oReader::read_words(const Words& words) {
  if (words[0] == "VERTEX_SE2") return read_vertex(words, GraphSpace::planar);
  if (words[0] == "VERTEX_SE3:QUAT") return read_vertex(words, GraphSpace::spatial);
  if (words[0] == "EDGE_SE2") return read_edge(words, GraphSpace::planar);
  if (words[0] == "EDGE_SE3:QUAT") return read_edge(words, GraphSpace::spatial);
  if (words[0] == "FIX") return read_fix(words);
  require(words[0].compare(0, 6, "PARAMS") == 0, "'" + words[0] + "' is not of a pose graph");
}

// # portolan KIND STATE REASON, and the arc itself if it is not accepted.
void G2oReader::read_comment(const Words& words) {
  if (words[0] != "#" || words.size() < 2 || words[1] != "portolan") return;
  Arc note;
  require(words.size() >= 5 && named(words[2], note.kind) && named(words[3], note.state) &&
              named(words[4], note.reason),
          "after '# portolan' must come an arc's kind, state and reason");
  noted_.assign(1, note);
  if (note.state == ArcState::accepted) {
    require(words.size() == 5, "an accepted arc is no comment");
    return;
  }
  require(words.size() > 5, "an arc that is not accepted must be in its comment");
  read_words({words.begin() + 5, words.end()});
  require(noted_.empty(), "'" + words[5] + "' is no arc");
}

void G2oReader::read_vertex(const Words& words, GraphSpace space) {
  require(words.size() == 2 + pose_size(space),
          words[0] + " must have an id and " + std::to_string(pose_size(space)) + " numbers");
  Vertex vertex{{line_, space}, {}};
  vertex.pose.id = id(words[1]);
  vertex.pose.T_map_pose = read_pose(words, 2, space);
  const auto stamp = stamps_.find(vertex.pose.id);
  if (stamp != stamps_.end()) vertex.pose.stamp = stamp->second;
  vertices_.push_back(vertex);
}

void G2oReader::read_edge(const Words& words, GraphSpace space) {
  const std::size_t numbers = pose_size(space) + information_size(space);
  require(words.size() == 3 + numbers,
          words[0] + " must have two ids and " + std::to_string(numbers) + " numbers");
  Edge edge{{line_, space}, {}};
  if (!noted_.empty()) edge.arc = noted_.front();
  edge.arc.from = id(words[1]);
  edge.arc.to = id(words[2]);
  edge.arc.T_from_to = read_pose(words, 3, space);
  edge.arc.information = read_information(words, 3 + pose_size(space), space);
  if (noted_.empty()) {
    const bool next = edge.arc.to - 1 == edge.arc.from;
    edge.arc.kind = next ? ArcKind::odometry : ArcKind::loop;
  }
  noted_.clear();
  edges_.push_back(edge);
}

void G2oReader::read_fix(const Words& words) {
  require(words.size() > 1, "FIX must name a pose");
  for (std::size_t i = 1; i < words.size(); ++i) fixes_.push_back({line_, id(words[i])});
}

Pose G2oReader::read_pose(const Words& words, std::size_t first, GraphSpace space) const {
  std::array<double, 7> x{};
  for (std::size_t i = 0; i < pose_size(space); ++i) x[i] = number(words[first + i]);
  if (space == GraphSpace::planar) return planar_pose(x[0], x[1], x[2]);
  const Eigen::Quaterniond q(x[6], x[3], x[4], x[5]);
  require(q.norm() > 1e-3 && std::isfinite(q.squaredNorm()), "the quaternion is no rotation");
  return spatial_pose({x[0], x[1], x[2]}, q);
}

TangentMatrix G2oReader::read_information(const Words& words, std::size_t first,
                                          GraphSpace space) const {
  TangentMatrix information = TangentMatrix::Zero();
  const int size = space == GraphSpace::planar ? 3 : 6;
  for (int i = 0; i < size; ++i) {
    for (int j = i; j < size; ++j) {
      const int row = size == 3 ? kPlanar[static_cast<std::size_t>(i)] : i;
      const int column = size == 3 ? kPlanar[static_cast<std::size_t>(j)] : j;
      information(row, column) = number(words[first++]);
      information(column, row) = information(row, column);
    }
  }
  return information;
}

Graph G2oReader::graph() const {
  require(noted_.empty(), "no arc comes after the comment about one");
  const bool planar = !vertices_.empty() ? vertices_[0].space == GraphSpace::planar
                                         : edges_.empty() || edges_[0].space == GraphSpace::planar;
  Graph graph(planar ? GraphSpace::planar : GraphSpace::spatial);
  const auto require_space = [&](const Line& line) {
    if (line.space != graph.space()) refuse(line.number, "SE2 and SE3 in one file");
  };
  for (const Vertex& vertex : vertices_) require_space(vertex);
  for (const Edge& edge : edges_) require_space(edge);
  add_poses(graph);
  for (const Edge& edge : edges_) {
    at_line(edge.number, [&] { graph.add(edge.arc); });
  }
  for (const Fix& fix : fixes_) {
    const std::optional<std::size_t> pose = graph.find(fix.id);
    if (!pose) refuse(fix.number, "FIX of a pose that is not there");
    graph.fix(*pose, true);
  }
  if (vertices_.empty()) place_along(spanning_tree(graph), graph);
  return graph;
}

// By increasing id, so that none has to be moved out of the way; of two the later one is refused.
void G2oReader::add_poses(Graph& graph) const {
  std::vector<Vertex> sorted = vertices_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Vertex& a, const Vertex& b) { return a.pose.id < b.pose.id; });
  for (const Vertex& vertex : sorted) {
    at_line(vertex.number, [&] { graph.add(vertex.pose); });
  }
  if (!vertices_.empty()) return;
  std::set<PoseId> named;
  for (const Edge& edge : edges_) named.insert({edge.arc.from, edge.arc.to});
  for (const PoseId id : named) {
    GraphPose pose;
    pose.id = id;
    const auto stamp = stamps_.find(id);
    if (stamp != stamps_.end()) pose.stamp = stamp->second;
    graph.add(pose);
  }
}

}  // namespace portolan
