// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <set>
#include <sstream>

namespace portolan::options_detail {

namespace {

template <class T>
bool read_whole(const std::string& text, T& value) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  return (in >> std::noskipws >> value) && in.peek() == std::istringstream::traits_type::eof();
}

// Of ASCII alone: what a character is must not depend on the locale of the process.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool is_word_of_yaml(const std::string& word) {
  static const std::set<std::string> kWords = {"true", "false", "yes", "no",  "on",
                                               "off",  "y",     "n",   "null"};
  return kWords.count(lower(word)) == 1;
}

std::string quoted(char c) {
  if (c == '"' || c == '\\') return {'\\', c};
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte != 0x7f) return {c};
  constexpr const char* kDigits = "0123456789abcdef";
  return {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
}

/// With a point before an exponent: YAML 1.1, which rosparam speaks, takes 1e-06 for a text.
std::string with_point(std::string number) {
  const std::size_t exponent = number.find('e');
  if (exponent == std::string::npos || number.find('.') != std::string::npos) return number;
  return number.insert(exponent, ".0");
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
    if (parse_double(text) == value) return with_point(text);
  }
  return with_point(with_precision(value, std::numeric_limits<double>::max_digits10));
}

std::string format_string(const std::string& value) {
  const auto is_plain = [](char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '/'; };
  const bool bare = !value.empty() && is_letter(value.front()) &&
                    std::all_of(value.begin(), value.end(), is_plain) && !is_word_of_yaml(value);
  if (bare) return value;
  std::string all = "\"";
  for (const char c : value) all += quoted(c);
  return all + "\"";
}

}  // namespace portolan::options_detail
