// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "graph/dense_product.hpp"

namespace portolan::dense {

// The first row from `row` on where vectors begin, at most `rows`.
template <class Vector>
constexpr Index aligned_row(Index row, Index rows) {
  return std::min((row + kWidth<Vector> - 1) / kWidth<Vector> * kWidth<Vector>, rows);
}

// Of the entries of a vector, in pairs first.
template <class Vector>
PORTOLAN_INLINE double total(const Vector& v) {
  constexpr Index kHalf = kWidth<Vector> / 2;
  double sum[kHalf];
  for (Index k = 0; k < kHalf; ++k) sum[k] = v[k] + v[k + kHalf];
  double all = sum[0];
  for (Index k = 1; k < kHalf; ++k) all += sum[k];
  return all;
}

// x = L^-1 x for n columns, whose diagonal is at the top of l and x, and x -= L x below.
template <class Vector, int n>
PORTOLAN_INLINE void forward_columns(const double* l, Index ld, Index first, Index rows,
                                     double* x) {
  double solved[n];
  for (int j = 0; j < n; ++j) {
    double sum = x[first + j];
    for (int k = 0; k < j; ++k) sum -= l[first + j + k * ld] * solved[k];
    solved[j] = sum * l[first + j + j * ld];
  }
  std::memcpy(x + first, solved, sizeof solved);
  Index i = first + n;
  for (const Index begin = aligned_row<Vector>(i, rows); i < begin; ++i) {
    for (int j = 0; j < n; ++j) x[i] -= l[i + j * ld] * solved[j];
  }
  for (; i < rows; i += kWidth<Vector>) {
    Vector sum;
    load(sum, x + i);
    for (int j = 0; j < n; ++j) {
      Vector column;
      load(column, l + i + j * ld);
      sum -= column * solved[j];
    }
    store(sum, x + i);
  }
}

// x -= L^T x of the rows below n columns, then x = L^-T x for these.
template <class Vector, int n>
PORTOLAN_INLINE void backward_columns(const double* l, Index ld, Index first, Index rows,
                                      double* x) {
  double sum[n];
  std::memcpy(sum, x + first, sizeof sum);
  Index i = first + n;
  for (const Index begin = aligned_row<Vector>(i, rows); i < begin; ++i) {
    for (int j = 0; j < n; ++j) sum[j] -= l[i + j * ld] * x[i];
  }
  Vector sums[n] = {};
  for (; i < rows; i += kWidth<Vector>) {
    Vector some;
    load(some, x + i);
    for (int j = 0; j < n; ++j) {
      Vector column;
      load(column, l + i + j * ld);
      sums[j] += column * some;
    }
  }
  for (int j = n - 1; j >= 0; --j) {
    sum[j] -= total(sums[j]);
    for (int k = j + 1; k < n; ++k) sum[j] -= l[first + k + j * ld] * sum[k];
    sum[j] *= l[first + j + j * ld];
  }
  std::memcpy(x + first, sum, sizeof sum);
}

constexpr int kSolved = 3;  // columns at once

template <class Vector>
PORTOLAN_INLINE void solve_forward(const double* l, Index ld, Index columns, double* x) {
  Index j = 0;
  for (; j + kSolved <= columns; j += kSolved) {
    forward_columns<Vector, kSolved>(l + j * ld, ld, j, ld, x);
  }
  for (; j < columns; ++j) forward_columns<Vector, 1>(l + j * ld, ld, j, ld, x);
}

template <class Vector>
PORTOLAN_INLINE void solve_backward(const double* l, Index ld, Index columns, double* x) {
  Index j = columns;
  for (; j % kSolved != 0; --j) backward_columns<Vector, 1>(l + (j - 1) * ld, ld, j - 1, ld, x);
  for (; j > 0; j -= kSolved) {
    backward_columns<Vector, kSolved>(l + (j - kSolved) * ld, ld, j - kSolved, ld, x);
  }
}

}  // namespace portolan::dense
