// SPDX-License-Identifier: BSD-3-Clause
#include "mrpt_rawlog.hpp"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <filesystem>
#include <limits>
#include <stdexcept>

namespace portolan::bench {

namespace {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CRawlog;

Pose pose(const mrpt::poses::CPose3D& from) {
  Pose to = planar_pose(from.x(), from.y(), from.yaw());
  to.translation().z() = from.z();
  to.rotate(Eigen::AngleAxisd(from.pitch(), Eigen::Vector3d::UnitY()));
  to.rotate(Eigen::AngleAxisd(from.roll(), Eigen::Vector3d::UnitX()));
  return to;
}

RangeScan range_scan(const CObservation2DRangeScan& from) {
  const auto n = static_cast<double>(from.getScanSize());
  const double aperture = static_cast<double>(from.aperture) * (from.rightToLeft ? 1.0 : -1.0);
  RangeScan to;
  to.angle_min = -aperture / 2.0;
  to.angle_increment = aperture / (n - 1.0);
  to.range_max = static_cast<double>(from.maxRange);
  for (std::size_t i = 0; i < from.getScanSize(); ++i) {
    to.ranges.push_back(from.getScanRangeValidity(i) ? from.getScanRange(i)
                                                     : std::numeric_limits<float>::infinity());
  }
  return to;
}

}  // namespace

std::vector<RawlogScan> read_rawlog(const std::string& path) {
  CRawlog log;
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error(path + ": no such file");
  if (!log.loadFromRawLogFile(path)) throw std::runtime_error(path + ": no rawlog");
  std::vector<RawlogScan> scans;
  Pose T_odom_base = Pose::Identity();
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log.getType(i) == CRawlog::etActionCollection) {
      const auto moved = log.getAsAction(i)->getBestMovementEstimation();
      if (moved)
        T_odom_base = T_odom_base * pose(mrpt::poses::CPose3D(moved->poseChange->getMeanVal()));
    } else if (log.getType(i) == CRawlog::etSensoryFrame) {
      const auto seen = log.getAsObservations(i)->getObservationByClass<CObservation2DRangeScan>();
      if (!seen) continue;
      scans.push_back({mrpt::Clock::toDouble(seen->timestamp), T_odom_base, pose(seen->sensorPose),
                       range_scan(*seen)});
    }
  }
  return scans;
}

}  // namespace portolan::bench
