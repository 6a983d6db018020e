// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "graph/arc_differences.hpp"
#include "graph/winding.hpp"

namespace portolan {

/// Coordinates by linear least squares: orientations first, and with these the positions.
/// Everything returns false where arcs leave a pose undetermined.
template <class Motion>
class LinearStart {
 public:
  using States = std::vector<typename Motion::State>;

  /// Both must outlive it.
  LinearStart(const Problem<Motion>& problem, const BlockPattern& pattern)
      : problem_(problem), pattern_(pattern) {}

  /// In the plane headings that agree best with loops wound as they are, so that the start counts;
  /// in space as if rotation matrices could be any, each then made the rotation next to it.
  bool orient(States& states);
  /// In the plane the same with one loop wound the other way.
  bool rewind(const OtherWinding& winding, States& states);
  /// Turns poses until the turns along arcs agree as well as they do anywhere near.
  bool average_turns(States& states);
  /// Positions, with orientations as they are.
  bool put_in_place(States& states);

 private:
  const ArcDifferences<Motion>& turns();
  const ArcDifferences<Motion>& positions();
  double turn(States& states, const OtherWinding* winding);

  const Problem<Motion>& problem_;
  const BlockPattern& pattern_;
  std::optional<ArcDifferences<Motion>> turns_;      // when it was needed
  std::optional<ArcDifferences<Motion>> positions_;  // and where it is not the same
};

}  // namespace portolan
