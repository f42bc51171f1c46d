#ifdef LIESL_OPTIM

#include "apps/tasks/map.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "apps/input/problem.hpp"
#include "apps/tasks/map_values.hpp"
#include "mbs/linalg/stop_request.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr double kActive = 2e-3;   // limits that count as active where the local model is made
constexpr int kMostPoints = 1000;  // along an axis

/// What was asked for, checked against the study.
struct MapPlan {
  std::array<int, 2> axes = {};  ///< variables
  std::vector<std::size_t> of;   ///< quantities
  VectorXd centre;               ///< design where the local model is made
  std::array<std::vector<double>, 2> values;
};

/// Finds out what is wrong with a request, all of it, and what it means otherwise.
class Planner {
 public:
  Planner(const std::vector<NlpVariable>& variables, const std::vector<MappedQuantity>& quantities,
          const MapRequest& request)
      : variables_(variables), quantities_(quantities), request_(request), problems_("map") {
    for (const NlpVariable& v : variables) names_.push_back(v.name);
  }

  MapPlan plan() {
    plan_axes();
    plan_quantities();
    plan_centre();
    problems_.throw_if_any();
    return plan_;
  }

 private:
  void say(const std::string& where, std::string what, std::string expected,
           std::string hint = "") {
    problems_.add({where, 0, 0, std::move(what), std::move(expected), std::move(hint)});
  }

  void plan_axes() {
    if (request_.over.size() != 2)
      return say("--over", fmt::format("{} variables", request_.over.size()), "two of the study",
                 "as in --over a,b or --over a=0.005:0.010,b");
    for (const std::size_t k : {0, 1}) {
      const MapAxis& axis = request_.over[k];
      const std::string where = "--over " + axis.name;
      const auto found = std::find(names_.begin(), names_.end(), axis.name);
      if (found == names_.end()) {
        say(where, "the study has no such variable", "a variable of the study",
            suggestion(axis.name, names_));
        continue;
      }
      plan_.axes[k] = static_cast<int>(found - names_.begin());
      plan_range(where, axis, k);
    }
    if (request_.over[0].name == request_.over[1].name)
      say("--over " + request_.over[0].name, "twice the same variable", "two variables");
  }

  void plan_range(const std::string& where, const MapAxis& axis, std::size_t k) {
    const NlpVariable& v = variables_[static_cast<std::size_t>(plan_.axes[k])];
    const auto [from, to] = axis.range.value_or(std::array{v.lower, v.upper});
    if (!(from < to) || from < v.lower || to > v.upper)
      say(where, fmt::format("the range is {}:{}", from, to),
          fmt::format("FROM < TO within the bounds [{}, {}]", v.lower, v.upper));
    const std::size_t given = request_.points.size();
    const int n = given == 0 ? 0 : request_.points[given == 1 ? 0 : std::min(k, given - 1)];
    if (given > 2 || n < 2 || n > kMostPoints)
      return say("--points", given > 2 ? "more than two numbers" : fmt::format("{} points", n),
                 fmt::format("one number or two, 2 to {}", kMostPoints));
    for (int i = 0; i < n; ++i) plan_.values[k].push_back(from + (to - from) * i / (n - 1));
  }

  void plan_quantities() {
    std::vector<std::string> known;
    for (const MappedQuantity& q : quantities_) known.push_back(q.name);
    for (const std::string& name : request_.of) {
      const auto found = std::find(known.begin(), known.end(), name);
      const auto at = static_cast<std::size_t>(found - known.begin());
      if (found == known.end())
        say("--of " + name, "the study neither minimises nor limits it",
            "the objective or a limit of the study", suggestion(name, known));
      else if (std::find(plan_.of.begin(), plan_.of.end(), at) == plan_.of.end())
        plan_.of.push_back(at);
    }
    if (request_.of.empty())
      for (std::size_t q = 0; q < known.size(); ++q) plan_.of.push_back(q);
  }

