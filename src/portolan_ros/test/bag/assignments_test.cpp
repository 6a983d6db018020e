// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/assignments.hpp"

#include <gtest/gtest.h>

namespace portolan {
namespace {

const std::vector<OptionRow> kOptions{{"odom_frame", "text", "odom", "", ""},
                                      {"scan_topics", "list of text", "[scan]", "", ""},
                                      {"laser/max_range", "number", "30", "", ""}};

TEST(Assignments, TellAMapperWhatItKnows) {
  Assignments assignments({"odom_frame:=robot/odom", "laser/max_range:=5", "other:=1"});
  const YAML::Node told = assignments.over(YAML::Load("{laser: {margin: 0.1}}"), kOptions);
  EXPECT_EQ(told["odom_frame"].as<std::string>(), "robot/odom");
  EXPECT_EQ(told["laser"]["max_range"].as<double>(), 5.0);
  EXPECT_EQ(told["laser"]["margin"].as<double>(), 0.1);
  EXPECT_FALSE(told["other"].IsDefined());
}

TEST(Assignments, ComeBeforeWhatWasTold) {
  Assignments assignments({"odom_frame:=b"});
  const YAML::Node before = YAML::Load("{odom_frame: a}");
  EXPECT_EQ(assignments.over(before, kOptions)["odom_frame"].as<std::string>(), "b");
  EXPECT_EQ(before["odom_frame"].as<std::string>(), "a");
}

TEST(Assignments, NameInputsAsLaunchFilesDo) {
  using Topics = std::vector<std::string>;
  const auto topics = [](const std::string& word) {
    return Assignments({word}).over(YAML::Node(), kOptions)["scan_topics"].as<Topics>();
  };
  EXPECT_EQ(topics("scan:=/front"), Topics{"/front"});
  EXPECT_EQ(topics("scan:=[a, b]"), (Topics{"a", "b"}));
  EXPECT_EQ(topics("scan_topics:=[c]"), Topics{"c"});
  EXPECT_EQ(topics("scan:="), Topics{});
}

TEST(Assignments, OfNamesThatNobodyKnowsAreFaults) {
  Assignments assignments({"odom_frame:=a", "odm_frame:=b"});
  assignments.over(YAML::Node(), kOptions);
  try {
    assignments.check_all_known();
    FAIL();
  } catch (const OptionsError& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    EXPECT_EQ(error.faults()[0].find("odm_frame"), 0U);
  }
}

TEST(Assignments, NeedANameAndAValueThatIsYaml) {
  EXPECT_THROW(Assignments({":=a"}), std::invalid_argument);
  EXPECT_THROW(Assignments({"a"}), std::invalid_argument);
  EXPECT_THROW(Assignments({"a:=["}), std::invalid_argument);
}

}  // namespace
}  // namespace portolan
