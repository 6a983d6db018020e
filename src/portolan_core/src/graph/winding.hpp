// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graph/block_pattern.hpp"
#include "graph/problem.hpp"
#include "portolan/graph/spanning_tree.hpp"

namespace portolan {

/// A loop in the plane whose turns may add up to a whole turn more, or less, than they do.
struct OtherWinding {
  std::size_t term;  ///< that closes the loop
  double turn;       ///< that would be left over there, instead of up to half a turn [rad]
  double price;      ///< what headings alone would add to chi^2
};

/// The loops that arcs close with a graph's tree, and how turns add up round them. Along the tree
/// they add up from the root, so that what is left is not wrapped: beyond half a turn a loop was
/// wound up. Of headings with all loops wound alike only one choice is the best.
template <class Motion>
class Loops;

template <>
class Loops<PlanarMotion> {
 public:
  using States = std::vector<PlanarMotion::State>;

  /// Both must outlive it.
  Loops(const Problem<PlanarMotion>& problem, const SpanningTree& tree);

  /// By loop: what is left of the turns round it [rad].
  std::vector<double> turns(const States& states) const;
  /// Those that headings would not mind much to see wound another way, by increasing price up to a
  /// highest one; `turns` are those of the states.
  std::vector<OtherWinding> other_windings(const States& states, const std::vector<double>& turns,
                                           double highest_price) const;

 private:
  void find_variances();

  const Problem<PlanarMotion>& problem_;
  const SpanningTree& tree_;
  std::vector<std::size_t> term_to_;  // by pose: the tree's term that leads to it
  std::vector<std::size_t> closing_;  // by loop: the term that closes it
  std::vector<double> variance_;      // by loop: of the turns round it
};

/// In space there are none: turns do not add up there.
template <>
class Loops<SpatialMotion> {
 public:
  using States = std::vector<SpatialMotion::State>;

  Loops(const Problem<SpatialMotion>&, const SpanningTree&) {}
  std::vector<double> turns(const States&) const { return {}; }
  std::vector<OtherWinding> other_windings(const States&, const std::vector<double>&,
                                           double) const {
    return {};
  }
};

/// Whether some loop's turns add up to more than half a turn.
bool is_wound_up(const std::vector<double>& turns);
/// Whether turns round all loops are by the same number of whole turns from nothing.
bool are_wound_alike(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace portolan
