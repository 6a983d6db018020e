// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/scan_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "random_pose.hpp"

namespace portolan {
namespace {

const std::string kTitle = "portolan scans 1 ";

std::vector<Keyframe> some_keyframes() {
  std::mt19937_64 random(1);
  std::vector<Keyframe> keyframes(4);
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    keyframes[i].stamp = Time{Duration(1'700'000'000'123'456'789 + static_cast<int>(i))};
    keyframes[i].T_base_sensor = random_pose(random);
    RangeScan& scan = keyframes[i].scan;
    scan.T_first_last = random_pose(random);
    scan.angle_min = -2.1;
    scan.angle_increment = -1.0 / 3.0;
    scan.range_max = 30.0;
    scan.ranges = {1.1F, std::numeric_limits<float>::infinity(), -0.0F, 1e-40F};
    scan.ranges.resize(i + 2, 7.3F);
  }
  keyframes[1].scan = RangeScan{};  // forgotten
  return keyframes;
}

std::string fault(const std::string& bytes) {
  try {
    scans_from_file(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(ScanFile, GivesBackEachScanToTheLastBit) {
  const std::vector<Keyframe> keyframes = some_keyframes();
  const std::vector<SavedScan> scans = scans_from_file(to_scan_file(keyframes));
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_EQ(scans[1].keyframe, 2);
  for (const SavedScan& saved : scans) {
    const Keyframe& keyframe = keyframes[static_cast<std::size_t>(saved.keyframe)];
    EXPECT_EQ(saved.stamp, keyframe.stamp);
    EXPECT_EQ(saved.T_base_sensor.matrix(), keyframe.T_base_sensor.matrix());
    EXPECT_EQ(saved.scan.T_first_last.matrix(), keyframe.scan.T_first_last.matrix());
    EXPECT_EQ(saved.scan.angle_min, keyframe.scan.angle_min);
    EXPECT_EQ(saved.scan.angle_increment, keyframe.scan.angle_increment);
    EXPECT_EQ(saved.scan.range_min, keyframe.scan.range_min);
    EXPECT_EQ(saved.scan.range_max, keyframe.scan.range_max);
    EXPECT_EQ(saved.scan.ranges, keyframe.scan.ranges);
  }
}

TEST(ScanFile, IsTheSameOnEveryMachine) {
  std::vector<Keyframe> keyframes(1);
  keyframes[0].stamp = Time{Duration(0x0102030405060708)};
  keyframes[0].scan.angle_increment = 1.0;
  keyframes[0].scan.ranges = {1.0F};
  const std::string bytes = to_scan_file(keyframes);
  EXPECT_EQ(bytes.substr(0, 19), "portolan scans 1 1\n");
  EXPECT_EQ(bytes.substr(19 + 8, 8), std::string("\x08\x07\x06\x05\x04\x03\x02\x01"));
  EXPECT_EQ(bytes.substr(bytes.size() - 4), std::string("\x00\x00\x80\x3f", 4));
  EXPECT_EQ(bytes.size(), 19U + 16U + 2U * 96U + 32U + 4U + 4U);
}

TEST(ScanFile, IsEmptyWhereNothingIsKept) {
  EXPECT_EQ(to_scan_file({}), kTitle + "0\n");
  EXPECT_TRUE(scans_from_file(kTitle + "0\n").empty());
}

TEST(ScanFile, SaysWhatIsNoTitle) {
  for (const std::string& bad :
       {std::string(), std::string("portolan scans 2 0\n"), kTitle, kTitle + "x\n", kTitle + "-1\n",
        kTitle + "1.5\n", kTitle + "99999999999999999999\n", "P5 " + kTitle + "0\n"}) {
    EXPECT_EQ(fault(bad), "does not begin with `portolan scans 1 COUNT`") << bad;
  }
}

TEST(ScanFile, NoticesEveryCut) {
  const std::string bytes = to_scan_file(some_keyframes());
  for (std::size_t size = kTitle.size() + 2; size < bytes.size(); ++size) {
    const std::string what = fault(bytes.substr(0, size));
    EXPECT_EQ(what.substr(what.size() - 8), " cut off") << size << ": " << what;
  }
  EXPECT_EQ(fault(bytes + "x"), "goes on after its last scan");
  EXPECT_EQ(fault(kTitle + "1000000000000000\n"), "scan 1 of 1000000000000000 is cut off");
}

TEST(ScanFile, RefusesWhatMakesNoSense) {
  const auto fault_with = [](const auto& change) {
    std::vector<Keyframe> keyframes = some_keyframes();
    change(keyframes[2]);
    return fault(to_scan_file(keyframes));
  };
  EXPECT_EQ(fault_with([](Keyframe& k) { k.T_base_sensor.linear() *= 2.0; }),
            "scan 2 of 3 has a pose that is not rigid");
  EXPECT_EQ(fault_with([](Keyframe& k) { k.scan.T_first_last.translation().x() = NAN; }),
            "scan 2 of 3 has a pose that is not rigid");
  EXPECT_EQ(fault_with([](Keyframe& k) { k.scan.angle_increment = 0.0; }),
            "scan 2 of 3 is malformed");
  EXPECT_EQ(fault_with([](Keyframe& k) { k.scan.range_max = -1.0; }), "scan 2 of 3 is malformed");
}

TEST(ScanFile, RefusesIdsThatDoNotIncrease) {
  const std::string one = to_scan_file({some_keyframes().front()}).substr(kTitle.size() + 2);
  EXPECT_EQ(fault(kTitle + "1\n" + one), "none");
  EXPECT_EQ(fault(kTitle + "2\n" + one + one), "scan 2 of 2 comes after one of a later keyframe");
}

}  // namespace
}  // namespace portolan
