// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/write.hpp"

#include <gtest/gtest.h>

#include "options/comma_locale.hpp"
#include "options/example_options.hpp"
#include "portolan/options/read.hpp"
#include "portolan/testing/random_options.hpp"

namespace portolan {
namespace {

const ExampleOptions kDefaults;

TEST(Write, YamlShowsNameValueMeaningAndInterval) {
  EXPECT_EQ(to_yaml(option_rows(kDefaults.laser)),
            "topic: scan  # where it listens\n"
            "queue: 10  # messages that may wait; in [1, 100]\n"
            "beam:\n"
            "  p_hit: 0.75  # P(occupied | echo); in (0.5, 1)\n"
            "  p_miss: 0.25  # P(occupied | none); in (0, 0.5)\n");
}

TEST(Write, RowsGoThroughGroupsInTheirOrder) {
  std::vector<std::string> names;
  for (const OptionRow& row : option_rows(kDefaults)) names.push_back(row.name);
  EXPECT_EQ(names, (std::vector<std::string>{"resolution", "weight", "offset", "publish", "quantum",
                                             "limit", "fusion", "frame", "laser/topic",
                                             "laser/queue", "laser/beam/p_hit", "laser/beam/p_miss",
                                             "origin", "flags", "fusions", "names", "layers"}));
}

TEST(Write, RowsSayTypes) {
  std::vector<std::string> types;
  for (const OptionRow& row : option_rows(kDefaults)) types.push_back(row.type);
  EXPECT_EQ(types, (std::vector<std::string>{
                       "number", "number", "number", "true | false", "whole number", "whole number",
                       "max | sum | latest", "text", "text", "whole number", "number", "number",
                       "list of number", "list of true | false", "list of max | sum | latest",
                       "list of text", "list of groups"}));
}

TEST(Write, GroupsInListsAreWrittenInOneLine) {
  ExampleOptions options;
  options.layers.resize(1);
  EXPECT_EQ(option_rows(options).back().value,
            "[{topic: scan, queue: 10, beam: {p_hit: 0.75, p_miss: 0.25}}]");
}

TEST(Write, MarkdownEscapesWhatWouldEndACell) {
  ExampleOptions options;
  options.frame = "a|b";
  const std::string table = to_markdown(option_rows(options));
  EXPECT_NE(table.find("| `fusion` | max \\| sum \\| latest | `max` |  | how layers join |\n"),
            std::string::npos);
  EXPECT_NE(
      table.find("| `weight` | number | `0.5` | in [0, 1] | share of the new \\| old value |"),
      std::string::npos);
  EXPECT_NE(table.find("`\"a\\|b\"`"), std::string::npos);
}

void expect_round_trip(const ExampleOptions& options) {
  const std::string yaml = to_yaml(option_rows(options));
  ExampleOptions read;
  ASSERT_NO_THROW(read_options(YAML::Load(yaml), read)) << yaml;
  const std::vector<OptionRow> before = option_rows(options);
  const std::vector<OptionRow> after = option_rows(read);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].value, after[i].value) << before[i].name;
  }
}

TEST(Write, RandomOptionsReadBackTheSame) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    std::mt19937_64 random(seed);
    expect_round_trip(testing::random_options<ExampleOptions>(random));
  }
}

TEST(Write, ReadsBackInAnyLocale) {
  const CommaLocale comma;
  std::mt19937_64 random(7);
  expect_round_trip(testing::random_options<ExampleOptions>(random));
}

}  // namespace
}  // namespace portolan
