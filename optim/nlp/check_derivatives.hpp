#pragma once
/// @file
/// Derivatives of a problem against central differences over a sweep of steps. A right derivative
/// shows an error that falls with the square of the step until round-off takes over; a wrong one
/// stays where it is. The slope tells this apart from a step that happened to suit.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optim/nlp/problem.hpp"

namespace liesl {

struct DerivativeCheckOptions {
  /// One direction for each variable instead of a single random one (n times the cost).
  bool every_variable = false;
  unsigned seed = 1;                  ///< of the random direction
  double largest_step = 1e-2;         ///< relative to the ranges of the variables, in (0, 0.5]
  int steps = 17;                     ///< each 10^(-1/2) of the one before, >= 3
  double tolerance = 1e-6;            ///< best relative error that counts as right, in (0, 1)
  bool hessian = true;                ///< check it too if the problem has one
  bool avoid_kinks = true;            ///< move off kinks and check there; false: do not judge them
  bool fits = false;                  ///< polynomials fitted to many differences, too (OddFits)
  std::function<void(int)> progress;  ///< called after every pair of points with their number

  /// Pairs of points on both sides of x, in one direction.
  int pairs() const;

  std::vector<std::string> errors() const;
};

/// One function in one direction d (scaled by the ranges D of the variables):
///     e(h) = | (r(x + h D d) - r(x - h D d)) / (2 h) - dr/dx D d | / |dr/dx D|_2,
/// with 1e-3 |r| in the place of a norm below 1e-9 |r|: a function that does not change, as the
/// prescribed coordinate of a joint, differs by round-off.
/// Differences of neighbouring steps are extrapolated to h = 0, too, once and twice: their errors
/// are O(h^4) and O(h^6), so that larger steps do, by which round-off is divided. Which of them is
/// taken does not depend on the derivative: the one that differs least from those it comes from (C.
/// J. F. Ridders, Accurate computation of F'(x) and F'(x) F''(x), Adv. Eng. Software 4 (1982)
/// 75-76).
struct DerivativeCheck {
  std::string function;   ///< "objective", name of a constraint, "Hessian of the Lagrangian"
  std::string direction;  ///< name of a variable, or "random"
  double best_error = 0;  ///< smallest e(h); infinite if no step gave a finite value
  double best_step = 0;   ///< h of it
  double extrapolated_error = 0;  ///< e of the extrapolated difference; infinite without any
  std::optional<double> slope;  ///< of log e over log h where truncation rules: 2 if right; none if
                                ///< the error is round-off at every step (linear functions)
  bool right = false;           ///< best_error <= tolerance
  bool kink = false;            ///< the function has a kink there: no difference tells
  bool round_off = false;       ///< its round-off hides errors above the tolerance: none tells
  std::optional<double> fitted_error;      ///< e of the slope of the best fit, with `fits`
  std::optional<double> fitted_deviation;  ///< standard error of that slope, over the same norm
};

/// A direction in which functions have no derivative at the given point: theirs from the left and
/// from the right differ, or the derivative itself has a kink there.
struct DerivativeKink {
  std::string direction;
  int functions = 0;  ///< how many
  double jump =
      0;  ///< largest difference of the two, relative to |dr/dx D|_2; 0 in the second case
};

struct DerivativeReport {
  Eigen::VectorXd x;                    ///< where: the given point, moved off bounds and kinks
  std::vector<DerivativeKink> kinks;    ///< of the given point
  std::vector<DerivativeCheck> checks;  ///< objective, constraints, Hessian
  int failed_evaluations = 0;           ///< points of the sweep without a finite value
  bool right = false;                   ///< all are that are judged

  /// Largest best_error; none without checks.
  const DerivativeCheck* worst() const;
  /// Table of the wrong ones and the `rows` worst others, one line each, and a verdict.
  std::string text(int rows = 20) const;
};

/// At x, moved inside so that all steps stay within the bounds. Fixed variables are left alone.
/// Where functions have a kink at x, as fractions of cells have when an edge lies on a grid line,
/// no difference tells whether a derivative is right: they are checked at a nearby point
/// (`kinks`), or not judged if the options say so. Functions are not judged where their round-off,
/// which second differences over the smallest steps show, is what keeps the differences from the
/// derivative. The Hessian is checked with sigma = 1 and random lambda in [0.5, 1.5] over the
/// scales of g.
/// @throws std::invalid_argument for invalid input, std::runtime_error without finite values at x
DerivativeReport check_derivatives(Problem& problem, const Eigen::VectorXd& x,
                                   const DerivativeCheckOptions& options = {});

}  // namespace liesl
