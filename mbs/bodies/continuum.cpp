#include "mbs/bodies/continuum.hpp"

#include <map>
#include <set>
#include <stdexcept>

#include "liegroup/rotation.hpp"
#include "mbs/bodies/polar_rotation.hpp"
#include "mbs/solids/continuum_check.hpp"
#include "mbs/solids/solid_model.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of an averaged port: stiffness, of E times the size of a cell for each node, and mass, of that of
// its nodes. What the port lags behind them is below what a hundredth of a cell is strained by.
constexpr double kStiffPort = 100, kLightPort = 1e-3;
constexpr double kNear = 1e-6;  // of the size of the mesh: a node at a port goes with that alone

/// w x y = turn(y) w.
template <class G>
auto turn(const Eigen::Matrix<double, G::space_dim, 1>& y) {
  return (-RotationOf<G>::cross(y)).eval();
}

}  // namespace

/// What an evaluation computes in.
template <FrameGroup G>
struct ContinuumBody<G>::Room final : BodyWorkspace {
  Points x, v, a, f;
  typename Cell::Positions at, rates, forces;
  VectorXd E, rate, stress;
  typename Cell::Response response;
};

/// A share of a tangent: matrices of the cells in inertial axes, D n x D n, and for each node of
/// the mesh what its increment or rate moves it by.
template <FrameGroup G>
struct ContinuumBody<G>::Share {
  std::function<void(int, MatrixXd&)> cell;
  Levers columns;
  bool held_only = false;  ///< the columns of nodes that are positions are zero
};

template <FrameGroup G>
ContinuumBody<G>::ContinuumBody(std::string body_name, const SolidSpec& spec,
                                const std::vector<G>& ports, const Eigen::Matrix3d& turn)
    : Body<G>(std::move(body_name), nodes_at_rest(spec, ports, turn)),
      ports_(static_cast<int>(ports.size())),
      damping_(spec.damping),
      cells_(spec.mesh().cells) {
  if (const auto problem = continuum_problem(spec))
    throw std::invalid_argument("part '" + this->name + "' as a continuum " + problem->text +
                                "; expected " + problem->expected);
  number_nodes(spec, ports, turn);
  make_cells(spec);
  make_mass();
  make_averaged(spec, turn);
  set_constant_matrices();
}

/// Ports, then the nodes that none of them holds, with the axes of the first port.
template <FrameGroup G>
std::vector<G> ContinuumBody<G>::nodes_at_rest(const SolidSpec& spec, const std::vector<G>& ports,
                                               const Eigen::Matrix3d& turn) {
  std::vector<G> nodes = ports;
  std::vector<bool> held(static_cast<std::size_t>(spec.mesh().node_count()), false);
  for (const Interface& f : spec.interfaces())
    if (f.tie == Tie::Rigid)
      for (const int i : f.nodes) held[static_cast<std::size_t>(i)] = true;
  const Eigen::Vector3d origin = spec.interfaces()[0].point;
  for (int i = 0; i < spec.mesh().node_count(); ++i) {
    if (held[static_cast<std::size_t>(i)]) continue;
    const Eigen::Vector3d s = turn * (spec.mesh().nodes.col(i) - origin);
    nodes.push_back(ports[0]);
    nodes.back().x += ports[0].R * s.head<sd>();
  }
  return nodes;
}

template <FrameGroup G>
void ContinuumBody<G>::number_nodes(const SolidSpec& spec, const std::vector<G>& ports,
                                    const Eigen::Matrix3d& turn) {
  const int n = spec.mesh().node_count();
  node_of_.assign(static_cast<std::size_t>(n), -1);
  for (int p = 0; p < ports_; ++p)
    if (const Interface& f = spec.interfaces()[static_cast<std::size_t>(p)]; f.tie == Tie::Rigid)
      for (const int i : f.nodes) node_of_[static_cast<std::size_t>(i)] = p;
  arm_.setZero(sd, n);
  rest_.resize(sd, n);
  int next = ports_;
  for (int i = 0; i < n; ++i) {
    int& node = node_of_[static_cast<std::size_t>(i)];
    if (node < 0) {
      node = next++;
      rest_.col(i) = this->reference[static_cast<std::size_t>(node)].x;
      continue;
    }
    const auto p = static_cast<std::size_t>(node);
    const Eigen::Vector3d s = turn * (spec.mesh().nodes.col(i) - spec.interfaces()[p].point);
    arm_.col(i) = s.head<sd>();
    rest_.col(i) = ports[p].x + ports[p].R * arm_.col(i);
  }
}

