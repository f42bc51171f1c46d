#include "optim/design/constants.hpp"

#include <stdexcept>

#include "mbs/solvers/stretched.hpp"
#include "optim/design/drive_tables.hpp"

namespace liesl {
namespace {

constexpr double kDifference = 1. / 1024;  // of the range of a value of a table

bool in_mechanism(const ConstantSpec& c) { return !sets_motion(c); }

std::vector<double> list(const Eigen::VectorXd& x) { return {x.data(), x.data() + x.size()}; }

std::string unit_of(const ConstantSpec& c) {
  switch (c.quantity) {
    case ConstantQuantity::Mass:
      return "kg";
    case ConstantQuantity::Stiffness:
      return c.turns ? "N m/rad" : "N/m";
    case ConstantQuantity::Damping:
      return c.turns ? "N m s/rad" : "N s/m";
    case ConstantQuantity::Rest:
    case ConstantQuantity::DriveValue:
      return c.turns ? "rad" : "m";
    case ConstantQuantity::Duration:
      return "s";
  }
  return "";
}

}  // namespace

Constants::Constants(const StudySpec& study, const Mechanism& mechanism)
    : constants_(study.constants), drives_(study.drives), duration_(study.duration) {
  Mechanism at = mechanism;
  for (const ConstantSpec& c : constants_) {
    variables_.push_back({c.name, c.lower, c.upper, c.start ? *c.start : constant_of(c, at)});
    units_.push_back(unit_of(c));
  }
}

int Constants::duration() const {
  for (int i = 0; i < size(); ++i)
    if (constants_[static_cast<std::size_t>(i)].quantity == ConstantQuantity::Duration) return i;
  return -1;
}

TimeFunction Constants::motion(int table, const Eigen::VectorXd& x) const {
  DriveTable at = drive_tables(constants_, drives_, duration_, list(x))[std::size_t(table)];
  return TimeFunction::table(std::move(at.t), std::move(at.q), at.how);
}

void Constants::apply(const Eigen::VectorXd& x, Mechanism& mechanism) const {
  for (int i = 0; i < size(); ++i)
    if (const ConstantSpec& c = constants_[static_cast<std::size_t>(i)]; in_mechanism(c))
      constant_of(c, mechanism) = x[i];
  for (int k = 0; k < static_cast<int>(drives_.size()); ++k)
    mechanism.drives.at(static_cast<std::size_t>(drives_[std::size_t(k)].drive)).motion =
        motion(k, x);
}

SimulationOptions Constants::simulation(SimulationOptions options, const Eigen::VectorXd& x) const {
  if (duration() < 0) return options;
  return stretched(options, x[duration()] / options.duration);
}

/// d(motion)/d(value): differences of fourth order. Linear tables have it exactly; slopes of cubic
/// ones depend on their values.
DriveDerivative Constants::by_value(int i, const Eigen::VectorXd& x) const {
  const ConstantSpec& c = constants_[static_cast<std::size_t>(i)];
  const double h = kDifference * (c.upper - c.lower);
  DriveDerivative by{drives_[static_cast<std::size_t>(c.drive)].drive, 0, {}};
  for (const auto& [steps, weight] : {std::pair{-2, 1.}, {-1, -8.}, {1, 8.}, {2, -1.}}) {
    Eigen::VectorXd at = x;
    at[i] += steps * h;
    by.motion.push_back({weight / (12 * h), motion(c.drive, at)});
  }
  return by;
}

std::vector<Parameter> Constants::parameters(const Mechanism&, const Eigen::VectorXd& x) const {
  std::vector<Parameter> all;
  for (int i = 0; i < size(); ++i) all.push_back(parameter(i, x));
  return all;
}

Parameter Constants::parameter(int i, const Eigen::VectorXd& x) const {
  const ConstantSpec& c = constants_[static_cast<std::size_t>(i)];
  Parameter p{c.name, {}};
  if (c.quantity == ConstantQuantity::DriveValue) {
    p.parts.emplace_back(by_value(i, x));
    return p;
  }
  if (c.quantity == ConstantQuantity::Duration) {
    p.parts.emplace_back(StepDerivative{1 / x[i]});
    return p;
  }
  if (c.quantity == ConstantQuantity::Mass) {
    RigidDerivative by;
    by.body = c.body;
    by.mass = 1;
    p.parts.emplace_back(by);
    return p;
  }
  ForceDerivative by;
  by.force = c.force;
  by.stiffness = c.quantity == ConstantQuantity::Stiffness;
  by.damping = c.quantity == ConstantQuantity::Damping;
  by.rest = c.quantity == ConstantQuantity::Rest;
  p.parts.emplace_back(by);
  return p;
}

}  // namespace liesl
