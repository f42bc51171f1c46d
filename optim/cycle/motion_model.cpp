#include "optim/cycle/motion_model.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "optim/problems/mechanism_rows.hpp"
#include "optim/problems/mesh_statics.hpp"
#include "optim/problems/screened_loads.hpp"
#include "optim/problems/treatment.hpp"
#include "optim/study/study_errors.hpp"
#include "optim/study/without_mechanism_statics.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr std::size_t kFewVariables = 12;  // differences simulate twice for each

/// A limit as the optimiser of the motion itself has it: constraints whose number stays.
void check_direct(ConstraintSpec& c) {
  c.has_image = false;
  if (c.treatment == Treatment::All) c.treatment = Treatment::Auto;
  if (c.treatment == Treatment::Maxima || c.treatment == Treatment::Neighbours ||
      c.treatment == Treatment::Ks)
    throw std::invalid_argument(
        "limit '" + c.response.name +
        "': the number of its maxima changes with the design; expected treatment \"auto\", "
        "\"all\", "
        "\"worst\", \"functional\" or \"p_norm\" with cycle.method = \"direct\"");
}

/// Torques and inertia forces are powers of the duration: of motions that vary no asymptotes. Nor
/// of means over time: with asymptotes they end at the limit of cycles, or beside the optimum.
Approximations approximations(const StudySpec& study) {
  Approximations out{study.cycle.approximation};
  if (std::ranges::any_of(study.constants, sets_motion)) out.without_image = Approximation::Power;
  for (const ConstraintSpec& c : study.constraints) {
    const bool mean = c.treatment == Treatment::Functional || c.treatment == Treatment::PNorm;
    const bool open = c.approximation == Approximation::Auto && out.general == Approximation::Auto;
    out.own.push_back(mean && open ? Approximation::Power : c.approximation);
  }
  return out;
}

/// @throws std::invalid_argument if the limit has no static problem of the whole mechanism
void check_mechanism(const StudySpec& study, const ConstraintSpec& c, const Mechanism& mechanism) {
  if (const auto none = without_mechanism_statics(study, c, mechanism))
    throw std::invalid_argument(
        fmt::format("limit '{}' with surrogate = \"mechanism\": {}; expected {}", c.response.name,
                    none->why, none->expected));
}

/// The study with what its method takes from static problems.
template <FrameGroup G>
StudySpec with_images(StudySpec study, const Mechanism& mechanism) {
  checked(study, mechanism);
  std::string without;
  for (ConstraintSpec& c : study.constraints) {
    if (c.surrogate == SurrogateKind::Mechanism) {
      check_mechanism(study, c, mechanism);
      c.has_image = false;
    }
    if (by_motion_alone(c)) c.has_image = false;
    if (!c.has_image) without += " '" + c.response.name + "'";
    if (study.cycle.method == CycleMethod::Full) c.has_image = false;
    if (study.cycle.method == CycleMethod::Direct) check_direct(c);
  }
  for (const PartLimitSpec& l : study.part_limits)
    if (follows_loads(l.quantity) && study.cycle.method == CycleMethod::Direct)
      throw std::invalid_argument("part limit '" + l.name +
                                  "' holds in load cases that change with the design; expected "
                                  "cycle.method = \"esl1\" or \"full\"");
  if (study.motion_objective.extremes && study.cycle.method == CycleMethod::Direct)
    throw std::invalid_argument(
        "cycle.method = \"direct\" takes no largest values or lowest frequencies as objective; "
        "expected \"esl1\" or \"full\"");
  if (const auto name = without_statics(study); name && study.cycle.method == CycleMethod::Esl)
    throw std::invalid_argument("'" + *name +
                                "' changes a constant of the motion, which no static problem "
                                "has; expected cycle.method = \"esl1\" or \"full\"");
  if (!study.motion_objective.only_mass() && study.cycle.method == CycleMethod::Esl)
    throw std::invalid_argument(
        "the objective is not the mass alone, which is all that a static problem has; expected "
        "cycle.method = \"esl1\" or \"full\"");
  if (!without.empty() && study.cycle.method == CycleMethod::Esl)
    throw std::invalid_argument("limits that the static problem of a part cannot tell:" + without +
                                "; expected cycle.method = \"esl1\" or \"full\"");
  return study;
}