  void plan_centre() {
    plan_.centre.resize(static_cast<Eigen::Index>(variables_.size()));
    for (std::size_t j = 0; j < variables_.size(); ++j)
      plan_.centre[static_cast<Eigen::Index>(j)] = variables_[j].start;
    if (!request_.path) {
      if (request_.cycle) say("--cycle", "there is no path to take a cycle of", "--path DIR");
      return;
    }
    const DesignPath& path = *request_.path;
    if (path.names != names_)
      return say(path.file, "its variables are not those of the study",
                 "results of liesl optimize of the same study");
    const std::vector<double>* at = &path.last;
    if (request_.cycle) {
      const auto found = std::find_if(path.cycles.begin(), path.cycles.end(),
                                      [&](const auto& c) { return c.first == *request_.cycle; });
      if (found == path.cycles.end())
        return say(fmt::format("--cycle {}", *request_.cycle), "the path has no such cycle",
                   path.cycles.empty()
                       ? "a path with cycles"
                       : fmt::format("a cycle from {} to {}", path.cycles.front().first,
                                     path.cycles.back().first));
      at = &found->second;
    }
    plan_.centre = Eigen::Map<const VectorXd>(at->data(), static_cast<Eigen::Index>(at->size()));
  }

  const std::vector<NlpVariable>& variables_;
  const std::vector<MappedQuantity>& quantities_;
  const MapRequest& request_;
  Problems problems_;
  std::vector<std::string> names_;
  MapPlan plan_;
};

VectorXd point(const MapPlan& plan, std::size_t i, std::size_t j) {
  VectorXd x = plan.centre;
  x[plan.axes[0]] = plan.values[0][i];
  x[plan.axes[1]] = plan.values[1][j];
  return x;
}

/// Simulates all points, a line of the grid a task.
void add_global(const MakeValues& make, const MapPlan& plan, const MapHooks& hooks,
                output::DesignMap& map) {
  const std::size_t nx = plan.values[0].size(), ny = plan.values[1].size();
  std::atomic<int> done = 0;
  std::mutex one;
  const auto go_on = [&](double) { return !hooks.keep_going || hooks.keep_going(); };
  tbb::parallel_for(std::size_t{0}, ny, [&](std::size_t j) {
    const std::unique_ptr<StudyValues> values = make();
    for (std::size_t i = 0; i < nx; ++i) {
      std::string& reason = map.reasons[j * nx + i];
      if (!go_on(0)) {
        reason = "interrupted";
        continue;
      }
      std::shared_ptr<DesignAnalysis> analysis;
      try {
        analysis = values->model().analyse(point(plan, i, j), go_on);
      } catch (const Stopped&) {
        reason = "interrupted";
        continue;
      }
      if (!analysis->good()) {
        reason = analysis->reason;
        continue;
      }
      const std::vector<double> all = values->of(*analysis);
      for (std::size_t q = 0; q < plan.of.size(); ++q)
        map.of[q].global[j * nx + i] = all[plan.of[q]];
      const std::lock_guard lock(one);
      if (hooks.on_point) hooks.on_point(++done, static_cast<int>(nx * ny));
    }
  });
}

/// The problem from which a cycle takes its next design, and the analysis that it refers to.
struct LocalProblem {
  std::shared_ptr<DesignAnalysis> at;
  std::unique_ptr<StaticProblem> problem;  ///< null: there is none
};

/// Made at x. @param what it is, or why there is none
LocalProblem local_problem(const Study& study, DesignModel& model, const VectorXd& x,
                           std::string& what) {
  const auto at = model.analyse(x, {});
  if (!at->good()) {
    what = "none: the design where it is made has no values: " + at->reason;
    return {};
  }
  const double move = study.spec.cycle.move_limit;
  if (study.spec.cycle.method != CycleMethod::Esl &&
      study.scene.simulation.type == SimulationType::Dynamic)
    try {
      Surrogate surrogate = model.surrogate(*at, x, move, kActive);
      what = study.spec.cycle.method == CycleMethod::Full ||
                     study.spec.cycle.method == CycleMethod::Direct
                 ? "the responses of the motion to first order (cycle.method \"full\")"
                 : "the static problem, corrected to first order (cycle.method \"esl1\")";
      if (!surrogate.problem) what = "none: " + surrogate.optimality.reason;
      return {at, std::move(surrogate.problem)};
    } catch (const NoSensitivities&) {
    }
  what = "the static problem under constant loads (cycle.method \"esl\")";
  return {at, model.static_problem(*at, x, move)};
}

