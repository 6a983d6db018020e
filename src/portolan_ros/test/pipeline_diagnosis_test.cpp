// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/pipeline_diagnosis.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "posed_input_fixture.hpp"
#include "toy_kind.hpp"

namespace portolan {
namespace {

class PipelineDiagnosisTest : public testing::Test {
 protected:
  void scan(double s) {
    const Pose T_odom_base = planar_pose(s, 0.0, 0.0);
    pipeline.receive_tf(tf_message(transform("odom", "base_link", s, T_odom_base)), false, at(s));
    RangeScan z;
    z.ranges = {1.0F};
    pipeline.receive(scans, std::optional(Sensed<RangeScan>{"base_link", at(s), at(s), z}), at(s));
  }
  std::string value(const std::string& key) {
    diagnostic_updater::DiagnosticStatusWrapper status;
    diagnosis.fill(status);
    for (const auto& line : status.values) {
      if (line.key == key) return line.value;
    }
    return "none";
  }

  Pipeline<ToyKind> pipeline{{}, {}};
  std::size_t scans = pipeline.add_input("scans");
  PipelineDiagnosis<ToyKind> diagnosis{pipeline};
};

TEST_F(PipelineDiagnosisTest, SaysWhatBecameOfTheMessages) {
  scan(1.0);
  scan(2.0);
  pipeline.receive<RangeScan>(scans, std::nullopt, at(2.0));
  EXPECT_EQ(value("scans received"), "3");
  EXPECT_EQ(value("scans used"), "2");
  EXPECT_EQ(value("scans dropped: malformed"), "1");
}

TEST_F(PipelineDiagnosisTest, SaysWhatTheLogHolds) {
  EXPECT_EQ(value("observations in the log"), "0");
  scan(1.0);
  scan(2.0);
  EXPECT_EQ(value("observations in the log"), "2");
  EXPECT_GT(std::stod(value("log [MB]")), 0.0);
  EXPECT_EQ(value("redrawn"), "1");
  pipeline.remapper().freeze();
  EXPECT_EQ(value("observations in the log"), "0");
}

TEST_F(PipelineDiagnosisTest, CountsWhatWasRefused) {
  EXPECT_EQ(value("corrections refused"), "0");
  EXPECT_EQ(value("times the clock ran back"), "0");
  diagnosis.refuse_correction();
  scan(10.0);
  scan(1.0);
  EXPECT_EQ(value("corrections refused"), "1");
  EXPECT_EQ(value("times the clock ran back"), "1");
}

}  // namespace
}  // namespace portolan
