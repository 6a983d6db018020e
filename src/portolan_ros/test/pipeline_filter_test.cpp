// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "portolan_ros/pipeline.hpp"
#include "posed_input_fixture.hpp"
#include "toy_kind.hpp"

namespace portolan {
namespace {

TEST_F(PosedInputTest, PosesAMessageInFurtherFrames) {
  PosedInput::Message a = message("a", 99.5, 99.5);
  a.references = {"base_link", "laser"};
  odometry(99.0);
  odometry(100.0);
  input.receive(scans, a, now);
  ASSERT_EQ(names(), "a");
  ASSERT_EQ(used[0].pose.T_reference_sensor.size(), 2u);
  EXPECT_TRUE(used[0].pose.T_reference_sensor[0].isApprox(T_base_laser(), 1e-9));
  EXPECT_TRUE(used[0].pose.T_reference_sensor[1].isApprox(Pose::Identity(), 1e-9));
}

TEST_F(PosedInputTest, WaitsForFurtherFramesAndSaysWhichOneIsMissing) {
  PosedInput::Message a = message("a", 99.5, 99.5);
  a.references = {"base_link", "hand"};
  PosedInput::Message b = message("b", 99.6, 99.6);
  b.references = {"foot"};
  odometry(99.0);
  odometry(100.0);
  input.receive(scans, a, now);
  input.receive(scans, b, now);
  EXPECT_EQ(names(), "");
  input.receive_tf(tf_message(transform("base_link", "hand", 0.0)), true, now);
  input.poll(now);
  EXPECT_EQ(names(), "a");
  now += seconds(2.0);
  input.poll(now);
  EXPECT_EQ(
      tally().sentence(),
      "1 of 2 scans used: 1 without a transform (no transform foot <- laser: tf knows no frame "
      "foot)");
}

/// Marks what it hands on with the height of the sensor above a frame of its own.
struct HeightFilter {
  struct Options {
    std::string frame = "floor";

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("frame", self.frame, "heights count from its origin");
    }
  };

  HeightFilter(const Options& options, const PipelineOptions& /*pipeline*/,
               const ToyMapper::Options& /*mapper*/)
      : frame(options.frame) {}

  std::vector<std::string> references(const RangeScan& /*z*/) const { return {frame}; }

  ToyObservation operator()(RangeScan z, const PosedInput::SensorPose& pose) const {
    z.range_min = pose.T_reference_sensor.at(0).translation().z();
    return z;
  }

  std::string frame;
};

struct FilteringKind : ToyKind {
  using Filter = HeightFilter;
};

TEST(PipelineFilter, SeesEachReadingBeforeTheLogDoes) {
  Pipeline<FilteringKind> pipeline{PipelineOptions{}, ToyMapper::Options{}};
  const std::size_t scans = pipeline.add_input("scans");
  const Pose mount(Eigen::Translation3d(0.0, 0.0, -0.75));
  pipeline.receive_tf(tf_message(transform("base_link", "floor", 0.0, mount)), true, at(1.0));
  const auto look = [&](double s) {
    pipeline.receive_tf(tf_message(transform("odom", "base_link", s)), false, at(s));
    RangeScan z;
    z.ranges = {1.0F};
    pipeline.receive(scans, std::optional(Sensed<RangeScan>{"base_link", at(s), at(s), z}), at(s));
  };
  look(1.0);
  pipeline.remapper().correct(Correction({{at(0.0), planar_pose(5.0, 0.0, 0.0)}}));
  pipeline.remapper().finish();
  const auto& entries = pipeline.remapper().map().entries();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_DOUBLE_EQ(std::get<RangeScan>(entries[0].z).range_min, 0.75);
  EXPECT_DOUBLE_EQ(entries[0].T_map_sensor.translation().x(), 5.0);
}

}  // namespace
}  // namespace portolan
