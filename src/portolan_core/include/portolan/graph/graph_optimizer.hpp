// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/graph.hpp"
#include "portolan/graph/optimizer_options.hpp"
#include "portolan/graph/optimizer_report.hpp"

namespace portolan {

/// Moves the poses of a graph to where its accepted arcs contradict each other least.
/// Gauss-Newton on a block-sparse Cholesky factor, damped after Levenberg where a step fails. The
/// same graph gives the same poses, bit for bit, on the same kind of processor.
class GraphOptimizer {
 public:
  using Options = OptimizerOptions;

  /// Throws OptionsError with every fault at once.
  explicit GraphOptimizer(const Options& options = {});

  /// Moves the poses that are not fixed, and says what it thinks of the result. The poses are left
  /// at the best coordinates that were found, never worse than before.
  OptimizerReport optimize(Graph& graph) const;

 private:
  Options options_;
};

}  // namespace portolan
