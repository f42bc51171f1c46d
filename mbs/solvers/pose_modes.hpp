#pragma once
/// @file
/// Natural frequencies of a mechanism in a pose, without weight, loads and the forces that springs
/// have there, and their derivatives.

#include <string>

#include "mbs/solvers/modes.hpp"
#include "mbs/system/parameter_residual.hpp"

namespace liesl {

struct PoseModes {
  State<SE3> pose;
  Eigen::VectorXd lambda;  ///< omega^2, rad^2/s^2, growing; motions that nothing holds left out
  Eigen::MatrixXd shapes;  ///< left-invariant increments of the nodes, phi^T M phi = 1
  std::string reason;      ///< why there are none; empty: there are
};

/// K phi + B^T nu = lambda M phi, B phi = 0, in space, where the drives have brought the bodies at
/// the time `at`, undeformed; K of bodies, springs and bushings, drives hold.
/// @param count how many of the lowest; fewer if there are fewer
PoseModes pose_modes(const Model<SE3>& model, const SimulationOptions& options, double at,
                     int count);

/// d lambda_i/dp = phi_i^T (K_p - lambda_i M_p) phi_i, of modes whose lambda is that of no other.
Eigen::VectorXd lambda_derivative(const Mechanism& mechanism, const Model<SE3>& model,
                                  const PoseModes& modes, const Parameter& parameter);

}  // namespace liesl