/// Is every record differentiated, or those that may bound the design?
bool every_record(const StudySpec& study, const ConstraintSpec& limit) {
  return aggregates(limit.treatment) || study.cycle.method == CycleMethod::Direct;
}

/// The responses whose rows a limit has: one a point, or where their largest is aggregated, that.
std::vector<ResponseSpec> rows_of(const StudySpec& study, const ConstraintSpec& limit,
                                  const Mechanism& mechanism) {
  if (every_record(study, limit)) return {limit.response};
  return at_every_point(limit.response, mechanism);
}

/// Replaces records by what the treatment of their limit makes of them.
void aggregate(const StudySpec& study, int r, MotionGradients& gradients) {
  const ConstraintSpec& limit = study.constraints[gradients.response(r).constraint];
  if (!aggregates(limit.treatment)) return;
  std::vector<double> times, values;
  for (int n = 0; n < gradients.records(r); ++n) {
    times.push_back(gradients.time(r, n));
    values.push_back(gradients.value(r, n));
  }
  gradients.aggregate(r, aggregates_of(limit, times, values));
}

/// The same of values alone.
VectorXd aggregated(const ConstraintSpec& limit, const std::vector<double>& times,
                    const VectorXd& v) {
  const std::vector<Aggregate> by = aggregates_of(limit, times, {v.begin(), v.end()});
  VectorXd out(static_cast<Eigen::Index>(by.size()));
  for (Eigen::Index k = 0; k < out.size(); ++k) out[k] = by[static_cast<std::size_t>(k)].value;
  return out;
}

/// |values| of those `responses` that `asked` says, over a motion; the others stay.
template <FrameGroup G>
void read_values(const DesignRun<G>& run, const std::vector<LimitedResponse>& responses,
                 const std::vector<bool>& asked, std::vector<VectorXd>& out) {
  const auto& trajectory = run.simulation.trajectory;
  const ResponseValues<G> values(run.mechanism, *run.model);
  State<G> state = run.model->initial_state();
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, state);
    for (std::size_t r = 0; r < responses.size(); ++r) {
      if (!asked[r]) continue;
      if (n == 0) out[r].resize(trajectory.size());
      out[r][n] = values(responses[r].response, state).norm();
    }
  }
}

}  // namespace

template <FrameGroup G>
std::shared_ptr<DesignAnalysis> MotionAnalysis<G>::figures() const {
  auto out = std::make_shared<MotionAnalysis<G>>();
  static_cast<DesignAnalysis&>(*out) = *this;
  out->limits = limits;
  return out;
}

template <FrameGroup G>
MotionModel<G>::MotionModel(const std::vector<Scenario<G>>& scenarios, const StudySpec& study)
    : study_(with_images<G>(study, scenarios.front().mechanism)) {
  for (const Scenario<G>& s : scenarios)
    simulators_.push_back(
        std::make_unique<DesignSimulator<G>>(s.mechanism, s.space, s.simulation, study_));
  effort_.factorizations.assign(scenarios.front().mechanism.bodies.size(), 0);
}

template <FrameGroup G>
std::shared_ptr<DesignAnalysis> MotionModel<G>::analyse(const VectorXd& x,
                                                        const Progress& progress) {
  auto out = std::make_shared<MotionAnalysis<G>>();
  out->runs.resize(simulators_.size());
  std::mutex one;
  const Progress shared = [&](double t) {
    const std::lock_guard lock(one);
    return !progress || progress(t);
  };
  tbb::parallel_for(std::size_t{0}, simulators_.size(),
                    [&](std::size_t s) { out->runs[s] = simulators_[s]->run(x, shared); });
  for (const DesignRun<G>& run : out->runs) {
    const Report& r = run.simulation.report;
    effort_ += {r.steps, r.newton_iterations, r.stepping_s, r.factorizations, 0};
  }
  judge(*out, x);
  return out;
}

