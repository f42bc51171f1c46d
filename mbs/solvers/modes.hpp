#pragma once
/// @file
/// Small oscillations about an equilibrium.

#include "mbs/solvers/statics.hpp"

namespace liesl {

/// K phi + B^T nu = omega^2 M phi, B phi = 0: K and B the tangent and the constraint gradients at
/// the equilibrium, M the constant mass matrices. No damping, no gyroscopic forces.
template <FrameGroup G>
struct ModesResult {
  State<G> equilibrium;            ///< t = load factor
  std::vector<double> omega;       ///< rad/s, growing; 0 = free motion or unstable
  std::vector<double> frequency;   ///< Hz
  std::vector<double> eigenvalue;  ///< omega^2, 1/s^2; negative = unstable equilibrium
  Eigen::MatrixXd shapes;          ///< columns: increments of the nodes [u; w] in local frames,
                                   ///< phi^T M phi = 1
  std::vector<double> residuals;   ///< |K phi + B^T nu - omega^2 M phi| / | |K| |phi| |
  Report report;
  InitialState start;
};

/// The first options.modes modes about the static equilibrium at options.max_load (solve_static);
/// the scene as given if it is in equilibrium already: then it may have free motions, which come as
/// modes of frequency 0. Small models by a dense null space of B, others by shift-invert Lanczos
/// (Spectra) on the saddle point. If the model has fewer modes, there are fewer. NotConverged,
/// Singular, Inconsistent: as solve_static; Singular too if M vanishes on a motion.
template <FrameGroup G>
ModesResult<G> solve_modes(const Model<G>& model, const SimulationOptions& options);

extern template ModesResult<SE2> solve_modes(const Model<SE2>&, const SimulationOptions&);
extern template ModesResult<SE3> solve_modes(const Model<SE3>&, const SimulationOptions&);

}  // namespace liesl
