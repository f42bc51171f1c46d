#include "mbs/bodies/condensed_law.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace liesl {
namespace {

/// Slope of the curvature of the axis, from d0_u = L e1 + (L^3/12) e1 x kappa_1.
template <class G>
typename G::Tangent slope_of_axis(const typename G::Tangent& d0) {
  typename G::Tangent a = G::Tangent::Zero();
  const double scale = 12 / (d0[0] * d0[0] * d0[0]);
  a[G::dim - 1] = -scale * d0[1];
  if constexpr (G::space_dim == 3) a[4] = scale * d0[2];
  return a;
}

}  // namespace

template <FrameGroup G>
CondensedLaw<G>::CondensedLaw(const Tangent& d0, const Matrix& K)
    : d0_(d0), L_(d0[0]), K_(K), Kinv_(K.inverse()) {
  W_ = Matrix::Identity() - (L_ * L_ / 12) * G::ad(slope_of_axis<G>(d0));
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  uncoupled_ = K.template topRightCorner<sd, rd>().isZero(0);
  varied_ = W_ * Kinv_ * W_.transpose();
  C0_ = stiffness(d0_);
}

template <FrameGroup G>
auto CondensedLaw<G>::flexibility(const Tangent& d) const -> Matrix {
  const Matrix a = G::ad(d);
  const Matrix half = a.lazyProduct(Kinv_);
  return varied_ + half.lazyProduct(a.transpose()) / 12;
}

/// In space by 3 x 3 blocks: [P Q; Q^T R]^-1 with the Schur complement P - Q R^-1 Q^T.
template <FrameGroup G>
auto CondensedLaw<G>::stiffness(const Tangent& d) const -> Matrix {
  const Matrix F = flexibility(d);
  if constexpr (G::space_dim == 2) {
    return F.inverse();
  } else {
    using Block = typename G::Rotation;
    const Block Q = F.template topRightCorner<3, 3>(), R = F.template bottomRightCorner<3, 3>(),
                Ri = R.inverse(), QRi = Q.lazyProduct(Ri);
    const Block schur = F.template topLeftCorner<3, 3>() - QRi.lazyProduct(Q.transpose());
    const Block S = schur.inverse(), T = -S.lazyProduct(QRi);
    Matrix C;
    C << S, T, T.transpose(), Ri - QRi.transpose().lazyProduct(T);
    return C;
  }
}

/// F n = e. In a plane ad has no last row; in space ad = [w~ u~; 0 w~], and where K^-1 has no
/// blocks that couple them, ad K^-1 ad^T = [w~ a w~^T + u~ b u~^T, u~ b w~^T; ., w~ b w~^T].
template <FrameGroup G>
auto CondensedLaw<G>::stress(const Tangent& d, const Tangent& e) const -> Tangent {
  if constexpr (G::space_dim == 2) {
    const Tangent y(0, -d[2], d[1]), x(d[2], 0, -d[0]);  // rows of ad
    const Tangent fy = Kinv_.lazyProduct(y) / 12, fx = Kinv_.lazyProduct(x) / 12;
    const Scalar a = varied_(0, 0) + y.dot(fy), b = varied_(0, 1) + y.dot(fx), c = varied_(0, 2),
                 p = varied_(1, 1) + x.dot(fx), q = varied_(1, 2), r = varied_(2, 2);
    const Scalar A = p * r - q * q, B = c * q - b * r, C = b * q - c * p;  // cofactors
    const Tangent n(A * e[0] + B * e[1] + C * e[2],
                    B * e[0] + (a * r - c * c) * e[1] + (b * c - a * q) * e[2],
                    C * e[0] + (b * c - a * q) * e[1] + (a * p - b * b) * e[2]);
    return n / (a * A + b * B + c * C);
  } else {
    if constexpr (std::is_same_v<Scalar, double>)
      if (!uncoupled_) return flexibility(d).llt().solve(e);
    using Block = typename G::Rotation;
    using Vector = typename G::Vector;
    const Block w = hat(Vector(d.template tail<3>())), u = hat(Vector(d.template head<3>()));
    const Block b = Kinv_.template bottomRightCorner<3, 3>() / 12;
    const Block wa = w.lazyProduct(Kinv_.template topLeftCorner<3, 3>() / 12);
    const Block ub = u.lazyProduct(b), wb = w.lazyProduct(b);
    Block P = varied_.template topLeftCorner<3, 3>(), Q = varied_.template topRightCorner<3, 3>(),
          R = varied_.template bottomRightCorner<3, 3>();
    P -= wa.lazyProduct(w);  // w~^T = -w~
    P -= ub.lazyProduct(u);
    Q -= ub.lazyProduct(w);
    R -= wb.lazyProduct(w);
    const Block Ri = R.inverse(), QRi = Q.lazyProduct(Ri);
    const Block schur = P - QRi.lazyProduct(Q.transpose());
    const Vector m = e.template tail<3>(), f = e.template head<3>() - QRi.lazyProduct(m);
    Tangent n;
    const Vector n_u = schur.inverse().lazyProduct(f);
    n << n_u, Ri.lazyProduct(m) - QRi.transpose().lazyProduct(n_u);
    return n;
  }
}

