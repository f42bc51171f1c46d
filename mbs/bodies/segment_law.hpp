#pragma once
/// @file
/// What chains of segments have in common in a plane (`SegmentBeam`) and in space
/// (`SpatialSegmentBeam`): the axial potential, the springs between segments, their masses and the
/// inertia of the points between them.

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/bodies/body.hpp"
#include "mbs/bodies/body_matrix.hpp"
#include "mbs/bodies/law_derivative.hpp"
#include "mbs/model/mechanism.hpp"

namespace liesl {

/// N of a segment of length L that is l long, N: k (l - L) with k = EA/L [N/m], or EA/3 (lambda -
/// 1/lambda^2) with lambda = l/L.
template <class S>
S axial_force(AxialPotential potential, const S& k, const S& L, const S& l) {
  if (potential == AxialPotential::Linear) return k * (l - L);
  const S stretch = l / L;
  return k * L / 3 * (stretch - 1 / (stretch * stretch));
}

/// dN/dl, N/m.
inline double axial_force_slope(AxialPotential potential, double k, double L, double l) {
  if (potential == AxialPotential::Linear) return k;
  const double stretch = l / L;
  return k / 3 * (1 + 2 / (stretch * stretch * stretch));
}

/// J: k (l - L)^2/2, or EA L/6 (lambda^2 + 2/lambda - 3).
inline double axial_energy(AxialPotential potential, double k, double L, double l) {
  if (potential == AxialPotential::Linear) return 0.5 * k * (l - L) * (l - L);
  const double stretch = l / L;
  return k * L * L / 6 * (stretch * stretch + 2 / stretch - 3);
}

/// c_i, N m: 1/c_i = sum of L_e/(2 EI_e) over the segments at node i. @param L, EI by segment
inline Eigen::VectorXd bending_springs(const Eigen::VectorXd& L, const Eigen::VectorXd& EI) {
  Eigen::VectorXd flexibility = Eigen::VectorXd::Zero(L.size() + 1);
  for (Eigen::Index e = 0; e < L.size(); ++e)
    for (const Eigen::Index i : {e, e + 1}) flexibility[i] += 0.5 * L[e] / EI[e];
  return flexibility.cwiseInverse();
}

/// dc_i = c_i^2 sum of L_e/(2 EI_e^2) dEI_e.
inline Eigen::VectorXd bending_springs_by(const Eigen::VectorXd& c, const Eigen::VectorXd& L,
                                          const Eigen::VectorXd& EI, const Eigen::VectorXd& dEI) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(c.size());
  for (Eigen::Index e = 0; e < L.size(); ++e)
    for (const Eigen::Index i : {e, e + 1})
      out[i] += c[i] * c[i] * 0.5 * L[e] / (EI[e] * EI[e]) * dEI[e];
  return out;
}

/// Segments [first, end).
struct SegmentRange {
  int first = 0, end = 0;

  /// With those beside them, out of n: all that springs at their nodes act on.
  SegmentRange with_neighbours(int n) const {
    return {std::max(first - 1, 0), std::min(end + 1, n)};
  }
};

/// The smallest range with every segment whose law is not 0: of the derivative by a parameter that
/// is of a few segments, forces elsewhere are 0 and cost nothing.
template <FrameGroup G>
SegmentRange acting_range(const std::vector<ElementSection<G>>& sections) {
  SegmentRange out;
  for (int e = 0; e < static_cast<int>(sections.size()); ++e) {
    const auto& section = sections[static_cast<std::size_t>(e)];
    if (section.K.isZero(0) && section.M.isZero(0)) continue;
    if (out.end == 0) out.first = e;
    out.end = e + 1;
  }
  return out;
}

/// Mass between nodes i and j, equal or neighbours, kg: consistent m/3 and m/6 of each segment, or
/// m/2. @param m by segment, kg
inline double mass_between(const Eigen::VectorXd& m, bool lumped, Eigen::Index i, Eigen::Index j) {
  if (i != j) return lumped ? 0 : m[std::min(i, j)] / 6;
  const double own = (i > 0 ? m[i - 1] : 0) + (i < m.size() ? m[i] : 0);
  return own / (lumped ? 2 : 3);
}

/// Velocity of a node in inertial axes.
template <FrameGroup G>
auto node_velocity(const BodyState<G>& s, int k) {
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  return Vector(s.H[k].R * Eigen::Map<const Vector>(s.v + G::dim * k));
}

