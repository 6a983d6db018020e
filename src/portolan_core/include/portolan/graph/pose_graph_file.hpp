// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "portolan/graph/pose_graph.hpp"
#include "portolan/map_file.hpp"

namespace portolan {

/// NAME.g2o, NAME.stamps and NAME.scans, to be saved together.
FileSet pose_graph_files(const PoseGraph& graph, const std::string& name);

/// The pose graph in such files, of which only the g2o must be there; without scans the places of
/// its keyframes are not found again. Throws std::runtime_error that names the file and what is
/// wrong in it.
PoseGraph pose_graph_from(const PoseGraph::Options& options, const FileSet& files,
                          const std::string& name);

/// Reads from a folder those files of NAME that are there, all from one save. Throws as above, and
/// where there is no g2o.
PoseGraph load_pose_graph(const PoseGraph::Options& options, const std::filesystem::path& folder,
                          const std::string& name);

}  // namespace portolan
