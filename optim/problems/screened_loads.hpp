#pragma once
/// @file
/// Few of the loads of a motion, to be kept with its cycle.

#include "optim/problems/cycle_loads.hpp"
#include "optim/problems/design_run.hpp"

namespace liesl {

/// Instants of a part that are kept at most.
inline constexpr std::size_t kKeptLoads = 3;

/// Of each part with loads the record where the limit is largest that bounds the design most, and
/// those where the size of the loads has a maximum over time above half of its largest
/// (Treatment::Maxima), the largest of these, kKeptLoads in all. The size is the norm over the
/// points, moments divided by the length of the mechanism. Parts without loads are left out.
template <FrameGroup G>
std::vector<CycleLoads> screened_loads(const DesignRun<G>& run, int scenario);

extern template std::vector<CycleLoads> screened_loads(const DesignRun<SE2>&, int);
extern template std::vector<CycleLoads> screened_loads(const DesignRun<SE3>&, int);

}  // namespace liesl
