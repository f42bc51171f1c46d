#pragma once
/// @file
/// What each kind of time function implements; private to the folder.

#include <memory>
#include <vector>

namespace liesl {

/// One kind of function: immutable, evaluated by several threads at once.
struct TimeFunctionKind {
  virtual ~TimeFunctionKind() = default;
  virtual double value(double t) const = 0;
  virtual double rate(double t) const = 0;
  virtual double acceleration(double t) const = 0;
  virtual bool is_constant() const = 0;
  virtual std::vector<double> knots() const { return {}; }
};

/// Quintic spline through (t_i, f_i), of which rate and acceleration are 0 at both ends.
/// @pre t strictly increasing, two points at least, all finite
std::shared_ptr<const TimeFunctionKind> quintic_table(std::vector<double> t, std::vector<double> f);

}  // namespace liesl
