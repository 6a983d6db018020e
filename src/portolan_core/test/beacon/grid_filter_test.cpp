// SPDX-License-Identifier: BSD-3-Clause
#include "beacon/grid_filter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "beacon/scenario.hpp"
#include "portolan/beacon/beacon_mapper.hpp"

namespace portolan {
namespace {

using beacon_test::Dice;
using beacon_test::GridFilter;

constexpr std::array<int, 4> kCompared = {1, 2, 5, 20};  // after so many ranges
using Variations = std::array<double, kCompared.size()>;

/// A beacon, what it is heard with, and the way past it.
struct Drive {
  Eigen::Vector3d beacon;
  double stddev;  // of ranges [m]
  Pose (*antenna)(int step);
};

const Drive kInThePlane = {
    {4.0, 5.0, 0.0}, 0.2, [](int step) { return beacon_test::figure_11(step, 12); }};
const Drive kInSpace = {{0.9, 1.0, 0.6}, 0.3, [](int step) {
                          return beacon_test::antenna_at(1.5 * std::sin(0.3 * step),
                                                         1.5 * std::sin(0.5 * step),
                                                         1.5 * std::sin(0.2 * step));
                        }};

BeaconOptions options_of(BeaconSpace space, BeaconParametrization parametrization) {
  BeaconOptions options = beacon_test::calibrated();
  options.space = space;
  options.parametrization = parametrization;
  options.outliers.share = 1e-9;  // Eq. 36 alone
  return options;
}

// How far the mapper's posterior is from the grid's.
template <int Dimensions>
Variations variations(const BeaconOptions& options, const Drive& drive, std::uint32_t seed,
                      GridFilter<Dimensions> exact) {
  BeaconMapper mapper(options);
  Dice dice(seed);
  Variations found{};
  std::size_t compared = 0;
  for (int step = 0; compared < kCompared.size(); ++step) {
    const Pose pose = drive.antenna(step);
    const double range = (drive.beacon - pose.translation()).norm() + dice.normal(drive.stddev);
    mapper.insert(beacon_test::one_range(0, range, drive.stddev), pose);
    exact.update(pose.translation().head<Dimensions>(), range, drive.stddev);
    if (step + 1 != kCompared[compared]) continue;
    found[compared++] = exact.total_variation(mapper.estimates()[0].modes);
  }
  return found;
}

template <int Dimensions>
void expect_match(const BeaconOptions& options, const Drive& drive,
                  const GridFilter<Dimensions>& empty, const Variations& bounds) {
  for (std::uint32_t seed = 0; seed < 2; ++seed) {
    const Variations found = variations(options, drive, seed, empty);
    for (std::size_t i = 0; i < kCompared.size(); ++i) {
      EXPECT_LT(found[i], bounds[i]) << "seed " << seed << ", ranges " << kCompared[i];
    }
  }
}

TEST(GridFilter, InThePlaneIsMatchedByAMixture) {
  const BeaconOptions options =
      options_of(BeaconSpace::planar, BeaconParametrization::cartesian_mixture);
  expect_match(options, kInThePlane, GridFilter<2>(8.0, 0.05), {0.01, 0.04, 0.12, 0.2});
}

TEST(GridFilter, InThePlaneIsMatchedInPolarCoordinates) {
  const BeaconOptions options = options_of(BeaconSpace::planar, BeaconParametrization::polar);
  expect_match(options, kInThePlane, GridFilter<2>(8.0, 0.05), {0.08, 0.1, 0.12, 0.15});
}

TEST(GridFilter, InSpaceIsMatchedByAMixture) {
  const BeaconOptions options =
      options_of(BeaconSpace::spatial, BeaconParametrization::cartesian_mixture);
  expect_match(options, kInSpace, GridFilter<3>(3.3, 0.15), {0.04, 0.08, 0.2, 0.25});
}

}  // namespace
}  // namespace portolan
