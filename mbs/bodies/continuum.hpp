#pragma once
/// @file
/// A meshed part in full motion: every node of the mesh moves, total Lagrangian (P. Wriggers,
/// Nonlinear Finite Element Methods, Springer 2008, ch. 4). With X the nodes at rest, x where they
/// are, M the consistent mass and V the potential of the cells (`ContinuumCell`),
///   M (x'' - g) + dV/dx = forces of the interfaces.
/// Nodes of a rigid interface move with its port, x = x_P + R_P s, so that couplings hold on to a
/// port as to any frame; forces on them add up to [R^T f; s x R^T f] there. Those of an averaged
/// one are nodes as all others, and its port moves with their average (`AveragedPort`).
///
/// Nodes: the interfaces, which are frames, then the other nodes of the mesh, which are positions
/// (NodeKind::Position). Their axes are turned by the polar rotation of the material about them: in
/// these axes stiffness and mass are those at rest, however far the part has turned, and factors
/// hold for as long as strains are small.
///
/// An outline scales each cell: energy, stress and damping by the ersatz law of its fraction, mass
/// by the fraction, of which empty cells keep the ratio of that law. Forces are linear in these
/// factors, so a derivative by them is a body with others.

#include <functional>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/bodies/averaged_port.hpp"
#include "mbs/bodies/body.hpp"
#include "mbs/linalg/sparse_assembly.hpp"
#include "mbs/solids/continuum_cell.hpp"
#include "mbs/solids/solid_spec.hpp"

namespace liesl {

template <FrameGroup G>
class ContinuumBody final : public Body<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;
  static constexpr int sd = G::space_dim, rd = G::rotation_dim;
  using Points = Eigen::Matrix<double, sd, Eigen::Dynamic>;  ///< a column a node of the mesh

  /// @param ports frames of the interfaces  @param turn components in their axes from components
  /// in the axes of the mesh
  /// @throws std::invalid_argument for a material that is incompressible, a mesh in several pieces,
  /// an outline that cuts the part into pieces
  ContinuumBody(std::string body_name, const SolidSpec& spec, const std::vector<G>& ports,
                const Eigen::Matrix3d& turn);

