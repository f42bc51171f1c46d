/// @file
/// Expressions of time by muParser, evaluated by any number of threads.

#include <fmt/format.h>
#include <muParser.h>

#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mbs/model/time_function.hpp"
#include "mbs/model/time_function_kind.hpp"

namespace liesl {

namespace {

/// One compiled expression with its own variable t; used by one thread at a time.
class Evaluator {
 public:
  explicit Evaluator(const std::string& text) {
    parser_.DefineConst("pi", std::numbers::pi);
    parser_.DefineVar("t", &t_);
    parser_.SetExpr(text);
    (*this)(0);  // compile now: later evaluations allocate nothing
  }
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  double operator()(double t) {
    t_ = t;
    return parser_.Eval();
  }
  int results() const { return parser_.GetNumResults(); }
  bool uses_time() const { return !parser_.GetUsedVar().empty(); }

 private:
  double t_ = 0;
  mu::Parser parser_;
};

/// Evaluators of one expression, handed out without a lock: a thread takes one out of the first
/// full slot and puts it back. New ones are made only when more threads evaluate at once than ever
/// before.
class EvaluatorPool {
 public:
  explicit EvaluatorPool(std::string text) : text_(std::move(text)) {
    slots_[0] = new Evaluator(text_);
  }
  ~EvaluatorPool() {
    for (auto& slot : slots_) delete slot.load();
  }
  EvaluatorPool(const EvaluatorPool&) = delete;
  EvaluatorPool& operator=(const EvaluatorPool&) = delete;

  /// Holds an evaluator for the time of one evaluation.
  class Loan {
   public:
    explicit Loan(EvaluatorPool& pool) : pool_(pool), evaluator_(pool.take()) {}
    ~Loan() { pool_.give_back(evaluator_); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    double operator()(double t) { return (*evaluator_)(t); }

   private:
    EvaluatorPool& pool_;
    Evaluator* evaluator_;
  };

 private:
  Evaluator* take() {
    for (auto& slot : slots_)
      if (Evaluator* e = slot.exchange(nullptr, std::memory_order_acquire)) return e;
    return new Evaluator(text_);
  }
  void give_back(Evaluator* e) {
    for (auto& slot : slots_) {
      Evaluator* empty = nullptr;
      if (slot.compare_exchange_strong(empty, e, std::memory_order_release)) return;
    }
    delete e;
  }

  std::string text_;
  std::array<std::atomic<Evaluator*>, 64> slots_ = {};
};

/// Steps that balance the truncation (h w)^4/30, (h w)^4/90 of a motion of frequency w = 1..1000
/// rad/s with the round-off 1e-16/h, 1e-16/h^2.
constexpr double rate_step = 0x1p-13, acceleration_step = 0x1p-12;

struct Expression final : TimeFunctionKind {
  Expression(const std::string& text, bool constant) : pool_(text), constant_(constant) {}

  double value(double t) const override { return EvaluatorPool::Loan(pool_)(t); }

  /// Central; forward where the expression is undefined before t (sqrt, log at t = 0).
  double rate(double t) const override {
    EvaluatorPool::Loan f(pool_);
    const double h = rate_step;
    const double central = (f(t - 2 * h) - 8 * f(t - h) + 8 * f(t + h) - f(t + 2 * h)) / (12 * h);
    if (std::isfinite(central)) return central;
    return (-25 * f(t) + 48 * f(t + h) - 36 * f(t + 2 * h) + 16 * f(t + 3 * h) - 3 * f(t + 4 * h)) /
           (12 * h);
  }

  double acceleration(double t) const override {
    EvaluatorPool::Loan f(pool_);
    const double h = acceleration_step;
    const double f0 = f(t);
    const double central =
        (-f(t - 2 * h) + 16 * f(t - h) - 30 * f0 + 16 * f(t + h) - f(t + 2 * h)) / (12 * h * h);
    if (std::isfinite(central)) return central;
    return (45 * f0 - 154 * f(t + h) + 214 * f(t + 2 * h) - 156 * f(t + 3 * h) + 61 * f(t + 4 * h) -
            10 * f(t + 5 * h)) /
           (12 * h * h);
  }

  bool is_constant() const override { return constant_; }

 private:
  mutable EvaluatorPool pool_;  // holds scratch memory only
  bool constant_;
};

}  // namespace

TimeFunction TimeFunction::expression(const std::string& text) {
  constexpr auto expected = "expected a formula of t (s) such as \"sin(2*pi*t)\"";
  try {
    Evaluator trial(text);
    if (trial.results() != 1)
      throw std::invalid_argument(
          fmt::format("expression \"{}\": {}, got {} formulas separated by commas; decimals are "
                      "written with a point",
                      text, expected, trial.results()));
    return TimeFunction(std::make_shared<Expression>(text, !trial.uses_time()));
  } catch (const mu::Parser::exception_type& e) {
    throw std::invalid_argument(fmt::format("expression \"{}\": {}, got: {} (at character {})",
                                            text, expected, e.GetMsg(), e.GetPos() + 1));
  }
}

}  // namespace liesl
