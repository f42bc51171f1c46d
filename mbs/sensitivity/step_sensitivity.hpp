#pragma once
/// @file
/// One step of the Lie-group generalized-alpha method, differentiated by parameters p at its
/// converged states: thesis eq. 3.17-3.19 on the group (Sonneville, Brüls 2014, "Sensitivity
/// analysis for multibody systems formulated on a Lie group", Multibody Syst. Dyn. 31).
///
/// ' = d/dp; eta: left-invariant sensitivity of the frames, H' = H eta~; w = vdot. With
/// dq = log(H_n^-1 H_{n+1}), M, C, K of `IterationMatrix` at n+1 and beta', gamma' of the step:
///   x0 = T^-1(-dq) eta_n
///   a0 = -v'_n/(beta h) - (1/(2 beta) - 1) a'_n
///   v0 = (1 - gamma/beta) v'_n + h (1 - gamma/(2 beta)) a'_n
///   w0 = [(1 - alpha_m) a0 + alpha_m a'_n - alpha_f w'_n]/(1 - alpha_f)
///   S [eta; lambda'] = -[r_p + M (w0 - beta' x0) + C (v0 - gamma' x0); Phi_p]
///   x = T^-1(dq) eta - x0:  a' = x/(beta h^2) + a0,  v' = gamma' x + v0,  w' = beta' x + w0.
/// Where p changes the step, s = (dh/dp)/h:
///   a0 += s e_a,  v0 += s [h (1 - gamma) a_n + h gamma (a_{n+1} + e_a)],
///   w0 += s e_a (1 - alpha_m)/(1 - alpha_f),  e_a = v_n/(beta h) - 2 dq/(beta h^2).
/// So for the group, whose coordinates have the rates v. Others are integrated in their own: dq' =
/// E eta_{n+1} - E_n eta_n with E of `increments` for T^-1, v', a', w' of known and unknown are
/// those of the coordinates, and `RateMap` takes them into local frames and back.
/// Penalties lambda = alpha (Phi + tau dPhi/dt) have -1/alpha in the corner of S, tau (D(B v) + B
/// V) beside B, and Phi_p + tau [dPhi_p/dt + B (v0 - gamma' x0)] in place of Phi_p. `backward` is
/// the transposed of this map (discrete adjoint: exact for the discrete motion).

#include <Eigen/Core>
#include <optional>

#include "mbs/linalg/refined_solve.hpp"
#include "mbs/sensitivity/rate_map.hpp"
#include "mbs/solvers/generalized_alpha.hpp"

namespace liesl {

/// Derivatives of the equations of motion by n_p parameters at constant state, a column each.
struct ResidualDerivative {
  Eigen::SparseMatrix<double> r;  ///< n x n_p, dr/dp: a parameter acts on few nodes
  Eigen::MatrixXd phi;           ///< m x n_p, dPhi/dp + tau d/dt of it; at the start d^2/dt^2 of it
  Eigen::RowVectorXd step = {};  ///< n_p, dh/dp / h; empty: no parameter changes the step
  /// v, a and w of `StepSensitivity::lag`, where r and phi are of states that go with p and do not
  /// obey the relations of the step: these obey them up to that.
  std::optional<StateSensitivity> lag = std::nullopt;
};

template <FrameGroup G>
class StepSensitivity {
 public:
  static constexpr int dim = G::dim;

  /// @throws std::invalid_argument for augmented penalties that share forces
  StepSensitivity(const Model<G>& model, double rho_inf);

  /// At the start, where accelerations and multipliers follow from M w + B^T lambda = ...
  /// @returns false if that has no solution, here and below
  bool start(const State<G>& s);
  /// At a start in static equilibrium and at rest: [K B^T; B 0] [eta; lambda'] = -[r_p; Phi_p],
  /// v' = w' = 0. @pre v = w = 0
  bool start_in_equilibrium(const State<G>& s) { return equilibrium(s, {s.t, 1}); }
  /// The same of any equilibrium, under loads of that level: `forward` gives eta and lambda'.
  bool equilibrium(const State<G>& s, const LoadLevel& level);
  /// At the step from `before` to `after` of size h. @param factor false: `solve` is not used
  bool step(const State<G>& before, const State<G>& after, double h, bool factor = true);

