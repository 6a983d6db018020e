// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "portolan/options/check.hpp"

namespace portolan {

namespace options_detail {

/// Fills described fields from a YAML map and remembers which names it was asked for.
class Reader {
 public:
  Reader(const YAML::Node& values, std::string prefix)
      : values_(values), prefix_(std::move(prefix)) {}

  template <class T>
  void operator()(const char* name, T& field, const char* /*meaning*/,
                  const Interval& /*allowed*/ = finite()) {
    known_.insert(name);
    if (values_.IsMap() && values_[name].IsDefined()) read(prefix_ + name, values_[name], field);
  }
  void require(bool /*holds*/, const char* /*rule*/) {}

  /// One fault for each name in the map that no field was called.
  void reject_unknown();

  std::vector<std::string> faults() && { return std::move(faults_); }

 private:
  template <class T>
  void read(const std::string& name, const YAML::Node& value, T& field) {
    if constexpr (kIsGroup<T>) {
      read_group(name, value, field);
    } else if constexpr (kIsList<T>) {
      read_list(name, value, field);
    } else {
      read_scalar(name, value, field);
    }
  }

  template <class T>
  void read_group(const std::string& name, const YAML::Node& value, T& field) {
    if (value.IsNull()) return;  // all its lines are commented out
    if (!value.IsMap()) return fault(name, value, "a map of options");
    Reader inner(value, name + "/");
    T::describe(field, inner);
    inner.reject_unknown();
    for (std::string& found : std::move(inner).faults()) faults_.push_back(std::move(found));
  }

  template <class T>
  void read_list(const std::string& name, const YAML::Node& value, T& field) {
    if (!value.IsSequence()) return fault(name, value, "a list");
    field.assign(value.size(), typename T::value_type{});
    for (std::size_t i = 0; i < value.size(); ++i) {
      typename T::value_type item{};
      read(name + "[" + std::to_string(i) + "]", value[i], item);
      field[i] = std::move(item);
    }
  }

  template <class T>
  void read_scalar(const std::string& name, const YAML::Node& value, T& field) {
    try {
      if (!value.IsScalar()) throw std::invalid_argument(wanted<T>());
      field = parse<T>(value.Scalar());
    } catch (const std::invalid_argument& expected) {
      fault(name, value, expected.what());
    }
  }

  void fault(const std::string& name, const YAML::Node& value, const char* expected);

  const YAML::Node values_;
  std::string prefix_;
  std::set<std::string> known_;
  std::vector<std::string> faults_;
};

}  // namespace options_detail

/// Fills the options from a YAML map; what the map does not name keeps its value. Several structs
/// may share one map, each taking the names that it describes. Throws OptionsError with every
/// fault at once: a wrong type, a value out of its interval, a rule broken, a name that none of
/// the structs knows.
template <class... Options>
void read_options(const YAML::Node& values, Options&... options) {
  if (!values.IsMap() && !values.IsNull()) throw OptionsError({"options must be a map of names"});
  options_detail::Reader reader(values, "");
  (Options::describe(options, reader), ...);
  reader.reject_unknown();
  std::vector<std::string> found = std::move(reader).faults();
  const auto add = [&found](std::vector<std::string> more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  (add(faults(options)), ...);
  if (!found.empty()) throw OptionsError(std::move(found));
}

}  // namespace portolan
