#include "optim/nlp/result.hpp"

#include <fmt/format.h>

namespace liesl {

const char* to_string(NlpStatus status) {
  switch (status) {
    case NlpStatus::Converged:
      return "converged";
    case NlpStatus::Acceptable:
      return "acceptable";
    case NlpStatus::IterationLimit:
      return "iteration limit";
    case NlpStatus::Infeasible:
      return "infeasible";
    case NlpStatus::Stopped:
      return "stopped";
  }
  return "unknown";
}

std::vector<std::string> NlpOptions::errors() const {
  std::vector<std::string> list;
  const auto expect = [&list](bool ok, const char* name, const char* range, double got) {
    if (!ok) list.push_back(fmt::format("{}: expected {}, got {}", name, range, got));
  };
  const auto fraction = [](double v) { return v > 0 && v < 1; };
  expect(max_iterations >= 1, "max_iterations", ">= 1", max_iterations);
  expect(fraction(tolerance), "tolerance", "in (0, 1)", tolerance);
  expect(fraction(feasibility), "feasibility", "in (0, 1)", feasibility);
  expect(acceptable >= tolerance && acceptable < 1, "acceptable", "in [tolerance, 1)", acceptable);
  expect(time_limit > 0, "time_limit", "> 0 s", time_limit);
  expect(fraction(warm_barrier), "warm_barrier", "in (0, 1)", warm_barrier);
  return list;
}

std::string NlpResult::brief() const {
  return fmt::format(
      "{}: {} | f = {:.10g}, violation {:.1e}, stationarity {:.1e} | {} iterations, {} "
      "evaluations, "
      "{:.3g} s",
      to_string(status), reason, f, violation, stationarity, iterations, evaluations, time);
}

}  // namespace liesl
