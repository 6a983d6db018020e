// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/remapper.hpp"

#include <gtest/gtest.h>

#include "remapper_fixture.hpp"

namespace portolan {
namespace {

TEST(Remapper, ToldLateEqualsToldEarly) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Drive drive(seed);
    ListRemapper late = unlimited();
    drive.observe(late, 0, 15);
    late.correct(random_correction(seed + 100));
    drive.observe(late, 15, 40);
    late.correct(random_correction(seed));
    late.finish();
    expect_equal(late.map(), told_early(drive, random_correction(seed)));
  }
}

TEST(Remapper, SlicesWithObservationsBetweenThemEqualOneReplay) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Drive drive(seed);
    std::mt19937_64 random(seed);
    ListRemapper remapper = unlimited();
    drive.observe(remapper, 0, 20);
    remapper.correct(random_correction(seed));
    for (int next = 20; next < 40 || !remapper.is_up_to_date();) {
      if (next < 40 && random() % 2 == 0) {
        drive.observe(remapper, next, next + 1);
        ++next;
      } else {
        remapper.replay(kNoTime);
      }
    }
    expect_equal(remapper.map(), told_early(drive, random_correction(seed)));
  }
}

TEST(Remapper, ShowsTheMapBeforeWhileItRedraws) {
  const Drive drive(1);
  ListRemapper remapper = unlimited();
  drive.observe(remapper, 0, 10);
  const ListMapper before = remapper.map();
  const Correction correction = random_correction(1);
  remapper.correct(correction);
  remapper.replay(kNoTime);
  expect_equal(remapper.map(), before);
  drive.observe(remapper, 10, 11);
  ASSERT_EQ(remapper.map().ids().size(), 11u);
  EXPECT_EQ(remapper.map().poses()[9].matrix(), drive.poses[9].matrix());
  const Pose corrected = correction.at(at_second(10)) * drive.poses[10];
  EXPECT_EQ(remapper.map().poses()[10].matrix(), corrected.matrix());
}

TEST(Remapper, EachCallDrawsOneObservationAtLeastAndSaysHowFarItIs) {
  const Drive drive(2);
  ListRemapper remapper = unlimited();
  drive.observe(remapper, 0, 4);
  EXPECT_EQ(remapper.progress(), 1.0);
  EXPECT_TRUE(remapper.replay(kNoTime));
  const std::size_t generation = remapper.generation();
  remapper.correct(random_correction(2));
  for (const double progress : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    EXPECT_EQ(remapper.progress(), progress);
    EXPECT_FALSE(remapper.is_up_to_date());
    EXPECT_EQ(remapper.generation(), generation);
    EXPECT_EQ(remapper.replay(kNoTime), progress == 1.0);
  }
  EXPECT_TRUE(remapper.is_up_to_date());
  EXPECT_EQ(remapper.progress(), 1.0);
  EXPECT_EQ(remapper.generation(), generation + 1);
}

TEST(Remapper, DrawsNothingAnewWhenNothingMoves) {
  ListRemapper remapper = unlimited();
  remapper.correct(random_correction(3));
  EXPECT_TRUE(remapper.is_up_to_date());  // nothing was seen yet
  Drive(3).observe(remapper, 0, 10);
  remapper.correct(random_correction(3));
  EXPECT_TRUE(remapper.is_up_to_date());
  std::vector<Correction::Knot> knots = random_correction(3).knots();
  knots.push_back({at_second(1000.0), Pose::Identity()});
  remapper.correct(Correction(knots));  // it says more of the time after the observations alone
  EXPECT_TRUE(remapper.is_up_to_date());
  EXPECT_EQ(remapper.correction().knots().size(), 6u);
}

TEST(Remapper, GoesOnRedrawingWhenNothingRedrawnMoves) {
  const Drive drive(4);
  ListRemapper remapper = unlimited();
  drive.observe_all(remapper);
  remapper.correct(correction_from(5.0, 1.0));
  for (int i = 0; i < 20; ++i) remapper.replay(kNoTime);
  remapper.correct(correction_from(5.0, 1.0));
  EXPECT_EQ(remapper.progress(), 0.5);
  std::vector<Correction::Knot> knots = correction_from(5.0, 1.0).knots();
  knots.push_back({at_second(30.0), planar_pose(1.0, 0.0, 0.0)});
  knots.push_back({at_second(31.0), planar_pose(2.0, 0.0, 0.0)});
  remapper.correct(Correction(knots));
  EXPECT_EQ(remapper.progress(), 0.5);
  remapper.finish();
  expect_equal(remapper.map(), told_early(drive, Correction(knots)));
}

TEST(Remapper, CorrectionsFasterThanARedrawDoNotStopTheMap) {
  const Drive drive(5);
  ListRemapper remapper = unlimited();
  drive.observe_all(remapper);
  const std::size_t generation = remapper.generation();
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    remapper.correct(random_correction(seed));
    remapper.replay(kNoTime);
  }
  EXPECT_GE(remapper.generation(), generation + 9);  // 41 calls a redraw
  remapper.finish();
  expect_equal(remapper.map(), told_early(drive, random_correction(399)));
}

TEST(Remapper, ACorrectionThatIsTakenBackWhileItWaitsIsForgotten) {
  const Drive drive(6);
  ListRemapper remapper = unlimited();
  drive.observe_all(remapper);
  remapper.correct(random_correction(1));
  remapper.replay(kNoTime);
  remapper.correct(random_correction(2));
  remapper.correct(random_correction(1));
  remapper.finish();
  expect_equal(remapper.map(), told_early(drive, random_correction(1)));
}

}  // namespace
}  // namespace portolan
