#include "optim/cycle/cycle_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace liesl {
namespace {

constexpr double kStuck = 1e-6;      // relative change of a design that counts as none
constexpr double kFixedPoint = 0.1;  // change of a design, of the tolerance, that ends the cycle
constexpr double kShrinks = 0.7;     // of a change of mass since the last but one

}  // namespace

const char* to_string(CycleStatus status) {
  switch (status) {
    case CycleStatus::Optimal:
      return "optimal";
    case CycleStatus::Converged:
      return "converged";
    case CycleStatus::CycleLimit:
      return "cycle limit";
    case CycleStatus::Oscillating:
      return "oscillating";
    case CycleStatus::Infeasible:
      return "infeasible";
    case CycleStatus::SimulationFailed:
      return "simulation failed";
    case CycleStatus::Inaccurate:
      return "inaccurate";
    case CycleStatus::Interrupted:
      return "interrupted";
  }
  return "";
}

std::optional<CycleStatus> cycle_status(const std::string& word) {
  for (int s = 0; s <= static_cast<int>(CycleStatus::Interrupted); ++s)
    if (word == to_string(static_cast<CycleStatus>(s))) return static_cast<CycleStatus>(s);
  return {};
}

double step_size(const Cycle& c, const Eigen::VectorXd& y) {
  if (c.unit.size() > 0) return (y - c.x).cwiseQuotient(c.unit).norm();
  return (y - c.x).norm() / c.x.norm();
}

std::optional<CycleEnd> agreement(const History& h, const CycleOptions& o) {
  if (h.size() < 2) return {};
  const Cycle &now = h.back(), &before = h[h.size() - 2];
  const double change = std::abs(now.objective - before.objective);
  if (!now.load_change || *now.load_change >= o.tolerance || now.worst > o.feasibility ||
      change > o.objective_tolerance * now.objective)
    return {};
  return CycleEnd{CycleStatus::Converged, fmt::format("loads changed by {:.2g}, mass by {:.2g}",
                                                      *now.load_change, change / before.objective)};
}

std::optional<CycleEnd> used_up(const History& h, const CycleOptions& o) {
  if (h.back().number <= o.max) return {};
  std::string reason = fmt::format("cycle.max = {} designs after the first are used up", o.max);
  if (const auto change = h.back().load_change; change && *change > 0)
    reason += fmt::format("; loads still changed by {:.2g}", *change);
  return CycleEnd{CycleStatus::CycleLimit, reason};
}

bool oscillates(const History& h, const CycleOptions& o) {
  if (h.size() < 4) return false;
  const auto change = [&](size_t back) {
    return h[h.size() - back].objective - h[h.size() - back - 1].objective;
  };
  return change(1) * change(2) < 0 && change(2) * change(3) < 0 &&
         std::abs(change(1)) > kShrinks * std::abs(change(3)) &&
         std::abs(change(1)) > o.objective_tolerance * h.back().objective;
}

std::optional<CycleEnd> fixed_point(const Cycle& cycle, const CycleOptions& o) {
  if (cycle.worst > o.feasibility || cycle.answer.size() == 0) return {};
  const double change = step_size(cycle, cycle.answer);
  if (change > kFixedPoint * o.tolerance) return {};
  return CycleEnd{
      CycleStatus::Converged,
      fmt::format("the static optimum under the loads is the design itself within {:.2g}", change)};
}

std::optional<CycleEnd> stuck(const Cycle& cycle, const CycleOptions& o) {
  if (cycle.worst <= o.feasibility || cycle.next.size() == 0) return {};
  if (step_size(cycle, cycle.next) > kStuck) return {};
  const std::string stays = cycle.worst < 10 ? fmt::format("{:.3g} % above", 100 * cycle.worst)
                                             : fmt::format("at {:.3g} times", 1 + cycle.worst);
  return CycleEnd{CycleStatus::Infeasible,
                  fmt::format("'{}' cannot be met within the bounds: it stays {} its limit{}; "
                              "widen the bounds or the limit",
                              cycle.worst_constraint, stays,
                              cycle.worst_at.empty() ? "" : " at " + cycle.worst_at)};
}

bool on_move_limit(const Cycle& cycle, const std::vector<NlpVariable>& variables) {
  for (int i = 0; i < cycle.answer.size(); ++i) {
    const double unit = cycle.unit.size() > 0 ? cycle.unit[i] : cycle.x[i];
    const double lower = cycle.lower[i], upper = cycle.upper[i];
    if (lower > variables[i].lower && cycle.answer[i] < lower + kStuck * unit) return true;
    if (upper < variables[i].upper && cycle.answer[i] > upper - kStuck * unit) return true;
  }
  return false;
}

Eigen::VectorXd next_design(const History& h, const std::vector<NlpVariable>& variables) {
  const Cycle& now = h.back();
  if (h.size() < 2 || on_move_limit(now, variables) || on_move_limit(h[h.size() - 2], variables))
    return now.answer;
  const Cycle& before = h[h.size() - 2];
  const auto in_units = [&now](const Eigen::VectorXd& d) -> Eigen::VectorXd {
    return now.unit.size() > 0 ? Eigen::VectorXd(d.cwiseQuotient(now.unit)) : d;
  };
  const Eigen::VectorXd change = in_units(now.answer - now.x);
  const Eigen::VectorXd difference = change - in_units(before.answer - before.x);
  const double size = difference.squaredNorm();
  const double theta = size > 0 ? change.dot(difference) / size : 0;
  Eigen::VectorXd next = now.answer;
  if (theta > -2 && theta < 0.5) next -= theta * (now.answer - before.answer);
  for (int i = 0; i < next.size(); ++i)
    next[i] = std::clamp(next[i], variables[i].lower, variables[i].upper);
  return next;
}

}  // namespace liesl
