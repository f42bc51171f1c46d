#pragma once
/// @file
/// Consistent start: positions on the constraints, velocities along them, accelerations and
/// multipliers from the equations of motion.

#include "mbs/solvers/joint_system.hpp"
#include "mbs/solvers/options.hpp"
#include "mbs/solvers/report.hpp"

namespace liesl {

/// What had to be changed to make the start consistent.
struct InitialState {
  SolveStatus status = SolveStatus::Converged;
  std::string reason;
  double moved = 0;                    ///< largest displacement of a node, m
  double velocity_change = 0;          ///< largest change of a node's velocity, m/s
  std::vector<std::string> redundant;  ///< one sentence a redundant joint row
  std::vector<std::string> warnings;
};

/// Positions alone: nodes onto the constraints at time s.t (Newton,
/// least change in the metric M/step^2 + K), joint coordinates into s.rows. For statics.
template <FrameGroup G>
InitialState assemble(const Model<G>& model, double step, State<G>& s);

/// Assembles the positions (Newton, least change in the metric M/step^2 + K), projects the
/// velocities (least change in the metric M/duration^2 + K: as rigid as the joints allow), solves
/// for accelerations and multipliers. A repeated constraint that contradicts the others is
/// Inconsistent.
template <FrameGroup G>
InitialState make_consistent(const Model<G>& model, const SimulationOptions& options, State<G>& s);

extern template InitialState assemble(const Model<SE2>&, double, State<SE2>&);
extern template InitialState assemble(const Model<SE3>&, double, State<SE3>&);
extern template InitialState make_consistent(const Model<SE2>&, const SimulationOptions&,
                                             State<SE2>&);
extern template InitialState make_consistent(const Model<SE3>&, const SimulationOptions&,
                                             State<SE3>&);

}  // namespace liesl
