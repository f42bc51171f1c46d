#pragma once
/// @file
/// The models of a mechanism at neighbouring values of a parameter, on the unknowns of one of them.

#include <memory>
#include <vector>

#include "mbs/model/parameter.hpp"
#include "mbs/system/equations.hpp"

namespace liesl {

/// Derivatives by p at constant state, as sums of weights times what the models near by have.
template <FrameGroup G>
class NearbyModels {
 public:
  struct Near {
    double weight;  ///< 1 per unit of p
    const Mechanism& mechanism;
    Model<G> model;
    Equations<G> equations;
    std::vector<G> moved;  ///< by node, from the frame at rest of the model to that of this one
    Near(double weight, const Mechanism& mechanism, const Model<G>& model);
  };

  /// @throws std::invalid_argument if they have other unknowns or rows than the model, or bodies in
  /// floating frames, whose modes change with p
  NearbyModels(const NearbyMechanisms& mechanisms, const Model<G>& model);

  const std::vector<std::unique_ptr<Near>>& models() const { return models_; }
  /// r_p += dr/dp, phi_p += dPhi/dp, as `ParameterResidual::add`.
  void add(const State<G>& s, const Eigen::VectorXd& previous, const LoadLevel& level,
           Eigen::VectorXd& r_p, Eigen::VectorXd& phi_p) const;
  /// xi by node, what the frames at rest change by, in their own axes; empty where they do not, or
  /// where nodes do not move along the group.
  const Eigen::VectorXd& lift() const { return lift_; }
  /// The same as `add`, of states that go with the geometry: H D(p), Ad(D^-1) v, Ad(D^-1) vdot with
  /// D(p) from the frames at rest to those at p, d/dp: xi, ad(v) xi, ad(vdot) xi. No element is
  /// strained by that, so that EA/L is not in the differences. @pre lift() is not empty
  void add_lifted(const State<G>& s, const Eigen::VectorXd& previous, const LoadLevel& level,
                  Eigen::VectorXd& r_p, Eigen::VectorXd& phi_p) const;
  /// A state as a model near by sees it: its rows, and the frames that follow.
  static State<G> seen_by(const Near& near, const State<G>& s);

 private:
  void set_lift(const Model<G>& model);

  std::vector<std::unique_ptr<Near>> models_;
  Eigen::VectorXd lift_;
};

extern template class NearbyModels<SE2>;
extern template class NearbyModels<SE3>;

}  // namespace liesl
