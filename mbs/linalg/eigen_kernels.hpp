#pragma once
/// @file
/// The kernels behind Eigen's products of dynamic size, compiled once (eigen_kernels.cpp) instead
/// of in every source that multiplies. Part of the precompiled headers; a source that is compiled
/// without it has its own copies. For Eigen 3.4, whose internals it names; nothing with another
/// version.

#include <Eigen/Core>

#if EIGEN_WORLD_VERSION == 3 && EIGEN_MAJOR_VERSION == 4 && EIGEN_MINOR_VERSION < 90

namespace Eigen::internal {

using RealTraits = gebp_traits<double, double>;
using ByColumns = const_blas_data_mapper<double, Index, ColMajor>;
using ByRows = const_blas_data_mapper<double, Index, RowMajor>;
using Target = blas_data_mapper<double, Index, ColMajor, Unaligned, 1>;

}  // namespace Eigen::internal

// A x B, packing and the inner kernel; A x; triangular systems with many right-hand sides.
#define LIESL_EIGEN_KERNELS(EXTERN)                                                                \
  EXTERN template struct gebp_kernel<double, double, Index, Target, RealTraits::mr,                \
                                     RealTraits::nr, false, false>;                                \
  EXTERN template struct gemm_pack_rhs<double, Index, ByColumns, RealTraits::nr, ColMajor>;        \
  EXTERN template struct gemm_pack_lhs<double, Index, ByColumns, RealTraits::mr,                   \
                                       RealTraits::LhsProgress, RealTraits::LhsPacket4Packing,     \
                                       ColMajor>;                                                  \
  EXTERN template struct gemm_pack_lhs<double, Index, ByRows, RealTraits::mr,                      \
                                       RealTraits::LhsProgress, RealTraits::LhsPacket4Packing,     \
                                       RowMajor>;                                                  \
  EXTERN template struct general_matrix_matrix_product<Index, double, ColMajor, false, double,     \
                                                       ColMajor, false, ColMajor, 1>;              \
  EXTERN template struct general_matrix_matrix_product<Index, double, RowMajor, false, double,     \
                                                       ColMajor, false, ColMajor, 1>;              \
  EXTERN template struct general_matrix_matrix_product<Index, double, ColMajor, false, double,     \
                                                       RowMajor, false, ColMajor, 1>;              \
  EXTERN template struct general_matrix_vector_product<Index, double, ByRows, RowMajor, false,     \
                                                       double, ByColumns, false, 0>;               \
  EXTERN template struct general_matrix_vector_product<Index, double, ByRows, RowMajor, false,     \
                                                       double, ByRows, false, 0>;                  \
  EXTERN template struct general_matrix_vector_product<Index, double, ByColumns, ColMajor, false,  \
                                                       double, ByColumns, false, 0>;               \
  EXTERN template struct general_matrix_vector_product<Index, double, ByColumns, ColMajor, false,  \
                                                       double, ByRows, false, 0>;                  \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false,       \
                                                 ColMajor, ColMajor, 1>;                           \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, ColMajor, \
                                                 ColMajor, 1>;

namespace Eigen::internal {
LIESL_EIGEN_KERNELS(extern)
}  // namespace Eigen::internal

#endif
