#pragma once
/// @file
/// Energy and momentum of a mechanism at a state, and the power that acts on it.

#include "mbs/system/equations.hpp"

namespace liesl {

/// Energies of a state, J: kinetic and gravity's potential of the bodies; elastic that of the
/// bodies, sum of L eps^T K eps / 2 or of e^T K_e e / 2, and of the springs, k (q - q_0)^2 / 2.
/// Every energy of a mechanism that is reported, compared or limited is this one.
/// @param s completed (Model::complete), with the coordinates q of the couplings
template <FrameGroup G>
BodyEnergy mechanical_energy(const Model<G>& model, const State<G>& s);

inline double total(const BodyEnergy& e) { return e.kinetic + e.elastic + e.potential; }

/// Power that drives, loads, actuators, dampers and the damping of bodies put into the mechanism,
/// W; damping takes it out:
///   P = -sum lambda df/dt + sum (F(t) - c dq/dt) dq/dt - r_load . v - sum D_body.
/// Damping of penalties takes more out, see PenaltyWork.
/// With d(mechanical energy)/dt = P, and + ds/dt times `weight_potential` where gravity has a
/// factor s(t).
/// @param eq workspace; its residual is overwritten
template <FrameGroup G>
double power(const Model<G>& model, Equations<G>& eq, const State<G>& s);

/// Potential of the weight at a factor of gravity of 1, J. From one state to the next a changing
/// factor s puts (s_1 - s_0) (V_0 + V_1)/2 into the mechanism, also where ds/dt jumps.
template <FrameGroup G>
double weight_potential(const Model<G>& model, const State<G>& s);

/// Momentum of a state about the origin, [linear; angular] in the axes of the model: N s, N m s.
/// It is the derivative of the kinetic energy by rigid velocities of the whole mechanism, and the
/// same for every formalism; the energy is quadratic in the velocities, so that its central
/// difference is exact.
/// @param s completed (Model::complete)
template <FrameGroup G>
typename G::Tangent momentum(const Model<G>& model, const State<G>& s);

extern template BodyEnergy mechanical_energy(const Model<SE2>&, const State<SE2>&);
extern template BodyEnergy mechanical_energy(const Model<SE3>&, const State<SE3>&);
extern template double weight_potential(const Model<SE2>&, const State<SE2>&);
extern template double weight_potential(const Model<SE3>&, const State<SE3>&);
extern template double power(const Model<SE2>&, Equations<SE2>&, const State<SE2>&);
extern template double power(const Model<SE3>&, Equations<SE3>&, const State<SE3>&);
extern template SE2::Tangent momentum(const Model<SE2>&, const State<SE2>&);
extern template SE3::Tangent momentum(const Model<SE3>&, const State<SE3>&);

}  // namespace liesl
