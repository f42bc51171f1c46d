#pragma once
/// @file
/// Sensitivity of a named response from that of the state, component by component:
///   dy/dp = y_h eta + y_v v' + y_vdot w' + y_lambda lambda' + y_p.

#include "mbs/sensitivity/motion_sensitivity.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

/// One response; the states are those of the direct and of the adjoint form, not completed. Where a
/// response is not smooth the derivatives are those of the branch that is active.
template <FrameGroup G>
class ResponseSensitivity {
 public:
  /// @param model, values, parameters outlive this
  /// @throws std::invalid_argument for energies by a geometry with which no states go
  ResponseSensitivity(const Model<G>& model, const ResponseValues<G>& values, ResponseSpec response,
                      const Parameters<G>& parameters);

  /// dy/dp, components x n_p, unit of the response per unit of p.
  Eigen::MatrixXd operator()(const State<G>& s, const StateSensitivity& ds) const;

  /// Adds the cotangents of weights^T y to the columns of `bars` and of `gradient` from `column`
  /// on, see CotangentsAt. @param weights components x functionals
  void add_cotangents(const State<G>& s, const Eigen::MatrixXd& weights, int column,
                      StateSensitivity& bars, Eigen::MatrixXd& gradient) const;

 private:
  using Gradient = std::vector<ResponseGradient<G>>;

  /// y_h eta + y_v v' + y_vdot w' + y_lambda lambda', components x columns.
  Eigen::MatrixXd by_state(const Gradient& gradient, const StateSensitivity& ds) const;
  /// y_p at constant state, components x n_p. By geometry it is that of states that go with it less
  /// what they change: at a constant state a body is strained by far more than its motion does, and
  /// its energy, that is quadratic in the strain, would have no digits left.
  Eigen::MatrixXd by_parameters(const State<G>& s, const Gradient& gradient) const;
  Eigen::VectorXd by_nearby(const NearbyModels<G>& nearby, const State<G>& s,
                            const State<G>& completed, Eigen::Index components) const;

  const Model<G>& model_;
  const ResponseValues<G>& values_;
  const ResponseSpec response_;
  const Parameters<G>& parameters_;
  bool explicit_;  ///< y_p may be other than zero
};

extern template class ResponseSensitivity<SE2>;
extern template class ResponseSensitivity<SE3>;

}  // namespace liesl
