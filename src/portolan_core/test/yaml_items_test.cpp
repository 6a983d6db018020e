// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/yaml_items.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace portolan::yaml_values {
namespace {

struct Read {
  YAML::Node head;
  std::vector<std::string> items;
  std::vector<std::string> versions;  // as each item found it
};

Read read(const std::string& text) {
  Read found;
  found.head = read_items(text, "things", [&](const YAML::Node& head, const YAML::Node& item) {
    found.items.push_back(YAML::Dump(item));
    found.versions.push_back(YAML::Dump(head["version"]));
  });
  return found;
}

/// What is said of a text that is refused; empty where it is read.
std::string fault_of(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(YamlItems, AreGivenOneByOneAndTheRestIsKept) {
  const Read found = read(
      "version: 1\n"
      "things:\n  - {id: 4, mean: [1, 2]}\n  - id: 5\n    things: [7]\n  - [8, ~]\n  - nine\n"
      "noise: {a: 0.5, b: [x, {c: d}]}\n");
  EXPECT_EQ(found.items, (std::vector<std::string>{"id: 4\nmean:\n  - 1\n  - 2",
                                                   "id: 5\nthings:\n  - 7", "- 8\n- ~", "nine"}));
  EXPECT_EQ(found.versions, std::vector<std::string>(4, "1"));
  EXPECT_TRUE(found.head["things"].IsSequence());
  EXPECT_EQ(found.head["things"].size(), 0U);
  EXPECT_EQ(found.head["noise"]["b"][1]["c"].as<std::string>(), "d");
}

TEST(YamlItems, OfAListOfAnotherNameAreNone) {
  for (const char* text : {"", "~", "word", "[1, {things: [2]}]", "more: {things: [1, 2]}"}) {
    EXPECT_TRUE(read(text).items.empty()) << text;
  }
  EXPECT_EQ(read("more: {things: [1, 2]}").head["more"]["things"].size(), 2U);
  EXPECT_TRUE(read("things: {a: 1}").head["things"].IsMap());
  EXPECT_FALSE(read("word").head.IsMap());
}

TEST(YamlItems, InAFileThatWouldTakeAllMemoryAreRefused) {
  std::string many = "things: [[0";
  for (int i = 0; i < 1000000; ++i) many += ",0";
  EXPECT_NE(fault_of(many + "]]").find("too large"), std::string::npos);
  EXPECT_NE(fault_of("things: " + std::string(100000, '[')).find("too deep"), std::string::npos);
  EXPECT_NE(fault_of("a: &a [x]\nthings: [*a, *a]\n").find("anchors"), std::string::npos);
  EXPECT_NE(fault_of("? [a]\n: b\n").find("key"), std::string::npos);
  EXPECT_NE(fault_of("things: [1, 2").find("line"), std::string::npos);
}

TEST(YamlItems, MayBeAsManyAsThereAre) {
  std::string text = "things:\n";
  for (int i = 0; i < 300000; ++i) text += "- {a: 1, b: 2}\n";  // over a million values in all
  EXPECT_EQ(read(text).items.size(), 300000U);
}

}  // namespace
}  // namespace portolan::yaml_values
