// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/options.hpp"
#include "portolan/thinning.hpp"

namespace portolan {

/// What a `Remapper` may keep, and what it lets in.
struct RemapperOptions {
  double log_budget = 512.0;
  Thinning::Options thinning;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("log_budget", self.log_budget,
          "memory for observations that corrections can still move [MB]", above(0.0));
    visit("thinning", self.thinning, "which observations enter");
  }
};

}  // namespace portolan
