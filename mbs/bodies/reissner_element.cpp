#include "mbs/bodies/reissner_element.hpp"

#include "mbs/bodies/body.hpp"

namespace liesl {
namespace {

template <FrameGroup G>
using Angular = typename RotationOf<G>::Vector;
template <FrameGroup G>
using AngularMatrix = typename RotationOf<G>::Matrix;

template <FrameGroup G>
AngularMatrix<G> W(const Angular<G>& phi) {
  using Rot = RotationOf<G>;
  return 0.5 * Rot::T(0.5 * phi) * Rot::Tinv(phi);
}

/// D_phi [W(phi)^T c]
template <FrameGroup G>
AngularMatrix<G> dWT(const Angular<G>& phi, const Angular<G>& c) {
  using Rot = RotationOf<G>;
  const Angular<G> half = -0.5 * phi;
  return 0.5 * Rot::dTinvT(phi, Rot::T(half) * c) -
         0.25 * Rot::Tinv(phi).transpose() * Rot::dT(half, c);
}

/// D_phi [T^-1(phi) w], T^-1(phi) = T^-T(-phi)
template <FrameGroup G>
AngularMatrix<G> dTinv(const Angular<G>& phi, const Angular<G>& w) {
  return -RotationOf<G>::dTinvT(-phi, w);
}

/// D_phi [W(phi) w]
template <FrameGroup G>
AngularMatrix<G> dW(const Angular<G>& phi, const Angular<G>& w) {
  using Rot = RotationOf<G>;
  const Angular<G> half = 0.5 * phi;
  return 0.25 * Rot::dT(half, Rot::Tinv(phi) * w) + 0.5 * Rot::T(half) * dTinv<G>(phi, w);
}

}  // namespace

template <FrameGroup G>
ReissnerElement<G>::ReissnerElement(const G& A, const G& B, const Matrix& K, const Matrix& M_s)
    : d0_(relative(A, B)), L_(d0_.template head<sd>().norm()), K_(K), M_s_(M_s) {
  mass_ = mass(A, B);
}

template <FrameGroup G>
auto ReissnerElement<G>::relative(const G& A, const G& B) -> Tangent {
  using Rot = RotationOf<G>;
  const Angular<G> phi = Rot::log(A.R.transpose() * B.R);
  Tangent d;
  d << Rot::exp(-0.5 * phi) * (A.R.transpose() * (B.x - A.x)), phi;
  return d;
}

template <FrameGroup G>
auto ReissnerElement<G>::P(const Tangent& d) -> Gradient {
  using Rot = RotationOf<G>;
  const Angular<G> phi = d.template tail<rd>();
  const Rotation E = Rot::exp(0.5 * phi);
  const auto D = Rot::cross(d.template head<sd>());
  Gradient p = Gradient::Zero();
  p.template block<sd, sd>(0, 0) = -E.transpose();
  p.template block<sd, rd>(0, sd) = D * W<G>(-phi);
  p.template block<sd, sd>(0, dim) = E;
  p.template block<sd, rd>(0, dim + sd) = D * W<G>(phi);
  p.template block<rd, rd>(sd, sd) = -Rot::Tinv(-phi);
  p.template block<rd, rd>(sd, dim + sd) = Rot::Tinv(phi);
  return p;
}

/// With E = exp(phi/2) and omega = W(-phi) w_A + W(phi) w_B.
template <FrameGroup G>
auto ReissnerElement<G>::dP(const Tangent& d, const double* v) -> Matrix {
  using Rot = RotationOf<G>;
  const Eigen::Map<const Pair> V(v);
  const Angular<G> phi = d.template tail<rd>(), half = 0.5 * phi, back = -phi;
  const Angular<G> wA = V.template segment<rd>(sd), wB = V.template segment<rd>(dim + sd);
  const Rotation E = Rot::exp(half);
  const Angular<G> omega = W<G>(back) * wA + W<G>(phi) * wB;
  Matrix D = Matrix::Zero();
  for (int j = 0; j < sd; ++j) D.template block<sd, 1>(0, j) = Rot::cross(Vector::Unit(j)) * omega;
  D.template block<sd, rd>(0, sd) =
      -0.5 * E.transpose() * Rot::cross(V.template segment<sd>(0)) * Rot::T(-half) -
      0.5 * E * Rot::cross(V.template segment<sd>(dim)) * Rot::T(half) +
      Rot::cross(d.template head<sd>()) * (dW<G>(phi, wB) - dW<G>(back, wA));
  D.template block<rd, rd>(sd, sd) = dTinv<G>(back, wA) + dTinv<G>(phi, wB);
  return D;
}

template <FrameGroup G>
auto ReissnerElement<G>::material_tangent(const G& A, const G& B) const -> PairMatrix {
  const Gradient p = P(relative(A, B));
  return p.transpose() * K_ * p / L_;
}

template <FrameGroup G>
void ReissnerElement<G>::internal_force(const G& A, const G& B, const double* v, double damping,
                                        Pair& g, const double* /*about*/) const {
  const Tangent d = relative(A, B);
  const Gradient p = P(d);
  Tangent strain = (d - d0_) / L_;
  if (damping > 0) strain += (damping / L_) * (p * Eigen::Map<const Pair>(v));
  const Tangent n = K_.lazyProduct(strain);
  g.noalias() = p.transpose() * n;
}

template <FrameGroup G>
auto ReissnerElement<G>::tangent(const G& A, const G& B, const Tangent& n) const -> PairMatrix {
  using Rot = RotationOf<G>;
  const Tangent d = relative(A, B);
  const Gradient p = P(d);
  const Angular<G> phi = d.template tail<rd>(), m = n.template tail<rd>(), half = 0.5 * phi;
  const Vector N = n.template head<sd>();
  const Rotation E = Rot::exp(half);
  const auto CN = Rot::cross(N);
  const Angular<G> c = Rot::cross(d.template head<sd>()).transpose() * N;
  Eigen::Matrix<double, 2 * dim, dim> geometric = Eigen::Matrix<double, 2 * dim, dim>::Zero();
  geometric.template block<sd, rd>(0, sd) = 0.5 * E * CN * Rot::T(half);
  geometric.template block<sd, rd>(dim, sd) = 0.5 * E.transpose() * CN * Rot::T(-half);
  geometric.template block<rd, sd>(sd, 0) = -W<G>(-phi).transpose() * CN.transpose();
  geometric.template block<rd, rd>(sd, sd) = Rot::dTinvT(-phi, m) - dWT<G>(-phi, c);
  geometric.template block<rd, sd>(dim + sd, 0) = -W<G>(phi).transpose() * CN.transpose();
  geometric.template block<rd, rd>(dim + sd, sd) = Rot::dTinvT(phi, m) + dWT<G>(phi, c);
  return p.transpose() * K_ * p / L_ + geometric * p;
}

template <FrameGroup G>
void ReissnerElement<G>::inertia_force(const G& A, const G& B, const double* v, const Pair& a,
                                       Pair& g) const {
  using Rot = RotationOf<G>;
  const Eigen::Map<const Pair> V(v);
  const double m = M_s_(0, 0) * L_ / 6;
  const AngularMatrix<G> J = M_s_.template bottomRightCorner<rd, rd>() * (L_ / 6);
  const Rotation R = A.R.transpose() * B.R;
  // Accelerations in the axes of A and of B: a_u + w x u = a_u - cross(u) w.
  const auto inertial = [&](int at) -> Vector {
    return a.template segment<sd>(at) -
           Rot::cross(V.template segment<sd>(at)) * V.template segment<rd>(at + sd);
  };
  const Vector at_A = inertial(0), at_B = inertial(dim);
  g.template segment<sd>(0) = m * (2 * at_A + R * at_B);
  g.template segment<sd>(dim) = m * (2 * at_B + R.transpose() * at_A);
  const Angular<G> ra = a.template segment<rd>(sd), rb = a.template segment<rd>(dim + sd);
  g.template segment<rd>(sd) = J * (2 * ra + rb);
  g.template segment<rd>(dim + sd) = J * (2 * rb + ra);
  if constexpr (rd == 3)
    for (int at : {sd, dim + sd}) {
      const Angular<G> w = V.template segment<rd>(at);
      g.template segment<rd>(at) += 3 * w.cross(J * w);
    }
}

template <FrameGroup G>
auto ReissnerElement<G>::mass(const G& A, const G& B) const -> PairMatrix {
  const Rotation R = A.R.transpose() * B.R;
  PairMatrix M = PairMatrix::Zero();
  const double m = M_s_(0, 0) * L_ / 6;
  const AngularMatrix<G> J = M_s_.template bottomRightCorner<rd, rd>() * (L_ / 6);
  M.template block<sd, sd>(0, 0) = M.template block<sd, sd>(dim, dim) =
      2 * m * Rotation::Identity();
  M.template block<sd, sd>(0, dim) = m * R;
  M.template block<sd, sd>(dim, 0) = m * R.transpose();
  for (int i : {sd, dim + sd})
    for (int j : {sd, dim + sd}) M.template block<rd, rd>(i, j) = (i == j ? 2 : 1) * J;
  return M;
}

template <FrameGroup G>
auto ReissnerElement<G>::gyroscopic_tangent(const G& A, const G& B, const double* v) const
    -> PairMatrix {
  using Rot = RotationOf<G>;
  const Eigen::Map<const Pair> V(v);
  const AngularMatrix<G> J = M_s_.template bottomRightCorner<rd, rd>() * (L_ / 2);
  PairMatrix convective = PairMatrix::Zero(), c = PairMatrix::Zero();
  for (int at : {0, dim}) {
    const Angular<G> w = V.template segment<rd>(at + sd);
    convective.template block<sd, rd>(at, at + sd) = -Rot::cross(V.template segment<sd>(at));
    for (int j = 0; j < sd; ++j)  // w x u is linear in u
      convective.template block<sd, 1>(at, at + j) = -Rot::cross(Vector::Unit(j)) * w;
    if constexpr (rd == 3)
      c.template block<rd, rd>(at + sd, at + sd) = hat(w) * J - hat(Angular<G>(J * w));
  }
  return c + mass(A, B) * convective;
}

/// d(R b) = (R b) x w_A - R (b x w_B) of R = R_A^T R_B, for the accelerations b in the axes of B.
template <FrameGroup G>
auto ReissnerElement<G>::inertia_stiffness(const G& A, const G& B, const double* v, const Pair& a,
                                           const Vector& gravity) const -> PairMatrix {
  using Rot = RotationOf<G>;
  const Eigen::Map<const Pair> V(v);
  const double m = M_s_(0, 0) * L_ / 6;
  const Rotation R = A.R.transpose() * B.R;
  const auto inertial = [&](int at) -> Vector {
    return a.template segment<sd>(at) -
           Rot::cross(V.template segment<sd>(at)) * V.template segment<rd>(at + sd);
  };
  const Vector at_A = inertial(0), at_B = inertial(dim);
  PairMatrix D = PairMatrix::Zero();
  D.template block<dim, dim>(0, 0) = liesl::weight_tangent<G>(A, gravity);
  D.template block<dim, dim>(dim, dim) = liesl::weight_tangent<G>(B, gravity);
  PairMatrix k = mass(A, B) * D;
  k.template block<sd, rd>(0, sd) += m * Rot::cross(R * at_B);
  k.template block<sd, rd>(0, dim + sd) -= m * R * Rot::cross(at_B);
  k.template block<sd, rd>(dim, dim + sd) += m * Rot::cross(R.transpose() * at_A);
  k.template block<sd, rd>(dim, sd) -= m * R.transpose() * Rot::cross(at_A);
  return k;
}

template <FrameGroup G>
double ReissnerElement<G>::weight_potential(const G& A, const G& B, const Vector& a) const {
  return -0.5 * L_ * M_s_(0, 0) * a.dot(A.x + B.x);
}

template <FrameGroup G>
auto ReissnerElement<G>::weight_gradient(const G& A, const G& B, const Vector& a) const -> Pair {
  Pair g = Pair::Zero();
  g.template head<sd>() = -0.5 * L_ * M_s_(0, 0) * (A.R.transpose() * a);
  g.template segment<sd>(dim) = -0.5 * L_ * M_s_(0, 0) * (B.R.transpose() * a);
  return g;
}

template <FrameGroup G>
auto ReissnerElement<G>::kinetic_gradient(const G& A, const G& B, const double* v) const -> Pair {
  using Rot = RotationOf<G>;
  const Eigen::Map<const Pair> V(v);
  const double m = M_s_(0, 0) * L_ / 6;
  const Rotation R = A.R.transpose() * B.R;
  const Vector u_A = V.template head<sd>(), u_B = V.template segment<sd>(dim);
  // a . (w x b) = -a . cross(b) w
  Pair g = Pair::Zero();
  g.template segment<rd>(sd) = m * Rot::cross(Vector(R * u_B)).transpose() * u_A;
  g.template segment<rd>(dim + sd) = -m * Rot::cross(u_B).transpose() * Vector(R.transpose() * u_A);
  return g;
}

template <FrameGroup G>
auto ReissnerElement<G>::constant_tangent() const -> PairMatrix {
  const Gradient p = P(d0_);
  return p.transpose() * K_ * p / L_;
}

template <FrameGroup G>
auto ReissnerElement<G>::integral(const Matrix& M) const -> PairMatrix {
  PairMatrix m = PairMatrix::Zero();
  m.template block<dim, dim>(0, 0) = m.template block<dim, dim>(dim, dim) = 0.5 * L_ * M;
  return m;
}

template class ReissnerElement<SE2>;
template class ReissnerElement<SE3>;

}  // namespace liesl