/// The worst of all scenarios.
template <FrameGroup G>
void MotionModel<G>::judge(MotionAnalysis<G>& a, const VectorXd& x) const {
  const DesignRun<G>& first = a.runs.front();
  const MotionObjective& weights = study_.motion_objective;
  a.mass = first.mass;
  a.objective =
      weights.mass * first.mass + weights.duration * first.duration + weights.effort * first.effort;
  for (std::size_t s = 0; s < a.runs.size(); ++s) {
    const DesignRun<G>& run = a.runs[s];
    if (!run.good() && a.status != SolveStatus::Interrupted) {
      a.status = run.status();
      a.reason = run.reason();
      if (!study_.scenarios.empty()) a.reason += " (" + study_.scenarios[s] + ")";
    }
    for (CycleLoads& part : screened_loads(run, static_cast<int>(s)))
      a.loads.push_back(std::move(part));
    a.limits.push_back({run.times(), run.limits, run.frequencies, run.masses});
    if (run.good() && !study_.part_limits.empty()) judge_parts(a, s, x);
    for (LimitExcess limit : run.excesses) {
      if (!study_.scenarios.empty() && !limit.at.empty())
        limit.name += " (" + study_.scenarios[s] + ")";
      a.add(std::move(limit));
    }
  }
  a.objective += extremes(a);
}

/// Limits of meshed parts, under all loads of the motion.
template <FrameGroup G>
void MotionModel<G>::judge_parts(MotionAnalysis<G>& a, std::size_t s, const VectorXd& x) const {
  for (int k = 0; k < design().parts(); ++k) {
    const SolidTask task = motion_task(study_, *simulators_[s], k, a.runs[s]);
    const VectorXd of_part = design().of_part(k, x);
    EslProblem problem(std::make_unique<MeshStatics>(task), study_.cycle, of_part);
    const auto check = problem.check(of_part);
    if (!check) {
      a.status = SolveStatus::Inconsistent;
      a.reason = problem.undefined_reason();
      return;
    }
    for (const PartLimitSpec& limit : study_.part_limits)
      for (const LimitCheck& found : check->limits) {
        if (limit.body != design().part(k).body || found.name != limit.name) continue;
        a.limits[s].parts.push_back({limit, found});
        const std::string of = study_.scenarios.empty() ? "" : " (" + study_.scenarios[s] + ")";
        a.add({limit.name + of, found.excess, found.at});
      }
  }
}

template <FrameGroup G>
double MotionModel<G>::extremes(const MotionAnalysis<G>& a) const {
  double sum = 0;
  const StudySpec at = with_sizes(a);
  for (const ConstraintSpec& c : at.constraints) sum += c.weight * c.limit;
  for (const FrequencyLimitSpec& f : at.frequencies) sum -= f.weight * f.least;
  return sum;
}

template <FrameGroup G>
StudySpec MotionModel<G>::scaled(const MotionAnalysis<G>& a) const {
  StudySpec study = with_sizes(a);
  if (!study.motion_objective.extremes) return study;
  for (const ConstraintSpec& term : study.constraints)
    if (term.weight > 0 && !(term.limit > 0))
      throw NoSensitivities("'" + term.response.name + "' of the objective is 0 all the time");
  for (const FrequencyLimitSpec& term : study.frequencies)
    if (term.weight > 0 && !(term.least > 0))
      throw NoSensitivities("the lowest frequency of the objective is 0");
  return study;
}

