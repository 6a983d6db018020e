// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "portolan/graph/optimizer_options.hpp"

namespace portolan {

/// What a squared residual counts, and the weight that it keeps in least squares.
struct Kernel {
  RobustKernel shape = RobustKernel::none;
  double width2 = 1.0;     ///< square of the residual from which it counts less
  double convexity = 1.0;  ///< geman_mcclure: the larger, the nearer to no kernel

  double cost(double r2) const {
    switch (shape) {
      case RobustKernel::huber:
        return r2 <= width2 ? r2 : 2.0 * std::sqrt(r2 * width2) - width2;
      case RobustKernel::cauchy:
        return width2 * std::log1p(r2 / width2);
      case RobustKernel::geman_mcclure:
        return r2 * scale() / (r2 + scale());
      default:
        return r2;
    }
  }

  /// The derivative of the cost.
  double weight(double r2) const {
    switch (shape) {
      case RobustKernel::huber:
        return r2 <= width2 ? 1.0 : std::sqrt(width2 / r2);
      case RobustKernel::cauchy:
        return width2 / (width2 + r2);
      case RobustKernel::geman_mcclure:
        return scale() * scale() / ((r2 + scale()) * (r2 + scale()));
      default:
        return 1.0;
    }
  }

 private:
  double scale() const { return width2 * convexity; }
};

}  // namespace portolan
