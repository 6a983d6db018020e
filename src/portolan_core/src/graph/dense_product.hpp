// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

// Products of dense matrices, for vectors of any width. All of it is inlined into functions that
// name the processor they are for.
#define PORTOLAN_INLINE inline __attribute__((always_inline))

namespace portolan::dense {

using Index = std::ptrdiff_t;
using Pair = double __attribute__((vector_size(16)));
using Quad = double __attribute__((vector_size(32)));
using Octet = double __attribute__((vector_size(64)));

constexpr Index kColumns = 6;  // that stay in registers together
constexpr Index kDepth = 48;   // columns whose rows fit into cache and page tables together

template <class Vector>
constexpr Index kWidth = static_cast<Index>(sizeof(Vector) / sizeof(double));

template <class Vector>
PORTOLAN_INLINE void load(Vector& v, const double* from) {
  std::memcpy(&v, from, sizeof v);
}
template <class Vector>
PORTOLAN_INLINE void store(const Vector& v, double* to) {
  std::memcpy(to, &v, sizeof v);
}

/// What becomes of C with a product P: C - P, P, or C + P.
enum class Use { subtract, set, add };

template <Use use, class Vector>
PORTOLAN_INLINE void put(const Vector& product, double* to) {
  Vector old;
  if (use != Use::set) load(old, to);
  store<Vector>(use == Use::set ? product : use == Use::add ? old + product : old - product, to);
}

// Of C and A B^T for `height` vectors of rows and a few columns.
template <Use use, class Vector, int columns, int height>
PORTOLAN_INLINE void multiply_tile(double* c, Index ldc, const double* a, Index lda,
                                   const double* b, Index ldb, Index depth) {
  Vector sum[columns][height] = {};
  for (Index k = 0; k < depth; ++k, a += lda, b += ldb) {
    Vector rows[height];
    for (int v = 0; v < height; ++v) load(rows[v], a + v * kWidth<Vector>);
    for (int j = 0; j < columns; ++j) {
      for (int v = 0; v < height; ++v) sum[j][v] += rows[v] * b[j];
    }
  }
  for (int j = 0; j < columns; ++j) {
    for (int v = 0; v < height; ++v) put<use>(sum[j][v], c + j * ldc + v * kWidth<Vector>);
  }
}

// Of C and A B^T for a few columns and any number of rows that is a multiple of the vectors' width.
template <Use use, class Vector, int columns>
PORTOLAN_INLINE void multiply_columns(double* c, Index ldc, Index rows, const double* a, Index lda,
                                      const double* b, Index ldb, Index depth) {
  constexpr Index kStep = kWidth<Vector>;
  Index i = 0;
  for (; i + 2 * kStep <= rows; i += 2 * kStep) {
    multiply_tile<use, Vector, columns, 2>(c + i, ldc, a + i, lda, b, ldb, depth);
  }
  if (i < rows) multiply_tile<use, Vector, columns, 1>(c + i, ldc, a + i, lda, b, ldb, depth);
}

template <Use use, class Vector>
PORTOLAN_INLINE void multiply_some(Index columns, double* c, Index ldc, Index rows, const double* a,
                                   Index lda, const double* b, Index ldb, Index depth) {
  switch (columns) {
    case 1:
      return multiply_columns<use, Vector, 1>(c, ldc, rows, a, lda, b, ldb, depth);
    case 2:
      return multiply_columns<use, Vector, 2>(c, ldc, rows, a, lda, b, ldb, depth);
    case 3:
      return multiply_columns<use, Vector, 3>(c, ldc, rows, a, lda, b, ldb, depth);
    case 4:
      return multiply_columns<use, Vector, 4>(c, ldc, rows, a, lda, b, ldb, depth);
    case 5:
      return multiply_columns<use, Vector, 5>(c, ldc, rows, a, lda, b, ldb, depth);
    default:
      return multiply_columns<use, Vector, 6>(c, ldc, rows, a, lda, b, ldb, depth);
  }
}

// Columns [first, last) of C and A A^T, each from its diagonal down, or a little above.
template <Use use, class Vector>
PORTOLAN_INLINE void multiply_trapezoid(double* c, Index ldc, Index first, Index last, Index ld,
                                        const double* a, Index lda, Index depth) {
  for (Index j = first; j < last; j += kColumns) {
    const Index top = j / kWidth<Vector> * kWidth<Vector>;
    multiply_some<use, Vector>(std::min(kColumns, last - j), c + top + j * ldc, ldc, ld - top,
                               a + top, lda, a + j, lda, depth);
  }
}

// Lower triangle of C = A A^T, a few columns of A after the other.
template <class Vector>
PORTOLAN_INLINE void square(double* c, Index ldc, Index n, const double* a, Index lda,
                            Index depth) {
  constexpr Index kStep = kWidth<Vector>;
  const Index rows = (n + kStep - 1) / kStep * kStep;
  multiply_trapezoid<Use::set, Vector>(c, ldc, 0, n, rows, a, lda, std::min(kDepth, depth));
  for (Index k = kDepth; k < depth; k += kDepth) {
    multiply_trapezoid<Use::add, Vector>(c, ldc, 0, n, rows, a + k * lda, lda,
                                         std::min(kDepth, depth - k));
  }
}

}  // namespace portolan::dense