template <FrameGroup G>
StudySpec MotionModel<G>::with_sizes(const MotionAnalysis<G>& a) const {
  StudySpec study = study_;
  if (!study.motion_objective.extremes) return study;
  for (std::size_t c = 0; c < study.constraints.size(); ++c) {
    ConstraintSpec& term = study.constraints[c];
    if (!(term.weight > 0)) continue;
    term.limit = 0;
    for (const MotionLimits& m : a.limits)
      if (c < m.limits.size()) term.limit = std::max(term.limit, m.limits[c].measure);
  }
  for (std::size_t f = 0; f < study.frequencies.size(); ++f) {
    FrequencyLimitSpec& term = study.frequencies[f];
    if (!(term.weight > 0)) continue;
    term.least = std::numeric_limits<double>::infinity();
    for (const MotionLimits& m : a.limits)
      if (f < m.frequencies.size()) term.least = std::min(term.least, m.frequencies[f].value);
  }
  return study;
}

template <FrameGroup G>
auto MotionModel<G>::static_members(const StudySpec& study, std::size_t s,
                                    const MotionAnalysis<G>& at, const VectorXd& x,
                                    double move) const -> Members {
  Members members = static_parts(study_, *simulators_[s], at.runs[s], x, move, study.frequencies);
  for (auto& member : members)  // the objective counts once
    member.weight = s > 0 ? 0 : member.weight * study_.motion_objective.mass;
  return members;
}

template <FrameGroup G>
std::unique_ptr<StaticProblem> MotionModel<G>::static_problem(const DesignAnalysis& given,
                                                              const VectorXd& x,
                                                              double move) const {
  const auto& at = dynamic_cast<const MotionAnalysis<G>&>(given);
  Members all;
  for (std::size_t s = 0; s < simulators_.size(); ++s)
    for (auto& member : static_members(study_, s, at, x, move)) all.push_back(std::move(member));
  return combined(std::move(all));
}

/// dJ/dx of J = T sum_n w_n v_n^2, T the duration, and T sum_n w_n (dv_n/dx) (dv_n/dx)^T.
template <FrameGroup G>
ObjectiveModel MotionModel<G>::objective_model(const MotionAnalysis<G>& at,
                                               const MotionGradients& effort) const {
  const DesignRun<G>& run = at.runs.front();
  const int duration = design().duration();
  const auto size = static_cast<Eigen::Index>(variables().size());
  ObjectiveModel out{duration,
                     study_.motion_objective.duration,
                     study_.motion_objective.effort,
                     run.effort,
                     VectorXd::Zero(size),
                     Eigen::MatrixXd::Zero(size, size),
                     extremes(at)};
  for (int r = 0; r < effort.responses(); ++r) {
    std::vector<double> times;
    for (int n = 0; n < effort.records(r); ++n) times.push_back(effort.time(r, n));
    const std::vector<double> weights = time_weights(times);
    for (int n = 0; n < effort.records(r); ++n)
      if (const VectorXd* dv = effort.gradient(r, n)) {
        const double weight = run.duration * weights[std::size_t(n)];
        out.by_effort += 2 * weight * effort.value(r, n) * *dv;
        out.curvature.noalias() += weight * *dv * dv->transpose();
      }
  }
  if (duration >= 0) out.by_effort[duration] += run.effort / run.duration;
  return out;
}

