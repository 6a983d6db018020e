// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/node_options.hpp"

#include <gtest/gtest.h>

#include <string>

#include "portolan_ros/graph/graph_node_options.hpp"
#include "portolan_ros/kinds/beacon_kind.hpp"

namespace portolan {
namespace {

/// The faults of a node's options of which one line of YAML stands otherwise.
template <class Options>
std::string faults_with(const std::string& yaml) {
  Options options;
  try {
    read_options(YAML::Load(yaml), options);
  } catch (const OptionsError& error) {
    return error.what();
  }
  return "";
}

using Mapper = MapperNodeOptions<BeaconKind>;
using Graph = GraphNodeOptions;

void expect_named(const std::string& yaml, const std::string& words) {
  EXPECT_NE(faults_with<Mapper>(yaml).find(words), std::string::npos) << yaml;
  EXPECT_NE(faults_with<Graph>(yaml).find(words), std::string::npos) << yaml;
}

TEST(NodeOptions, FramesAndFoldersHaveNames) {
  expect_named("map_frame: \"\"", "map_frame must not be empty");
  expect_named("odom_frame: \"\"", "odom_frame must not be empty");
  expect_named("base_frame: \"\"", "base_frame must not be empty");
  expect_named("map_directory: \"\"", "map_directory must not be empty");
}

TEST(NodeOptions, AMapNameThatLeavesTheFolderIsAFaultAtTheStartAndNotWhenTheMapIsSaved) {
  for (const char* name : {"\"\"", "lab/ground_floor", "..", ".hidden", "\"a\\nb\""}) {
    expect_named("map_name: " + std::string(name), "map_name must be a bare file name");
  }
  EXPECT_EQ(faults_with<Mapper>("map_name: ground floor 2"), "");
}

TEST(NodeOptions, WhoHasALocaliserMayMapInItsFrameButNotFindTheDriftOfIt) {
  EXPECT_EQ(faults_with<Mapper>("odom_frame: map"), "");
  EXPECT_NE(faults_with<Graph>("odom_frame: map"), "");
}

}  // namespace
}  // namespace portolan
