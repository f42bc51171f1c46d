#include <fmt/format.h>

#include "apps/cli/command.hpp"

#ifndef LIESL_OPTIM

#include "apps/output/io_error.hpp"

namespace liesl {

int optimize_command(const CommandOptions& options) {
  throw output::IoError(
      "optimise", options.file,
      "this build has no optimisation; configure with -DLIESL_OPTIM=ON (needs Ipopt and NLopt)");
}

}  // namespace liesl

#else

#include "apps/cli/checkpoint.hpp"
#include "apps/cli/describe_holes.hpp"
#include "apps/cli/optimize_part.hpp"
#include "apps/cli/part_files.hpp"
#include "apps/cli/part_summary.hpp"
#include "apps/cli/run_summary.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/csv_writer.hpp"
#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/write_results.hpp"
#include "apps/scene/problem.hpp"
#include "apps/scene/study.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/cycle/derivative_check.hpp"
#include "optim/cycle/motion_topology.hpp"

namespace liesl {
namespace {

void describe_cycles(output::OptimizeSummary& summary, const std::vector<Cycle>& history) {
  summary.history.clear();
  for (const auto& c : history)
    summary.history.push_back(
        {c.number, c.mass, c.worst, c.load_change, c.load_cases, c.iterations, c.move, c.seconds});
}

std::vector<output::ResponseResult> series(const std::vector<LimitSeries>& limits,
                                           const Mechanism& mechanism, const StudySpec& spec) {
  std::vector<output::ResponseResult> out;
  for (size_t i = 0; i < limits.size(); ++i)
    out.push_back(
        {limits[i].name, unit(spec.constraints[i].response, mechanism), 1, limits[i].values});
  return out;
}

void write_series(const std::filesystem::path& path, const std::vector<double>& times,
                  std::vector<output::ResponseResult> responses, const Scene& scene) {
  output::Results r;
  r.times = times;
  if (scene.simulation.type != SimulationType::Dynamic) {
    r.abscissa = "load_factor";
    r.abscissa_unit = "-";
  }
  r.responses = std::move(responses);
  output::write_responses_csv(path, r);
}

std::vector<output::DesignRow> design_rows(const Sizing& sizing, const Mechanism& mechanism,
                                           const Eigen::VectorXd& x) {
  std::vector<output::DesignRow> rows;
  for (int i = 0; i < sizing.size(); ++i)
    for (const auto& at : sizing.elements(i)) {
      const auto& beam = std::get<BeamSpec>(mechanism.bodies[at.body].kind);
      double s = 0;
      for (int e = 0; e < at.element; ++e) s += element_length(beam, e);
      const auto& v = sizing.variables()[i];
      rows.push_back({v.name, mechanism.bodies[at.body].name, at.element, s,
                      s + element_length(beam, at.element), v.start, x[i], v.lower, v.upper, "m"});
    }
  return rows;
}

template <FrameGroup G>
void describe_result(output::OptimizeSummary& summary, const Study& study, const Design& design,
                     const CycleResult<G>& r) {
  describe_cycles(summary, r.history);
  summary.status = to_string(r.status);
  summary.reason = r.reason;
  summary.steps = static_cast<int>(r.steps);
  summary.newton_iterations = r.newton_iterations;
  summary.stepping_s = r.stepping_s;
  summary.mass_initial = r.mass_initial;
  summary.mass_final = r.mass;
  summary.worst_constraint = r.worst;
  summary.load_change = r.load_change;
  const auto& bodies = study.scene.mechanism.bodies;
  for (size_t b = 0; b < r.factorizations.size(); ++b)
    summary.factorizations.emplace_back(bodies[b].name, r.factorizations[b]);
  summary.design = design_figures(design.variables(), design.units(), r.x);
  for (size_t i = 0; i < r.final.size(); ++i) {
    const auto& spec = study.spec.constraints[i].response;
    summary.constraints.push_back(
        {r.final[i].name, name_of(spec.kind), unit(spec, study.scene.mechanism), r.final[i].limit,
         i < r.initial.size() ? r.initial[i].largest : 0, r.final[i].largest, r.final[i].at_time,
         r.final[i].largest / r.final[i].limit - 1});
  }
  auto& identity = summary.more["identity"] = nlohmann::ordered_json::object();
  for (const auto& [body, id] : r.identity)
    identity[bodies[body].name] = {
        {"nonlinear", id.nonlinear}, {"linear", id.linear}, {"cases", id.cases}};
  const KktResidual* kkt =
      r.optimality && r.optimality->residual ? &*r.optimality->residual : nullptr;
  summary.more["kkt_residual"] = kkt ? nlohmann::json(kkt->stationarity) : nlohmann::json(nullptr);
  summary.more["kkt"] = r.optimality ? r.optimality->brief() : "not checked";
  summary.warnings.insert(summary.warnings.end(), r.warnings.begin(), r.warnings.end());
}

void print_cycle(const Cycle& c, bool quiet) {
  if (quiet) return;
  if (c.number == 1)
    fmt::print(" cycle     mass [kg]   worst limit   load change   cases   iterations\n");
  const bool sized = c.next.size() > 0;  // the last cycle only confirms
  fmt::print("{:6} {:13.6g} {:+13.3e} {:>13} {:>7} {:>12}\n", c.number, c.mass, c.worst,
             c.load_change ? fmt::format("{:.3e}", *c.load_change) : "-",
             sized ? std::to_string(c.load_cases) : "-",
             sized ? std::to_string(c.iterations) : "-");
  std::fflush(stdout);
}

/// New holes of a study, which is `study` with those that stayed.
template <FrameGroup G>
Holes holes_of(const MotionTopology<G>& rounds, const Study& study) {
  const CycleResult<G>& end = rounds.cycle;
  Holes holes{body_names(study.scene.mechanism), rounds.holes, {}, 0, "", "kg"};
  if (rounds.next) {
    holes.next = rounds.next->hole.nucleus;
    holes.body = rounds.next->body;
  } else if (end.status == CycleStatus::Interrupted) {
    holes.reason = end.reason;
  } else if (!rounds.holes.empty() && !rounds.holes.back().pays) {
    holes.reason = "'" + rounds.holes.back().feature + "', the last one tried, does not pay";
  } else if (end.status != CycleStatus::Converged) {
    holes.reason = "there is no converged cycle to start from";
  } else if (end.proposals.empty()) {
    holes.reason = "no part whose outline changes counts in the objective";
  } else {
    holes.reason = end.proposals.front().hole.reason;
  }
  return holes;
}

/// What is left of part k, whose outline the study changed.
template <FrameGroup G>
void write_part_of(const Design& design, int k, const Study& study, const CycleResult<G>& r,
                   const std::filesystem::path& folder) {
  PartShape& part = design.part(k);
  std::vector<Eigen::VectorXd> history;
  for (const auto& c : r.history) history.push_back(design.of_part(k, c.x));
  if (r.history.back().x != r.x) history.push_back(design.of_part(k, r.x));
  const BodySpec& final = r.mechanism.bodies[static_cast<std::size_t>(part.body)];
  PartFields fields =
      fields_of_motion(study.spec, part, design.of_part(k, r.x), *r.model, r.simulation.trajectory);
  for (const PartProposal& p : r.proposals)
    if (p.body == part.body) {
      fields.hole_gain = p.hole.gain;
      fields.gain_unit = "kg/m^3";
    }
  write_part(folder, final.name, part, history, fields);
  write_outline(folder, final.name, std::get<SolidSpec>(final.kind).outline);
}

/// All that a study of a motion leaves behind. `sizing` is that of the start.
template <FrameGroup G>
void write_end(const Study& study, const Sizing& sizing, const Design& design,
               const CycleResult<G>& r, const std::filesystem::path& folder,
               output::OptimizeSummary& summary) {
  const Scene& scene = study.scene;
  output::Results results = collect(scene, r.mechanism, *r.model, r.simulation.trajectory);
  output::write_results(folder, results);
  describe_responses(summary, results);
  describe_parts(summary, r.mechanism, *r.model, r.simulation.trajectory,
                 scene.simulation.type == SimulationType::Dynamic);
  write_series(folder / "responses_initial.csv", r.times_initial,
               series(r.initial, scene.mechanism, study.spec), scene);
  write_series(folder / "responses_final.csv", r.times,
               series(r.final, scene.mechanism, study.spec), scene);
  if (sizing.size() > 0)
    output::write_design_csv(folder / "design.csv", design_rows(sizing, scene.mechanism, r.x));
  for (int k = 0; k < design.parts(); ++k) write_part_of(design, k, study, r, folder);
}

template <FrameGroup G>
int optimize_on(const Study& given, const Space<G>& space, const CommandOptions& options,
                output::AtomicFolder& folder, output::OptimizeSummary& summary,
                const std::vector<Cycle>& resume, Holes& holes, const Stopwatch& clock) {
  const Scene& scene = given.scene;
  const Design first(given.spec, scene.mechanism);
  bool with_holes = false;
  CycleHooks hooks;
  output::Progress line(
      "simulating",
      scene.simulation.type == SimulationType::Dynamic ? scene.simulation.duration
                                                       : scene.simulation.max_load,
      scene.simulation.type == SimulationType::Dynamic ? "s" : "load", options.quiet);
  const Progress progress = watch(line);
  hooks.progress = progress;
  hooks.keep_going = [] { return output::interrupted() == 0; };
  hooks.on_cycle = [&](const std::vector<Cycle>& history) {
    line.clear();
    print_cycle(history.back(), options.quiet);
    output::OptimizeSummary so_far = summary;
    describe_cycles(so_far, history);
    so_far.status = "running";
    so_far.reason = fmt::format("{} cycles so far; go on with --resume", history.size());
    so_far.mass_initial = history.front().mass;
    so_far.mass_final = history.back().mass;
    so_far.worst_constraint = history.back().worst;
    so_far.wall_s = clock.seconds();
    if (!with_holes)  // a checkpoint does not tell of them
      write_checkpoint(folder.path() / "checkpoint.json", history, summary.input_sha256);
    output::write_summary(folder.path() / "summary.json", output::to_json(so_far));
    folder.commit();
  };
  const auto on_hole = [&](const std::string& feature, const Nucleus& n) {
    with_holes = true;
    print_hole(feature, n, options.quiet);
  };
  const MotionTopology<G> rounds =
      optimise_motion_topology<G>(scene.mechanism, space, scene.simulation, given.spec,
                                  options.nucleate, hooks, on_hole, resume);
  Study study = given;  // with the holes that stayed
  study.spec = rounds.study;
  study.scene.mechanism = rounds.mechanism;
  const Design design(study.spec, study.scene.mechanism);
  describe_result(summary, study, design, rounds.cycle);
  for (auto& figure : summary.design)
    for (const NlpVariable& v : first.variables())
      if (v.name == figure.name) figure.initial = v.start;
  if (design.parts() > 0) describe_holes(summary, holes = holes_of(rounds, study));
  if (rounds.cycle.model)
    write_end(study, first.sizing(), design, rounds.cycle, folder.path(), summary);
  summary.wall_s = clock.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(summary));
  folder.commit();
  return rounds.cycle.status == CycleStatus::Converged ? 0 : 1;
}

void print_result(const output::OptimizeSummary& s, const std::string& folder, bool quiet) {
  if (quiet) return;
  fmt::print("{}: {} after {} cycles ({})\n", s.name, s.status, s.history.size(), s.reason);
  fmt::print("  mass {:.6g} kg -> {:.6g} kg, worst limit {:+.2e}, {:.3g} s\n", s.mass_initial,
             s.mass_final, s.worst_constraint, s.wall_s);
  fmt::print("  optimality conditions of the motion: {}\n", s.more["kkt"].get<std::string>());
  for (const auto& d : s.design)
    fmt::print("  {:<20} {:.6g} -> {:.6g} {}\n", d.name, d.initial, d.final, d.unit);
  for (const auto& w : s.warnings) fmt::print("  note: {}\n", w);
  fmt::print("results in {}; next: liesl plot {}\n", folder, folder);
}

template <FrameGroup G>
int check_derivatives_of(const Study& study, const Space<G>& space) {
  const DerivativeReport report =
      check_study_derivatives<G>(study.scene.mechanism, space, study.scene.simulation, study.spec);
  fmt::print("{}", report.text());
  return report.right ? 0 : 1;
}

}  // namespace

