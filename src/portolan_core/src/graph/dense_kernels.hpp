// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace portolan {

/// The dense arithmetic inside of a sparse Cholesky factor, with the widest vectors that the
/// processor has. Matrices are column-major; their leading dimensions and the numbers of rows that
/// are worked on are rounded up to `kRowStep`, so that rows of padding and, in lower triangles,
/// entries above the diagonal hold anything.
struct DenseKernels {
  static constexpr std::ptrdiff_t kRowStep = 8;
  static std::ptrdiff_t padded(std::ptrdiff_t rows) {
    return (rows + kRowStep - 1) / kRowStep * kRowStep;
  }

  /// Turns the lower trapezoid of the first `columns` columns, `ld` rows each, into those of a
  /// Cholesky factor, with the inverses of what stands on its diagonal instead. False where it is
  /// not positive definite.
  bool (*factor_panel)(double* a, std::ptrdiff_t ld, std::ptrdiff_t columns);
  /// Lower triangle of C (n x n) = A A^T, where A has `depth` columns.
  void (*square)(double* c, std::ptrdiff_t ldc, std::ptrdiff_t n, const double* a,
                 std::ptrdiff_t lda, std::ptrdiff_t depth);
  /// x = L^-1 x, of such a factor, for the upper `columns` rows, then x -= L x for those below,
  /// `ld` in all. Rows of padding must be finite in x and zero in L, which they are if they were
  /// before it was factored.
  void (*solve_forward)(const double* l, std::ptrdiff_t ld, std::ptrdiff_t columns, double* x);
  /// x -= L^T x of the rows below the upper `columns`, then x = L^-T x for these.
  void (*solve_backward)(const double* l, std::ptrdiff_t ld, std::ptrdiff_t columns, double* x);
};

/// Those for this processor.
const DenseKernels& dense_kernels();

}  // namespace portolan
