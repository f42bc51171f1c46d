#pragma once
/// @file
/// One run of a scene as figures: termination status, cost, conserved quantities.

#include "apps/compare/conserved.hpp"
#include "apps/output/series.hpp"
#include "apps/scene/scene.hpp"
#include "mbs/solvers/dynamics.hpp"

namespace liesl {

/// How a run ended.
enum class Ending {
  Converged,  ///< as asked for
  Recovered,  ///< with a tangent refactorised where it should be constant, or smaller steps
  Stopped     ///< before its end, with a reason
};
const char* name_of(Ending ending);

struct MeasureOptions {
  ResponseSpec response;   ///< what is recorded
  int repeats = 0;         ///< timed runs after the first; 0: no times, no drifts
  double time_limit = 60;  ///< s, CPU time of one run
};

struct Measured {
  Ending ending = Ending::Converged;
  std::string reason;     ///< why it stopped, or what it recovered by
  Report report;          ///< of the first run
  output::Series series;  ///< of the response
  Drift drift;
  double cpu_s = 0;       ///< median of the stepping alone
  double cpu_spread = 0;  ///< (longest - shortest) / median
};

/// Simulates a dynamic scene. Non-convergence is an ending; values are finite unless it stopped.
/// @throws output::Interrupted when the program is asked to end
template <FrameGroup G>
Measured measure(const Scene& scene, const Space<G>& space, const MeasureOptions& options);

extern template Measured measure(const Scene&, const Space<SE2>&, const MeasureOptions&);
extern template Measured measure(const Scene&, const Space<SE3>&, const MeasureOptions&);

}  // namespace liesl
