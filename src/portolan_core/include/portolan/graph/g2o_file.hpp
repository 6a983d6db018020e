// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "portolan/graph/graph.hpp"
#include "portolan/map_file.hpp"

namespace portolan {

/// The graph as g2o text: VERTEX_SE2 and EDGE_SE2, or VERTEX_SE3:QUAT and EDGE_SE3:QUAT with the
/// upper triangle of the information by rows, FIX. What g2o has no words for stands in comments
/// `# portolan KIND STATE REASON` before an arc; arcs that are not accepted are comments as a
/// whole, so that others solve the same graph. Numbers are exact, turns to 1e-14. Read and written
/// again it is the same text.
std::string to_g2o(const Graph& graph);

/// The graph that g2o text describes, by lines in any order; lines of PARAMS and comments do not
/// count. Quaternions are normalised. Where there are no vertices at all, poses come from the arcs
/// and stand along the spanning tree. Without comment an arc from one id to the next is odometry,
/// any other a loop. Throws std::runtime_error, `line N: what is wrong`, for anything else.
Graph graph_from_g2o(const std::string& g2o, const std::string& stamps = "");

/// A line `id stamp` for each pose [s], with nine decimals.
std::string stamps_text(const Graph& graph);

/// A line `stamp tx ty tz qx qy qz qw` for each pose, in the order of stamps [s, m].
std::string to_tum(const Graph& graph);

/// NAME.g2o and NAME.stamps, to be saved together.
FileSet graph_files(const Graph& graph, const std::string& name);

/// Reads NAME.g2o, and NAME.stamps if it is beside it. Throws std::runtime_error that names the
/// file and, where the text is wrong, its line.
Graph load_graph(const std::filesystem::path& g2o);

}  // namespace portolan