template <FrameGroup G>
void ContinuumBody<G>::make_cells(const SolidSpec& spec) {
  const SolidModel& model = *spec.model;
  std::map<const CellMatrices*, int> known;  // cells of equal shape share their matrices
  typename Cell::Positions at;
  for (int e = 0; e < model.mesh().cell_count(); ++e) {
    const auto [found, is_new] = known.emplace(&model.cell(e), static_cast<int>(shapes_.size()));
    shape_of_.push_back(found->second);
    if (!is_new) continue;
    gather(e, rest_, at);
    shapes_.emplace_back(at, model.material(), model.thickness(), spec.law);
    cell_mass_.push_back(model.cell(e).M);
  }
}

template <FrameGroup G>
void ContinuumBody<G>::make_averaged(const SolidSpec& spec, const Eigen::Matrix3d& turn) {
  const double node_mass = total_mass() / mesh_nodes();  // corners of quadratic cells may have none
  for (int p = 0; p < ports_; ++p) {
    const Interface& f = spec.interfaces()[static_cast<std::size_t>(p)];
    if (f.tie == Tie::Rigid) continue;
    Points places(sd, f.nodes.size());
    std::vector<int> nodes;
    for (const int i : f.nodes) {
      const Eigen::Vector3d s = turn * (spec.mesh().nodes.col(i) - f.point);
      places.col(static_cast<Eigen::Index>(nodes.size())) = s.head<sd>();
      nodes.push_back(node_of(i));
    }
    const double size = sd == 2 ? spec.model->thickness() : std::cbrt(mean_volume_at(f.nodes)),
                 mass = node_mass * static_cast<double>(nodes.size());
    averaged_.emplace_back(p, std::move(nodes), std::move(places),
                           kStiffPort * spec.model->material().E * size, kLightPort * mass);
  }
}

template <FrameGroup G>
double ContinuumBody<G>::mean_volume_at(const std::vector<int>& nodes) const {
  const std::set<int> any(nodes.begin(), nodes.end());
  std::vector<double> volumes;
  for (int e = 0; e < cells_.cols(); ++e)
    if (cells_.col(e).unaryExpr([&any](int i) { return int(any.count(i)); }).any())
      volumes.push_back(cell(e).volume());
  return VectorXd::Map(volumes.data(), static_cast<Eigen::Index>(volumes.size())).mean();
}

template <FrameGroup G>
void ContinuumBody<G>::make_mass() {
  SparseAssembly assembly(mesh_nodes());
  assembly.begin();
  for (int e = 0; e < cells_.cols(); ++e)
    for (int j = 0; j < cells_.rows(); ++j)
      for (int i = 0; i < cells_.rows(); ++i)
        assembly.add(cells_(i, e), cells_(j, e), mass_of(e)(i, j));
  mass_ = assembly.finish();
  node_mass_ = mass_ * VectorXd::Ones(mesh_nodes());
}

