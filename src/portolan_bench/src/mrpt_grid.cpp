// SPDX-License-Identifier: BSD-3-Clause
#include "mrpt_grid.hpp"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRange.h>

#include <cmath>
#include <variant>
#include <vector>

namespace portolan::bench {

namespace {

struct MrptReading {
  mrpt::obs::CObservation::Ptr observation;
  mrpt::poses::CPose3D pose;
};

mrpt::obs::CObservation::Ptr convert(const RangeScan& from, double max_range) {
  auto to = std::make_shared<mrpt::obs::CObservation2DRangeScan>();
  const std::size_t n = from.ranges.size();
  to->aperture = static_cast<float>(std::abs(from.angle_increment) * static_cast<double>(n));
  to->maxRange = static_cast<float>(max_range) + 1.0F;
  to->rightToLeft = from.angle_increment > 0.0;
  to->resizeScan(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float range = from.ranges[i];
    const bool valid = range_reading(range, from.range_min, from.range_max) == RangeReading::hit;
    to->setScanRange(i, valid ? range : 0.0F);
    to->setScanRangeValidity(i, valid);
  }
  // Its beams are centred about the sensor's x axis.
  const double turn = from.angle_min + from.angle_increment * static_cast<double>(n) / 2.0;
  to->sensorPose = mrpt::poses::CPose3D(0, 0, 0, turn, 0, 0);
  return to;
}

mrpt::obs::CObservation::Ptr convert(const RangeEcho& echo) {
  auto to = std::make_shared<mrpt::obs::CObservationRange>();
  to->minSensorDistance = static_cast<float>(echo.range_min);
  to->maxSensorDistance = static_cast<float>(echo.range_max);
  to->sensorConeApperture = static_cast<float>(echo.aperture);
  mrpt::obs::CObservationRange::TMeasurement measurement;
  measurement.sensedDistance = static_cast<float>(echo.range);
  to->sensedData.push_back(measurement);
  return to;
}

MrptReading convert(const Workload::Reading& from, double max_range) {
  const auto* scan = std::get_if<RangeScan>(&from.z);
  const Eigen::Vector3d p = from.T_map_sensor.translation();
  return {scan ? convert(*scan, max_range) : convert(std::get<RangeEcho>(from.z)),
          mrpt::poses::CPose3D(p.x(), p.y(), 0, yaw(from.T_map_sensor), 0, 0)};
}

}  // namespace

Drawer mrpt_grid(const Workload& workload, bool widening) {
  auto readings = std::make_shared<std::vector<MrptReading>>();
  for (const Workload::Reading& reading : workload.readings) {
    readings->push_back(convert(reading, workload.max_range));
  }
  const Eigen::AlignedBox2f extent = workload.extent().cast<float>();  // so that it never grows
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>(
      extent.min().x(), extent.max().x(), extent.min().y(), extent.max().y(), 0.05F);
  map->insertionOptions.maxDistanceInsertion = static_cast<float>(workload.max_range) + 1.0F;
  map->insertionOptions.wideningBeamsWithDistance = widening;
  map->insertionOptions.considerInvalidRangesAsFreeSpace = false;
  map->insertionOptions.maxOccupancyUpdateCertainty = 0.75F;
  return [map, readings](std::size_t i) {
    map->insertObservation(*(*readings)[i].observation, (*readings)[i].pose);
  };
}

}  // namespace portolan::bench
