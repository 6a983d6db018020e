// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "portolan/correction.hpp"
#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/keyframe_maps.hpp"
#include "portolan/graph/loop/consensus.hpp"
#include "portolan/graph/optimizer_report.hpp"
#include "portolan/graph/pose_graph_options.hpp"
#include "portolan/outcome.hpp"

namespace portolan {

struct SavedScan;

/// How far a robot's odometry has drifted, found from what it saw again: keyframes, arcs between
/// them, and the coordinates that contradict the arcs least (chapter 8's pose constraint maps).
///
/// The coordinates follow from the keyframes and the accepted arcs alone, not from the order in
/// which these came: whoever disables a loop gets back, bit for bit, what was there without it.
class PoseGraph {
 public:
  using Options = PoseGraphOptions;

  /// Throws OptionsError.
  explicit PoseGraph(const Options& options);

  /// Takes what a planar sensor saw from a pose. None where no keyframe is due; rejected where
  /// stamps do not increase or the graph is full; unusable where scan or poses are malformed.
  std::optional<Outcome> insert(Time stamp, const Pose& T_odom_base, const RangeScan& scan,
                                const Pose& T_base_sensor);

  /// Adds an arc that somebody else knows of, and returns its index. It is held to what the graph
  /// and the scans say, and accepted or rejected with the reason; `force` accepts it unseen. Throws
  /// std::invalid_argument as `Graph::add` does.
  std::size_t add(PoseId from, PoseId to, const Pose& T_from_to, const TangentMatrix& information,
                  bool force);

  /// Takes a loop or given arc out of the coordinates, or into them. Throws std::out_of_range for
  /// no such arc, std::invalid_argument for arcs between neighbours and for what is no information.
  void disable(std::size_t arc);
  void enable(std::size_t arc);

  /// Goes on from a graph that was saved, without its scans. Nobody saw the robot meanwhile: to the
  /// next keyframe odometry says where to look first, and next to nothing besides. Throws
  /// std::invalid_argument where it is no graph of this kind: ids from 0 on, increasing stamps, an
  /// accepted arc of odometry between neighbours.
  static PoseGraph restored(const Options& options, const Graph& graph);
  /// Gives keyframes the scans that were saved with the graph, so that their places can be found
  /// again. Throws std::invalid_argument where one is of no keyframe, or of another moment.
  void recall(std::vector<SavedScan> scans);

  /// T_map_odom with a knot at each keyframe.
  Correction correction() const;

  const Graph& graph() const { return graph_; }
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }

  /// Counts how often poses that were there before were moved.
  std::size_t generation() const { return generation_; }
  /// What the optimiser thought of the last coordinates that it made; none without loops.
  const std::optional<OptimizerReport>& report() const { return report_; }
  /// Keyframes whose scans were forgotten to stay within the budget.
  std::size_t forgotten() const { return forgotten_; }
  const Options& options() const { return options_; }

 private:
  PlacedKeyframes placed() const { return {keyframes_, graph_}; }
  bool is_due(Time stamp, const Pose& T_odom_base) const;
  double way_to(const Pose& T_odom_base) const;
  void connect();
  void forget_scans();
  bool has_enough_loops(std::size_t here) const;
  void look_for_loops();
  void accept(const std::vector<std::size_t>& arcs);
  void change(std::size_t arc, ArcState state);
  void settle();
  void place_after(std::size_t keyframe);
  bool closes(const Arc& arc) const;
  std::vector<Link> links(std::size_t count) const;

  Options options_;
  Graph graph_;
  std::vector<Keyframe> keyframes_;
  std::vector<UncertainPose> steps_;  // each keyframe from the one before
  Chain chain_;
  double looked_ = 0.0;  // way at which loops were last looked for [m]
  std::size_t scan_bytes_ = 0;
  std::size_t forgotten_ = 0;
  bool is_resumed_ = false;  // no keyframe has come since the graph was restored
  std::size_t generation_ = 0;
  std::optional<OptimizerReport> report_;
};

}  // namespace portolan
