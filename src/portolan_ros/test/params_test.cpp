// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/params.hpp"

#include <gtest/gtest.h>

#include <array>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

namespace portolan {
namespace {

using XmlRpc::XmlRpcValue;

enum class Colour { red, green };
constexpr std::array<const char*, 2> enum_names(Colour) { return {"red", "green"}; }

struct Inner {
  double depth = 1.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("depth", self.depth, "how deep [m]", above(0.0));
  }
};

struct Example {
  bool flag = false;
  int count = 3;
  double size = 0.5;
  std::string name = "none";
  Colour colour = Colour::red;
  std::vector<std::string> topics = {"scan"};
  std::vector<double> numbers;
  Inner inner;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("flag", self.flag, "whether");
    visit("count", self.count, "how many", within(0, 10));
    visit("size", self.size, "how large [m]", between(0.0, 10.0));
    visit("name", self.name, "what it is called");
    visit("colour", self.colour, "how it looks");
    visit("topics", self.topics, "where from");
    visit("numbers", self.numbers, "some numbers");
    visit("inner", self.inner, "what is inside");
  }
};

/// What a launch file or rosparam would put on the server.
XmlRpcValue tree() {
  XmlRpcValue value;
  value["flag"] = true;
  value["count"] = 7;
  value["size"] = 0.1;
  value["name"] = "true";  // a text, whatever it looks like
  value["colour"] = "green";
  value["topics"][0] = "front";
  value["topics"][1] = "/rear/scan";
  value["numbers"][0] = 1;
  value["numbers"][1] = 2.5;
  value["inner"]["depth"] = 2;
  return value;
}

/// The faults of a tree in which this one value stands otherwise.
std::vector<std::string> faults_with(const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue changed = tree();
  changed[name] = value;
  Example options;
  try {
    read_options(to_yaml(changed), options);
  } catch (const OptionsError& error) {
    return error.faults();
  }
  return {};
}

XmlRpcValue list_of(const XmlRpcValue& item) {
  XmlRpcValue list;
  list[0] = item;
  return list;
}

XmlRpcValue empty_list() {
  XmlRpcValue list;
  list.setSize(0);
  return list;
}

TEST(Params, ReachTheirOptions) {
  Example options;
  read_options(to_yaml(tree()), options);
  EXPECT_TRUE(options.flag);
  EXPECT_EQ(options.count, 7);
  EXPECT_EQ(options.size, 0.1);
  EXPECT_EQ(options.name, "true");
  EXPECT_EQ(options.colour, Colour::green);
  EXPECT_EQ(options.topics, (std::vector<std::string>{"front", "/rear/scan"}));
  EXPECT_EQ(options.numbers, (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(options.inner.depth, 2.0);
}

TEST(Params, WhatIsNotThereKeepsItsDefault) {
  Example options;
  read_options(to_yaml(XmlRpcValue()), options);
  XmlRpcValue one;
  one["count"] = 4;
  read_options(to_yaml(one), options);
  EXPECT_EQ(options.count, 4);
  EXPECT_EQ(options.size, 0.5);
  EXPECT_EQ(options.topics, std::vector<std::string>{"scan"});
}

TEST(Params, AnEmptyListIsAList) {
  XmlRpcValue value;
  value["topics"] = empty_list();
  Example options;
  read_options(to_yaml(value), options);
  EXPECT_TRUE(options.topics.empty());
}

TEST(Params, NumbersKeepEveryBit) {
  for (const double number : {0.1, 1.0 / 3.0, 5e-324, 1e-6, 9.999999999999998}) {
    XmlRpcValue value;
    value["size"] = number;
    Example options;
    read_options(to_yaml(value), options);
    EXPECT_EQ(options.size, number);
  }
}

TEST(Params, OfTheWrongTypeAreFaults) {
  using Faults = std::vector<std::string>;
  EXPECT_EQ(faults_with("flag", 1), Faults{"flag = 1 must be true or false"});
  EXPECT_EQ(faults_with("count", 2.5), Faults{"count = 2.5 must be a whole number"});
  EXPECT_EQ(faults_with("count", true), Faults{"count = true must be a whole number"});
  EXPECT_EQ(faults_with("size", "large"), Faults{"size = large must be a number"});
  EXPECT_EQ(faults_with("size", true), Faults{"size = true must be a number"});
  EXPECT_EQ(faults_with("colour", "blue"), Faults{"colour = blue must be one of red | green"});
  EXPECT_EQ(faults_with("numbers", list_of("x")).size(), 1u);
  EXPECT_EQ(faults_with("numbers", list_of(list_of(1.0))).size(), 1u);
  EXPECT_EQ(faults_with("topics", "scan").size(), 1u);
  EXPECT_EQ(faults_with("inner", 3).size(), 1u);
  EXPECT_EQ(faults_with("name", tree()).size(), 1u);
  EXPECT_EQ(faults_with("size", list_of(1.0)).size(), 1u);
}

TEST(Params, OutOfTheirIntervalAreFaults) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(faults_with("count", 11), std::vector<std::string>{"count = 11 must be in [0, 10]"});
  for (const double size : {nan, inf, -inf, 0.0, 10.0}) {
    EXPECT_EQ(faults_with("size", size).size(), 1u) << size;
  }
}

TEST(Params, OfAKindThatNoOptionHasAreFaults) {
  std::tm time{};
  EXPECT_EQ(faults_with("size", XmlRpcValue(&time)).size(), 1u);
  char bytes[] = "abc";
  EXPECT_EQ(faults_with("name", XmlRpcValue(bytes, 3)).size(), 1u);
}

TEST(Params, ThatNobodyKnowsAreFaultsAndAllAreToldAtOnce) {
  XmlRpcValue value = tree();
  value["resolutoin"] = 0.05;
  value["inner"]["width"] = 1.0;
  value["count"] = -1;
  Example options;
  try {
    read_options(to_yaml(value), options);
    FAIL() << "nothing was thrown";
  } catch (const OptionsError& error) {
    EXPECT_EQ(error.faults().size(), 3u);
    for (const char* name : {"resolutoin", "inner/width", "count"}) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
    }
  }
}

}  // namespace
}  // namespace portolan
