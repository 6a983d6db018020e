// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/input_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <string>

#include "posed_input_fixture.hpp"

namespace portolan {
namespace {

InputOrder of_inputs(std::size_t count) {
  InputOrder order;
  for (std::size_t i = 0; i < count; ++i) order.add_input();
  return order;
}

TEST(InputOrder, AnInputAloneIsAlwaysInTurn) {
  InputOrder order = of_inputs(1);
  order.note(0, at(1.0));
  EXPECT_TRUE(order.is_in_turn(0, at(1.0)));
}

TEST(InputOrder, WaitsUntilTheOtherHasPassedOrWasSilentForLong) {
  InputOrder order = of_inputs(2);
  order.note(0, at(1.0));
  EXPECT_FALSE(order.is_in_turn(0, at(1.0)));
  order.note(1, at(0.9));
  EXPECT_FALSE(order.is_in_turn(0, at(1.0)));
  order.note(1, at(1.0));
  EXPECT_TRUE(order.is_in_turn(0, at(1.0)));
  order.note(0, at(2.0));
  EXPECT_FALSE(order.is_in_turn(0, at(2.0)));
  order.note(0, at(2.1));
  EXPECT_TRUE(order.is_in_turn(0, at(2.1)));
}

TEST(InputOrder, OneThatNeverBringsAnythingIsForgotten) {
  InputOrder order = of_inputs(2);
  order.note(0, at(1.0));
  order.note(0, at(2.5));
  EXPECT_TRUE(order.is_in_turn(0, at(2.5)));
  order.clear();
  order.note(0, at(2.5));
  EXPECT_FALSE(order.is_in_turn(0, at(2.5)));
}

/// Three inputs of a robot whose transforms are known already; messages wait 50 ms for each other.
class OrderOfInputs : public PosedInputTest {
 protected:
  void begin(double order_wait = 0.05) {
    PosedInputOptions waits = options();
    waits.order_wait = order_wait;
    mixed.emplace(waits);
    for (const char* noun : {"a", "b", "c"}) mixed->add_input(noun);
    const auto static_laser = transform("base_link", "laser", 0.0, T_base_laser());
    mixed->receive_tf(tf_message(static_laser), true, now);
    for (const double s : {99.0, 105.0}) {
      mixed->receive_tf(tf_message(transform("odom", "base_link", s, T_odom_base(s))), false, now);
    }
    used.clear();
  }
  void receive(std::size_t i, const std::string& name, double s) {
    mixed->receive(i, message(name, s, s), now);
  }
  void wait(double s) {
    now += seconds(s);
    mixed->poll(now);
  }

  /// What is used of messages with the same stamps that come in any order within the 50 ms.
  std::string used_in_order_of_arrival(unsigned seed) {
    std::mt19937_64 random(seed);
    begin();
    for (int round = 0; round < 20; ++round) {
      std::array<std::size_t, 3> inputs = {0, 1, 2};
      std::shuffle(inputs.begin(), inputs.end(), random);
      for (const std::size_t i : inputs) {
        receive(i, std::to_string(round) + "abc"[i], 100.0 + 0.1 * round);
        wait(0.01);
      }
      wait(0.07);
    }
    return names();
  }

  std::optional<PosedInput> mixed;
};

TEST_F(OrderOfInputs, DoesNotDependOnWhichComesFirst) {
  std::string expected;
  for (int round = 0; round < 20; ++round) {
    for (const char name : {'a', 'b', 'c'}) {
      expected += (expected.empty() ? "" : " ") + std::to_string(round) + name;
    }
  }
  for (unsigned seed = 0; seed < 20; ++seed) EXPECT_EQ(used_in_order_of_arrival(seed), expected);
}

TEST_F(OrderOfInputs, AnOlderOneOfAnotherInputGoesFirst) {
  begin();
  receive(0, "late", 99.5);
  wait(0.03);
  receive(1, "early", 99.4);
  EXPECT_EQ(names(), "");  // of c nothing is known
  wait(0.02);
  EXPECT_EQ(names(), "early late");
}

TEST_F(OrderOfInputs, WaitsNoLongerThanNeeded) {
  begin();
  receive(0, "a", 99.5);
  receive(1, "b", 99.5);
  EXPECT_EQ(names(), "");
  receive(2, "c", 99.5);
  EXPECT_EQ(names(), "a b c");
}

TEST_F(OrderOfInputs, WaitsForNothingOnceNothingMoreIsComing) {
  begin();
  receive(0, "late", 99.5);
  receive(1, "early", 99.4);
  EXPECT_EQ(names(), "");
  mixed->settle(now);
  EXPECT_EQ(names(), "early late");
}

TEST_F(OrderOfInputs, LosesNothingThatCanBePosedWhenTooManyWait) {
  begin();
  for (int i = 0; i < 3 * options().queue_size; ++i) receive(0, "a", 99.5 + 0.001 * i);
  EXPECT_EQ(used.size(), 2u * static_cast<std::size_t>(options().queue_size));
  EXPECT_EQ(mixed->tallies()[0].lost(), 0u);
}

TEST_F(OrderOfInputs, LosesNothingThatCanBePosedWhenTimeBeginsAnew) {
  begin();
  receive(0, "late", 99.5);
  receive(1, "early", 99.4);
  mixed->receive(0, message("nowhere", 99.6, 99.6, "camera"), now);
  EXPECT_EQ(names(), "");
  mixed->clear();
  EXPECT_EQ(names(), "early late");
  EXPECT_EQ(mixed->tallies()[0].dropped(Drop::time_ran_back), 1u);
}

TEST_F(OrderOfInputs, NoneWaitsIfNothingIsToBeWaitedFor) {
  begin(0.0);
  receive(0, "late", 99.5);
  EXPECT_EQ(names(), "late");
  receive(1, "early", 99.4);
  EXPECT_EQ(names(), "late early");
}

}  // namespace
}  // namespace portolan