template <FrameGroup G>
auto CondensedLaw<G>::conjugate(const Tangent& d, const Tangent& n) const -> Tangent {
  const Tangent z = -Kinv_.lazyProduct(BeamElement<G>::minus_ad_transpose(d, n));
  return n - (L_ / 12) * BeamElement<G>::minus_ad_transpose(z, n);
}

template <FrameGroup G>
auto CondensedLaw<G>::force_operator(const Tangent& n) -> Matrix {
  Matrix N = Matrix::Zero();
  if constexpr (G::space_dim == 2) {
    N(0, 2) = n[1];
    N(1, 2) = -n[0];
    N(2, 0) = -n[1];
    N(2, 1) = n[0];
  } else {
    using Vector = typename G::Vector;
    const typename G::Rotation f = hat(Vector(n.template head<3>()));
    N.template topRightCorner<3, 3>() = f;
    N.template bottomLeftCorner<3, 3>() = f;
    N.template bottomRightCorner<3, 3>() = hat(Vector(n.template tail<3>()));
  }
  return N;
}

template <FrameGroup G>
auto CondensedLaw<G>::Y(const Tangent& d, const Tangent& n) const -> Matrix {
  const Matrix a = G::ad(d), KN = Kinv_.lazyProduct(force_operator(n));
  const Tangent z = Kinv_.lazyProduct(-BeamElement<G>::minus_ad_transpose(d, n));
  return Matrix::Identity() + (L_ / 12) * (G::ad(z) - a.lazyProduct(KN));
}

template <FrameGroup G>
auto CondensedLaw<G>::hessian(const Tangent& d, const Tangent& n) const -> Matrix {
  const Matrix y = Y(d, n), N = force_operator(n);
  const Matrix c = stiffness(d).lazyProduct(y), KN = Kinv_.lazyProduct(N);
  return y.transpose().lazyProduct(c) / L_ - (L_ / 12) * N.transpose().lazyProduct(KN);
}

template <FrameGroup G>
void CondensedLaw<G>::force(const G& A, const G& B, const Scalar* v, double damping,
                            Pair& g) const {
  BeamElement<G>::transmit(
      A, B,
      [&](const Tangent& d, const Matrix& Ti) -> Tangent {
        Tangent e = (d - d0_) / L_;
        if (damping > 0) e += (damping / L_) * BeamElement<G>::relative_rate(d, Ti, v);
        return conjugate(d, stress(d, e));
      },
      g);
}

/// d and P(d), T^-1(-d) = T^-1(d) - ad(d).
template <FrameGroup G>
auto CondensedLaw<G>::relative_motion(const G& A, const G& B) -> RelativeMotion {
  Tangent d;
  Matrix Ti;
  G::log_and_Tinv(A.inverse() * B, d, Ti);
  RelativeMotion out{d, {}};
  out.P << G::ad(d) - Ti, Ti;
  return out;
}

template <FrameGroup G>
auto CondensedLaw<G>::damping_tangent(const G& A, const G& B, const Scalar* v, double damping) const
    -> PairMatrix {
  const auto [d, p] = relative_motion(A, B);
  const Tangent rate = p.lazyProduct(Eigen::Map<const Pair>(v)) / L_;
  const Tangent n = stress(d, (d - d0_) / L_ + damping * rate);
  const Matrix C = Y(d, n).transpose().lazyProduct(stiffness(d));
  const Gradient n_by_v = C.lazyProduct(p) * (damping / L_);
  return p.transpose().lazyProduct(n_by_v);
}