template <FrameGroup G>
void ContinuumBody<G>::set_constant_matrices() {
  const BodyState<G> rest{this->reference.data()};
  const std::vector<Share> stiffness = {{[this](int e, MatrixXd& K) {
                                           typename Cell::Positions at;
                                           MatrixXd B;
                                           gather(e, rest_, at);
                                           cell(e).strain_matrix(at, B);
                                           K.noalias() = B.transpose() * cell(e).stiffness() * B;
                                         },
                                         levers(rest.H)}};
  const std::vector<Share> mass = {inertia_share(levers(rest.H))};
  pattern_ = SparseAssembly(this->size());
  const OfPorts of_ports = [&rest](const AveragedPort<G>& port, std::size_t) {
    return port.stiffness_at(rest.H, VectorXd::Zero(port.strains()));
  };
  add_shares(rest.H, stiffness, 0, of_ports, pattern_);
  const Eigen::SparseMatrix<double> K = pattern_.finish();
  const double size = std::cbrt(shapes_[0].volume());
  for (int k = ports_; k < this->nodes(); ++k)
    for (int i = 0; i < sd; ++i) stiffest_ = std::max(stiffest_, K.coeff(dim * k + i, dim * k + i));
  dead_ = stiffest_ * size * size;
  dead_mass_ = total_mass() / mesh_nodes() * size * size;
  this->K_.set_sparse(assemble(rest.H, stiffness, dead_, of_ports));
  this->M_.set_sparse(assemble(rest.H, mass, dead_mass_, masses_of_ports()));
}

template <FrameGroup G>
auto ContinuumBody<G>::masses_of_ports() const -> OfPorts {
  return [](const AveragedPort<G>& port, std::size_t) { return port.mass(); };
}

template <FrameGroup G>
auto ContinuumBody<G>::lever(int i) const -> Lever {
  Lever D = Lever::Zero();
  D.template leftCols<sd>().setIdentity();
  if (held(i)) D.template rightCols<rd>() = turn<G>(arm_.col(i));
  return D;
}

/// R D of all nodes of the mesh: d(position)/d(increment), inertial.
template <FrameGroup G>
auto ContinuumBody<G>::levers(const G* H) const -> Levers {
  Levers out;
  for (int i = 0; i < mesh_nodes(); ++i) out.push_back(H[node_of(i)].R * lever(i));
  return out;
}

template <FrameGroup G>
void ContinuumBody<G>::gather(int e, const Points& all, typename Cell::Positions& at) const {
  at.resize(sd, cells_.rows());
  for (int c = 0; c < cells_.rows(); ++c) at.col(c) = all.col(cells_(c, e));
}

template <FrameGroup G>
void ContinuumBody<G>::positions(const G* H, Points& x) const {
  x.resize(sd, mesh_nodes());
  for (int i = 0; i < mesh_nodes(); ++i) {
    const G& at = H[node_of(i)];
    x.col(i) = at.x;
    if (held(i)) x.col(i).noalias() += at.R * arm_.col(i);
  }
}

/// u + w x s of held nodes in the axes of their port.
template <FrameGroup G>
auto ContinuumBody<G>::local_velocity(const BodyState<G>& s, int i) const -> Vector {
  const Eigen::Map<const Tangent> v(s.v + dim * node_of(i));
  Vector y = v.template head<sd>();
  if (held(i)) y += turn<G>(arm_.col(i)) * v.template tail<rd>();
  return y;
}

/// u' + w' x s + w x (u + w x s).
template <FrameGroup G>
auto ContinuumBody<G>::local_acceleration(const BodyState<G>& s, int i) const -> Vector {
  const Eigen::Map<const Tangent> a(s.vdot + dim * node_of(i)), v(s.v + dim * node_of(i));
  Vector y = a.template head<sd>();
  if (held(i))
    y += turn<G>(arm_.col(i)) * a.template tail<rd>() +
         turn<G>(local_velocity(s, i)) * v.template tail<rd>();
  return y;
}

template <FrameGroup G>
void ContinuumBody<G>::velocities(const BodyState<G>& s, Points& v) const {
  v.resize(sd, mesh_nodes());
  for (int i = 0; i < mesh_nodes(); ++i)
    v.col(i).noalias() = s.H[node_of(i)].R * local_velocity(s, i);
}

