// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/pipeline.hpp"

#include <gtest/gtest.h>

#include "posed_input_fixture.hpp"
#include "toy_kind.hpp"

namespace portolan {
namespace {

/// A robot that drives along x with 1 m/s, its sensors in its middle.
class PipelineTest : public testing::Test {
 protected:
  void begin(PipelineOptions options) {
    options.posing.order_wait = 0.0;
    pipeline.emplace(options, ToyMapper::Options());
    scans = pipeline->add_input("scans");
    echoes = pipeline->add_input("echoes");
  }
  void SetUp() override { begin({}); }

  void odometry(double s) {
    const Pose T_odom_base = planar_pose(s, 0.0, 0.0);
    pipeline->receive_tf(tf_message(transform("odom", "base_link", s, T_odom_base)), false, now);
  }
  void scan(double first, double last, const std::string& frame = "base_link") {
    RangeScan z;
    z.ranges = {1.0F, 2.0F};
    pipeline->receive(
        scans, std::optional(Sensed<RangeScan>{frame, at(first), at(last), std::move(z)}), now);
  }
  void echo(double s, double range = 1.0, const std::string& frame = "base_link") {
    RangeEcho z;
    z.range = range;
    pipeline->receive(echoes, std::optional(Sensed<RangeEcho>{frame, at(s), at(s), z}), now);
  }
  /// One lap of a bag: clock, odometry and a scan at each second from `from` on.
  void drive(double from, int count) {
    for (int i = 0; i < count; ++i) {
      now = at(from + i);
      odometry(from + i);
      scan(from + i, from + i);
    }
  }

  const std::vector<ToyMapper::Entry>& map() const { return pipeline->remapper().map().entries(); }
  std::vector<double> places() const {
    std::vector<double> xs;
    for (const auto& entry : map()) xs.push_back(entry.T_map_sensor.translation().x());
    return xs;
  }
  const Tally& tally(std::size_t input) const { return pipeline->posed().tallies()[input]; }