/// u' + w x u: its acceleration in its own axes.
inline Eigen::Vector2d node_acceleration(const BodyState<SE2>& s, int k) {
  const double *v = s.v + 3 * k, *a = s.vdot + 3 * k;
  return {a[0] - v[2] * v[1], a[1] + v[2] * v[0]};
}
inline Vec3 node_acceleration(const BodyState<SE3>& s, int k) {
  const Vec3 u = Eigen::Map<const Vec3>(s.v + 6 * k), w = Eigen::Map<const Vec3>(s.v + 6 * k + 3);
  return Eigen::Map<const Vec3>(s.vdot + 6 * k) + w.cross(u);
}

/// Nodes 1 ... n - 1 of H to where its ends carry them from `start`, linear in between.
template <FrameGroup G>
void follow_ends(const G* start, int n, G* H) {
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  for (int k = 1; k < n; ++k) {
    const auto carried = [&](int end) -> Vector {
      const Vector from_end = start[end].R.transpose() * (start[k].x - start[end].x);
      return H[end].x + H[end].R * from_end;
    };
    const double share = static_cast<double>(k) / n;
    H[k].x = (1 - share) * carried(0) + share * carried(n);
  }
}

/// r += the inertia of the points of `acting` segments against x'' - g, without the end sections.
/// @param m by segment, kg
template <FrameGroup G>
void add_point_inertia(const BodyState<G>& s, const Eigen::VectorXd& m, SegmentRange acting,
                       bool lumped, const Eigen::Matrix<double, G::space_dim, 1>& gravity,
                       double* r, ForceScale& scale) {
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  const auto apparent = [&](int k) -> Vector {
    return s.H[k].R * node_acceleration(s, k) - gravity;
  };
  Vector f = Vector::Zero(), a = apparent(acting.first);
  ForceScale own;  // summed in registers, not in what r may overlap
  const auto put = [&](int k) {
    typename G::Tangent local = G::Tangent::Zero();
    local.template head<G::space_dim>() = s.H[k].R.transpose() * f;
    Eigen::Map<typename G::Tangent>(r + G::dim * k) += local;
    own.add<G>(local);
  };
  for (int e = acting.first; e < acting.end; ++e) {
    const Vector b = apparent(e + 1);
    f += lumped ? Vector(0.5 * m[e] * a) : Vector(m[e] / 6 * (2 * a + b));
    put(e);
    f = lumped ? Vector(0.5 * m[e] * b) : Vector(m[e] / 6 * (a + 2 * b));
    a = b;
  }
  put(acting.end);
  scale.force += own.force;
}

/// Kinetic energy of a segment of mass m [kg] whose ends have the velocities a and b, J.
template <class Vector>
double kinetic_energy(double m, bool lumped, const Vector& a, const Vector& b) {
  return lumped ? m / 4 * (a.squaredNorm() + b.squaredNorm())
                : m / 6 * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
}

/// The block of nodes i and j, at most next neighbours, of a wide chain.
template <int N>
typename BodyMatrix<N>::Block& block_of(BodyMatrix<N>& A, int i, int j) {
  switch (j - i) {
    case 0:
      return A.D[i];
    case 1:
      return A.U[i];
    case -1:
      return A.L[j];
    case 2:
      return A.U2[i];
    default:
      return A.L2[j];
  }
}

/// @param length what rotations are compared with, m
/// @throws std::invalid_argument for a section that couples N, V and M, or whose mass is off the
/// axis
template <FrameGroup G>
void require_on_axis(const std::string& name, const std::vector<ElementSection<G>>& sections,
                     double length) {
  constexpr double kCoupled = 1e-12;  // of the diagonal
  typename G::Tangent scale = G::Tangent::Ones();
  scale.template tail<G::rotation_dim>().setConstant(length);
  const auto couples = [&](const typename G::Matrix& A) {
    typename G::Matrix off =
        scale.cwiseInverse().asDiagonal() * A * scale.cwiseInverse().asDiagonal();
    const double size = kCoupled * off.diagonal().maxCoeff();
    off.diagonal().setZero();
    return off.cwiseAbs().maxCoeff() > size;
  };
  for (const auto& section : sections)
    if (couples(section.K) || couples(section.M))
      throw std::invalid_argument(
          "beam '" + name +
          "': a chain of segments needs sections on their axis, without coupling of N, V and M; "
          "formalism se3 has them");
}

}  // namespace liesl
