// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/chi_squared.hpp"

#include <cmath>

namespace portolan {

double chi_squared_probability(double value, std::size_t degrees) {
  if (!(value > 0.0)) return 0.0;
  // The series of the incomplete gamma function; its terms rise up to n = x and then fall.
  const double a = 0.5 * static_cast<double>(degrees);
  const double x = 0.5 * value;
  double term = 1.0;
  double sum = 1.0;
  for (int n = 1; term > 1e-16 * sum; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  const double log_first = a * std::log(x) - x - std::lgamma(a + 1.0);
  return std::fmin(std::exp(log_first + std::log(sum)), 1.0);
}

double chi_squared_quantile(double probability, std::size_t degrees) {
  double low = 0.0;
  double high = static_cast<double>(degrees) + 10.0;
  while (chi_squared_probability(high, degrees) < probability && high < 1e6) high *= 2.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (chi_squared_probability(middle, degrees) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace portolan
