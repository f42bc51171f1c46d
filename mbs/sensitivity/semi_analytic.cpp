#include "mbs/sensitivity/semi_analytic.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "mbs/sensitivity/inertial_axes.hpp"
#include "mbs/system/penalty.hpp"

namespace liesl {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Residuals of the perturbed models, and of the model itself.
template <FrameGroup G>
class Residuals {
 public:
  Residuals(const Model<G>& model, const std::vector<PerturbedModel<G>>& perturbed)
      : perturbed_(perturbed), at_(model) {
    for (const auto& p : perturbed) changed_.emplace_back(*p.model);
    at_.damping = damping_of_penalties(model);
    for (auto& eq : changed_) eq.damping = at_.damping;
  }
  /// -[r; Phi] of a change of v and vdot with p_i, divided by the step. @param v, vdot n x n_p
  MatrixXd right_side(const State<G>& s, const VectorXd& previous, const MatrixXd& v,
                      const MatrixXd& vdot) {
    at_.evaluate(s, previous, {s.t, 1});
    MatrixXd out(at_.r.size() + at_.phi.size(), static_cast<Index>(changed_.size()));
    State<G> moved = s;
    for (Index i = 0; i < out.cols(); ++i) {
      Equations<G>& eq = changed_[static_cast<std::size_t>(i)];
      const double step = perturbed_[static_cast<std::size_t>(i)].step;
      moved.v = s.v + step * v.col(i);
      moved.vdot = s.vdot + step * vdot.col(i);
      eq.evaluate(moved, previous, {s.t, 1});
      out.col(i) << -(eq.r - at_.r) / step, -(eq.phi - at_.phi) / step;
    }
    return out;
  }
  /// r_p and d^2/dt^2 of Phi_p at constant state.
  ResidualDerivative at_start(const State<G>& s) {
    const MatrixXd none = MatrixXd::Zero(at_.r.size(), static_cast<Index>(changed_.size()));
    const MatrixXd b = right_side(s, s.rows, none, none);
    MatrixXd phi(at_.phi.size(), b.cols());
    VectorXd target(phi.rows()), changed = target;
    at_.acceleration_target(s, s.t, target);
    for (Index i = 0; i < phi.cols(); ++i) {
      changed_[static_cast<std::size_t>(i)].acceleration_target(s, s.t, changed);
      phi.col(i) = (target - changed) / perturbed_[static_cast<std::size_t>(i)].step;
    }
    return {(-b.topRows(at_.r.size())).eval().sparseView(), phi};
  }
  /// At the state, positions in the axes of their nodes.
  Equations<G>& equations(const State<G>& s, const VectorXd& previous) {
    at_.evaluate(s, previous, {s.t, 1});
    return at_;
  }

 private:
  const std::vector<PerturbedModel<G>>& perturbed_;
  Equations<G> at_;
  std::vector<Equations<G>> changed_;
};

/// x <- S^-1 x by corrections with the integrator's constant factor, positions in inertial axes.
template <FrameGroup G>
class FrozenFactor {
 public:
  explicit FrozenFactor(const Model<G>& model) : model_(model), system_(model) {}
  /// @param s the state, in the axes of the factor: those of its nodes  @pre eq evaluated there
  bool solve(const IterationMatrix<G>& S, TangentWeights w, int corrections, const State<G>& s,
             Equations<G>& eq, MatrixXd& x) {
    if (w.mass != mass_ && !system_.factor(w)) return false;
    mass_ = w.mass;
    const auto n = eq.r.size(), m = eq.phi.size();
    VectorXd delta(n), dlambda(m);
    const MatrixXd b = x;
    x.setZero();
    for (int k = 0; k < corrections; ++k) {
      MatrixXd rest = b - S.matrix() * x;
      turn_positions(model_, s, false, rest);
      for (Index i = 0; i < x.cols(); ++i) {
        eq.r = -rest.col(i).head(n);
        eq.phi = -rest.col(i).tail(m);
        if (!system_.solve(eq, delta, dlambda)) return false;
        turn_positions(model_, s, true, delta);
        x.col(i).head(n) += delta;
        x.col(i).tail(m) += dlambda;
      }
    }
    return x.allFinite();
  }

 private:
  const Model<G>& model_;
  JointSystem<G> system_;
  double mass_ = 0;
};

}  // namespace

template <FrameGroup G>
SensitivityEnd semi_analytic_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                         const std::vector<PerturbedModel<G>>& perturbed,
                                         const StepFactor& factor, const SensitivityAt<G>& at) {
  if (tape.options.start == StartChoice::Equilibrium)
    throw std::invalid_argument("the semi-analytic form needs a start that is given");
  Residuals<G> residuals(model, perturbed);
  FrozenFactor<G> frozen(model);
  StepSensitivity<G> sensitivity(model, tape.options.rho_inf);
  typename StepSensitivity<G>::Known k;
  typename StepSensitivity<G>::RateChange change;
  StateSensitivity ds;
  SensitivityEnd end;
  const auto fail = [&end](double t) {
    end.reason = fmt::format(
        "the equations of the step to t = {:.6g} s are singular or have no finite solution", t);
  };
  const State<G> first = in_inertial_axes(model, tape.checkpoints.at(0).s);
  long step = 0;
  if (!sensitivity.start(first)) return fail(first.t), end;
  if (!sensitivity.forward(residuals.at_start(first), ds)) return fail(first.t), end;
  at(step++, first, ds);
  const auto advance = [&](const State<G>& from, const State<G>& to, double h) {
    if (!end.complete()) return;
    const State<G> before = in_inertial_axes(model, from), after = in_inertial_axes(model, to);
    if (!sensitivity.step(before, after, h, !factor.frozen)) return fail(after.t);
    const TangentWeights w = sensitivity.weights();
    sensitivity.take_known(ds, k);
    sensitivity.take_at_held_frames(k, change);
    MatrixXd x = residuals.right_side(after, before.rows, change.v, change.vdot);
    const bool solved = factor.frozen ? frozen.solve(sensitivity.matrix(), w, factor.corrections,
                                                     to, residuals.equations(to, from.rows), x)
                                      : sensitivity.solve(x);
    if (!solved) return fail(after.t);
    sensitivity.finish(k, x, ds);
    at(step++, after, ds);
  };
  Replay<G> replay(model, tape);
  for (int i = 0; i < replay.stretches() && end.complete(); ++i) replay.run(i, advance);
  return end;
}

template SensitivityEnd semi_analytic_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                                  const std::vector<PerturbedModel<SE2>>&,
                                                  const StepFactor&, const SensitivityAt<SE2>&);
template SensitivityEnd semi_analytic_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                                  const std::vector<PerturbedModel<SE3>>&,
                                                  const StepFactor&, const SensitivityAt<SE3>&);

}  // namespace liesl
