// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/loop/loop_options.hpp"
#include "portolan/graph/match/icp.hpp"
#include "portolan/graph/match/scan_surface.hpp"
#include "portolan/graph/optimizer_options.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// When a moment of the trajectory is remembered.
struct KeyframeOptions {
  double min_travel = 0.5;
  double min_turn = 0.35;
  double min_interval = 0.0;
  int max_count = 20000;
  double scan_budget = 256.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_travel", self.min_travel, "a keyframe after so much way [m]", above(0.0));
    visit("min_turn", self.min_turn, "or after such a turn [rad]", above(0.0));
    visit("min_interval", self.min_interval,
          "or after so much time, if the robot has moved by a tenth of the others at least; 0: do "
          "not wait for it [s]",
          at_least(0.0));
    visit(
        "max_count", self.max_count,
        "keyframes at most; then some are dropped where the robot has been again since, and poses "
        "and arcs are numbered anew; what comes where none can go is rejected",
        at_least(2.0));
    visit("scan_budget", self.scan_budget,
          "memory for scans; past it the oldest are forgotten, and their places no longer found "
          "again [MB]",
          above(0.0));
  }
};

/// How far odometry may be believed: errors add up as a random walk does.
struct OdometryNoise {
  double position = 0.05;
  double heading = 0.02;
  double turn = 0.05;
  double delay = 0.05;
  double max_speed = 5.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("position", self.position, "deviation per root of the way [m/sqrt(m)]", above(0.0));
    visit("heading", self.heading, "deviation per root of the way [rad/sqrt(m)]", above(0.0));
    visit("turn", self.turn, "deviation per root of the turn [rad/sqrt(rad)]", at_least(0.0));
    visit("delay", self.delay, "deviation of its stamps from the scans' [s]", at_least(0.0));
    visit("max_speed", self.max_speed,
          "odometry that moves faster has jumped, and counts for next to nothing [m/s]",
          above(0.0));
  }
};

/// How a new keyframe is matched with those before it.
struct ScanMatchOptions {
  bool enabled = true;
  double map_way = 8.0;
  double min_overlap = 0.5;
  double sure_overlap = 0.7;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("enabled", self.enabled, "match each keyframe with those before it");
    visit("map_way", self.map_way, "a scan is matched with those of so much way before it [m]",
          at_least(0.0));
    visit("min_overlap", self.min_overlap, "share of a scan's points that must fit",
          within(0.0, 1.0));
    visit("sure_overlap", self.sure_overlap,
          "share from which on a scan is believed even where odometry contradicts; above 1: never",
          at_least(0.0));
  }
};

/// How a `PoseGraph` is built; it calls them `Options`.
struct PoseGraphOptions {
  KeyframeOptions keyframes;
  OdometryNoise odometry;
  SurfaceOptions surfaces;
  IcpOptions icp;
  ScanMatchOptions scans;
  LoopOptions loops;
  OptimizerOptions optimizer = started_as_given();

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("keyframes", self.keyframes, "which moments are remembered");
    visit("odometry", self.odometry, "how far odometry is believed");
    visit("surfaces", self.surfaces, "what of a scan is matched");
    visit("icp", self.icp, "how scans are brought onto each other");
    visit("scans", self.scans, "arcs between neighbouring keyframes");
    visit("loops", self.loops, "arcs to earlier visits");
    visit("optimizer", self.optimizer, "how coordinates are made consistent");
  }

 private:
  static OptimizerOptions started_as_given() {
    OptimizerOptions optimizer;
    optimizer.start = GraphStart::as_given;
    return optimizer;
  }
};

}  // namespace portolan
