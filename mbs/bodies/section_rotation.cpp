#include "mbs/bodies/section_rotation.hpp"

namespace liesl {
namespace {

/// A vector and its derivative by the increments of both nodes.
template <int n, int K>
struct Jet {
  Eigen::Matrix<double, n, 1> v;
  Eigen::Matrix<double, n, K> d;
};

template <int n, int K>
Jet<n, K> operator+(const Jet<n, K>& a, const Jet<n, K>& b) {
  return {a.v + b.v, a.d + b.d};
}
template <int n, int K>
Jet<n, K> operator-(const Jet<n, K>& a, const Jet<n, K>& b) {
  return {a.v - b.v, a.d - b.d};
}
template <int n, int K>
Jet<n, K> operator*(double s, const Jet<n, K>& a) {
  return {s * a.v, s * a.d};
}
template <int m, int n, int K>
Jet<m, K> times(const Eigen::Matrix<double, m, n>& M, const Jet<n, K>& a) {
  return {M.lazyProduct(a.v), M.lazyProduct(a.d)};
}
template <int m, int n>
Eigen::Matrix<double, m, 1> times(const Eigen::Matrix<double, m, n>& M,
                                  const Eigen::Matrix<double, n, 1>& a) {
  return M.lazyProduct(a);
}

/// A vector that does not change, and one that is among the increments.
template <int n, int K, class V>
Jet<n, K> fixed(const V& v) {
  return {v, Eigen::Matrix<double, n, K>::Zero()};
}
template <int n, int K, class V>
Jet<n, K> free_at(int column, const V& v) {
  Jet<n, K> out = fixed<n, K>(v);
  out.d.template middleCols<n>(column).setIdentity();
  return out;
}

}  // namespace

template <FrameGroup G>
struct SectionRotation<G>::Values {
  using Space = Vector;
  using Angular = Eigen::Matrix<double, rd, 1>;
  using Frame = Rotation;

  static Space turned(const Frame& S, const Space& z) { return S.lazyProduct(z); }
  /// w x z
  static Space cross(const Angular& w, const Space& z) {
    return -RotationOf<G>::cross(z).lazyProduct(w);
  }
  /// a x b, about the axes of rotation
  static Angular moment(const Space& a, const Space& b) {
    return RotationOf<G>::cross(b).transpose().lazyProduct(a);
  }
};

template <FrameGroup G>
struct SectionRotation<G>::Jets {
  using Space = Jet<sd, 2 * dim>;
  using Angular = Jet<rd, 2 * dim>;
  /// S, and where h_me and h_other are among the increments (-1: S does not turn).
  struct Frame {
    Rotation S;
    int me = -1, other = -1;
  };

