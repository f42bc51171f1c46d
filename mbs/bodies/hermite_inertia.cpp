#include "mbs/bodies/hermite_inertia.hpp"

#include <algorithm>
#include <cmath>

namespace liesl {
namespace {

/// Index among the rotations of the one that bends along direction i.
template <int rd>
constexpr int bends(int i) {
  return rd == 1 ? 0 : 3 - i;
}

/// The most that s^2 m L^2/24 may be, below what it is in any section of solid material: it needs
/// rotary inertia to act on.
double most(double L, double m, double J) { return 0.9 * L * std::sqrt(m * J / 12); }

/// sqrt(1 - eta)
double root_of_shear(double eta) { return std::sqrt(std::max(0.0, 1 - eta)); }

}  // namespace

template <FrameGroup G>
auto HermiteInertia<G>::coefficients(const Scalar& L, const Matrix& M, const Share& eta)
    -> Coefficients {
  Coefficients c{M, Share::Zero(), Share::Zero()};
  for (int i = 1; i < sd; ++i) {
    const int r = sd + bends<rd>(i);
    const double m = M(0, 0), J = M(r, r), s = root_of_shear(eta[i]);
    c.shear[i] = 2 * s / (1 + s) * J;
    if (J > 0) c.beta[i] = 1 - s + std::min(L * L / 24 * m * s * s, most(L, m, J)) / J;
  }
  return c;
}

template <FrameGroup G>
auto HermiteInertia<G>::derivative(const Scalar& L, const Matrix& M, const Share& eta,
                                   const Matrix& dM, const Share& deta) -> Coefficients {
  Coefficients c{dM, Share::Zero(), Share::Zero()};
  const double m = M(0, 0), dm = dM(0, 0);
  for (int i = 1; i < sd; ++i) {
    const int r = sd + bends<rd>(i);
    const double J = M(r, r), dJ = dM(r, r), largest = most(L, m, J);
    const double s = root_of_shear(eta[i]), ds = s > 0 ? -deta[i] / (2 * s) : 0;
    c.shear[i] = 2 / (1 + s) * (s * dJ + ds / (1 + s) * J);
    if (!(J > 0)) continue;
    c.beta[i] = -ds;
    const double by_mass = L * L / 24 * m * s * s;
    if (by_mass <= largest)
      c.beta[i] += L * L / 24 * s * (s * dm + 2 * ds * m) / J - by_mass / J * dJ / J;
    else if (largest > 0)  // 0: of a section without mass
      c.beta[i] += 0.5 * largest / J * (dm / m - dJ / J);
  }
  return c;
}

namespace {

/// Inertia by rotation, (1/3 + j) and (1/6 - j) of J L.
template <class G>
SectionRotation<G> rotation_of_sections(double L, const typename HermiteInertia<G>::Coefficients& c,
                                        const typename HermiteInertia<G>::Share& beta,
                                        double factor = 1) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  const Eigen::Matrix<double, rd, rd> J = c.M.template bottomRightCorner<rd, rd>();
  Eigen::Matrix<double, rd, rd> moved = Eigen::Matrix<double, rd, rd>::Zero();
  if (rd == 3) moved(0, 0) = J(0, 0) / 12;
  for (int i = 1; i < sd; ++i) moved(bends<rd>(i), bends<rd>(i)) = c.shear[i] / 12;
  return {L, factor * L * (J / 3 + moved), factor * L * (J / 6 - moved), beta};
}

}  // namespace

template <FrameGroup G>
HermiteInertia<G>::HermiteInertia(const Scalar& L, const Coefficients& c)
    : L_(L),
      m_(c.M(0, 0)),
      X_(SectionRotation<G>::turning()),
      sections_{rotation_of_sections<G>(L, c, c.beta)} {
  set_translation();
}

/// Of a quadratic function the difference about its middle is the derivative, for any step t; this
/// one is of the size of beta.
template <FrameGroup G>
HermiteInertia<G>::HermiteInertia(const Scalar& L, const Coefficients& c, const Coefficients& dc)
    : L_(L),
      m_(dc.M(0, 0)),
      X_(SectionRotation<G>::turning()),
      sections_{rotation_of_sections<G>(L, dc, c.beta)} {
  set_translation();
  const double size = c.beta.norm(), change = dc.beta.norm();
  if (change == 0) return;
  const double t = size > 0 ? size / change : 1;
  for (const double step : {t, -t})
    sections_.push_back(rotation_of_sections<G>(L, c, c.beta + step * dc.beta, 1 / (2 * step)));
}

