#include "mbs/solvers/generalized_alpha.hpp"

namespace liesl {
namespace {

constexpr double kSlow = 0.5;         // contraction that asks for a new tangent
constexpr double kConstraint = 1e-3;  // constraint tolerance: this * tolerance * length
constexpr double kMemory = 0.1;       // share of the largest force so far in the scale

}  // namespace

template <FrameGroup G>
GeneralizedAlpha<G>::GeneralizedAlpha(const Model<G>& model, const SimulationOptions& options)
    : model_(model), options_(options), weights_(options.rho_inf), equations_(model) {
  factorizations_.assign(model.bodies.size(), 0);
  trial_ = model.initial_state();
  dq_.setZero(model.size());
  delta_.setZero(model.size());
  dlambda_.setZero(model.constraints());
  previous_vdot_.setZero(model.size());
  step_before_.setZero(model.size());
}

/// The factors for a step size: kept from the first use on.
template <FrameGroup G>
JointSystem<G>& GeneralizedAlpha<G>::system_for(double h) {
  for (auto& f : factored_)
    if (f.h == h) return f.system;
  factored_.push_back({h, false, JointSystem<G>(model_)});
  factored_.back().system.factor(weights_.at(h));
  for (auto& n : factorizations_) ++n;
  return factored_.back().system;
}

/// Extrapolated accelerations and the formulas of Newmark: dq, v, vdot, H of the trial state.
template <FrameGroup G>
void GeneralizedAlpha<G>::predict(const State<G>& old, double h) {
  const auto& [am, af, gamma, beta] = weights_;
  if (previous_h_ == h)
    trial_.vdot = 2 * old.vdot - previous_vdot_;
  else
    trial_.vdot = old.vdot;
  trial_.a = ((1 - af) * trial_.vdot + af * old.vdot - am * old.a) / (1 - am);
  dq_ = h * old.v + h * h * (0.5 - beta) * old.a + h * h * beta * trial_.a;
  trial_.v = old.v + h * (1 - gamma) * old.a + h * gamma * trial_.a;
  trial_.lambda = old.lambda;
  trial_.t = old.t + h;
  for (size_t k = 0; k < old.H.size(); ++k)
    trial_.H[k] = old.H[k] * G::exp(dq_.template segment<G::dim>(G::dim * static_cast<int>(k)));
}

/// The correction delta is an increment at the current iterate: dq += T^-1(dq) delta.
template <FrameGroup G>
void GeneralizedAlpha<G>::correct(double, TangentWeights w) {
  for (int k = 0; k < model_.nodes(); ++k) {
    auto dq = dq_.template segment<G::dim>(G::dim * k);
    const typename G::Tangent e = G::Tinv(dq) * delta_.template segment<G::dim>(G::dim * k);
    dq += e;
    trial_.v.template segment<G::dim>(G::dim * k) += w.damping * e;
    trial_.vdot.template segment<G::dim>(G::dim * k) += w.mass * e;
  }
  trial_.lambda += dlambda_;
}

/// Aitken: with a frozen tangent the corrections shrink by a nearly constant factor c along the
/// same direction; the rest of that geometric series is known.
template <FrameGroup G>
void GeneralizedAlpha<G>::extrapolate(Eigen::VectorXd& delta) const {
  const double size = step_before_.squaredNorm();
  const double c = size > 0 ? delta.dot(step_before_) / size : 0;
  if (std::abs(c) < kSlow) delta /= 1 - c;
}

template <FrameGroup G>
bool GeneralizedAlpha<G>::small_enough() const {
  const double scale = std::max(equations_.scale(), kMemory * scale_);
  return equations_.residual() <= options_.tolerance * scale + equations_.round_off() &&
         equations_.constraint_residual() <= kConstraint * options_.tolerance * model_.length;
}

template <FrameGroup G>
StepResult GeneralizedAlpha<G>::step(State<G>& s, double h) {
  const TangentWeights w = weights_.at(h);
  JointSystem<G>& system = system_for(h);
  StepResult result;
  predict(s, h);
  double before = 0;
  for (;;) {
    equations_.evaluate(trial_, s.q, {trial_.t, 1});
    const double residual = equations_.residual();
    result.residual = residual / std::max(equations_.scale(), 1e-300);
    if (!std::isfinite(residual + equations_.constraint_residual())) {
      result.failure = "the iteration diverged";
      return result;
    }
    if (small_enough()) break;
    if (result.iterations == options_.max_iterations) {
      result.failure = "the iteration did not converge";
      return result;
    }
    const bool slow = result.iterations >= 2 && residual > kSlow * before;
    if (slow && !result.refreshed) {
      if (!system.factor_exact(trial_, w)) {
        result.failure = "the tangent is singular";
        return result;
      }
      for (auto& n : factorizations_) ++n;
      result.refreshed = true;
    }
    before = residual;
    if (!system.solve(equations_, delta_, dlambda_)) {
      result.failure = "the joint equations are singular";
      return result;
    }
    if (result.iterations > 0) extrapolate(delta_);
    step_before_ = delta_;
    ++result.iterations;
    correct(h, w);
    for (int k = 0; k < model_.nodes(); ++k)
      trial_.H[k] = s.H[k] * G::exp(dq_.template segment<G::dim>(G::dim * k));
  }
  result.converged = true;
  accept(s, s, h, result);
  return result;
}

template <FrameGroup G>
void GeneralizedAlpha<G>::accept(const State<G>& old, State<G>& s, double h, StepResult& result) {
  const auto& [am, af, gamma, beta] = weights_;
  trial_.a = ((1 - af) * trial_.vdot + af * old.vdot - am * old.a) / (1 - am);
  double error = 0;
  for (int k = 0; k < model_.nodes(); ++k)
    error = std::max(error, (trial_.a - old.a).template segment<G::space_dim>(G::dim * k).norm());
  result.error = h * h * std::abs(beta - 1. / 6) * error;
  equations_.observe(trial_, old.q, trial_.q);
  for (auto& H : trial_.H) H.orthonormalize();
  previous_vdot_ = old.vdot;
  previous_h_ = h;
  scale_ = std::max(scale_, equations_.scale());
  std::swap(s, trial_);
}

template class GeneralizedAlpha<SE2>;
template class GeneralizedAlpha<SE3>;

}  // namespace liesl