template <FrameGroup G>
void ContinuumBody<G>::add_to_nodes(const G* H, const Points& f, double* r) const {
  for (int i = 0; i < mesh_nodes(); ++i) {
    const int k = node_of(i);
    const Vector local = H[k].R.transpose() * f.col(i);
    Eigen::Map<Tangent> out(r + dim * k);
    out.template head<sd>() += local;
    if (held(i)) out.template tail<rd>() += turn<G>(arm_.col(i)).transpose() * local;
  }
}

template <FrameGroup G>
std::unique_ptr<BodyWorkspace> ContinuumBody<G>::make_workspace() const {
  return std::make_unique<Room>();
}

template <FrameGroup G>
void ContinuumBody<G>::internal_forces(const BodyState<G>& s, Room& room, Points& f,
                                       ForceScale* scale, const double* elastic) const {
  positions(s.H, room.x);
  if (damping_ > 0) velocities(s, room.v);
  f.setZero(sd, mesh_nodes());
  for (int e = 0; e < cells_.cols(); ++e) {
    stress_of(e, room, false, elastic);
    room.forces.setZero(sd, cells_.rows());
    cell(e).add_force(room.at, room.stress, room.forces);
    for (int c = 0; c < cells_.rows(); ++c) f.col(cells_(c, e)) += room.forces.col(c);
    if (scale) scale->force += room.forces.squaredNorm();
  }
}

/// Elastic and viscous stress of a cell, S = dW/dE + damping A Edot with A of the linear law.
/// @param elastic stresses of all cells to take for dW/dE, null: those of the state
/// @pre room.x, and room.v with damping
template <FrameGroup G>
void ContinuumBody<G>::stress_of(int e, Room& room, bool tangent, const double* elastic) const {
  gather(e, room.x, room.at);
  if (tangent || !elastic) {
    cell(e).strain(room.at, room.E);
    cell(e).respond(room.E, tangent, room.response);
    room.stress = room.response.stress;
  }
  if (elastic) {
    const int n = cell(e).strains();
    room.stress = Eigen::Map<const VectorXd>(elastic + n * e, n);
  }
  if (damping_ == 0) return;
  gather(e, room.v, room.rates);
  cell(e).strain_rate(room.at, room.rates, room.rate);
  room.stress.noalias() += damping_ * (cell(e).stiffness() * room.rate);
}

template <FrameGroup G>
void ContinuumBody<G>::inertia_forces(const BodyState<G>& s, const Vector& gravity, Room& room,
                                      Points& f) const {
  room.a.resize(sd, mesh_nodes());
  for (int i = 0; i < mesh_nodes(); ++i)
    room.a.col(i).noalias() = s.H[node_of(i)].R * local_acceleration(s, i) - gravity;
  f.noalias() = room.a * mass_;
}

template <FrameGroup G>
void ContinuumBody<G>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                                   ForceScale& scale) const {
  in_room(s, [&](Room& room) {
    inertia_forces(s, gravity, room, room.f);
    scale.force += room.f.squaredNorm();
    add_to_nodes(s.H, room.f, r);
    for (const auto& port : averaged_) port.add_inertia(s, r);
  });
}

template <FrameGroup G>
void ContinuumBody<G>::add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const {
  in_room(s, [&](Room& room) {
    internal_forces(s, room, room.f, &scale);
    add_to_nodes(s.H, room.f, r);
    for (const auto& port : averaged_) port.add_internal(s.H, 1, r, &scale);
  });
}

/// sum of (R D)_a^T K_ab columns_b over cells and shares, as blocks of the nodes of the body.
template <FrameGroup G>
Eigen::SparseMatrix<double> ContinuumBody<G>::assemble(const G* H, const std::vector<Share>& shares,
                                                       double dead, const OfPorts& of_ports) const {
  SparseAssembly assembly = pattern_;
  add_shares(H, shares, dead, of_ports, assembly);
  return std::move(assembly).finish();
}

