#pragma once
/// @file
/// Numeric differentiation of functions between groups and vector spaces, and a step sweep that
/// judges an analytic derivative by the slope of its error, not by one lucky step.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#include "liegroup/concepts.hpp"

namespace liesl {

/// Tangent of a point: that of its group, or the vector itself, or a 1-vector for a number.
template <class X>
struct TangentOf {
  using type = Eigen::Matrix<double, X::RowsAtCompileTime, 1>;
};
template <LieGroup X>
struct TangentOf<X> {
  using type = typename X::Tangent;
};
template <std::floating_point X>
struct TangentOf<X> {
  using type = Eigen::Matrix<double, 1, 1>;
};

/// x moved by d: x exp(d) in a group (left-invariant increment), x + d in a vector space.
template <class X, class D>
X retract(const X& x, const D& d) {
  if constexpr (LieGroup<X>)
    return x * X::exp(d);
  else if constexpr (std::floating_point<X>)
    return x + d[0];
  else
    return x + d;
}

/// The d with retract(from, d) = to.
template <class X>
typename TangentOf<X>::type difference(const X& from, const X& to) {
  if constexpr (LieGroup<X>)
    return X::log(from.inverse() * to);
  else if constexpr (std::floating_point<X>)
    return typename TangentOf<X>::type(to - from);
  else
    return to - from;
}

/// Largest absolute coefficient; infinity if one of them is not a finite number.
template <class Derived>
double max_norm(const Eigen::MatrixBase<Derived>& A) {
  double largest = 0;
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      const double a = std::abs(A(i, j));
      if (!std::isfinite(a)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, a);
    }
  }
  return largest;
}

/// Step of central_difference that balances truncation and rounding for arguments of size one.
inline constexpr double kCentralStep = 6e-6;

/// J [dim of f(x) x dim of x] with f(x exp(d)) = f(x) exp(J d) to first order; error O(step^2).
/// x and f(x) are group elements, Eigen column vectors (f must return a value, not an expression)
/// or double. Dynamic sizes are allowed.
template <class F, class X>
auto central_difference(const F& f, const X& x, double step = kCentralStep) {
  using Dx = typename TangentOf<X>::type;
  using Dy = typename TangentOf<std::remove_cvref_t<decltype(f(x))>>::type;
  const auto n = [&]() -> Eigen::Index {
    if constexpr (Dx::RowsAtCompileTime == Eigen::Dynamic)
      return x.size();
    else
      return Dx::RowsAtCompileTime;
  }();
  Eigen::Matrix<double, Dy::RowsAtCompileTime, Dx::RowsAtCompileTime> J;
  for (Eigen::Index i = 0; i < n; ++i) {
    Dx d = Dx::Zero(n);
    d[i] = step;
    const auto plus = f(retract(x, d));
    d[i] = -step;
    const Dy column = difference(f(retract(x, d)), plus) / (2 * step);
    if (i == 0) J.resize(column.size(), n);
    J.col(i) = column;
  }
  return J;
}

/// What a sweep of steps says about an analytic derivative.
struct StepSweep {
  double best_error = 0;  ///< smallest max-norm error over the steps
  double best_step = 0;
  double largest_step_error = 0;
  double slope = 0;      ///< of log(error) over log(step) where truncation rules; 2 when right
  int slope_points = 0;  ///< steps the slope was fitted to; below 3 there is no slope

  /// Right derivative: the error falls with the step's square down to `tolerance`, or stays below
  /// it at every step (no third derivative to speak of).
  bool confirms(double tolerance, double slope_tolerance = 0.1) const {
    if (largest_step_error <= tolerance) return true;
    return best_error <= tolerance && slope_points >= 3 && std::abs(slope - 2) <= slope_tolerance;
  }

  static constexpr double kLargest = 0.05;  ///< first step; then kCount - 1 more, each shorter
  static constexpr double kRatio = 0.5623413251903491;  ///< 10^(-1/4)
  static constexpr int kCount = 23;                     ///< down to 1.6e-7
};

/// Compares J with central differences of f at x over the steps of StepSweep. The slope is the
/// least-squares line through the steps above the best one whose error is 30 times the best.
template <class F, class X, class Jacobian>
StepSweep step_sweep(const F& f, const X& x, const Jacobian& J) {
  std::array<double, StepSweep::kCount> step, error;
  for (std::size_t k = 0; k < step.size(); ++k) {
    step[k] = k == 0 ? StepSweep::kLargest : step[k - 1] * StepSweep::kRatio;
    const auto deviation = (central_difference(f, x, step[k]) - J).eval();
    error[k] = std::min(max_norm(deviation), std::numeric_limits<double>::max());
  }
  const auto best =
      static_cast<std::size_t>(std::min_element(error.begin(), error.end()) - error.begin());
  StepSweep sweep{error[best], step[best], error[0], 0, 0};
  double s = 0, e = 0, ss = 0, se = 0;
  for (std::size_t k = 0; k < best && error[k] > 30 * error[best]; ++k) {
    const double a = std::log(step[k]), b = std::log(error[k]);
    s += a, e += b, ss += a * a, se += a * b;
    ++sweep.slope_points;
  }
  const double n = sweep.slope_points;
  if (n >= 3) sweep.slope = (n * se - s * e) / (n * ss - s * s);
  return sweep;
}

}  // namespace liesl
