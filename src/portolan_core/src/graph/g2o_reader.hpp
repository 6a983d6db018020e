// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "portolan/graph/graph.hpp"

namespace portolan {

/// Gathers what the lines of a g2o file say, and makes a graph of it in the end. Every fault is a
/// std::runtime_error with the number of its line.
class G2oReader {
 public:
  explicit G2oReader(std::map<PoseId, Time> stamps) : stamps_(std::move(stamps)) {}

  void read(const std::string& line);
  Graph graph() const;

 private:
  using Words = std::vector<std::string>;
  struct Line {
    std::size_t number;
    GraphSpace space;
  };
  struct Vertex : Line {
    GraphPose pose;
  };
  struct Edge : Line {
    Arc arc;
  };
  struct Fix {
    std::size_t number;
    PoseId id;
  };

  void read_words(const Words& words);
  void read_comment(const Words& words);
  void read_vertex(const Words& words, GraphSpace space);
  void read_edge(const Words& words, GraphSpace space);
  void read_fix(const Words& words);
  Pose read_pose(const Words& words, std::size_t first, GraphSpace space) const;
  TangentMatrix read_information(const Words& words, std::size_t first, GraphSpace space) const;
  double number(const std::string& word) const;
  PoseId id(const std::string& word) const;
  void require(bool holds, const std::string& fault) const;
  void add_poses(Graph& graph) const;

  std::map<PoseId, Time> stamps_;
  std::size_t line_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<Fix> fixes_;
  std::vector<Arc> noted_;  // what a comment said of the next arc; at most one
};

}  // namespace portolan
