// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/assignments.hpp"

#include <stdexcept>

namespace portolan {

namespace {

constexpr const char* kTopics = "_topics";

YAML::Node value_of(const std::string& word, const std::string& text) {
  try {
    const YAML::Node value = YAML::Load(text);
    return value.IsNull() ? YAML::Node("") : value;
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(word + ": " + error.what());
  }
}

YAML::Node as_list(const YAML::Node& topics) {
  if (topics.IsSequence()) return topics;
  YAML::Node list(YAML::NodeType::Sequence);
  if (!topics.Scalar().empty()) list.push_back(topics);
  return list;
}

/// `name` may lead through groups: laser/max_range.
void set(YAML::Node options, const std::string& name, const YAML::Node& value) {
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) {
    options[name] = value;
  } else {
    set(options[name.substr(0, slash)], name.substr(slash + 1), value);
  }
}

}  // namespace

Assignments::Assignments(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t sign = word.find(":=");
    if (sign == std::string::npos || sign == 0) {
      throw std::invalid_argument(word + ": name:=value is wanted");
    }
    const std::string name = word.substr(0, sign);
    values_[name] = value_of(word, word.substr(sign + 2));
    unknown_.insert(name);
  }
}

YAML::Node Assignments::over(const YAML::Node& told, const std::vector<OptionRow>& options) {
  const bool is_told = told.IsDefined() && !told.IsNull();
  YAML::Node all = is_told ? YAML::Clone(told) : YAML::Node(YAML::NodeType::Map);
  for (const auto& [name, value] : values_) {
    for (const OptionRow& option : options) {
      const bool is_input = option.name == name + kTopics;
      if (option.name != name && !is_input) continue;
      set(all, option.name, is_input ? as_list(value) : value);
      unknown_.erase(name);
    }
  }
  return all;
}

void Assignments::check_all_known() const {
  std::vector<std::string> faults;
  faults.reserve(unknown_.size());
  for (const std::string& name : unknown_) {
    faults.push_back(name + " is neither an option nor an input of any mapper");
  }
  if (!faults.empty()) throw OptionsError(faults);
}

}  // namespace portolan
