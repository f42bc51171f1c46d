#ifdef LIESL_OPTIM

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <limits>

#include "apps/cli/result_files.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/output/file.hpp"
#include "apps/study/load_study.hpp"
#include "apps/tasks/optimize_verified.hpp"
#include "apps/tasks/run_summary.hpp"
#include "apps/tasks/sensitivity.hpp"
#include "optim/cycle/design_model.hpp"
#include "optim/design/design.hpp"
#include "python/module/job.hpp"
#include "python/module/outcome.hpp"
#include "python/module/program.hpp"

namespace liesl::python {
namespace {

using Eigen::VectorXd;
using Json = nlohmann::ordered_json;

/// What of a study of beams the rows of nlp() do not have: they are largest values in windows of
/// time.
std::vector<std::string> without_rows(const StudySpec& spec) {
  const auto any = [&](const auto& is) {
    return std::any_of(spec.constraints.begin(), spec.constraints.end(), is);
  };
  std::vector<std::string> out;
  if (!spec.frequencies.empty()) out.push_back("limits on frequencies");
  if (!spec.mass_limits.empty()) out.push_back("limits on masses");
  if (!spec.part_limits.empty()) out.push_back("limits of meshed parts");
  if (has_catalogue(spec)) out.push_back("sizes of a catalogue");
  if (any([](const ConstraintSpec& c) {
        return c.treatment == Treatment::Functional || c.treatment == Treatment::PNorm;
      }))
    out.push_back("limits on integrals and p-norms");
  if (any([](const ConstraintSpec& c) { return c.weight > 0; }))
    out.push_back("largest values in the objective");
  return out;
}

/// null: no finite number.
double figure_of(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

/// An array of numbers.
VectorXd vector_of(const Json& list) {
  const auto x = list.get<std::vector<double>>();
  return Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// What liesl/study.py has found: `status`, `reason`, `x`, `history` (rows with keys of
/// summary.json), `limits` of one's own (`name`, `initial`, `final`).
FoundOptimum found_of(const Json& given) {
  FoundOptimum out;
  out.status =
      cycle_status(given.at("status").get<std::string>()).value_or(CycleStatus::SimulationFailed);
  out.reason = given.at("reason").get<std::string>();
  out.x = vector_of(given.at("x"));
  for (const Json& row : given.at("history")) {
    Cycle& cycle = out.history.emplace_back();
    cycle.number = row.at("cycle").get<int>();
    cycle.x = vector_of(row.at("design"));
    cycle.mass = row.at("mass").get<double>();
    cycle.objective = figure_of(row.at("objective"));
    cycle.worst = figure_of(row.at("worst_constraint"));
    cycle.worst_constraint = row.at("worst_limit").get<std::string>();
    cycle.seconds = row.at("wall_s").get<double>();
    for (const auto& [name, limit] : row.at("limits").items())
      cycle.excesses.push_back(
          {name, figure_of(limit.at("violation")), limit.at("at").get<std::string>()});
  }
  for (const Json& limit : given.at("limits")) {
    const double initial = figure_of(limit.at("initial")), final = figure_of(limit.at("final"));
    out.limits.push_back(
        {limit.at("name").get<std::string>(), "own function", "-", 0, initial, final, 0, final});
  }
  return out;
}

class OptimizeResult final : public Outcome {
 public:
  OptimizeResult(OptimizeOutcome outcome, std::shared_ptr<const Study> study)
      : outcome_(std::move(outcome)), study_(std::move(study)) {
    show(outcome_.results);
  }
  std::string summary() const override { return output::to_json(outcome_.summary).dump(); }
  void write(const std::filesystem::path& folder) const override {
    write_optimization(folder, outcome_, *study_);
  }

 private:
  OptimizeOutcome outcome_;
  std::shared_ptr<const Study> study_;
};

/// A study that was read, and what it varies.
class StudyInput : public std::enable_shared_from_this<StudyInput> {
 public:
  StudyInput(const std::string& text, const std::string& file, const std::filesystem::path& folder,
             const std::vector<std::string>& changes)
      : read_([=](const std::vector<std::string>& more) {
          auto all = changes;
          all.insert(all.end(), more.begin(), more.end());
          return read_study(text, file, folder, all);
        }),
        changes_(changes),
        study_(std::make_shared<const Study>(read_study(text, file, folder, changes))),
        design_(std::make_shared<const Design>(study_->spec, study_->scene.mechanism)) {}

  const Study& study() const { return *study_; }
  const Design& design() const { return *design_; }
  py::object program() const { return program_of(study_); }
  bool moves() const {
    return study_->spec.loads.empty() && study_->scene.simulation.type == SimulationType::Dynamic;
  }

  /// Mass of the bodies in the objective, kg, and its gradient: central differences of fourth order
  /// of the data, exact to round-off for polynomials of fourth degree.
  double mass(const VectorXd& x) const {
    return mass_of(design_->apply(study_->scene.mechanism, x), study_->spec.mass_of);
  }
  VectorXd mass_gradient(const VectorXd& x) const {
    constexpr double kStep = 1. / 1024;
    VectorXd out(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const NlpVariable& v = design_->variables()[static_cast<std::size_t>(i)];
      const double h = kStep * std::max(std::abs(x[i]), 1e-3 * (v.upper - v.lower));
      const auto at = [&](double steps) {
        VectorXd moved = x;
        moved[i] += steps * h;
        return mass(moved);
      };
      out[i] = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    }
    return out;
  }

  /// The motion of a scenario at the design x, with a record at every step.
  std::shared_ptr<MotionResult> evaluate(const VectorXd& x, std::size_t scenario) const {
    return run_job([study = study_, design = design_, x, scenario](const Stop& stop) {
      const Scene& scene = scenario == 0 ? study->scene : study->scenarios.at(scenario - 1);
      SensitivityProblem problem = study_problem(*study, scene, design, x);
      problem.scene.simulation.output_every = 1;
      const ChosenSpace space = choose_space(problem.scene);
      return std::make_shared<MotionResult>(
          std::make_unique<DifferentiableMotion>(std::move(problem), space, stop.progress()));
    });
  }

  /// @param verify as `liesl optimize` does  @param on_cycle called with the summary so far, or
  /// None
  std::shared_ptr<Outcome> optimize(int nucleate, bool verify, const py::object& on_cycle) const {
    VerifiedOptions how;
    how.verify = verify;
    how.refine = study_->refine && nucleate == 0;
    how.nucleate = nucleate;
    how.read = read_;
    return run_job([self = shared_from_this(), how, call = hold(on_cycle)](const Stop& stop) {
      return self->optimized(how, hooks(stop, *call));
    });
  }

  /// An optimum that functions of one's own have led to. @param text JSON, see found_of
  std::shared_ptr<Outcome> found(const std::string& text) const {
    return run_job([self = shared_from_this(), given = Json::parse(text)](const Stop& stop) {
      return self->described(given, stop.progress());
    });
  }

 private:
  /// The summary before anything has run.
  output::OptimizeSummary known(const ChosenSpace& space) const {
    output::OptimizeSummary summary;
    summary.command = "optimize";
    summary.overrides = changes_;
    describe(summary, study_->scene, space);
    summary.name = study_->spec.name;
    summary.input_sha256 = output::sha256(study_->input);
    return summary;
  }
  std::shared_ptr<Outcome> described(const Json& given, const Progress& progress) const {
    const ChosenSpace space = choose_space(study_->scene);
    OptimizeOutcome out = found_task(*study_, space, known(space), found_of(given), progress);
    out.summary.more.update(given.at("more"));
    out.summary.more["input"] = study_->file;
    out.summary.wall_s = given.at("wall_s").get<double>();
    return std::make_shared<OptimizeResult>(std::move(out), study_);
  }
  std::shared_ptr<Outcome> optimized(const VerifiedOptions& how, const OptimizeHooks& hooks) const {
    const Stopwatch clock;
    const ChosenSpace space = choose_space(study_->scene);
    VerifiedOptimum end = optimize_verified(*study_, space, known(space), hooks, how);
    end.out.summary.more["input"] = study_->file;
    end.out.summary.wall_s = clock.seconds();
    return std::make_shared<OptimizeResult>(std::move(end.out),
                                            std::make_shared<const Study>(std::move(end.study)));
  }
  static OptimizeHooks hooks(const Stop& stop, const py::object& on_cycle) {
    OptimizeHooks hooks;
    hooks.progress = stop.progress();
    hooks.keep_going = [&stop] { return !stop.requested(); };
    hooks.on_cycle = [&stop, &on_cycle](const output::OptimizeSummary& so_far,
                                        const RoundHistory&) {
      const py::gil_scoped_acquire locked;
      if (!on_cycle.is_none() && !stop.requested()) on_cycle(output::to_json(so_far).dump());
    };
    hooks.on_hole = [](const std::string&, const Nucleus&) {};
    return hooks;
  }

  ReadStudy read_;
  std::vector<std::string> changes_;
  std::shared_ptr<const Study> study_;
  std::shared_ptr<const Design> design_;
};

/// (name, unit, lower, upper, start) of each.
py::list variables_of(const StudyInput& input) {
  py::list out;
  const auto& variables = input.design().variables();
  for (std::size_t i = 0; i < variables.size(); ++i)
    out.append(py::make_tuple(variables[i].name, input.design().units()[i], variables[i].lower,
                              variables[i].upper, variables[i].start));
  return out;
}

/// (name, limit) of each.
py::list limits_of(const StudyInput& input) {
  py::list out;
  for (const ConstraintSpec& c : input.study().spec.constraints)
    out.append(py::make_tuple(c.response.name, c.limit));
  return out;
}

}  // namespace

void bind_studies(py::module_& module) {
  using Texts = std::vector<std::string>;
  py::class_<StudyInput, std::shared_ptr<StudyInput>>(module, "Study")
      .def(py::init<const std::string&, const std::string&, const std::filesystem::path&,
                    const Texts&>())
      .def("warnings", [](const StudyInput& s) { return s.study().scene.warnings; })
      .def("variables", &variables_of)
      .def("limits", &limits_of)
      .def("scenarios", [](const StudyInput& s) { return s.study().spec.scenarios; })
      .def("moves", &StudyInput::moves)
      .def("changes_outlines", [](const StudyInput& s) { return s.design().parts() > 0; })
      .def("only_mass",
           [](const StudyInput& s) { return s.study().spec.motion_objective.only_mass(); })
      .def("without_rows", [](const StudyInput& s) { return without_rows(s.study().spec); })
      .def("program", &StudyInput::program)
      .def("fixed_loads", [](const StudyInput& s) { return !s.study().spec.loads.empty(); })
      .def("most_cycles", [](const StudyInput& s) { return s.study().spec.cycle.max; })
      .def("mass", &StudyInput::mass)
      .def("mass_gradient", &StudyInput::mass_gradient)
      .def("evaluate", &StudyInput::evaluate)
      .def("optimize", &StudyInput::optimize)
      .def("found", &StudyInput::found);
}

}  // namespace liesl::python

#endif
