#include "mbs/sensitivity/response_sensitivity.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace liesl {

using Eigen::Index;
using Eigen::MatrixXd;

template <FrameGroup G>
ResponseSensitivity<G>::ResponseSensitivity(const Model<G>& model, const ResponseValues<G>& values,
                                            ResponseSpec response, const Parameters<G>& parameters)
    : model_(model), values_(values), response_(std::move(response)), parameters_(parameters) {
  explicit_ = ResponseValues<G>::depends_on_law(response_.kind);
  for (const auto& parameter : parameters) {
    explicit_ = explicit_ || parameter.nearby();
    if (!parameter.nearby() || !parameter.nearby()->strains()) continue;
    if (response_.kind == ResponseKind::Compliance || response_.kind == ResponseKind::Energy)
      throw std::invalid_argument(fmt::format(
          "'{}' changes the shape of bodies whose nodes do not move along the group, "
          "which has no derivative of '{}': expected simulation.formalism = \"se3\", or "
          "another response",
          parameter.parameter().name, name_of(response_.kind)));
  }
}

/// Differences of what the nearby models make of the state, or of the state that goes with them.
template <FrameGroup G>
Eigen::VectorXd ResponseSensitivity<G>::by_nearby(const NearbyModels<G>& nearby, const State<G>& s,
                                                  const State<G>& completed,
                                                  Index components) const {
  Eigen::VectorXd y_p = Eigen::VectorXd::Zero(components);
  State<G> at = s;
  for (const auto& neighbour : nearby.models()) {
    if (nearby.lift().size() > 0) nearby.lift(*neighbour, s, at);
    const ResponseValues<G> values(neighbour->mechanism, neighbour->model);
    const State<G> seen = NearbyModels<G>::seen_by(*neighbour, at);
    y_p += neighbour->weight * values_.of_neighbour(response_, completed, values, seen);
  }
  return y_p;
}

template <FrameGroup G>
MatrixXd ResponseSensitivity<G>::by_state(const Gradient& gradient,
                                          const StateSensitivity& ds) const {
  MatrixXd dy = MatrixXd::Zero(static_cast<Index>(gradient.size()), ds.eta.cols());
  for (size_t c = 0; c < gradient.size(); ++c) {
    auto row = dy.row(static_cast<Index>(c));
    for (const auto& node : gradient[c].nodes)
      row += node.h.transpose() * ds.eta.template middleRows<G::dim>(G::dim * node.node) +
             node.v.transpose() * ds.v.template middleRows<G::dim>(G::dim * node.node) +
             node.vdot.transpose() * ds.w.template middleRows<G::dim>(G::dim * node.node);
    for (const auto& multiplier : gradient[c].lambda)
      row += multiplier.value * ds.lambda.row(multiplier.row);
  }
  return dy;
}

template <FrameGroup G>
MatrixXd ResponseSensitivity<G>::by_parameters(const State<G>& s, const Gradient& gradient) const {
  const auto components = static_cast<Index>(gradient.size());
  MatrixXd y_p = MatrixXd::Zero(components, static_cast<Index>(parameters_.size()));
  if (!explicit_) return y_p;
  State<G> completed = s;
  model_.complete(completed);
  for (size_t i = 0; i < parameters_.size(); ++i)
    if (const auto* nearby = parameters_[i].nearby())
      y_p.col(static_cast<Index>(i)) = by_nearby(*nearby, s, completed, components);
    else if (ResponseValues<G>::depends_on_law(response_.kind))
      y_p.col(static_cast<Index>(i)) = values_.by_parameter(response_, completed, parameters_[i]);
  if (any_lifted(parameters_)) y_p -= by_state(gradient, lift_of(model_, parameters_, s));
  return y_p;
}

template <FrameGroup G>
MatrixXd ResponseSensitivity<G>::operator()(const State<G>& s, const StateSensitivity& ds) const {
  const auto gradient = values_.gradient(response_, s);
  return by_parameters(s, gradient) + by_state(gradient, ds);
}

template <FrameGroup G>
void ResponseSensitivity<G>::add_cotangents(const State<G>& s, const MatrixXd& weights, int column,
                                            StateSensitivity& bars, MatrixXd& gradient) const {
  const auto y_h = values_.gradient(response_, s);
  const auto k = weights.cols();
  for (size_t c = 0; c < y_h.size(); ++c) {
    const auto factors = weights.row(static_cast<Index>(c));
    for (const auto& node : y_h[c].nodes) {
      const auto first = G::dim * node.node;
      bars.eta.block(first, column, G::dim, k) += node.h * factors;
      bars.v.block(first, column, G::dim, k) += node.v * factors;
      bars.w.block(first, column, G::dim, k) += node.vdot * factors;
    }
    for (const auto& multiplier : y_h[c].lambda)
      bars.lambda.row(multiplier.row).segment(column, k) += multiplier.value * factors;
  }
  if (explicit_) gradient.middleCols(column, k) += by_parameters(s, y_h).transpose() * weights;
}

template class ResponseSensitivity<SE2>;
template class ResponseSensitivity<SE3>;

}  // namespace liesl
