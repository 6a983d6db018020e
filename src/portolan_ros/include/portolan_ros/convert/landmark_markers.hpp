// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <portolan_msgs/LandmarkMap.h>
#include <visualization_msgs/MarkerArray.h>

namespace portolan::ros_convert {

/// What rviz shows of the map: each landmark as a dot in an ellipsoid of so many standard
/// deviations with its id above, the surer it exists the less transparent; blue points, and orange
/// rays with a line from where they were first seen. A direction is an arrow. The first marker
/// removes those of the message before.
visualization_msgs::MarkerArray landmark_markers(const portolan_msgs::LandmarkMap& map,
                                                 double standard_deviations);

}  // namespace portolan::ros_convert
