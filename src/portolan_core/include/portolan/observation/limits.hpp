// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace portolan {

/// What no sensor can mean. Filters square these numbers and take differences of the squares: one
/// reading beyond would leave a map that is no number, or a search through all the world.
constexpr double kFurthestReading = 1e6;  ///< [m]
constexpr double kFurthestPixel = 1e6;    ///< from the upper left one [pixel]
constexpr double kWidestDistance = 1e3;   ///< deviation of a distance or place [m]
constexpr double kWidestAngle = 3.15;     ///< deviation of an angle; more is any direction [rad]

/// Better than this no deviation is believed, whatever is stated, and nothing told apart.
constexpr double kSharpestDistance = 1e-4;  ///< [m]
constexpr double kSharpestAngle = 1e-6;     ///< [rad]

/// True where it is a deviation, in the same units as `widest`; 0 says that it is unknown.
constexpr bool is_deviation(double stddev, double widest) {
  return stddev >= 0.0 && stddev <= widest;  // false of what is not a number
}

}  // namespace portolan
