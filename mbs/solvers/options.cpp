#include "mbs/solvers/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace liesl {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a number may be: an interval, the lower end with or without.
struct Range {
  double low = 0, high = kInfinity;
  bool open = false;  ///< without the lower end
  const char* unit = "";

  bool holds(double x) const {
    return std::isfinite(x) && (open ? x > low : x >= low) && x <= high;
  }
  std::string text() const {
    const std::string lower = fmt::format("{} {:g}", open ? "above" : "of at least", low);
    const std::string upper = high < kInfinity ? fmt::format(" and at most {:g}", high) : "";
    return fmt::format("a number {}{}{}{} is expected", lower, upper, *unit ? " " : "", unit);
  }
};

constexpr Range kSeconds{0, kInfinity, true, "s"};
constexpr Range kCount{1, std::numeric_limits<int>::max()};

}  // namespace

std::vector<std::string> SimulationOptions::errors() const {
  const struct {
    const char* key;
    double value;
    Range range;
  } rows[] = {
      {"duration", duration, kSeconds},
      {"step", step, kSeconds},
      {"rho_inf", rho_inf, {0, 1}},
      {"tolerance", tolerance, {0, 1e-2, true}},
      {"max_iterations", static_cast<double>(max_iterations), {3, 100}},
      {"error_tolerance", error_tolerance, {0, 1, true}},
      {"step_min", step_min, {0, kInfinity, false, "s"}},
      {"output_every", static_cast<double>(output_every), kCount},
      {"at", at, {0, kInfinity, false, "s"}},
      {"load_steps", static_cast<double>(load_steps), kCount},
      {"max_load", max_load, {0, kInfinity, true}},
      {"modes", static_cast<double>(modes), kCount},
  };
  std::vector<std::string> problems;
  for (const auto& row : rows)
    if (!row.range.holds(row.value))
      problems.push_back(
          fmt::format("simulation.{}: {}, not {:g}", row.key, row.range.text(), row.value));
  if (type != SimulationType::Dynamic || !problems.empty()) return problems;
  if (step > duration)
    problems.push_back(fmt::format(
        "simulation.step: a step of at most the duration, {:g} s, is expected, not {:g}", duration,
        step));
  if (step_min > step)
    problems.push_back(fmt::format(
        "simulation.step_min: a step of at most simulation.step, {:g} s, is expected, not {:g}",
        step, step_min));
  return problems;
}

void SimulationOptions::require_valid() const {
  if (const auto problems = errors(); !problems.empty())
    throw std::invalid_argument(fmt::format("{}", fmt::join(problems, "\n")));
}

}  // namespace liesl
