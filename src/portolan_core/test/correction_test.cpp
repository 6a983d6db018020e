// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/correction.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "random_pose.hpp"

namespace portolan {
namespace {

Time at_second(double s) { return Time(seconds(s)); }

TEST(Correction, IsIdentityWithoutKnots) {
  EXPECT_EQ(Correction().at(at_second(5.0)).matrix(), Pose::Identity().matrix());
}

TEST(Correction, IsConstantOutsideItsKnots) {
  std::mt19937_64 random(1);
  const Pose first = random_pose(random);
  const Pose last = random_pose(random);
  const Correction correction({{at_second(1.0), first}, {at_second(2.0), last}});
  EXPECT_EQ(correction.at(Time::min()).matrix(), first.matrix());
  EXPECT_EQ(correction.at(at_second(0.999)).matrix(), first.matrix());
  EXPECT_EQ(correction.at(at_second(1.0)).matrix(), first.matrix());
  EXPECT_EQ(correction.at(at_second(2.0)).matrix(), last.matrix());
  EXPECT_EQ(correction.at(at_second(2.001)).matrix(), last.matrix());
  EXPECT_EQ(correction.at(Time::max()).matrix(), last.matrix());
}

TEST(Correction, OneKnotHoldsAlways) {
  const Correction correction({{at_second(10.0), planar_pose(1.0, 2.0, 3.0)}});
  for (const double s : {-100.0, 10.0, 100.0}) {
    EXPECT_EQ(correction.at(at_second(s)).matrix(), planar_pose(1.0, 2.0, 3.0).matrix());
  }
}

TEST(Correction, InterpolatesBetweenNeighbours) {
  const Correction correction({{at_second(0.0), planar_pose(0.0, 0.0, 0.0)},
                               {at_second(1.0), planar_pose(1.0, 0.0, 0.4)},
                               {at_second(3.0), planar_pose(1.0, 4.0, 0.4)}});
  EXPECT_TRUE(correction.at(at_second(0.25)).isApprox(planar_pose(0.25, 0.0, 0.1), 1e-12));
  EXPECT_TRUE(correction.at(at_second(1.5)).isApprox(planar_pose(1.0, 1.0, 0.4), 1e-12));
  EXPECT_TRUE(correction.at(at_second(2.5)).isApprox(planar_pose(1.0, 3.0, 0.4), 1e-12));
}

TEST(Correction, IsExactAtItsKnots) {
  std::mt19937_64 random(2);
  std::vector<Correction::Knot> knots;
  knots.reserve(20);
  for (int i = 0; i < 20; ++i) knots.push_back({at_second(i), random_pose(random)});
  const Correction correction(knots);
  for (const Correction::Knot& knot : knots) {
    EXPECT_EQ(correction.at(knot.stamp).matrix(), knot.T_map_odom.matrix());
  }
}

TEST(Correction, AnotherKnotThatSaysTheSameMovesNothing) {
  std::mt19937_64 random(3);
  const Pose T_map_odom = random_pose(random);
  const Correction before({{at_second(1.0), T_map_odom}});
  const Correction after({{at_second(1.0), T_map_odom}, {at_second(2.0), T_map_odom}});
  for (double s = 0.9; s < 2.2; s += 0.01) {
    EXPECT_EQ(before.at(at_second(s)).matrix(), after.at(at_second(s)).matrix());
  }
}

TEST(Correction, KeepsNanosecondsOfStampsFarFromTheirEpoch) {
  const Time start(std::chrono::hours(24 * 365 * 54));
  const Correction correction(
      {{start, planar_pose(0.0, 0.0, 0.0)}, {start + Duration(2), planar_pose(2.0, 0.0, 0.0)}});
  EXPECT_NEAR(correction.at(start + Duration(1)).translation().x(), 1.0, 1e-12);
}

TEST(Correction, RefusesStampsThatDoNotIncrease) {
  const Pose pose = Pose::Identity();
  EXPECT_THROW(Correction({{at_second(1.0), pose}, {at_second(1.0), pose}}), std::invalid_argument);
  EXPECT_THROW(Correction({{at_second(2.0), pose}, {at_second(1.0), pose}}), std::invalid_argument);
}

TEST(Correction, RefusesPosesThatAreNotRigid) {
  Pose pose = Pose::Identity();
  pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Correction({{at_second(1.0), pose}}), std::invalid_argument);
  pose = Pose::Identity();
  pose.linear() *= 2.0;
  EXPECT_THROW(Correction({{at_second(1.0), Pose::Identity()}, {at_second(2.0), pose}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace portolan
