#pragma once
/// @file
/// The linear cantilever of n equal elements under a unit force at its tip.

#include <gtest/gtest.h>

#include "liegroup/concepts.hpp"
#include "mbs/linalg/block_tridiagonal.hpp"

namespace liesl::test {

inline constexpr double kCantileverLength = 2, kCantileverEI = 30, kCantileverGA = 500;

/// Deflection of Timoshenko's beam, m: L^3/(3 EI) + L/kGA.
inline constexpr double kTimoshenkoBending =
    kCantileverLength * kCantileverLength * kCantileverLength / (3 * kCantileverEI);
inline constexpr double kTimoshenkoShear = kCantileverLength / kCantileverGA;

/// Deflection of the tip, m. @tparam Element with constant_tangent()
template <FrameGroup G, class Element>
double tip_deflection(int n) {
  constexpr int dim = G::dim;
  typename G::Tangent k = G::Tangent::Constant(70);
  k[1] = kCantileverGA;
  k[dim - 1] = kCantileverEI;
  const typename G::Matrix K = k.asDiagonal();
  const Element e(G::identity(), G::exp(kCantileverLength / n * G::Tangent::Unit(0)), K,
                  G::Matrix::Identity());
  BlockTridiagonal<dim> A(n + 1);
  for (int i = 0; i < n; ++i) A.add_element(i, e.constant_tangent());
  A.D[0].setIdentity();  // held
  A.U[0].setZero();
  A.L[0].setZero();
  BlockTridiagonalLU<dim> lu;
  EXPECT_TRUE(lu.factor(A));
  Eigen::VectorXd u = Eigen::VectorXd::Unit(dim * (n + 1), dim * n + 1);
  lu.solve(u.data());
  return u[dim * n + 1];
}

}  // namespace liesl::test
