// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>

#include "portolan_ros/diagnosis.hpp"
#include "portolan_ros/kinds/kind_parts.hpp"
#include "portolan_ros/pipeline.hpp"

namespace portolan {

/// Says how one map comes about: what became of the messages, the log and the corrections.
template <class Kind>
class PipelineDiagnosis {
 public:
  explicit PipelineDiagnosis(const Pipeline<Kind>& pipeline) : pipeline_(pipeline) {}

  /// To be called for each correction that could not be taken.
  void refuse_correction() { ++corrections_refused_; }

  /// Fills in summary and counts. To be called at the rate of the diagnostics.
  void fill(diagnostic_updater::DiagnosticStatusWrapper& status) {
    inputs_.fill(pipeline_.posed().tallies(), status);
    const auto& remapper = pipeline_.remapper();
    status.add("observations in the log", remapper.log_size());
    status.add("log [MB]", static_cast<double>(remapper.log_bytes()) * 1e-6);
    status.add("observations that corrections no longer move", remapper.frozen());
    status.add("redrawn", remapper.progress());
    status.add("corrections refused", corrections_refused_);
    status.add("transforms refused", pipeline_.posed().bad_transforms());
    status.add("times the clock ran back", pipeline_.time_jumps());
    for (const auto& [what, count] : counts_of<Kind>(remapper.map())) status.add(what, count);
  }

 private:
  const Pipeline<Kind>& pipeline_;
  Diagnosis inputs_;
  std::size_t corrections_refused_ = 0;
};

}  // namespace portolan
