#include "optim/cycle/cycle_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "optim/cycle/motion_problem.hpp"

namespace liesl {

namespace {

constexpr std::size_t kFewVariables = 12;  // differences simulate twice for each
constexpr double kNearActive = 1e-2;       // limits that may hold the mass up when the cycle ends

}  // namespace

template <FrameGroup G>
CycleRecord<G>::CycleRecord(const DesignSimulator<G>& simulator, const StudySpec& study,
                            const CycleHooks& hooks, int bodies)
    : simulator_(simulator), study_(study), hooks_(hooks) {
  result_.factorizations.assign(static_cast<std::size_t>(bodies), 0);
}

template <FrameGroup G>
auto CycleRecord<G>::simulate(const Eigen::VectorXd& x) -> Run {
  Run run = std::make_shared<DesignRun<G>>(simulator_.run(x, hooks_.progress));
  const Report& report = run->simulation.report;
  result_.steps += report.steps;
  result_.newton_iterations += report.newton_iterations;
  result_.stepping_s += report.stepping_s;
  for (size_t b = 0; b < report.factorizations.size(); ++b)
    result_.factorizations[b] += report.factorizations[b];
  return run;
}

template <FrameGroup G>
Cycle& CycleRecord<G>::add(const Run& run, const Eigen::VectorXd& x, const Run& before,
                           double move) {
  Cycle c;
  c.number = result_.history.empty() ? 1 : result_.history.back().number + 1;
  c.x = x;
  c.mass = run->mass;
  c.worst = run->worst;
  c.worst_constraint = run->worst_constraint;
  c.worst_time = run->worst_time;
  c.move = move;
  if (before && before->good() && before->times() == run->times())
    c.load_change = load_change(*run, *before);
  c.unit = simulator_.design().unit(x);
  if (result_.history.empty()) keep_initial(*run);
  result_.history.push_back(c);
  return result_.history.back();
}

template <FrameGroup G>
auto CycleRecord<G>::restore(const std::vector<Cycle>& resume) -> Run {
  const std::size_t variables = simulator_.design().variables().size();
  for (const auto& cycle : resume) {
    if (static_cast<std::size_t>(cycle.x.size()) != variables)
      throw std::invalid_argument("resume: the interrupted run has other variables");
    result_.history.push_back(cycle);
  }
  // Simulated again: the first (where it came from), the best (to return), the last (its loads).
  const auto best = std::min_element(
      resume.begin(), resume.end(),
      [this](const Cycle& a, const Cycle& b) { return better(a.worst, a.mass, b.worst, b.mass); });
  keep_initial(*simulate(resume.front().x));
  keep_if_better(simulate(best->x), best->x);
  const Run last = simulate(resume.back().x);
  keep_if_better(last, resume.back().x);
  return last;
}

template <FrameGroup G>
void CycleRecord<G>::keep_initial(const DesignRun<G>& run) {
  result_.initial = run.limits;
  result_.mass_initial = run.mass;
  result_.times_initial = run.times();
}

template <FrameGroup G>
bool CycleRecord<G>::better(double worst, double mass, double than_worst, double than_mass) const {
  const double allowed = study_.cycle.feasibility;
  const bool meets = worst <= allowed, other_meets = than_worst <= allowed;
  return meets != other_meets ? meets : meets ? mass < than_mass : worst < than_worst;
}

template <FrameGroup G>
void CycleRecord<G>::keep_if_better(const Run& run, const Eigen::VectorXd& x) {
  if (!run->good()) return;
  if (!best_ || better(run->worst, run->mass, best_->worst, best_->mass)) keep(run, x);
}

template <FrameGroup G>
void CycleRecord<G>::keep(const Run& run, const Eigen::VectorXd& x) {
  best_ = run;
  best_x_ = x;
}

template <FrameGroup G>
bool CycleRecord<G>::end(const std::optional<CycleEnd>& end) {
  if (!end) return false;
  result_.status = end->status;
  result_.reason = end->reason;
  return true;
}

template <FrameGroup G>
CycleResult<G> CycleRecord<G>::finish() {
  if (best_) {
    if (!result_.optimality) evaluate_certificate();
    if (closed(result_.status)) propose_holes();
    describe();
  }
  return std::move(result_);
}

/// Only of a design the cycle stands by.
template <FrameGroup G>
void CycleRecord<G>::evaluate_certificate() {
  const CycleStatus s = result_.status;
  if (study_.cycle.optimality == OptimalityCheck::Never || s == CycleStatus::Infeasible ||
      s == CycleStatus::SimulationFailed || s == CycleStatus::Interrupted)
    return;
  const bool differences = study_.cycle.optimality == OptimalityCheck::Always ||
                           simulator_.design().variables().size() <= kFewVariables;
  result_.optimality =
      certificate(simulator_, study_, *best_, best_x_, differences, hooks_.progress);
  say(*result_.optimality);
}

template <FrameGroup G>
void CycleRecord<G>::say(const DynamicOptimality& o) {
  if (!o.residual)
    result_.warnings.push_back("the dynamic optimality conditions were not checked: " + o.reason);
  if (!o.residual || o.holds()) return;
  if (result_.status == CycleStatus::Converged && study_.cycle.method == CycleMethod::Esl)
    result_.reason =
        "loads and design agree, but the dynamic optimality conditions do not hold: " + o.brief() +
        "; " + result_.reason;
  if (study_.cycle.method == CycleMethod::Esl)
    result_.warnings.push_back(
        "not optimal for the motion itself: the cycle does not see how the loads follow the "
        "design, and a lighter one may be near (" +
        o.brief() + "); cycle.method = \"esl1\" does");
}

template <FrameGroup G>
void CycleRecord<G>::propose_holes() {
  const Design& design = simulator_.design();
  for (int k = 0; k < design.parts(); ++k) {
    const int body = design.part(k).body;
    const auto& counted = study_.mass_of;
    if (std::find(counted.begin(), counted.end(), body) == counted.end()) continue;
    result_.proposals.push_back(
        {body, propose_hole(motion_task(study_, simulator_, k, *best_),
                            study_.shapes.at(body).walls, design.of_part(k, best_x_))});
  }
}

template <FrameGroup G>
void CycleRecord<G>::describe() {
  result_.x = best_x_;
  result_.mass = best_->mass;
  result_.worst = best_->worst;
  result_.final = best_->limits;
  for (const auto& loads : best_->loads)
    result_.identity.emplace_back(
        loads.body, check_identity(*best_->model, best_->simulation.trajectory, loads));
  const Design& design = simulator_.design();
  for (int k = 0; k < design.parts(); ++k) {
    PartShape& part = design.part(k);
    part.shape->set(part.design.parameters(design.of_part(k, best_x_)));
    const Fractions fractions = volume_fractions(part.model.mesh(), *part.shape);
    for (const auto& loads : best_->solid_loads)
      if (loads.body == part.body)
        result_.identity.emplace_back(loads.body,
                                      check_identity(part.model, fractions.value, loads));
  }
  result_.times = best_->times();
  if (!result_.history.empty()) result_.load_change = result_.history.back().load_change;
  for (const auto& w : best_->simulation.report.warnings) result_.warnings.push_back(w);
  result_.mechanism = best_->mechanism;
  result_.model = best_->model;
  result_.simulation = std::move(best_->simulation);
}

template <FrameGroup G>
DynamicOptimality certificate(const DesignSimulator<G>& simulator, const StudySpec& study,
                              const DesignRun<G>& run, const Eigen::VectorXd& x, bool differences,
                              const Progress& progress) {
  const auto statics = motion_problem(study, simulator, run, x, study.cycle.move_limit);
  DynamicOptimality none;
  none.reason = "statics has no sensitivities";
  if (!run.tape.checkpoints.empty()) try {
      const MotionGradients<G> motion(simulator.design(), run, x, statics->responses());
      return check_optimality(simulator, study, x, motion, *statics, kNearActive);
    } catch (const std::invalid_argument& error) {  // a motion without sensitivities
      none.reason = error.what();
    }
  return differences ? check_optimality_by_differences(simulator, study, run, x, *statics,
                                                       kNearActive, progress)
                     : none;
}

template class CycleRecord<SE2>;
template class CycleRecord<SE3>;
template DynamicOptimality certificate(const DesignSimulator<SE2>&, const StudySpec&,
                                       const DesignRun<SE2>&, const Eigen::VectorXd&, bool,
                                       const Progress&);
template DynamicOptimality certificate(const DesignSimulator<SE3>&, const StudySpec&,
                                       const DesignRun<SE3>&, const Eigen::VectorXd&, bool,
                                       const Progress&);

}  // namespace liesl
