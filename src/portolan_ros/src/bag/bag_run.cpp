// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/bag_run.hpp"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <list>
#include <stdexcept>

#include "portolan_ros/bag/bag_graph.hpp"
#include "portolan_ros/bag/progress_bar.hpp"
#include "portolan_ros/kinds/for_each_kind.hpp"

namespace portolan {

namespace {

YAML::Node merged_config(const std::vector<std::string>& files) {
  YAML::Node config(YAML::NodeType::Map);
  for (const std::string& file : files) {
    try {
      for (const auto& section : YAML::LoadFile(file)) config[section.first] = section.second;
    } catch (const YAML::Exception& error) {
      throw std::runtime_error(file + ": " + error.what());
    }
  }
  return config;
}

AnyBagMapper any_bag_graph(const YAML::Node& config) {
  GraphNodeOptions options;
  if (config[BagGraph::kName]) read_options(config[BagGraph::kName], options);
  const auto graph = std::make_shared<BagGraph>(options);
  return {BagGraph::kName,
          graph->topics(),
          graph->input_topics(),
          [graph](const rosbag::MessageInstance& message) { graph->take(message); },
          [](const Correction& /*its own*/) {},
          [graph] { graph->finish(); },
          [graph] { return graph->files(); },
          [graph] { return graph->summary(); },
          [graph] { return graph->tallies(); },
          [graph] { return graph->correction(); }};
}

// A file that says how a simulated robot is built may say how it maps, too.
constexpr const char* kSimulator = "robot_sim";

void check_sections(const YAML::Node& config, const std::vector<AnyBagMapper>& mappers) {
  for (const auto& section : config) {
    const std::string name = section.first.Scalar();
    const bool known =
        name == kSimulator || std::any_of(mappers.begin(), mappers.end(),
                                          [&](const AnyBagMapper& m) { return m.name == name; });
    if (!known) throw OptionsError({name + " is the name of no mapper"});
  }
}

/// The bags, opened, and how their time runs.
struct Bags {
  std::list<rosbag::Bag> open;
  ros::Time begin;
  ros::Time end;
  std::set<std::string> topics;
};

Bags open_bags(const BagRun& what) {
  Bags bags;
  rosbag::View all;
  for (const std::string& path : what.bags) {
    try {
      bags.open.emplace_back(path);
    } catch (const rosbag::BagException& error) {
      throw std::runtime_error(path + ": " + error.what());
    }
    all.addQuery(bags.open.back());
  }
  if (all.size() == 0) throw std::runtime_error("the bags hold no messages");
  bags.begin = all.getBeginTime() + ros::Duration(what.start);
  bags.end = what.duration ? bags.begin + ros::Duration(*what.duration) : all.getEndTime();
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    bags.topics.insert(ros_convert::without_slash(connection->topic));
  }
  return bags;
}

bool is_wanted(const AnyBagMapper& mapper, const BagRun& what, const Bags& bags) {
  if (what.mappers) {
    return std::count(what.mappers->begin(), what.mappers->end(), mapper.name) > 0;
  }
  if (mapper.name == BagGraph::kName) return false;  // it changes all maps: only if asked for
  return std::any_of(mapper.input_topics.begin(), mapper.input_topics.end(),
                     [&](const std::string& topic) { return bags.topics.count(topic) > 0; });
}

std::vector<AnyBagMapper> wanted_mappers(const BagRun& what, const Bags& bags) {
  const YAML::Node config = merged_config(what.configs);
  std::vector<AnyBagMapper> mappers;
  for_each_kind([&](auto kind) { mappers.push_back(any_bag_mapper<decltype(kind)>(config)); });
  mappers.push_back(any_bag_graph(config));
  check_sections(config, mappers);
  for (const std::string& name : what.mappers.value_or(std::vector<std::string>{})) {
    const bool known = std::any_of(mappers.begin(), mappers.end(),
                                   [&](const AnyBagMapper& m) { return m.name == name; });
    if (!known) throw std::invalid_argument("there is no mapper called " + name);
  }
  mappers.erase(std::remove_if(mappers.begin(), mappers.end(),
                               [&](const AnyBagMapper& m) { return !is_wanted(m, what, bags); }),
                mappers.end());
  if (mappers.empty()) throw std::runtime_error("no mapper finds a topic of its own in the bags");
  return mappers;
}

/// The topic as the bag may spell it: with its slash and without.
std::vector<std::string> spellings(const std::set<std::string>& topics) {
  std::vector<std::string> all;
  for (const std::string& topic : topics) {
    all.push_back(topic);
    all.push_back("/" + topic);
  }
  return all;
}

void add_queries(rosbag::View& view, const Bags& bags, const std::set<std::string>& topics,
                 const ros::Time& from, const ros::Time& to) {
  for (const rosbag::Bag& bag : bags.open) {
    view.addQuery(bag, rosbag::TopicQuery(spellings(topics)), from, to);
  }
}

void play(const Bags& bags, std::vector<AnyBagMapper>& mappers) {
  std::set<std::string> topics;
  for (const AnyBagMapper& mapper : mappers) {
    topics.insert(mapper.topics.begin(), mapper.topics.end());
  }
  const auto give_all = [&mappers](const rosbag::MessageInstance& message) {
    for (AnyBagMapper& mapper : mappers) mapper.take(message);
  };
  rosbag::View mounts;  // static transforms hold from before the start on
  add_queries(mounts, bags, {"tf_static"}, ros::TIME_MIN, bags.begin);
  for (const rosbag::MessageInstance& message : mounts) give_all(message);
  rosbag::View view;
  add_queries(view, bags, topics, bags.begin, bags.end);
  ProgressBar bar(std::cerr, isatty(STDERR_FILENO) == 1, "mapping");
  std::uint32_t done = 0;
  for (const rosbag::MessageInstance& message : view) {
    give_all(message);
    bar.show(static_cast<double>(++done) / view.size());
  }
  bar.finish();
}

/// The pose graph is the last one, and the others wait for what it knows of the drift.
void finish(std::vector<AnyBagMapper>& mappers) {
  AnyBagMapper& last = mappers.back();
  if (last.correction) {
    last.finish();
    for (AnyBagMapper& mapper : mappers) mapper.correct(last.correction());
  }
  for (AnyBagMapper& mapper : mappers) mapper.finish();
}

YAML::Node summary_of(const BagRun& what, const std::vector<AnyBagMapper>& mappers) {
  YAML::Node summary;
  summary["portolan"] = PORTOLAN_VERSION;
  for (const std::string& bag : what.bags) {
    summary["bags"].push_back(std::filesystem::path(bag).filename().string());
  }
  for (const AnyBagMapper& mapper : mappers) summary["mappers"][mapper.name] = mapper.summary();
  return summary;
}

}  // namespace

void run(const BagRun& what) {
  const Bags bags = open_bags(what);
  std::vector<AnyBagMapper> mappers = wanted_mappers(what, bags);
  play(bags, mappers);
  finish(mappers);
  FileSet files;
  for (const AnyBagMapper& mapper : mappers) {
    std::cerr << mapper.name << ": " << sentence_of(mapper.tallies()) << std::endl;
    files.merge(mapper.files());
  }
  YAML::Emitter summary;
  summary << summary_of(what, mappers);
  files["summary.yaml"] = std::string(summary.c_str()) + "\n";
  std::filesystem::create_directories(what.out);
  save_files(what.out, files);
  std::cerr << files.size() << " files in " << what.out << std::endl;
  for (const AnyBagMapper& mapper : mappers) {
    if (!used_anything(mapper.tallies())) {
      throw std::runtime_error("the map of " + mapper.name +
                               " is empty: " + sentence_of(mapper.tallies()));
    }
  }
}

}  // namespace portolan
