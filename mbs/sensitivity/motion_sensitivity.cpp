#include "mbs/sensitivity/motion_sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mbs/sensitivity/inertial_axes.hpp"
#include "mbs/sensitivity/lift.hpp"
#include "mbs/solvers/initial_state.hpp"
#include "mbs/system/penalty.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMoved = 1e-9;    // of the mechanism's length; of its speeds
constexpr double kResting = 1e-6;  // rad, or lengths, in the duration squared
constexpr int kStretches = 64;     // of a step each that are read at once

/// What the lift of two states leaves of the relations of the step between them, at nodes that are
/// carried by others.
template <FrameGroup G>
std::optional<StateSensitivity> lag_of(const Model<G>& model, const Parameters<G>& parameters,
                                       const StepSensitivity<G>& step, const State<G>& before,
                                       const State<G>& after) {
  if (model.positions().empty() || !any_lifted(parameters)) return std::nullopt;
  StateSensitivity lag =
      step.lag(lift_of(model, parameters, before), lift_of(model, parameters, after));
  const auto found = std::find_if(parameters.begin(), parameters.end(), lifted<G>);
  const std::vector<int>& carriers = found->nearby()->carriers();
  for (const int node : model.frames())
    if (carriers[static_cast<std::size_t>(node)] == node)
      for (MatrixXd* x : {&lag.v, &lag.a, &lag.w}) x->middleRows(G::dim * node, G::dim).setZero();
  return lag;
}

/// Calls `at` with a state and its derivatives, those of the lift among them.
template <FrameGroup G>
void tell(const Model<G>& model, const Parameters<G>& parameters, const SensitivityAt<G>& at,
          long step, const State<G>& s, const StateSensitivity& ds) {
  if (!any_lifted(parameters)) return at(step, s, ds);
  StateSensitivity whole = ds;
  at(step, s, whole += lift_of(model, parameters, s));
}

/// Adds the cotangents of a step, what they say of the lift to the gradient.
template <FrameGroup G>
void ask(const Model<G>& model, const Parameters<G>& parameters, const CotangentsAt<G>& at,
         long step, const State<G>& s, StateSensitivity& bars, MatrixXd& gradient) {
  if (!any_lifted(parameters)) return at(step, s, bars, gradient);
  auto own =
      StateSensitivity::zero(model.size(), model.constraints(), static_cast<int>(gradient.cols()));
  at(step, s, own, gradient);
  gradient += lift_of(model, parameters, s).transposed_product(own);
  bars += own;
}

/// r_p and Phi_p + tau dPhi_p/dt of all parameters, lifted where they have a lift.
template <FrameGroup G>
class Derivatives {
 public:
  /// @param damping tau of penalties, s
  Derivatives(const Model<G>& model, const Parameters<G>& parameters, double damping)
      : parameters_(parameters), damping_(damping) {
    const auto n_p = static_cast<Eigen::Index>(parameters.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < n_p; ++i)
      for (const int node : parameters[static_cast<std::size_t>(i)].nodes())
        for (int j = G::dim * node; j < G::dim * (node + 1); ++j) entries.emplace_back(j, i, 0);
    by_p_.r.resize(model.size(), n_p);
    by_p_.r.setFromTriplets(entries.begin(), entries.end());
    by_p_.phi = MatrixXd::Zero(model.constraints(), n_p);
    Eigen::RowVectorXd step(n_p);
    for (Eigen::Index i = 0; i < n_p; ++i) step[i] = parameters[static_cast<std::size_t>(i)].step();
    if (!step.isZero(0)) by_p_.step = step;
    r_p_.setZero(model.size());
    phi_p_.setZero(model.constraints());
    rate_.setZero(model.constraints());
    for (const auto& p : parameters)
      if (p.nearby())
        for (const auto& neighbour : p.nearby()->models()) neighbour->equations.damping = damping;
  }
  /// At the state after a step. @param previous coupling rows at the state before
  const ResidualDerivative& at(const State<G>& s, const VectorXd& previous,
                               std::optional<StateSensitivity> lag = std::nullopt) {
    by_p_.lag = std::move(lag);
    return at(s, previous, {s.t, 1});
  }
  const ResidualDerivative& at(const State<G>& s, const VectorXd& previous,
                               const LoadLevel& level) {
    for (size_t i = 0; i < parameters_.size(); ++i) {
      phi_p_.setZero();
      if (lifted(parameters_[i]))
        parameters_[i].nearby()->add_lifted(s, previous, level, r_p_, phi_p_);
      else
        parameters_[i].add(s, previous, level, r_p_, phi_p_);
      add_damping(parameters_[i], level.t);
      const auto column = static_cast<Eigen::Index>(i);
      by_p_.phi.col(column) = phi_p_;
      for (Eigen::SparseMatrix<double>::InnerIterator it(by_p_.r, column); it; ++it) {
        it.valueRef() = r_p_[it.row()];
        r_p_[it.row()] = 0;
      }
    }
    return by_p_;
  }
  /// Without the parameters of which `start_derivatives` has what the start changes by.
  const ResidualDerivative& at_start(const State<G>& s, bool in_equilibrium) {
    at(s, s.rows);
    if (in_equilibrium) return by_p_;
    set_target(s.t, 2);
    for (size_t i = 0; i < parameters_.size(); ++i)
      if (parameters_[i].nearby()) by_p_.r.col(static_cast<Eigen::Index>(i)) *= 0;
    return by_p_;
  }
  /// Largest time derivative of Phi_p of this order.
  double largest_target(double t, int order) {
    set_target(t, order);
    return by_p_.phi.size() > 0 ? by_p_.phi.cwiseAbs().maxCoeff() : 0;
  }