template <FrameGroup G>
auto CondensedLaw<G>::tangent(const G& A, const G& B, const Tangent& elastic, const Scalar* v,
                              double damping) const -> PairMatrix {
  const auto [d, p] = relative_motion(A, B);
  Tangent n = elastic;
  if (damping > 0) n += stress(d, p.lazyProduct(Eigen::Map<const Pair>(v)) * (damping / L_));
  Matrix H = hessian(d, n);
  if (damping > 0) {
    const Matrix C = Y(d, n).transpose().lazyProduct(stiffness(d));
    H += C.lazyProduct(BeamElement<G>::dP(d, v)) * (damping / L_);
  }
  const Tangent force = conjugate(d, n);
  const Gradient Hp = H.lazyProduct(p);
  PairMatrix k = p.transpose().lazyProduct(Hp);
  k.template topRows<G::dim>() += G::dTinvT(-d, force).lazyProduct(p);
  k.template bottomRows<G::dim>() += G::dTinvT(d, force).lazyProduct(p);
  return k;
}

/// K^-1' = -K^-1 K' K^-1 = -D.
template <FrameGroup G>
auto CondensedLaw<G>::minus_flexibility_by(const Tangent& d, const Tangent& n,
                                           const Matrix& dK) const -> Tangent {
  const Matrix a = G::ad(d), D = Kinv_ * dK * Kinv_;
  return W_ * (D * (W_.transpose() * n)) + a * (D * (a.transpose() * n)) / 12;
}

template <FrameGroup G>
auto CondensedLaw<G>::stress_by(const Tangent& d, const Tangent& n, const Matrix& dK) const
    -> Tangent {
  return stress(d, minus_flexibility_by(d, n, dK));
}

template <FrameGroup G>
auto CondensedLaw<G>::conjugate_by(const Tangent& d, const Tangent& n, const Tangent& dn,
                                   const Matrix& dK) const -> Tangent {
  const Matrix a = G::ad(d);
  const Tangent z = Kinv_ * (a.transpose() * n), dz = Kinv_ * (a.transpose() * dn - dK * z);
  return dn + (L_ / 12) * (G::ad(dz).transpose() * n + G::ad(z).transpose() * dn);
}

template <FrameGroup G>
auto CondensedLaw<G>::of_flexibility(const Matrix& X) const -> Matrix {
  const Matrix a = G::ad(d0_);
  return W_ * X * W_.transpose() + a * X * a.transpose() / 12;
}

template <FrameGroup G>
auto CondensedLaw<G>::stiffness_at_rest_by(const Matrix& dK) const -> Matrix {
  return C0_ * of_flexibility(Kinv_ * dK * Kinv_) * C0_;
}

/// F_p C F_q + F_q C F_p - F_pq between two C.
template <FrameGroup G>
auto CondensedLaw<G>::stiffness_at_rest_second(const Matrix& K_p, const Matrix& K_q,
                                               const Matrix& K_pq) const -> Matrix {
  const Matrix F_p = of_flexibility(Kinv_ * K_p * Kinv_), F_q = of_flexibility(Kinv_ * K_q * Kinv_);
  const Matrix X = Kinv_ * (K_p * Kinv_ * K_q + K_q * Kinv_ * K_p - K_pq) * Kinv_;
  return C0_ * (F_p * C0_ * F_q + F_q * C0_ * F_p - of_flexibility(X)) * C0_;
}

template class CondensedLaw<SE2>;
template class CondensedLaw<SE3>;
template auto CondensedLaw<SE2Of<Lanes>>::stress(const Tangent&, const Tangent&) const -> Tangent;
template void CondensedLaw<SE2Of<Lanes>>::force(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                const Lanes*, double, Pair&) const;
template auto CondensedLaw<SE2Of<Lanes>>::damping_tangent(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                          const Lanes*, double) const -> PairMatrix;
template auto CondensedLaw<SE2Of<Lanes>>::tangent(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                  const Tangent&, const Lanes*, double) const
    -> PairMatrix;
template auto CondensedLaw<SE3Of<Lanes>>::stress(const Tangent&, const Tangent&) const -> Tangent;
template void CondensedLaw<SE3Of<Lanes>>::force(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                const Lanes*, double, Pair&) const;
template auto CondensedLaw<SE3Of<Lanes>>::damping_tangent(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                          const Lanes*, double) const -> PairMatrix;
template auto CondensedLaw<SE3Of<Lanes>>::tangent(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                  const Tangent&, const Lanes*, double) const
    -> PairMatrix;

}  // namespace liesl
