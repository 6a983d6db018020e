// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "options/example_options.hpp"

namespace portolan {
namespace {

using Faults = std::vector<std::string>;

TEST(Check, FindsNoFaultInTheDefaults) {
  const ExampleOptions options;
  EXPECT_EQ(faults(options), Faults{});
  EXPECT_EQ(&checked(options), &options);
}

TEST(Check, NamesEveryFaultWithValueAndInterval) {
  ExampleOptions options;
  options.resolution = -1.0;
  options.limit = -2;
  options.offset = std::numeric_limits<double>::quiet_NaN();
  options.laser.queue = 0;
  options.laser.beam = {0.51, 0.1};
  options.layers.resize(2);
  options.layers[1].beam.p_hit = 1.0;
  options.origin = {1.0, std::numeric_limits<double>::infinity()};
  const Faults expected = {"resolution = -1 must be above 0",
                           "offset = .nan must be finite",
                           "limit = -2 must be at least -1",
                           "laser/queue = 0 must be in [1, 100]",
                           "laser/beam/p_hit and p_miss must be above 0.7 together",
                           "origin[1] = .inf must be finite",
                           "layers[1]/beam/p_hit = 1 must be in (0.5, 1)",
                           "origin must have three numbers"};
  EXPECT_EQ(faults(options), expected);
}

TEST(Check, ThrowsEveryFaultAtOnceOneALine) {
  ExampleOptions options;
  options.resolution = 2.0;
  options.weight = 1.5F;
  try {
    checked(options);
    FAIL();
  } catch (const OptionsError& error) {
    EXPECT_EQ(error.faults(), faults(options));
    EXPECT_STREQ(error.what(),
                 "bad options:\n  weight = 1.5 must be in [0, 1]\n"
                 "  resolution must be below a metre");
  }
}

}  // namespace
}  // namespace portolan