template <FrameGroup G>
void ContinuumBody<G>::add_shares(const G* H, const std::vector<Share>& shares, double dead,
                                  const OfPorts& of_ports, SparseAssembly& assembly) const {
  assembly.begin();
  const Levers rows = levers(H);
  std::vector<MatrixXd> of_cell(shares.size(), MatrixXd(sd * cells_.rows(), sd * cells_.rows()));
  typename G::Matrix block;
  for (int e = 0; e < cells_.cols(); ++e) {
    for (std::size_t t = 0; t < shares.size(); ++t) shares[t].cell(e, of_cell[t]);
    for (int b = 0; b < cells_.rows(); ++b) {
      const int j = cells_(b, e), columns = held(j) ? dim : sd;
      for (int a = 0; a < cells_.rows(); ++a) {
        const int i = cells_(a, e);
        Lever moved = Lever::Zero();
        for (std::size_t t = 0; t < shares.size(); ++t)
          if (held(j) || !shares[t].held_only)
            moved.noalias() +=
                of_cell[t].template block<sd, sd>(sd * a, sd * b) * shares[t].columns[j];
        block.noalias() = rows[i].transpose() * moved;
        assembly.add_block(dim * node_of(i), dim * node_of(j),
                           block.topLeftCorner(held(i) ? dim : sd, columns));
      }
    }
  }
  for (int k = ports_; k < this->nodes(); ++k)
    for (int i = sd; i < dim; ++i) assembly.add(dim * k + i, dim * k + i, dead);
  for (std::size_t p = 0; p < averaged_.size(); ++p) {
    const MatrixXd of_port = of_ports(averaged_[p], p);
    const std::vector<int> at = averaged_[p].unknowns();
    for (std::size_t j = 0; j < at.size(); ++j)
      for (std::size_t i = 0; i < at.size(); ++i)
        assembly.add(at[i], at[j], of_port(Eigen::Index(i), Eigen::Index(j)));
  }
}

/// The consistent mass with accelerations that are columns times what is varied.
template <FrameGroup G>
auto ContinuumBody<G>::inertia_share(Levers columns, bool held_only) const -> Share {
  return {[this](int e, MatrixXd& M) {
            M.setZero();
            for (int i = 0; i < cells_.rows(); ++i)
              for (int j = 0; j < cells_.rows(); ++j)
                M.template block<sd, sd>(sd * i, sd * j).diagonal().setConstant(mass_of(e)(i, j));
          },
          std::move(columns), held_only};
}

/// R y~ of held nodes: what a vector that is constant in the axes of its port turns by.
template <FrameGroup G>
template <class Local>
auto ContinuumBody<G>::turned(const G* H, const Local& local) const -> Levers {
  Levers out(static_cast<std::size_t>(mesh_nodes()), Lever::Zero());
  for (int i = 0; i < mesh_nodes(); ++i)
    if (held(i)) out[i].template rightCols<rd>() = H[node_of(i)].R * turn<G>(local(i));
  return out;
}

/// Of the stiffness: material and geometric stiffness of the cells, damping by the place, what
/// velocities and accelerations of held nodes turn by; forces on held nodes that turn come after.
template <FrameGroup G>
Eigen::SparseMatrix<double> ContinuumBody<G>::stiffness_at(const BodyState<G>& s, Room& room,
                                                           const double* elastic) const {
  MatrixXd B, Bv;
  positions(s.H, room.x);
  if (damping_ > 0) velocities(s, room.v);
  std::vector<Share> shares = {{[&](int e, MatrixXd& K) {
                                  stress_of(e, room, true, elastic);
                                  cell(e).strain_matrix(room.at, B);
                                  K.noalias() = B.transpose() * (room.response.tangent * B);
                                  if (damping_ > 0) {
                                    cell(e).strain_matrix(room.rates, Bv);
                                    K.noalias() +=
                                        damping_ * B.transpose() * (cell(e).stiffness() * Bv);
                                  }
                                  cell(e).add_geometric(room.stress, K);
                                },
                                levers(s.H)}};
  if (s.vdot)
    shares.push_back(
        inertia_share(turned(s.H, [&](int i) { return local_acceleration(s, i); }), true));
  if (damping_ > 0) {
    shares.push_back(damping_share(room, {}));
    shares.back().columns = turned(s.H, [&](int i) { return local_velocity(s, i); });
    shares.back().held_only = true;
  }
  return assemble(s.H, shares, dead_, [&](const AveragedPort<G>& port, std::size_t p) {
    return port.stiffness_at(
        s.H, elastic ? VectorXd(Eigen::Map<const VectorXd>(elastic + stress_of_port(p), dim))
                     : port.stress(s.H));
  });
}

