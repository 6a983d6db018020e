// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace portolan {

/// P(a chi-squared variable of `degrees` > 0 degrees of freedom is below `value`).
double chi_squared_probability(double value, std::size_t degrees);

/// The value below which it lies with `probability`, in (0, 1).
double chi_squared_quantile(double probability, std::size_t degrees);

}  // namespace portolan
