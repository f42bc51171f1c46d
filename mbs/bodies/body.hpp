#pragma once
/// @file
/// What a body is to the model: nodes with frames, inertia and elasticity in local frames.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "liegroup/rotation.hpp"
#include "mbs/bodies/body_matrix.hpp"
#include "mbs/bodies/law_derivative.hpp"
#include "mbs/bodies/shape_derivative.hpp"
#include "mbs/bodies/spread_load.hpp"
#include "mbs/model/element_place.hpp"

namespace liesl {

/// What a body computes in, so that an evaluation allocates nothing and a body can be const: one of
/// each body for each thread, from `Body::make_workspace`.
struct BodyWorkspace {
  virtual ~BodyWorkspace() = default;
};

/// The part of a state that belongs to one body: pointers to its first node.
template <FrameGroup G>
struct BodyState {
  const G* H = nullptr;           ///< frames, one a node
  const double* v = nullptr;      ///< left-invariant velocities, dim a node
  const double* vdot = nullptr;   ///< their rates, dim a node
  const double* w = nullptr;      ///< amplitudes of modes, dim a node
  BodyWorkspace* work = nullptr;  ///< null: a function that needs one makes its own
  /// Statics: section forces (elements x dim) about which a law that is not linear in them is
  /// linearised, those of `exact_tangent`; null = exact. Equal at equilibrium.
  const double* stress = nullptr;
};

/// What a node of a body is to the solvers.
enum class NodeKind {
  Frame,     ///< an unknown frame
  Position,  ///< an unknown position: its axes are held within a step and follow the body after it
  Amplitudes,  ///< dim unknown amplitudes of modes: a vector; its frame follows
  Follower     ///< no unknowns: its frame follows from those of the body's other nodes
};

/// Weights of the three parts of a tangent, mass M + damping C + stiffness K. Those of the time
/// integrator are beta' and gamma'; with mass = damping = 0 it is the static tangent.
struct TangentWeights {
  double mass = 0;       ///< beta'  [1/s^2]
  double damping = 0;    ///< gamma' [1/s]
  double stiffness = 1;  ///< [-]
};

/// Sums of squares of the forces and moments that make up a residual: the measure of what
/// "small" means for it.
struct ForceScale {
  double force = 0;   ///< N^2
  double moment = 0;  ///< (N m)^2

  template <class G, class Wrench>
  void add(const Wrench& f) {
    force += f.template head<G::space_dim>().squaredNorm();
    moment += f.template tail<G::rotation_dim>().squaredNorm();
  }
  /// Norm of all with moments divided by a length, N.
  double norm(double length) const { return std::sqrt(force + moment / (length * length)); }
};

/// What is wrong with the shape of a body, and what to do about it: a clause each.
struct ShapeFault {
  std::string what, remedy;
};

struct BodyEnergy {
  double kinetic = 0, elastic = 0, potential = 0;  ///< J; potential of gravity, zero at the origin
};

/// A chain of n >= 1 nodes. Forces are conjugate to left-invariant increments in the nodal frames.
template <FrameGroup G>
class Body {
 public:
  static constexpr int dim = G::dim;
  using Tangent = typename G::Tangent;
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  using Matrices = BodyMatrix<dim>;
  using Stresses = std::vector<Tangent, Eigen::aligned_allocator<Tangent>>;  ///< by element
  using Strains = Eigen::Matrix<double, dim, Eigen::Dynamic>;                ///< by element

  Body(std::string body_name, std::vector<G> nodes_at_rest)
      : name(std::move(body_name)), reference(std::move(nodes_at_rest)) {}
  virtual ~Body() = default;

  const std::string name;
  const std::vector<G> reference;  ///< nodal frames of the undeformed body where the scene puts it