/// damping B^T A B. @pre room.x, kept as long as the share
template <FrameGroup G>
auto ContinuumBody<G>::damping_share(Room& room, Levers columns) const -> Share {
  return {[this, &room](int e, MatrixXd& C) {
            MatrixXd B;
            gather(e, room.x, room.at);
            cell(e).strain_matrix(room.at, B);
            C.noalias() = damping_ * B.transpose() * (cell(e).stiffness() * B);
          },
          std::move(columns)};
}

/// By v: accelerations of held nodes, R (w x (du + dw x s) + dw x y) with y = u + w x s; damping.
template <FrameGroup G>
Eigen::SparseMatrix<double> ContinuumBody<G>::damping_at(const BodyState<G>& s, Room& room) const {
  Levers by_v(static_cast<std::size_t>(mesh_nodes()), Lever::Zero());
  for (int i = 0; i < mesh_nodes(); ++i) {
    if (!held(i)) continue;
    const Eigen::Map<const Tangent> v(s.v + dim * node_of(i));
    Lever local;
    const Lever D = lever(i);
    for (int j = 0; j < dim; ++j) local.col(j) = turn<G>(D.col(j)) * v.template tail<rd>();
    local.template rightCols<rd>() += turn<G>(local_velocity(s, i));
    by_v[i] = s.H[node_of(i)].R * local;
  }
  std::vector<Share> shares = {inertia_share(std::move(by_v), true)};
  positions(s.H, room.x);
  if (damping_ > 0) shares.push_back(damping_share(room, levers(s.H)));
  return assemble(s.H, shares, 0,
                  [&s](const AveragedPort<G>& port, std::size_t) { return port.damping_at(s.v); });
}

template <FrameGroup G>
void ContinuumBody<G>::exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                                     const Tangent* stress, Matrices& A) const {
  if (!A.is_sparse()) A.set_form(this->K_);
  A.set_zero();
  in_room(s, [&](Room& room) {
    const auto add = [&A](double weight, const Eigen::SparseMatrix<double>& share) {
      A.sparse.coeffs() += weight * share.coeffs();
    };
    if (w.mass != 0)
      add(w.mass, assemble(s.H, {inertia_share(levers(s.H))}, dead_mass_, masses_of_ports()));
    if (w.damping != 0) add(w.damping, damping_at(s, room));
    if (w.stiffness == 0) return;
    const double* about = stress ? stress->data() : nullptr;
    add(w.stiffness, stiffness_at(s, room, about));
    Points elastic;
    internal_forces(s, room, elastic, nullptr, about);
    inertia_forces(s, gravity, room, room.f);
    for (int i = 0; i < mesh_nodes(); ++i) {
      if (!held(i)) continue;
      const int k = node_of(i);
      const Vector local = s.H[k].R.transpose() * (elastic.col(i) + room.f.col(i));
      typename G::Matrix turning = G::Matrix::Zero();
      turning.template rightCols<rd>() = -w.stiffness * lever(i).transpose() * turn<G>(local);
      A.add_to_node(k, turning);
    }
  });
}

