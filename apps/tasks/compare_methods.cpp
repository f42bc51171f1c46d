#include <fmt/format.h>

#include <ctime>

#include "apps/tasks/compare.hpp"

#ifndef LIESL_OPTIM

#include "apps/output/io_error.hpp"

namespace liesl {

MeasuredMethod measure_method(const Comparison& comparison, const Study&) {
  throw output::without_optimisation("optimise", comparison.rows.of);
}

}  // namespace liesl

#else

#include "apps/output/interrupt.hpp"
#include "apps/tasks/optimize.hpp"

namespace liesl {

MeasuredMethod measure_method(const Comparison& comparison, const Study& study) {
  const std::clock_t begin = std::clock();
  const auto seconds = [begin] {
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  OptimizeHooks hooks;
  hooks.keep_going = [&] {
    return output::interrupted() == 0 && seconds() <= comparison.time_limit;
  };
  hooks.progress = [](double) { return output::interrupted() == 0; };
  const OptimizeOutcome out = optimize_task(study, choose_space(study.scene), {}, 0, hooks);
  output::check_interrupt();
  MeasuredMethod m;
  m.cpu_s = seconds();
  m.status = out.summary.status;
  m.reason = out.summary.reason;
  if (out.status == CycleStatus::Interrupted) {
    m.status = "stopped";
    m.reason = fmt::format("more than {:g} s of processor time", comparison.time_limit);
  }
  const int motions = 1 + static_cast<int>(study.scenarios.size());
  m.simulations = motions * static_cast<int>(out.summary.history.size());
  if (const auto& more = out.summary.more; more.contains("sensitivities"))
    m.sensitivities = more["sensitivities"].get<int>();
  if (!out.simulated) return m;
  m.mass = out.summary.mass_final;
  m.violation = out.summary.worst_constraint;
  if (const auto& kkt = out.summary.more["kkt_residual"]; kkt.is_number())
    m.kkt = kkt.get<double>();
  return m;
}

}  // namespace liesl

#endif
