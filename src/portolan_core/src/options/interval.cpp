// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/interval.hpp"

#include <cmath>

#include "portolan/options/value.hpp"

namespace portolan {

using options_detail::format_double;

bool Interval::contains(double value) const {
  const bool above_low = open_low ? value > low : value >= low;
  const bool below_high = open_high ? value < high : value <= high;
  return above_low && below_high;
}

std::string Interval::words() const {
  const bool bounded_below = std::isfinite(low);
  const bool bounded_above = std::isfinite(high);
  if (bounded_below && bounded_above) {
    return std::string("in ") + (open_low ? "(" : "[") + format_double(low) + ", " +
           format_double(high) + (open_high ? ")" : "]");
  }
  if (bounded_below) return (open_low ? "above " : "at least ") + format_double(low);
  if (bounded_above) return (open_high ? "below " : "at most ") + format_double(high);
  return "finite";
}

}  // namespace portolan
