// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/range_noise.hpp"

#include <limits>

namespace portolan::sim {

double RangeNoise::measure(double range, Random& random) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const bool dropped = random.chance(dropout);
  const bool wild = random.chance(outliers);
  const double any = random.uniform(range_min, range_max);
  const double error = random.normal();
  if (dropped) return kInfinity;
  if (wild) return any;
  if (range >= range_max) return kInfinity;
  const double measured = range + error * stddev(range);
  if (measured < range_min) return -kInfinity;
  return measured < range_max ? measured : kInfinity;
}

}  // namespace portolan::sim
