#include "mbs/solvers/generalized_alpha.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mbs/solvers/divergence.hpp"
#include "mbs/system/penalty.hpp"

namespace liesl {
namespace {

constexpr double kSlow = 0.51;        // contraction that asks for a new tangent
constexpr double kGain = 0.1;         // the same of the adaptive strategy
constexpr int kCheap = 3;             // corrections that a step may take with any tangent
constexpr int kRenewal = 6;           // corrections beyond these that ask for another one
constexpr double kConstraint = 1e-3;  // constraint tolerance: this * tolerance * length
constexpr double kRoundOff = 1e-14;   // and this * length at least: positions are rounded
constexpr double kClosed = 1e-9;      // m: largest opening that augmentations leave, angles too
constexpr int kAugmentations = 10;    // a step
constexpr double kStalled = 0.1;      // of the opening left by an augmentation: weights grow
constexpr double kHeavier = 1e3;      // by which they do at least, for the rest of the step
constexpr double kHeaviest = 1e6;     // and at most
constexpr double kUnknown = std::numeric_limits<double>::infinity();  // an augmentation is between
constexpr double kMemory = 0.1;  // share of the largest force so far in the scale
constexpr double kQuiet = 1e-8;  // forces on a body below this share of all count as none

/// What a joint is open by after the last correction.
std::string opening(double open, double allowed) {
  return fmt::format(
      " (a joint is open by {:.2g} m or rad, {:.2g} at most under this simulation.tolerance)", open,
      allowed);
}

}  // namespace

TangentStrategy tangent_strategy(TangentStrategy chosen, Formalism formalism) {
  if (chosen != TangentStrategy::Auto) return chosen;
  if (formalism == Formalism::Classical) return TangentStrategy::Exact;
  if (formalism == Formalism::R3SO3 || formalism == Formalism::Floating)
    return TangentStrategy::Adaptive;
  return TangentStrategy::Constant;
}

template <FrameGroup G>
GeneralizedAlpha<G>::GeneralizedAlpha(const Model<G>& model, const SimulationOptions& options)
    : model_(model),
      options_(options),
      weights_(options.rho_inf),
      tangent_(tangent_strategy(options.tangent, model.formalism)),
      coordinates_(model, options.rescale),
      equations_(model),
      tangent_at_(model) {
  if (model.penalty.form != ConstraintForm::Multipliers) {
    equations_.compliance = model.penalty.weight.cwiseInverse();
    equations_.damping = damping_of_penalties(model);
  }
  for (const auto& c : model.couplings)
    for (const int k : model.positions())
      turns_are_observed_ = turns_are_observed_ || (c.a.body >= 0 && c.a.node == k) ||
                            (c.b.body >= 0 && c.b.node == k);
  factorizations_.assign(model.bodies.size(), 0);
  scales_.assign(model.bodies.size(), 0);
  trial_ = model.initial_state();
  coordinates_.start(trial_);
  for (auto* x :
       {&dq_, &u_, &udot_, &old_u_, &old_udot_, &older_udot_, &delta_, &increment_, &step_before_})
    x->setZero(model.size());
  dlambda_.setZero(model.constraints());
}

template <FrameGroup G>
void GeneralizedAlpha<G>::start(State<G>& s) {
  coordinates_.turn_positions(s, {});
  coordinates_.start(s);
  coordinates_.rates(s, old_u_, s.a);
}

/// The factors for a step size: kept from the first use on.
template <FrameGroup G>
auto GeneralizedAlpha<G>::factors_for(double h) -> Factored& {
  for (auto& f : factored_)
    if (f.at.h == h) return f;
  factored_.push_back({false, {h, trial_, dq_, u_, udot_}, JointSystem<G>(model_)});
  factored_.back().system.factor(weights_.at(h));
  for (auto& n : factorizations_) ++n;
  return factored_.back();
}

template <FrameGroup G>
StepMemory<G> GeneralizedAlpha<G>::memory() const {
  StepMemory<G> memory{older_udot_, previous_h_, scales_, excess_, {}};
  for (const auto& f : factored_)
    if (f.exact) memory.tangents.push_back(f.at);
  return memory;
}

template <FrameGroup G>
void GeneralizedAlpha<G>::restore(const StepMemory<G>& memory) {
  older_udot_ = memory.older_udot;
  previous_h_ = memory.previous_h;
  scales_ = memory.scales;
  for (auto& f : factored_) {
    if (f.exact) f.system.factor(weights_.at(f.at.h));
    f.exact = false;
  }
  for (const auto& point : memory.tangents) {
    Factored& f = factors_for(point.h);
    f.at = point;
    equations_.evaluate(f.at.s, f.at.s.rows, {f.at.s.t, 1});
    refresh(f);
  }
  excess_ = memory.excess;
}

/// Extrapolated accelerations and the formulas of Newmark: dq, rates, frames of the trial state.
template <FrameGroup G>
void GeneralizedAlpha<G>::predict(const State<G>& old, double h) {
  const auto& [am, af, gamma, beta] = weights_;
  coordinates_.rates(old, old_u_, old_udot_);
  if (previous_h_ == h)
    udot_ = 2 * old_udot_ - older_udot_;
  else if (options_.adaptive && previous_h_ > 0)
    udot_ = old_udot_ + h / previous_h_ * (old_udot_ - older_udot_);
  else
    udot_ = old_udot_;
  trial_.a = ((1 - af) * udot_ + af * old_udot_ - am * old.a) / (1 - am);
  dq_ = h * old_u_ + h * h * (0.5 - beta) * old.a + h * h * beta * trial_.a;
  u_ = old_u_ + h * (1 - gamma) * old.a + h * gamma * trial_.a;
  trial_.lambda = old.lambda;
  trial_.t = old.t + h;
  coordinates_.place(old, dq_, u_, udot_, trial_);
}

/// Axes of positions to where the predictor takes them: the correction is one in them. Vectors of
/// the state before are the same in other axes. Rates of positions are their velocities.
template <FrameGroup G>
void GeneralizedAlpha<G>::turn_axes(State<G>& old) {
  if (model_.positions().empty()) return;
  coordinates_.turn_positions(trial_, {&dq_, &older_udot_, &old.v, &old.vdot, &old.a});
  const auto take = [](Eigen::VectorXd& to, const Eigen::VectorXd& from, int k) {
    to.template segment<G::space_dim>(G::dim * k) = from.template segment<G::space_dim>(G::dim * k);
  };
  for (const int k : model_.positions()) {
    take(u_, trial_.v, k);
    take(udot_, trial_.vdot, k);
    take(old_u_, old.v, k);
    take(old_udot_, old.vdot, k);
    old.H[k].R = trial_.H[k].R;
  }
}

/// The correction delta is an increment of the frames at the current iterate.
template <FrameGroup G>
void GeneralizedAlpha<G>::correct(const State<G>& old, TangentWeights w) {
  coordinates_.increment(trial_, dq_, delta_, increment_);
  dq_ += increment_;
  u_ += w.damping * increment_;
  udot_ += w.mass * increment_;
  trial_.lambda += dlambda_;
  coordinates_.place(old, dq_, u_, udot_, trial_);
}

/// The complete tangent at `factors.at` into the factors. @returns false if it is singular; the
/// constant one is back then. @pre equations_ were evaluated there
template <FrameGroup G>
bool GeneralizedAlpha<G>::refresh(Factored& factors) {
  const TangentPoint<G>& at = factors.at;
  for (auto& n : factorizations_) ++n;
  excess_ = 0;
  coordinates_.rate_tangents(at.s, at.dq, at.u, at.udot, weights_.at(at.h), rate_tangents_);
  tangent_at_.take_own_stress(equations_);
  tangent_at_.linearise(equations_, at.s, {at.s.t, 1}, &rate_tangents_);
  factors.exact = factors.system.factor_exact(tangent_at_);
  if (!factors.exact) factors.system.factor(weights_.at(at.h));
  return factors.exact;
}

/// Auto begins with the constant tangent and keeps it, or the last one, until the corrections that
/// steps took beyond a few have added up. Another costs more than these, but serves later steps,
/// too.
template <FrameGroup G>
bool GeneralizedAlpha<G>::wants_tangent(StepResult& result, double residual, double before) const {
  if (tangent_ == TangentStrategy::Exact) return true;
  if (result.tangents > 0) return false;
  if (tangent_ == TangentStrategy::Adaptive)
    return result.iterations >= 1 && residual > kGain * before;
  if (result.iterations >= 2 && residual > kSlow * before) return true;
  result.renewed =
      options_.tangent == TangentStrategy::Auto && excess_ >= kRenewal && result.iterations >= 1;
  return result.renewed;
}

/// Aitken: with a frozen tangent the corrections shrink by a nearly constant factor c along the
/// same direction; the rest of that geometric series is known. A new tangent begins a new series.
template <FrameGroup G>
void GeneralizedAlpha<G>::extrapolate(Eigen::VectorXd& delta) const {
  const double size = step_before_.squaredNorm();
  const double c = size > 0 ? delta.dot(step_before_) / size : 0;
  if (std::abs(c) < kSlow) delta /= 1 - c;
}

/// Residuals of the bodies, each relative to the forces on it, as a root mean square: a grain
/// beside a ton has to be in balance, too. Beyond the round-off of one node, or of all nodes.
template <FrameGroup G>
double GeneralizedAlpha<G>::imbalance(bool of_all_nodes) const {
  const double least = std::max(kQuiet * equations_.scale(), 1e-300);
  double sum = 0;
  for (int b = 0; b < static_cast<int>(scales_.size()); ++b) {
    const double scale = std::max({equations_.scale(b), kMemory * scales_[b], least});
    const double nodes = of_all_nodes ? model_.bodies[static_cast<std::size_t>(b)]->nodes() : 1;
    const double round_off = equations_.round_off() * std::sqrt(nodes);
    const double body = std::max(equations_.residual(b) - round_off, 0.) / scale;
    sum += body * body;
  }
  return std::sqrt(sum / static_cast<double>(scales_.size()));
}

/// lambda* <- lambda at a converged iterate, while the joints are open by more than they may be (E.
/// Bayo, J. Garcia de Jalon, M. A. Serna, A modified Lagrangian formulation for the dynamic
/// analysis of constrained mechanical systems, CMAME 71 (1988) 183-195). Near a dead point the
/// bodies hardly yield to some rows: what an augmentation closes there grows with the weight. Of
/// compliance c and flexibility f of the bodies it leaves c/(c + f), which was measured: c becomes
/// what leaves a tenth of what is allowed.
/// @returns whether the iteration goes on
template <FrameGroup G>
bool GeneralizedAlpha<G>::augment(StepResult& result) {
  if (model_.penalty.form != ConstraintForm::Augmented) return false;
  const double closed = std::min(kClosed / std::max(1.0, model_.length),
                                 kConstraint * options_.tolerance * model_.length);
  const double open = equations_.opening();
  if (open <= closed) return false;
  equations_.phi += equations_.compliance.cwiseProduct(trial_.lambda - equations_.estimate);
  equations_.estimate = trial_.lambda;
  if (const double left = open / result.opening; left > kStalled) {
    const double stiff = left < 1 ? left / (1 - left) : kHeaviest;
    equations_.compliance /= std::clamp(stiff * open / (kStalled * closed), kHeavier, kHeaviest);
  }
  result.opening = open;
  ++result.augmentations;
  return true;
}

template <FrameGroup G>
StepResult GeneralizedAlpha<G>::step(State<G>& s, double h, double error_limit) {
  const TangentWeights w = weights_.at(h);
  Factored& factors = factors_for(h);
  StepResult result;
  predict(s, h);
  turn_axes(s);
  if (model_.penalty.form == ConstraintForm::Augmented) {
    equations_.estimate = s.lambda;
    equations_.compliance = model_.penalty.weight.cwiseInverse();
  }
  double before = 0;
  for (;;) {
    equations_.evaluate(trial_, s.rows, {trial_.t, 1});
    // An iteration that is about to be given up may have come as near as the round-off of all
    // nodes.
    const double residual = imbalance(2 * result.iterations > options_.max_iterations);
    result.residual = residual;
    if (!std::isfinite(equations_.residual() + equations_.constraint_residual())) {
      result.failure = divergence(model_, trial_);
      return result;
    }
    bool augmented = false;
    const double open = equations_.constraint_residual(),
                 allowed = std::max(kConstraint * options_.tolerance, kRoundOff) * model_.length;
    if (residual <= options_.tolerance && open <= allowed) {
      augmented = augment(result);
      if (!augmented) break;
      if (result.augmentations > kAugmentations) {
        result.failure = "the augmentations do not close the joints";
        return result;
      }
    }
    if (result.iterations == options_.max_iterations) {
      result.failure = "the iteration did not converge";
      if (open > allowed) result.failure += opening(open, allowed);
      return result;
    }
    const bool fresh = !augmented && wants_tangent(result, residual, before);
    if (fresh) {
      factors.at.s = trial_;
      factors.at.s.rows = s.rows;
      factors.at.dq = dq_;
      factors.at.u = u_;
      factors.at.udot = udot_;
      if (!refresh(factors)) {
        result.failure = "the tangent is singular";
        return result;
      }
      ++result.tangents;
    }
    before = augmented ? kUnknown : residual;
    if (!factors.system.solve(equations_, delta_, dlambda_)) {
      result.failure = "the joint equations are singular";
      return result;
    }
    if (result.iterations > 0 && !fresh && !augmented) extrapolate(delta_);
    step_before_ = delta_;
    ++result.iterations;
    if (result.iterations > kCheap && result.augmentations == 0) ++excess_;
    correct(s, w);
  }
  if (coordinates_.passes_full_turn(s, trial_)) {
    result.failure =
        "a rotation vector comes near 2 pi, where T(psi) is singular (simulation.rescale = true "
        "keeps it below pi),";
    return result;
  }
  result.converged = true;
  const auto& [am, af, gamma, beta] = weights_;
  trial_.a = ((1 - af) * udot_ + af * old_udot_ - am * s.a) / (1 - am);
  result.error = local_error(s, h);
  if (result.error > error_limit) return result;
  result.accepted = true;
  accept(s, h);
  return result;
}

/// Of the positions by Newmark's formulas, h^2 |beta - 1/6| |a_{n+1} - a_n|, the largest of a node.
template <FrameGroup G>
double GeneralizedAlpha<G>::local_error(const State<G>& s, double h) const {
  double change = 0;
  for (int k = 0; k < model_.nodes(); ++k)
    change =
        std::max(change, (trial_.a - s.a).template segment<G::space_dim>(G::dim * k).squaredNorm());
  return h * h * std::abs(weights_.beta - 1. / 6) * std::sqrt(change);
}

template <FrameGroup G>
void GeneralizedAlpha<G>::accept(State<G>& s, double h) {
  older_udot_ = old_udot_;
  if (turns_are_observed_) coordinates_.turn_positions(trial_, {&older_udot_});
  const bool moved = coordinates_.finish(trial_);
  equations_.observe(trial_, s.rows, trial_.rows);
  previous_h_ = moved ? 0 : h;
  for (int b = 0; b < static_cast<int>(scales_.size()); ++b)
    scales_[b] = std::max(scales_[b], equations_.scale(b));
  std::swap(s, trial_);
}

template class GeneralizedAlpha<SE2>;
template class GeneralizedAlpha<SE3>;

}  // namespace liesl