template <FrameGroup G>
void ContinuumBody<G>::extrapolate_stress(const BodyState<G>& s, const double* delta,
                                          Tangent* stress) const {
  const bool moves = !Eigen::Map<const VectorXd>(delta, this->size()).isZero(0);
  double* out = stress->data();
  in_room(s, [&](Room& room) {
    positions(s.H, room.x);
    BodyState<G> moved = s;
    moved.v = delta;
    if (moves) velocities(moved, room.v);
    for (int e = 0; e < cells_.cols(); ++e, out += room.E.size()) {
      gather(e, room.x, room.at);
      cell(e).strain(room.at, room.E);
      cell(e).respond(room.E, moves, room.response);
      Eigen::Map<VectorXd> of_cell(out, room.E.size());
      of_cell = room.response.stress;
      if (!moves) continue;
      gather(e, room.v, room.rates);
      cell(e).strain_rate(room.at, room.rates, room.rate);
      of_cell.noalias() += room.response.tangent * room.rate;
    }
  });
  for (std::size_t p = 0; p < averaged_.size(); ++p)
    stress[stress_of_port(p) / dim] = averaged_[p].stress(s.H, delta);
}

template <FrameGroup G>
BodyEnergy ContinuumBody<G>::energy(const BodyState<G>& s, const Vector& gravity) const {
  BodyEnergy out;
  in_room(s, [&](Room& room) {
    positions(s.H, room.x);
    velocities(s, room.v);
    out.kinetic = 0.5 * room.v.cwiseProduct(room.v * mass_).sum();
    out.potential = -gravity.dot(room.x * node_mass_);
    for (int e = 0; e < cells_.cols(); ++e) {
      stress_of(e, room, false);
      out.elastic += room.response.energy;
    }
    for (const auto& port : averaged_) {
      out.elastic += port.elastic_energy(s.H);
      out.kinetic += port.kinetic_energy(s.v);
    }
  });
  return out;
}

template <FrameGroup G>
double ContinuumBody<G>::dissipation(const BodyState<G>& s) const {
  double power = 0;
  if (damping_ > 0)
    in_room(s, [&](Room& room) {
      positions(s.H, room.x);
      velocities(s, room.v);
      for (int e = 0; e < cells_.cols(); ++e) {
        stress_of(e, room, false);
        power += (room.stress - room.response.stress).dot(room.rate);
      }
    });
  return power;
}

template <FrameGroup G>
void ContinuumBody<G>::add_energy_gradient(const BodyState<G>& s, const Vector& gravity,
                                           const BodyEnergy& weight, double* h, double* v) const {
  in_room(s, [&](Room& room) {
    Points elastic;
    BodyState<G> at_rest = s;
    const VectorXd still = VectorXd::Zero(this->size());
    at_rest.v = still.data();  // elastic forces alone
    internal_forces(at_rest, room, elastic, nullptr);
    elastic = weight.elastic * elastic - weight.potential * gravity * node_mass_.transpose();
    add_to_nodes(s.H, elastic, h);
    velocities(s, room.v);
    const Points momentum = weight.kinetic * (room.v * mass_);
    add_to_nodes(s.H, momentum, v);
    for (const auto& port : averaged_) {
      port.add_internal(s.H, weight.elastic, h, nullptr);
      port.add_momentum(s.v, weight.kinetic, v);
    }
    for (int i = 0; i < mesh_nodes(); ++i)
      if (held(i))
        Eigen::Map<Tangent>(h + dim * node_of(i)).template tail<rd>() +=
            turn<G>(local_velocity(s, i)).transpose() *
            (s.H[node_of(i)].R.transpose() * momentum.col(i));
  });
}

template <FrameGroup G>
std::unique_ptr<Body<G>> ContinuumBody<G>::derivative(const LawDerivative<G>& law) const {
  const auto* scale = std::get_if<ScaleDerivative>(&law);
  if (!scale)
    throw std::invalid_argument("derivative of part '" + this->name +
                                "': a continuum has that of the scale of its stiffness and mass; "
                                "expected solid.as = \"reduced\" for that of fractions");
  return std::unique_ptr<Body<G>>(new ContinuumBody(*this, *scale));
}

