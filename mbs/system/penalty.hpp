#pragma once
/// @file
/// Constraints by penalties: forces B^T lambda with lambda = alpha (Phi + tau dPhi/dt) (J. C.
/// Garcia Orden, J. J. Arribas, D. Dopico, F. Gabaldon 2024, eq. 3).

#include <string>
#include <vector>

#include "mbs/model/parameter.hpp"
#include "mbs/system/joint_graph.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// Weights of the rows of a model that is numbered. Those that the spec does not give are 1000
/// times the largest diagonal entry of K + M/step^2 of the bodies, of translations for rows that
/// are lengths, of rotations for rows that are angles, rounded up to a power of ten: a small change
/// of the design leaves them.
/// @throws std::invalid_argument if a weight or the damping is negative or not finite
template <FrameGroup G>
Penalty build_penalty(const PenaltySpec& spec, const Model<G>& model);

/// Is Phi of this row a length [m], not an angle [rad]?
template <FrameGroup G>
bool is_length(const Row<G>& row) {
  return row.kind() != RowKind::Angle && row.kind() != RowKind::Perpendicular;
}

/// tau of a motion, s; 0 with multipliers, and of augmented joints, which are closed: what their
/// rate is, is the error of the velocities, and a force of it would keep them open.
template <FrameGroup G>
double damping_of_penalties(const Model<G>& model) {
  return model.penalty.form == ConstraintForm::Penalty ? model.penalty.damping : 0;
}

/// Phi from the rows of a state, m or rad by multiplier.
template <FrameGroup G>
Eigen::VectorXd openings(const Model<G>& model, const State<G>& s);

/// sum of alpha Phi^2 / 2, J; 0 with multipliers.
template <FrameGroup G>
double penalty_energy(const Model<G>& model, const State<G>& s);

/// What damping of penalties, and augmentation, takes out of a motion, step by step.
template <FrameGroup G>
class PenaltyWork {
 public:
  explicit PenaltyWork(const Model<G>& model) : model_(model) {}
  /// Work beyond the change of `penalty_energy` since the state before, J; 0 at the first one:
  /// -(lambda_0 + lambda_1)/2 . (Phi_1 - Phi_0) + alpha (Phi_1^2 - Phi_0^2)/2.
  /// With lambda = alpha (Phi + tau dPhi/dt) that is -alpha tau (dPhi/dt) dPhi. The rate of a stiff
  /// row is no more than the error of the velocities: its square, as a power, has no meaning.
  double step(const State<G>& s);

 private:
  const Model<G>& model_;
  bool first_ = true;
  Eigen::VectorXd lambda_, opening_;
};

/// Of penalty_energy by the weights at constant state, J per unit of p.
template <FrameGroup G>
double penalty_energy_derivative(const PenaltyDerivative& by, const Model<G>& model,
                                 const State<G>& s);

/// Watches what penalties leave open, joint by joint, against the largest deformation of the bodies
/// that share a closed loop with it, or else are nearest (`JointGraph::beside`).
template <FrameGroup G>
class JointOpening {
 public:
  /// The joint that opens furthest.
  struct Worst {
    std::string joint;
    double opening = 0;      ///< m; angles times the model's length
    double deformation = 0;  ///< of what it is set against, of all where that is rigid, m
    double share = 0;        ///< of the one in the other; of the model's length if none deforms
  };

  explicit JointOpening(const Model<G>& model);
  /// @param gap Phi by multiplier  @param s completed
  void step(const Eigen::VectorXd& gap, const State<G>& s);
  Worst worst() const;
  bool rigid() const { return rigid_; }  ///< no body can deform

 private:
  double beside(const JointGraph& graph, const Coupling<G>& c) const;

  const Model<G>& model_;
  Eigen::VectorXd lever_;    ///< by multiplier: 1 or the model's length
  Eigen::VectorXd opening_;  ///< by multiplier, the largest so far
  std::vector<bool> deforms_;
  std::vector<double> deformation_;  ///< by body: farthest from where its middle node takes it, m
  bool rigid_ = true;
};

extern template class PenaltyWork<SE2>;
extern template class PenaltyWork<SE3>;
extern template class JointOpening<SE2>;
extern template class JointOpening<SE3>;

}  // namespace liesl