  NodeKind kind(int node) const override {
    return node < ports_ ? NodeKind::Frame : NodeKind::Position;
  }
  int points() const override { return ports_; }
  /// The body as a mesh whose nodes all move, null if it is none.
  static const ContinuumBody* of(const Body<G>& body) {
    return dynamic_cast<const ContinuumBody*>(&body);
  }
  double damping() const override { return damping_; }
  std::unique_ptr<BodyWorkspace> make_workspace() const override;
  void turn_axes(G* H) const override;
  void follow_frames(const G* start, G* H) const override;
  std::optional<ShapeFault> fault(const G* H) const override;
  std::string no_forces(const G* H) const override;

  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override;
  void add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const override;
  void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                     const Tangent* stress, Matrices& A) const override;
  /// Stresses of the points of all cells with their weights, as `ContinuumCell` has them: the
  /// tangent about them keeps Newton's method on its way where positions that move straight
  /// stretch cells that turn (D. Magisano, L. Leonetti, G. Garcea, How to improve efficiency and
  /// robustness of the Newton method in geometrically non-linear structural problem discretized via
  /// displacement-based finite elements, CMAME 313 (2017) 986-1005).
  void extrapolate_stress(const BodyState<G>& s, const double* delta,
                          Tangent* stress) const override;
  int stresses() const override {
    return static_cast<int>(averaged_.size() +
                            (cells_.cols() * shapes_[0].strains() + dim - 1) / dim);
  }
  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override;
  double dissipation(const BodyState<G>& s) const override;
  double total_mass() const override { return node_mass_.sum(); }
  double axial_stiffness() const override { return stiffest_; }
  std::unique_ptr<Body<G>> derivative(const LawDerivative<G>& law) const override;
  std::unique_ptr<ShapeDerivative<G>> by_shape(
      const std::vector<NearbyBody<G>>& nearby) const override;
  void add_energy_gradient(const BodyState<G>& s, const Vector& gravity, const BodyEnergy& weight,
                           double* h, double* v) const override;

  Eigen::VectorXd stress_shares() const override { return shares_; }
  Eigen::MatrixXd cell_stresses(const BodyState<G>& s) const override;
  Eigen::VectorXd cell_stress(const BodyState<G>& s, int cell) const override;
  void add_cell_stress_gradient(const BodyState<G>& s, int cell, const Eigen::VectorXd& f,
                                double* h) const override;

  /// Where all nodes of the mesh are, m, inertial.
  void positions(const G* H, Points& x) const;
  /// Cauchy stresses of the material at the centres of the cells, a column each, in the axes in
  /// which the positions of the nodes of the mesh are given, Pa; zero in a cell that is inverted or
  /// void.
  Eigen::MatrixXd stresses_at(const Points& x) const;
  int mesh_nodes() const { return static_cast<int>(node_of_.size()); }
  /// Node of the body that a node of the mesh moves with: an interface, or its own.
  int node_of(int mesh_node) const { return node_of_[static_cast<std::size_t>(mesh_node)]; }

 private:
  using Cell = ContinuumCell<sd>;
  using Square = Eigen::Matrix<double, sd, sd>;
  /// d(position)/d(increment) of a node of the mesh in the axes of its node of the body.
  using Lever = Eigen::Matrix<double, sd, dim>;
  using Levers = std::vector<Lever, Eigen::aligned_allocator<Lever>>;
  struct Room;
  struct Share;
  class ByShape;

  /// The derivative of a body by factors of its cells. @param ports that of the stiffness of its
  /// averaged ports
  ContinuumBody(const ContinuumBody& body, Eigen::VectorXd stiff, Eigen::VectorXd heavy,
                double ports);

  /// Is it the same mesh of the same material, its nodes apart?
  bool same_but_for_nodes(const ContinuumBody& other) const;
  static std::vector<G> nodes_at_rest(const SolidSpec& spec, const std::vector<G>& ports,
                                      const Eigen::Matrix3d& turn);
  void number_nodes(const SolidSpec& spec, const std::vector<G>& ports,
                    const Eigen::Matrix3d& turn);
  void make_cells(const SolidSpec& spec);
  void make_averaged(const SolidSpec& spec, const Eigen::Matrix3d& turn);
  double mean_volume_at(const std::vector<int>& nodes) const;  ///< of cells that hold any of them
  void make_mass();
  void set_constant_matrices();

  /// Calls f with the workspace of a state, or with one of its own.
  template <class F>
  void in_room(const BodyState<G>& s, const F& f) const {
    const auto own = s.work ? nullptr : make_workspace();
    f(static_cast<Room&>(s.work ? *s.work : *own));
  }
  bool held(int i) const { return node_of(i) < ports_; }
  bool holds(int e) const {
    return cells_.col(e).unaryExpr([this](int i) { return held(i); }).any();
  }
  Lever lever(int i) const;
  Levers levers(const G* H) const;
  const Cell& cell(int e) const {
    return shapes_[static_cast<std::size_t>(shape_of_[static_cast<std::size_t>(e)])];
  }
  /// Of one component between corners of a cell.
  double mass_of(int e, int i, int j) const {
    const auto shape = static_cast<std::size_t>(shape_of_[static_cast<std::size_t>(e)]);
    return heavy_[e] * cell_mass_[shape](i, j);
  }
  /// Has material enough to be judged by what its law and its shape become.
  bool solid(int e) const;
  /// Shares of the stress of cells, none of void ones.
  Eigen::VectorXd of_solid(Eigen::VectorXd shares) const;
  /// Values at the corners of a cell.
  void gather(int e, const Points& all, typename Cell::Positions& at) const;
  Vector local_velocity(const BodyState<G>& s, int i) const;
  Vector local_acceleration(const BodyState<G>& s, int i) const;
  void velocities(const BodyState<G>& s, Points& v) const;
  /// Forces on the nodes of the mesh to those of the body.
  void add_to_nodes(const G* H, const Points& f, double* r) const;
  void respond(int e, Room& room, bool tangent) const;
  void stress_of(int e, Room& room, bool tangent, const double* elastic = nullptr) const;
  void internal_forces(const BodyState<G>& s, Room& room, Points& f, ForceScale* scale,
                       const double* elastic = nullptr) const;
  void inertia_forces(const BodyState<G>& s, const Vector& gravity, Room& room, Points& f) const;

  /// Tangents of the averaged ports, one after the other.
  using OfPorts = std::function<Eigen::MatrixXd(const AveragedPort<G>&, std::size_t)>;
  Eigen::SparseMatrix<double> assemble(const G* H, const std::vector<Share>& shares, double dead,
                                       const OfPorts& of_ports) const;
  void add_shares(const G* H, const std::vector<Share>& shares, double dead,
                  const OfPorts& of_ports, SparseAssembly& assembly) const;
  OfPorts masses_of_ports() const;
  /// Where the stress of an averaged port is among those of `extrapolate_stress`.
  Eigen::Index stress_of_port(std::size_t i) const {
    return dim * (stresses() - static_cast<Eigen::Index>(averaged_.size() - i));
  }
  double viscosity(int e) const { return damping_ * stiff_[e]; }  ///< of the law at rest, s
  Share inertia_share(Levers columns, bool held_only = false) const;
  Share damping_share(Room& room, Levers columns) const;
  template <class Local>
  Levers turned(const G* H, const Local& local) const;
  Eigen::SparseMatrix<double> stiffness_at(const BodyState<G>& s, Room& room,
                                           const double* elastic) const;
  Eigen::SparseMatrix<double> damping_at(const BodyState<G>& s, Room& room) const;

  int ports_;
  double damping_, thickness_;
  std::vector<int> node_of_;  ///< by node of the mesh: node of the body
  Points arm_;                ///< by node of the mesh: in the axes of the port it is held by, m
  Points rest_;               ///< inertial, m
  Eigen::MatrixXi cells_;     ///< corners x cells
  Eigen::VectorXd fraction_;  ///< by cell: share of material
  Eigen::VectorXd stiff_, heavy_;  ///< by cell: factors of energy and mass
  Eigen::VectorXd shares_;         ///< by cell: of its stress that it shows
  double stress_ = 1;              ///< that stresses of the material are multiplied by
  std::vector<int> shape_of_;
  std::vector<Cell> shapes_;                ///< cells of equal shape share them
  std::vector<Eigen::MatrixXd> cell_mass_;  ///< by shape, of one component
  Eigen::SparseMatrix<double> mass_;        ///< of one component, nodes of the mesh
  Eigen::VectorXd node_mass_;               ///< its rows summed up, kg
  double dead_mass_ = 0, dead_ = 0;         ///< in place of the rotations of positions
  double stiffest_ = 0;
  std::vector<AveragedPort<G>> averaged_;
  SparseAssembly pattern_;
};

/// What an evaluation computes in.
template <FrameGroup G>
struct ContinuumBody<G>::Room final : BodyWorkspace {
  Points x, v, a, f;
  typename Cell::Positions at, rates, forces;
  Eigen::VectorXd E, rate, stress;
  typename Cell::Response response;
};

/// A share of a tangent: matrices of the cells in inertial axes, D n x D n, and for each node of
/// the mesh what its increment or rate moves it by.
template <FrameGroup G>
struct ContinuumBody<G>::Share {
  std::function<void(int, Eigen::MatrixXd&)> cell;
  Levers columns;
  bool held_only = false;  ///< the columns of nodes that are positions are zero
};

extern template class ContinuumBody<SE2>;
extern template class ContinuumBody<SE3>;

}  // namespace liesl
