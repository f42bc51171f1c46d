#include "mbs/sensitivity/motion_sensitivity.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMoved = 1e-9;  // of the mechanism's length; of its speeds

/// r_p and Phi_p of all parameters.
template <FrameGroup G>
class Derivatives {
 public:
  Derivatives(const Model<G>& model, const Parameters<G>& parameters) : parameters_(parameters) {
    const auto n_p = static_cast<Eigen::Index>(parameters.size());
    by_p_ = {MatrixXd::Zero(model.size(), n_p), MatrixXd::Zero(model.constraints(), n_p)};
    r_p_.setZero(model.size());
    phi_p_.setZero(model.constraints());
  }
  /// At the state after a step. @param previous coupling rows at the state before
  const ResidualDerivative& at(const State<G>& s, const VectorXd& previous) {
    for (size_t i = 0; i < parameters_.size(); ++i) {
      r_p_.setZero();
      phi_p_.setZero();
      parameters_[i].add(s, previous, {s.t, 1}, r_p_, phi_p_);
      by_p_.r.col(static_cast<Eigen::Index>(i)) = r_p_;
      by_p_.phi.col(static_cast<Eigen::Index>(i)) = phi_p_;
    }
    return by_p_;
  }
  const ResidualDerivative& at_start(const State<G>& s) {
    at(s, s.rows);
    set_target(s.t, 2);
    return by_p_;
  }
  /// Largest time derivative of Phi_p of this order.
  double largest_target(double t, int order) {
    set_target(t, order);
    return by_p_.phi.size() > 0 ? by_p_.phi.cwiseAbs().maxCoeff() : 0;
  }

 private:
  void set_target(double t, int order) {
    for (size_t i = 0; i < parameters_.size(); ++i) {
      phi_p_.setZero();
      parameters_[i].add_target(t, order, phi_p_);
      by_p_.phi.col(static_cast<Eigen::Index>(i)) = phi_p_;
    }
  }

  const Parameters<G>& parameters_;
  ResidualDerivative by_p_;
  VectorXd r_p_, phi_p_;
};

/// The start must not depend on the parameters.
template <FrameGroup G>
void require_given_start(const Model<G>& model, const Tape<G>& tape, Derivatives<G>& derivatives) {
  const InitialState& start = tape.start;
  const double t = tape.checkpoints.at(0).s.t;
  if (derivatives.largest_target(t, 0) > kMoved * model.length ||
      derivatives.largest_target(t, 1) > kMoved * model.length / tape.options.duration)
    throw std::invalid_argument(
        "the start depends on a parameter: a drive with a factor has to start from zero and from "
        "rest, its motion and the rate of its motion 0 at the start");
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
                                  const Parameters<G>& parameters, const SensitivityAt<G>& at) {
  Derivatives<G> derivatives(model, parameters);
  require_given_start(model, tape, derivatives);
  StepSensitivity<G> sensitivity(model, tape.options.rho_inf);
  StateSensitivity ds;
  SensitivityEnd end;
  long step = 0;
  const auto advance = [&](const State<G>& s, const ResidualDerivative& by_p) {
    sensitivity.forward(by_p, ds);
    at(step++, s, ds);
  };
  const State<G>& first = tape.checkpoints.at(0).s;
  if (!sensitivity.start(first)) return singular(first.t);
  advance(first, derivatives.at_start(first));
  Replay<G> replay(model, tape);
  for (int i = 0; i < replay.stretches() && end.complete(); ++i)
    replay.run(i, [&](const State<G>& before, const State<G>& after, double h) {
      if (!end.complete()) return;
      if (sensitivity.step(before, after, h))
        advance(after, derivatives.at(after, before.rows));
      else
        end = singular(after.t);
    });
  return end;
}

template <FrameGroup G>
SensitivityEnd adjoint_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                   const Parameters<G>& parameters, int functionals,
                                   const CotangentsAt<G>& at, MatrixXd& gradient) {
  Derivatives<G> derivatives(model, parameters);
  require_given_start(model, tape, derivatives);
  StepSensitivity<G> sensitivity(model, tape.options.rho_inf);
  gradient.setZero(static_cast<Eigen::Index>(parameters.size()), functionals);
  StateSensitivity bars = StateSensitivity::zero(model.size(), model.constraints(), functionals);
  long step = tape.steps();
  const auto go_back = [&](const State<G>& s, const ResidualDerivative& by_p) {
    at(step--, s, bars, gradient);
    sensitivity.backward(by_p, bars, gradient);
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
      go_back(record->after, derivatives.at(record->after, record->before.rows));
    }
  }
  const State<G>& first = tape.checkpoints.at(0).s;
  if (!sensitivity.start(first)) return singular(first.t);
  go_back(first, derivatives.at_start(first));
  return {};
}

template SensitivityEnd direct_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                           const Parameters<SE2>&, const SensitivityAt<SE2>&);
template SensitivityEnd direct_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                           const Parameters<SE3>&, const SensitivityAt<SE3>&);
template SensitivityEnd adjoint_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                            const Parameters<SE2>&, int, const CotangentsAt<SE2>&,
                                            MatrixXd&);
template SensitivityEnd adjoint_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                            const Parameters<SE3>&, int, const CotangentsAt<SE3>&,
                                            MatrixXd&);

}  // namespace liesl
