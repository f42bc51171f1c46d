#pragma once
/// @file
/// Variables of one kind in a design: what they are, what they change, and the derivatives by them.

#include <string>
#include <vector>

#include "mbs/model/mechanism.hpp"
#include "mbs/model/parameter.hpp"
#include "mbs/solvers/options.hpp"
#include "optim/nlp/problem.hpp"

namespace liesl {

/// A group {variables, apply, derivative of what they change}. x: the variables of the group.
class VariableGroup {
 public:
  virtual ~VariableGroup() = default;

  /// Names, bounds, start; and a unit for each.
  virtual const std::vector<NlpVariable>& variables() const = 0;
  virtual const std::vector<std::string>& units() const = 0;
  int size() const { return static_cast<int>(variables().size()); }

  /// Whether a change of a variable is measured by its range (`range_of`); else by its size at x.
  virtual bool measured_by_range() const { return true; }

  /// Writes x into a mechanism.
  virtual void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const = 0;
  /// How the mechanism with x is simulated.
  virtual SimulationOptions simulation(SimulationOptions options, const Eigen::VectorXd&) const {
    return options;
  }
  /// One a variable, with its name. @param designed the mechanism with x
  virtual std::vector<Parameter> parameters(const Mechanism& designed,
                                            const Eigen::VectorXd& x) const = 0;

  /// Whether the static problem of some part (PartStatics) has these variables; where none has,
  /// limits follow them by the gradients of the motion alone.
  virtual bool has_statics() const { return false; }
};

/// upper - lower; 1 of a variable that is fixed, at a value of a catalogue.
inline double range_of(const NlpVariable& v) { return v.upper > v.lower ? v.upper - v.lower : 1; }

}  // namespace liesl
