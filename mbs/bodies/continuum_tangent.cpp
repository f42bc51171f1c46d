/// @file
/// Matrices of meshed parts whose nodes all move: at rest, and the exact tangent.

#include <algorithm>
#include <type_traits>

#include "mbs/bodies/continuum.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

template <FrameGroup G>
void ContinuumBody<G>::set_constant_matrices() {
  const BodyState<G> rest{this->reference.data()};
  const std::vector<Share> stiffness = {{[this](int e, MatrixXd& K) {
                                           typename Cell::Positions at;
                                           MatrixXd B;
                                           gather(e, rest_, at);
                                           cell(e).strain_matrix(at, B);
                                           K.noalias() =
                                               stiff_[e] * B.transpose() * cell(e).stiffness() * B;
                                         },
                                         levers(rest.H)}};
  const std::vector<Share> mass = {inertia_share(levers(rest.H))};
  const OfPorts of_ports = [&rest](const AveragedPort<G>& port, std::size_t) {
    return port.stiffness_at(rest.H, VectorXd::Zero(port.strains()));
  };
  add_shares(rest.H, stiffness, 0, of_ports, pattern_);
  const Eigen::SparseMatrix<double> K = pattern_.finish();
  const double size = std::cbrt(shapes_[0].volume());
  stiffest_ = 0;
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
  const bool held_only = std::ranges::all_of(shares, &Share::held_only);
  std::vector<MatrixXd> of_cell(shares.size(), MatrixXd(sd * cells_.rows(), sd * cells_.rows()));
  constexpr std::integral_constant<int, sd> position;
  constexpr std::integral_constant<int, dim> frame;
  for (int e = 0; e < cells_.cols(); ++e) {
    if (!held_only || holds(e))
      for (std::size_t t = 0; t < shares.size(); ++t) shares[t].cell(e, of_cell[t]);
    const auto add = [&](int a, int b, auto row_count, auto column_count) {
      constexpr int m = decltype(row_count)::value, n = decltype(column_count)::value;
      const int i = cells_(a, e), j = cells_(b, e);
      Eigen::Matrix<double, sd, n> moved = Eigen::Matrix<double, sd, n>::Zero();
      for (std::size_t t = 0; t < shares.size(); ++t)
        if (n == dim || !shares[t].held_only)
          moved.noalias() += of_cell[t].template block<sd, sd>(sd * a, sd * b) *
                             shares[t].columns[j].template leftCols<n>();
      const Eigen::Matrix<double, m, n> block = rows[i].template leftCols<m>().transpose() * moved;
      assembly.add_block(dim * node_of(i), dim * node_of(j), block);
    };
    for (int b = 0; b < cells_.rows(); ++b)
      for (int a = 0; a < cells_.rows(); ++a) {
        const bool by_frame = held(cells_(b, e));
        if (held(cells_(a, e)))
          by_frame ? add(a, b, frame, frame) : add(a, b, frame, position);
        else
          by_frame ? add(a, b, position, frame) : add(a, b, position, position);
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
                M.template block<sd, sd>(sd * i, sd * j).diagonal().setConstant(mass_of(e, i, j));
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
                                        viscosity(e) * B.transpose() * (cell(e).stiffness() * Bv);
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
            C.noalias() = viscosity(e) * B.transpose() * (cell(e).stiffness() * B);
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
    for (const auto& port : averaged_)
      A.add_to_node(port.port(), w.stiffness * port.weight_stiffness(s.H, gravity));
  });
}

template void ContinuumBody<SE2>::set_constant_matrices();
template void ContinuumBody<SE3>::set_constant_matrices();
template auto ContinuumBody<SE2>::masses_of_ports() const -> OfPorts;
template auto ContinuumBody<SE3>::masses_of_ports() const -> OfPorts;
template Eigen::SparseMatrix<double> ContinuumBody<SE2>::assemble(const SE2*,
                                                                  const std::vector<Share>&, double,
                                                                  const OfPorts&) const;
template Eigen::SparseMatrix<double> ContinuumBody<SE3>::assemble(const SE3*,
                                                                  const std::vector<Share>&, double,
                                                                  const OfPorts&) const;
template void ContinuumBody<SE2>::add_shares(const SE2*, const std::vector<Share>&, double,
                                             const OfPorts&, SparseAssembly&) const;
template void ContinuumBody<SE3>::add_shares(const SE3*, const std::vector<Share>&, double,
                                             const OfPorts&, SparseAssembly&) const;
template auto ContinuumBody<SE2>::inertia_share(Levers, bool) const -> Share;
template auto ContinuumBody<SE3>::inertia_share(Levers, bool) const -> Share;
template auto ContinuumBody<SE2>::damping_share(Room&, Levers) const -> Share;
template auto ContinuumBody<SE3>::damping_share(Room&, Levers) const -> Share;
template Eigen::SparseMatrix<double> ContinuumBody<SE2>::stiffness_at(const BodyState<SE2>&, Room&,
                                                                      const double*) const;
template Eigen::SparseMatrix<double> ContinuumBody<SE3>::stiffness_at(const BodyState<SE3>&, Room&,
                                                                      const double*) const;
template Eigen::SparseMatrix<double> ContinuumBody<SE2>::damping_at(const BodyState<SE2>&,
                                                                    Room&) const;
template Eigen::SparseMatrix<double> ContinuumBody<SE3>::damping_at(const BodyState<SE3>&,
                                                                    Room&) const;
template void ContinuumBody<SE2>::exact_tangent(const BodyState<SE2>&, const Vector&,
                                                TangentWeights, const Tangent*, Matrices&) const;
template void ContinuumBody<SE3>::exact_tangent(const BodyState<SE3>&, const Vector&,
                                                TangentWeights, const Tangent*, Matrices&) const;

}  // namespace liesl
