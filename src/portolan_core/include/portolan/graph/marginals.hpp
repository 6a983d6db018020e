// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "portolan/graph/graph.hpp"

namespace portolan {

/// How uncertain the poses of a graph are, at its coordinates, given all accepted arcs.
/// Covariances are of T_map_pose * exp(v), x, y, z [m] and turns [rad] in the pose's own frame.
class Marginals {
 public:
  /// Throws std::runtime_error where arcs leave a pose undetermined.
  explicit Marginals(const Graph& graph);
  ~Marginals();
  Marginals(Marginals&&) noexcept;
  Marginals& operator=(Marginals&&) noexcept;

  /// Of one pose against the fixed ones; zero for those. Throws std::out_of_range.
  TangentMatrix covariance(PoseId id) const;
  /// Of T_from_to between two poses, in the frame of `to`. Throws std::out_of_range.
  TangentMatrix relative_covariance(PoseId from, PoseId to) const;
  /// Of every pose, by index of `Graph::poses()`: by selected inversion, not pose by pose.
  std::vector<TangentMatrix> covariances() const;

 private:
  class Factor;
  std::unique_ptr<const Factor> factor_;
};

}  // namespace portolan
