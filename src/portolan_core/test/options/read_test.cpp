// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/read.hpp"

#include <gtest/gtest.h>

#include "options/comma_locale.hpp"
#include "options/example_options.hpp"

namespace portolan {
namespace {

using Faults = std::vector<std::string>;

ExampleOptions read(const std::string& yaml) {
  ExampleOptions options;
  read_options(YAML::Load(yaml), options);
  return options;
}

Faults faults_of(const std::string& yaml) {
  try {
    read(yaml);
  } catch (const OptionsError& error) {
    return error.faults();
  }
  return {};
}

TEST(Read, KeepsWhatIsNotNamed) {
  const ExampleOptions options = read("{resolution: 0.1, laser: {beam: {p_hit: 0.9}}}");
  EXPECT_EQ(options.resolution, 0.1);
  EXPECT_EQ(options.laser.beam.p_hit, 0.9);
  EXPECT_EQ(options.laser.beam.p_miss, 0.25);
  EXPECT_EQ(options.frame, "map");
}

TEST(Read, TakesAnEmptyMapOrGroup) {
  EXPECT_EQ(read("").resolution, 0.05);
  EXPECT_EQ(read("{}").resolution, 0.05);
  EXPECT_EQ(read("laser:\nresolution: 0.2").resolution, 0.2);
}

TEST(Read, TakesEveryKind) {
  const ExampleOptions options = read(R"(
weight: 0.25
offset: -3
publish: no
quantum: 255
limit: 9000000000
fusion: latest
frame: "world: 1"
origin: [1, 2.5, -3]
flags: [true, false]
fusions: [sum, max]
names: [a, "b c"]
layers: [{topic: front, beam: {p_hit: 0.8}}, {queue: 3}]
)");
  EXPECT_EQ(options.weight, 0.25F);
  EXPECT_EQ(options.offset, -3.0);
  EXPECT_FALSE(options.publish);
  EXPECT_EQ(options.quantum, 255);
  EXPECT_EQ(options.limit, 9000000000);
  EXPECT_EQ(options.fusion, Fusion::latest);
  EXPECT_EQ(options.frame, "world: 1");
  EXPECT_EQ(options.origin, (std::vector<double>{1.0, 2.5, -3.0}));
  EXPECT_EQ(options.flags, (std::vector<bool>{true, false}));
  EXPECT_EQ(options.fusions, (std::vector<Fusion>{Fusion::sum, Fusion::max}));
  EXPECT_EQ(options.names, (std::vector<std::string>{"a", "b c"}));
  ASSERT_EQ(options.layers.size(), 2u);
  EXPECT_EQ(options.layers[0].topic, "front");
  EXPECT_EQ(options.layers[0].beam.p_hit, 0.8);
  EXPECT_EQ(options.layers[1].topic, "scan");
  EXPECT_EQ(options.layers[1].queue, 3);
}

TEST(Read, AListReplacesTheDefaultOne) {
  EXPECT_TRUE(read("layers: []").layers.empty());
  EXPECT_EQ(faults_of("origin: [1, 2]"), Faults{"origin must have three numbers"});
}

TEST(Read, SaysWhichNamesAreUnknownAtEveryDepth) {
  const Faults expected = {"laser/beam/p_hitt is no option here", "laser/topik is no option here",
                           "layers[0]/x is no option here", "resolutoin is no option here"};
  EXPECT_EQ(faults_of("{resolutoin: 1, laser: {topik: a, beam: {p_hitt: 1}}, layers: [{x: 1}]}"),
            expected);
}

TEST(Read, SaysWhatItExpectedInstead) {
  const Faults expected = {
      "resolution = 5 cm must be a number", "weight = ~ must be a number",
      "publish = 1 must be true or false",  "quantum = 256 must be a smaller whole number",
      "limit = 1.5 must be a whole number", "fusion = [max] must be one of max | sum | latest",
      "frame = {a: b} must be text",        "laser = 3 must be a map of options",
      "origin[1] = x must be a number",     "flags = true must be a list"};
  EXPECT_EQ(faults_of("{resolution: \"5 cm\", weight: , publish: 1, quantum: 256, limit: 1.5,"
                      " fusion: [max], frame: {a: b}, laser: 3, origin: [1, x, 3], flags: true}"),
            expected);
}

TEST(Read, JoinsWrongTypesUnknownNamesRangesAndRules) {
  const Faults expected = {"publish = maybe must be true or false", "other is no option here",
                           "weight = 2 must be in [0, 1]", "resolution must be below a metre"};
  EXPECT_EQ(faults_of("{publish: maybe, other: 1, weight: 2, resolution: 3}"), expected);
}

TEST(Read, RefusesWhatIsNoMap) {
  EXPECT_EQ(faults_of("[1, 2]"), Faults{"options must be a map of names"});
  EXPECT_EQ(faults_of("5"), Faults{"options must be a map of names"});
}

TEST(Read, SeveralStructsShareOneMap) {
  BeamOptions beam;
  LayerOptions layer;
  read_options(YAML::Load("{p_hit: 0.6, p_miss: 0.2, topic: a}"), beam, layer);
  EXPECT_EQ(beam.p_hit, 0.6);
  EXPECT_EQ(layer.topic, "a");
  try {
    read_options(YAML::Load("{p_hit: 2, queue: 0, z: 1}"), beam, layer);
    FAIL();
  } catch (const OptionsError& error) {
    EXPECT_EQ(error.faults(), (Faults{"z is no option here", "p_hit = 2 must be in (0.5, 1)",
                                      "queue = 0 must be in [1, 100]"}));
  }
}

TEST(Read, DoesNotDependOnTheLocale) {
  const CommaLocale comma;
  EXPECT_EQ(read("resolution: 0.125").resolution, 0.125);
  EXPECT_EQ(faults_of("resolution: 0,125"), Faults{"resolution = 0,125 must be a number"});
}

}  // namespace
}  // namespace portolan