template <FrameGroup G>
void HermiteInertia<G>::set_translation() {
  const Scalar L = L_, m = m_ * L, mL = m * L, mLL = mL * L;
  AA_ << 5 * m / 12, mL / 12, mL / 12, mLL / 32;
  BB_ << 5 * m / 12, -mL / 12, -mL / 12, mLL / 32;
  AB_ << m / 12, 0, 0, mLL / 96;
  M_AA_ = block(AA_, Rotation::Identity(), by_rates());
  M_BB_ = block(BB_, Rotation::Identity(), by_rates());
}

/// w x e_1 = (0, w_z, -w_y), of a plane (0, w).
template <FrameGroup G>
auto HermiteInertia<G>::of_node(const Tangent& v) const -> Two {
  Two p;
  p.col(0) = v.template head<sd>();
  p(0, 1) = 0;
  p(1, 1) = v[dim - 1];
  if constexpr (sd == 3) p(2, 1) = -v[4];
  return p;
}

/// N a + w x (N v), N v by column: rates of R u and R (w x e_1) in the axes of R.
template <FrameGroup G>
auto HermiteInertia<G>::acceleration(const Tangent& v, const Tangent& a) const -> Two {
  Two p = of_node(a);
  if constexpr (sd == 2) {
    const Scalar w = v[2];
    p(0, 0) -= w * v[1];
    p(1, 0) += w * v[0];
    p(0, 1) = -w * w;
  } else {
    const Scalar x = v[3], y = v[4], z = v[5], xy = x * y, xz = x * z, yy = y * y, zz = z * z;
    p(0, 0) += y * v[2] - z * v[1];
    p(1, 0) += z * v[0] - x * v[2];
    p(2, 0) += x * v[1] - y * v[0];
    p(0, 1) = -yy - zz;
    p(1, 1) += xy;
    p(2, 1) += xz;
  }
  return p;
}

/// N^T f
template <FrameGroup G>
auto HermiteInertia<G>::collect(const Two& f) const -> Tangent {
  Tangent g;
  g.template head<sd>() = f.col(0);
  g[dim - 1] = f(1, 1);
  if constexpr (sd == 3) {
    g[3] = 0;
    g[4] = -f(2, 1);
  }
  return g;
}

template <FrameGroup G>
void HermiteInertia<G>::force(const G& A, const G& B, const Scalar* v, const Pair& a,
                              Pair& g) const {
  const Eigen::Map<const Tangent> v_A(v), v_B(v + dim);
  const Rotation S = A.R.transpose() * B.R;
  const Two p = acceleration(v_A, a.template head<dim>()),
            q = acceleration(v_B, a.template tail<dim>());
  const Two from_B = q.lazyProduct(AB_.transpose()), from_A = p.lazyProduct(AB_);
  Two on_A = p.lazyProduct(AA_), on_B = q.lazyProduct(BB_);
  on_A += S.lazyProduct(from_B);
  on_B += S.transpose().lazyProduct(from_A);
  g.template head<dim>() = collect(on_A);
  g.template tail<dim>() = collect(on_B);
  for (const auto& s : sections_) s.add_force(A, B, v, a, g);
}

/// N^T (c x R) dp, N the derivatives by rates and dp these.
template <FrameGroup G>
auto HermiteInertia<G>::block(const Square& c, const Rotation& R, const Derivatives& by) const
    -> Matrix {
  const Rotation Ru = R.lazyProduct(by.uu);
  const auto turned = [&](int i) -> Turning {
    const Turning sum = c(i, 0) * by.uw + c(i, 1) * by.w1;
    return R.lazyProduct(sum);
  };
  Matrix M;
  M.template topLeftCorner<sd, sd>() = c(0, 0) * Ru;
  M.template topRightCorner<sd, rd>() = turned(0);
  M.template bottomLeftCorner<rd, sd>() = c(1, 0) * X_.transpose().lazyProduct(Ru);
  M.template bottomRightCorner<rd, rd>() = X_.transpose().lazyProduct(turned(1));
  return M;
}

template <FrameGroup G>
auto HermiteInertia<G>::mass(const G& A, const G& B) const -> PairMatrix {
  const Matrix M_AB = block(AB_, A.R.transpose().lazyProduct(B.R), by_rates());
  PairMatrix M;
  M << M_AA_, M_AB, M_AB.transpose(), M_BB_;
  for (const auto& s : sections_) s.add_mass(A, B, M);
  return M;
}

