#pragma once
/// @file
/// The characteristic of a spring: force over elongation, as a table.

#include <vector>

#include "mbs/model/time_function.hpp"

namespace liesl {

/// f(x) through points (x_i, f_i), linear or a C1 cubic without overshoot between them, and
/// straight on with the slope of its end outside. Immutable, cheap to copy.
class ForceCurve {
 public:
  /// @param x elongations, strictly increasing, m or rad, at least two  @param f forces, N or N m
  /// @throws std::invalid_argument
  ForceCurve(std::vector<double> x, std::vector<double> f, TimeFunction::Interpolation how);

  double operator()(double x) const;  ///< N or N m
  double slope(double x) const;       ///< df/dx; at a point of a linear table that from the right
  /// Integral of f from 0 to x, J.
  double energy(double x) const;
  /// The points.
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& f() const { return f_; }
  bool operator==(const ForceCurve& other) const {
    return x_ == other.x_ && f_ == other.f_ && how_ == other.how_;
  }

 private:
  double integral(double a, double b) const;

  std::vector<double> x_, f_;
  TimeFunction::Interpolation how_;
  TimeFunction inside_;
  double first_slope_ = 0, last_slope_ = 0;
};

}  // namespace liesl
