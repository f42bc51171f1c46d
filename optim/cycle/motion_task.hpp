#pragma once
/// @file
/// The static problem of a meshed part under the loads of a motion.

#include "optim/cycle/design_run.hpp"
#include "optim/cycle/solid_task.hpp"

namespace liesl {

/// The task of the simulator's part with the loads of `run` as its cases, and the outputs as the
/// motion has them. @pre simulator.part() is not null; the simulator outlives the task
template <FrameGroup G>
SolidTask motion_task(const StudySpec& study, const DesignSimulator<G>& simulator,
                      const DesignRun<G>& run);

extern template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE2>&,
                                      const DesignRun<SE2>&);
extern template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE3>&,
                                      const DesignRun<SE3>&);

}  // namespace liesl
