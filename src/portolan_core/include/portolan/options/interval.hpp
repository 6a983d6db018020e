// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

namespace portolan {

/// The values that a numeric option may take; NaN never lies in an interval.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open_low = true;   ///< `low` itself is not allowed
  bool open_high = true;  ///< `high` itself is not allowed

  bool contains(double value) const;

  /// In words, to end the sentence "must be …": "above 0", "in (0.5, 1)".
  std::string words() const;
};

/// Any finite number.
inline Interval finite() { return {}; }
/// low < value < infinity.
inline Interval above(double low) { return {low, finite().high, true, true}; }
/// low <= value < infinity.
inline Interval at_least(double low) { return {low, finite().high, false, true}; }
/// low < value < high.
inline Interval between(double low, double high) { return {low, high, true, true}; }
/// low <= value <= high.
inline Interval within(double low, double high) { return {low, high, false, false}; }
/// low < value <= high.
inline Interval above_to(double low, double high) { return {low, high, true, false}; }

}  // namespace portolan
