// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "portolan/options/error.hpp"
#include "portolan/options/interval.hpp"
#include "portolan/options/traits.hpp"
#include "portolan/options/value.hpp"

namespace portolan {

namespace options_detail {

/// Collects a sentence for each value that its interval does not contain.
class Checker {
 public:
  explicit Checker(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  template <class T>
  void operator()(const char* name, const T& field, const char* /*meaning*/,
                  const Interval& allowed = finite()) {
    check(prefix_ + name, field, allowed);
  }

  void require(bool holds, const char* rule) {
    if (!holds) faults_.push_back(prefix_ + rule);
  }

  std::vector<std::string> faults() && { return std::move(faults_); }

 private:
  template <class T>
  void check(const std::string& name, const T& field, const Interval& allowed) {
    if constexpr (kIsGroup<T>) {
      Checker inner(name + "/");
      T::describe(field, inner);
      for (std::string& fault : std::move(inner).faults()) faults_.push_back(std::move(fault));
    } else if constexpr (kIsList<T>) {
      for (std::size_t i = 0; i < field.size(); ++i) {
        check<typename T::value_type>(name + "[" + std::to_string(i) + "]", field[i], allowed);
      }
    } else if constexpr (kIsNumber<T>) {
      if (!allowed.contains(static_cast<double>(field))) {
        faults_.push_back(name + " = " + format(field) + " must be " + allowed.words());
      }
    }
  }

  std::string prefix_;
  std::vector<std::string> faults_;
};

}  // namespace options_detail

/// A sentence for each fault of these options; empty where they are good.
template <class Options>
std::vector<std::string> faults(const Options& options) {
  options_detail::Checker checker;
  Options::describe(options, checker);
  return std::move(checker).faults();
}

/// The options themselves, where they are good. Throws OptionsError with every fault at once.
template <class Options>
const Options& checked(const Options& options) {
  std::vector<std::string> found = faults(options);
  if (!found.empty()) throw OptionsError(std::move(found));
  return options;
}

}  // namespace portolan
