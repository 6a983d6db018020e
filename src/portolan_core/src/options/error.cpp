// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/error.hpp"

#include <utility>

namespace portolan {

namespace {

std::string joined(const std::vector<std::string>& faults) {
  std::string all = "bad options:";
  for (const std::string& fault : faults) all += "\n  " + fault;
  return all;
}

}  // namespace

OptionsError::OptionsError(std::vector<std::string> faults)
    : std::invalid_argument(joined(faults)), faults_(std::move(faults)) {}

}  // namespace portolan
