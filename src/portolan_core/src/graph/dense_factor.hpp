// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "graph/dense_product.hpp"

namespace portolan::dense {

// Cholesky factor of a small block, with the inverses of what stands on its diagonal instead. Roots
// come last, where no pivot waits for one.
template <int n>
PORTOLAN_INLINE bool factor_corner(double (&l)[n][n]) {
  for (int j = 0; j < n; ++j) {
    if (!(l[j][j] > 0.0)) return false;
    const double inverse = 1.0 / l[j][j];
    for (int k = j + 1; k < n; ++k) {
      const double share = l[j][k] * inverse;
      for (int i = k; i < n; ++i) l[k][i] -= l[j][i] * share;
    }
  }
  for (int j = 0; j < n; ++j) {
    l[j][j] = 1.0 / std::sqrt(l[j][j]);
    for (int i = j + 1; i < n; ++i) l[j][i] *= l[j][j];
  }
  return true;
}

// Rows of A = A L^-T.
template <class Vector, int n>
PORTOLAN_INLINE void divide_rows(double* a, Index ld, Index rows, const double (&l)[n][n]) {
  for (Index i = 0; i < rows; i += kWidth<Vector>) {
    Vector x[n];
    for (int j = 0; j < n; ++j) load(x[j], a + i + j * ld);
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < j; ++k) x[j] -= x[k] * l[k][j];
      x[j] *= l[j][j];
    }
    for (int j = 0; j < n; ++j) store(x[j], a + i + j * ld);
  }
}

// Factors n columns that begin at `first`, given that those before are subtracted already. The
// rows of the corner are divided too where they share a vector with others, and then put right.
template <class Vector, int n>
PORTOLAN_INLINE bool factor_columns(double* a, Index ld, Index first) {
  double* corner = a + first + first * ld;
  double l[n][n];
  for (int j = 0; j < n; ++j) std::memcpy(l[j], corner + j * ld, sizeof l[j]);
  if (!factor_corner<n>(l)) return false;
  const Index top = (first + n) / kWidth<Vector> * kWidth<Vector>;
  divide_rows<Vector, n>(a + top + first * ld, ld, ld - top, l);
  for (int j = 0; j < n; ++j) {
    std::memcpy(corner + j + j * ld, &l[j][j], static_cast<std::size_t>(n - j) * sizeof(double));
  }
  return true;
}

template <class Vector>
PORTOLAN_INLINE bool factor_some(Index columns, double* a, Index ld, Index first) {
  switch (columns) {
    case 1:
      return factor_columns<Vector, 1>(a, ld, first);
    case 2:
      return factor_columns<Vector, 2>(a, ld, first);
    case 3:
      return factor_columns<Vector, 3>(a, ld, first);
    case 4:
      return factor_columns<Vector, 4>(a, ld, first);
    case 5:
      return factor_columns<Vector, 5>(a, ld, first);
    default:
      return factor_columns<Vector, 6>(a, ld, first);
  }
}

// Left-looking within kDepth columns, right-looking between them.
template <class Vector>
PORTOLAN_INLINE bool factor_panel(double* a, Index ld, Index columns) {
  for (Index first = 0; first < columns; first += kDepth) {
    const Index last = std::min(first + kDepth, columns);
    for (Index j = first; j < last; j += kColumns) {
      const Index few = std::min(kColumns, last - j);
      const double* before = a + first * ld;
      if (j > first)
        multiply_trapezoid<Use::subtract, Vector>(a, ld, j, j + few, ld, before, ld, j - first);
      if (!factor_some<Vector>(few, a, ld, j)) return false;
    }
    multiply_trapezoid<Use::subtract, Vector>(a, ld, last, columns, ld, a + first * ld, ld,
                                              last - first);
  }
  return true;
}

}  // namespace portolan::dense