  int nodes() const { return static_cast<int>(reference.size()); }
  int size() const { return dim * nodes(); }
  virtual NodeKind kind(int /*node*/) const { return NodeKind::Frame; }
  /// Nodes that ports hold on to: the first ones. Further ones hold amplitudes, or are of a mesh.
  virtual int points() const { return nodes(); }
  /// Frames, velocities and their rates of every node from the unknowns; nothing to do where all
  /// nodes are frames.
  virtual void complete(G* /*H*/, double* /*v*/, double* /*vdot*/, const double* /*w*/) const {}

  /// Turns the axes of the nodes that are positions to where the body is, in place; nothing to do
  /// where there are none.
  virtual void turn_axes(G* /*H*/) const {}
  /// Turns frames by what no internal force depends on to where the rest of the body holds them, in
  /// place: the spin of an end of a chain without torsion.
  virtual void settle_spin(G* /*H*/) const {}
  /// Takes the nodes that are positions to where its frames carry them from `start`, in place: by a
  /// correction that turns the body their own steps, straight ones, would stretch it.
  virtual void follow_frames(const G* /*start*/, G* /*H*/) const {}
  /// What is wrong with the shape of the body, if something is.
  virtual std::optional<ShapeFault> fault(const G* /*H*/) const { return {}; }
  /// Why its forces are not finite in a shape where they are not, one clause; empty if they are.
  virtual std::string no_forces(const G* /*H*/) const { return {}; }

  /// A workspace for this body, null if it needs none.
  virtual std::unique_ptr<BodyWorkspace> make_workspace() const { return nullptr; }

  /// r += M (vdot - [R^T gravity; 0]) + gyroscopic force. Gravity enters as an acceleration.
  virtual void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                           ForceScale& scale) const = 0;
  /// r += internal force (elastic + damping).
  virtual void add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const = 0;

  /// Constant mass matrix and constant tangent stiffness (at the reference shape).
  const Matrices& mass() const { return M_; }
  const Matrices& stiffness() const { return K_; }
  /// Stiffness-proportional damping in s: C = damping * K.
  virtual double damping() const { return 0; }

