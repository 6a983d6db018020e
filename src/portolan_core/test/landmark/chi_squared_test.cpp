// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/chi_squared.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace portolan {
namespace {

TEST(ChiSquared, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(chi_squared_quantile(0.95, 1), 3.841459, 1e-5);
  EXPECT_NEAR(chi_squared_quantile(0.99, 2), 9.210340, 1e-5);
  EXPECT_NEAR(chi_squared_quantile(0.999, 3), 16.266236, 1e-5);
  EXPECT_NEAR(chi_squared_quantile(0.05, 100), 77.929465, 1e-4);
}

TEST(ChiSquared, ProbabilityOfTwoDegreesIsExponential) {
  for (const double value : {0.1, 1.0, 5.0, 40.0})
    EXPECT_NEAR(chi_squared_probability(value, 2), 1.0 - std::exp(-0.5 * value), 1e-12);
  EXPECT_EQ(chi_squared_probability(0.0, 3), 0.0);
  EXPECT_EQ(chi_squared_probability(-1.0, 3), 0.0);
}

}  // namespace
}  // namespace portolan