  static Space turned(const Frame& f, const Space& z) {
    Space out = times(f.S, z);
    if (f.me < 0) return out;
    out.d.template middleCols<rd>(f.me + sd) += RotationOf<G>::cross(out.v);
    out.d.template middleCols<rd>(f.other + sd) -= f.S.lazyProduct(RotationOf<G>::cross(z.v));
    return out;
  }
  static Space cross(const Angular& w, const Space& z) {
    Rotation spin;
    if constexpr (rd == 1)
      spin << 0, -w.v[0], w.v[0], 0;
    else
      spin = hat(w.v);
    Space out{Values::cross(w.v, z.v), spin.lazyProduct(z.d)};
    out.d -= RotationOf<G>::cross(z.v).lazyProduct(w.d);
    return out;
  }
  static Angular moment(const Space& a, const Space& b) {
    Angular out{Values::moment(a.v, b.v), RotationOf<G>::cross(b.v).transpose().lazyProduct(a.d)};
    out.d -= RotationOf<G>::cross(a.v).transpose().lazyProduct(b.d);
    return out;
  }
};

/// The motion of a node as the other one sees it: S turns what is in the axes of the other one.
template <FrameGroup G>
template <class Q>
struct SectionRotation<G>::Node {
  double sign;  ///< of x in r
  typename Q::Frame S;
  typename Q::Space rho, u, udot;
  typename Q::Angular w, wdot;
};

template <FrameGroup G>
template <class Q>
struct SectionRotation<G>::Force {
  typename Q::Space f;
  typename Q::Angular m;
};

template <FrameGroup G>
SectionRotation<G>::SectionRotation(double L, const Inertia& Ja, const Inertia& Jc, const Vector& D,
                                    const Vector& c)
    : L_(L), Ja_(Ja), Jc_(Jc), c_(c), X_(turning()), E_(D.asDiagonal() * X_) {}

template <FrameGroup G>
auto SectionRotation<G>::places(const G& A, const G& B) const -> std::array<Place, 2> {
  const Vector r = (B.x - A.x) / L_ - 0.5 * (A.R.col(0) + B.R.col(0));
  const Rotation S = A.R.transpose().lazyProduct(B.R);
  return {Place{0, dim, -1, S, A.R.transpose().lazyProduct(r)},
          Place{dim, 0, 1, S.transpose(), B.R.transpose().lazyProduct(r)}};
}

/// rho' = R^T r' - w x rho.
template <FrameGroup G>
template <class Q>
typename Q::Space SectionRotation<G>::rate(const Node<Q>& me, const Node<Q>& other) const {
  const typename Q::Space nodes = (other.sign / L_) * other.u - 0.5 * times(X_, other.w),
                          here = (me.sign / L_) * me.u - 0.5 * times(X_, me.w);
  return Q::turned(me.S, nodes) + here - Q::cross(me.w, me.rho);
}

/// rho'' = R^T r'' - 2 w x rho' - w' x rho - w x (w x rho).
template <FrameGroup G>
template <class Q>
typename Q::Space SectionRotation<G>::second_rate(const Node<Q>& me, const Node<Q>& other,
                                                  const typename Q::Space& rate) const {
  const auto in_own_axes = [this](const Node<Q>& n) -> typename Q::Space {
    const typename Q::Space moving = (n.sign / L_) * n.u - 0.5 * times(X_, n.w);
    const typename Q::Space faster = (n.sign / L_) * n.udot - 0.5 * times(X_, n.wdot);
    return faster + Q::cross(n.w, moving);
  };
  const typename Q::Space turning = 2.0 * rate + Q::cross(me.w, me.rho);
  return Q::turned(me.S, in_own_axes(other)) + in_own_axes(me) - Q::cross(me.w, turning) -
         Q::cross(me.wdot, me.rho);
}

/// d/dt (dT/dw) + w x dT/dw - dT/dh of the rotation of the nodes themselves.
template <FrameGroup G>
template <class Q>
typename Q::Angular SectionRotation<G>::momentum_rate(const Node<Q>& me,
                                                      const Node<Q>& other) const {
  using Angular = typename Q::Angular;
  const Angular own = times(Ja_, me.wdot);
  if constexpr (rd == 1) {
    return own + times(Jc_, other.wdot);
  } else {
    const Angular w = Q::turned(me.S, other.w), wdot = Q::turned(me.S, other.wdot),
                  Jw = Q::turned(me.S, times(Jc_, other.w)),
                  Jwdot = Q::turned(me.S, times(Jc_, other.wdot)),
                  gyro = Q::turned(me.S, Q::cross(other.w, times(Jc_, other.w)));
    const Angular moved = times(Jc_, wdot) + Jwdot + gyro - times(Jc_, Q::cross(me.w, w)) +
                          Q::cross(me.w, times(Jc_, w)) - Q::cross(me.w, Jw) -
                          Q::cross(times(Jc_, me.w), w);
    return own + Q::cross(me.w, times(Ja_, me.w)) + 0.5 * moved;
  }
}

/// (d rho')^T (c rho''/2 + L E w'/2) and (L/2) (E^T rho'' + w x E^T rho').
template <FrameGroup G>
template <class Q>
void SectionRotation<G>::add_force_of(const Node<Q>& me, const Node<Q>& other, Force<Q>& on_me,
                                      Force<Q>& on_other) const {
  using Space = typename Q::Space;
  using Angular = typename Q::Angular;
  const Eigen::Matrix<double, rd, sd> Et = E_.transpose(), Xt = X_.transpose();
  const Rotation c = c_.asDiagonal();
  const Space dot = rate<Q>(me, other), ddot = second_rate<Q>(me, other, dot);
  const Space p = 0.5 * times(c, ddot) + (L_ / 2) * times(E_, me.wdot);
  const Space on = Q::turned(other.S, p);
  on_me.f = on_me.f + (me.sign / L_) * p;
  on_me.m = on_me.m + Q::moment(p, me.rho) - 0.5 * times(Xt, p) + (L_ / 2) * times(Et, ddot) +
            momentum_rate<Q>(me, other);
  if constexpr (rd == 3) {
    const Angular turned = Q::cross(me.w, times(Et, dot));
    on_me.m = on_me.m + (L_ / 2) * turned;
  }
  on_other.f = on_other.f + (other.sign / L_) * on;
  on_other.m = on_other.m - 0.5 * times(Xt, on);
}

template <FrameGroup G>
void SectionRotation<G>::add_force(const G& A, const G& B, const double* v, const Pair& a,
                                   Pair& g) const {
  using Q = Values;
  const Eigen::Map<const Pair> rates(v);
  const auto node = [&](const Place& me) {
    return Node<Q>{me.sign,
                   me.S,
                   me.rho,
                   rates.template segment<sd>(me.at),
                   a.template segment<sd>(me.at),
                   rates.template segment<rd>(me.at + sd),
                   a.template segment<rd>(me.at + sd)};
  };
  const auto at = places(A, B);
  const Node<Q> n_A = node(at[0]), n_B = node(at[1]);
  Force<Q> on_A{g.template head<sd>(), g.template segment<rd>(sd)},
      on_B{g.template segment<sd>(dim), g.template tail<rd>()};
  add_force_of<Q>(n_A, n_B, on_A, on_B);
  add_force_of<Q>(n_B, n_A, on_B, on_A);
  g << on_A.f, on_A.m, on_B.f, on_B.m;
}

/// P: d rho = P [h_A; h_B], rho' = P [v_A; v_B].
template <FrameGroup G>
auto SectionRotation<G>::gradient(const Place& me) const -> Gradient {
  Gradient P;
  P.template middleCols<sd>(me.at) = Rotation::Identity() * (me.sign / L_);
  P.template middleCols<rd>(me.at + sd) = RotationOf<G>::cross(me.rho) - 0.5 * X_;
  P.template middleCols<sd>(me.other) = me.S * (-me.sign / L_);
  P.template middleCols<rd>(me.other + sd) = -0.5 * me.S.lazyProduct(X_);
  return P;
}

template <FrameGroup G>
void SectionRotation<G>::add_mass(const G& A, const G& B, PairMatrix& M) const {
  for (const Place& me : places(A, B)) {
    const Gradient P = gradient(me), cP = (0.5 * c_).asDiagonal() * P;
    M += P.transpose().lazyProduct(cP);
    const Eigen::Matrix<double, rd, 2 * dim> EP = (L_ / 2) * E_.transpose().lazyProduct(P);
    M.template middleRows<rd>(me.at + sd) += EP;
    M.template middleCols<rd>(me.at + sd) += EP.transpose();
    M.template block<rd, rd>(me.at + sd, me.at + sd) += Ja_;
    auto coupling = M.template block<rd, rd>(me.at + sd, me.other + sd);
    if constexpr (rd == 1)
      coupling += Jc_;
    else
      coupling += 0.5 * (Jc_.lazyProduct(me.S) + me.S.lazyProduct(Jc_));
  }
}

template <FrameGroup G>
auto SectionRotation<G>::by_rates(const Place& me, const double* v) const -> Node<Jets> {
  constexpr int K = 2 * dim;
  const Eigen::Map<const Pair> rates(v);
  return {me.sign,
          {me.S},
          fixed<sd, K>(me.rho),
          free_at<sd, K>(me.at, rates.template segment<sd>(me.at)),
          fixed<sd, K>(Vector::Zero()),
          free_at<rd, K>(me.at + sd, rates.template segment<rd>(me.at + sd)),
          fixed<rd, K>(Eigen::Matrix<double, rd, 1>::Zero())};
}

template <FrameGroup G>
auto SectionRotation<G>::by_frames(const Place& me, const double* v, const Pair& a) const
    -> Node<Jets> {
  constexpr int K = 2 * dim;
  const Eigen::Map<const Pair> rates(v);
  return {me.sign,
          {me.S, me.at, me.other},
          {me.rho, gradient(me)},
          fixed<sd, K>(rates.template segment<sd>(me.at)),
          fixed<sd, K>(a.template segment<sd>(me.at)),
          fixed<rd, K>(rates.template segment<rd>(me.at + sd)),
          fixed<rd, K>(a.template segment<rd>(me.at + sd))};
}

template <FrameGroup G>
void SectionRotation<G>::add_derivative(const Node<Jets>& A, const Node<Jets>& B,
                                        PairMatrix& K) const {
  using Q = Jets;
  constexpr int n = 2 * dim;
  const Force<Q> none{fixed<sd, n>(Vector::Zero()),
                      fixed<rd, n>(Eigen::Matrix<double, rd, 1>::Zero())};
  Force<Q> on_A = none, on_B = none;
  add_force_of<Q>(A, B, on_A, on_B);
  add_force_of<Q>(B, A, on_B, on_A);
  K.template topRows<sd>() += on_A.f.d;
  K.template middleRows<rd>(sd) += on_A.m.d;
  K.template middleRows<sd>(dim) += on_B.f.d;
  K.template bottomRows<rd>() += on_B.m.d;
}

template <FrameGroup G>
void SectionRotation<G>::add_gyroscopic_tangent(const G& A, const G& B, const double* v,
                                                PairMatrix& C) const {
  const auto at = places(A, B);
  add_derivative(by_rates(at[0], v), by_rates(at[1], v), C);
}

template <FrameGroup G>
void SectionRotation<G>::add_stiffness(const G& A, const G& B, const double* v, const Pair& a,
                                       PairMatrix& K) const {
  const auto at = places(A, B);
  add_derivative(by_frames(at[0], v, a), by_frames(at[1], v, a), K);
}

/// (L E w + c rho')/2 . d rho' of each node, and what S does to J_c.
template <FrameGroup G>
void SectionRotation<G>::add_kinetic_gradient(const G& A, const G& B, const double* v,
                                              Pair& g) const {
  using Q = Jets;
  const auto at = places(A, B);
  const Node<Q> nodes[] = {by_frames(at[0], v, Pair::Zero()), by_frames(at[1], v, Pair::Zero())};
  for (int k = 0; k < 2; ++k) {
    const Node<Q>&me = nodes[k], &other = nodes[1 - k];
    const auto dot = rate<Q>(me, other);
    const Vector p = (L_ / 2) * (E_ * me.w.v) + 0.5 * c_.cwiseProduct(dot.v);
    g += dot.d.transpose() * p;
    if constexpr (rd == 3)  // w_A . (J_c S + S J_c) w_B/2, a half by each node
      g += 0.5 * Q::turned(me.S, times(Jc_, other.w)).d.transpose() * me.w.v;
  }
}

template class SectionRotation<SE2>;
template class SectionRotation<SE3>;

}  // namespace liesl
