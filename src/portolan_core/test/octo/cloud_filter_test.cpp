// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/cloud_filter.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(PassThrough, judges_points_in_the_frame_of_choice) {
  PointCloud cloud;
  cloud.points = {{1, 0, 0}, {1, 0, 0.5F}, {1, 0, -0.9F}, {kNan, 0, 0}};
  cloud.no_returns = {{0, 1, 0}};
  PassThrough box;
  box.min_z = 0.2;
  box.max_z = 1.2;
  const Pose T_base_sensor(Eigen::Translation3d(0.0, 0.0, 1.0));
  const PointCloud kept = pass_through(cloud, T_base_sensor, box);
  ASSERT_EQ(kept.points.size(), 1U);
  EXPECT_EQ(kept.points[0], cloud.points[0]);
  EXPECT_EQ(kept.no_returns.size(), 1U);
}

TEST(PassThrough, lets_everything_through_by_default_and_refuses_an_empty_box) {
  Random random(1);
  const PointCloud cloud = random_cloud(random, 100, 5.0, 0.1);
  EXPECT_EQ(pass_through(cloud, Pose::Identity(), PassThrough{}).points, cloud.points);
  PassThrough box;
  box.min_x = 2.0;
  box.max_x = 1.0;
  EXPECT_THROW(checked(box), OptionsError);
}

TEST(Thinned, keeps_the_first_point_of_each_cube_where_it_is) {
  PointCloud cloud;
  cloud.points = {{0.01F, 0, 0}, {0.09F, 0, 0}, {-0.01F, 0, 0}, {kNan, 0, 0}, {0.11F, 0, 0}};
  const PointCloud thin = thinned(cloud, 0.1, 0.0);
  EXPECT_EQ(thin.points,
            (std::vector<Eigen::Vector3f>{cloud.points[0], cloud.points[2], cloud.points[4]}));
}

TEST(Thinned, keeps_one_no_return_for_each_cube_at_its_end) {
  PointCloud cloud;
  cloud.no_returns = {{1, 0, 0}, {1, 0.005F, 0}, {1, 0.02F, 0}};
  EXPECT_EQ(thinned(cloud, 0.1, 10.0).no_returns.size(), 2U);
}

TEST(Thinned, marks_nearly_the_same_voxels_with_fewer_points) {
  Random random(2);
  PointCloud cloud;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p(3.0, uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
    cloud.points.emplace_back(p.cast<float>());
  }
  const PointCloud thin = thinned(cloud, 0.1, 0.0);
  EXPECT_LT(thin.points.size(), cloud.points.size() / 20);
  EXPECT_EQ(thinned(thin, 0.1, 0.0).points, thin.points);
  EXPECT_EQ(thinned(cloud, 0.0, 0.0).points, cloud.points);
}

}  // namespace
}  // namespace portolan::octo_test
