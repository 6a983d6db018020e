// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octo_mapper.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

const Pose kHere(Eigen::Translation3d(0.05, 0.05, 0.05));

OctoMapper::Options random_options(Random& random) {
  OctoMapper::Options options;
  options.resolution = std::array{0.05, 0.1, 0.1, 0.25, 0.37}[random() % 5];
  options.sensor_model.hit = uniform(random, 0.51, 0.95);
  options.sensor_model.miss = uniform(random, 0.05, 0.49);
  options.sensor_model.min = uniform(random, 0.05, 0.4);
  options.sensor_model.max = uniform(random, 0.6, 0.99);
  options.sensor_model.max_range = random() % 3 == 0 ? -1.0 : uniform(random, 0.5, 6.0);
  options.discretize = random() % 3 == 0;
  return options;
}

OctoMapper::Options with_max_range(double max_range) {
  OctoMapper::Options options;
  options.resolution = 0.1;
  options.sensor_model.max_range = max_range;
  return options;
}

TEST(OctoMapper, makes_the_same_tree_as_the_library) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const OctoMapper::Options options = random_options(random);
    OctoMapper map(options);
    OctreeMirror mirror(options);
    octomap::OcTree expected = empty_tree(options);
    for (int i = 0; i < 9; ++i) {
      const Pose T_map_sensor = random_pose(random, i % 4 == 0 ? 0.0 : 1.5);
      const PointCloud cloud = random_cloud(random, 120, 4.0, options.resolution);
      ASSERT_EQ(map.insert(cloud, T_map_sensor), Outcome::inserted);
      insert(expected, options, cloud, T_map_sensor);
      if (i % 3 == 0) mirror.follow(map, 0);
    }
    mirror.follow(map, 0);
    ASSERT_GT(expected.size(), 100U);
    ASSERT_EQ(bytes(octree(map)), bytes(expected)) << "seed " << seed;
    ASSERT_EQ(bytes(mirror.tree()), bytes(expected)) << "seed " << seed;
    ASSERT_EQ(mirror.tree().size(), expected.calcNumNodes());
    ASSERT_TRUE(mirror.tree() == octree(map));
  }
}

TEST(OctoMapper, clamps_and_prunes_as_the_library_over_many_clouds) {
  Random random(5);
  const OctoMapper::Options options = with_max_range(2.0);
  OctoMapper map(options);
  octomap::OcTree expected = empty_tree(options);
  PointCloud cloud;  // a dense wall, so that voxels before it fill up and collapse
  for (float y = -1.0F; y < 1.0F; y += 0.05F) {
    for (float z = -1.0F; z < 1.0F; z += 0.05F) cloud.points.emplace_back(1.5F, y, z);
  }
  for (int i = 0; i < 25; ++i) {
    const Pose pose(Eigen::Translation3d(0.001 * uniform(random, 0.0, 1.0), 0.0, 0.0));
    map.insert(cloud, pose);
    insert(expected, options, cloud, pose);
  }
  EXPECT_LT(expected.getNumLeafNodes(), count_of_known(map));
  EXPECT_EQ(bytes(octree(map)), bytes(expected));
}