  /// A = w.mass M + w.damping C + w.stiffness K, the exact derivatives of the residual at this
  /// state by vdot, by v and by left-invariant increments of the frames (amplitudes), v and vdot
  /// held. K has the elastic stress `stress` (elements x dim, null = the state's own) in its
  /// geometric term.
  virtual void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                             const Tangent* stress, Matrices& A) const = 0;
  /// K, C and M of it one by one, for bodies where they share what they are made of.
  virtual void exact_tangents(const BodyState<G>& s, const Vector& gravity, const Tangent* stress,
                              Matrices& K, Matrices& C, Matrices& M) const {
    exact_tangent(s, gravity, {0, 0, 1}, stress, K);
    exact_tangent(s, gravity, {0, 1, 0}, stress, C);
    exact_tangent(s, gravity, {1, 0, 0}, stress, M);
  }

  /// Shares of a load per length: f = W [l_0; ...; l_n]; zero for bodies without length.
  virtual Matrices load_distribution() const { return Matrices(nodes()); }
  /// For bodies with followers instead: f = S l_0, all of the load from its components in the axes
  /// of node 0 [size x dim]; `follower` loads keep their components in the axes of every node.
  virtual Eigen::MatrixXd load_share(bool /*follower*/) const { return {}; }

  /// r -= what `load_distribution` misses of a load per length where elements turn or bend, and
  /// A += its derivative; nothing where the shares are exact. Of a `derivative` that of what is
  /// missed, by the parameter, is `add_spread_derivative`.
  virtual void add_spread_curvature(const BodyState<G>&, const SpreadLoad<G>&,
                                    double* /*r*/) const {}
  virtual void add_spread_curvature_tangent(const BodyState<G>&, const SpreadLoad<G>&,
                                            Matrices& /*A*/) const {}
  virtual void add_spread_derivative(const BodyState<G>&, const SpreadLoad<G>&,
                                     double* /*r*/) const {}

  /// Components at the end of the last node that pad its amplitudes and never move.
  virtual int padding() const { return 0; }

  virtual int elements() const { return 0; }
  /// Nodes that the forces of element e act on: the first, and how many; all unless said otherwise.
  virtual std::pair<int, int> nodes_of(int /*e*/) const { return {0, nodes()}; }
  /// Strain of element e, and elastic section forces [N, N m] of a completed state: in the middle
  /// n = K eps, at its nodes those of the elastic force g = P^T n of the element, -g_A and g_B, in
  /// the axes of the node. With no load inside the element they are in equilibrium with what acts
  /// on the nodes, so that moments at the nodes are right whatever its length. (Of the loads of an
  /// equivalent static load case at a node they are the shares of the elements.)
  virtual Tangent strain(const BodyState<G>&, int /*e*/) const { return Tangent::Zero(); }
  virtual Tangent section_force(const BodyState<G>&, int /*e*/, ElementPlace) const {
    return Tangent::Zero();
  }
  /// Those at both nodes of element e.
  virtual std::array<Tangent, 2> end_forces(const BodyState<G>& s, int e) const {
    return {section_force(s, e, ElementPlace::First), section_force(s, e, ElementPlace::Last)};
  }
  /// Both for all elements at once. @param eps, n one an element
  virtual void all_strains(const BodyState<G>& s, Tangent* eps) const {
    for (int e = 0; e < elements(); ++e) eps[e] = strain(s, e);
  }
  virtual void all_end_forces(const BodyState<G>& s, std::array<Tangent, 2>* n) const {
    for (int e = 0; e < elements(); ++e) n[e] = end_forces(s, e);
  }
  /// stress[e] = section force + its first-order change by the nodal increments `delta` (dim a
  /// node), one an element: n = K (eps + P(d) delta / L). On entry the stress that the increments
  /// were found with.
  virtual void extrapolate_stress(const BodyState<G>&, const double* /*delta*/,
                                  Tangent* /*stress*/) const {}
  /// Tangents that `extrapolate_stress` fills: one an element; of a mesh whose nodes move as many
  /// as hold the stresses of all its cells, one after the other.
  virtual int stresses() const { return elements(); }

  /// Stiffness of all points as a free linear structure at rest.
  virtual const Matrices& free_stiffness() const { return K_; }
  /// f += elastic forces on all points, from the frames of a completed state; without damping.
  virtual void add_elastic_force(const G* H, double* f) const {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(size());
    ForceScale scale;
    add_internal({H, rest.data(), rest.data()}, f, scale);
  }
  /// Strains of all elements under small displacements u of the points at rest, dim a node.
  virtual Strains strains_at_rest(const Eigen::VectorXd& u) const {
    std::vector<G> H(reference);
    for (int k = 0; k < nodes(); ++k) H[k] = H[k] * G::exp(Tangent(u.segment<dim>(dim * k)));
    Strains eps(dim, elements());
    for (int e = 0; e < elements(); ++e) eps.col(e) = strain({H.data()}, e);
    return eps;
  }

  virtual BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const = 0;
  /// Power that the damping of the body takes out of a completed state, W, >= 0.
  virtual double dissipation(const BodyState<G>&) const { return 0; }

  /// Kilograms, and the largest axial stiffness EA/L of an element in N/m (0 = rigid): round-off
  /// in positions times this is the smallest force that means anything.
  virtual double total_mass() const = 0;
  virtual double axial_stiffness() const { return 0; }

  /// d(body)/dp for a parameter p of its law, geometry fixed. Forces, matrices, section forces and
  /// energies are linear in K, M_s, the inertia, and in the matrices of a mesh; so their
  /// derivatives at any state are those of the same body with the derivative of the law for its
  /// law: `add_inertia` and `add_internal` of what is returned give
  ///   dr/dp = d(M vdot + g_gyr + g_int - weight)/dp,
  /// `mass`, `stiffness` and `exact_tangent` those of the matrices, `energy`, `section_force` and
  /// `cell_stress` likewise. Strains have none, so `strain` is that of this body. It has the
  /// unknowns of this body. Modes of a reduced beam are kept: with all of them that is a choice of
  /// coordinates; with fewer the derivative is that of the motion in the space of these modes.
  /// @throws std::invalid_argument if the law is of another kind of body or not of its size
  virtual std::unique_ptr<Body<G>> derivative(const LawDerivative<G>& law) const = 0;

  /// d(forces)/dp by the nodes at rest of bodies of the same law and the same mesh; null: none is
  /// known but by differences of the forces of the nearby bodies. This body outlives what is
  /// returned; the nearby ones need not.
  virtual std::unique_ptr<ShapeDerivative<G>> by_shape(
      const std::vector<NearbyBody<G>>& /*nearby*/) const {
    return nullptr;
  }

  /// h += (dn_e/dh)^T f: gradient of f . n_e, n_e the section force of element e, with respect to
  /// the increments of the nodal frames of a completed state.
  virtual void add_section_force_gradient(const BodyState<G>&, int /*e*/, ElementPlace,
                                          const Tangent& /*f*/, double* /*h*/) const {}

  /// Cells of a mesh: the share of the stress of its material that each shows (`relaxed_shares` of
  /// the fractions), and these stresses at the centres, a column each, ordered as in
  /// `CellMatrices`, Pa. Nothing of bodies without cells.
  virtual Eigen::VectorXd stress_shares() const { return {}; }
  virtual Eigen::MatrixXd cell_stresses(const BodyState<G>&) const { return {}; }
  /// Those of one cell; of a `derivative` their derivative at constant state, as its shares are.
  virtual Eigen::VectorXd cell_stress(const BodyState<G>&, int /*cell*/) const { return {}; }
  /// h += gradient of f . (stress of a cell) with respect to the unknowns.
  /// @param s as the solvers have it, not completed
  virtual void add_cell_stress_gradient(const BodyState<G>& /*s*/, int /*cell*/,
                                        const Eigen::VectorXd& /*f*/, double* /*h*/) const {}
  /// Gradient of weight.kinetic T + weight.elastic V + weight.potential U with respect to the
  /// unknowns: h by increments of frames and amplitudes, v by velocities and rates of amplitudes.
  /// @param s as the solvers have it, not completed
  virtual void add_energy_gradient(const BodyState<G>& s, const Vector& gravity,
                                   const BodyEnergy& weight, double* h, double* v) const = 0;
  /// Takes what h and v say of nodes that follow to the nodes they follow: gradients with respect
  /// to all frames and velocities become those with respect to the unknowns, in place.
  /// @param s as the solvers have it, not completed
  virtual void to_unknowns(const BodyState<G>& /*s*/, double* /*h*/, double* /*v*/) const {}
  /// The same of what `vdot` says of the rates of velocities of nodes that follow, in place; what
  /// it says of the unknowns themselves and of their velocities is added to h and v.
  virtual void rates_to_unknowns(const BodyState<G>& /*s*/, double* /*h*/, double* /*v*/,
                                 double* /*vdot*/) const {}

 protected:
  Matrices M_, K_;
};

/// vdot - [R^T gravity; 0] for each node: inertia and weight at once.
template <FrameGroup G>
inline typename G::Tangent apparent_acceleration(const BodyState<G>& s, int node,
                                                 const typename Body<G>::Vector& gravity) {
  typename G::Tangent a = Eigen::Map<const typename G::Tangent>(s.vdot + G::dim * node);
  a.template head<G::space_dim>().noalias() -= s.H[node].R.transpose() * gravity;
  return a;
}

/// D_h of -[R^T gravity; 0] at one node (left-invariant): columns of the rotation.
template <FrameGroup G>
inline typename G::Matrix weight_tangent(const G& H, const typename Body<G>::Vector& gravity) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  typename G::Matrix D = G::Matrix::Zero();
  D.template topRightCorner<sd, rd>() =  // -d(R^T g) = w x (R^T g)
      -RotationOf<G>::cross(H.R.transpose().lazyProduct(gravity));
  return D;
}

}  // namespace liesl
