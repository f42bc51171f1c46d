#pragma once
/// @file
/// Derivative of the Craig-Bampton modes of a meshed part by the fractions of its cells.

#include "mbs/linalg/sparse_cholesky.hpp"
#include "mbs/solids/solid_model.hpp"

namespace liesl {

/// dPsi/dp of Psi = [Psi_c, Phi], shapes of unit port motions and modes with all ports held, at
/// fractions v, with i the coordinates that are no port's:
///   K_ii Psi_c' = -(K' Psi_c)_i,
///   (K_ii - lambda_k M_ii) phi_k' = -P (K' - lambda_k M')_ii phi_k,  P = I - M_ii Phi Phi^T,
/// with phi_k' M-orthogonal to all modes that are kept: what phi_k' has within their span is a
/// choice of coordinates, which no motion depends on (Fox, Kapoor 1968, AIAA J. 6). Modes of one
/// frequency need no care unless only some of them are kept. Conjugate gradients with K_ii^-1,
/// whose factor is made once; not for several threads at once.
class ModeDerivative {
 public:
  /// @param basis Psi, q x n: columns without a motion of a port are modes, M-normal
  /// @throws std::runtime_error if K_ii is not positive definite
  ModeDerivative(const SolidModel& model, const Eigen::VectorXd& v, const Eigen::MatrixXd& basis);

  /// Psi' for dv/dp, q x n, zero at the ports. Overwrites the matrices of the model.
  /// @throws std::invalid_argument if the highest mode kept has the frequency of one that is not:
  /// the span of the modes has no derivative then
  Eigen::MatrixXd operator()(const SolidModel& model, const Eigen::VectorXd& dv) const;

  const Eigen::VectorXd& fractions() const { return v_; }

 private:
  Eigen::MatrixXd complement(const Eigen::MatrixXd& loads) const;

  Eigen::VectorXd v_;
  Eigen::MatrixXd Psi_;
  std::vector<int> shapes_, modes_;  ///< columns of Psi_
  int inner_;
  SolidModel::Sparse K_, M_;  ///< of the inner coordinates, lower triangles
  Eigen::MatrixXd Phi_, MPhi_;
  Eigen::VectorXd lambda_;
  SparseCholesky factor_;
};

}  // namespace liesl
