// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace portolan::sim {

/// A stream of random numbers that is the same on every system for the same seed and name.
/// Whoever draws has a stream of its own, so that one more sensor changes nothing for the others.
class Random {
 public:
  Random(std::uint64_t seed, const std::string& stream);

  /// Evenly spread over [0, 1).
  double uniform();
  /// Evenly spread over [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Normal with mean 0 and deviation 1, by Marsaglia's polar method.
  double normal();
  double normal(double mean, double stddev) { return mean + stddev * normal(); }
  /// True with this probability. Draws even where the answer is certain, so that a changed
  /// probability does not shift the numbers after it.
  bool chance(double probability) { return uniform() < probability; }
  /// How often something happens that happens `mean` times on average (Poisson).
  int count(double mean);
  /// A whole number from 0 to size - 1.
  std::size_t index(std::size_t size);

 private:
  std::mt19937_64 engine_;
  double spare_ = 0.0;  // the second of the pair that normal() makes
  bool has_spare_ = false;
};

}  // namespace portolan::sim
