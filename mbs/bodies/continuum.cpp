#include "mbs/bodies/continuum.hpp"

#include <map>
#include <set>
#include <stdexcept>

#include "mbs/solids/connectivity.hpp"
#include "mbs/solids/continuum_check.hpp"
#include "mbs/solids/stress_norm.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of an averaged port: stiffness, of E times the size of a cell for each node, and mass, of that of
// its nodes. What the port lags behind them is below what a hundredth of a cell is strained by.
constexpr double kStiffPort = 100, kLightPort = 1e-3;

/// Mass of a cell whose nodes move by themselves, of that of a full one. Empty ones keep as much of
/// it as of their stiffness: accelerations are known, and waves as fast as in the material.
double mass_share(const ErsatzLaw& law, double v) { return law.ratio + (1 - law.ratio) * v; }

/// The linear law of cells that are void stays finite where they are pushed flat.
SolidLaw law_of(const SolidSpec& spec, double v) {
  return v >= kLeastFraction ? spec.law : SolidLaw::StVenantKirchhoff;
}

}  // namespace

template <FrameGroup G>
ContinuumBody<G>::ContinuumBody(std::string body_name, const SolidSpec& spec,
                                const std::vector<G>& ports, const Eigen::Matrix3d& turn)
    : Body<G>(std::move(body_name), nodes_at_rest(spec, ports, turn)),
      ports_(static_cast<int>(ports.size())),
      damping_(spec.damping),
      thickness_(spec.model->thickness()),
      cells_(spec.mesh().cells),
      pattern_(this->size()) {
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
  const ErsatzLaw& law = model.law();
  fraction_ = solid_fractions(spec).value;
  stiff_ = fraction_.unaryExpr([&law](double v) { return law.stiffness(v); });
  heavy_ = fraction_.unaryExpr([&law](double v) { return mass_share(law, v); });
  shares_ = of_solid(relaxed_shares(fraction_));
  // cells of equal shape share their matrices
  std::map<std::pair<const CellMatrices*, SolidLaw>, int> known;
  typename Cell::Positions at;
  for (int e = 0; e < model.mesh().cell_count(); ++e) {
    const SolidLaw of_cell = law_of(spec, fraction_[e]);
    const auto [found, is_new] =
        known.emplace(std::pair{&model.cell(e), of_cell}, static_cast<int>(shapes_.size()));
    shape_of_.push_back(found->second);
    if (!is_new) continue;
    gather(e, rest_, at);
    shapes_.emplace_back(at, model.material(), model.thickness(), of_cell);
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
        assembly.add(cells_(i, e), cells_(j, e), mass_of(e, i, j));
  mass_ = assembly.finish();
  node_mass_ = mass_ * VectorXd::Ones(mesh_nodes());
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

/// The law of a cell with its share of material. @pre room.at
template <FrameGroup G>
void ContinuumBody<G>::respond(int e, Room& room, bool tangent) const {
  cell(e).strain(room.at, room.E);
  cell(e).respond(room.E, tangent, room.response, stiff_[e]);
}

/// Elastic and viscous stress of a cell, S = dW/dE + damping A Edot with A of the linear law.
/// @param elastic stresses of all cells to take for dW/dE, null: those of the state
/// @pre room.x, and room.v with damping
template <FrameGroup G>
void ContinuumBody<G>::stress_of(int e, Room& room, bool tangent, const double* elastic) const {
  gather(e, room.x, room.at);
  if (tangent || !elastic) {
    respond(e, room, tangent);
    room.stress = room.response.stress;
  }
  if (elastic) {
    const int n = cell(e).strains();
    room.stress = Eigen::Map<const VectorXd>(elastic + n * e, n);
  }
  if (damping_ == 0) return;
  gather(e, room.v, room.rates);
  cell(e).strain_rate(room.at, room.rates, room.rate);
  room.stress.noalias() += viscosity(e) * (cell(e).stiffness() * room.rate);
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
    for (const auto& port : averaged_) port.add_inertia(s, gravity, r);
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
      respond(e, room, moves);
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
      out.potential += port.potential_energy(s.H, gravity);
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
      port.add_weight(s.H, gravity, weight.potential, h);
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
  const auto made = [this](VectorXd stiff, VectorXd heavy, double ports) {
    return std::unique_ptr<ContinuumBody>(
        new ContinuumBody(*this, std::move(stiff), std::move(heavy), ports));
  };
  if (const auto* scale = std::get_if<ScaleDerivative>(&law)) {
    auto out = made(scale->stiffness * stiff_, scale->mass * heavy_, scale->stiffness);
    out->shares_.setZero();
    out->stress_ = scale->stress;
    return out;
  }
  const auto* cells = std::get_if<FractionDerivative>(&law);
  if (!cells || !cells->model || cells->fractions.size() != fraction_.size() ||
      cells->derivative.size() != fraction_.size())
    throw std::invalid_argument("derivative of part '" + this->name +
                                "': expected that of the fractions of its cells, or of a scale");
  const ErsatzLaw& ersatz = cells->model->law();
  const VectorXd slope =
      cells->fractions.unaryExpr([&ersatz](double v) { return ersatz.slope(v); });
  auto out = made(slope.cwiseProduct(cells->derivative), (1 - ersatz.ratio) * cells->derivative, 0);
  out->shares_ = of_solid(relaxed_shares_derivative(cells->fractions, cells->derivative));
  out->stress_ = 0;
  return out;
}

/// Averaged ports have a share of the mass of the whole.
template <FrameGroup G>
ContinuumBody<G>::ContinuumBody(const ContinuumBody& body, VectorXd stiff, VectorXd heavy,
                                double ports)
    : ContinuumBody(body) {
  const double mass = total_mass();
  stiff_ = std::move(stiff);
  heavy_ = std::move(heavy);
  make_mass();
  for (auto& port : averaged_) port.scale(ports, mass > 0 ? total_mass() / mass : 0);
  set_constant_matrices();
}

template class ContinuumBody<SE2>;
template class ContinuumBody<SE3>;

}  // namespace liesl