void add_local(const Study& study, const MakeValues& make, const MapPlan& plan, MapOutcome& out) {
  if (!study.spec.loads.empty()) {
    out.summary.local = "none: under fixed loads the problem of a step is the study itself";
    return;
  }
  const std::unique_ptr<StudyValues> values = make();
  const LocalProblem local = local_problem(study, values->model(), plan.centre, out.summary.local);
  if (!local.problem) return;
  StaticProblem& problem = *local.problem;
  const std::size_t nx = plan.values[0].size(), ny = plan.values[1].size();
  for (std::size_t j = 0; j < ny; ++j)  // load cases that count anywhere
    for (std::size_t i = 0; i < nx; ++i)
      while (problem.add_violated(point(plan, i, j), 0) > 0) {
      }
  for (auto& q : out.map.of) q.local.assign(nx * ny, kNoValue);
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i) {
      const std::vector<double> all = values->of(problem, point(plan, i, j));
      for (std::size_t q = 0; q < plan.of.size(); ++q)
        out.map.of[q].local[j * nx + i] = all[plan.of[q]];
    }
}

void describe(const Study& study, const MapPlan& plan, const std::vector<NlpVariable>& variables,
              const MapRequest& request, MapOutcome& out) {
  for (std::size_t j = 0; j < variables.size(); ++j)
    out.map.centre.emplace_back(variables[j].name, plan.centre[static_cast<Eigen::Index>(j)]);
  if (request.path)
    for (const auto& [cycle, x] : request.path->cycles)
      if (static_cast<Eigen::Index>(x.size()) == plan.centre.size())
        out.map.path.push_back({cycle,
                                {x[static_cast<std::size_t>(plan.axes[0])],
                                 x[static_cast<std::size_t>(plan.axes[1])]}});
  output::MapSummary& s = out.summary;
  s.name = study.spec.name;
  s.designs = static_cast<int>(out.map.points());
  const auto stopped = std::count(out.map.reasons.begin(), out.map.reasons.end(), "interrupted");
  s.failed = s.designs - static_cast<int>(std::count(out.map.reasons.begin(), out.map.reasons.end(),
                                                     std::string()));
  s.status = stopped > 0 ? "interrupted" : "done";
  s.reason = fmt::format("{} of {} designs have values", s.designs - s.failed, s.designs);
}

}  // namespace

MapOutcome map_task(const Study& study, const ChosenSpace& space, const MapRequest& request,
                    const MapHooks& hooks) {
  if (study.spec.motion_objective.extremes)
    throw InputError({{study.file, 0, 0,
                       "a map shows no objective that is a largest value or a lowest frequency",
                       "an objective of mass, duration or effort",
                       "a copy that limits them instead shows them"}});
  const MakeValues make = values_of(study, space);
  const std::vector<MappedQuantity> known = quantities(study);
  const Design design(study.spec, study.scene.mechanism);
  const std::vector<NlpVariable>& variables = design.variables();
  const MapPlan plan = Planner(variables, known, request).plan();
  MapOutcome out;
  for (const std::size_t k : {0, 1})
    out.map.axes[k] = {variables[static_cast<std::size_t>(plan.axes[k])].name,
                       design.units()[static_cast<std::size_t>(plan.axes[k])], plan.values[k]};
  const std::size_t points = out.map.points();
  for (const std::size_t q : plan.of)
    out.map.of.push_back(
        {known[q].name, known[q].unit, known[q].limit, std::vector<double>(points, kNoValue), {}});
  out.map.reasons.resize(points);
  add_local(study, make, plan, out);
  add_global(make, plan, hooks, out.map);
  describe(study, plan, variables, request, out);
  return out;
}

}  // namespace liesl

#endif
