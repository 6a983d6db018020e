// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/graph.hpp"
#include "portolan/graph/match/match.hpp"
#include "portolan/graph/match/surface_index.hpp"
#include "portolan/options.hpp"

namespace portolan {

/// How surfaces are brought onto each other, and when that is believed.
struct IcpOptions {
  double reach = 1.0;
  double kernel = 0.05;
  double min_cosine = 0.7;
  double min_constraint = 0.01;
  double bias = 0.01;
  int coarse_points = 90;
  int max_iterations = 40;
  int min_points = 10;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("reach", self.reach, "points at first look so far for their partners [m]", above(0.0));
    visit("kernel", self.kernel,
          "distance from the surface at which a partner counts for a quarter in the end [m]",
          above(0.0));
    visit("min_cosine", self.min_cosine, "of the angle between the surfaces of partners",
          between(-1.0, 1.0));
    visit("min_constraint", self.min_constraint,
          "a direction is open if surfaces hold it less: mean squared cosine to their normals",
          between(0.0, 1.0));
    visit("bias", self.bias,
          "deviation of a match that no number of points makes smaller [m]; of the heading: this "
          "over the mean range",
          above(0.0));
    visit("coarse_points", self.coarse_points, "so many points are matched until they lie close",
          at_least(3.0));
    visit("max_iterations", self.max_iterations, "of matching partners", at_least(1.0));
    visit("min_points", self.min_points, "with fewer partners there is no match", at_least(3.0));
    visit.require(self.reach >= self.kernel, "reach must not be less than kernel");
  }
};

/// Brings the source onto the target by the distances of its points from the target's lines (or
/// planes), starting from a guess: iterated closest points, robust by a Geman-McClure kernel that
/// narrows from `reach` to `kernel`. Where the surfaces leave a direction open the guess stays, and
/// the result says so. The information is the Hessian over the mean squared residual, with `bias`.
/// Not converged where there are too few partners.
Match icp(const SurfaceIndex& target, const Surface& source, const Pose& T_target_source,
          GraphSpace space, const IcpOptions& options);

}  // namespace portolan
