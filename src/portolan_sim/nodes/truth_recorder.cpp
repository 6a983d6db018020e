// SPDX-License-Identifier: BSD-3-Clause
#include "truth_recorder.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "portolan/map_file.hpp"

namespace portolan::sim {

namespace {

/// As part of a file's name.
std::string file_name(std::string topic) {
  std::replace(topic.begin(), topic.end(), '/', '_');
  return "view_" + topic;
}

}  // namespace

TruthRecorder::TruthRecorder(const RobotSimOptions& options, const Simulation& simulation)
    : options_(options),
      grid_(truth_grid(simulation.world(), options.truth_resolution, options.truth_height,
                       simulation.T_map_start().translation().head<2>())) {}

void TruthRecorder::record(const Simulation& simulation, const Event& event) {
  if (!wanted()) return;
  if (const auto* truth = std::get_if<Event::Truth>(&event.payload)) {
    trajectory_.emplace_back(event.stamp, truth->T_map_base);
  }
  const bool is_scan = std::holds_alternative<Event::Scan>(event.payload);
  if (!is_scan && !std::holds_alternative<RangeEcho>(event.payload)) return;
  View& view = views_.try_emplace(event.topic, grid_).first->second;
  for (const AnySensor& sensor : simulation.sensors()) {
    const std::vector<Mount> frames = mounts(sensor);
    const bool measured_it = std::any_of(frames.begin(), frames.end(), [&](const Mount& mount) {
      return mount.frame == event.frame;
    });
    if (measured_it) {
      view.look(simulation.world(), sensor, simulation.T_map_base().at(event.stamp));
    }
  }
}

void TruthRecorder::write(const Simulation& simulation) const {
  if (!wanted()) throw std::runtime_error("truth_directory names no folder");
  FileSet files = mark_files(simulation.world());
  files.merge(grid_files("map", grid_));
  for (const auto& [topic, view] : views_) files.merge(grid_files(file_name(topic), view.grid()));
  files["trajectory.tum"] = to_tum(trajectory_);
  std::filesystem::create_directories(options_.truth_directory);
  save_files(options_.truth_directory, files);
}

}  // namespace portolan::sim