TEST(OctoMapper, points_of_no_use_are_counted_and_change_nothing) {
  OctoMapper map(with_max_range(-1.0));
  PointCloud cloud;
  cloud.points = {{kNan, 0, 1}, {kInf, 0, 0}, {0, -kInf, kNan}, {5000, 0, 0}, {0, 0, 1e30F}};
  EXPECT_EQ(map.insert(cloud, Pose::Identity()), Outcome::inserted);
  EXPECT_EQ(map.blocks().size(), 0U);
  EXPECT_EQ(map.counts().not_finite, 3U);
  EXPECT_EQ(map.counts().outside_octree, 2U);
  EXPECT_EQ(map.insert(PointCloud{}, Pose::Identity()), Outcome::inserted);
  Pose broken = Pose::Identity();
  broken(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(map.insert(cloud, broken), Outcome::rejected);
}

TEST(OctoMapper, discretized_clouds_ignore_points_of_no_use) {
  OctoMapper::Options options = with_max_range(3.0);
  options.discretize = true;
  OctoMapper map(options);
  OctoMapper clean(options);
  PointCloud cloud;
  cloud.points = {{1, 0, 0}, {1.01F, 0, 0}, {0, 1, 0}};
  clean.insert(cloud, kHere);
  cloud.points.insert(cloud.points.end(), {{kNan, 0, 1}, {kInf, 0, 0}});
  map.insert(cloud, kHere);
  EXPECT_EQ(bytes(octree(map)), bytes(octree(clean)));
  EXPECT_EQ(map.counts().hits, 2U);
}

TEST(OctoMapper, a_sensor_outside_of_the_octree_marks_ends_alone_as_the_library_does) {
  const OctoMapper::Options options = with_max_range(-1.0);
  OctoMapper map(options);
  octomap::OcTree expected = empty_tree(options);
  const Pose outside(Eigen::Translation3d(3277.0, 0.0, 0.0));
  PointCloud cloud;
  cloud.points = {{-2, 0, 0}, {-3, 1, 0}, {4, 0, 0}};
  map.insert(cloud, outside);
  insert(expected, options, cloud, outside);
  EXPECT_EQ(bytes(octree(map)), bytes(expected));
  EXPECT_EQ(map.counts().outside_octree, 1U);
}

TEST(OctoMapper, far_points_that_no_dense_volume_holds_make_the_same_tree) {
  const OctoMapper::Options options = with_max_range(-1.0);
  OctoMapper map(options);
  octomap::OcTree expected = empty_tree(options);
  Random random(3);
  PointCloud cloud = random_cloud(random, 200, 6.0, 0.1);
  cloud.points.insert(cloud.points.end(),
                      {{900, 800, 700}, {-900, 20, 30}, {3, -1500, 400}, {900, 800, 700.1F}});
  map.insert(cloud, kHere);
  insert(expected, options, cloud, kHere);
  EXPECT_EQ(bytes(octree(map)), bytes(expected));
}

TEST(OctoMapper, min_range_ignores_what_is_too_near) {
  OctoMapper::Options options = with_max_range(-1.0);
  options.sensor_model.min_range = 0.5;
  OctoMapper map(options);
  PointCloud cloud;
  cloud.points = {{0.4F, 0, 0}, {0, 0.6F, 0}};
  map.insert(cloud, kHere);
  EXPECT_EQ(map.counts().too_near, 1U);
  EXPECT_FALSE(map.log_odds({0.35F, 0.05F, 0.05F}));
  EXPECT_TRUE(map.log_odds({0.05F, 0.35F, 0.05F}));
}

TEST(OctoMapper, no_returns_clear_up_to_the_maximum_range_if_told_so) {
  OctoMapper::Options options = with_max_range(1.0);
  PointCloud cloud;
  cloud.no_returns = {{1, 0, 0}};
  OctoMapper silent(options);
  silent.insert(cloud, kHere);
  EXPECT_EQ(silent.blocks().size(), 0U);
  EXPECT_EQ(silent.counts().silent, 1U);

  options.no_return = NoReturn::clear;
  OctoMapper map(options);
  map.insert(cloud, kHere);
  EXPECT_LT(map.log_odds({0.95F, 0.05F, 0.05F}).value(), 0.0F);
  EXPECT_FALSE(map.log_odds({1.15F, 0.05F, 0.05F}));

  PointCloud beyond;  // the library's way to say the same
  beyond.points = {{7, 0, 0}};
  OctoMapper same(options);
  same.insert(beyond, kHere);
  EXPECT_EQ(bytes(octree(map)), bytes(octree(same)));
}

TEST(OctoMapper, clearing_no_returns_needs_a_maximum_range) {
  OctoMapper::Options options;
  options.no_return = NoReturn::clear;
  EXPECT_THROW(OctoMapper{options}, OptionsError);
}

TEST(OctoMapper, ground_is_cleared_up_to_it_and_no_obstacle) {
  OctoMapper map(with_max_range(-1.0));
  GroundedCloud cloud;
  cloud.obstacles.points = {{0, 1, 0}};
  cloud.ground = {{1, 0, 0}};
  map.insert(cloud, kHere);
  EXPECT_GT(map.log_odds({0.05F, 1.05F, 0.05F}).value(), 0.0F);
  EXPECT_LT(map.log_odds({0.95F, 0.05F, 0.05F}).value(), 0.0F);
  EXPECT_FALSE(map.log_odds({1.05F, 0.05F, 0.05F}));
}

TEST(OctoMapper, a_scan_marks_and_clears_as_its_readings_say) {
  OctoMapper::Options options = with_max_range(2.0);
  options.no_return = NoReturn::clear;
  OctoMapper map(options);
  RangeScan scan;
  scan.angle_increment = M_PI / 2.0;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  scan.ranges = {1.0F, kInf, kNan, 5.0F};
  EXPECT_EQ(map.insert(scan, kHere), Outcome::inserted);
  EXPECT_GT(map.log_odds({1.05F, 0.05F, 0.05F}).value(), 0.0F);
  EXPECT_LT(map.log_odds({0.05F, 1.95F, 0.05F}).value(), 0.0F);
  EXPECT_FALSE(map.log_odds({-0.15F, 0.05F, 0.05F}));
  EXPECT_LT(map.log_odds({0.05F, -1.75F, 0.05F}).value(), 0.0F);
  scan.angle_increment = 0.0;
  EXPECT_EQ(map.insert(scan, kHere), Outcome::unusable);
}

TEST(OctoMapper, beams_of_a_slow_scan_start_where_the_sensor_was) {
  OctoMapper map(with_max_range(-1.0));
  RangeScan scan;
  scan.angle_increment = 1e-9;
  scan.range_max = 30.0;
  scan.ranges = {1.0F, 1.0F, 1.0F};
  scan.T_first_last = Pose(Eigen::Translation3d(0.0, 2.0, 0.0));
  map.insert(scan, kHere);
  for (const float y : {0.05F, 1.05F, 2.05F}) {
    EXPECT_GT(map.log_odds({1.05F, y, 0.05F}).value(), 0.0F) << y;
    EXPECT_LT(map.log_odds({0.05F, y, 0.05F}).value(), 0.0F) << y;
  }
}

TEST(OctoMapper, a_cleared_box_frees_what_is_known_in_it_and_no_more) {
  const OctoMapper::Options options = with_max_range(-1.0);
  OctoMapper map(options);
  PointCloud cloud;
  cloud.points = {{1, 0, 0}, {0, 1, 0}};
  map.insert(cloud, kHere);
  const ClearBox box{{Eigen::Vector3d(0.5, -0.5, -0.5), Eigen::Vector3d(1.5, 0.5, 0.5)}};
  EXPECT_EQ(map.insert(box, Pose::Identity()), Outcome::inserted);
  EXPECT_EQ(map.log_odds({1.05F, 0.05F, 0.05F}), octomap::logodds(options.sensor_model.min));
  EXPECT_EQ(map.log_odds({0.75F, 0.05F, 0.05F}), octomap::logodds(options.sensor_model.min));
  EXPECT_EQ(map.log_odds({0.25F, 0.05F, 0.05F}), octomap::logodds(options.sensor_model.miss));
  EXPECT_GT(map.log_odds({0.05F, 1.05F, 0.05F}).value(), 0.0F);
  EXPECT_FALSE(map.log_odds({1.25F, 0.05F, 0.05F}));
  EXPECT_EQ(map.insert(ClearBox{}, Pose::Identity()), Outcome::unusable);
}

TEST(OctoMapper, a_cleared_box_turns_with_its_pose) {
  OctoMapper map(with_max_range(-1.0));
  PointCloud cloud;
  cloud.points = {{0, 1, 0}};
  map.insert(cloud, kHere);
  const ClearBox box{{Eigen::Vector3d(0.9, -0.2, -0.2), Eigen::Vector3d(1.2, 0.2, 0.2)}};
  map.insert(box, Pose::Identity());
  EXPECT_GT(map.log_odds({0.05F, 1.05F, 0.05F}).value(), 0.0F);
  map.insert(box, planar_pose(0.0, 0.0, M_PI / 2.0));
  EXPECT_LT(map.log_odds({0.05F, 1.05F, 0.05F}).value(), 0.0F);
}

TEST(OctoMapper, tells_what_changed) {
  OctoMapper map(with_max_range(-1.0));
  PointCloud cloud;
  cloud.points = {{1, 0, 0}};
  map.insert(cloud, kHere);
  const OctoMapper::Revision before = map.revision();
  EXPECT_FALSE(map.changed_since(before));
  map.insert(cloud, Pose(Eigen::Translation3d(10.05, 0.05, 0.05)));
  const auto box = map.changed_since(before);
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->contains(Eigen::Vector3d(11.05, 0.05, 0.05)));
  EXPECT_FALSE(box->contains(Eigen::Vector3d(1.05, 0.05, 0.05)));
}

TEST(OctoMapper, ten_million_points_are_drawn) {
  OctoMapper::Options options = with_max_range(-1.0);
  options.discretize = true;
  OctoMapper map(options);
  PointCloud cloud;
  cloud.points.assign(10'000'000, Eigen::Vector3f(0.5F, 0.5F, 0.0F));
  EXPECT_EQ(map.insert(cloud, kHere), Outcome::inserted);
  EXPECT_EQ(map.counts().hits, 1U);
}

}  // namespace
}  // namespace portolan::octo_test
