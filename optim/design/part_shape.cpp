#include "optim/design/part_shape.hpp"

#include <stdexcept>

namespace liesl {
namespace {

const SolidSpec& outlined(const Mechanism& mechanism, int body) {
  const auto* solid = std::get_if<SolidSpec>(&mechanism.bodies.at(body).kind);
  if (!solid || solid->outline.features.empty())
    throw std::invalid_argument("design: '" + mechanism.bodies[body].name +
                                "' has no outline; expected a meshed part with features");
  return *solid;
}

}  // namespace

PartShape::PartShape(const Mechanism& mechanism, int body_index, const ShapeDesignSpec& spec)
    : body(body_index),
      shape(make_shape(outlined(mechanism, body_index).outline)),
      mesh(outlined(mechanism, body_index).model),
      model(*mesh),
      design(spec, *shape, model) {}

Eigen::MatrixXd PartShape::fraction_gradient(const Eigen::VectorXd& x) const {
  shape->set(design.parameters(x));
  const Fractions f = volume_fractions(model.mesh(), *shape);
  return FractionGradient(f.derivative * design.jacobian());
}

std::vector<Parameter> PartShape::parameters(const Mechanism&, const Eigen::VectorXd& x) const {
  const Eigen::MatrixXd by = fraction_gradient(x);
  std::vector<Parameter> all;
  for (int j = 0; j < by.cols(); ++j)
    all.push_back({design.variables()[j].name, {SolidDerivative{body, by.col(j)}}});
  return all;
}

void PartShape::apply(const Eigen::VectorXd& x, Mechanism& mechanism) const {
  set_values(std::get<SolidSpec>(mechanism.bodies[body].kind).outline, design.parameters(x));
}

}  // namespace liesl
