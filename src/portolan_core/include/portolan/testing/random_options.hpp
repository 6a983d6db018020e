// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "portolan/options.hpp"

namespace portolan::testing {

/// Fills described fields with random values from their intervals. Open-ended intervals give
/// values up to ten times as far from their end as the default is.
class Randomizer {
 public:
  explicit Randomizer(std::mt19937_64& random) : random_(random) {}

  template <class T>
  void operator()(const char* /*name*/, T& field, const char* /*meaning*/,
                  const Interval& allowed = finite()) {
    fill(field, allowed);
  }
  void require(bool /*holds*/, const char* /*rule*/) {}

 private:
  template <class T>
  void fill(T& field, const Interval& allowed) {
    if constexpr (options_detail::kIsGroup<T>) {
      T::describe(field, *this);
    } else if constexpr (options_detail::kIsList<T>) {
      fill_list(field, allowed);
    } else if constexpr (std::is_same_v<T, bool>) {
      field = below(2) == 1;
    } else if constexpr (std::is_enum_v<T>) {
      field = static_cast<T>(below(options_detail::names_of(field).size()));
    } else if constexpr (options_detail::kIsNumber<T>) {
      field = number(field, allowed);
    } else {
      field = text();
    }
  }

  /// As long as it was, or of any length up to four.
  template <class List>
  void fill_list(List& list, const Interval& allowed) {
    if (below(2) == 1) list.resize(below(5));
    for (std::size_t i = 0; i < list.size(); ++i) {
      typename List::value_type item = list[i];
      fill(item, allowed);
      list[i] = std::move(item);
    }
  }

  template <class T>
  T number(T before, const Interval& allowed) {
    const double low = std::max(allowed.low, static_cast<double>(std::numeric_limits<T>::lowest()));
    const double high = std::min(allowed.high, static_cast<double>(std::numeric_limits<T>::max()));
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const double drawn = real(static_cast<double>(before), allowed);
      const double value = std::is_integral_v<T> ? std::round(drawn) : drawn;
      if (value < low || value > high) continue;
      if (allowed.contains(static_cast<double>(static_cast<T>(value))))
        return static_cast<T>(value);
    }
    return before;
  }

  double real(double before, const Interval& allowed);
  std::string text();
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  std::mt19937_64& random_;
};

inline double Randomizer::real(double before, const Interval& allowed) {
  const bool bounded_below = std::isfinite(allowed.low);
  const bool bounded_above = std::isfinite(allowed.high);
  if (bounded_below && bounded_above) {
    const std::size_t place = below(20);  // the ends are worth a test of their own
    if (place == 0) return allowed.low;
    return place == 1 ? allowed.high : uniform(allowed.low, allowed.high);
  }
  const double end = bounded_below ? allowed.low : bounded_above ? allowed.high : 0.0;
  const double distance = std::abs(before - end);
  const double drawn = (distance > 0.0 ? distance : 1.0) * std::pow(10.0, uniform(-1.0, 1.0));
  const bool upwards = bounded_below || (!bounded_above && below(2) == 1);
  return upwards ? end + drawn : end - drawn;
}

inline std::string Randomizer::text() {
  const std::string letters = "abcXYZ019_/ :#'\"\\-{}[],~\n\t\x01\xc3\xa4";
  std::string value;
  for (std::size_t left = below(8); left > 0; --left) {
    const std::size_t place = below(letters.size() - 1);
    value += place + 2 < letters.size() ? letters.substr(place, 1) : letters.substr(place);
  }
  return value;
}

/// Options without faults, all else at random; the seed decides. Throws std::runtime_error where
/// ten thousand draws break a rule each.
template <class Options>
Options random_options(std::mt19937_64& random) {
  for (int attempt = 0; attempt < 10000; ++attempt) {
    Options options;
    Randomizer randomizer(random);
    Options::describe(options, randomizer);
    if (faults(options).empty()) return options;
  }
  throw std::runtime_error("no random options keep the rules");
}

}  // namespace portolan::testing
