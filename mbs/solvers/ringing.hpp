#pragma once
/// @file
/// Do the joint forces change sign at every step? In index 3 the error of the multipliers has a
/// part (-rho_inf)^n, which rho_inf = 1 never calms (A. Cardona, M. Geradin, Comput. Struct. 33
/// (1989) 801-820). An alternating part of size a stands alone in the second difference,
///   D_n = lambda_n - 2 lambda_{n-1} + lambda_{n-2} = +-4 a,
/// where forces that follow the motion leave O(h^2).

#include <Eigen/Core>

namespace liesl {

/// Watches the multipliers of accepted steps.
class Ringing {
 public:
  /// Multipliers [N, N m] after a step of size h [s]. Differences need steps of one size: after
  /// another h it begins anew, and keeps its count.
  void step(const Eigen::VectorXd& lambda, double h);

  /// At every second step or more, of all so far?
  bool lasts() const { return 2 * rings_ > steps_; }

  /// Alternating part over the multipliers, mean of the steps that ring; 0 if none does.
  double share() const { return rings_ > 0 ? share_ / static_cast<double>(rings_) : 0; }

  /// The largest rho_inf, rounded down to a hundredth, with which a part that starts as large falls
  /// below what is worth telling in half of the steps n: share (n/2) rho^(n/2) = 0.01 (the root
  /// -rho_inf is a multiple one, hence the factor n/2). Needs lasts().
  double calm_rho() const;

 private:
  double h_ = 0, share_ = 0;
  long known_ = 0, steps_ = 0, rings_ = 0;
  Eigen::VectorXd before_, earlier_, difference_, last_;
};

}  // namespace liesl
