#pragma once
/// @file
/// The models of a mechanism at neighbouring values of a parameter, on the unknowns of one of them.

#include <memory>
#include <vector>

#include "mbs/model/parameter.hpp"
#include "mbs/system/equations.hpp"

namespace liesl {

/// Derivatives by p at constant state, as sums of weights times what the nearby models have; of
/// bodies that have a derivative by their shape (`Body::by_shape`) that instead.
template <FrameGroup G>
class NearbyModels {
 public:
  struct Neighbour {
    double weight;  ///< 1 per unit of p
    const Mechanism& mechanism;
    Model<G> model;
    Equations<G> equations;
    /// By node, from the frame at rest of the model to that of this one; of nodes that go together
    /// the way in the axes of the first frame of their body, and the turn.
    std::vector<G> moved;
    Neighbour(double weight, const Mechanism& mechanism, const Model<G>& model);
  };

  /// @throws std::invalid_argument if they have other unknowns or rows than the model, or bodies in
  /// floating frames, whose modes change with p  @param model outlives this
  NearbyModels(const NearbyMechanisms& mechanisms, const Model<G>& model);

  const std::vector<std::unique_ptr<Neighbour>>& models() const { return models_; }
  /// r_p += dr/dp, phi_p += dPhi/dp, as `ParameterResidual::add`.
  void add(const State<G>& s, const Eigen::VectorXd& previous, const LoadLevel& level,
           Eigen::VectorXd& r_p, Eigen::VectorXd& phi_p) const;
  /// xi by node, what the frames at rest change by, in their own axes; in bodies with positions all
  /// nodes go together, in the axes of the first frame of their body. Empty where they do not
  /// change, or where nodes do not move along the group.
  const Eigen::VectorXd& lift() const { return lift_; }
  /// Does the geometry change the shape of bodies at rest while no lift is known? Then a constant
  /// state strains them by what p changes, far more than a motion may.
  bool strains() const { return strains_; }
  /// By node: the first frame of a body whose nodes go together, else the node itself.
  const std::vector<int>& carriers() const { return carriers_; }
  /// The same as `add`, of states that go with the geometry: H D(p), Ad(D^-1) v, Ad(D^-1) vdot with
  /// D(p) from the frames at rest to those at p, d/dp: xi, ad(v) xi, ad(vdot) xi. No element is
  /// strained by that, so that EA/L is not in the differences. Positions go as if they were fixed
  /// to the first frame R_0 of their body: x + R_0 xi; what strains them then is the strain of the
  /// body times xi, not xi. So do further frames of such a body, which turn by their own way. @pre
  /// lift() is not empty
  void add_lifted(const State<G>& s, const Eigen::VectorXd& previous, const LoadLevel& level,
                  Eigen::VectorXd& r_p, Eigen::VectorXd& phi_p) const;
  /// d/dp of the state of one node that goes with the geometry: its increment, that of v and that
  /// of a rate of v, `rates` (vdot, or the acceleration-like variable). @pre lift() is not empty
  struct NodeDirection {
    typename G::Tangent eta, v, rate;
  };
  NodeDirection direction(const State<G>& s, const Eigen::VectorXd& rates, int node) const;
  /// The state that goes with the geometry to a nearby model. @param lifted as large as s
  void lift(const Neighbour& neighbour, const State<G>& s, State<G>& lifted) const;
  /// A state as a nearby model sees it: its rows, and the frames that follow.
  static State<G> seen_by(const Neighbour& neighbour, const State<G>& s);

 private:
  using Vector = typename Model<G>::Vector;
  /// What a carried node has of its position, velocity and rate, in its own axes.
  struct Shift {
    Vector x, v, vdot;
  };
  Shift shift_of(const State<G>& s, const Eigen::VectorXd& rates, int node, const Vector& xi) const;
  /// A body whose forces are not differenced.
  struct Shape {
    int body;
    std::unique_ptr<ShapeDerivative<G>> forces;
    std::unique_ptr<BodyWorkspace> work;
  };
  void set_lift();
  void set_shapes();
  void add_shapes(const State<G>& s, const LoadLevel& level, bool lifted,
                  Eigen::VectorXd& r_p) const;

  const Model<G>& model_;
  std::vector<std::unique_ptr<Neighbour>> models_;
  std::vector<Shape> shapes_;
  Eigen::VectorXd lift_;
  std::vector<int> carriers_;
  std::vector<char> frames_;  ///< by node: is it a frame?
  bool strains_ = false;
};

/// What a point that is fixed to a frame at xi, in its axes, has of its rates: R_0^T x', with v and
/// vdot of the frame: omega x xi and omega' x xi + omega x (omega x xi).
template <FrameGroup G>
struct CarriedRates {
  using Vector = typename Model<G>::Vector;
  Vector v, vdot;
  CarriedRates(const typename G::Tangent& frame_v, const typename G::Tangent& frame_vdot,
               const Vector& xi) {
    typename G::Tangent way = G::Tangent::Zero(), turned = way;
    way.template head<G::space_dim>() = xi;
    v = (G::ad(frame_v) * way).template head<G::space_dim>();
    turned.template head<G::space_dim>() = v;
    vdot = (G::ad(frame_vdot) * way + G::ad(frame_v) * turned).template head<G::space_dim>();
  }
};

extern template class NearbyModels<SE2>;
extern template class NearbyModels<SE3>;

}  // namespace liesl
