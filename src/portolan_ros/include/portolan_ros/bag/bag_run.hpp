// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/message_instance.h>
#include <yaml-cpp/yaml.h>

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "portolan/map_file.hpp"
#include "portolan_ros/bag/bag_mapper.hpp"

namespace portolan {

/// Any kind of map over a bag, with its type forgotten.
struct AnyBagMapper {
  std::string name;
  std::string legend;  ///< of its pictures
  std::set<std::string> topics;
  std::set<std::string> input_topics;
  std::function<void(const rosbag::MessageInstance&)> take;
  std::function<void(const Correction&)> correct;
  std::function<void()> finish;
  std::function<FileSet()> files;
  std::function<YAML::Node()> summary;
  std::function<std::vector<Tally>()> tallies;
  std::function<Correction()> correction = {};  ///< what it knows of the drift; most know nothing
};

/// The mapper of this kind with the options under its name in `config`. Throws OptionsError.
template <class Kind>
AnyBagMapper any_bag_mapper(const YAML::Node& config) {
  MapperNodeOptions<Kind> options;
  if (config[Kind::kName]) read_options(config[Kind::kName], options);
  const auto mapper = std::make_shared<BagMapper<Kind>>(options);
  return {Kind::kName,
          Kind::kLegend,
          mapper->topics(),
          mapper->input_topics(),
          [mapper](const rosbag::MessageInstance& message) { mapper->take(message); },
          [mapper](const Correction& correction) { mapper->correct(correction); },
          [mapper] { mapper->finish(); },
          [mapper] { return mapper->files(); },
          [mapper] { return mapper->summary(); },
          [mapper] { return mapper->tallies(); }};
}

/// What to do with which bags.
struct BagRun {
  std::vector<std::string> bags;
  std::vector<std::string> configs;                 ///< YAML files, options under mappers' names
  std::vector<std::string> assignments;             ///< name:=value, for each mapper that knows it
  std::string out = "maps";                         ///< folder, made where it is missing
  double start = 0.0;                               ///< [s] after the begin of the bags
  std::optional<double> duration;                   ///< [s]; none: to their end
  std::optional<std::vector<std::string>> mappers;  ///< none: all that find a topic
};

/// Draws the maps and writes them, with pictures, report.md and summary.yaml, into the folder.
/// Progress and results go to stderr. Throws std::exception where a bag, an option or the folder is
/// at fault, and where a map stayed empty: then with the reason.
void run(const BagRun& what);

}  // namespace portolan
