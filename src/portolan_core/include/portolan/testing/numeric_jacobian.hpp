// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace portolan::testing {

/// The derivative of `f` at `x` by central differences, to check a Jacobian written by hand.
/// `f` takes a vector like `x` and gives a vector; row i, column j is d f_i / d x_j. Each element
/// of x is moved by `step` times its size, or by `step` where that is below 1. `difference(a, b)`
/// is a - b, and for results that hold angles the one that wraps them.
template <class Function, class Vector, class Difference>
auto numeric_jacobian(const Function& f, const Vector& x, const Difference& difference,
                      double step = 1e-6) {
  using Input = typename Vector::PlainObject;
  using Output = typename std::decay_t<decltype(f(std::declval<const Input&>()))>::PlainObject;
  const Input& center = x;
  const Output value = f(center);
  Eigen::Matrix<double, Output::RowsAtCompileTime, Input::RowsAtCompileTime> jacobian(
      value.size(), center.size());
  for (Eigen::Index j = 0; j < center.size(); ++j) {
    const double move = step * std::max(1.0, std::abs(center[j]));
    Input ahead = center;
    Input behind = center;
    ahead[j] += move;
    behind[j] -= move;
    const Output change = difference(Output(f(ahead)), Output(f(behind)));
    jacobian.col(j) = change / (ahead[j] - behind[j]);
  }
  return jacobian;
}

template <class Function, class Vector>
auto numeric_jacobian(const Function& f, const Vector& x) {
  return numeric_jacobian(f, x, [](const auto& a, const auto& b) { return (a - b).eval(); });
}

}  // namespace portolan::testing
