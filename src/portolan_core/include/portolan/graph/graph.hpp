// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "portolan/graph/arc.hpp"
#include "portolan/time.hpp"

namespace portolan {

/// How a pose can move: x, y and heading, or all six ways.
enum class GraphSpace { planar, spatial };

constexpr std::array<const char*, 2> enum_names(GraphSpace) { return {"planar", "spatial"}; }

/// A pose of the robot that a graph remembers: chapter 8's node.
struct GraphPose {
  PoseId id = 0;
  Time stamp{};
  Pose T_map_pose = Pose::Identity();
  /// Stays where it is. Of a graph without any, the pose of the lowest id stays.
  bool fixed = false;
};

/// A pose constraint map: poses, and arcs that say where they lie from each other.
/// Poses are kept by increasing id, arcs in the order they came in; nothing is ever removed.
class Graph {
 public:
  explicit Graph(GraphSpace space = GraphSpace::planar) : space_(space) {}

  /// In `planar`, z, roll and pitch of poses and arcs do not count.
  GraphSpace space() const { return space_; }

  /// Throws std::invalid_argument for an id that is there already and a pose that is not rigid.
  void add(const GraphPose& pose);
  /// Returns the arc's index. Throws std::invalid_argument where an end is not in the graph, both
  /// are the same, or T_from_to is not rigid. With information that is no information, the arc
  /// comes in as rejected, `bad_information`.
  std::size_t add(const Arc& arc);

  const std::vector<GraphPose>& poses() const { return poses_; }
  const std::vector<Arc>& arcs() const { return arcs_; }

  /// Where in `poses()` the pose is; none if it is not there.
  std::optional<std::size_t> find(PoseId id) const;
  /// Throws std::out_of_range.
  const GraphPose& at(PoseId id) const;

  /// Moves the pose at an index of `poses()`. Throws std::out_of_range.
  void move(std::size_t pose, const Pose& T_map_pose) { poses_.at(pose).T_map_pose = T_map_pose; }
  void fix(std::size_t pose, bool fixed) { poses_.at(pose).fixed = fixed; }
  /// Changes whether and why an arc counts; by index of `arcs()`. Throws std::out_of_range.
  void set_state(std::size_t arc, ArcState state, ArcReason reason);

 private:
  GraphSpace space_;
  std::vector<GraphPose> poses_;  // by increasing id
  std::vector<Arc> arcs_;
};

}  // namespace portolan
