// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "octo/octo_fixture.hpp"
#include "portolan/octo/cloud_filter.hpp"
#include "portolan/octo/projection.hpp"
#include "portolan/remapper.hpp"

namespace portolan::octo_test {
namespace {

constexpr double kBudget = 0.02;  // [MB]: the last observations only

struct Entry {
  Time stamp;
  Pose T_odom_sensor;
  OctoMapper::Observation z;
};

std::vector<Entry> journey(Random& random, bool thins) {
  std::vector<Entry> entries;
  for (int i = 0; i < 15; ++i) {
    const Pose pose = random_pose(random, 1.0);
    PointCloud cloud = random_cloud(random, 100, 2.0, 0.1);
    if (thins) cloud = thinned(std::move(cloud), 0.1, 0.0);
    entries.push_back({Time(seconds(i)), pose, std::move(cloud)});
    const ClearBox box{{Eigen::Vector3d(-0.5, -0.5, -0.5), Eigen::Vector3d(0.5, 0.5, 0.5)}};
    if (i % 5 == 3) entries.push_back({Time(seconds(i + 0.5)), pose, box});
  }
  return entries;
}

Correction correction(Random& random) {
  return Correction({{Time(seconds(0)), random_pose(random, 0.3)},
                     {Time(seconds(7)), random_pose(random, 0.3)},
                     {Time(seconds(14)), random_pose(random, 0.3)}});
}

Remapper<OctoMapper> remapper(double log_budget) {
  RemapperOptions options;
  options.log_budget = log_budget;
  OctoMapper::Options mapper;
  mapper.resolution = 0.1;
  mapper.sensor_model.max_range = 1.5;
  return {options, mapper};
}

TEST(OctoMapper, told_late_of_a_correction_equals_one_that_knew_it) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const std::vector<Entry> entries = journey(random, seed % 2 == 0);
    const Correction right = correction(random);
    Remapper<OctoMapper> late = remapper(512.0);
    Remapper<OctoMapper> early = remapper(512.0);
    early.correct(right);
    OctreeMirror mirror(late.map().options());
    for (const Entry& entry : entries) {
      late.observe(entry.stamp, entry.T_odom_sensor, entry.z);
      early.observe(entry.stamp, entry.T_odom_sensor, entry.z);
    }
    mirror.follow(late.map(), late.generation());
    const std::string before = bytes(octree(late.map()));
    late.correct(right);
    late.finish();
    mirror.follow(late.map(), late.generation());
    ASSERT_NE(before, bytes(octree(early.map())));
    ASSERT_EQ(bytes(octree(late.map())), bytes(octree(early.map())));
    ASSERT_EQ(bytes(mirror.tree()), bytes(octree(early.map())));
  }
}

TEST(OctoMapper, what_fell_out_of_the_log_stays_in_the_map) {
  Random random(3);
  const std::vector<Entry> entries = journey(random, false);
  Remapper<OctoMapper> small = remapper(kBudget);
  Remapper<OctoMapper> large = remapper(512.0);
  for (const Entry& entry : entries) {
    small.observe(entry.stamp, entry.T_odom_sensor, entry.z);
    large.observe(entry.stamp, entry.T_odom_sensor, entry.z);
  }
  EXPECT_GT(small.frozen(), 0U);
  EXPECT_EQ(bytes(octree(small.map())), bytes(octree(large.map())));
}

TEST(OctoMapper, observations_are_weighed_for_the_log) {
  PointCloud cloud;
  cloud.points.resize(1000);
  GroundedCloud grounded;
  grounded.ground.resize(1000);
  EXPECT_GE(byte_size(OctoMapper::Observation(cloud)), 12000U);
  EXPECT_GE(byte_size(OctoMapper::Observation(grounded)), 12000U);
  EXPECT_GT(byte_size(OctoMapper::Observation(ClearBox{})), 0U);
}

}  // namespace
}  // namespace portolan::octo_test
