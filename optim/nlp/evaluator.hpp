#pragma once
/// @file
/// The scaled view of a problem that all drivers consume, with a cache of the last points.

#include <Eigen/Core>
#include <chrono>
#include <exception>
#include <list>
#include <optional>
#include <string>

#include "optim/nlp/problem.hpp"
#include "optim/nlp/result.hpp"

namespace liesl {

/// Values and gradients of a problem at x, in its own units.
struct NlpPoint {
  Eigen::VectorXd x;
  double f = 0;
  Eigen::VectorXd g;
  bool has_gradients = false;
  Eigen::VectorXd df;  ///< empty unless has_gradients
  RowMatrix dg;        ///< empty unless has_gradients
};

/// Scaled quantities: y_j = x_j / x_scale_j, F = f / f_scale, G_i = g_i / g_scale_i.
struct NlpScaling {
  Eigen::VectorXd x;  ///< range of the variable; largest 1000 |start|, and |start| or 1 without one
  double f = 1;       ///< |f| at the start, at least 1/100 of the largest |df_j| x_j
  Eigen::VectorXd g;  ///< NlpConstraint::scale

  static Eigen::VectorXd of_variables(const Problem& problem);
  static NlpScaling at(const Problem& problem, const NlpPoint& point);
};

/// Start of a problem, moved into its bounds.
Eigen::VectorXd start_of(const Problem& problem);
/// Largest scaled violation, 0 if feasible.
double largest_violation(const Eigen::VectorXd& g, const Eigen::VectorXd& scale);

/// Keeps the contract of Problem for whatever order an optimiser calls in: evaluates once per
/// point, turns values that are not finite and exceptions into `false`, counts, remembers the best
/// point. Every method that takes y returns false if nothing can be had there; then `failure`
/// says why, and `rethrow` hands on an exception. After an exception nothing is evaluated.
class Evaluator {
 public:
  static constexpr int kForgivenFailures = 30;

  /// Evaluates values and gradients at the start and derives the scaling from them.
  Evaluator(Problem& problem, const NlpOptions& options);

  bool usable() const { return usable_; }  ///< the start could be evaluated
  int n() const { return static_cast<int>(problem_.variables().size()); }
  int m() const { return static_cast<int>(problem_.constraints().size()); }
  Problem& problem() const { return problem_; }
  const NlpScaling& scaling() const { return scaling_; }
  Eigen::VectorXd lower() const;  ///< of y
  Eigen::VectorXd upper() const;
  Eigen::VectorXd start() const;
  Eigen::VectorXd unscaled(const Eigen::VectorXd& y) const;  ///< x, within the bounds

  bool values(const Eigen::VectorXd& y);
  bool gradients(const Eigen::VectorXd& y);  ///< implies values
  /// Lower triangle (or diagonal) of sigma F'' + sum lambda_i G_i'' with respect to y.
  bool hessian(const Eigen::VectorXd& y, double sigma, const Eigen::VectorXd& lambda);

  /// Point of the last successful call, and what it gives in scaled quantities.
  const NlpPoint& point() const { return points_.front(); }
  double F() const { return point().f / scaling_.f; }
  Eigen::VectorXd G() const { return point().g.cwiseQuotient(scaling_.g); }
  Eigen::VectorXd dF() const { return point().df.cwiseProduct(scaling_.x) / scaling_.f; }
  void dG(double* row_major) const;  ///< m x n
  RowMatrix dG() const;
  const Eigen::MatrixXd& H() const { return hessian_; }

  /// Runs `call` and keeps its exception: for everything called from C or from Ipopt.
  template <class Call>
  bool guard(Call&& call) {
    if (exception_) return false;
    try {
      return call();
    } catch (...) {
      exception_ = std::current_exception();
      return false;
    }
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }
  bool broken() const { return exception_ != nullptr; }
  /// Too many new points in a row without a value: nothing is evaluated any more.
  bool given_up() const { return failures_in_a_row_ >= kForgivenFailures; }
  const std::string& failure() const { return failure_; }
  /// `reason`, and the latest failure if it does not say it already.
  std::string with_failure(const std::string& reason) const;

  /// True to go on: calls the user's progress function and looks at the clock.
  bool proceed(int iteration);
  bool out_of_time() const { return seconds() > options_.time_limit; }
  double seconds() const;

  /// Best point so far: least f among the feasible ones, else least violation.
  const std::optional<NlpPoint>& best() const { return best_; }
  /// Fills x, f, g, violation, counts and time from `point`.
  void report(const NlpPoint& point, NlpResult& result) const;
  /// dF + sum lambda_i dG_i at point() (with gradients); lambda of the scaled constraints.
  Eigen::VectorXd residual(const Eigen::VectorXd& lambda) const;
  /// Largest component of a residual that no bound can carry: one that point() is at, within 1e-6,
  /// and that pushes the right way.
  double stationarity(const Eigen::VectorXd& residual) const;

 private:
  bool values_at(const Eigen::VectorXd& x);
  bool gradients_at(const Eigen::VectorXd& x);
  /// Makes the problem's own state belong to p: the calls that are due, in the order promised.
  /// p keeps what it had if they give nothing finite.
  bool bring_back(NlpPoint& p, bool with_gradients);
  bool finite_values(const NlpPoint& p);
  bool finite_gradients(const NlpPoint& p);
  void remember(const NlpPoint& p);

  Problem& problem_;
  const NlpOptions& options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  NlpScaling scaling_;
  std::list<NlpPoint> points_;                ///< latest first, at most three
  Eigen::VectorXd current_, differentiated_;  ///< x of the latest values(), gradients()
  Eigen::VectorXd failed_at_;                 ///< latest x without a value
  Eigen::VectorXd no_point_;                  ///< NaN: differs from every x
  Eigen::MatrixXd hessian_;
  std::optional<NlpPoint> best_;
  double best_violation_ = 0;
  std::exception_ptr exception_;
  std::string failure_;
  bool usable_ = false;
  int evaluations_ = 0, gradient_evaluations_ = 0, failed_ = 0, failures_in_a_row_ = 0;
};

}  // namespace liesl