  Time now = at(1.0);
  std::optional<Pipeline<ToyKind>> pipeline;
  std::size_t scans = 0;
  std::size_t echoes = 0;
};

TEST_F(PipelineTest, BringsMessagesOfAllInputsIntoTheMap) {
  odometry(1.0);
  odometry(2.0);
  scan(1.5, 1.5);
  echo(1.75, 0.7);
  ASSERT_EQ(map().size(), 2u);
  EXPECT_EQ(std::get<RangeScan>(map()[0].z).ranges, (std::vector<float>{1.0F, 2.0F}));
  EXPECT_EQ(std::get<RangeEcho>(map()[1].z).range, 0.7);
  EXPECT_NEAR(places()[0], 1.5, 1e-9);
  EXPECT_NEAR(places()[1], 1.75, 1e-9);
  EXPECT_EQ(tally(scans).used(), 1u);
  EXPECT_EQ(tally(echoes).used(), 1u);
}

TEST_F(PipelineTest, TellsScansHowTheSensorMoved) {
  odometry(1.0);
  scan(1.25, 1.75);
  odometry(2.0);
  ASSERT_EQ(map().size(), 1u);
  const Pose& moved = std::get<RangeScan>(map()[0].z).T_first_last;
  EXPECT_TRUE(moved.isApprox(planar_pose(0.5, 0.0, 0.0), 1e-9));
}

TEST_F(PipelineTest, CountsWhatTheMapperRefuses) {
  odometry(1.0);
  odometry(2.0);
  echo(1.1, 13.0);
  pipeline->remapper().correct(Correction({{at(0.0), planar_pose(-9.0, 0.0, 0.0)}}));
  echo(1.2);
  pipeline->receive(echoes, std::optional<Sensed<RangeEcho>>(), now);
  EXPECT_EQ(tally(echoes).received(), 3u);
  EXPECT_EQ(tally(echoes).dropped(Drop::unusable), 1u);
  EXPECT_EQ(tally(echoes).dropped(Drop::rejected), 1u);
  EXPECT_EQ(tally(echoes).dropped(Drop::malformed), 1u);
  EXPECT_EQ(tally(echoes).waiting(), 0u);
  EXPECT_TRUE(map().empty());
}

TEST_F(PipelineTest, CountsWhatIsThinnedForEachSensorByItself) {
  PipelineOptions options;
  options.remapper.thinning.min_travel = 0.5;
  begin(options);
  odometry(1.0);
  odometry(3.0);
  for (const double s : {1.0, 1.25, 1.5, 1.75, 2.0}) scan(s, s);
  echo(1.1);                       // another input
  scan(1.3, 1.3, "odom");          // another sensor
  scan(2.25, 2.25, "/base_link");  // the first one by its old name
  EXPECT_EQ(tally(scans).received(), 7u);
  EXPECT_EQ(tally(scans).used(), 4u);
  EXPECT_EQ(tally(scans).dropped(Drop::thinned), 3u);
  EXPECT_EQ(tally(echoes).used(), 1u);
}

TEST_F(PipelineTest, ACorrectionBendsTheMap) {
  const Correction correction(
      {{at(1.0), planar_pose(0.0, 1.0, 0.0)}, {at(2.0), planar_pose(10.0, 1.0, 0.0)}});
  drive(1.0, 2);
  pipeline->remapper().correct(correction);
  pipeline->remapper().finish();
  drive(3.0, 1);
  ASSERT_EQ(map().size(), 3u);
  EXPECT_EQ(places(), (std::vector<double>{1.0, 12.0, 13.0}));
}

TEST_F(PipelineTest, StartsAnewWhenTheClockRunsBack) {
  pipeline->remapper().correct(Correction({{at(0.0), planar_pose(100.0, 0.0, 0.0)}}));
  drive(10.0, 5);
  EXPECT_EQ(places(), (std::vector<double>{110.0, 111.0, 112.0, 113.0, 114.0}));
  drive(10.0, 3);
  EXPECT_EQ(places(), (std::vector<double>{10.0, 11.0, 12.0}));  // from the very first message
  EXPECT_EQ(pipeline->time_jumps(), 1u);
  EXPECT_EQ(tally(scans).used(), 8u);
}

TEST_F(PipelineTest, KeepsTheMapOnRequestWhenTheClockRunsBack) {
  PipelineOptions options;
  options.on_time_jump = OnTimeJump::keep;
  begin(options);
  drive(10.0, 3);
  drive(10.0, 2);
  EXPECT_EQ(places(), (std::vector<double>{10.0, 11.0, 12.0, 10.0, 11.0}));
  pipeline->remapper().correct(Correction({{at(0.0), planar_pose(100.0, 0.0, 0.0)}}));
  pipeline->remapper().finish();  // what was there before the jump can no longer move
  EXPECT_EQ(places(), (std::vector<double>{10.0, 11.0, 12.0, 110.0, 111.0}));
  EXPECT_EQ(pipeline->time_jumps(), 1u);
}

/// A map of 10, 11, 12 m that is to be kept, and was moved by 100 m.
class KeptMapTest : public PipelineTest {
 protected:
  void SetUp() override {
    PipelineOptions options;
    options.on_time_jump = OnTimeJump::keep;
    begin(options);
    drive(10.0, 3);
    pipeline->correct(Correction({{at(0.0), planar_pose(100.0, 0.0, 0.0)}}), at(12.0), now);
    pipeline->remapper().finish();
  }
  void expect_places(const std::vector<double>& expected) {
    pipeline->remapper().finish();
    EXPECT_EQ(places(), expected);
  }
};

TEST_F(KeptMapTest, StaysWhereTheOneWhoCorrectsNoticesFirstThatTimeRanBack) {
  pipeline->correct(Correction(), at(5.0), now);
  expect_places({110.0, 111.0, 112.0});
  pipeline->correct(Correction({{at(0.0), planar_pose(7.0, 0.0, 0.0)}}), at(5.5), now);
  expect_places({110.0, 111.0, 112.0});
  drive(6.0, 2);
  expect_places({110.0, 111.0, 112.0, 13.0, 14.0});
  EXPECT_EQ(pipeline->time_jumps(), 1u);
}

TEST_F(KeptMapTest, StaysWhereTheOneWhoCorrectsNoticesLast) {
  drive(6.0, 1);
  pipeline->correct(Correction(), at(6.5), now);
  expect_places({110.0, 111.0, 112.0, 6.0});
  EXPECT_EQ(pipeline->time_jumps(), 1u);
}

TEST_F(KeptMapTest, FollowsACorrectionWhoseSenderAloneSetItsClockBack) {
  pipeline->correct(Correction(), at(5.0), now);
  drive(13.0, 3);
  expect_places({10.0, 11.0, 12.0, 13.0, 14.0, 15.0});
  EXPECT_EQ(pipeline->time_jumps(), 0u);
}

TEST_F(PipelineTest, CountsWhatWaitedWhenTheClockRanBack) {
  now = at(50.0);
  scan(50.0, 50.0);
  now = at(10.0);
  pipeline->poll(now);
  EXPECT_EQ(tally(scans).dropped(Drop::time_ran_back), 1u);
  EXPECT_EQ(tally(scans).waiting(), 0u);
}

TEST_F(PipelineTest, AJumpByMoreThanTfRemembersIsOneJump) {
  drive(1000.0, 3);
  drive(10.0, 3);
  EXPECT_EQ(pipeline->time_jumps(), 1u);
  EXPECT_EQ(places(), (std::vector<double>{10.0, 11.0, 12.0}));
}

TEST_F(PipelineTest, StartsAnewWhenOnlyStampsRunBack) {
  now = at(5000.0);  // a bag that loops without a clock: nobody tells its time
  for (const double s : {1000.0, 1001.0, 10.0, 11.0, 12.0}) {
    odometry(s);
    scan(s, s);
  }
  EXPECT_EQ(pipeline->time_jumps(), 1u);
  EXPECT_EQ(places(), (std::vector<double>{11.0, 12.0}));
  EXPECT_EQ(tally(scans).dropped(Drop::time_ran_back), 1u);
}

TEST_F(PipelineTest, TakesOdometryForTf) {
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(1, 0);
  message.pose.pose.position.x = 7.0;
  message.pose.pose.orientation.w = 1.0;
  scan(1.0, 1.0);
  pipeline->receive_odometry(message, now);
  EXPECT_EQ(places(), std::vector<double>{7.0});
}

TEST_F(PipelineTest, RefusesNonsense) {
  PipelineOptions options;
  options.posing.tf_wait = -1.0;
  EXPECT_THROW(Pipeline<ToyKind>(options, ToyMapper::Options()), OptionsError);
  ToyMapper::Options mapper_options;
  mapper_options.resolution = 0.0;
  EXPECT_THROW(Pipeline<ToyKind>(PipelineOptions(), mapper_options), OptionsError);
}

}  // namespace
}  // namespace portolan
