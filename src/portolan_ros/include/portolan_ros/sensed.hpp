// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
};

}  // namespace portolan