/// Static problems and rows of all limits, with their gradients in the order of the rows.
template <FrameGroup G>
std::unique_ptr<StaticProblem> MotionModel<G>::with_gradients(const MotionAnalysis<G>& at,
                                                              const StudySpec& study,
                                                              const VectorXd& x, double move,
                                                              MotionGradients& gradients) const
    try {
  struct Part {
    Members members;
    MotionGradients gradients;
    int imaged = 0;     ///< responses of the static problems of parts
    int mechanism = 0;  ///< of those of the whole mechanism, which follow
    MotionGradients effort;
  };
  std::vector<Part> parts(simulators_.size());
  effort_.sensitivities += static_cast<long>(parts.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t s) {
    Part& p = parts[s];
    const DesignRun<G>& run = at.runs[s];
    p.members = static_members(study, s, at, x, move);
    std::vector<LimitedResponse> responses;
    for (const auto& member : p.members)
      for (auto& r : member.problem->responses_with_slopes()) {
        if (r.slopes) {
          auto placed = std::make_shared<PartSlopes>(*r.slopes);
          placed->first = member.first;
          r.slopes = std::move(placed);
        }
        responses.push_back(std::move(r));
      }
    p.imaged = static_cast<int>(responses.size());
    for (const bool by_mechanism : {true, false}) {
      for (std::size_t c = 0; c < study_.constraints.size(); ++c) {
        const ConstraintSpec& limit = study_.constraints[c];
        if (limit.has_image || (limit.surrogate == SurrogateKind::Mechanism) != by_mechanism)
          continue;
        for (auto& r : rows_of(study_, limit, run.mechanism))
          responses.push_back({static_cast<int>(c), std::move(r), static_cast<int>(s),
                               every_record(study_, limit) ? 0 : 0.5, limit.treatment});
      }
      if (by_mechanism) p.mechanism = static_cast<int>(responses.size()) - p.imaged;
    }
    const auto limited = static_cast<int>(responses.size());
    if (s == 0)
      for (const ResponseSpec& r : study_.motion_objective.responses)
        responses.push_back({-1, r, 0, 0});
    for (auto& r : responses) r.scenario = static_cast<int>(s);
    p.gradients = MotionGradients(simulators_[s]->design(), run, x, responses);
    p.effort = p.gradients.split(limited);
    for (int r = p.imaged; r < p.gradients.responses(); ++r) aggregate(study_, r, p.gradients);
  });
  Members members;
  if (!study_.motion_objective.only_mass())
    members.push_back({std::make_unique<ObjectiveProblem>(objective_model(at, parts.front().effort),
                                                          x, variables()),
                       1, 0});
  for (std::size_t s = 0; s < parts.size(); ++s) {
    Part& p = parts[s];
    for (auto& member : p.members) members.push_back(std::move(member));
    const auto rows = [&](int first, int count) {
      return std::make_unique<MotionRows>(p.gradients, first, count, study, variables());
    };
    if (p.mechanism > 0)
      members.push_back({std::make_unique<MechanismRows<G>>(rows(p.imaged, p.mechanism),
                                                            *simulators_[s], at.runs[s], study),
                         0, 0});
    const int first = p.imaged + p.mechanism;
    if (const int count = p.gradients.responses() - first; count > 0)
      members.push_back({rows(first, count), 0, 0});
    gradients.append(std::move(p.gradients));
  }
  return combined(std::move(members));
} catch (const MechanismMoves& error) {
  throw NoStaticsOfMechanism(error.what());
} catch (const std::invalid_argument& error) {
  throw NoSensitivities(error.what());
}

template <FrameGroup G>
Surrogate MotionModel<G>::uncorrected(const DesignAnalysis& given, const VectorXd& x,
                                      double move) const try {
  const auto& at = dynamic_cast<const MotionAnalysis<G>&>(given);
  const auto told = [](const ConstraintSpec& c) { return c.has_image; };
  if (!std::ranges::all_of(study_.constraints, told) || !study_.motion_objective.only_mass() ||
      at.runs.front().statics)
    return {};
  Members all;
  for (std::size_t s = 0; s < simulators_.size(); ++s)
    for (auto& member : static_members(scaled(at), s, at, x, move)) {
      MotionGradients::require(simulators_[s]->design(), at.runs[s], x,
                               member.problem->responses());
      all.push_back(std::move(member));
    }
  return {std::make_unique<CorrectedProblem>(combined(std::move(all)), MotionGradients(), x,
                                             at.objective, approximations(study_)),
          {}};
} catch (const std::invalid_argument& error) {
  throw NoSensitivities(error.what());
}

