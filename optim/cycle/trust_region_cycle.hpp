#pragma once
/// @file
/// A cycle that ends at the optimum of the motion: static problems that agree with it to first
/// order, within trust regions (Alexandrov, Dennis, Lewis, Torczon 1998, "A trust-region framework
/// for managing the use of approximation models", Struct. Optim. 15; for loads of the design:
/// Stolpe, Pollini 2023).

#include <stdexcept>

#include "optim/cycle/cycle_record.hpp"

namespace liesl {

/// The motion cannot be differentiated.
struct NoSensitivities : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// From the design x_k, its simulation and its sensitivities:
///   minimise  m(x)/m_0 + sigma t  subject to  v^_rn(x)/limit_r - 1 <= t,  t >= 0,
///             |x - x_k| within the radius                          (corrected_problem.hpp)
/// and simulate the answer. It is taken if the merit phi = m/m_0 + sigma max(0, worst violation)
/// falls by a tenth of what was predicted; the radius follows the ratio. Ends Optimal if the KKT
/// conditions of the motion hold and no decrease is predicted that counts; Converged if only the
/// latter; Infeasible if limits are still exceeded then.
/// @throws NoSensitivities if the motion of the start has none: formalism, start moved by joints
template <FrameGroup G>
CycleResult<G> run_trust_region_cycle(const DesignSimulator<G>& simulator, const StudySpec& study,
                                      const CycleHooks& hooks, int bodies,
                                      const std::vector<Cycle>& resume = {});

extern template CycleResult<SE2> run_trust_region_cycle(const DesignSimulator<SE2>&,
                                                        const StudySpec&, const CycleHooks&, int,
                                                        const std::vector<Cycle>&);
extern template CycleResult<SE3> run_trust_region_cycle(const DesignSimulator<SE3>&,
                                                        const StudySpec&, const CycleHooks&, int,
                                                        const std::vector<Cycle>&);

}  // namespace liesl
