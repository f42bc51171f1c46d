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

#include "mbs/sensitivity/lift.hpp"
#include "mbs/sensitivity/linearised_steps.hpp"
#include "mbs/solvers/replay.hpp"
#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/parameter_residual.hpp"

namespace liesl {

/// Called for the start (step 0) and after each accepted step with the state and its derivatives.
template <FrameGroup G>
using SensitivityAt = std::function<void(long step, const State<G>& s, const StateSensitivity& ds)>;

/// Which form takes less time, as measured (docs/sensitivities.md, "What it costs").
constexpr bool adjoint_is_faster(int parameters, int functionals) {
  return parameters > functionals + 4;
}

/// @throws std::invalid_argument if there are no sensitivities, as the forms below, at once
template <FrameGroup G>
void require_sensitivities(const Model<G>& model, const Tape<G>& tape,
                           const Parameters<G>& parameters);

/// Direct form: one factorisation and n_p solutions a step.
/// @throws std::invalid_argument if the start depends on the parameters: it was moved onto joints
/// or drives, or a drive that depends on them does not start from zero and from rest. A static
/// equilibrium is differentiated; the motion has to start from rest there
template <FrameGroup G>
SensitivityEnd direct_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                  const Parameters<G>& parameters, const SensitivityAt<G>& at);

/// Of equilibria under a growing load, [K B^T; B 0] [eta; lambda'] = -[r_p; Phi_p] at each record
/// but the first, which has no load. Called with the number of the record; v' = w' = 0.
/// @param path equilibria, t = load factor  @param time of drives, tables and expressions
/// (simulation.at)
template <FrameGroup G>
SensitivityEnd static_sensitivity(const Model<G>& model, const Trajectory<G>& path, double time,
                                  const Parameters<G>& parameters, const SensitivityAt<G>& at);

/// Adds the derivatives of the functionals' terms j_n by the state of a step: to the columns of
/// `bars` by eta, v, w = vdot and lambda (a: not used), to `gradient` (n_p x functionals) by p.
template <FrameGroup G>
using CotangentsAt = std::function<void(long step, const State<G>& s, StateSensitivity& bars,
                                        Eigen::MatrixXd& gradient)>;

/// Adjoint form: gradients of J = sum over steps of j_n, one factorisation and a solution for each
/// functional a step, whatever n_p; and one more forward run, stretch by stretch from the last,
/// unless the tape has all states.
/// @param gradient n_p x functionals, filled
/// @throws std::invalid_argument as the direct form
template <FrameGroup G>
SensitivityEnd adjoint_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                   const Parameters<G>& parameters, int functionals,
                                   const CotangentsAt<G>& at, Eigen::MatrixXd& gradient);

extern template void require_sensitivities(const Model<SE2>&, const Tape<SE2>&,
                                           const Parameters<SE2>&);
extern template void require_sensitivities(const Model<SE3>&, const Tape<SE3>&,
                                           const Parameters<SE3>&);
extern template SensitivityEnd direct_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                                  const Parameters<SE2>&,
                                                  const SensitivityAt<SE2>&);
extern template SensitivityEnd direct_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                                  const Parameters<SE3>&,
                                                  const SensitivityAt<SE3>&);
extern template SensitivityEnd static_sensitivity(const Model<SE2>&, const Trajectory<SE2>&, double,
                                                  const Parameters<SE2>&,
                                                  const SensitivityAt<SE2>&);
extern template SensitivityEnd static_sensitivity(const Model<SE3>&, const Trajectory<SE3>&, double,
                                                  const Parameters<SE3>&,
                                                  const SensitivityAt<SE3>&);
extern template SensitivityEnd adjoint_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                                   const Parameters<SE2>&, int,
                                                   const CotangentsAt<SE2>&, Eigen::MatrixXd&);
extern template SensitivityEnd adjoint_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                                   const Parameters<SE3>&, int,
                                                   const CotangentsAt<SE3>&, Eigen::MatrixXd&);

}  // namespace liesl
