// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/bag_run.hpp"

#include <rosbag/view.h>
#include <unistd.h>

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "bag_report.hpp"
#include "open_bags.hpp"
#include "portolan_ros/bag/assignments.hpp"
#include "portolan_ros/bag/bag_graph.hpp"
#include "portolan_ros/bag/progress_bar.hpp"
#include "portolan_ros/kinds/for_each_kind.hpp"

namespace portolan {

namespace {

YAML::Node merged_config(const std::vector<std::string>& files) {
  YAML::Node config(YAML::NodeType::Map);
  for (const std::string& file : files) {
    try {
      const YAML::Node sections = YAML::LoadFile(file);
      if (!sections.IsMap() && !sections.IsNull()) {
        throw std::runtime_error(file + ": options under mappers' names are wanted");
      }
      for (const auto& section : sections) config[section.first] = section.second;
    } catch (const YAML::Exception& error) {
      throw std::runtime_error(file + ": " + error.what());
    }
  }
  return config;
}

/// The files' options, and over them those of the command line.
YAML::Node configured(const BagRun& what) {
  YAML::Node config = merged_config(what.configs);
  Assignments assignments(what.assignments);
  const auto assign = [&](const std::string& mapper, const std::vector<OptionRow>& options) {
    config[mapper] = assignments.over(config[mapper], options);
  };
  for_each_kind([&](auto kind) {
    using Kind = decltype(kind);
    assign(Kind::kName, option_rows(MapperNodeOptions<Kind>()));
  });
  assign(BagGraph::kName, option_rows(GraphNodeOptions()));
  assignments.check_all_known();
  return config;
}

AnyBagMapper any_bag_graph(const YAML::Node& config) {
  GraphNodeOptions options;
  if (config[BagGraph::kName]) read_options(config[BagGraph::kName], options);
  const auto graph = std::make_shared<BagGraph>(options);
  return {BagGraph::kName,
          BagGraph::kLegend,
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

bool is_wanted(const AnyBagMapper& mapper, const BagRun& what, const Bags& bags) {
  if (what.mappers) {
    return std::count(what.mappers->begin(), what.mappers->end(), mapper.name) > 0;
  }
  if (mapper.name == BagGraph::kName) return false;  // it changes all maps: only if asked for
  return std::any_of(mapper.input_topics.begin(), mapper.input_topics.end(),
                     [&](const std::string& topic) { return bags.topics.count(topic) > 0; });
}

std::vector<AnyBagMapper> wanted_mappers(const BagRun& what, const Bags& bags) {
  const YAML::Node config = configured(what);
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
  if (mappers.empty()) {
    throw std::runtime_error("no mapper finds a topic of its own in the bags; " + bags.advice);
  }
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

std::vector<std::string> names_of(const BagRun& what) {
  std::vector<std::string> names;
  for (const std::string& bag : what.bags) {
    names.push_back(std::filesystem::path(bag).filename().string());
  }
  return names;
}

std::vector<std::string> names_of(const FileSet& files) {
  std::vector<std::string> names;
  for (const auto& [name, content] : files) names.push_back(name);
  return names;
}

YAML::Node summary_of(const BagRun& what, const std::vector<AnyBagMapper>& mappers) {
  YAML::Node summary;
  summary["portolan"] = PORTOLAN_VERSION;
  summary["bags"] = names_of(what);
  for (const AnyBagMapper& mapper : mappers) summary["mappers"][mapper.name] = mapper.summary();
  return summary;
}

std::string why_empty(const AnyBagMapper& mapper, const Bags& bags) {
  const std::vector<Tally> tallies = mapper.tallies();
  const std::string what = "the map of " + mapper.name + " is empty: " + sentence_of(tallies);
  const bool heard = std::any_of(tallies.begin(), tallies.end(),
                                 [](const Tally& tally) { return tally.received() > 0; });
  if (heard) return what;
  return what + " on " + boost::join(mapper.input_topics, ", ") + " in the bags; " + bags.advice;
}

}  // namespace

void run(const BagRun& what) {
  const Bags bags = open_bags(what.bags, what.start, what.duration);
  std::vector<AnyBagMapper> mappers = wanted_mappers(what, bags);
  std::filesystem::create_directories(what.out);
  play(bags, mappers);
  finish(mappers);
  FileSet files;
  std::vector<ReportedMap> reported;
  for (const AnyBagMapper& mapper : mappers) {
    FileSet made = mapper.files();
    reported.push_back({mapper.name, mapper.legend, sentence_of(mapper.tallies()), names_of(made)});
    std::cerr << mapper.name << ": " << reported.back().used << std::endl;
    files.merge(made);
  }
  files["report.md"] = bag_report(names_of(what), reported);
  YAML::Emitter summary;
  summary << summary_of(what, mappers);
  files["summary.yaml"] = std::string(summary.c_str()) + "\n";
  save_files(what.out, files);
  std::cerr << files.size() << " files in " << what.out << std::endl;
  for (const AnyBagMapper& mapper : mappers) {
    if (!used_anything(mapper.tallies())) {
      throw std::runtime_error(why_empty(mapper, bags));
    }
  }
}

}  // namespace portolan
