#pragma once
/// @file
/// The static problem of a design under the loads of its motion, whatever its parts are made of.

#include "optim/problems/combined_problem.hpp"
#include "optim/problems/design_run.hpp"
#include "optim/problems/solid_task.hpp"

namespace liesl {

/// The task of part k of the simulator's design with the loads of `run` as its cases, and the
/// outputs as the motion has them. @pre the simulator outlives the task
template <FrameGroup G>
SolidTask motion_task(const StudySpec& study, const DesignSimulator<G>& simulator, int k,
                      const DesignRun<G>& run);

/// Minimum mass under the loads of `run` within move limits about its design x: sections within
/// x (1 -+ move); outlines within `move` of the range of a variable, and within
/// study.cycle.move_cells cells at the first move limit, study.cycle.move_limit, less as `move`
/// shrinks. @pre everything outlives the problem
/// @param frequencies those of the study, terms of the objective with their size at x
template <FrameGroup G>
std::vector<CombinedProblem::Member> static_parts(
    const StudySpec& study, const DesignSimulator<G>& simulator, const DesignRun<G>& run,
    const Eigen::VectorXd& x, double move, const std::vector<FrequencyLimitSpec>& frequencies);

/// The same as one problem.
template <FrameGroup G>
std::unique_ptr<StaticProblem> motion_problem(const StudySpec& study,
                                              const DesignSimulator<G>& simulator,
                                              const DesignRun<G>& run, const Eigen::VectorXd& x,
                                              double move) {
  return combined(static_parts(study, simulator, run, x, move, study.frequencies));
}

extern template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE2>&, int,
                                      const DesignRun<SE2>&);
extern template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE3>&, int,
                                      const DesignRun<SE3>&);
extern template std::vector<CombinedProblem::Member> static_parts(
    const StudySpec&, const DesignSimulator<SE2>&, const DesignRun<SE2>&, const Eigen::VectorXd&,
    double, const std::vector<FrequencyLimitSpec>&);
extern template std::vector<CombinedProblem::Member> static_parts(
    const StudySpec&, const DesignSimulator<SE3>&, const DesignRun<SE3>&, const Eigen::VectorXd&,
    double, const std::vector<FrequencyLimitSpec>&);

}  // namespace liesl
