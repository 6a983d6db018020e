// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/diagnosis.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace portolan {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

class DiagnosisTest : public testing::Test {
 protected:
  void use(std::size_t input, int count = 1) {
    for (int i = 0; i < count; ++i) {
      tallies[input].receive();
      tallies[input].use();
    }
  }
  void drop(std::size_t input, Drop reason, int count = 1) {
    for (int i = 0; i < count; ++i) {
      tallies[input].receive();
      tallies[input].drop(reason);
    }
  }
  DiagnosticStatusWrapper status() {
    DiagnosticStatusWrapper filled;
    diagnosis.fill(tallies, filled);
    return filled;
  }
  int level() { return status().level; }

  Diagnosis diagnosis;
  std::vector<Tally> tallies = {Tally("scans"), Tally("echoes")};
};

TEST_F(DiagnosisTest, WarnsWhereNothingArrives) {
  const DiagnosticStatusWrapper filled = status();
  EXPECT_EQ(filled.level, DiagnosticStatus::WARN);
  EXPECT_EQ(filled.message, "no scans received; no echoes received");
}

TEST_F(DiagnosisTest, IsContentWithOneInput) {
  use(0, 3);
  const DiagnosticStatusWrapper filled = status();
  EXPECT_EQ(filled.level, DiagnosticStatus::OK);
  EXPECT_EQ(filled.message, "3 of 3 scans used; no echoes received");
}

TEST_F(DiagnosisTest, ListsWhatBecameOfTheMessages) {
  use(0, 2);
  drop(0, Drop::malformed, 3);
  drop(1, Drop::queue_full);
  std::map<std::string, std::string> values;
  for (const auto& value : status().values) values[value.key] = value.value;
  const std::map<std::string, std::string> expected = {
      {"scans received", "5"},  {"scans used", "2"},  {"scans dropped: malformed", "3"},
      {"echoes received", "1"}, {"echoes used", "0"}, {"echoes dropped: queue_full", "1"}};
  EXPECT_EQ(values, expected);
}

TEST_F(DiagnosisTest, WarnsWhereAnInputsLatestMessagesWereAllLost) {
  use(0);
  use(1);
  EXPECT_EQ(level(), DiagnosticStatus::OK);
  use(0);
  drop(1, Drop::no_transform);
  EXPECT_EQ(level(), DiagnosticStatus::WARN);
}

TEST_F(DiagnosisTest, ForgivesALostMessageAmongGoodOnes) {
  use(0);
  EXPECT_EQ(level(), DiagnosticStatus::OK);
  use(0);
  drop(0, Drop::no_transform);
  EXPECT_EQ(level(), DiagnosticStatus::OK);
}

TEST_F(DiagnosisTest, ForgetsAfterSomeCalls) {
  use(0);
  EXPECT_EQ(level(), DiagnosticStatus::OK);
  drop(0, Drop::unusable);
  EXPECT_EQ(level(), DiagnosticStatus::WARN);
  int calls = 0;
  while (level() == DiagnosticStatus::WARN && calls < 100) ++calls;
  EXPECT_GT(calls, 1);
  EXPECT_LT(calls, 10);
}

TEST_F(DiagnosisTest, ThinnedMessagesAreNoLoss) {
  use(0);
  EXPECT_EQ(level(), DiagnosticStatus::OK);
  drop(0, Drop::thinned, 50);
  EXPECT_EQ(level(), DiagnosticStatus::OK);
}

TEST_F(DiagnosisTest, InputsThatComeLaterAreFine) {
  use(0);
  EXPECT_EQ(level(), DiagnosticStatus::OK);
  tallies.emplace_back("clouds");
  EXPECT_EQ(level(), DiagnosticStatus::OK);
}

}  // namespace
}  // namespace portolan
