// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/random.hpp"

#include <cmath>

namespace portolan::sim {

namespace {

/// Spreads close seeds far apart (the finalizer of splitmix64).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// FNV-1a.
std::uint64_t hashed(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

Random::Random(std::uint64_t seed, const std::string& stream)
    : engine_(mixed(mixed(seed) ^ hashed(stream))) {}

double Random::uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

double Random::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double u = 0.0;
  double v = 0.0;
  double s = 0.0;
  do {
    u = uniform(-1.0, 1.0);
    v = uniform(-1.0, 1.0);
    s = u * u + v * v;
  } while (s >= 1.0 || s == 0.0);
  const double factor = std::sqrt(-2.0 * std::log(s) / s);
  spare_ = v * factor;
  has_spare_ = true;
  return u * factor;
}

int Random::count(double mean) {
  const double limit = std::exp(-mean);
  int happened = 0;
  for (double product = uniform(); product > limit; product *= uniform()) ++happened;
  return happened;
}

std::size_t Random::index(std::size_t size) {
  return static_cast<std::size_t>(uniform() * static_cast<double>(size));
}

}  // namespace portolan::sim
