// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace portolan {

/// What is wrong with a set of options: every fault at once, one a line, each naming the option,
/// its value and what is allowed.
class OptionsError : public std::invalid_argument {
 public:
  explicit OptionsError(std::vector<std::string> faults);

  const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::vector<std::string> faults_;
};

}  // namespace portolan
