// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/health.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>

namespace portolan {
namespace {

const char* const kWhy = "no transform odom <- laser at their stamps; newest is 0.8 s older";

Tally scans(int received, int used) {
  Tally tally("scans");
  for (int i = 0; i < received; ++i) tally.receive();
  for (int i = 0; i < used; ++i) tally.use();
  return tally;
}

TEST(Tally, SaysWhenNothingCame) { EXPECT_EQ(scans(0, 0).sentence(), "no scans received"); }

TEST(Tally, SaysWhenAllIsWell) { EXPECT_EQ(scans(312, 312).sentence(), "312 of 312 scans used"); }

TEST(Tally, GivesTheReasonAloneWhereItTookAll) {
  Tally tally = scans(312, 0);
  for (int i = 0; i < 312; ++i) tally.drop(Drop::no_transform, kWhy);
  EXPECT_EQ(tally.sentence(), std::string("0 of 312 scans used: ") + kWhy);
}

TEST(Tally, GivesTheReasonAloneWhereTheRestStillWaits) {
  Tally tally = scans(312, 0);
  for (int i = 0; i < 300; ++i) tally.drop(Drop::no_transform, kWhy);
  EXPECT_EQ(tally.waiting(), 12u);
  EXPECT_EQ(tally.sentence(), std::string("0 of 312 scans used: ") + kWhy);
}

TEST(Tally, CountsWhereAReasonTookSome) {
  Tally tally = scans(10, 6);
  tally.drop(Drop::no_transform, "an older reason");
  tally.drop(Drop::no_transform, kWhy);
  tally.drop(Drop::malformed);
  EXPECT_EQ(tally.sentence(),
            std::string("6 of 10 scans used: 1 malformed, 2 without a transform (") + kWhy +
                "), 1 waiting for tf or their turn");
}

TEST(Tally, CountsWhereThereIsNoDetail) {
  Tally tally = scans(2, 0);
  tally.drop(Drop::malformed);
  tally.drop(Drop::malformed);
  EXPECT_EQ(tally.sentence(), "0 of 2 scans used: 2 malformed");
}

TEST(Tally, SaysWhatWaits) {
  EXPECT_EQ(scans(5, 2).sentence(), "2 of 5 scans used: 3 waiting for tf or their turn");
}

TEST(Tally, KeepsTheLastDetail) {
  Tally tally = scans(2, 0);
  tally.drop(Drop::no_transform, "first");
  tally.drop(Drop::no_transform, "second");
  EXPECT_EQ(tally.sentence(), "0 of 2 scans used: second");
}

TEST(Tally, EveryMessageIsUsedWaitingOrDropped) {
  Tally tally = scans(20, 5);
  for (std::size_t i = 0; i < enum_names(Drop{}).size(); ++i) tally.drop(static_cast<Drop>(i));
  EXPECT_EQ(tally.received(), 20u);
  EXPECT_EQ(tally.used(), 5u);
  EXPECT_EQ(tally.lost(), 8u);  // what was thinned is not lost
  EXPECT_EQ(tally.dropped(Drop::thinned), 1u);
  EXPECT_EQ(tally.waiting(), 6u);
}

TEST(Tally, EveryReasonHasWordsOfItsOwn) {
  std::set<std::string> sentences;
  for (std::size_t i = 0; i < enum_names(Drop{}).size(); ++i) {
    Tally tally = scans(1, 0);
    tally.drop(static_cast<Drop>(i));
    EXPECT_GT(tally.sentence().size(), std::string("0 of 1 scans used: 1 ").size()) << i;
    sentences.insert(tally.sentence());
  }
  EXPECT_EQ(sentences.size(), enum_names(Drop{}).size());
}

}  // namespace
}  // namespace portolan