template <FrameGroup G>
Surrogate MotionModel<G>::surrogate(const DesignAnalysis& given, const VectorXd& x, double move,
                                    double active) const {
  const auto& at = dynamic_cast<const MotionAnalysis<G>&>(given);
  Surrogate out;
  MotionGradients gradients;
  const StudySpec study = scaled(at);
  auto statics = with_gradients(at, study, x, move, gradients);
  out.optimality = check_optimality(study, variables(), x, gradients, *statics, active);
  if (gradients.reason().empty() && at.worst > study_.cycle.feasibility)
    out.optimality.violation =
        check_violation(study, variables(), x, gradients, *statics, at.worst, active);
  if (gradients.reason().empty())
    out.problem = std::make_unique<CorrectedProblem>(std::move(statics), std::move(gradients), x,
                                                     at.objective, approximations(study_));
  return out;
}

/// Of motions; limits of meshed parts themselves are not known.
template <FrameGroup G>
std::vector<VectorXd> MotionModel<G>::response_values(
    const DesignAnalysis& given, const std::vector<LimitedResponse>& of) const {
  const auto& at = dynamic_cast<const MotionAnalysis<G>&>(given);
  std::vector<VectorXd> out(of.size());
  for (std::size_t s = 0; s < at.runs.size(); ++s) {
    const DesignRun<G>& run = at.runs[s];
    if (run.statics) continue;
    std::vector<bool> asked;
    for (const LimitedResponse& r : of)
      asked.push_back(r.scenario == static_cast<int>(s) && r.constraint >= 0 && r.part_limit < 0);
    read_values(run, of, asked, out);
    for (std::size_t r = 0; r < of.size(); ++r) {
      if (!asked[r]) continue;
      const ConstraintSpec& limit = study_.constraints[static_cast<std::size_t>(of[r].constraint)];
      if (!limit.has_image && aggregates(limit.treatment))
        out[r] = aggregated(limit, run.times(), out[r]);
    }
  }
  return out;
}

template <FrameGroup G>
DynamicOptimality MotionModel<G>::optimality(const DesignAnalysis& given, const VectorXd& x,
                                             const Progress& progress) const {
  const auto& at = dynamic_cast<const MotionAnalysis<G>&>(given);
  DynamicOptimality none;
  none.reason = "there is no motion to be differentiated";
  if (at.runs.front().differentiable()) try {
      return surrogate(at, x, study_.cycle.move_limit, kNearActive).optimality;
    } catch (const NoSensitivities& error) {
      none.reason = error.what();
    }
  for (const PartLimitSpec& l : study_.part_limits)
    if (follows_loads(l.quantity)) return none;  // not among the differences
  const bool differences =
      study_.cycle.optimality == OptimalityCheck::Always || variables().size() <= kFewVariables;
  if (!differences || at.runs.size() > 1) return none;
  const auto statics = static_problem(at, x, study_.cycle.move_limit);
  return check_optimality_by_differences(simulator(0), at.runs.front(), x, *statics, kNearActive,
                                         progress);
}

template <FrameGroup G>
std::optional<double> MotionModel<G>::load_change(const DesignAnalysis& now_given,
                                                  const DesignAnalysis& before_given) const {
  const auto& now = dynamic_cast<const MotionAnalysis<G>&>(now_given);
  const auto& before = dynamic_cast<const MotionAnalysis<G>&>(before_given);
  double change = 0;
  for (std::size_t s = 0; s < now.runs.size(); ++s) {
    if (now.limits[s].times != before.limits[s].times) return {};
    change = std::max(change, liesl::load_change(now.runs[s], before.runs[s]));
  }
  return change;
}

template struct MotionAnalysis<SE2>;
template struct MotionAnalysis<SE3>;
template class MotionModel<SE2>;
template class MotionModel<SE3>;

}  // namespace liesl
