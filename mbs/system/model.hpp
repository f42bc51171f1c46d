#pragma once
/// @file
/// A mechanism on a group of frames, const once built: bodies, couplings, loads. Several threads
/// may simulate one model: whatever changes is in states and workspaces.

#include <memory>
#include <string>
#include <vector>

#include "liegroup/rotation.hpp"
#include "mbs/bodies/body.hpp"
#include "mbs/couplings/coupling.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/system/plane.hpp"
#include "mbs/system/state.hpp"

namespace liesl {

/// How the constraints of a model are enforced, see `ConstraintForm`.
struct Penalty {
  ConstraintForm form = ConstraintForm::Multipliers;
  Eigen::VectorXd weight;                 ///< alpha by multiplier, N/m or N m; empty: multipliers
  double damping = 0;                     ///< tau, s
  double displacement = 0, rotation = 0;  ///< the weights by kind of row
};

/// A load at a port or spread over a body.
template <FrameGroup G>
struct Load {
  PortOf<G> port;
  bool spread = false;
  bool follower = false;
  typename G::Tangent wrench =
      G::Tangent::Zero();  ///< [force; moment]; inertial axes unless follower
  TimeFunction scale;
  BlockTridiagonal<G::dim> distribution;  ///< of a spread load
  Eigen::MatrixXd share;                  ///< the same on a body with followers, see load_share
};

template <FrameGroup G>
class Model {
 public:
  using Vector = typename Body<G>::Vector;

  /// Builds the model of a mechanism. For SE(2) `space` maps to the plane; every quantity that is
  /// not of the plane must vanish (find_plane has seen to that). Constraints that repeat others at
  /// the start are found by rank and left out.
  static Model build(const Mechanism& mechanism, const Space<G>& space);

  int nodes() const { return nodes_; }
  int size() const { return G::dim * nodes_; }      ///< velocities
  int constraints() const { return constraints_; }  ///< multipliers
  int rows() const { return rows_; }                ///< coupling rows of all roles
  int first_node(int body) const { return first_node_[body]; }

  /// Nodes of a kind over all bodies.
  const std::vector<int>& frames() const { return frames_; }
  const std::vector<int>& positions() const { return positions_; }
  const std::vector<int>& amplitudes() const { return amplitudes_; }
  /// Moves a state by left-invariant increments, dim a node: frames H <- H exp(delta_k), positions
  /// x
  /// <- x + R delta_k, amplitudes w <- w + delta_k. Nodes that follow others stay: see `complete`.
  void retract(State<G>& s, Eigen::Ref<const Eigen::VectorXd> delta) const;
  /// Sets all that follows from the unknowns: what records and responses see.
  void complete(State<G>& s) const;

  /// Bodies where the scene puts them, at rest or with the scene's rigid velocities.
  State<G> initial_state() const;

  BodyState<G> body_state(const State<G>& s, int body) const {
    const int n = first_node_[body];
    return {s.H.data() + n, s.v.data() + G::dim * n, s.vdot.data() + G::dim * n,
            s.w.data() + G::dim * n};
  }

  Formalism formalism = Formalism::SE3;
  Penalty penalty;
  NodeUpdate update = NodeUpdate::Screw;  ///< never AsFormalism
  Space<G> space;
  Vector gravity = Vector::Zero();
  TimeFunction gravity_scale = TimeFunction::constant(1);
  /// Acceleration of gravity at time t.
  Vector gravity_at(double t) const { return gravity_scale(t) * gravity; }
  std::vector<std::unique_ptr<Body<G>>> bodies;
  std::vector<Coupling<G>> couplings;
  std::vector<Load<G>> loads;
  /// Distinct nodes of each body that couplings hold on to; `PortOf::slot` counts in here.
  std::vector<std::vector<int>> coupled_nodes;
  /// One sentence a joint of which rows repeat others and are left out (Role::Redundant); with
  /// penalties they stay and share the forces.
  std::vector<std::string> redundant;
  /// Not empty: the start is a dead point, where rows depend on others though not near it.
  std::string dead_point;
  double length = 1;  ///< size of the mechanism, m: makes moments and forces comparable
  double extent =
      1;  ///< farthest from the origin that its nodes may be, m: what positions round off to

 private:
  void finish();
  void leave_out_redundant_rows();
  void set_initial_velocity(const Mechanism& mechanism);
  void set_velocity_of_mesh(int body, int node);

  int nodes_ = 0, constraints_ = 0, rows_ = 0;
  std::vector<int> first_node_, frames_, positions_, amplitudes_;
  Eigen::VectorXd initial_velocity_;
};

extern template class Model<SE2>;
extern template class Model<SE3>;

}  // namespace liesl
