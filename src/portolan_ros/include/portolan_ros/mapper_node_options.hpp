// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "portolan/options.hpp"
#include "portolan/remapper.hpp"
#include "portolan_ros/kinds/kind_parts.hpp"
#include "portolan_ros/node_options.hpp"
#include "portolan_ros/posed_input.hpp"

namespace portolan {

/// What becomes of the map when the clock runs back.
enum class OnTimeJump {
  reset,  ///< it starts anew: the bag loops, the simulator was restarted
  keep,   ///< it stays, but what it shows can no longer be corrected
};

constexpr std::array<const char*, 2> enum_names(OnTimeJump) { return {"reset", "keep"}; }

/// What every mapper takes in, and how: the part that needs no ROS graph.
struct PipelineOptions {
  std::string base_frame = "base_link";
  OnTimeJump on_time_jump = OnTimeJump::reset;
  PosedInputOptions posing;
  RemapperOptions remapper;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("base_frame", self.base_frame, "the robot's own frame");
    visit("on_time_jump", self.on_time_jump,
          "when the clock runs back: start anew, or keep a map that corrections no longer move");
    PosedInputOptions::describe(self.posing, visit);
    RemapperOptions::describe(self.remapper, visit);
    visit.require(!self.base_frame.empty(), "base_frame must not be empty");
  }
};

/// The topics of each input, by the input's name; parameter `<name>_topics`.
struct TopicOptions {
  std::map<std::string, std::vector<std::string>> by_input;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    for (auto& [name, topics] : self.by_input) {
      const std::string meaning = "topics that feed the input `" + name + "`; [] for none";
      visit((name + "_topics").c_str(), topics, meaning.c_str());
    }
  }
};

/// The topics of a kind of map before anybody changed them: each input's own name.
template <class Kind>
TopicOptions default_topics() {
  TopicOptions options;
  Kind::inputs([&options](const std::string& name, const std::string& /*noun*/, auto /*convert*/) {
    options.by_input[name] = {name};
  });
  return options;
}

/// All options of a node for one kind of map, as its private parameters name them.
template <class Kind>
struct MapperNodeOptions {
  NodeOptions node = node_options_for(Kind::kFileName);
  double redraw_share = 0.5;
  PipelineOptions pipeline;
  TopicOptions topics = default_topics<Kind>();
  typename FilterOf<Kind>::Options filter;
  typename Kind::OutputOptions output;
  typename Kind::Mapper::Options mapper;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    NodeOptions::describe(self.node, visit);
    visit("redraw_share", self.redraw_share,
          "share of one core that redrawing after a correction may use", above_to(0.0, 0.95));
    PipelineOptions::describe(self.pipeline, visit);
    TopicOptions::describe(self.topics, visit);
    FilterOf<Kind>::Options::describe(self.filter, visit);
    Kind::OutputOptions::describe(self.output, visit);
    Kind::Mapper::Options::describe(self.mapper, visit);
  }
};

}  // namespace portolan
