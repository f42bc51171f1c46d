#include "mbs/bodies/condensed_law.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace liesl {

/// From d0_u = L e1 + (L^3/12) e1 x kappa_1.
template <FrameGroup G>
auto CondensedLaw<G>::slope_of_axis() const -> Tangent {
  Tangent a = Tangent::Zero();
  const Scalar scale = 12 / (L_ * L_ * L_);
  a[G::dim - 1] = -scale * d0_[1];
  if constexpr (G::space_dim == 3) a[4] = scale * d0_[2];
  return a;
}

template <FrameGroup G>
CondensedLaw<G>::CondensedLaw(const Tangent& d0, const Matrix& K)
    : d0_(d0), L_(d0[0]), K_(K), Kinv_(K.inverse()) {
  W_ = Matrix::Identity() - (L_ * L_ / 12) * G::ad(slope_of_axis());
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
  return n - (L_ / 12) * BeamElement<G>::minus_ad_transpose(slope(d, n), n);
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
auto CondensedLaw<G>::Y(const Tangent& d, const Tangent& n, const Tangent& z) const -> Matrix {
  const Matrix a = G::ad(d), KN = Kinv_.lazyProduct(force_operator(n));
  return Matrix::Identity() + (L_ / 12) * (G::ad(z) - a.lazyProduct(KN));
}

template <FrameGroup G>
auto CondensedLaw<G>::hessian(const Tangent& d, const Tangent& n, const Tangent& z) const
    -> Matrix {
  const Matrix y = Y(d, n, z), N = force_operator(n);
  const Matrix c = stiffness(d).lazyProduct(y), KN = Kinv_.lazyProduct(N);
  return y.transpose().lazyProduct(c) / L_ - (L_ / 12) * N.transpose().lazyProduct(KN);
}

template <FrameGroup G>
auto CondensedLaw<G>::viscous(const Tangent& d, const Tangent& n, const Tangent& r) const
    -> Tangent {
  const Matrix y = Y(d, n);
  const Tangent rate = stress(d, y.lazyProduct(r)) / L_;
  return y.transpose().lazyProduct(rate);
}

/// Of Y^T m = L (F dn/dd)^T m, m = dn/dt: with the second derivative of n by d, which follows from
/// F n = (d - d0)/L,
///   L d2(m . n)/dd2 = -(L/12)(M^T K^-1 N + N^T K^-1 M) + n_d^T (Y_m - I) + (Y_m - I)^T n_d,
/// M = N(m), Y_m = Y(d, m), n_d = dn/dd, and
///   -n_d^T (L/12) [(ad(r) K^-1 N - ad(K^-1 ad(r)^T n)) + (ad(r) K^-1 ad(d)^T + its transpose)
///   n_d].
template <FrameGroup G>
auto CondensedLaw<G>::viscous_by_d(const Tangent& d, const Tangent& n, const Tangent& r) const
    -> Matrix {
  const Matrix a = G::ad(d), ar = G::ad(r), N = force_operator(n), KN = Kinv_.lazyProduct(N);
  const Matrix y = Y(d, n), n_d = stiffness(d).lazyProduct(y) / L_;
  const Tangent m = n_d.lazyProduct(r), zr = slope(r, n);
  const Matrix turned = Y(d, m) - Matrix::Identity();
  const Matrix once = force_operator(m).transpose().lazyProduct(KN),
               twice = n_d.transpose().lazyProduct(turned),
               Ka = Kinv_.lazyProduct(Matrix(a.transpose())), crossed = ar.lazyProduct(Ka);
  Matrix inner = ar.lazyProduct(KN) - G::ad(zr);
  inner += Matrix(crossed + crossed.transpose()).lazyProduct(n_d);
  return twice + twice.transpose() - (L_ / 12) * (once + once.transpose()) -
         (L_ / 12) * n_d.transpose().lazyProduct(inner);
}

template <FrameGroup G>
void CondensedLaw<G>::force(const G& A, const G& B, const Scalar* v, double damping,
                            Pair& g) const {
  BeamElement<G>::transmit(
      A, B,
      [&](const Tangent& d, const Matrix& Ti) -> Tangent {
        const Tangent n = stress(d, (d - d0_) / L_);
        Tangent f = conjugate(d, n);
        if (damping > 0) f += damping * viscous(d, n, BeamElement<G>::relative_rate(d, Ti, v));
        return f;
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
auto CondensedLaw<G>::damping_tangent(const G& A, const G& B, const Scalar*, double damping) const
    -> PairMatrix {
  const auto [d, p] = relative_motion(A, B);
  const Gradient Yp = Y(d, stress(d, (d - d0_) / L_)).lazyProduct(p);
  const Gradient n_by_v = stiffness(d).lazyProduct(Yp) * (damping / L_);
  return Yp.transpose().lazyProduct(n_by_v);
}

template <FrameGroup G>
auto CondensedLaw<G>::tangent(const G& A, const G& B, const Tangent& n, const Scalar* v,
                              double damping) const -> PairMatrix {
  const auto [d, p] = relative_motion(A, B);
  Matrix H = hessian(d, n);
  Tangent force = conjugate(d, n);
  if (damping > 0) {
    const Tangent r = p.lazyProduct(Eigen::Map<const Pair>(v));
    const Matrix y = Y(d, n), c = stiffness(d).lazyProduct(y) / L_,
                 by_rate = y.transpose().lazyProduct(c);
    force += damping * by_rate.lazyProduct(r);
    H += damping * (viscous_by_d(d, n, r) + by_rate.lazyProduct(BeamElement<G>::dP(d, v)));
  }
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

/// Y' = (L/12) [ad(z') - ad(d) (K^-1 N)'], F m' = Y' r/L - F' m for m = dn/dt.
template <FrameGroup G>
auto CondensedLaw<G>::viscous_by(const Tangent& d, const Tangent& n, const Tangent& dn,
                                 const Tangent& r, const Matrix& dK) const -> Tangent {
  const Matrix a = G::ad(d), y = Y(d, n);
  const Tangent dz = Kinv_ * (a.transpose() * dn - dK * slope(d, n));
  const Matrix KN = Kinv_ * (force_operator(dn) - dK * Kinv_ * force_operator(n));
  const Matrix dy = (L_ / 12) * (G::ad(dz) - a * KN);
  const Tangent m = stress(d, y * r) / L_,
                dm = stress(d, dy * r / L_ + minus_flexibility_by(d, m, dK));
  return dy.transpose() * m + y.transpose() * dm;
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
