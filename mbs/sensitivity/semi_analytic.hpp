#pragma once
/// @file
/// Semi-analytic direct form (E. Tromme, thesis, Liège 2015, eq. 3.17-3.19): the right side of a
/// step by one difference of the residual at p + e, v + e (v0 - gamma' x0), vdot + e (w0 - beta'
/// x0), no derivative of any law. Here to be compared with the analytic form: it costs a residual
/// of the whole mechanism a step and parameter, and its error is that of a forward difference.

#include "mbs/sensitivity/motion_sensitivity.hpp"

namespace liesl {

/// The model at p_i + step; outlives what uses it.
template <FrameGroup G>
struct PerturbedModel {
  const Model<G>* model = nullptr;
  double step = 0;  ///< unit of p_i
};

/// S of the step factored, or the integrator's constant factor (beta' M + K_t at rest, joints of
/// the moment) with so many corrections.
struct StepFactor {
  bool frozen = false;
  int corrections = 1;
};

/// @throws std::invalid_argument as direct_sensitivity, and for a start in equilibrium
template <FrameGroup G>
SensitivityEnd semi_analytic_sensitivity(const Model<G>& model, const Tape<G>& tape,
                                         const std::vector<PerturbedModel<G>>& perturbed,
                                         const StepFactor& factor, const SensitivityAt<G>& at);

extern template SensitivityEnd semi_analytic_sensitivity(const Model<SE2>&, const Tape<SE2>&,
                                                         const std::vector<PerturbedModel<SE2>>&,
                                                         const StepFactor&,
                                                         const SensitivityAt<SE2>&);
extern template SensitivityEnd semi_analytic_sensitivity(const Model<SE3>&, const Tape<SE3>&,
                                                         const std::vector<PerturbedModel<SE3>>&,
                                                         const StepFactor&,
                                                         const SensitivityAt<SE3>&);

}  // namespace liesl
