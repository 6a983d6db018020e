// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

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

}  // namespace portolan
