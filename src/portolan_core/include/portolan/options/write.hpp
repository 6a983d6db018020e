// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "portolan/options/interval.hpp"
#include "portolan/options/traits.hpp"
#include "portolan/options/value.hpp"

namespace portolan {

/// One option as documentation shows it.
struct OptionRow {
  std::string name;     ///< with the names of its groups before it: "laser/p_hit"
  std::string type;     ///< "number", "true | false", or the names to choose from
  std::string value;    ///< as YAML
  std::string allowed;  ///< the interval in words; empty where any value will do
  std::string meaning;  ///< with the unit in brackets
};

namespace options_detail {

/// Lists described fields in the order of their description.
class Lister {
 public:
  explicit Lister(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  template <class T>
  void operator()(const char* name, const T& field, const char* meaning,
                  const Interval& allowed = finite()) {
    if constexpr (kIsGroup<T>) {
      Lister inner(prefix_ + name + "/");
      T::describe(field, inner);
      for (OptionRow& row : std::move(inner).rows()) rows_.push_back(std::move(row));
    } else {
      rows_.push_back({prefix_ + name, type(field), text(field), words<T>(allowed), meaning});
    }
  }
  void require(bool /*holds*/, const char* /*rule*/) {}

  std::vector<OptionRow> rows() && { return std::move(rows_); }

 private:
  template <class T>
  static std::string type(const T& /*field*/) {
    if constexpr (kIsList<T>) {
      if constexpr (kIsGroup<typename T::value_type>) {
        return "list of groups";
      } else {
        return "list of " + type_words<typename T::value_type>();
      }
    } else {
      return type_words<T>();
    }
  }

  template <class T>
  static std::string text(const T& field) {
    if constexpr (kIsGroup<T>) {
      FlowWriter inner;
      T::describe(field, inner);
      return "{" + inner.all + "}";
    } else if constexpr (kIsList<T>) {
      std::string all;
      for (const auto& item : field) {
        all += (all.empty() ? "" : ", ") + text<typename T::value_type>(item);
      }
      return "[" + all + "]";
    } else {
      return format<T>(field);
    }
  }

  template <class T>
  static std::string words(const Interval& allowed) {
    const bool any = allowed.low == finite().low && allowed.high == finite().high;
    return any ? std::string{} : allowed.words();
  }

  /// Writes a group that stands in a list: "{x: 1, y: 2}".
  struct FlowWriter {
    template <class T>
    void operator()(const char* name, const T& field, const char* /*meaning*/,
                    const Interval& /*allowed*/ = finite()) {
      all += (all.empty() ? "" : ", ") + std::string(name) + ": " + text(field);
    }
    void require(bool /*holds*/, const char* /*rule*/) {}

    std::string all;
  };

  std::string prefix_;
  std::vector<OptionRow> rows_;
};

}  // namespace options_detail

/// Every option, groups opened, in the order of their description.
template <class... Options>
std::vector<OptionRow> option_rows(const Options&... options) {
  options_detail::Lister lister;
  (Options::describe(options, lister), ...);
  return std::move(lister).rows();
}

/// The rows as commented YAML that `read_options` reads back to the same values.
std::string to_yaml(const std::vector<OptionRow>& rows);

/// The rows as a Markdown table.
std::string to_markdown(const std::vector<OptionRow>& rows);

}  // namespace portolan