/// D_v acceleration(v, a): d(w x q) = w x dq - q x dw.
template <FrameGroup G>
auto HermiteInertia<G>::gyroscopic(const Tangent& v) const -> Derivatives {
  using Rot = RotationOf<G>;
  const Two q = of_node(v);
  Rotation W;  // w x
  if constexpr (sd == 2)
    W << 0, -v[2], v[2], 0;
  else
    W = hat(Vector(v.template tail<3>()));
  return {W, -Rot::cross(q.col(0)), W.lazyProduct(X_) - Rot::cross(q.col(1))};
}

template <FrameGroup G>
auto HermiteInertia<G>::gyroscopic_tangent(const G& A, const G& B, const Scalar* v) const
    -> PairMatrix {
  const Eigen::Map<const Tangent> v_A(v), v_B(v + dim);
  const Rotation I = Rotation::Identity(), S = A.R.transpose().lazyProduct(B.R);
  const Derivatives by_A = gyroscopic(v_A), by_B = gyroscopic(v_B);
  PairMatrix c;
  c << block(AA_, I, by_A), block(AB_, S, by_B),  //
      block(AB_.transpose(), S.transpose(), by_A), block(BB_, I, by_B);
  for (const auto& s : sections_) s.add_gyroscopic_tangent(A, B, v, c);
  return c;
}

/// N^T of two matrices on(i) that act on the rotation of the node at `column`.
template <FrameGroup G>
template <class F>
void HermiteInertia<G>::add_turned(const F& on, int row, int column, PairMatrix& k) const {
  k.template block<sd, rd>(row, column + sd) += on(0);
  k.template block<rd, rd>(row + sd, column + sd) += X_.transpose().lazyProduct(on(1));
}

/// dS = -w_A~ S + S w_B~ on what each node has of the other.
template <FrameGroup G>
auto HermiteInertia<G>::stiffness(const G& A, const G& B, const Scalar* v, const Pair& a) const
    -> PairMatrix {
  using Rot = RotationOf<G>;
  const Rotation S = A.R.transpose().lazyProduct(B.R), St = S.transpose();
  const Two p = acceleration(Eigen::Map<const Tangent>(v), a.template head<dim>()),
            q = acceleration(Eigen::Map<const Tangent>(v + dim), a.template tail<dim>());
  const Two y = q.lazyProduct(AB_.transpose()), z = p.lazyProduct(AB_);
  const Two Sy = S.lazyProduct(y), Sz = St.lazyProduct(z);
  PairMatrix k = PairMatrix::Zero();
  add_turned([&](int i) -> Turning { return Rot::cross(Sy.col(i)); }, 0, 0, k);
  add_turned([&](int i) -> Turning { return -S.lazyProduct(Rot::cross(y.col(i))); }, 0, dim, k);
  add_turned([&](int i) -> Turning { return -St.lazyProduct(Rot::cross(z.col(i))); }, dim, 0, k);
  add_turned([&](int i) -> Turning { return Rot::cross(Sz.col(i)); }, dim, dim, k);
  for (const auto& s : sections_) s.add_stiffness(A, B, v, a, k);
  return k;
}

template <FrameGroup G>
void HermiteInertia<G>::add_weight_tangent(const G& A, const G& B, const Vector& gravity,
                                           const PairMatrix& M, PairMatrix& k) {
  using Rot = RotationOf<G>;
  const auto turned = [&](const G& H) -> Turning {  // -d(R^T g) = w x (R^T g)
    return -Rot::cross(Vector(H.R.transpose().lazyProduct(gravity)));
  };
  k.template middleCols<rd>(sd) += M.template leftCols<sd>().lazyProduct(turned(A));
  k.template rightCols<rd>() += M.template middleCols<sd>(dim).lazyProduct(turned(B));
}

template <FrameGroup G>
auto HermiteInertia<G>::kinetic_energy(const G& A, const G& B, const Scalar* v) const -> Scalar {
  const Two p = of_node(Eigen::Map<const Tangent>(v)),
            q = of_node(Eigen::Map<const Tangent>(v + dim));
  const Two from_B = A.R.transpose() * (B.R * (q * AB_.transpose()));
  Scalar T = p.cwiseProduct(from_B + 0.5 * p * AA_).sum() + 0.5 * q.cwiseProduct(q * BB_).sum();
  for (const auto& s : sections_) T += s.kinetic_energy(A, B, v);
  return T;
}

