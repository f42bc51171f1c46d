#pragma once
/// @file
/// The linear system of one Newton correction,
///   [A  B^T] [delta ]     [r  ]
///   [B  -C ] [dlambda] = -[phi],   A = blockdiag over bodies of beta' M + gamma' C_b + K,
/// solved body by body: A is factored once, the joints come in by a small dense Schur complement
/// whose gradients B change with the motion. C: compliance 1/k of springs and dampers.

#include "mbs/bodies/body.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/system/equations.hpp"

namespace liesl {

template <FrameGroup G>
class JointSystem {
 public:
  static constexpr int dim = G::dim;

  explicit JointSystem(const Model<G>& model);

  /// Factors beta' M + (1 + gamma' damping) K_t of every body at its reference shape. With
  /// `stiffness` 0 the mass alone. @returns false if a body's matrix is singular.
  bool factor(TangentWeights w, double stiffness = 1);
  /// The same with the exact tangents at a state. @returns false if singular.
  bool factor_exact(const State<G>& s, TangentWeights w);

  /// delta, dlambda from eq.r and eq.phi. `compliant` = false leaves springs and dampers out
  /// (accelerations). @returns false if the joint system is singular.
  bool solve(const Equations<G>& eq, Eigen::VectorXd& delta, Eigen::VectorXd& dlambda,
             bool compliant = true);

  /// Factorisations so far, one number a body.
  const std::vector<int>& factorizations() const { return factorizations_; }

 private:
  struct BodyFactor {
    BodyLU<dim> lu;
    Eigen::MatrixXd X;            ///< A^-1 E, E = unit increments of the coupled nodes
    Eigen::MatrixXd F;            ///< E^T A^-1 E: compliance seen by the joints
    Eigen::VectorXd joint_force;  ///< B^T dlambda on the coupled nodes
  };
  struct Side {  ///< one end of a coupling on a body
    int coupling, column, slot;
  };

  bool factor_body(int body, BodyMatrix<dim>& A);
  void assemble(const Equations<G>& eq, bool compliant);

  const Model<G>& model_;
  std::vector<BodyFactor> bodies_;
  std::vector<std::vector<Side>> sides_;  ///< by body
  std::vector<int> first_;                ///< first row of each coupling in the joint system
  std::vector<int> factorizations_;
  std::vector<double> point_inertia_;  ///< by body, see point_inertia
  std::vector<BodyMatrix<dim>> scratch_;
  TangentWeights weights_;
  bool symmetric_ = true;
  Eigen::MatrixXd S_;
  Eigen::VectorXd rhs_, solution_;
  linalg::Cholesky cholesky_;
  linalg::LU lu_;
};

extern template class JointSystem<SE2>;
extern template class JointSystem<SE3>;

}  // namespace liesl
