#include "apps/lean/lean_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace liesl {

double LeanRuns::distance(const Setting& s, const Setting& from) {
  const Trial &a = trial(s), &b = trial(from);
  return a.ok && b.ok ? relative_distance(a.series, b.series)
                      : std::numeric_limits<double>::infinity();
}

std::string LeanRuns::verdict(const Setting& s) {
  if (!trial(s).ok) return "does not run";
  return whole_steps(s) ? percent(error(s)) : "steps have to be halved";
}

void LeanRuns::decide(Decision decision) {
  on_decision_(decision);
  result.decisions.push_back(std::move(decision));
}

LeanResult LeanRuns::finish(LeanStatus status, const std::string& reason) {
  result.status = status;
  result.reason = reason;
  result.runs = trials_.runs();
  result.changes = changes(lean, result.given);
  result.lean = lean;
  return result;
}

std::string percent(double x) { return std::isfinite(x) ? fmt::format("{:.3g} %", 100 * x) : "-"; }

std::string text_of(const Setting& s) {
  std::string text = s.steps > 0 ? fmt::format("{} steps of {:.4g} s", s.steps, s.step()) : "";
  for (const auto& beam : s.beams) {
    text += fmt::format("{}{} ", text.empty() ? "" : ", ", beam.name);
    text += beam.rigid
                ? "rigid"
                : fmt::format("{} {}{}", beam.elements, beam.segments ? "segment" : "element",
                              beam.elements == 1 ? "" : "s");
    if (beam.order != 2 && !beam.rigid) text += fmt::format(" of order {}", beam.order);
    if (beam.modes >= 0) text += fmt::format(" in {} modes", beam.modes);
  }
  return text.empty() ? "nothing to refine" : text;
}

const char* to_string(LeanStatus status) {
  switch (status) {
    case LeanStatus::Done:
      return "done";
    case LeanStatus::Missed:
      return "tolerance missed";
    case LeanStatus::NotConverged:
      return "not converged";
    case LeanStatus::Failed:
      return "simulation failed";
  }
  return "";
}

}  // namespace liesl
