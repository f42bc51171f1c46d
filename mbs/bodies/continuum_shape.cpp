/// @file
/// Shapes of meshed parts whose nodes all move: axes of the nodes, stresses of the cells, and
/// whether the cells have any.

#include "mbs/bodies/continuum.hpp"
#include "mbs/bodies/polar_rotation.hpp"
#include "mbs/solids/connectivity.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNear = 1e-6;  // of the size of the mesh: a node at a port goes with that alone

}  // namespace

/// Cells that are void fold and turn inside out where the walls about them come together; what they
/// weigh and resist, a twentieth of the material at most, does not tell.
template <FrameGroup G>
bool ContinuumBody<G>::solid(int e) const {
  return fraction_[e] >= kLeastFraction;
}

/// The mean deformation gradient of the cells about a node, by the volumes of their material.
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
    const double volume_of_cell = heavy_[e] * cell(e).volume();
    const Square F = volume_of_cell * cell(e).central_gradient(at);
    for (int c = 0; c < cells_.rows(); ++c) {
      mean[node_of(cells_(c, e))] += F;
      volume[node_of(cells_(c, e))] += volume_of_cell;
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
std::optional<ShapeFault> ContinuumBody<G>::fault(const G* H) const {
  Points x;
  positions(H, x);
  typename Cell::Positions at;
  for (int e = 0; e < cells_.cols(); ++e) {
    if (!solid(e)) continue;
    gather(e, x, at);
    if (!(cell(e).smallest_determinant(at) > 0))
      return ShapeFault{"cell " + std::to_string(e) + " of '" + this->name + "' is inverted",
                        cell(e).law() == SolidLaw::StVenantKirchhoff
                            ? "use smaller cells there, or law = \"neo_hookean\""
                            : "use smaller cells there"};
  }
  return {};
}

template <FrameGroup G>
MatrixXd ContinuumBody<G>::stresses_at(const Points& x) const {
  MatrixXd out = MatrixXd::Zero(Cell::kStrains, cells_.cols());
  typename Cell::Positions at;
  for (int e = 0; e < cells_.cols(); ++e) {
    if (!solid(e)) continue;
    gather(e, x, at);
    out.col(e) = cell(e).central_stress(at);
  }
  return out;
}

template <FrameGroup G>
VectorXd ContinuumBody<G>::of_solid(VectorXd shares) const {
  for (int e = 0; e < shares.size(); ++e)
    if (!solid(e)) shares[e] = 0;
  return shares;
}

template <FrameGroup G>
MatrixXd ContinuumBody<G>::cell_stresses(const BodyState<G>& s) const {
  Points x;
  positions(s.H, x);
  return stress_ * stresses_at(x);
}

template <FrameGroup G>
VectorXd ContinuumBody<G>::cell_stress(const BodyState<G>& s, int e) const {
  Points x;
  positions(s.H, x);
  typename Cell::Positions at;
  gather(e, x, at);
  return stress_ * cell(e).central_stress(at);
}

template <FrameGroup G>
void ContinuumBody<G>::add_cell_stress_gradient(const BodyState<G>& s, int e, const VectorXd& f,
                                                double* h) const {
  Points x, by_x = Points::Zero(sd, mesh_nodes());
  positions(s.H, x);
  typename Cell::Positions at, by_at = Cell::Positions::Zero(sd, cells_.rows());
  gather(e, x, at);
  cell(e).add_central_stress_gradient(at, stress_ * f, by_at);
  for (int c = 0; c < cells_.rows(); ++c) by_x.col(cells_(c, e)) = by_at.col(c);
  add_to_nodes(s.H, by_x, h);
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

template bool ContinuumBody<SE2>::solid(int) const;
template bool ContinuumBody<SE3>::solid(int) const;
template void ContinuumBody<SE2>::turn_axes(SE2*) const;
template void ContinuumBody<SE3>::turn_axes(SE3*) const;
template void ContinuumBody<SE2>::follow_frames(const SE2*, SE2*) const;
template void ContinuumBody<SE3>::follow_frames(const SE3*, SE3*) const;
template std::optional<ShapeFault> ContinuumBody<SE2>::fault(const SE2*) const;
template std::optional<ShapeFault> ContinuumBody<SE3>::fault(const SE3*) const;
template std::string ContinuumBody<SE2>::no_forces(const SE2*) const;
template std::string ContinuumBody<SE3>::no_forces(const SE3*) const;
template MatrixXd ContinuumBody<SE2>::stresses_at(const Points&) const;
template MatrixXd ContinuumBody<SE3>::stresses_at(const Points&) const;
template VectorXd ContinuumBody<SE2>::of_solid(VectorXd) const;
template VectorXd ContinuumBody<SE3>::of_solid(VectorXd) const;
template MatrixXd ContinuumBody<SE2>::cell_stresses(const BodyState<SE2>&) const;
template MatrixXd ContinuumBody<SE3>::cell_stresses(const BodyState<SE3>&) const;
template VectorXd ContinuumBody<SE2>::cell_stress(const BodyState<SE2>&, int) const;
template VectorXd ContinuumBody<SE3>::cell_stress(const BodyState<SE3>&, int) const;
template void ContinuumBody<SE2>::add_cell_stress_gradient(const BodyState<SE2>&, int,
                                                           const VectorXd&, double*) const;
template void ContinuumBody<SE3>::add_cell_stress_gradient(const BodyState<SE3>&, int,
                                                           const VectorXd&, double*) const;

}  // namespace liesl
