// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "portolan/time.hpp"

namespace portolan {

/// What a sensor message says, before anybody knows where the sensor was.
template <class Observation>
struct Sensed {
  std::string frame;  ///< of the sensor
  Time first;         ///< when the measurement began
  Time last;          ///< when it ended; equal to `first` for all but slow sweeps
  Observation z;
  /// Which part of what the sensor says at that moment it is: a driver may send one message for
  /// each beacon, all with one stamp. Equal for messages that repeat each other.
  std::uint64_t part = 0;
};

/// The same `part` for messages about the same things, by their ids (FNV-1a).
template <class Thing>
std::uint64_t part_about(const std::vector<Thing>& things) {
  std::uint64_t hash = 14695981039346656037U;
  for (const Thing& thing : things) {
    hash = (hash ^ static_cast<std::uint32_t>(thing.id)) * 1099511628211U;
  }
  return hash;
}

}  // namespace portolan
