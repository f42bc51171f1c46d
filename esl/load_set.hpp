#pragma once
/// @file
/// Equivalent static loads of a part at every instant of the motion, in the nodal local frames. By
/// formalism: Lie group and R^3 x SO(3): the internal force, f = g_int(H) (thesis eq. 3.22);
/// classical: f = K_ref u with u in the corotational frame of each element (eq. 3.21);
/// floating: f = K_ff q_f (eq. 3.20).

#include <set>

#include "mbs/bodies/beam.hpp"
#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

struct LoadSet {
  int body = 0;
  std::vector<double> t;  ///< s, one a load case
  Eigen::MatrixXd f;      ///< dim * nodes x load cases; [N; N m] a node
};

/// The loads of one body at every record. Elastic part only: damping does no static work. That of
/// the last node of a chain of segments in space is in axes carried along it, which do not spin.
template <FrameGroup G>
LoadSet extract_loads(const Model<G>& model, const Trajectory<G>& trajectory, int body);

/// sum_n |f_n - g_n| / sum_n |g_n| over all parts (thesis eq. 3.25); moments are divided by
/// `length`. The sets must have the same bodies and instants.
/// @throws std::invalid_argument if they do not
double load_change(const std::vector<LoadSet>& f, const std::vector<LoadSet>& before, int dim,
                   int space_dim, double length);

/// Up to `count` load cases (columns) spread over time, and the one with the largest load.
std::set<int> spread_cases(const Eigen::MatrixXd& loads, int count);

/// How well the static problem of a part gives back its dynamic deformation: largest difference of
/// strain over the largest strain of all load cases tried. (Not of each case by itself: a rod that
/// bends little under an axial force N has an error of N L^2/(pi^2 EI) of that little bending.)
struct Identity {
  double nonlinear = 0;  ///< g_int(H_stat) = f_n solved in full: round-off
  double linear = 0;     ///< K_t u = f_n: first order in strain
  int cases = 0;         ///< tried
};

/// Solves the isolated part, held at its first node, under `cases` of its loads spread over time,
/// the largest among them, and compares strains (which no rigid motion changes) with the motion's.
template <FrameGroup G>
Identity check_identity(const Model<G>& model, const Trajectory<G>& trajectory,
                        const LoadSet& loads, int cases = 8);

extern template LoadSet extract_loads(const Model<SE2>&, const Trajectory<SE2>&, int);
extern template LoadSet extract_loads(const Model<SE3>&, const Trajectory<SE3>&, int);
extern template Identity check_identity(const Model<SE2>&, const Trajectory<SE2>&, const LoadSet&,
                                        int);
extern template Identity check_identity(const Model<SE3>&, const Trajectory<SE3>&, const LoadSet&,
                                        int);

}  // namespace liesl
