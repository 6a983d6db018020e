// SPDX-License-Identifier: BSD-3-Clause
// What robots do to tf.
#include <console_bridge/console.h>

#include "portolan_ros/posed_input.hpp"
#include "posed_input_fixture.hpp"

namespace portolan {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Counts the lines that tf2 writes.
class LogCounter : public console_bridge::OutputHandler {
 public:
  LogCounter() { console_bridge::useOutputHandler(this); }
  ~LogCounter() override { console_bridge::restorePreviousOutputHandler(); }
  LogCounter(const LogCounter&) = delete;
  LogCounter& operator=(const LogCounter&) = delete;

  void log(const std::string& /*text*/, console_bridge::LogLevel /*level*/, const char* /*file*/,
           int /*line*/) override {
    ++lines;
  }

  int lines = 0;
};

class PosedInputTf : public PosedInputTest {
 protected:
  void receive(const geometry_msgs::TransformStamped& transform) {
    input.receive_tf(tf_message(transform), false, now);
  }
  void TearDown() override {
    EXPECT_EQ(log.lines, 0);
    PosedInputTest::TearDown();
  }

  LogCounter log;
};

TEST_F(PosedInputTf, FramesMayBeginWithASlash) {
  odometry(99.0, "/");
  odometry(100.0, "/");
  scan("a", 99.5, "/laser");
  EXPECT_EQ(names(), "a");
  PosedInputOptions slashed = options();
  slashed.odom_frame = "/odom";
  PosedInput other(slashed);
  other.add_input("scans");
  other.receive_tf(tf_message(transform("odom", "laser", 99.0)), false, now);
  other.receive(0, message("b", 99.0, 99.0), now);
  EXPECT_EQ(names(), "a b");
}

TEST_F(PosedInputTf, RefusesTransformsThatAreNone) {
  for (const double wrong : {kNaN, std::numeric_limits<double>::infinity()}) {
    auto message = transform("odom", "base_link", 99.0);
    message.transform.translation.y = wrong;
    receive(message);
    message = transform("odom", "base_link", 99.0);
    message.transform.rotation.x = wrong;
    receive(message);
  }
  for (const double length : {0.0, 0.9, 1.1, 1e200}) {
    auto message = transform("odom", "base_link", 99.0);
    message.transform.rotation.w = length;
    receive(message);
  }
  EXPECT_EQ(input.bad_transforms(), 8u);
  scan("a", 99.0);
  EXPECT_EQ(names(), "");
}

TEST_F(PosedInputTf, RefusesFramesThatAreNone) {
  receive(transform("", "base_link", 99.0));
  receive(transform("odom", "", 99.0));
  receive(transform("/", "/", 99.0));
  receive(transform("odom", "odom", 99.0));
  receive(transform("/odom", "odom", 99.0));
  EXPECT_EQ(input.bad_transforms(), 5u);
}

TEST_F(PosedInputTf, MendsQuaternionsThatAreOffALittle) {
  for (const double length : {0.992, 1.008}) {
    auto message = transform("odom", "base_link", 98.0 + length, planar_pose(5.0, 0.0, 0.0));
    message.transform.rotation.w = length;
    receive(message);
  }
  EXPECT_EQ(input.bad_transforms(), 0u);
  scan("a", 99.0);
  ASSERT_EQ(names(), "a");
  EXPECT_TRUE(
      used[0].pose.T_odom_sensor.isApprox(planar_pose(5.0, 0.0, 0.0) * T_base_laser(), 1e-9));
}

TEST_F(PosedInputTf, CountsRepeatedTransforms) {
  for (int i = 0; i < 3; ++i) {
    odometry(99.0);
    odometry(99.5);
  }
  EXPECT_EQ(input.bad_transforms(), 4u);
  EXPECT_FALSE(input.transforms_ran_back());
}

TEST_F(PosedInputTf, SurvivesALoop) {
  receive(transform("odom", "a", 99.0));
  receive(transform("a", "odom", 99.0));
  receive(transform("b", "b2", 99.0));
  receive(transform("b2", "b", 99.0));
  scan("a", 99.0, "a");
  scan("b", 99.0, "b2");
  scan("c", 99.0, "laser");
  now += seconds(2.0);
  input.poll(now);
  EXPECT_EQ(tally().received(), 3u);
  EXPECT_EQ(tally().waiting(), 0u);
  EXPECT_GE(dropped(Drop::no_transform), 2u);
}

TEST_F(PosedInputTf, RefusesATransformFromTheFarFuture) {
  odometry(99.0);
  receive(transform("odom", "base_link", 100.0 + 3601.0));
  EXPECT_EQ(input.bad_transforms(), 1u);
  odometry(100.0);
  EXPECT_FALSE(input.transforms_ran_back());
  scan("a", 99.5);
  EXPECT_EQ(names(), "a");
}

TEST_F(PosedInputTf, TheStampOfWhatNeverMovesIsOfNoImport) {
  odometry(99.0);
  input.receive_tf(tf_message(transform("base_link", "camera", 1.7e9)), true, now);
  EXPECT_EQ(input.bad_transforms(), 0u);
  scan("a", 99.0, "camera");
  EXPECT_EQ(names(), "a");
}

TEST_F(PosedInputTf, SurvivesALoneWildStamp) {
  now = Time{};  // before the first tick of the clock nobody knows what lies ahead
  for (const double wild : {4000.0, 10.0, 4e9}) {
    odometry(99.0 + wild * 1e-12);
    receive(transform("odom", "base_link", wild));
    odometry(100.0 + wild * 1e-12);
    EXPECT_FALSE(input.transforms_ran_back()) << wild;
  }
  EXPECT_EQ(input.bad_transforms(), 3u);
  scan("a", 99.5);
  EXPECT_EQ(names(), "a");
}

TEST_F(PosedInputTf, SurvivesASecondSenderWithAWrongClock) {
  for (int i = 0; i < 20; ++i) {
    odometry(99.0 + 0.1 * i);
    receive(transform("base_link", "arm", 10.0 + 0.1 * i));
    receive(transform("odom", "base_link", 20.0 + 0.1 * i));
    receive(transform("base_link", "gripper", 0.0));
  }
  EXPECT_FALSE(input.transforms_ran_back());
  scan("a", 99.5);
  EXPECT_EQ(names(), "a");
  EXPECT_EQ(input.bad_transforms(), 40u);  // the wrong odometry, and what has no stamp
}

TEST_F(PosedInputTf, BeginsAnewWhereStampsRanBackByMoreThanIsRemembered) {
  odometry(99.0);
  scan("lost", 99.5);
  odometry(2.0);
  EXPECT_FALSE(input.transforms_ran_back());  // it may be a lone one
  odometry(2.1);
  EXPECT_TRUE(input.transforms_ran_back());
  EXPECT_FALSE(input.transforms_ran_back());  // said once
  EXPECT_EQ(dropped(Drop::time_ran_back), 1u);
  odometry(3.0);
  scan("a", 2.5);
  EXPECT_EQ(names(), "a");
}

TEST_F(PosedInputTf, LosesNothingWhereTfPausesForLongerThanIsRemembered) {
  odometry(20.0);
  scan("a", 95.0);
  odometry(95.0);  // it may be a lone wild stamp
  EXPECT_EQ(names(), "");
  odometry(96.0);  // no: tf had paused
  EXPECT_EQ(names(), "a");
  EXPECT_TRUE(used[0].pose.T_odom_sensor.isApprox(T_odom_base(95.0) * T_base_laser()));
  EXPECT_EQ(input.bad_transforms(), 0u);
}

TEST_F(PosedInputTf, DoesNotMindStampsThatRunBackALittle) {
  odometry(99.0);
  odometry(98.0);
  odometry(70.0);
  EXPECT_FALSE(input.transforms_ran_back());
  scan("a", 98.5);
  EXPECT_EQ(names(), "a");
}

nav_msgs::Odometry odometry_at(double s, const Pose& pose) {
  nav_msgs::Odometry message;
  message.header.stamp = ros_convert::time(at(s));
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose = ros_convert::pose(pose);
  return message;
}

TEST_F(PosedInputTf, OdometryMessagesServeAsTransforms) {
  nav_msgs::Odometry message;
  message.pose.pose = ros_convert::pose(planar_pose(3.0, 1.0, 0.5));
  message.header.stamp = ros::Time(99, 0);
  message.header.frame_id = "/odom";
  message.child_frame_id = "base_link";
  input.receive_odometry(message, "base_footprint", now);
  message.header.stamp = ros::Time(100, 0);
  message.header.frame_id.clear();
  message.child_frame_id.clear();
  input.receive_odometry(message, "base_link", now);
  EXPECT_EQ(input.bad_transforms(), 0u);
  scan("a", 99.5);
  ASSERT_EQ(names(), "a");
  EXPECT_TRUE(
      used[0].pose.T_odom_sensor.isApprox(planar_pose(3.0, 1.0, 0.5) * T_base_laser(), 1e-9));
}

// A heading that may be off by 0.1 rad moves a sensor half a metre to the left back and forth.
TEST_F(PosedInputTf, TheCovarianceOfOdometryIsCarriedToTheSensor) {
  nav_msgs::Odometry message = odometry_at(99.0, planar_pose(3.0, 1.0, 0.5 * M_PI));
  message.pose.covariance[0] = 0.04;   // along x of odom, which is to the right of the robot
  message.pose.covariance[35] = 0.01;  // heading
  input.receive_odometry(message, "base_link", now);
  message.header.stamp = ros::Time(100, 0);
  message.pose.covariance.fill(0.0);
  input.receive_odometry(message, "base_link", now);
  scan("a", 99.5);
  scan("b", 100.0);
  ASSERT_EQ(names(), "a b");
  ASSERT_TRUE(used[0].pose.covariance);
  PoseCovariance expected = PoseCovariance::Zero();
  expected(0, 0) = 0.5 * 0.5 * 0.01;
  expected(1, 1) = 0.04;
  expected(5, 5) = 0.01;
  expected(0, 5) = expected(5, 0) = -0.5 * 0.01;
  EXPECT_LT((*used[0].pose.covariance - expected).norm(), 1e-9);
  EXPECT_FALSE(used[1].pose.covariance) << "zeros say that it is unknown";
}

TEST_F(PosedInputTf, OdometryThatIsRefusedTellsNoCovariance) {
  nav_msgs::Odometry message = odometry_at(99.0, planar_pose(3.0, 1.0, 0.0));
  message.pose.covariance.fill(0.0);
  message.pose.covariance[0] = -1.0;
  input.receive_odometry(message, "base_link", now);
  message.header.stamp = ros::Time(99, 500000000);
  message.pose.covariance[0] = 0.04;
  message.header.frame_id = "elsewhere";
  message.child_frame_id = "other";
  input.receive_odometry(message, "base_link", now);
  message = odometry_at(100.0, planar_pose(3.0, 1.0, 0.0));
  input.receive_odometry(message, "base_link", now);
  message.header.stamp = ros::Time(90000, 0);
  message.pose.covariance[0] = 0.04;
  input.receive_odometry(message, "base_link", now);
  scan("a", 100.0);
  ASSERT_EQ(names(), "a");
  EXPECT_FALSE(used[0].pose.covariance);
}

TEST_F(PosedInputTf, RefusesOdometryThatIsNone) {
  nav_msgs::Odometry message;  // its quaternion is zero
  message.header.stamp = ros::Time(99, 0);
  input.receive_odometry(message, "base_link", now);
  EXPECT_EQ(input.bad_transforms(), 1u);
}

TEST_F(PosedInputTf, WritesNothingWhileMessagesWait) {
  scan("a", 99.0);
  scan("b", 99.0, "");
  scan("c", 99.0, "//laser");
  for (int i = 0; i < 10; ++i) odometry(90.0 + 0.1 * i);
  EXPECT_EQ(tally().waiting(), 3u);
}

}  // namespace
}  // namespace portolan
