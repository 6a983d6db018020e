// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/range_echo.hpp"

#include <cmath>

namespace portolan {

bool is_usable(const RangeEcho& echo) {
  return echo.aperture > 0.0 && echo.aperture <= 2.0 * M_PI && echo.range_min >= 0.0 &&
         echo.range_min <= echo.range_max && std::isfinite(echo.range_max);
}

}  // namespace portolan
