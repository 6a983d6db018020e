// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/grid/footprint.hpp"
#include "portolan/grid/grid_options.hpp"
#include "portolan/grid/scan_fan.hpp"
#include "portolan/observation/point_cloud.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/outcome.hpp"
#include "portolan/pose.hpp"

namespace portolan {

// The inverse sensor models of lasers and clouds; EchoCone is that of sonars. Each draws what one
// observation says into an open footprint, and says whether it may be put into the map. The pose
// must be valid.

/// A planar scan. Sector model: free is the polygon from the sensor along its echoes (drawn back by
/// the margin), so that each beam stands for the angular step about it, with the range running
/// straight to that of its neighbour; where a neighbour is silent or more than 90 degrees away, the
/// beam's own range holds up to half a step. Ray model: free are the cells under each beam. Beams
/// that free less than 1/32 cell free nothing.
///
/// Occupied are the echoes' cells and, with a margin, the strips along surfaces: between neighbours
/// of at most 90 degrees whose ranges differ by no more than two margins and a cell's side, from
/// the ends of what they free to the margin beyond their echoes. The strips of one turn together
/// make one outline, under the even-odd rule.
///
/// Where the sensor moves during the scan, each beam starts from where it stood then, and turned as
/// it did then; sectors reach from there to where it stood half way.
Outcome draw(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options,
             ScanFan& fan, Footprint& footprint);

/// A cloud: each ray frees the cells under its part inside the height band, thin, and occupies the
/// cell of its end where that lies in the band.
Outcome draw(const PointCloud& cloud, const Pose& T_map_sensor, const GridOptions& options,
             Footprint& footprint);

}  // namespace portolan
