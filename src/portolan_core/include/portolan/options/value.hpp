// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace portolan::options_detail {

/// Text to value; each throws std::invalid_argument that ends the sentence "must be …".
bool parse_bool(const std::string& text);
double parse_double(const std::string& text);
std::int64_t parse_integer(const std::string& text);
/// The place of `text` in `names`.
std::size_t parse_name(const std::string& text, const std::vector<std::string>& names);

/// Value to the shortest text that reads back as the same value.
std::string format_double(double value);
/// In quotes, on one line, where YAML could read the bare text as anything but a string.
std::string format_string(const std::string& value);

template <class Enum>
std::vector<std::string> names_of(Enum value) {
  const auto names = enum_names(value);
  return {names.begin(), names.end()};
}

template <class T>
T parse(const std::string& text) {
  if constexpr (std::is_same_v<T, bool>) {
    return parse_bool(text);
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(parse_name(text, names_of(T{})));
  } else if constexpr (std::is_integral_v<T>) {
    const std::int64_t value = parse_integer(text);
    const auto narrow = static_cast<T>(value);
    if (static_cast<std::int64_t>(narrow) != value || (std::is_unsigned_v<T> && value < 0)) {
      throw std::invalid_argument("a smaller whole number");
    }
    return narrow;
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(parse_double(text));
  } else {
    static_assert(std::is_same_v<T, std::string>, "no option can have this type");
    return text;
  }
}

template <class T>
std::string format(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_enum_v<T>) {
    return names_of(value).at(static_cast<std::size_t>(value));
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return format_double(value);
  } else {
    return format_string(value);
  }
}

/// What a value of this type is called: "number", "whole number", "true or false", "text", or the
/// names joined by " | ".
template <class T>
std::string type_words() {
  if constexpr (std::is_same_v<T, bool>) {
    return "true | false";
  } else if constexpr (std::is_enum_v<T>) {
    std::string words;
    for (const std::string& name : names_of(T{})) words += (words.empty() ? "" : " | ") + name;
    return words;
  } else if constexpr (std::is_integral_v<T>) {
    return "whole number";
  } else if constexpr (std::is_floating_point_v<T>) {
    return "number";
  } else {
    return "text";
  }
}

/// The same, to end the sentence "must be …".
template <class T>
std::string wanted() {
  if constexpr (std::is_same_v<T, std::string>) {
    return "text";
  } else if constexpr (std::is_same_v<T, bool>) {
    return "true or false";
  } else {
    return (std::is_enum_v<T> ? "one of " : "a ") + type_words<T>();
  }
}

}  // namespace portolan::options_detail
