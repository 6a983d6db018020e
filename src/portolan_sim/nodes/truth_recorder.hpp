// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "portolan/sim/simulation.hpp"
#include "portolan/sim/truth_files.hpp"
#include "portolan/sim/truth_grid.hpp"
#include "portolan/sim/view.hpp"
#include "robot_sim_options.hpp"

namespace portolan::sim {

/// Keeps the truth about a run, and writes it as files: `map.yaml` and `map.pgm`,
/// `landmarks.yaml`, `beacons.yaml`, `trajectory.tum`, and for each topic of scans or echoes
/// `view_<topic>.yaml` and `.pgm`, what such a sensor could have seen.
class TruthRecorder {
 public:
  /// Knows the true grid; records what passes only where the options name a folder.
  TruthRecorder(const RobotSimOptions& options, const Simulation& simulation);

  void record(const Simulation& simulation, const Event& event);

  /// Throws std::runtime_error where there is no folder, or it cannot be written to.
  void write(const Simulation& simulation) const;

  const TruthGrid& grid() const { return grid_; }
  bool wanted() const { return !options_.truth_directory.empty(); }

 private:
  RobotSimOptions options_;
  TruthGrid grid_;
  Trajectory trajectory_;
  std::map<std::string, View> views_;  // by topic
};

}  // namespace portolan::sim
