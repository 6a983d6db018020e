// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "portolan/options.hpp"

namespace portolan {

/// Options from the command line, `name:=value`: each holds for every mapper that knows the name.
class Assignments {
 public:
  /// True where the word is one of them and not, say, the name of a bag.
  static bool is_one(const std::string& word) { return word.find(":=") != std::string::npos; }

  /// Throws std::invalid_argument unless each word is `name:=value`, with a value that is YAML.
  explicit Assignments(const std::vector<std::string>& words);

  /// What a mapper with these options is told, and over it what is assigned to them. An input may
  /// be named as in launch files: `scan:=/front` is `scan_topics:=[/front]`.
  YAML::Node over(const YAML::Node& told, const std::vector<OptionRow>& options);

  /// Throws OptionsError where no mapper so far has known a name.
  void check_all_known() const;

 private:
  std::map<std::string, YAML::Node> values_;
  std::set<std::string> unknown_;
};

}  // namespace portolan
