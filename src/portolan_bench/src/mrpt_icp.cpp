// SPDX-License-Identifier: BSD-3-Clause
#include "mrpt_icp.hpp"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPosePDF.h>
#include <mrpt/slam/CICP.h>

#include <cmath>

#include "portolan/observation/range_reading.hpp"

namespace portolan::bench {
namespace {

mrpt::maps::CSimplePointsMap points_of(const RangeScan& scan) {
  mrpt::maps::CSimplePointsMap map;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const auto range = static_cast<double>(scan.ranges[i]);
    if (range_reading(range, scan.range_min, scan.range_max) != RangeReading::hit) continue;
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    map.insertPoint(static_cast<float>(range * std::cos(angle)),
                    static_cast<float>(range * std::sin(angle)));
  }
  return map;
}

mrpt::slam::CICP::TConfigParams tuned_options() {
  mrpt::slam::CICP::TConfigParams options;
  options.maxIterations = 80;
  options.thresholdDist = 0.75;
  options.thresholdAng = 15.0 * M_PI / 180.0;
  options.smallestThresholdDist = 0.05;
  options.ALFA = 0.8;
  options.corresponding_points_decimation = 1;
  return options;
}

}  // namespace

Pose mrpt_icp(const RangeScan& target, const RangeScan& source, const Pose& T_guess, bool tuned) {
  mrpt::slam::CICP icp;
  if (tuned) icp.options = tuned_options();
  const mrpt::maps::CSimplePointsMap a = points_of(target);
  const mrpt::maps::CSimplePointsMap b = points_of(source);
  const Eigen::Vector3d p = T_guess.translation();
  const auto result = icp.Align(&a, &b, mrpt::poses::CPose2D(p.x(), p.y(), yaw(T_guess)));
  const mrpt::poses::CPose2D mean = result->getMeanVal();
  return planar_pose(mean.x(), mean.y(), mean.phi());
}

}  // namespace portolan::bench
