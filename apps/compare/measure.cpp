#include "apps/compare/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "apps/output/interrupt.hpp"

namespace liesl {

namespace {

/// Stops a run that needs too much time, or when the program is asked to end.
class Watch {
 public:
  explicit Watch(double limit) : limit_(limit) {}
  Progress progress() {
    start_ = std::clock();
    return [this](double) {
      over_ = over_ || static_cast<double>(std::clock() - start_) > limit_ * CLOCKS_PER_SEC;
      return !over_ && output::interrupted() == 0;
    };
  }
  bool over() const { return over_; }

 private:
  double limit_;
  std::clock_t start_ = 0;
  bool over_ = false;
};

bool constant_tangent(const Scene& scene) {
  return tangent_strategy(scene.simulation.tangent, scene.mechanism.formalism) ==
         TangentStrategy::Constant;
}

void judge(const Scene& scene, const Watch& watch, Measured& run) {
  const Report& report = run.report;
  if (report.status != SolveStatus::Converged) {
    run.ending = Ending::Stopped;
    run.reason = watch.over() ? "needed more CPU time than time_limit" : report.reason;
  } else if (!run.series.values.allFinite()) {
    run.ending = Ending::Stopped;
    run.reason = "the response is not finite";
  } else {
    const long again =
        constant_tangent(scene) ? report.tangent_refreshes - report.tangent_renewals : 0;
    if (again + report.rejected_steps == 0) return;
    run.ending = Ending::Recovered;
    if (again > 0) run.reason = fmt::format("{} tangents refactorised", again);
    if (report.rejected_steps > 0)
      run.reason += fmt::format("{}{} steps halved", again > 0 ? ", " : "", report.rejected_steps);
  }
}

}  // namespace

const char* name_of(Ending ending) {
  return ending == Ending::Converged   ? "converged"
         : ending == Ending::Recovered ? "recovered"
                                       : "stopped";
}

template <FrameGroup G>
Measured measure(const Scene& scene, const Space<G>& space, const MeasureOptions& options) {
  Measured run;
  Watch watch(options.time_limit);
  {
    Model<G> model = Model<G>::build(scene.mechanism, space);
    const DynamicResult<G> result = simulate(model, scene.simulation, watch.progress());
    output::check_interrupt();
    run.report = result.report;
    run.series = output::record(options.response, scene.mechanism, model, result.trajectory);
    judge(scene, watch, run);
    if (options.repeats > 0 && run.ending != Ending::Stopped)
      run.drift = drift(scene.mechanism, model, result.trajectory);
  }
  std::vector<double> times;
  while (static_cast<int>(times.size()) < options.repeats && run.ending != Ending::Stopped) {
    Model<G> model = Model<G>::build(scene.mechanism, space);
    times.push_back(simulate(model, scene.simulation, watch.progress()).report.stepping_cpu_s);
    output::check_interrupt();
  }
  if (times.empty()) return run;
  std::sort(times.begin(), times.end());
  const std::size_t middle = times.size() / 2;
  run.cpu_s = times.size() % 2 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]);
  run.cpu_spread = run.cpu_s > 0 ? (times.back() - times.front()) / run.cpu_s : 0;
  return run;
}

template Measured measure(const Scene&, const Space<SE2>&, const MeasureOptions&);
template Measured measure(const Scene&, const Space<SE3>&, const MeasureOptions&);

}  // namespace liesl
