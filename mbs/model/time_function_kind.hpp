#pragma once
/// @file
/// What each kind of time function implements; private to the folder.

#include <memory>
#include <string>

#include "mbs/model/time_function.hpp"

namespace liesl {

/// One kind of function: immutable, evaluated by several threads at once.
struct TimeFunction::Kind {
  virtual ~Kind() = default;
  virtual double value(double t) const = 0;
  virtual double rate(double t) const = 0;
  virtual double acceleration(double t) const = 0;
  virtual bool is_constant() const = 0;
};

}  // namespace liesl
