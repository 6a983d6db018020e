// SPDX-License-Identifier: BSD-3-Clause
#include "mrpt_beacons.hpp"

#include <mrpt/maps/CBeaconMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationBeaconRanges.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace portolan::bench {

namespace {

using mrpt::maps::CBeacon;
using mrpt::maps::CBeaconMap;
using mrpt::obs::CObservationBeaconRanges;
using mrpt::obs::CRawlog;

struct Posed {
  mrpt::poses::CPose3D pose;
  CObservationBeaconRanges ranges;
};

mrpt::poses::CPose3D pose(const Pose& from) {
  const Eigen::Vector3d p = from.translation();
  return {p.x(), p.y(), p.z(), yaw(from), 0.0, 0.0};
}

BeaconWorkload::PosedRanges posed(const CObservationBeaconRanges& seen,
                                  const mrpt::poses::CPose3D& base) {
  BeaconWorkload::PosedRanges posed;
  const mrpt::poses::CPoint3D p = base + seen.sensedData[0].sensorLocationOnRobot;
  posed.T_map_sensor = planar_pose(p.x(), p.y(), base.yaw());
  for (const auto& reading : seen.sensedData) {
    posed.z.ranges.push_back({static_cast<BeaconId>(reading.beaconID),
                              static_cast<double>(reading.sensedDistance),
                              static_cast<double>(seen.stdError)});
  }
  return posed;
}

Posed converted(const BeaconWorkload::PosedRanges& from) {
  Posed to;
  to.pose = pose(from.T_map_sensor);
  for (const BeaconRange& range : from.z.ranges) {
    CObservationBeaconRanges::TMeasurement reading;
    reading.beaconID = static_cast<std::int32_t>(range.id);
    reading.sensedDistance = static_cast<float>(range.range);
    to.ranges.stdError = static_cast<float>(range.stddev);
    to.ranges.sensedData.push_back(reading);
  }
  return to;
}

CBeaconMap empty_map(double stddev) {
  CBeaconMap map;
  map.insertionOptions.insertAsMonteCarlo = false;
  map.insertionOptions.minElevation_deg = 0.0F;
  map.insertionOptions.maxElevation_deg = 0.0F;
  map.insertionOptions.SOG_thresholdNegligible = 40.0F;  // these as in MRPT's own configuration
  map.insertionOptions.SOG_maxDistBetweenGaussians = 0.6F;
  map.insertionOptions.SOG_separationConstant = 2.0F;
  map.likelihoodOptions.rangeStd = static_cast<float>(stddev);
  return map;
}

Eigen::Vector3d place(const CBeacon& beacon) {
  mrpt::poses::CPoint3D mean;
  if (beacon.m_typePDF == CBeacon::pdfSOG) {
    double heaviest = -1e300;
    for (const auto& mode : beacon.m_locationSOG) {
      if (mode.log_w <= heaviest) continue;
      heaviest = mode.log_w;
      mean = mode.val.mean;
    }
  } else {
    beacon.getMean(mean);
  }
  return {mean.x(), mean.y(), mean.z()};
}

}  // namespace

std::function<Places()> mrpt_beacons(const BeaconWorkload& load) {
  std::vector<Posed> posed;
  for (const auto& ranges : load.posed) posed.push_back(converted(ranges));
  const double stddev = load.stddev;
  return [posed, stddev] {
    CBeaconMap map = empty_map(stddev);
    for (const Posed& p : posed) map.insertObservation(p.ranges, p.pose);
    Places places;
    for (const CBeacon& beacon : map) places[static_cast<BeaconId>(beacon.m_ID)] = place(beacon);
    return places;
  };
}

BeaconWorkload beacon_rawlog(const std::string& path, const std::vector<Pose>& poses) {
  CRawlog log;
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error(path + ": no such file");
  if (!log.loadFromRawLogFile(path)) throw std::runtime_error(path + ": no rawlog");
  BeaconWorkload load;
  mrpt::poses::CPose3D base;
  std::size_t actions = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log.getType(i) == CRawlog::etActionCollection) {
      const auto moved = log.getAsAction(i)->getBestMovementEstimation();
      if (moved) base = base + mrpt::poses::CPose3D(moved->poseChange->getMeanVal());
      ++actions;
    } else if (log.getType(i) == CRawlog::etSensoryFrame) {
      const auto seen = log.getAsObservations(i)->getObservationByClass<CObservationBeaconRanges>();
      if (!seen || seen->sensedData.empty()) continue;
      if (!poses.empty() && (actions == 0 || actions > poses.size())) continue;
      load.posed.push_back(posed(*seen, poses.empty() ? base : pose(poses[actions - 1])));
      load.stddev = 2.0 * static_cast<double>(seen->stdError);  // as in its configuration
    }
  }
  return load;
}

}  // namespace portolan::bench