/// Internal forces are linear in E and in the thickness, those of inertia in rho and in it.
template <FrameGroup G>
ContinuumBody<G>::ContinuumBody(const ContinuumBody& body, const ScaleDerivative& law)
    : ContinuumBody(body) {
  for (Cell& c : shapes_) c.scale(law.stiffness);
  for (MatrixXd& M : cell_mass_) M *= law.mass;
  for (auto& port : averaged_) port.scale(law.stiffness, law.mass);
  mass_ *= law.mass;
  node_mass_ *= law.mass;
  dead_mass_ *= law.mass;
  dead_ *= law.stiffness;
  stiffest_ *= law.stiffness;
  this->K_.sparse *= law.stiffness;
  this->M_.sparse *= law.mass;
}

/// The mean deformation gradient of the cells about a node, by their volumes.
template <FrameGroup G>
void ContinuumBody<G>::turn_axes(G* H) const {
  Points x;
  positions(H, x);
  std::vector<Square, Eigen::aligned_allocator<Square>> mean(
      static_cast<std::size_t>(this->nodes()), Square::Zero());
  VectorXd volume = VectorXd::Zero(this->nodes());
  typename Cell::Positions at;
  for (int e = 0; e < cells_.cols(); ++e) {
    gather(e, x, at);
    const Square F = cell(e).volume() * cell(e).central_gradient(at);
    for (int c = 0; c < cells_.rows(); ++c) {
      mean[node_of(cells_(c, e))] += F;
      volume[node_of(cells_(c, e))] += cell(e).volume();
    }
  }
  for (int k = ports_; k < this->nodes(); ++k) {
    const Square& R = this->reference[k].R;
    H[k].R = polar_rotation<sd>(mean[k] / volume[k], H[k].R * R.transpose()) * R;
  }
}

/// By the ports, each weighted with the inverse square of its distance.
template <FrameGroup G>
void ContinuumBody<G>::follow_frames(const G* start, G* H) const {
  const double size = rest_.squaredNorm();
  for (int k = ports_; k < this->nodes(); ++k) {
    Vector sum = Vector::Zero();
    double weights = 0;
    for (int p = 0; p < ports_; ++p) {
      const Vector from = start[p].R.transpose() * (start[k].x - start[p].x);
      const double weight = 1 / (from.squaredNorm() + kNear * kNear * size);
      sum += weight * (H[p].x + H[p].R * from);
      weights += weight;
    }
    H[k].x = sum / weights;
  }
}

template <FrameGroup G>
std::string ContinuumBody<G>::fault(const G* H) const {
  Points x;
  positions(H, x);
  typename Cell::Positions at;
  for (int e = 0; e < cells_.cols(); ++e) {
    gather(e, x, at);
    if (!(cell(e).smallest_determinant(at) > 0))
      return "cell " + std::to_string(e) + " of '" + this->name + "' is inverted";
  }
  return {};
}

template <FrameGroup G>
MatrixXd ContinuumBody<G>::stresses_at(const Points& x) const {
  MatrixXd out(Cell::kStrains, cells_.cols());
  typename Cell::Positions at;
  for (int e = 0; e < cells_.cols(); ++e) {
    gather(e, x, at);
    out.col(e) = cell(e).central_stress(at);
  }
  return out;
}

template <FrameGroup G>
std::string ContinuumBody<G>::no_forces(const G* H) const {
  Points x;
  positions(H, x);
  if (!x.allFinite()) return {};
  typename Cell::Positions at;
  VectorXd E;
  typename Cell::Response response;
  for (int e = 0; e < cells_.cols(); ++e) {
    gather(e, x, at);
    cell(e).strain(at, E);
    cell(e).respond(E, false, response);
    if (!response.converged)
      return "cell " + std::to_string(e) + " of '" + this->name +
             "' has no stress: it is pushed flat, or its enhanced strains do not converge";
  }
  return {};
}

template class ContinuumBody<SE2>;
template class ContinuumBody<SE3>;

}  // namespace liesl
