#pragma once
/// @file
/// Shape optimisation under loads that stay, in rounds: optimise, insert a hole where the
/// topological derivative says that one pays, optimise again. Experimental.

#include <memory>

#include "mbs/model/mechanism.hpp"
#include "optim/cycle/nucleation.hpp"
#include "optim/cycle/shape_cycle.hpp"
#include "optim/design/part_shape.hpp"

namespace liesl {

/// A hole that was tried.
struct HoleRound {
  int body = 0;
  std::string feature;  ///< "new_hole1"
  Nucleus nucleus;
  double before = 0, after = 0;  ///< objective
  int steps = 0;
  bool pays = false;  ///< kept: all limits are met and the objective fell by more than
                      ///< `cycle.objective_tolerance`
  std::string reason;
};

struct TopologyResult {
  std::unique_ptr<PartShape> part;  ///< with the holes that pay
  levelset::ShapeSpec outline;      ///< its tree at the final design
  ShapeResult shape;                ///< history: all steps of the rounds that pay
  std::size_t round = 0;            ///< where the last of them begins in the history
  std::vector<HoleRound> holes;     ///< all that were tried
  HoleProposal proposal;            ///< where the next hole would pay
};

struct TopologyHooks : ShapeHooks {
  std::function<void(const std::string& feature, const Nucleus&)> on_hole;
};

/// @param body whose outline the study changes  @param most holes to insert; 0: only propose
/// A hole that does not pay is taken out again and ends the rounds; so do an interruption and an
/// optimum without a proposal.
/// @throws std::invalid_argument as PartShape and solid_task do
TopologyResult optimise_topology(const StudySpec& study, const Mechanism& mechanism, int body,
                                 int most, const TopologyHooks& hooks = {});

}  // namespace liesl