 private:
  void add_damping(const ParameterResidual<G>& parameter, double t) {
    if (damping_ == 0) return;
    rate_.setZero();
    parameter.add_target(t, 1, rate_);
    phi_p_ += damping_ * rate_;
  }
  void set_target(double t, int order) {
    for (size_t i = 0; i < parameters_.size(); ++i) {
      phi_p_.setZero();
      parameters_[i].add_target(t, order, phi_p_);
      by_p_.phi.col(static_cast<Eigen::Index>(i)) = phi_p_;
    }
  }

  const Parameters<G>& parameters_;
  const double damping_;
  ResidualDerivative by_p_;
  VectorXd r_p_, phi_p_, rate_;
};

/// Do drives that stand still begin to accelerate? Nodes of an equilibrium do, by its round-off.
template <FrameGroup G>
bool drives_accelerate(const Model<G>& model, const State<G>& at_rest, double duration) {
  VectorXd rate(model.constraints());
  Equations<G>(model).acceleration_target(at_rest, at_rest.t, rate);
  return rate.lpNorm<Eigen::Infinity>() * duration * duration >
         kResting * std::min(1.0, model.length);
}

/// Does the consistent start change with a parameter? That of an equilibrium does by its equations.
template <FrameGroup G>
bool start_changes(const Tape<G>& tape, const Parameters<G>& parameters) {
  return tape.options.start != StartChoice::Equilibrium &&
         std::any_of(parameters.begin(), parameters.end(),
                     [](const auto& p) { return p.nearby() != nullptr; });
}

/// What the consistent start changes by with parameters that are known by nearby mechanisms, a
/// column each, less the lift: differences of the starts of those. Zero for all others.
template <FrameGroup G>
StateSensitivity start_derivatives(const Model<G>& model, const Tape<G>& tape,
                                   const Parameters<G>& parameters, const State<G>& first) {
  auto ds = StateSensitivity::zero(model.size(), model.constraints(),
                                   static_cast<int>(parameters.size()));
  for (size_t i = 0; i < parameters.size(); ++i) {
    if (!parameters[i].nearby()) continue;
    const auto column = static_cast<Eigen::Index>(i);
    for (const auto& neighbour : parameters[i].nearby()->models()) {
      State<G> s = neighbour->model.initial_state();
      const InitialState start = make_consistent(neighbour->model, tape.options, s);
      if (start.status != SolveStatus::Converged) throw std::invalid_argument(start.reason);
      if (start.moved > kMoved * model.length)
        throw std::invalid_argument(fmt::format(
            "parameter '{}' opens joints: bodies were moved by {:.3g} m to close them; expected "
            "geometry in which all bodies that meet at a joint change together",
            parameters[i].parameter().name, start.moved));
      s = in_inertial_axes(neighbour->model, s);
      for (const auto* nodes : {&model.frames(), &model.positions()})
        for (const int k : *nodes)
          ds.eta.col(column).template segment<G::dim>(G::dim * k) +=
              neighbour->weight * G::log(first.H[k].inverse() * s.H[k]);
      ds.v.col(column) += neighbour->weight * s.v;
      ds.w.col(column) += neighbour->weight * s.vdot;
      ds.lambda.col(column) += neighbour->weight * s.lambda;
    }
  }
  ds.a = ds.w;
  const StateSensitivity lift = lift_of(model, parameters, first);
  ds.eta -= lift.eta;
  ds.v -= lift.v;
  ds.a -= lift.a;
  ds.w -= lift.w;
  return ds;
}

