// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/value.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "options/comma_locale.hpp"
#include "options/example_options.hpp"

namespace portolan::options_detail {
namespace {

TEST(Value, ReadsNumbersWhole) {
  EXPECT_EQ(parse<double>("1"), 1.0);
  EXPECT_EQ(parse<double>("-2.5e-3"), -2.5e-3);
  EXPECT_EQ(parse<double>(".5"), 0.5);
  EXPECT_EQ(parse<double>("-.inf"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parse<double>(".NaN")));
  for (const char* text : {"", "1,5", "1.5 m", " 1", "1 ", "one", "0x10", "1e", "1e999", "--1"}) {
    EXPECT_THROW(parse<double>(text), std::invalid_argument) << text;
  }
}

TEST(Value, ReadsIntegersThatFit) {
  EXPECT_EQ(parse<std::int64_t>("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(parse<std::uint8_t>("255"), 255);
  EXPECT_EQ(parse<std::int8_t>("-128"), -128);
  for (const char* text : {"", "1.0", "1e3", "0x10", "7 ", "9223372036854775808"}) {
    EXPECT_THROW(parse<std::int64_t>(text), std::invalid_argument) << text;
  }
  for (const char* text : {"256", "-1", "-256"}) {
    EXPECT_THROW(parse<std::uint8_t>(text), std::invalid_argument) << text;
  }
  EXPECT_THROW(parse<std::uint64_t>("-1"), std::invalid_argument);
  EXPECT_THROW(parse<std::int8_t>("128"), std::invalid_argument);
}

TEST(Value, ReadsWordsOfYamlAsBool) {
  for (const char* text : {"true", "True", "YES", "on"}) EXPECT_TRUE(parse<bool>(text));
  for (const char* text : {"false", "FALSE", "no", "Off"}) EXPECT_FALSE(parse<bool>(text));
  for (const char* text : {"", "1", "0", "t"}) {
    EXPECT_THROW(parse<bool>(text), std::invalid_argument) << text;
  }
}

TEST(Value, ReadsEnumeratorsByName) {
  EXPECT_EQ(parse<Fusion>("latest"), Fusion::latest);
  EXPECT_EQ(format(Fusion::sum), "sum");
  try {
    parse<Fusion>("Max");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "one of max | sum | latest");
  }
}

TEST(Value, WritesTheShortestNumberThatReadsBack) {
  EXPECT_EQ(format(0.05), "0.05");
  EXPECT_EQ(format(1.0), "1");
  EXPECT_EQ(format(-0.1), "-0.1");
  EXPECT_EQ(format(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(format(std::numeric_limits<double>::infinity()), ".inf");
  EXPECT_EQ(format(0.5F), "0.5");
  EXPECT_EQ(format(std::uint8_t{7}), "7");
}

TEST(Value, WritesExponentsThatYamlTakesForNumbers) {
  EXPECT_EQ(format(1e-6), "1.0e-06");
  EXPECT_EQ(format(-2e20), "-2.0e+20");
  EXPECT_EQ(format(2.5e-9), "2.5e-09");
}

TEST(Value, EveryNumberReadsBackAsItself) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value)) {
      EXPECT_EQ(parse<double>(format(value)), value) << format(value);
    }
  }
  EXPECT_EQ(parse<double>(format(std::numeric_limits<double>::denorm_min())),
            std::numeric_limits<double>::denorm_min());
}

TEST(Value, QuotesWhatYamlWouldMisread) {
  EXPECT_EQ(format(std::string("base_link")), "base_link");
  EXPECT_EQ(format(std::string("a/b")), "a/b");
  for (const std::string text : {"", "true", "No", "y", "NULL", "12", "1e5", "~", "a: b", "a #b"}) {
    EXPECT_EQ(format(text), "\"" + text + "\"");
  }
  EXPECT_EQ(format(std::string("say \"hi\"\\\n")), "\"say \\\"hi\\\"\\\\\\x0a\"");
}

TEST(Value, EveryTextReadsBackAsItself) {
  std::string all;
  for (char c = 1; c < 127; ++c) all += c;
  all += "\x7fäß→";
  EXPECT_EQ(YAML::Load(format(all)).Scalar(), all);
  for (const char c : all.substr(0, 127)) {
    EXPECT_EQ(YAML::Load("[" + format(std::string(1, c)) + "]  # c")[0].Scalar(),
              std::string(1, c));
  }
}

TEST(Value, DoesNotDependOnTheLocale) {
  const CommaLocale comma;
  EXPECT_EQ(parse<double>("1234567.5"), 1234567.5);
  EXPECT_THROW(parse<double>("1,5"), std::invalid_argument);
  EXPECT_EQ(format(1234567.5), "1234567.5");
  EXPECT_EQ(format(std::int64_t{1234567}), "1234567");
}

}  // namespace
}  // namespace portolan::options_detail
