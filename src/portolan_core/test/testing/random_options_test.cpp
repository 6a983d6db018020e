// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/testing/random_options.hpp"

#include <gtest/gtest.h>

#include <set>

#include "options/example_options.hpp"

namespace portolan::testing {
namespace {

const ExampleOptions kDefaults;

TEST(RandomOptions, HaveNoFaults) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    EXPECT_EQ(faults(random_options<ExampleOptions>(random)), std::vector<std::string>{});
  }
}

TEST(RandomOptions, AreTheSameForTheSameSeed) {
  std::mt19937_64 first(5);
  std::mt19937_64 second(5);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(to_yaml(option_rows(random_options<ExampleOptions>(first))),
              to_yaml(option_rows(random_options<ExampleOptions>(second))));
  }
}

TEST(RandomOptions, ReachEveryKindOfField) {
  std::mt19937_64 random(2);
  std::vector<std::set<std::string>> values(option_rows(kDefaults).size());
  for (int i = 0; i < 300; ++i) {
    const auto rows = option_rows(random_options<ExampleOptions>(random));
    for (std::size_t field = 0; field < rows.size(); ++field)
      values[field].insert(rows[field].value);
  }
  const auto rows = option_rows(kDefaults);
  for (std::size_t field = 0; field < rows.size(); ++field) {
    const std::size_t few = rows[field].type == "true | false" ? 2 : 3;
    EXPECT_GE(values[field].size(), few) << rows[field].name;
  }
}

struct Impossible {
  int number = 0;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("number", self.number, "any", within(0, 9));
    visit.require(self.number > 9, "number must be above its interval");
  }
};

TEST(RandomOptions, GiveUpOnRulesThatNobodyCanKeep) {
  std::mt19937_64 random(3);
  EXPECT_THROW(random_options<Impossible>(random), std::runtime_error);
}

}  // namespace
}  // namespace portolan::testing