/// The start must not depend on the parameters, or be an equilibrium at rest.
template <FrameGroup G>
void require_given_start(const Model<G>& model, const Tape<G>& tape, Derivatives<G>& derivatives) {
  const InitialState& start = tape.start;
  const double t = tape.checkpoints.at(0).s.t;
  if (derivatives.largest_target(t, 0) > kMoved * model.length ||
      derivatives.largest_target(t, 1) > kMoved * model.length / tape.options.duration)
    throw std::invalid_argument(
        "the start depends on a parameter: a drive with a factor has to start from zero and from "
        "rest, its motion and the rate of its motion 0 at the start");
  const bool in_equilibrium = tape.options.start == StartChoice::Equilibrium;
  const State<G>& first = tape.checkpoints.at(0).s;
  if (in_equilibrium &&
      (first.v.template lpNorm<Eigen::Infinity>() * tape.options.duration >
           kMoved * std::min(1.0, model.length) ||  // the rate of a drive has round-off
       drives_accelerate(model, first, tape.options.duration)))
    throw std::invalid_argument(
        "sensitivities of a start in equilibrium need one at rest: no velocities, and drives that "
        "begin without velocity and acceleration");
  if (!in_equilibrium && start.moved > kMoved * model.length)
    throw std::invalid_argument(fmt::format(
        "sensitivities need a start that joints leave where it is; the bodies were moved by {:.3g} "
        "m to close the joints: give assembled positions",
        start.moved));
  if (start.velocity_change > kMoved * model.length / tape.options.duration)
    throw std::invalid_argument(fmt::format(
        "sensitivities need a start with velocities that joints and drives leave as they are; they "
        "were changed by {:.3g} m/s: give consistent velocities, or drives that start from rest",
        start.velocity_change));
}

template <FrameGroup G>
bool take_start(StepSensitivity<G>& sensitivity, const Tape<G>& tape, const State<G>& first) {
  return tape.options.start == StartChoice::Equilibrium ? sensitivity.start_in_equilibrium(first)
                                                        : sensitivity.start(first);
}

SensitivityEnd singular(double t) {
  return {fmt::format("the equations of the start at t = {:.6g} s are singular", t)};
}

SensitivityEnd not_finite(double t) {
  return {fmt::format("the equations of the start at t = {:.6g} s have no finite solution", t)};
}

/// Steps of a tape, in inertial axes.
template <FrameGroup G>
class TapeSteps {
 public:
  TapeSteps(const Model<G>& model, const Tape<G>& tape)
      : model_(model), tape_(tape), replay_(model, tape) {}

  int stretches() const { return replay_.stretches(); }
  /// Those of stretches from `first` on, before `end`.
  const Steps<G>& read(int first, int end) {
    steps_.h.clear();
    steps_.states = {in_inertial_axes(model_, tape_.checkpoints[static_cast<size_t>(first)].s)};
    for (int i = first; i < end; ++i)
      replay_.run(i, [&](const State<G>&, const State<G>& after, double h) {
        steps_.states.push_back(in_inertial_axes(model_, after));
        steps_.h.push_back(h);
      });
    return steps_;
  }

 private:
  const Model<G>& model_;
  const Tape<G>& tape_;
  Replay<G> replay_;
  Steps<G> steps_;
};

}  // namespace

template <FrameGroup G>
void require_sensitivities(const Model<G>& model, const Tape<G>& tape,
                           const Parameters<G>& parameters) {
  Derivatives<G> derivatives(model, parameters, damping_of_penalties(model));
  require_given_start(model, tape, derivatives);
  const StepSensitivity<G> sensitivity(model, tape.options.rho_inf);
  if (start_changes(tape, parameters))
    start_derivatives(model, tape, parameters, in_inertial_axes(model, tape.checkpoints.at(0).s));
}

template <FrameGroup G>
SensitivityEnd direct_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                  const Parameters<G>& parameters, const SensitivityAt<G>& at) {
  Derivatives<G> derivatives(model, parameters, damping_of_penalties(model));
  require_given_start(model, tape, derivatives);
  LinearisedSteps<G> linearised(model, tape.options.rho_inf);
  StateSensitivity ds;
  long step = 0;
  const State<G> first = in_inertial_axes(model, tape.checkpoints.at(0).s);
  if (!take_start(linearised.start(), tape, first)) return singular(first.t);
  if (!linearised.start().forward(
          derivatives.at_start(first, tape.options.start == StartChoice::Equilibrium), ds))
    return not_finite(first.t);
  if (start_changes(tape, parameters)) ds += start_derivatives(model, tape, parameters, first);
  tell(model, parameters, at, step++, first, ds);
  TapeSteps<G> tape_steps(model, tape);
  SensitivityEnd end;
  const int at_once = tape.every == 1 ? kStretches : 1;
  for (int i = 0; i < tape_steps.stretches() && end.complete(); i += at_once) {
    const Steps<G>& steps = tape_steps.read(i, std::min(i + at_once, tape_steps.stretches()));
    end = linearised.run(steps, false, [&](StepSensitivity<G>& sensitivity, size_t k) {
      const State<G>&before = steps.states[k], &after = steps.states[k + 1];
      const auto lag = lag_of(model, parameters, sensitivity, before, after);
      if (!sensitivity.forward(derivatives.at(after, before.rows, lag), ds)) return false;
      tell(model, parameters, at, step++, after, ds);
      return true;
    });
  }
  return end;
}

