#include "optim/cycle/fixed_point_rule.hpp"

namespace liesl {
namespace {

constexpr double kSmallestMove = 1e-3;
// Iterations without second derivatives while the loads still change: they converge slowly, and to
// an answer that the next loads move.
constexpr int kFewIterations = 20;

}  // namespace

Step FixedPointRule::resume(CycleRecord& record) {
  const Cycle at = record.history().back();
  move_ = at.move;
  warm_ = at.warm;
  if (at.next.size() == at.x.size())  // no cycle more where there is no step
    return {at.next,
            at.end == CycleStatus::Infeasible ? stuck(at, record.options()) : std::nullopt};
  record.drop_last();  // it has no answer
  if (!record.history().empty()) warm_ = record.history().back().warm;
  return {at.x, {}};
}

/// A design whose simulation fails is half-way taken back.
Step FixedPointRule::retreat(CycleRecord& record, const DesignAnalysis& failed,
                             const Eigen::VectorXd& x) {
  move_ *= 0.5;
  if (record.history().empty() || move_ < kSmallestMove)
    return {x, CycleEnd{CycleStatus::SimulationFailed,
                        "a design cannot be analysed: " + failed.reason}};
  record.warn("a design could not be analysed and was taken back half-way: " + failed.reason);
  return {0.5 * (x + record.history().back().x), {}};
}

/// What the latest analysis ends; halves the move limit of a cycle that oscillates.
std::optional<CycleEnd> FixedPointRule::ended(const CycleRecord& record) {
  const CycleOptions& options = record.options();
  if (auto end = agreement(record.history(), options)) return end;
  if (oscillates(record.history(), options)) {
    move_ *= 0.5;
    if (move_ < kSmallestMove)
      return CycleEnd{CycleStatus::Oscillating,
                      "the designs go to and fro although the move limits shrank; the best one is "
                      "returned"};
  }
  return used_up(record.history(), options);
}

Step FixedPointRule::next(CycleRecord& record, const CycleRecord::Analysis& analysis,
                          Cycle& cycle) {
  record.keep_if_better(analysis, cycle.x);
  cycle.move = move_;
  if (auto end = ended(record)) return {cycle.x, std::move(end)};
  const auto problem = record.model().static_problem(*analysis, cycle.x, move_);
  const NlpWarmStart before = warm_;
  solve(record, *problem, cycle);
  if (record.asked_to_stop()) {  // half an optimum says nothing of the design; `resume` solves anew
    cycle.answer.resize(0);
    cycle.warm = before;
    return {cycle.x, record.stopped()};
  }
  cycle.next = next_design(record.history(), record.model().variables());
  std::optional<CycleEnd> end = fixed_point(cycle, record.options());
  if (!end) end = stuck(cycle, record.options());
  return {cycle.next, std::move(end)};
}

/// The static optimum under the loads of this cycle.
void FixedPointRule::solve(CycleRecord& record, StaticProblem& problem, Cycle& cycle) {
  const CycleOptions& options = record.options();
  const auto& variables = problem.variables();
  cycle.lower.resize(cycle.x.size());
  cycle.upper.resize(cycle.x.size());
  for (int i = 0; i < cycle.x.size(); ++i) {
    cycle.lower[i] = variables[i].lower;
    cycle.upper[i] = variables[i].upper;
  }
  const int all = NlpOptions().max_iterations, few = problem.has_hessian() ? all : kFewIterations;
  const auto& keep_going = record.hooks().keep_going;
  StaticAnswer answer = solve_static(problem, options, warm_, keep_going, few);
  cycle.iterations = answer.iterations;
  if (few < all && answer.result.status == NlpStatus::IterationLimit &&
      step_size(cycle, answer.result.x) <= options.tolerance) {  // few led nowhere
    answer = solve_static(problem, options, warm_, keep_going, all);
    cycle.iterations += answer.iterations;
  }
  cycle.load_cases = problem.load_cases();
  cycle.move = move_;
  cycle.answer = answer.result.x;
  cycle.warm = warm_;
}

}  // namespace liesl
