// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/posed_input.hpp"

#include "posed_input_fixture.hpp"

namespace portolan {
namespace {

TEST_F(PosedInputTest, UsesAMessageAtOnceWhereTfIsThere) {
  odometry(99.0);
  odometry(100.0);
  scan("a", 99.5);
  ASSERT_EQ(names(), "a");
  EXPECT_TRUE(used[0].pose.T_odom_sensor.isApprox(T_odom_base(99.5) * T_base_laser(), 1e-9));
  EXPECT_TRUE(used[0].pose.T_first_last.isApprox(Pose::Identity(), 1e-12));
  EXPECT_EQ(tally().sentence(), "1 of 1 scans used");
}

TEST_F(PosedInputTest, WaitsForTfThatIsLate) {
  odometry(99.0);
  scan("a", 99.5);
  EXPECT_EQ(names(), "");
  EXPECT_EQ(tally().waiting(), 1u);
  now += seconds(0.9);
  odometry(99.4);  // not yet
  EXPECT_EQ(tally().waiting(), 1u);
  odometry(99.6);
  EXPECT_EQ(names(), "a");
  EXPECT_EQ(tally().waiting(), 0u);
}

TEST_F(PosedInputTest, DropsWhatTfDoesNotTellInTime) {
  for (int i = 0; i < 330; ++i) {
    const double s = 100.0 + 0.125 * i;
    now = at(s);
    odometry(s - 0.8 - 1.125);  // tf runs late by more than a scan waits
    if (i < 312) scan("a", s);
  }
  EXPECT_EQ(names(), "");
  EXPECT_EQ(tally().sentence(),
            "0 of 312 scans used: no transform odom <- laser at their stamps; newest is 0.8 s "
            "older");
}

TEST_F(PosedInputTest, WaitsNoLongerThanItShould) {
  odometry(99.0);
  scan("a", 100.0);
  now += seconds(1.0);
  input.poll(now);
  EXPECT_EQ(tally().waiting(), 1u);
  now += seconds(0.001);
  input.poll(now);
  EXPECT_EQ(dropped(Drop::no_transform), 1u);
  odometry(100.5);
  EXPECT_EQ(names(), "");
}

TEST_F(PosedInputTest, SaysWhenTfBeganTooLate) {
  odometry(99.0);
  scan("a", 70.0);
  now += seconds(2.0);
  input.poll(now);
  EXPECT_EQ(tally().sentence(),
            "0 of 1 scans used: no transform odom <- laser at their stamps; newest is 29.0 s "
            "newer");
}

TEST_F(PosedInputTest, SaysWhichFrameIsMissing) {
  scan("a", 99.0);
  now += seconds(2.0);
  input.poll(now);
  EXPECT_EQ(tally().sentence(),
            "0 of 1 scans used: no transform odom <- laser: tf knows no frame odom");
  odometry(99.0);
  scan("b", 99.0, "lidar");
  now += seconds(2.0);
  input.poll(now);
  EXPECT_NE(tally().sentence().find("odom <- lidar: tf knows no frame lidar"), std::string::npos);
  scan("c", 99.0, "");
  now += seconds(2.0);
  input.poll(now);
  EXPECT_NE(tally().sentence().find("they name no frame"), std::string::npos);
}

TEST_F(PosedInputTest, UsesWhatWaitedInTheOrderOfItsStamps) {
  const std::size_t echoes = input.add_input("echoes");
  scan("c", 99.3);
  input.receive(echoes, message("b", 99.2, 99.2), now);
  scan("d", 99.4);
  input.receive(echoes, message("a", 99.1, 99.1), now);
  input.receive(echoes, message("c2", 99.3, 99.3), now);
  odometry(99.0);
  EXPECT_EQ(names(), "");
  odometry(100.0);
  EXPECT_EQ(names(), "a b c c2 d");
  EXPECT_EQ(tally(scans).used(), 2u);
  EXPECT_EQ(tally(echoes).used(), 3u);
}

TEST_F(PosedInputTest, OneThatCannotBePosedDoesNotHoldUpTheOthers) {
  odometry(99.0);
  odometry(100.0);
  scan("a", 99.1, "lidar");
  scan("b", 99.2);
  EXPECT_EQ(names(), "b");
  EXPECT_EQ(tally().waiting(), 1u);
}

TEST_F(PosedInputTest, KeepsNoMoreThanTheQueueHolds) {
  odometry(99.0);
  for (int i = 0; i < 23; ++i) scan(std::string(1, static_cast<char>('a' + i)), 99.1 + 0.01 * i);
  EXPECT_EQ(tally().waiting(), 20u);
  EXPECT_EQ(dropped(Drop::queue_full), 3u);
  odometry(100.0);
  EXPECT_EQ(names(), "d e f g h i j k l m n o p q r s t u v w");  // the oldest gave way
}

TEST_F(PosedInputTest, RefusesAMessageWithoutAStamp) {
  odometry(99.0);
  scan("a", 0.0);
  EXPECT_EQ(names(), "");
  EXPECT_EQ(tally().sentence(), "0 of 1 scans used: 1 without a stamp");
}

TEST_F(PosedInputTest, UsesAStampOnceForEachSensor) {
  odometry(99.0);
  odometry(100.0);
  const std::size_t echoes = input.add_input("echoes");
  scan("a", 99.5);
  scan("again", 99.5);
  scan("slashed", 99.5, "/laser");
  scan("other frame", 99.5, "base_link");
  input.receive(echoes, message("other input", 99.5, 99.5), now);
  EXPECT_EQ(names(), "a other frame other input");
  EXPECT_EQ(dropped(Drop::repeated_stamp), 2u);
}

TEST_F(PosedInputTest, TakesAllPartsOfWhatASensorSaysAtOneMoment) {
  odometry(99.0);
  odometry(100.0);
  for (const std::uint64_t part : {1U, 2U, 1U, 3U}) {
    PosedInput::Message z = message("z", 99.5, 99.5);
    z.part = part;
    input.receive(scans, std::move(z), now);
  }
  EXPECT_EQ(tally().used(), 3u);
  EXPECT_EQ(dropped(Drop::repeated_stamp), 1u);
}

TEST_F(PosedInputTest, KnowsARepeatedStampThatCameAWhileAgo) {
  odometry(99.0);
  odometry(100.0);
  for (const double s : {99.1, 99.2, 99.1, 99.3, 99.2, 99.3}) scan("a", s);
  EXPECT_EQ(tally().used(), 3u);
  EXPECT_EQ(dropped(Drop::repeated_stamp), 3u);
}

TEST_F(PosedInputTest, UsesStampsThatDecrease) {
  odometry(99.0);
  odometry(100.0);
  for (const double s : {99.5, 99.3, 99.1}) scan("a", s);
  ASSERT_EQ(tally().used(), 3u);
  EXPECT_TRUE(used[2].pose.T_odom_sensor.isApprox(T_odom_base(99.1) * T_base_laser(), 1e-9));
}

TEST_F(PosedInputTest, CountsWhatTheMapperSays) {
  odometry(99.0);
  odometry(100.0);
  outcome = std::nullopt;
  scan("a", 99.1);
  outcome = Outcome::rejected;
  scan("b", 99.2);
  outcome = Outcome::unusable;
  scan("c", 99.3);
  input.receive_malformed(scans);
  EXPECT_EQ(tally().received(), 4u);
  EXPECT_EQ(tally().used(), 0u);
  EXPECT_EQ(tally().waiting(), 0u);
  EXPECT_EQ(dropped(Drop::thinned), 1u);
  EXPECT_EQ(dropped(Drop::rejected), 1u);
  EXPECT_EQ(dropped(Drop::unusable), 1u);
  EXPECT_EQ(dropped(Drop::malformed), 1u);
}

TEST_F(PosedInputTest, TellsHowTheSensorMovedDuringASweep) {
  odometry(99.0);
  odometry(99.4);
  input.receive(scans, message("a", 99.2, 99.7), now);
  EXPECT_EQ(names(), "");  // its end is not known yet
  odometry(100.0);
  ASSERT_EQ(names(), "a");
  EXPECT_TRUE(used[0].pose.T_odom_sensor.isApprox(T_odom_base(99.2) * T_base_laser(), 1e-9));
  EXPECT_TRUE(used[0].pose.T_first_last.isApprox(planar_pose(0.5, 0.0, 0.0), 1e-9));
}

TEST_F(PosedInputTest, DropsASweepWhoseEndTfNeverTells) {
  odometry(99.0);
  odometry(99.4);
  input.receive(scans, message("a", 99.2, 99.7), now);
  now += seconds(2.0);
  input.poll(now);
  EXPECT_EQ(tally().sentence(),
            "0 of 1 scans used: no transform odom <- laser at their stamps; newest is 0.3 s older");
}

TEST_F(PosedInputTest, WaitingBeginsWithTheFirstTickOfTheClock) {
  now = Time{};
  scan("a", 99.5);
  odometry(99.0);
  EXPECT_EQ(tally().waiting(), 1u);
  now = at(99.5);
  input.poll(now);
  EXPECT_EQ(tally().waiting(), 1u);
  now = at(100.4);
  odometry(100.0);
  EXPECT_EQ(names(), "a");
}

TEST_F(PosedInputTest, SurvivesStampsAtTheEndOfTime) {
  const Time last = ros_convert::time(ros::TIME_MAX);
  now = Time{};
  input.receive_tf(tf_message(transform("odom", "mast", 1.0)), true, now);
  input.receive(scans,
                {"mast", last, last + seconds(9.0),
                 [this](const PosedInput::SensorPose&) { return outcome; }},
                now);
  EXPECT_EQ(tally().used(), 1u);  // a mast that never moves is where it is at any time
}

TEST_F(PosedInputTest, ForgetsOnDemandAllButWhatNeverMoves) {
  odometry(99.0);
  scan("a", 99.5);
  input.clear();
  EXPECT_EQ(dropped(Drop::time_ran_back), 1u);
  EXPECT_EQ(tally().waiting(), 0u);
  scan("b", 99.0);
  EXPECT_EQ(tally().waiting(), 1u);  // the odometry is gone
  odometry(2.0);
  odometry(3.0);
  scan("c", 2.5);
  EXPECT_EQ(names(), "c");  // the laser's place is not
}

TEST_F(PosedInputTest, AfterForgettingAStampMayComeAgain) {
  odometry(99.0);
  scan("a", 99.0);
  input.clear();
  odometry(99.0);
  scan("b", 99.0);
  EXPECT_EQ(names(), "a b");
}

TEST(PosedInputOptions, RefusesNonsense) {
  const auto with = [](auto change) {
    PosedInputOptions options;
    change(options);
    return options;
  };
  using O = PosedInputOptions;
  EXPECT_THROW(PosedInput(with([](O& o) { o.odom_frame.clear(); })), OptionsError);
  EXPECT_THROW(PosedInput(with([](O& o) { o.tf_wait = -1.0; })), OptionsError);
  EXPECT_THROW(PosedInput(with([](O& o) { o.tf_buffer = 0.0; })), OptionsError);
  EXPECT_THROW(PosedInput(with([](O& o) { o.queue_size = 0; })), OptionsError);
}

}  // namespace
}  // namespace portolan
