// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <deque>
#include <vector>

#include "portolan_ros/health.hpp"

namespace portolan {

/// Says in one line how mapping goes, and counts what each input lost and why.
/// A warning is given where nothing arrives, or where an input's latest messages were all lost.
class Diagnosis {
 public:
  /// Fills in summary and counts. To be called at the rate of the diagnostics: "latest" means
  /// since some calls before.
  void fill(const std::vector<Tally>& tallies, diagnostic_updater::DiagnosticStatusWrapper& status);

 private:
  bool is_starving(std::size_t input, const Tally& tally);

  std::vector<std::deque<Tally>> past_;  // by input: as it was at the last calls, oldest first
};

}  // namespace portolan
