#pragma once
/// @file
/// From solver to writers: the states of a simulation as plain numbers in space.

#include "apps/output/results.hpp"
#include "apps/scene/scene.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

/// Everything that results.h5 and the tables hold of a simulation.
template <FrameGroup G>
output::Results collect(const Scene& scene, const Mechanism& mechanism, const Model<G>& model,
                        const Trajectory<G>& trajectory);

/// Only the named responses, over the records.
template <FrameGroup G>
std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>& responses,
                                                      const Mechanism& mechanism,
                                                      const Model<G>& model,
                                                      const Trajectory<G>& trajectory);

extern template output::Results collect(const Scene&, const Mechanism&, const Model<SE2>&,
                                        const Trajectory<SE2>&);
extern template output::Results collect(const Scene&, const Mechanism&, const Model<SE3>&,
                                        const Trajectory<SE3>&);
extern template std::vector<output::ResponseResult> collect_responses(
    const std::vector<ResponseSpec>&, const Mechanism&, const Model<SE2>&, const Trajectory<SE2>&);
extern template std::vector<output::ResponseResult> collect_responses(
    const std::vector<ResponseSpec>&, const Mechanism&, const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
