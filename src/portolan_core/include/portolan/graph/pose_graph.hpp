// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "portolan/correction.hpp"
#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/keyframe_maps.hpp"
#include "portolan/graph/loop/consensus.hpp"
#include "portolan/graph/loop/place_search.hpp"
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
  /// stamps do not increase, or where the graph is full and can do without no keyframe; unusable
  /// where scan or poses are malformed. A full graph drops what it can do without
  /// (`spare_keyframes`): poses and arcs are numbered anew then.
  std::optional<Outcome> insert(Time stamp, const Pose& T_odom_base, const RangeScan& scan,
                                const Pose& T_base_sensor);

  /// Somebody says where the robot is, who may have carried it there. The next scan, or the first
  /// one not older than `since`, is a keyframe from there on, whatever odometry says. What was said
  /// is a given arc to it, never surer than a good guess, and loops decide. Rejected while there is
  /// no keyframe yet, unusable where it is no pose or no covariance.
  Outcome expect(const UncertainPose& T_map_base, Time since = Time{});

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
  /// next keyframe odometry says where to look first, and next to nothing besides; where it is not
  /// found, it is looked for in the whole graph. Throws
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

  /// Nobody knows how the robot came here, to the newest keyframe, from where it was before:
  /// nothing that was seen since then has held the one to the other yet.
  bool is_lost() const;

  /// Counts how often poses that were there before were moved, or numbered anew.
  std::size_t generation() const { return generation_; }
  /// What the optimiser thought of the last coordinates that it made; none without loops.
  const std::optional<OptimizerReport>& report() const { return report_; }
  /// Keyframes whose scans were forgotten to stay within the budget.
  std::size_t forgotten() const { return forgotten_; }
  /// Keyframes that were dropped to stay within their number, and rejected loops with them.
  std::size_t dropped() const { return dropped_; }
  std::size_t dropped_loops() const { return dropped_loops_; }
  const Options& options() const { return options_; }

 private:
  PlacedKeyframes placed() const { return {keyframes_, graph_}; }
  bool is_told(Time stamp) const { return told_ && stamp >= told_since_; }
  static bool is_near(const Pose& a, const Pose& b);
  bool is_due(Time stamp, const Pose& T_odom_base) const;
  double way_to(const Pose& T_odom_base) const;
  void connect();
  void add_guess(const Pose& T_map_base, const TangentMatrix& covariance);
  void step_on(const UncertainPose& step);
  void forget_scans();
  bool make_room();
  void drop(const std::vector<std::size_t>& spare);
  void drop_keyframes(const std::vector<std::size_t>& spare);
  bool has_enough_loops(std::size_t here) const;
  std::vector<std::optional<UncertainPose>> seen_from(std::size_t now) const;
  std::vector<std::optional<UncertainPose>> seen_as_suspected(std::size_t now) const;
  PoseGraphOptions strict() const;
  void look_for_loops();
  void look_everywhere();
  void compare_visits(const std::vector<std::optional<UncertainPose>>& T_now,
                      const PoseGraphOptions& options);
  void take(const Arc& loop, const PoseGraphOptions& options);
  bool is_first_round() const;
  void confirm(std::size_t arc, const PoseGraphOptions& options);
  void confirm_guess();
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
  std::size_t dropped_ = 0;
  std::size_t dropped_loops_ = 0;
  bool is_resumed_ = false;               // no keyframe has come since the graph was restored
  std::optional<UncertainPose> told_;     // where the next keyframe is said to be
  Time told_since_{};                     // which is not older than this
  PlaceSearch search_;                    // for the newest keyframes, among those before a gap
  bool has_guess_ = false;                // of where they are
  bool is_searched_ = false;              // there, since nobody said it
  std::optional<std::size_t> suspected_;  // arc to where they may be
  std::size_t generation_ = 0;
  std::optional<OptimizerReport> report_;
};

}  // namespace portolan
