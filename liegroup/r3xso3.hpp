#pragma once
/// @file
/// R^3 x SO(3): position and rotation as a direct product, the setting of the classical finite
/// elements. Same members as SE3, another composition: translations are **inertial**, rotations
/// local, h = [u; w], and the two never mix.

#include <Eigen/Core>

#include "liegroup/coefficients.hpp"
#include "liegroup/concepts.hpp"
#include "liegroup/so3.hpp"

namespace liesl {

/// H1 * H2 = (R1 R2, x1 + x2). All operators are block diagonal: diag(I, operator of SO3).
struct R3xSO3 {
  using Tangent = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;
  static constexpr int dim = 6;
  static constexpr int space_dim = 3;
  static constexpr int rotation_dim = 3;

  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d x = Eigen::Vector3d::Zero();

  R3xSO3() = default;
  R3xSO3(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& position)
      : R(rotation), x(position) {}

  static R3xSO3 identity() { return {}; }
  R3xSO3 operator*(const R3xSO3& other) const { return {product<3>(R, other.R), x + other.x}; }
  /// Inertial coordinates R p + x of the point with local coordinates p.
  Eigen::Vector3d operator*(const Eigen::Vector3d& p) const { return product_plus<3>(R, p, x); }
  R3xSO3 inverse() const { return {transpose<3>(R), -x}; }

  static R3xSO3 exp(const Tangent& h) { return {SO3::exp(h.tail<3>()).R, h.head<3>()}; }

  /// Rotation below pi, see SO3::log.
  static Tangent log(const R3xSO3& H) {
    Tangent h;
    h << H.x, SO3::log(H.R);
    return h;
  }
  static void log_and_Tinv(const R3xSO3& H, Tangent& d, Matrix& Tinv_d) {
    d = log(H);
    Tinv_d = Tinv(d);
  }

  Matrix Ad() const { return blocks(1, R); }
  Matrix AdInv() const { return blocks(1, R.transpose()); }
  static Matrix ad(const Tangent& h) { return blocks(0, hat(h.tail<3>())); }

  static Matrix T(const Tangent& h) { return blocks(1, SO3::T(h.tail<3>())); }
  static Matrix Tinv(const Tangent& h) { return blocks(1, SO3::Tinv(h.tail<3>())); }
  static Matrix dT(const Tangent& h, const Tangent& a) {
    return blocks(0, SO3::dT(h.tail<3>(), a.tail<3>()));
  }
  static Matrix dTinv(const Tangent& h, const Tangent& a) {
    return blocks(0, SO3::dTinv(h.tail<3>(), a.tail<3>()));
  }
  static Matrix dTinvT(const Tangent& h, const Tangent& n) {
    return blocks(0, SO3::dTinvT(h.tail<3>(), n.tail<3>()));
  }

  /// One Newton step of R towards the nearest rotation; x is kept.
  void orthonormalize() { newton_step_to_rotation<3>(R); }

 private:
  /// diag(scale I, A)
  static Matrix blocks(double scale, const Eigen::Matrix3d& A) {
    Matrix M = Matrix::Zero();
    M.diagonal().head<3>().setConstant(scale);
    M.bottomRightCorner<3, 3>() = A;
    return M;
  }
};

static_assert(FrameGroup<R3xSO3>);

}  // namespace liesl
