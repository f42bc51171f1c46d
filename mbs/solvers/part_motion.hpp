#pragma once
/// @file
/// What a meshed part does over a trajectory: its coordinates, and how fast they change.

#include <vector>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/solvers/trajectory.hpp"

namespace liesl {

/// e of a meshed part at every record, a column each: motions of the further ports, amplitudes.
/// @param first_node of the body in the model
template <FrameGroup G>
Eigen::MatrixXd part_coordinates(const SolidBody<G>& body, int first_node,
                                 const Trajectory<G>& trajectory);

/// S e with S^T S = K_e: signals [sqrt(J)] whose squares add up to twice the elastic energy,
/// whatever the units of e. They are the equivalent static loads of the part, f = K Psi e, in the
/// energy norm f^T K^-1 f.
template <FrameGroup G>
Eigen::MatrixXd energy_signals(const SolidBody<G>& body, const Eigen::MatrixXd& e);

/// The frequency [Hz] below which all but `share` of the power of signals (a row each) lies: the
/// power spectra of all rows are summed over the whole record under a Hann window,
///   w_n = sin^2(pi n/(N-1)),
/// so that a record that is no whole number of periods does not leak upwards. A tone of f gives f
/// to within 2/duration; what happens at the very ends counts little; nothing above half of the
/// rate of the records is seen. Constant signals give 0, within the same 2/duration.
/// @param t  times of the columns [s], increasing; values between them are linear  @pre share > 0
/// @returns 0 for less than three records and for signals that are zero
double bandwidth(const std::vector<double>& t, const Eigen::MatrixXd& signals, double share);

extern template Eigen::MatrixXd part_coordinates(const SolidBody<SE2>&, int,
                                                 const Trajectory<SE2>&);
extern template Eigen::MatrixXd part_coordinates(const SolidBody<SE3>&, int,
                                                 const Trajectory<SE3>&);
extern template Eigen::MatrixXd energy_signals(const SolidBody<SE2>&, const Eigen::MatrixXd&);
extern template Eigen::MatrixXd energy_signals(const SolidBody<SE3>&, const Eigen::MatrixXd&);

}  // namespace liesl
