#include "optim/design/constants.hpp"

#include <algorithm>
#include <stdexcept>

namespace liesl {
Constants::Constants(const std::vector<ConstantSpec>& constants, const Mechanism& mechanism)
    : constants_(constants) {
  Mechanism at = mechanism;
  for (const ConstantSpec& c : constants)
    variables_.push_back({c.name, c.lower, c.upper, c.start.value_or(constant_of(c, at))});
}

std::string Constants::unit(int i) const {
  const ConstantSpec& c = constants_[static_cast<std::size_t>(i)];
  switch (c.quantity) {
    case ConstantQuantity::Mass:
      return "kg";
    case ConstantQuantity::Stiffness:
      return c.turns ? "N m/rad" : "N/m";
    case ConstantQuantity::Damping:
      return c.turns ? "N m s/rad" : "N s/m";
    case ConstantQuantity::Rest:
      return c.turns ? "rad" : "m";
  }
  return "";
}

void Constants::apply(const Eigen::VectorXd& x, Mechanism& mechanism) const {
  for (int i = 0; i < size(); ++i)
    constant_of(constants_[static_cast<std::size_t>(i)], mechanism) = x[i];
}

Parameter Constants::parameter(int i) const {
  const ConstantSpec& c = constants_[static_cast<std::size_t>(i)];
  Parameter p{c.name, {}};
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

Eigen::VectorXd Constants::mass_gradient(const std::vector<int>& counted) const {
  Eigen::VectorXd df = Eigen::VectorXd::Zero(size());
  for (int i = 0; i < size(); ++i) {
    const ConstantSpec& c = constants_[static_cast<std::size_t>(i)];
    df[i] = c.quantity == ConstantQuantity::Mass &&
            std::count(counted.begin(), counted.end(), c.body) > 0;
  }
  return df;
}

}  // namespace liesl
