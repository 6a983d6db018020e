// SPDX-License-Identifier: BSD-3-Clause
#include "mrpt_grid.hpp"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRange.h>

#include <cmath>

namespace portolan::bench {

namespace {

struct MrptScan {
  mrpt::obs::CObservation2DRangeScan scan;
  mrpt::poses::CPose3D pose;
};

MrptScan convert(const Workload::PosedScan& from, double max_range) {
  MrptScan to;
  const std::size_t n = from.scan.ranges.size();
  to.scan.aperture =
      static_cast<float>(std::abs(from.scan.angle_increment) * static_cast<double>(n));
  to.scan.maxRange = static_cast<float>(max_range) + 1.0F;
  to.scan.rightToLeft = from.scan.angle_increment > 0.0;
  to.scan.resizeScan(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float range = from.scan.ranges[i];
    const bool valid =
        range_reading(range, from.scan.range_min, from.scan.range_max) == RangeReading::hit;
    to.scan.setScanRange(i, valid ? range : 0.0F);
    to.scan.setScanRangeValidity(i, valid);
  }
  // Its beams are centred about the sensor's x axis.
  const double turn =
      from.scan.angle_min + from.scan.angle_increment * static_cast<double>(n) / 2.0;
  to.scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0, turn, 0, 0);
  const Eigen::Vector3d p = from.T_map_sensor.translation();
  to.pose = mrpt::poses::CPose3D(p.x(), p.y(), 0, yaw(from.T_map_sensor), 0, 0);
  return to;
}

mrpt::obs::CObservationRange convert(const RangeEcho& echo) {
  mrpt::obs::CObservationRange to;
  to.minSensorDistance = static_cast<float>(echo.range_min);
  to.maxSensorDistance = static_cast<float>(echo.range_max);
  to.sensorConeApperture = static_cast<float>(echo.aperture);
  mrpt::obs::CObservationRange::TMeasurement measurement;
  measurement.sensedDistance = static_cast<float>(echo.range);
  to.sensedData.push_back(measurement);
  return to;
}

}  // namespace

Drawer mrpt_grid(const Workload& workload, bool widening) {
  Eigen::Vector2d low(-1.0, -1.0), high(1.0, 1.0);
  auto scans = std::make_shared<std::vector<MrptScan>>();
  for (const Workload::PosedScan& posed : workload.scans) {
    scans->push_back(convert(posed, workload.max_range));
    low = low.cwiseMin(posed.T_map_sensor.translation().head<2>());
    high = high.cwiseMax(posed.T_map_sensor.translation().head<2>());
  }
  const double reach = workload.max_range + 2.0;  // presized, so that it never grows
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>(
      static_cast<float>(low.x() - reach), static_cast<float>(high.x() + reach),
      static_cast<float>(low.y() - reach), static_cast<float>(high.y() + reach), 0.05F);
  map->insertionOptions.maxDistanceInsertion = static_cast<float>(workload.max_range) + 1.0F;
  map->insertionOptions.wideningBeamsWithDistance = widening;
  map->insertionOptions.considerInvalidRangesAsFreeSpace = false;
  map->insertionOptions.maxOccupancyUpdateCertainty = 0.75F;
  Drawer drawer;
  drawer.scan = [map, scans](std::size_t i) {
    map->insertObservation((*scans)[i].scan, (*scans)[i].pose);
  };
  drawer.echo = [map, ping = std::make_shared<mrpt::obs::CObservationRange>(),
                 last = RangeEcho{}](const RangeEcho& echo) mutable {
    if (echo.range != last.range) *ping = convert(echo);
    last = echo;
    map->insertObservation(*ping, mrpt::poses::CPose3D());
  };
  return drawer;
}

}  // namespace portolan::bench
