// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "portolan/graph/match/score_pyramid.hpp"
#include "portolan/graph/match/surface.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// How finely poses are tried, and what makes two of them different answers.
struct CorrelativeOptions {
  double resolution = 0.1;
  double blur = 0.1;
  int max_points = 200;
  double min_score = 0.3;
  double rival_distance = 0.7;
  double rival_turn = 0.4;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("resolution", self.resolution, "poses are tried so far from each other [m]", above(0.0));
    visit("blur", self.blur, "deviation of the distance from the surface that still scores [m]",
          above(0.0));
    visit("max_points", self.max_points, "so many points of the source are tried", at_least(3.0));
    visit("min_score", self.min_score, "with less there is no answer; 1: all points on surfaces",
          between(0.0, 1.0));
    visit("rival_distance", self.rival_distance,
          "poses further apart than this are different answers [m]", above(0.0));
    visit("rival_turn", self.rival_turn, "so are poses turned more than this [rad]", above(0.0));
  }
};

/// The poses among which to search: around a first one.
struct SearchWindow {
  double reach = 1.0;  ///< in x and in y [m]
  double turn = 0.8;   ///< of the heading [rad]
};

/// The best answer of a search.
struct Correlation {
  Pose T_target_source = Pose::Identity();
  double score = 0.0;
  double rival = 0.0;               ///< of the best different answer; 0 if below 0.9 of `score`
  Pose T_rival = Pose::Identity();  ///< that answer, where there is one
};

/// Finds where a scan fits best in the plane, whatever the first guess: tries every pose of a
/// window by branch and bound over a pyramid of scores (Olson 2009, Hess et al. 2016). Equal to
/// trying them all, one by one.
class CorrelativeMatcher {
 public:
  /// For windows that reach up to `reach` [m] quickly; larger ones are searched too.
  CorrelativeMatcher(const Surface& target, double reach, const CorrelativeOptions& options);

  /// None where nothing in the window scores enough.
  std::optional<Correlation> search(const Surface& source, const Pose& T_target_source,
                                    const SearchWindow& window) const;

  /// The same without a look at rivals; none where nothing scores more than `floor` either.
  std::optional<Correlation> best(const Surface& source, const Pose& T_target_source,
                                  const SearchWindow& window, double floor) const;

 private:
  CorrelativeOptions options_;
  ScorePyramid pyramid_;
};

}  // namespace portolan
