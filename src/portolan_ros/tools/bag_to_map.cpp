// SPDX-License-Identifier: BSD-3-Clause
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/program_options.hpp>
#include <iostream>

#include "portolan_ros/bag/assignments.hpp"
#include "portolan_ros/bag/bag_run.hpp"
#include "portolan_ros/report.hpp"

namespace {

namespace po = boost::program_options;

constexpr const char* kWantsBag = "name a bag; --help says more";

po::options_description described() {
  po::options_description options(
      "usage: bag_to_map [options] [name:=value...] BAG...\n"
      "Draws maps of recordings, with pictures. Your topics and frames, and any other parameter,\n"
      "are said as to the nodes: scan:=/front/scan odom_frame:=robot/odom resolution:=0.1\n"
      "options");
  auto add = options.add_options();
  add("help,h", "say this");
  add("config", po::value<std::vector<std::string>>()->composing(),
      "YAML file with options, each mapper's under its name; may be given several times");
  add("out", po::value<std::string>()->default_value("maps"), "folder for the maps");
  add("start", po::value<double>()->default_value(0.0), "begin so many seconds into the bags");
  add("duration", po::value<double>(), "end after so many seconds");
  add("mappers", po::value<std::string>(),
      "which maps, separated by commas; default: all for which the bags have a topic");
  add("bag", po::value<std::vector<std::string>>()->composing(), "bags to map");
  return options;
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> names;
  boost::split(names, list, boost::is_any_of(","), boost::token_compress_on);
  return names;
}

portolan::BagRun what_to_run(const po::variables_map& arguments) {
  portolan::BagRun what;
  if (arguments.count("bag") == 0) throw std::invalid_argument(kWantsBag);
  for (const std::string& word : arguments["bag"].as<std::vector<std::string>>()) {
    (portolan::Assignments::is_one(word) ? what.assignments : what.bags).push_back(word);
  }
  if (what.bags.empty()) throw std::invalid_argument(kWantsBag);
  if (arguments.count("config") > 0) {
    what.configs = arguments["config"].as<std::vector<std::string>>();
  }
  what.out = arguments["out"].as<std::string>();
  what.start = arguments["start"].as<double>();
  if (arguments.count("duration") > 0) what.duration = arguments["duration"].as<double>();
  if (arguments.count("mappers") > 0) what.mappers = split(arguments["mappers"].as<std::string>());
  return what;
}

}  // namespace

int main(int argc, char** argv) try {
  const po::options_description options = described();
  po::positional_options_description positional;
  positional.add("bag", -1);
  po::variables_map arguments;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(),
            arguments);
  if (arguments.count("help") > 0) {
    std::cout << options;
    return 0;
  }
  portolan::run(what_to_run(arguments));
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
