#include "mbs/sensitivity/response_sensitivity.hpp"

namespace liesl {

using Eigen::Index;
using Eigen::MatrixXd;

template <FrameGroup G>
ResponseSensitivity<G>::ResponseSensitivity(const Model<G>& model, const ResponseValues<G>& values,
                                            ResponseSpec response, const Parameters<G>& parameters)
    : model_(model), values_(values), response_(std::move(response)), parameters_(parameters) {}

template <FrameGroup G>
MatrixXd ResponseSensitivity<G>::by_parameters(const State<G>& s, Index components) const {
  State<G> completed = s;
  model_.complete(completed);
  MatrixXd y_p(components, static_cast<Index>(parameters_.size()));
  for (size_t i = 0; i < parameters_.size(); ++i)
    y_p.col(static_cast<Index>(i)) = values_.by_parameter(response_, completed, parameters_[i]);
  return y_p;
}

template <FrameGroup G>
MatrixXd ResponseSensitivity<G>::operator()(const State<G>& s, const StateSensitivity& ds) const {
  const auto gradient = values_.gradient(response_, s);
  MatrixXd dy = by_parameters(s, static_cast<Index>(gradient.size()));
  for (size_t c = 0; c < gradient.size(); ++c) {
    auto row = dy.row(static_cast<Index>(c));
    for (const auto& node : gradient[c].nodes)
      row += node.h.transpose() * ds.eta.template middleRows<G::dim>(G::dim * node.node) +
             node.v.transpose() * ds.v.template middleRows<G::dim>(G::dim * node.node);
    for (const auto& multiplier : gradient[c].lambda)
      row += multiplier.value * ds.lambda.row(multiplier.row);
  }
  return dy;
}

template <FrameGroup G>
void ResponseSensitivity<G>::add_cotangents(const State<G>& s, const Eigen::VectorXd& weight,
                                            int column, StateSensitivity& bars,
                                            MatrixXd& gradient) const {
  const auto y_h = values_.gradient(response_, s);
  for (size_t c = 0; c < y_h.size(); ++c) {
    const double factor = weight[static_cast<Index>(c)];
    for (const auto& node : y_h[c].nodes) {
      bars.eta.col(column).template segment<G::dim>(G::dim * node.node) += factor * node.h;
      bars.v.col(column).template segment<G::dim>(G::dim * node.node) += factor * node.v;
    }
    for (const auto& multiplier : y_h[c].lambda)
      bars.lambda(multiplier.row, column) += factor * multiplier.value;
  }
  gradient.col(column) += by_parameters(s, weight.size()).transpose() * weight;
}

template class ResponseSensitivity<SE2>;
template class ResponseSensitivity<SE3>;

}  // namespace liesl