int optimize_command(const CommandOptions& options) {
  const Stopwatch clock;
  const Study study = load_study(options.file, options.set);
  if (study.scene.simulation.type == SimulationType::Modes)
    throw InputError(
        {{study.scene.file, 0, 0, "simulation.type = \"modes\" has no loads to size a part for",
          "\"dynamic\" or \"static\"", ""}});
  const bool fixed_loads = !study.spec.loads.empty();
  const ChosenSpace space = choose_space(study.scene);
  if (options.check_derivatives && fixed_loads) return check_part_derivatives(study);
  if (options.check_derivatives)
    return std::visit([&](const auto& s) { return check_derivatives_of(study, s); }, space.space);

  if (options.nucleate > 0 && study.spec.shapes.empty())
    throw InputError({{study.file, 0, 0, "--nucleate: the study changes no outline",
                       "a study with variables of a meshed part", "run without --nucleate"}});
  if (options.nucleate > 0 && options.resume)
    throw InputError({{study.file, 0, 0, "--nucleate: rounds with new holes are not resumed",
                       "--resume or --nucleate", "run without --resume"}});

  output::OptimizeSummary summary;
  summary.command = "optimize";
  summary.overrides = options.set;
  describe(summary, study.scene, space);
  summary.name = study.spec.name;
  summary.input_sha256 = output::sha256(study.input);
  std::vector<Cycle> resume;
  if (options.resume)
    resume = read_checkpoint(std::filesystem::path(options.out) / "checkpoint.json",
                             summary.input_sha256);
  if (options.resume && fixed_loads)
    throw InputError({{study.file, 0, 0, "--resume: steps under fixed loads are not resumed",
                       "a study of a motion", "run without --resume"}});
  output::AtomicFolder folder(options.out, options.force || options.resume);
  if (fixed_loads) return optimize_part(study, options, folder, summary, clock);
  Holes holes;
  const int code = std::visit(
      [&](const auto& s) {
        return optimize_on(study, s, options, folder, summary, resume, holes, clock);
      },
      space.space);
  print_result(summary, options.out, options.quiet);
  if (!options.quiet) print_holes(holes, options.nucleate);
  return code;
}

}  // namespace liesl

#endif
