#pragma once
/// @file
/// Sensitivities of a whole motion by parameters: direct, all responses of few parameters, and
/// adjoint, few functionals of all parameters. Both replay the tape of a simulation, so that they
/// are those of the motion that was computed, halved steps and all.
///
/// The states are converged to simulation.tolerance only, and so are the sensitivities: 1e-8 or
/// below where they count (at 1e-6 an error of about 1e-4).

#include <functional>
#include <string>

#include "mbs/sensitivity/step_sensitivity.hpp"
#include "mbs/solvers/replay.hpp"

namespace liesl {

/// How the residual r of the equations of motion depends on parameters at constant state.
template <FrameGroup G>
class ParameterDerivative {
 public:
  virtual ~ParameterDerivative() = default;
  virtual int parameters() const = 0;
  /// r_p += dr/dp at s, n x parameters, forces in nodal local frames.
  virtual void add(const State<G>& s, Eigen::MatrixXd& r_p) const = 0;
};

/// How it ended: `reason` is empty if all steps were differentiated.
struct SensitivityEnd {
  std::string reason;
  bool complete() const { return reason.empty(); }
};

/// Called for the start (step 0) and after each accepted step with the state and its derivatives.
template <FrameGroup G>
using SensitivityAt = std::function<void(long step, const State<G>& s, const StateSensitivity& ds)>;

/// Direct form: one factorisation and n_p solutions a step.
/// @throws std::invalid_argument if the start was moved onto joints or drives: it depends on the
/// parameters then
template <FrameGroup G>
SensitivityEnd direct_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                  const ParameterDerivative<G>& derivative,
                                  const SensitivityAt<G>& at);

/// Adds the derivatives of the functionals' terms j_n by the state of a step: to the columns of
/// `bars` by eta, v, w = vdot and lambda (a: not used), to `gradient` (n_p x functionals) by p.
template <FrameGroup G>
using CotangentsAt = std::function<void(long step, const State<G>& s, StateSensitivity& bars,
                                        Eigen::MatrixXd& gradient)>;

/// Adjoint form: gradients of J = sum over steps of j_n, one factorisation and a solution for each
/// functional a step, whatever n_p; and one more forward run, stretch by stretch from the last.
/// @param gradient n_p x functionals, filled
/// @throws std::invalid_argument as the direct form
template <FrameGroup G>
SensitivityEnd adjoint_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                   const ParameterDerivative<G>& derivative, int functionals,
                                   const CotangentsAt<G>& at, Eigen::MatrixXd& gradient);

extern template SensitivityEnd direct_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                                  const ParameterDerivative<SE2>&,
                                                  const SensitivityAt<SE2>&);
extern template SensitivityEnd direct_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                                  const ParameterDerivative<SE3>&,
                                                  const SensitivityAt<SE3>&);
extern template SensitivityEnd adjoint_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                                   const ParameterDerivative<SE2>&, int,
                                                   const CotangentsAt<SE2>&, Eigen::MatrixXd&);
extern template SensitivityEnd adjoint_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                                   const ParameterDerivative<SE3>&, int,
                                                   const CotangentsAt<SE3>&, Eigen::MatrixXd&);

}  // namespace liesl
