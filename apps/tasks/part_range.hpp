#pragma once
/// @file
/// How far a body in a floating frame, a meshed part or a beam, goes beyond what it can describe:
/// its deformation is linear in its frame.

#include <map>
#include <string>
#include <vector>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// Over the records of a simulation.
struct PartRange {
  double bend = 0;   ///< largest turn of an interface or a node against the first, rad
  double euler = 0;  ///< largest compression over the Euler load; parts of two interfaces, beams
  double pull = 0;   ///< largest tension over it, at the first interface or in an element
  double spin = 0;   ///< largest (Omega_J/omega_1)^2; parts of one interface
};

/// Compression N = -d . f_1, f = K_e e the force on the second interface, d the direction from the
/// first to it. Euler load between hinges of a bar that is as soft across d as the part held at its
/// first interface, y = F L^3/(3 EI): P_E = pi^2 EI/L^2 = pi^2 L/(3 y/F). Tension is -N, with the
/// share of the first interface in the centrifugal force of a part that turns, m Omega^2 L/6 with
/// Omega = |Omega x d|; that of the second, m Omega^2 L/3, is in f_1.
///
/// A part of one interface has no force at another, and no turn of it. With Omega the angular
/// velocity of its frame and J its inertia about the interface, Omega_J^2 = Omega . J Omega over
/// the largest principal value of J: |Omega x d|^2 of a slender blade along d. omega_1 is its
/// lowest circular frequency held at the interface: what spins is stiffened by its tension, omega^2
/// = omega_1^2 + c Omega^2 with c from 0.2 (bending in the plane of rotation) to 1.2 (out of it), a
/// linear part is softened instead. Its turn is that of the end of a slender cantilever in its
/// first mode with the same r.m.s. of displacement over distance from the interface, 1.6 sqrt(e^T
/// M_e e / int rho r^2).
/// @param e coordinates of the part, a column a record
/// @param omega angular velocity of its frame in the axes of the first interface, likewise, rad/s
template <FrameGroup G>
PartRange part_range(const SolidBody<G>& body, const Eigen::MatrixXd& e,
                     const Eigen::MatrixXd& omega);

/// The same of the beams in floating frames, by body: turns of their nodes, normal forces of their
/// elements, the Euler load from the softness of the end held at the start.
template <FrameGroup G>
std::map<int, PartRange> beam_ranges(const Mechanism& mechanism, const Model<G>& model,
                                     const Trajectory<G>& trajectory);

/// A sentence for each bound that is passed: a tenth of the Euler load and of (Omega_J/omega_1)^2,
/// 0.15 rad.
std::vector<std::string> range_warnings(const std::string& part, int interfaces,
                                        const PartRange& range);
/// @pre body is a beam that is simulated as modal
std::vector<std::string> beam_range_warnings(const BodySpec& body, Formalism formalism,
                                             const PartRange& range);

extern template PartRange part_range(const SolidBody<SE2>&, const Eigen::MatrixXd&,
                                     const Eigen::MatrixXd&);
extern template PartRange part_range(const SolidBody<SE3>&, const Eigen::MatrixXd&,
                                     const Eigen::MatrixXd&);
extern template std::map<int, PartRange> beam_ranges(const Mechanism&, const Model<SE2>&,
                                                     const Trajectory<SE2>&);
extern template std::map<int, PartRange> beam_ranges(const Mechanism&, const Model<SE3>&,
                                                     const Trajectory<SE3>&);

}  // namespace liesl
