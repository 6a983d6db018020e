// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "portolan/options.hpp"

namespace portolan {

enum class Fusion { max, sum, latest };

constexpr std::array<const char*, 3> enum_names(Fusion) { return {"max", "sum", "latest"}; }

/// An ordinary group, used once by name and several times in a list.
struct BeamOptions {
  double p_hit = 0.75;
  double p_miss = 0.25;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("p_hit", self.p_hit, "P(occupied | echo)", between(0.5, 1.0));
    visit("p_miss", self.p_miss, "P(occupied | none)", between(0.0, 0.5));
    visit.require(self.p_hit + self.p_miss > 0.7, "p_hit and p_miss must be above 0.7 together");
  }
};

/// A group with a group in it.
struct LayerOptions {
  std::string topic = "scan";
  std::int32_t queue = 10;
  BeamOptions beam;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("topic", self.topic, "where it listens");
    visit("queue", self.queue, "messages that may wait", within(1, 100));
    visit("beam", self.beam, "the sensor model");
  }
};

/// Options of every kind that there is.
struct ExampleOptions {
  double resolution = 0.05;
  float weight = 0.5F;
  double offset = 0.0;
  bool publish = true;
  std::uint8_t quantum = 4;
  std::int64_t limit = -1;
  Fusion fusion = Fusion::max;
  std::string frame = "map";
  LayerOptions laser;
  std::vector<double> origin = {0.0, 0.0, 0.0};
  std::vector<bool> flags;
  std::vector<Fusion> fusions;
  std::vector<std::string> names;
  std::vector<LayerOptions> layers;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("resolution", self.resolution, "side of a cell [m]", above(0.0));
    visit("weight", self.weight, "share of the new | old value", within(0.0, 1.0));
    visit("offset", self.offset, "of the origin [m]");
    visit("publish", self.publish, "whether anyone hears of it");
    visit("quantum", self.quantum, "step of the log-odds");
    visit("limit", self.limit, "or -1", at_least(-1.0));
    visit("fusion", self.fusion, "how layers join");
    visit("frame", self.frame, "of the map");
    visit("laser", self.laser, "the laser's layer");
    visit("origin", self.origin, "x, y, z [m]");
    visit("flags", self.flags, "on or off");
    visit("fusions", self.fusions, "one after the other");
    visit("names", self.names, "of anything");
    visit("layers", self.layers, "more of them");
    visit.require(self.resolution < 1.0, "resolution must be below a metre");
    visit.require(self.origin.size() == 3, "origin must have three numbers");
  }
};

}  // namespace portolan
