// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace portolan::options_detail {

namespace {

template <class T>
bool read_whole(const std::string& text, T& value) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  return (in >> std::noskipws >> value) && in.peek() == std::istringstream::traits_type::eof();
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string with_precision(double value, int digits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(digits) << value;
  return out.str();
}

}  // namespace

bool parse_bool(const std::string& text) {
  const std::string word = lower(text);
  if (word == "true" || word == "yes" || word == "on") return true;
  if (word == "false" || word == "no" || word == "off") return false;
  throw std::invalid_argument("true or false");
}

double parse_double(const std::string& text) {
  const std::string word = lower(text);
  if (word == ".inf" || word == "+.inf" || word == "inf") {
    return std::numeric_limits<double>::infinity();
  }
  if (word == "-.inf" || word == "-inf") return -std::numeric_limits<double>::infinity();
  if (word == ".nan" || word == "nan") return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  if (!read_whole(text, value)) throw std::invalid_argument("a number");
  return value;
}

std::int64_t parse_integer(const std::string& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw std::invalid_argument("a whole number");
  }
  return value;
}

std::size_t parse_name(const std::string& text, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " | ") + name;
  throw std::invalid_argument("one of " + all);
}

std::string format_double(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0.0 ? ".inf" : "-.inf";
  for (int digits = 6; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    std::string text = with_precision(value, digits);
    if (parse_double(text) == value) return text;
  }
  return with_precision(value, std::numeric_limits<double>::max_digits10);
}

std::string format_string(const std::string& value) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '/'; };
  const bool bare = !value.empty() && std::isalpha(static_cast<unsigned char>(value[0])) &&
                    std::all_of(value.begin(), value.end(), plain) && lower(value) != "true" &&
                    lower(value) != "false" && lower(value) != "null" && lower(value) != "yes" &&
                    lower(value) != "no" && lower(value) != "on" && lower(value) != "off";
  if (bare) return value;
  std::string quoted = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace portolan::options_detail
