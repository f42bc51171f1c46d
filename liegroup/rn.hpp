#pragma once
/// @file
/// The vector space R^N as a group under addition. Every operator is the identity or zero, so that
/// code written for a group costs what the classical code costs.

#include <Eigen/Core>

#include "liegroup/concepts.hpp"

namespace liesl {

/// x in R^N, H1 * H2 = x1 + x2, tangent u [N].
template <int N>
struct Rn {
  using Tangent = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  static constexpr int dim = N;

  Tangent x = Tangent::Zero();

  Rn() = default;
  explicit Rn(const Tangent& position) : x(position) {}

  static Rn identity() { return {}; }
  Rn operator*(const Rn& other) const { return Rn(x + other.x); }
  Rn inverse() const { return Rn(-x); }

  static Rn exp(const Tangent& u) { return Rn(u); }
  static Tangent log(const Rn& H) { return H.x; }
  static void log_and_Tinv(const Rn& H, Tangent& d, Matrix& Tinv_d) {
    d = H.x;
    Tinv_d = Matrix::Identity();
  }

  Matrix Ad() const { return Matrix::Identity(); }
  Matrix AdInv() const { return Matrix::Identity(); }
  static Matrix ad(const Tangent&) { return Matrix::Zero(); }

  static Matrix T(const Tangent&) { return Matrix::Identity(); }
  static Matrix Tinv(const Tangent&) { return Matrix::Identity(); }
  static Matrix dT(const Tangent&, const Tangent&) { return Matrix::Zero(); }
  static Matrix dTinv(const Tangent&, const Tangent&) { return Matrix::Zero(); }
  static Matrix dTinvT(const Tangent&, const Tangent&) { return Matrix::Zero(); }
};

static_assert(LieGroup<Rn<1>> && LieGroup<Rn<3>>);

}  // namespace liesl
