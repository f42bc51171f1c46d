#pragma once
/// @file
/// What each kind of time function implements; private to the folder.

namespace liesl {

/// One kind of function: immutable, evaluated by several threads at once.
struct TimeFunctionKind {
  virtual ~TimeFunctionKind() = default;
  virtual double value(double t) const = 0;
  virtual double rate(double t) const = 0;
  virtual double acceleration(double t) const = 0;
  virtual bool is_constant() const = 0;
};

}  // namespace liesl