template <FrameGroup G>
SensitivityEnd static_sensitivity(const Model<G>& model, const Trajectory<G>& path, double time,
                                  const Parameters<G>& parameters, const SensitivityAt<G>& at) {
  Derivatives<G> derivatives(model, parameters, 0);
  StepSensitivity<G> sensitivity(model, 1);
  StateSensitivity ds;
  State<G> s = model.initial_state();
  for (int n = 1; n < path.size(); ++n) {
    path.read(n, s);
    const LoadLevel level{time, s.t};
    if (!sensitivity.equilibrium(s, level))
      return {fmt::format("the tangent at the load factor {:.6g} is singular", s.t)};
    if (!sensitivity.forward(derivatives.at(s, s.rows, level), ds))
      return {fmt::format("the equations at the load factor {:.6g} have no finite solution", s.t)};
    tell(model, parameters, at, n, s, ds);
  }
  return {};
}

template <FrameGroup G>
SensitivityEnd adjoint_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                   const Parameters<G>& parameters, int functionals,
                                   const CotangentsAt<G>& at, MatrixXd& gradient) {
  Derivatives<G> derivatives(model, parameters, damping_of_penalties(model));
  require_given_start(model, tape, derivatives);
  LinearisedSteps<G> linearised(model, tape.options.rho_inf);
  gradient.setZero(static_cast<Eigen::Index>(parameters.size()), functionals);
  StateSensitivity bars = StateSensitivity::zero(model.size(), model.constraints(), functionals);
  long step = tape.steps();
  TapeSteps<G> tape_steps(model, tape);
  const int at_once = tape.every == 1 ? kStretches : 1;
  for (int end = tape_steps.stretches(); end > 0; end -= at_once) {
    const Steps<G>& steps = tape_steps.read(std::max(0, end - at_once), end);
    const auto ended = linearised.run(steps, true, [&](StepSensitivity<G>& sensitivity, size_t k) {
      const State<G>&before = steps.states[k], &after = steps.states[k + 1];
      const auto lag = lag_of(model, parameters, sensitivity, before, after);
      ask(model, parameters, at, step--, after, bars, gradient);
      return sensitivity.backward(derivatives.at(after, before.rows, lag), bars, gradient);
    });
    if (!ended.complete()) return ended;
  }
  const State<G> first = in_inertial_axes(model, tape.checkpoints.at(0).s);
  if (!take_start(linearised.start(), tape, first)) return singular(first.t);
  ask(model, parameters, at, step, first, bars, gradient);
  if (start_changes(tape, parameters))
    gradient += start_derivatives(model, tape, parameters, first).transposed_product(bars);
  if (!linearised.start().backward(
          derivatives.at_start(first, tape.options.start == StartChoice::Equilibrium), bars,
          gradient))
    return not_finite(first.t);
  return {};
}

template void require_sensitivities(const Model<SE2>&, const Tape<SE2>&, const Parameters<SE2>&);
template void require_sensitivities(const Model<SE3>&, const Tape<SE3>&, const Parameters<SE3>&);
template SensitivityEnd direct_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                           const Parameters<SE2>&, const SensitivityAt<SE2>&);
template SensitivityEnd direct_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                           const Parameters<SE3>&, const SensitivityAt<SE3>&);
template SensitivityEnd static_sensitivity(const Model<SE2>&, const Trajectory<SE2>&, double,
                                           const Parameters<SE2>&, const SensitivityAt<SE2>&);
template SensitivityEnd static_sensitivity(const Model<SE3>&, const Trajectory<SE3>&, double,
                                           const Parameters<SE3>&, const SensitivityAt<SE3>&);
template SensitivityEnd adjoint_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                            const Parameters<SE2>&, int, const CotangentsAt<SE2>&,
                                            MatrixXd&);
template SensitivityEnd adjoint_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                            const Parameters<SE3>&, int, const CotangentsAt<SE3>&,
                                            MatrixXd&);

}  // namespace liesl
