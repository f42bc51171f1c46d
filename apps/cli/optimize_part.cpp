#ifdef LIESL_OPTIM

#include "apps/cli/optimize_part.hpp"

#include <fmt/format.h>

#include "apps/cli/describe_holes.hpp"
#include "apps/cli/part_files.hpp"
#include "apps/output/interrupt.hpp"
#include "optim/cycle/solid_task.hpp"
#include "optim/cycle/topology_cycle.hpp"
#include "optim/nlp/check_derivatives.hpp"

namespace liesl {
namespace {

struct Quantity {
  const char *name, *unit;
};

Quantity quantity(SolidResponse r) {
  switch (r) {
    case SolidResponse::Output:
      return {"displacement", "m"};
    case SolidResponse::Compliance:
      return {"compliance", "J"};
    case SolidResponse::Stress:
      return {"stress", "Pa"};
    case SolidResponse::Mass:
      return {"mass", "kg"};
    case SolidResponse::Frequency:
      return {"frequency", "Hz"};
  }
  return {"", ""};
}

void print_step(const ShapeStep& s, SolidResponse goal, bool quiet) {
  if (quiet) return;
  if (s.number == 1)
    fmt::print(" step     mass [kg] {:>15}   worst limit   cases   iterations\n",
               fmt::format("{} [{}]", quantity(goal).name, quantity(goal).unit));
  fmt::print("{:5} {:13.6g} {:15.7g} {:+13.3e} {:>7} {:>12}\n", s.number, s.check.mass,
             s.check.goal, s.check.worst, s.load_cases, s.iterations);
  std::fflush(stdout);
}

void describe_steps(output::OptimizeSummary& summary, SolidResponse goal,
                    const std::vector<ShapeStep>& history) {
  summary.history.clear();
  for (const auto& s : history) {
    const bool mass = goal == SolidResponse::Mass;
    summary.history.push_back({s.number, s.check.mass, s.check.worst, std::nullopt, s.load_cases,
                               s.iterations, 0, s.seconds,
                               mass ? std::nullopt : std::optional(s.check.goal)});
  }
  summary.mass_initial = history.front().check.mass;
  summary.mass_final = history.back().check.mass;
  summary.worst_constraint = history.back().check.worst;
}

void describe_limits(output::OptimizeSummary& summary, const SolidTask& task,
                     const ShapeResult& r) {
  const auto &first = r.history.front().check.limits, &last = r.history.back().check.limits;
  for (std::size_t i = 0; i < last.size(); ++i) {
    const bool wall = i >= task.limits.size();
    const Quantity q = wall ? Quantity{"wall", "-"} : quantity(task.limits[i].response);
    summary.constraints.push_back({last[i].name, q.name, q.unit, last[i].limit, first[i].value,
                                   last[i].value, 0, last[i].excess});
  }
}

void describe_result(output::OptimizeSummary& summary, const SolidTask& task,
                     const ShapeResult& r) {
  summary.status = to_string(r.status);
  summary.reason = r.reason;
  if (r.history.empty()) return;
  describe_steps(summary, task.goal, r.history);
  describe_limits(summary, task, r);
  summary.design = design_figures(task.design->variables(), task.design->units(), r.x);
  for (auto step = r.history.rbegin(); step != r.history.rend(); ++step)  // new holes come later
    for (Eigen::Index j = 0; j < std::min(step->x.size(), r.x.size()); ++j)
      summary.design[static_cast<std::size_t>(j)].initial = step->x[j];
  auto& more = summary.more;
  more["objective"] = {{"quantity", quantity(task.goal).name},
                       {"unit", quantity(task.goal).unit},
                       {"initial", r.history.front().check.goal},
                       {"final", r.history.back().check.goal}};
  more["kkt_residual"] = r.stationarity;
  more["load_cases"] = task.cases;
}

/// Since the last hole that was kept.
std::vector<Eigen::VectorXd> designs(const TopologyResult& r) {
  std::vector<Eigen::VectorXd> x;
  for (std::size_t i = r.round; i < r.shape.history.size(); ++i) x.push_back(r.shape.history[i].x);
  return x;
}

void print_result(const output::OptimizeSummary& s, const std::string& folder, bool quiet) {
  if (quiet) return;
  fmt::print("{}: {} after {} steps ({})\n", s.name, s.status, s.history.size(), s.reason);
  if (s.more.contains("objective")) {
    const auto& o = s.more["objective"];
    fmt::print(
        "  {} {:.7g} {} -> {:.7g} {}, mass {:.6g} kg -> {:.6g} kg, worst limit {:+.2e}, "
        "{:.3g} s\n",
        o["quantity"].get<std::string>(), o["initial"].get<double>(), o["unit"].get<std::string>(),
        o["final"].get<double>(), o["unit"].get<std::string>(), s.mass_initial, s.mass_final,
        s.worst_constraint, s.wall_s);
  }
  for (const auto& d : s.design)
    fmt::print("  {:<20} {:.6g} -> {:.6g} {}\n", d.name, d.initial, d.final, d.unit);
  fmt::print("results in {}; next: liesl plot {}\n", folder, folder);
}

}  // namespace

std::vector<output::DesignFigure> design_figures(const std::vector<NlpVariable>& variables,
                                                 const std::vector<std::string>& units,
                                                 const Eigen::VectorXd& x) {
  std::vector<output::DesignFigure> out;
  for (int j = 0; j < x.size(); ++j) {
    const auto& v = variables[static_cast<std::size_t>(j)];
    out.push_back({v.name, v.start, x[j], v.lower, v.upper, units[static_cast<std::size_t>(j)]});
  }
  return out;
}

int optimize_part(const Study& study, const CommandOptions& options, output::AtomicFolder& folder,
                  output::OptimizeSummary& summary, const Stopwatch& clock) {
  const int body = study.spec.shapes.begin()->first;
  const SolidResponse goal = study.spec.goal;
  TopologyHooks hooks;
  hooks.keep_going = [] { return output::interrupted() == 0; };
  hooks.on_step = [&](const std::vector<ShapeStep>& history) {
    print_step(history.back(), goal, options.quiet);
    output::OptimizeSummary so_far = summary;
    describe_steps(so_far, goal, history);
    so_far.status = "running";
    so_far.reason = fmt::format("{} steps so far", history.size());
    so_far.wall_s = clock.seconds();
    output::write_summary(folder.path() / "summary.json", output::to_json(so_far));
    folder.commit();
  };
  hooks.on_hole = [&](const std::string& feature, const Nucleus& n) {
    print_hole(feature, n, options.quiet);
  };
  const TopologyResult r =
      optimise_topology(study.spec, study.scene.mechanism, body, options.nucleate, hooks);
  const std::string& name = study.scene.mechanism.bodies[static_cast<std::size_t>(body)].name;
  const Holes holes{body_names(study.scene.mechanism),
                    r.holes,
                    r.proposal.nucleus,
                    body,
                    r.proposal.reason,
                    quantity(goal).unit};
  describe_result(summary, solid_task(study.spec, *r.part), r.shape);
  describe_holes(summary, holes);
  if (r.shape.x.size() > 0) {
    write_part(folder.path(), name, *r.part, designs(r),
               {r.shape.fractions, r.shape.displacements, r.shape.von_mises, r.proposal.gain,
                holes.unit + "/m^3"});
    write_outline(folder.path(), name, r.outline);
  }
  summary.wall_s = clock.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(summary));
  folder.commit();
  print_result(summary, options.out, options.quiet);
  if (!options.quiet) print_holes(holes, options.nucleate);
  return r.shape.status == CycleStatus::Converged ? 0 : 1;
}

int check_part_derivatives(const Study& study) {
  const auto& [body, spec] = *study.spec.shapes.begin();
  PartShape part(study.scene.mechanism, body, spec);
  const SolidTask task = solid_task(study.spec, part);
  StaticShape problem(task, part.design.start(), study.spec.cycle.move_cells,
                      study.spec.cycle.move_limit);
  if (!problem.obstacle().empty())
    throw std::runtime_error("the start design has no part: " + problem.obstacle());
  DerivativeCheckOptions options;
  options.every_variable = true;
  const DerivativeReport report = check_derivatives(problem, part.design.start(), options);
  fmt::print("{}", report.text());
  return report.right ? 0 : 1;
}

}  // namespace liesl

#endif
