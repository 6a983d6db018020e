// SPDX-License-Identifier: BSD-3-Clause
#include "graph/dense_kernels.hpp"

#include "graph/dense_factor.hpp"
#include "graph/dense_solve.hpp"

namespace portolan {

namespace {

using dense::Index;

struct Portable {
  static bool factor(double* a, Index ld, Index columns) {
    return dense::factor_panel<dense::Pair>(a, ld, columns);
  }
  static void square(double* c, Index ldc, Index n, const double* a, Index lda, Index depth) {
    dense::square<dense::Pair>(c, ldc, n, a, lda, depth);
  }
  static void forward(const double* l, Index ld, Index columns, double* x) {
    dense::solve_forward<dense::Pair>(l, ld, columns, x);
  }
  static void backward(const double* l, Index ld, Index columns, double* x) {
    dense::solve_backward<dense::Pair>(l, ld, columns, x);
  }
  static constexpr DenseKernels kKernels{factor, square, forward, backward};
};

#if defined(__x86_64__)
struct Avx2 {
  __attribute__((target("avx2,fma"))) static bool factor(double* a, Index ld, Index columns) {
    return dense::factor_panel<dense::Quad>(a, ld, columns);
  }
  __attribute__((target("avx2,fma"))) static void square(double* c, Index ldc, Index n,
                                                         const double* a, Index lda, Index depth) {
    dense::square<dense::Quad>(c, ldc, n, a, lda, depth);
  }
  __attribute__((target("avx2,fma"))) static void forward(const double* l, Index ld, Index columns,
                                                          double* x) {
    dense::solve_forward<dense::Quad>(l, ld, columns, x);
  }
  __attribute__((target("avx2,fma"))) static void backward(const double* l, Index ld, Index columns,
                                                           double* x) {
    dense::solve_backward<dense::Quad>(l, ld, columns, x);
  }
  static constexpr DenseKernels kKernels{factor, square, forward, backward};
};

struct Avx512 {
  __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma"))) static bool factor(double* a,
                                                                                   Index ld,
                                                                                   Index columns) {
    return dense::factor_panel<dense::Octet>(a, ld, columns);
  }
  __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma"))) static void square(
      double* c, Index ldc, Index n, const double* a, Index lda, Index depth) {
    dense::square<dense::Octet>(c, ldc, n, a, lda, depth);
  }
  __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma"))) static void forward(const double* l,
                                                                                    Index ld,
                                                                                    Index columns,
                                                                                    double* x) {
    dense::solve_forward<dense::Quad>(l, ld, columns, x);
  }
  __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma"))) static void backward(
      const double* l, Index ld, Index columns, double* x) {
    dense::solve_backward<dense::Quad>(l, ld, columns, x);
  }
  static constexpr DenseKernels kKernels{factor, square, forward, backward};
};

#endif

const DenseKernels& choose() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    return Avx512::kKernels;
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Avx2::kKernels;
#endif
  return Portable::kKernels;
}

}  // namespace

const DenseKernels& dense_kernels() {
  static const DenseKernels& kernels = choose();
  return kernels;
}

}  // namespace portolan
