#include "mbs/sensitivity/motion_sensitivity.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace liesl {
namespace {

using Eigen::MatrixXd;

constexpr double kMoved = 1e-9;  // of the mechanism's length; of its speeds

/// The start must not depend on the parameters.
template <FrameGroup G>
void require_given_start(const Model<G>& model, const Tape<G>& tape) {
  const InitialState& start = tape.start;
  if (start.moved > kMoved * model.length)
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
MatrixXd residual_derivative(const Model<G>& model, const ParameterDerivative<G>& derivative,
                             const State<G>& s) {
  MatrixXd r_p = MatrixXd::Zero(model.size(), derivative.parameters());
  derivative.add(s, r_p);
  return r_p;
}

SensitivityEnd singular(double t) {
  return {fmt::format("the equations of the step to t = {:.6g} s are singular", t)};
}

template <FrameGroup G>
struct StepRecord {
  State<G> before, after;
  double h;
};

}  // namespace

template <FrameGroup G>
SensitivityEnd direct_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                  const ParameterDerivative<G>& derivative,
                                  const SensitivityAt<G>& at) {
  require_given_start(model, tape);
  StepSensitivity<G> sensitivity(model, tape.options.rho_inf);
  StateSensitivity ds;
  SensitivityEnd end;
  long step = 0;
  const auto advance = [&](const State<G>& s) {
    sensitivity.forward(residual_derivative(model, derivative, s), ds);
    at(step++, s, ds);
  };
  const State<G>& first = tape.checkpoints.at(0).s;
  if (!sensitivity.start(first)) return singular(first.t);
  advance(first);
  Replay<G> replay(model, tape);
  for (int i = 0; i < replay.stretches() && end.complete(); ++i)
    replay.run(i, [&](const State<G>& before, const State<G>& after, double h) {
      if (!end.complete()) return;
      if (sensitivity.step(before, after, h))
        advance(after);
      else
        end = singular(after.t);
    });
  return end;
}

template <FrameGroup G>
SensitivityEnd adjoint_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                   const ParameterDerivative<G>& derivative, int functionals,
                                   const CotangentsAt<G>& at, MatrixXd& gradient) {
  require_given_start(model, tape);
  StepSensitivity<G> sensitivity(model, tape.options.rho_inf);
  gradient.setZero(derivative.parameters(), functionals);
  StateSensitivity bars = StateSensitivity::zero(model.size(), model.constraints(), functionals);
  long step = tape.steps();
  const auto go_back = [&](const State<G>& s) {
    at(step--, s, bars, gradient);
    sensitivity.backward(residual_derivative(model, derivative, s), bars, gradient);
  };
  Replay<G> replay(model, tape);
  std::vector<StepRecord<G>> stretch;
  for (int i = replay.stretches() - 1; i >= 0; --i) {
    stretch.clear();
    replay.run(i, [&](const State<G>& before, const State<G>& after, double h) {
      stretch.push_back({before, after, h});
    });
    for (auto record = stretch.rbegin(); record != stretch.rend(); ++record) {
      if (!sensitivity.step(record->before, record->after, record->h))
        return singular(record->after.t);
      go_back(record->after);
    }
  }
  const State<G>& first = tape.checkpoints.at(0).s;
  if (!sensitivity.start(first)) return singular(first.t);
  go_back(first);
  return {};
}

template SensitivityEnd direct_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                           const ParameterDerivative<SE2>&,
                                           const SensitivityAt<SE2>&);
template SensitivityEnd direct_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                           const ParameterDerivative<SE3>&,
                                           const SensitivityAt<SE3>&);
template SensitivityEnd adjoint_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                            const ParameterDerivative<SE2>&, int,
                                            const CotangentsAt<SE2>&, MatrixXd&);
template SensitivityEnd adjoint_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                            const ParameterDerivative<SE3>&, int,
                                            const CotangentsAt<SE3>&, MatrixXd&);

}  // namespace liesl
