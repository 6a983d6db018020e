// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "octo/octo_fixture.hpp"

namespace portolan {

/// What the laws need to know of OctoMapper: clouds, clouds with ground, scans, cleared boxes, in
/// all modes.
class OctoMapperCase {
 public:
  using Mapper = OctoMapper;

  explicit OctoMapperCase(std::uint32_t seed) : random_(seed) {
    options_.resolution = 0.1;
    options_.sensor_model.max_range = seed % 4 == 3 ? -1.0 : 1.5;
    options_.discretize = seed % 2 == 1;
    options_.no_return = seed % 4 == 0 ? NoReturn::clear : NoReturn::ignore;
  }

  const OctoMapper::Options& options() const { return options_; }

  OctoMapper::Observation observation() {
    switch (random_() % 4) {
      case 0:
        return cloud();
      case 1:
        return GroundedCloud{cloud(), cloud().points};
      case 2:
        return scan();
      default:
        return ClearBox{{Eigen::Vector3d(-0.5, -0.5, -0.5), Eigen::Vector3d(0.5, 0.6, 0.7)}};
    }
  }

  Pose pose() { return octo_test::random_pose(random_, 1.0); }

  static bool equal(const OctoMapper& a, const OctoMapper& b) {
    return octo_test::bytes(octree(a)) == octo_test::bytes(octree(b)) &&
           octo_test::count_of_known(a) == octo_test::count_of_known(b);
  }

 private:
  PointCloud cloud() {
    PointCloud cloud = octo_test::random_cloud(random_, 60, 2.0, options_.resolution);
    cloud.no_returns = {Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitZ()};
    return cloud;
  }

  RangeScan scan() {
    RangeScan scan;
    scan.angle_increment = 0.2;
    scan.range_min = 0.1;
    scan.range_max = 2.0;
    for (int i = 0; i < 20; ++i) {
      scan.ranges.push_back(static_cast<float>(octo_test::uniform(random_, -0.1, 2.5)));
    }
    return scan;
  }

  octo_test::Random random_;
  OctoMapper::Options options_;
};

}  // namespace portolan
