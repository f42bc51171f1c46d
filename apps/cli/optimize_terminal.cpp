#ifdef LIESL_OPTIM

#include "apps/cli/optimize_terminal.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/terminal.hpp"

namespace liesl {

namespace {

/// A line a variable, numbers under each other.
void print_design(const std::vector<output::DesignFigure>& design) {
  std::size_t width = 0;
  for (const auto& d : design) width = std::max(width, d.name.size());
  for (const auto& d : design)
    fmt::print("  {:<{}} {:>12.6g} -> {:>12.6g} {}\n", d.name, width, d.initial, d.final, d.unit);
}

}  // namespace

void print_cycle(const Cycle& c, SolidResponse objective, bool quiet) {
  if (quiet) return;
  const bool other = objective != SolidResponse::Mass;
  const Quantity q = quantity(objective);
  if (c.number == 1)
    fmt::print(" cycle     mass [kg]{}   worst limit   load change   cases   iterations\n",
               other ? fmt::format(" {:>17}", fmt::format("{} [{}]", q.name, q.unit)) : "");
  const bool sized = c.load_cases > 0;  // the first, or the last, only simulates
  fmt::print("{:6} {:13.6g}{} {:>13} {:>13} {:>7} {:>12}\n", c.number, c.mass,
             other ? fmt::format(" {:17.7g}", c.objective) : "", signed_percent(c.worst),
             c.load_change ? size_percent(*c.load_change) : "-",
             sized ? std::to_string(c.load_cases) : "-",
             sized ? std::to_string(c.iterations) : "-");
  std::fflush(stdout);
}

void print_hole(const std::string& feature, const Nucleus& n, bool quiet) {
  if (quiet) return;
  fmt::print("      {} at ({:.4g}, {:.4g}, {:.4g}) m\n", feature, n.place[0], n.place[1],
             n.place[2]);
}

void print_holes(const Holes& holes, int most) {
  for (const HoleRound& h : holes.tried)
    fmt::print("  {} in '{}': {:.6g} {} -> {:.6g} {}, {}\n", h.feature,
               holes.bodies[std::size_t(h.body)], h.before, holes.unit, h.after, holes.unit,
               h.kept ? "kept" : "taken out again (" + h.reason + ")");
  if (const auto& n = holes.next)
    fmt::print(
        "  a hole in '{}' would reduce the objective at ({:.4g}, {:.4g}, {:.4g}) m, {:.4g} {} per "
        "m^3 at first "
        "(experimental): {}\n",
        holes.bodies[std::size_t(holes.body)], n->place[0], n->place[1], n->place[2], n->gain,
        holes.unit, most > 0 ? "--nucleate with a larger number" : "--nucleate inserts it");
  else if (!holes.reason.empty())
    fmt::print("  no hole is proposed: {}\n", holes.reason);
}

namespace {

/// " unit" of the objective, nothing of a number.
std::string unit_of_objective(const output::OptimizeSummary& s) {
  const auto unit = s.more["objective"]["unit"].get<std::string>();
  return unit == "-" ? "" : " " + unit;
}

/// " +- 2e-05", by mesh and step, if both are known.
std::string error_of(const nlohmann::ordered_json& objective) {
  if (!objective.contains("error")) return "";
  const auto& error = objective["error"];
  return fmt::format(" +- {:.2g}", error["mesh"].get<double>() + error.value("step", 0.0));
}

/// What a hundredth more of a limit is worth.
void print_price(const output::OptimizeSummary& s, const std::string& name, double price) {
  if (!s.more.contains("objective") || s.more["objective"]["quantity"] == "mass")
    fmt::print("  {}: 1 % more allowed saves {:.3g} g\n", name, 10 * price);
  else
    fmt::print("  {}: 1 % more allowed saves {:.3g}{}\n", name, 0.01 * price, unit_of_objective(s));
}

}  // namespace

void print_result(const output::OptimizeSummary& s, const std::string& folder, bool quiet) {
  if (quiet) return;
  fmt::print("{}: {} after {} cycles ({})\n", s.name, s.status, s.history.size(), s.reason);
  if (s.more.contains("objective") && s.more["objective"]["quantity"] != "mass") {
    const auto& o = s.more["objective"];
    const std::string unit = unit_of_objective(s);
    fmt::print("  {} {:.7g}{} -> {:.7g}{}{}\n", o["quantity"].get<std::string>(),
               o["initial"].get<double>(), unit, o["final"].get<double>(), error_of(o), unit);
  }
  const std::string error =
      s.more.contains("worst_constraint_error")
          ? fmt::format(" +- {:.2g} %", 100 * s.more["worst_constraint_error"].get<double>())
          : "";
  if (s.mass_initial > 0)
    fmt::print("  mass {:.6g} kg -> {:.6g} kg ({}), worst limit {}{}, {:.3g} s\n", s.mass_initial,
               s.mass_final, signed_percent(s.mass_final / s.mass_initial - 1),
               signed_percent(s.worst_constraint), error, s.wall_s);
  else
    fmt::print("  no design was analysed, {:.3g} s\n", s.wall_s);
  const std::string kkt = s.more.value("kkt", "not checked");
  if (s.reason.find(kkt) == std::string::npos) fmt::print("  KKT conditions: {}\n", kkt);
  if (s.more.contains("prices"))
    for (const auto& [name, price] : s.more["prices"].items()) print_price(s, name, price);
  print_design(s.design);
  for (const auto& w : s.warnings) fmt::print("  note: {}\n", w);
  print_folder(folder);
}

}  // namespace liesl

#endif
