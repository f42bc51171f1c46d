#pragma once
/// @file
/// Sizes of the steps of a motion. Every multiple of simulation.step, H, is met exactly: sizes are
/// H/2^k, of adaptive steps H/(3 2^k), too, and the rest of H is a multiple of each. So few sizes
/// occur, and the matrices of each are factored once.
///
/// Steps that do not converge are halved and double again after four good ones. Adaptive steps
/// keep the local error l = O(h^3) of each below a limit by a PI controller (K. Gustafsson 1991,
/// ACM Trans. Math. Softw. 17; E. Hairer, G. Wanner, Solving Ordinary Differential Equations II,
/// IV.2; G. Soederlind 2002, Numer. Algorithms 31). It works on the size w that it wants, with the
/// error l (w/h)^3 that a step of it would have, e = l (w/h)^3 / (0.9^3 limit):
///   w <- w e_n^(-0.7/3) e_{n-1}^(0.4/3)     after a step,
///   w <- 0.9 h (limit/l)^(1/3)              where l is above the limit, and the step again,
/// within [0.2 h, 5 h]; h is the largest of the sizes that is not above w. It stays where w is 0.95
/// to 1 of it, and does not grow right after a step that was taken again.

#include "mbs/solvers/generalized_alpha.hpp"

namespace liesl {

class StepControl {
 public:
  /// @param error_limit largest local error of an adaptive step, m, > 0
  StepControl(const SimulationOptions& o, double error_limit);

  /// Of the next attempt, s.
  double h() const { return size(ticks_); }
  /// What the next attempt may be off by, m; infinite where steps are not adaptive, and at the
  /// smallest.
  double error_limit() const;

  /// After an attempt that did not converge, or whose error was above `error_limit()`: a smaller
  /// step. @returns false if there is none
  bool retry(const StepResult& attempt);
  /// After a step, with its error, m.
  void advance(double error);

  /// Whole steps done, or -1 between two of them.
  long whole() const { return done_ == 0 ? whole_ : -1; }
  double time() const;

 private:
  double size(long ticks) const;
  void want(double error);
  long largest(double ticks) const;

  bool adaptive_;
  double step_, limit_;
  long all_ = 1;               ///< ticks of a whole step
  long ticks_;                 ///< of the next attempt
  double wanted_;              ///< ticks
  long whole_ = 0, done_ = 0;  ///< whole steps, and ticks since
  int wait_ = 0;               ///< steps until the size may grow
  double before_ = 1;          ///< e of the step before
};

}  // namespace liesl
