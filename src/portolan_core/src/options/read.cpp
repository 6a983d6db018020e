// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/read.hpp"

namespace portolan::options_detail {

namespace {

std::string shown(const YAML::Node& value) {
  YAML::Emitter out;
  out << YAML::Flow << value;
  return out.c_str();
}

}  // namespace

void Reader::reject_unknown() {
  if (!values_.IsMap()) return;
  for (const auto& entry : values_) {
    const std::string& name = entry.first.Scalar();
    if (known_.count(name) == 0) faults_.push_back(prefix_ + name + " is no option here");
  }
}

void Reader::fault(const std::string& name, const YAML::Node& value, const char* expected) {
  faults_.push_back(name + " = " + shown(value) + " must be " + expected);
}

}  // namespace portolan::options_detail