/// p_A . dS y, y = c p_B.
template <FrameGroup G>
auto HermiteInertia<G>::kinetic_gradient(const G& A, const G& B, const Scalar* v) const -> Pair {
  using Rot = RotationOf<G>;
  const Rotation S = A.R.transpose() * B.R;
  const Two p = of_node(Eigen::Map<const Tangent>(v)),
            y = of_node(Eigen::Map<const Tangent>(v + dim)) * AB_.transpose();
  Pair g = Pair::Zero();
  for (int i = 0; i < 2; ++i) {
    g.template segment<rd>(sd) += Rot::cross(Vector(S * y.col(i))).transpose() * p.col(i);
    g.template tail<rd>() -= Rot::cross(Vector(y.col(i))).transpose() * (S.transpose() * p.col(i));
  }
  for (const auto& s : sections_) s.add_kinetic_gradient(A, B, v, g);
  return g;
}

template <FrameGroup G>
auto HermiteInertia<G>::weight_potential(const G& A, const G& B, const Vector& a) const -> Scalar {
  return -m_ * L_ * a.dot(0.5 * (A.x + B.x) + L_ / 12 * (A.R.col(0) - B.R.col(0)));
}

template <FrameGroup G>
auto HermiteInertia<G>::weight_gradient(const G& A, const G& B, const Vector& a) const -> Pair {
  const Vector at_A = A.R.transpose() * a, at_B = B.R.transpose() * a;
  Pair g;
  g << 0.5 * at_A, L_ / 12 * (X_.transpose() * at_A), 0.5 * at_B,
      -L_ / 12 * (X_.transpose() * at_B);
  return -m_ * L_ * g;
}

template class HermiteInertia<SE2>;
template class HermiteInertia<SE3>;
template void HermiteInertia<SE2Of<Lanes>>::force(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                  const Lanes*, const Pair&, Pair&) const;
template auto HermiteInertia<SE2Of<Lanes>>::mass(const SE2Of<Lanes>&, const SE2Of<Lanes>&) const
    -> PairMatrix;
template auto HermiteInertia<SE2Of<Lanes>>::gyroscopic_tangent(const SE2Of<Lanes>&,
                                                               const SE2Of<Lanes>&,
                                                               const Lanes*) const -> PairMatrix;
template auto HermiteInertia<SE2Of<Lanes>>::stiffness(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                      const Lanes*, const Pair&) const
    -> PairMatrix;
template void HermiteInertia<SE2Of<Lanes>>::add_weight_tangent(const SE2Of<Lanes>&,
                                                               const SE2Of<Lanes>&, const Vector&,
                                                               const PairMatrix&, PairMatrix&);
template auto HermiteInertia<SE2Of<Lanes>>::kinetic_energy(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                           const Lanes*) const -> Scalar;
template auto HermiteInertia<SE2Of<Lanes>>::weight_potential(const SE2Of<Lanes>&,
                                                             const SE2Of<Lanes>&,
                                                             const Vector&) const -> Scalar;
template void HermiteInertia<SE3Of<Lanes>>::force(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                  const Lanes*, const Pair&, Pair&) const;
template auto HermiteInertia<SE3Of<Lanes>>::mass(const SE3Of<Lanes>&, const SE3Of<Lanes>&) const
    -> PairMatrix;
template auto HermiteInertia<SE3Of<Lanes>>::gyroscopic_tangent(const SE3Of<Lanes>&,
                                                               const SE3Of<Lanes>&,
                                                               const Lanes*) const -> PairMatrix;
template auto HermiteInertia<SE3Of<Lanes>>::stiffness(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                      const Lanes*, const Pair&) const
    -> PairMatrix;
template void HermiteInertia<SE3Of<Lanes>>::add_weight_tangent(const SE3Of<Lanes>&,
                                                               const SE3Of<Lanes>&, const Vector&,
                                                               const PairMatrix&, PairMatrix&);
template auto HermiteInertia<SE3Of<Lanes>>::kinetic_energy(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                           const Lanes*) const -> Scalar;
template auto HermiteInertia<SE3Of<Lanes>>::weight_potential(const SE3Of<Lanes>&,
                                                             const SE3Of<Lanes>&,
                                                             const Vector&) const -> Scalar;

}  // namespace liesl
