// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "portolan/graph/keyframe_maps.hpp"
#include "portolan/graph/match/correlative.hpp"
#include "portolan/graph/pose_graph_options.hpp"

namespace portolan {

/// Looks for a robot whose place in a graph is not known in all of that graph: compares what it
/// sees with every place there, a few places at a time.
class PlaceSearch {
 public:
  /// Nobody knows how the robot came to keyframe `begin`, and it is looked for among those before.
  explicit PlaceSearch(std::size_t begin = 0) : begin_(begin) {}

  std::size_t begin() const { return begin_; }
  /// Counts how often all places were compared.
  std::size_t rounds() const { return rounds_; }

  /// The keyframes are numbered anew: begins its round again.
  void restart(std::size_t begin);

  /// Goes on by a few places. A round compares all of them with what was newest when it began; at
  /// its end comes an unconfirmed loop, if one place stands up to all questions that are asked of
  /// a loop and no other that does fits nearly as well.
  std::optional<Arc> go_on(const PlacedKeyframes& placed, const PoseGraphOptions& options);

 private:
  // Where `here_` may be.
  struct Hit {
    std::size_t place = 0;
    Pose T_place_here = Pose::Identity();
    double score = 0.0;
  };

  double best_score() const;
  void compare(const PlacedKeyframes& placed, const LocalMap& here,
               const PoseGraphOptions& options);
  std::vector<Hit> distinct(const PlacedKeyframes& placed, std::size_t count,
                            const CorrelativeOptions& options) const;
  void add_rivals(const PlacedKeyframes& placed, const LocalMap& here,
                  const PoseGraphOptions& options);
  void refine(const PlacedKeyframes& placed, const LocalMap& here, const PoseGraphOptions& options);
  std::optional<Arc> verdict(const PlacedKeyframes& placed, const LocalMap& here,
                             const PoseGraphOptions& options) const;

  std::size_t begin_;
  std::size_t rounds_ = 0;
  std::size_t here_ = 0;
  std::vector<std::size_t> places_;  // still to be compared in this round, the last one first
  std::vector<Hit> hits_;
};

}  // namespace portolan