  /// x: of the state before on entry, of the state after on return; at the start what it is on
  /// entry does not count. @param by_p at the state after
  /// @returns false if the solution is not finite, here and below: then x is that of entry
  bool forward(const ResidualDerivative& by_p, StateSensitivity& x);

  /// What the state before says of the one after: x0, a0, v0, w0 of the file's head, of the
  /// coordinates.
  struct Known {
    Eigen::MatrixXd x0, a0, v0, w0;
  };
  void take_known(const StateSensitivity& before, Known& k) const;
  /// v', a', w' that the step makes of `before` and eta of `after`, less those of `after`: zero if
  /// these are derivatives of states along the step. @pre nodes move along the group
  StateSensitivity lag(const StateSensitivity& before, const StateSensitivity& after) const;
  /// Adds what the parameters change by the step itself, and the lag.
  void add_step(const ResidualDerivative& by_p, Known& k) const;
  /// What v and vdot of the state after change by at held frames, n x n_p: v0 - gamma' x0 and w0 -
  /// beta' x0, in local frames.
  struct RateChange {
    Eigen::MatrixXd v, vdot;
  };
  void take_at_held_frames(const Known& k, RateChange& change) const;
  /// The state after from the solution [eta; lambda'] of its equations.
  void finish(const Known& k, const Eigen::MatrixXd& solution, StateSensitivity& x) const;
  /// x <- S^-1 x, not finite where it returns false
  bool solve(Eigen::MatrixXd& x);
  TangentWeights weights() const { return weights_.at(h_); }
  bool at_start() const { return at_start_; }

  /// x: cotangents of the state after on entry, of the state before on return; of the start zero.
  /// @param p cotangents of the parameters, n_p x columns: p -= r_p^T mu + Phi_p^T nu
  /// @returns false also if p is not finite
  bool backward(const ResidualDerivative& by_p, StateSensitivity& x, Eigen::MatrixXd& p);

  const IterationMatrix<G>& matrix() const { return matrix_; }

 private:
  bool linearise(const State<G>& s, const Eigen::VectorXd& previous, const RateTangents<G>& rates,
                 bool factor);
  bool linearise_step(const State<G>& before, const State<G>& after, double h, bool factor);
  void take_screws(const Eigen::VectorXd& dq);
  bool start_forward(const ResidualDerivative& by_p, StateSensitivity& x);
  bool start_backward(const ResidualDerivative& by_p, StateSensitivity& x, Eigen::MatrixXd& p);
  /// f(row, column, block) of tau B, by coupling and port.
  template <class F>
  void each_damped_block(F f) const;
  using Blocks = typename RateTangents<G>::Blocks;

  const Model<G>& model_;
  const AlphaWeights weights_;
  const double damping_;  ///< of penalties
  NodeCoordinates<G> coordinates_;
  Equations<G> equations_;
  IterationMatrix<G> matrix_;
  bool at_start_ = false, in_equilibrium_ = false;
  double h_ = 0;
  Blocks ahead_, back_;  ///< T^-1(dq), T^-1(-dq); of other coordinates their `increments`
  RateMap<G> before_, after_;
  Eigen::VectorXd by_step_a_, by_step_v_;  ///< what s multiplies in a0 and v0
  RateTangents<G> rates_;
  Known known_;
  RateChange change_;
  Eigen::MatrixXd force_, rhs_;
  RefinedSolve refined_;
  Eigen::SparseMatrix<double> start_matrix_;
  SparseLu start_lu_;
};

extern template class StepSensitivity<SE2>;
extern template class StepSensitivity<SE3>;

}  // namespace liesl
