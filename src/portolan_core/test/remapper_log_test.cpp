// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "portolan/remapper.hpp"
#include "remapper_fixture.hpp"

namespace portolan {
namespace {

TEST(RemapperLog, KeepsWhatWasRejectedButNotWhatIsUnusable) {
  ListMapper::Options options;
  options.reach = 5.0;
  ListRemapper remapper(RemapperOptions{}, options);
  EXPECT_EQ(remapper.observe(at_second(0), planar_pose(9, 0, 0), Sight{1}), Outcome::rejected);
  EXPECT_EQ(remapper.observe(at_second(0), planar_pose(1, 0, 0), Sight{-1}), Outcome::unusable);
  EXPECT_EQ(remapper.observe(at_second(0), planar_pose(1, 0, 0), Sight{2}), Outcome::inserted);
  EXPECT_EQ(remapper.log_size(), 2u);
  EXPECT_EQ(remapper.map().ids(), Ids{2});
  remapper.correct(Correction({{at_second(0), planar_pose(-5.0, 0.0, 0.0)}}));
  remapper.finish();
  EXPECT_EQ(remapper.map().ids(), (Ids{1, 2}));
}

TEST(RemapperLog, TurnsAwayWhatHasNoPose) {
  ListRemapper remapper = unlimited();
  Pose broken = Pose::Identity();
  broken.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(remapper.observe(Time(), broken, Sight{1}), Outcome::rejected);
  EXPECT_EQ(remapper.log_size(), 0u);
  EXPECT_TRUE(remapper.map().ids().empty());
}

TEST(RemapperLog, ThinsMapAndLogAlike) {
  RemapperOptions options;
  options.thinning.min_travel = 1.0;
  ListRemapper remapper(options, ListMapper::Options{});
  EXPECT_EQ(remapper.observe(Time(), planar_pose(0, 0, 0), Sight{-1}), Outcome::unusable);
  EXPECT_EQ(remapper.observe(Time(), planar_pose(0, 0, 0), Sight{0}), Outcome::inserted);
  EXPECT_EQ(remapper.observe(Time(), planar_pose(0.5, 0, 0), Sight{1}), std::nullopt);
  EXPECT_EQ(remapper.observe(Time(), planar_pose(0.5, 0, 0), Sight{2}, 7), Outcome::inserted);
  EXPECT_EQ(remapper.observe(Time(), planar_pose(1, 0, 0), Sight{3}), Outcome::inserted);
  EXPECT_EQ(remapper.map().ids(), (Ids{0, 2, 3}));
  EXPECT_EQ(remapper.log_size(), 3u);
}

TEST(RemapperLog, TheBudgetFreezesTheOldestAndNoMore) {
  const Drive drive(7, 30);
  ListRemapper remapper = with_room_for(10);
  drive.observe(remapper, 0, 10);
  EXPECT_EQ(remapper.frozen(), 0u);
  drive.observe(remapper, 10, 30);
  EXPECT_EQ(remapper.frozen(), 20u);
  EXPECT_EQ(remapper.log_size(), 10u);
  const Correction correction = random_correction(7);
  remapper.correct(correction);
  remapper.finish();
  ASSERT_EQ(remapper.map().ids().size(), 30u);
  for (std::size_t i = 0; i < 30; ++i) {
    const Pose moved = correction.at(at_second(static_cast<double>(i))) * drive.poses[i];
    const Pose& expected = i < 20 ? drive.poses[i] : moved;
    EXPECT_EQ(remapper.map().poses()[i].matrix(), expected.matrix()) << i;
  }
}

TEST(RemapperLog, FreezingDuringARedrawChangesNothingInTheMap) {
  for (int slices = 0; slices <= 11; ++slices) {
    const Drive drive(8, 30);
    ListRemapper remapper = with_room_for(10);
    drive.observe(remapper, 0, 10);
    remapper.correct(random_correction(8));
    for (int i = 0; i < slices; ++i) remapper.replay(kNoTime);
    drive.observe(remapper, 10, 30);
    EXPECT_EQ(remapper.frozen(), 20u);
    remapper.finish();
    expect_equal(remapper.map(), told_early(drive, random_correction(8)));
    remapper.correct(correction_from(1000.0, 1.0));
    remapper.finish();  // base and log still make the same list
    EXPECT_EQ(remapper.map().ids(), told_early(drive, Correction()).ids());
  }
}

TEST(RemapperLog, ABudgetBelowOneObservationFreezesEach) {
  const Drive drive(9, 5);
  RemapperOptions options;
  options.log_budget = 1e-6;
  ListRemapper remapper(options, ListMapper::Options{});
  drive.observe_all(remapper);
  EXPECT_EQ(remapper.log_size(), 0u);
  EXPECT_EQ(remapper.log_bytes(), 0u);
  EXPECT_EQ(remapper.frozen(), 5u);
  remapper.correct(random_correction(9));
  EXPECT_TRUE(remapper.is_up_to_date());
  expect_equal(remapper.map(), told_early(drive, Correction()));
}

TEST(RemapperLog, FreezeKeepsWhatTheMapShows) {
  const Drive drive(10);
  ListRemapper remapper = unlimited();
  drive.observe(remapper, 0, 10);
  remapper.correct(random_correction(1));
  remapper.freeze();
  EXPECT_EQ(remapper.log_size(), 0u);
  EXPECT_EQ(remapper.log_bytes(), 0u);
  const ListMapper frozen = remapper.map();
  remapper.correct(random_correction(2));
  drive.observe(remapper, 10, 40);
  remapper.correct(random_correction(3));
  remapper.finish();
  const ListMapper corrected = told_early(drive, random_correction(3));
  ASSERT_EQ(remapper.map().ids(), corrected.ids());
  for (std::size_t i = 0; i < 40; ++i) {
    const ListMapper& expected = i < 10 ? frozen : corrected;
    EXPECT_EQ(remapper.map().poses()[i].matrix(), expected.poses()[i].matrix()) << i;
  }
}

TEST(RemapperLog, RestartsFromAnotherMapUnderTheSameCorrection) {
  const Drive drive(11);
  ListRemapper remapper = unlimited();
  drive.observe(remapper, 0, 10);
  remapper.correct(random_correction(1));
  remapper.finish();
  ListMapper loaded{ListMapper::Options{}};
  loaded.insert(Sight{77}, Pose::Identity());
  const std::size_t generation = remapper.generation();
  remapper.restart_from(loaded);
  EXPECT_NE(remapper.generation(), generation);
  EXPECT_EQ(remapper.log_size(), 0u);
  expect_equal(remapper.map(), loaded);
  EXPECT_EQ(remapper.correction().knots().size(), 5u);
  remapper.observe(at_second(50), Pose::Identity(), Sight{78});
  remapper.correct(Correction());
  remapper.finish();
  EXPECT_EQ(remapper.map().ids(), (Ids{77, 78}));
  EXPECT_EQ(remapper.map().poses()[1].matrix(), Pose::Identity().matrix());
}

TEST(RemapperLog, RestartsUnderTheCorrectionThatWaited) {
  const Drive drive(12);
  ListRemapper remapper = unlimited();
  drive.observe_all(remapper);
  remapper.correct(random_correction(1));
  remapper.replay(kNoTime);
  remapper.correct(correction_from(0.0, 4.0));
  remapper.restart_from(ListMapper(ListMapper::Options{}));
  EXPECT_TRUE(remapper.is_up_to_date());
  remapper.observe(at_second(50), Pose::Identity(), Sight{1});
  EXPECT_EQ(remapper.map().poses().at(0).translation().x(), 4.0);
}

TEST(RemapperLog, ResetForgetsEverything) {
  RemapperOptions options;
  options.thinning.min_travel = 1.0;
  ListRemapper remapper(options, ListMapper::Options{});
  remapper.observe(at_second(50), Pose::Identity(), Sight{1});
  remapper.correct(random_correction(1));
  remapper.replay(kNoTime);
  remapper.correct(random_correction(2));
  remapper.reset();
  EXPECT_TRUE(remapper.is_up_to_date());
  EXPECT_TRUE(remapper.map().ids().empty());
  EXPECT_TRUE(remapper.correction().knots().empty());
  EXPECT_EQ(remapper.log_size(), 0u);
  EXPECT_EQ(remapper.log_bytes(), 0u);
  EXPECT_EQ(remapper.observe(at_second(50), Pose::Identity(), Sight{2}), Outcome::inserted);
  remapper.finish();
  EXPECT_EQ(remapper.map().ids(), Ids{2});
  EXPECT_EQ(remapper.map().poses()[0].matrix(), Pose::Identity().matrix());
}

TEST(RemapperLog, ObservationsMayComeOutOfOrder) {
  ListRemapper remapper = unlimited();
  for (const int s : {3, 1, 2}) remapper.observe(at_second(s), Pose::Identity(), Sight{s});
  remapper.correct(correction_from(1.5, 2.0));
  remapper.finish();
  EXPECT_EQ(remapper.map().ids(), (Ids{3, 1, 2}));  // as they came, not as they were seen
  EXPECT_EQ(remapper.map().poses()[0].translation().x(), 2.0);
  EXPECT_EQ(remapper.map().poses()[1].translation().x(), 0.0);
}

TEST(RemapperLog, RefusesOptionsThatMakeNoSense) {
  RemapperOptions options;
  options.log_budget = 0.0;
  EXPECT_THROW(ListRemapper(options, ListMapper::Options{}), OptionsError);
  ListMapper::Options mapper_options;
  mapper_options.reach = -1.0;
  EXPECT_THROW(ListRemapper(RemapperOptions{}, mapper_options), OptionsError);
}

}  // namespace
}  // namespace portolan
