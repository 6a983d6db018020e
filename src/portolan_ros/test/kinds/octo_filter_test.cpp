// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/octo_filter.hpp"

#include <gtest/gtest.h>

#include "octo_maps.hpp"

namespace portolan {
namespace {

using Frames = std::vector<std::string>;
using ros_convert::OrganizedCloud;

OctoFilter filter(const OctoFilterOptions& options) {
  return OctoFilter(options, PipelineOptions(), octo_options());
}

/// A sensor 1 m above a floor: points on the floor, on a box and on a lamp.
OrganizedCloud scene() {
  OrganizedCloud organized;
  PointCloud& cloud = organized.cloud;
  for (int i = 0; i < 40; ++i) {
    const int column = i % 8;
    const int row = i / 8;
    cloud.points.emplace_back(1.0F + 0.1F * static_cast<float>(column),
                              0.1F * static_cast<float>(row), -1.0F);
  }
  cloud.points.emplace_back(1.5F, 0.0F, -0.6F);
  cloud.points.emplace_back(1.5F, 0.0F, 1.5F);
  return organized;
}

PosedInput::SensorPose pose(const std::vector<double>& heights) {
  PosedInput::SensorPose pose{Pose::Identity(), Pose::Identity()};
  for (const double z : heights) {
    pose.T_reference_sensor.emplace_back(Eigen::Translation3d(0.0, 0.0, z));
  }
  return pose;
}

const PointCloud& cloud_of(const OctoMapper::Observation& z) { return std::get<PointCloud>(z); }

TEST(OctoFilter, LetsAllPassWhereNothingIsAskedFor) {
  const OctoFilter all = filter({});
  EXPECT_EQ(all.references(OrganizedCloud()), Frames());
  EXPECT_EQ(all.references(RangeScan()), Frames());
  EXPECT_EQ(cloud_of(all(scene(), pose({}))).points, scene().cloud.points);
}

TEST(OctoFilter, DropsPointsByTheirHeightInAFrameOfChoice) {
  OctoFilterOptions options;
  options.box.max_z = 2.0;
  EXPECT_EQ(filter(options).references(OrganizedCloud()), Frames{"odom"});
  EXPECT_EQ(cloud_of(filter(options)(scene(), pose({1.0}))).points.size(), 41u);
  options.pointcloud_frame = "/lamp";
  options.box.min_z = 0.2;
  EXPECT_EQ(filter(options).references(OrganizedCloud()), Frames{"lamp"});
  EXPECT_EQ(cloud_of(filter(options)(scene(), pose({1.0}))).points.size(), 1u);
}

TEST(OctoFilter, SetsTheGroundApart) {
  OctoFilterOptions options;
  options.filter_ground = true;
  EXPECT_EQ(filter(options).references(OrganizedCloud()), Frames{"base_link"});
  const auto split = std::get<GroundedCloud>(filter(options)(scene(), pose({1.0})));
  EXPECT_EQ(split.ground.size(), 40u);
  EXPECT_EQ(split.obstacles.points.size(), 2u);
  options.box.max_z = 2.0;
  EXPECT_EQ(filter(options).references(OrganizedCloud()), (Frames{"odom", "base_link"}));
  const auto both = std::get<GroundedCloud>(filter(options)(scene(), pose({1.5, 1.0})));
  EXPECT_EQ(both.ground.size(), 40u);
  EXPECT_EQ(both.obstacles.points.size(), 1u);
}

TEST(OctoFilter, ThinsCloudsToTheResolution) {
  OctoFilterOptions options;
  options.thin_points = true;
  OrganizedCloud dense;
  for (int i = 0; i < 100; ++i) {
    dense.cloud.points.emplace_back(1.05F, 0.05F + 0.0001F * static_cast<float>(i), 0.05F);
  }
  EXPECT_EQ(filter(options).references(dense), Frames());
  EXPECT_EQ(cloud_of(filter(options)(dense, pose({}))).points.size(), 1u);
}

TEST(OctoFilter, KeepsNoReturnsOnlyForAMapThatIsClearedByThem) {
  OrganizedCloud cloud = scene();
  cloud.cloud.no_returns = {Eigen::Vector3f::UnitX()};
  cloud.unknown = {Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitZ()};
  OctoFilterOptions options;
  EXPECT_TRUE(cloud_of(filter(options)(cloud, pose({}))).no_returns.empty());
  OctoMapper::Options mapper = octo_options();
  mapper.no_return = NoReturn::clear;
  mapper.sensor_model.max_range = 5.0;
  const OctoFilter keeps(options, PipelineOptions(), mapper);
  EXPECT_EQ(cloud_of(keeps(cloud, pose({}))).no_returns, cloud.cloud.no_returns);
  options.nan_points = NanPoint::nothing_returned;
  const OctoFilter believes(options, PipelineOptions(), mapper);
  EXPECT_EQ(cloud_of(believes(cloud, pose({}))).no_returns.size(), 3u);
}

TEST(OctoFilter, ItsBoxMustHaveSomeRoom) {
  OctoFilterOptions options;
  options.box.min_z = options.box.max_z = 1.0;
  EXPECT_EQ(faults(options).size(), 1u);
}

}  // namespace
}  // namespace portolan
