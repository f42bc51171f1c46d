#include "optim/cycle/shape_cycle.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr double kOnLimit = 1e-3;  // of the move: nearer than this is on the move limit
constexpr double kStands = 1e-6;   // of the range: a step that counts as none

class ShapeCycle {
 public:
  ShapeCycle(const SolidTask& task, const ShapeMoves& moves, const ShapeHooks& hooks)
      : task_(task), moves_(moves), hooks_(hooks) {}

  ShapeResult run() {
    VectorXd x = task_.design->start();
    for (int number = 1;; ++number) {
      const auto begin = std::chrono::steady_clock::now();
      StaticShape problem(task_, x, moves_.cells, moves_.share);
      if (!record(problem, x, number)) break;
      const bool last = end_ || number > task_.cycle.max;
      if (last) {
        finish(problem, x);
        if (hooks_.on_step) hooks_.on_step(result_.history);
        break;
      }
      x = step(problem, x);
      result_.history.back().seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      if (hooks_.on_step) hooks_.on_step(result_.history);
    }
    return std::move(result_);
  }

 private:
  /// False: there is no part at x.
  bool record(StaticShape& problem, const VectorXd& x, int number) {
    auto check = problem.check(x);
    if (!check) {
      result_.status = CycleStatus::Infeasible;
      result_.reason = (number == 1 ? "the start design: " : "a design: ") + problem.obstacle();
      return false;
    }
    result_.history.push_back({number, x, std::move(*check), 0, 0, 0});
    return true;
  }

  VectorXd step(StaticShape& problem, const VectorXd& x) {
    const StaticAnswer answer = solve_static(problem, task_.cycle, warm_, hooks_.keep_going);
    ShapeStep& s = result_.history.back();
    s.iterations = answer.iterations;
    s.load_cases = problem.load_cases();
    result_.stationarity = answer.result.stationarity;
    judge(problem, x, answer.result);
    return answer.result.x;
  }

  /// Does the cycle end with this answer?
  void judge(const StaticShape& problem, const VectorXd& x, const NlpResult& answer) {
    if (hooks_.keep_going && !hooks_.keep_going()) {
      end_ = CycleEnd{CycleStatus::Interrupted, "stopped on request"};
      return;
    }
    const auto& own = task_.design->variables();
    double moved = 0;
    bool limited = false;
    for (int j = 0; j < x.size(); ++j) {
      const NlpVariable& v = problem.variables()[j];
      const double range = own[j].upper - own[j].lower;
      moved = std::max(moved, std::abs(answer.x[j] - x[j]) / range);
      limited |= v.lower > own[j].lower && answer.x[j] - v.lower < kOnLimit * (x[j] - v.lower);
      limited |= v.upper < own[j].upper && v.upper - answer.x[j] < kOnLimit * (v.upper - x[j]);
    }
    const bool met = answer.violation <= task_.cycle.feasibility;
    if (met && (moved < kStands || (!limited && answer.solved())))
      end_ = CycleEnd{CycleStatus::Converged,
                      fmt::format("the optimum lies inside the move limits ({})", answer.reason)};
    else if (moved < kStands)
      end_ = CycleEnd{CycleStatus::Infeasible, infeasible(answer)};
  }

  static std::string infeasible(const NlpResult& answer) {
    if (answer.conflict.empty()) return answer.reason;
    const NlpViolation& v = answer.conflict.front();
    return fmt::format("'{}' cannot be met within the bounds: it stays {:.3g} % above its limit",
                       v.name, 100 * v.g);
  }

  void finish(StaticShape& problem, const VectorXd& x) {
    const SolidCheck& check = result_.history.back().check;
    result_.status = end_ ? end_->status : CycleStatus::CycleLimit;
    result_.reason =
        end_ ? end_->reason
             : fmt::format("{} steps are used up and the outline still moves", task_.cycle.max);
    if (result_.status == CycleStatus::Converged && check.worst > task_.cycle.feasibility) {
      result_.status = CycleStatus::Infeasible;
      result_.reason =
          fmt::format("'{}' is {:.3g} % above its limit", check.worst_limit, 100 * check.worst);
    }
    result_.x = x;
    problem.show_all(x);
    result_.fractions = problem.statics().fractions();
    result_.displacements = problem.statics().u();
    result_.von_mises = von_mises(problem.statics(), task_.stress.relaxation);
  }

  const SolidTask& task_;
  const ShapeMoves moves_;
  const ShapeHooks& hooks_;
  NlpWarmStart warm_;
  std::optional<CycleEnd> end_;
  ShapeResult result_;
};

}  // namespace

ShapeResult optimise_shape(const SolidTask& task, const ShapeMoves& moves,
                           const ShapeHooks& hooks) {
  return ShapeCycle(task, moves, hooks).run();
}

}  // namespace liesl
