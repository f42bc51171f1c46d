#pragma once
/// @file
/// The linear system of one Newton correction,
///   [A  B^T] [delta ]     [r  ]
///   [B  -C ] [dlambda] = -[phi],   A = blockdiag over bodies of beta' M + gamma' C_b + K,
/// solved body by body: A is factored once, the joints come in by a small dense Schur complement
/// whose gradients B change with the motion. C: compliance 1/k of springs and dampers, 1/alpha of
/// penalties.
///
/// With the exact tangent couplings and loads at ports have stiffness X of their own on the coupled
/// nodes, z = E^T delta, and A is that of bodies and spread loads:
///   [I + F X   F B^T] [z      ]     [E^T A^-1 r]
///   [B         -C   ] [dlambda] = - [phi       ],   delta = -A^-1 (r + E (X z + B^T dlambda)).
/// I + F X stays with the tangent; what follows B is eliminated,
///   G = (I + F X)^-1 F B^T,  w = -(I + F X)^-1 E^T A^-1 r,
///   (B G + C) dlambda = phi + B w,   z = w - G dlambda.

#include "mbs/bodies/body.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/solvers/iteration_matrix.hpp"

namespace liesl {

template <FrameGroup G>
class JointSystem {
 public:
  static constexpr int dim = G::dim;

  explicit JointSystem(const Model<G>& model);

  /// Factors beta' M + (1 + gamma' damping) K_t of every body at its reference shape. With
  /// `stiffness` 0 the mass alone. @returns false if a body's matrix is singular.
  bool factor(TangentWeights w, double stiffness = 1);
  /// The same with all that was linearised at a state. @returns false if singular.
  bool factor_exact(const IterationMatrix<G>& S);

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
  /// Of a spring or damper in a step, df/dq + gamma' df/dq'; 0 on the flat part of a table.
  double tangent_stiffness(const Equations<G>& eq, int coupling, int row) const;
  /// What divides the equation of a penalised row, 1 + gamma' tau.
  double damped(const Equations<G>& eq) const { return 1 + weights_.damping * eq.damping; }
  void add_compliance(const Equations<G>& eq, bool compliant);
  void join();
  /// Row of X of the coupled node at a port.
  int place(const PortOf<G>& p) const { return dim * (first_node_[p.body] + p.slot); }
  /// f(first constraint, B of one side, place of its node) for each side of a coupling on a body.
  template <class F>
  void each_side(const Equations<G>& eq, F&& f) const {
    for (size_t k = 0; k < model_.couplings.size(); ++k) {
      const auto& c = model_.couplings[k];
      const auto B = eq.couplings[k].B.topRows(c.constraints);
      if (c.a.body >= 0) f(c.first_constraint, B.template leftCols<dim>(), place(c.a));
      if (c.b.body >= 0) f(c.first_constraint, B.template rightCols<dim>(), place(c.b));
    }
  }
  void assemble_exact(const Equations<G>& eq);
  bool solve_exact(const Equations<G>& eq, Eigen::VectorXd& delta, Eigen::VectorXd& dlambda);
  /// delta += A^-1 E f, f = joint_force of every body.
  void add_joint_forces(Eigen::VectorXd& delta) const;

  const Model<G>& model_;
  std::vector<BodyFactor> bodies_;
  std::vector<std::vector<Side>> sides_;  ///< by body
  std::vector<int> first_;                ///< first row of each coupling in the joint system
  std::vector<int> factorizations_;
  std::vector<double> point_inertia_;  ///< by body, see point_inertia
  std::vector<BodyMatrix<dim>> scratch_;
  TangentWeights weights_;
  bool exact_ = false;
  std::vector<int> first_node_;    ///< by body: of its coupled nodes among all of them
  Eigen::MatrixXd X_;              ///< stiffness of couplings and loads on the coupled nodes
  Eigen::MatrixXd join_, joined_;  ///< I + F X; (I + F X)^-1 F
  Eigen::MatrixXd S_;
  Eigen::MatrixXd exact_S_, G_;  ///< B G + C; (I + F X)^-1 F B^T
  Eigen::MatrixXd rates_;        ///< what damped penalties add to B: m x coupled nodes; else empty
  Eigen::VectorXd rhs_, exact_rhs_, solution_;
  Eigen::VectorXd z_, force_;  ///< of all coupled nodes
  linalg::Cholesky cholesky_;
  linalg::LU lu_, exact_lu_, join_lu_;
};

extern template class JointSystem<SE2>;
extern template class JointSystem<SE3>;

}  // namespace liesl
