#include "mbs/bodies/section_rotation.hpp"

#include <type_traits>

namespace liesl {
namespace {

/// A vector and its derivative by the increments of both nodes.
template <class S, int n, int K>
struct Jet {
  Eigen::Matrix<S, n, 1> v;
  Eigen::Matrix<S, n, K> d;
};

template <class S, int n, int K>
Jet<S, n, K> operator+(const Jet<S, n, K>& a, const Jet<S, n, K>& b) {
  return {a.v + b.v, a.d + b.d};
}
template <class S, int n, int K>
Jet<S, n, K> operator-(const Jet<S, n, K>& a, const Jet<S, n, K>& b) {
  return {a.v - b.v, a.d - b.d};
}
template <class S, int n, int K>
Jet<S, n, K> operator+(const Jet<S, n, K>& a, const Eigen::Matrix<S, n, 1>& b) {
  return {a.v + b, a.d};
}
template <class S, int n, int K>
Jet<S, n, K> operator+(const Eigen::Matrix<S, n, 1>& a, const Jet<S, n, K>& b) {
  return b + a;
}
template <class S, int n, int K>
Jet<S, n, K> operator-(const Jet<S, n, K>& a, const Eigen::Matrix<S, n, 1>& b) {
  return {a.v - b, a.d};
}
template <class S, int n, int K>
Jet<S, n, K> operator*(const std::type_identity_t<S>& s, const Jet<S, n, K>& a) {
  return {s * a.v, s * a.d};
}
template <class S, int m, int n, int K>
Jet<S, m, K> times(const Eigen::Matrix<S, m, n>& M, const Jet<S, n, K>& a) {
  return {M.lazyProduct(a.v), M.lazyProduct(a.d)};
}
template <class S, int m, int n>
Eigen::Matrix<S, m, 1> times(const Eigen::Matrix<S, m, n>& M, const Eigen::Matrix<S, n, 1>& a) {
  return M.lazyProduct(a);
}

/// A vector that does not change, and one that is among the increments.
template <int n, int K, class V>
Jet<typename V::Scalar, n, K> fixed(const V& v) {
  return {v, Eigen::Matrix<typename V::Scalar, n, K>::Zero()};
}
template <int n, int K, class V>
Jet<typename V::Scalar, n, K> free_at(int column, const V& v) {
  Jet<typename V::Scalar, n, K> out = fixed<n, K>(v);
  out.d.template middleCols<n>(column).setIdentity();
  return out;
}

}  // namespace

template <FrameGroup G>
struct SectionRotation<G>::Values {
  using Space = Vector;
  using Angular = SectionRotation<G>::Angular;
  using Frame = Rotation;
  using Turned = Space;  ///< what frames turn
  using Rate = Space;
  using Spin = Angular;

  static Space turned(const Frame& S, const Space& z) { return S.lazyProduct(z); }
  /// X w
  static Space about(const Angular& w) {
    if constexpr (rd == 1)
      return {0, w[0]};
    else
      return {0, w[2], -w[1]};
  }
  /// X^T z
  static Angular onto(const Space& z) {
    if constexpr (rd == 1)
      return Angular(z[1]);
    else
      return {0, -z[2], z[1]};
  }
  static Space scaled(const Vector& by, const Space& z) { return by.cwiseProduct(z); }
  /// w x z
  static Space cross(const Angular& w, const Space& z) {
    if constexpr (rd == 1)
      return {-w[0] * z[1], w[0] * z[0]};
    else
      return w.cross(z);
  }
  /// a x b, about the axes of rotation
  static Angular moment(const Space& a, const Space& b) {
    if constexpr (rd == 1)
      return Angular(a[0] * b[1] - a[1] * b[0]);
    else
      return a.cross(b);
  }
};

/// Vectors that do not change have no derivative, and cost none.
template <FrameGroup G>
template <int K>
struct SectionRotation<G>::Jets {
  static constexpr int columns = K;
  using Space = Jet<Scalar, sd, K>;
  using Angular = Jet<Scalar, rd, K>;
  using StillAngular = SectionRotation<G>::Angular;

  static Vector about(const StillAngular& w) { return Values::about(w); }
  static Space about(const Angular& w) { return {Values::about(w.v), turning().lazyProduct(w.d)}; }
  static Angular onto(const Space& z) {
    return {Values::onto(z.v), turning().transpose().lazyProduct(z.d)};
  }
  static Space scaled(const Vector& by, const Space& z) {
    return {by.cwiseProduct(z.v), by.asDiagonal() * z.d};
  }
  static Vector cross(const StillAngular& w, const Vector& z) { return Values::cross(w, z); }
  static Space cross(const StillAngular& w, const Space& z) {
    return {Values::cross(w, z.v), spin(w).lazyProduct(z.d)};
  }
  static Space cross(const Angular& w, const Vector& z) {
    return {Values::cross(w.v, z), -RotationOf<G>::cross(z).lazyProduct(w.d)};
  }
  static Space cross(const Angular& w, const Space& z) {
    Space out = cross(w.v, z);
    out.d -= RotationOf<G>::cross(z.v).lazyProduct(w.d);
    return out;
  }
  static Angular moment(const Space& a, const Vector& b) {
    return {Values::moment(a.v, b), RotationOf<G>::cross(b).transpose().lazyProduct(a.d)};
  }
  static Angular moment(const Space& a, const Space& b) {
    Angular out = moment(a, b.v);
    out.d -= RotationOf<G>::cross(a.v).transpose().lazyProduct(b.d);
    return out;
  }

 private:
  /// w x
  static Rotation spin(const StillAngular& w) {
    Rotation W;
    if constexpr (rd == 1)
      W << 0, -w[0], w[0], 0;
    else
      W = hat(Vector(w));
    return W;
  }
};

template <FrameGroup G>
struct SectionRotation<G>::ByRates
    : SectionRotation<G>::template Jets<2 * SectionRotation<G>::dim> {
  using Base = Jets<2 * dim>;
  using typename Base::Space;
  using Frame = Rotation;
  using Turned = Vector;
  using Rate = Space;
  using Spin = typename Base::Angular;

  static Space turned(const Frame& S, const Space& z) { return times(S, z); }
};

template <FrameGroup G>
struct SectionRotation<G>::ByFrames
    : SectionRotation<G>::template Jets<SectionRotation<G>::relative> {
  using Base = Jets<relative>;
  using typename Base::Space;
  /// S, and where w_me and w_other are among [q; w_A; w_B].
  struct Frame {
    Rotation S;
    int me, other;
  };
  using Turned = Space;
  using Rate = Vector;
  using Spin = typename Base::StillAngular;

  static Space turned(const Frame& f, const Vector& z) {
    Space out = fixed<sd, relative>(Vector(f.S.lazyProduct(z)));
    add_turn(f, z, out);
    return out;
  }
  static Space turned(const Frame& f, const Space& z) {
    Space out = times(f.S, z);
    add_turn(f, z.v, out);
    return out;
  }

 private:
  static void add_turn(const Frame& f, const Vector& z, Space& out) {
    out.d.template middleCols<rd>(f.me) += RotationOf<G>::cross(out.v);
    out.d.template middleCols<rd>(f.other) -= f.S.lazyProduct(RotationOf<G>::cross(z));
  }
};

/// The motion of a node as the other one sees it, and what is its own in r' and
/// r'' in its axes.
template <FrameGroup G>
template <class Q>
struct SectionRotation<G>::Node {
  double sign;  ///< of x in r
  typename Q::Frame S;
  typename Q::Turned rho;
  typename Q::Rate r_dot, r_ddot;
  typename Q::Spin w;
  SectionRotation<G>::Angular wdot;
};

template <FrameGroup G>
template <class Q>
struct SectionRotation<G>::Motion {
  typename Q::Rate u;
  Vector udot;
  typename Q::Spin w;
  SectionRotation<G>::Angular wdot;
};

/// y of the section of a node, and with it what the other one needs: rates as
/// seen at rest.
template <FrameGroup G>
template <class Q>
struct SectionRotation<G>::Turn {
  typename Q::Angular y, ydot, Jy, y_rate, Jy_rate;
};

/// p' and p' + w x p - dT/dh, p = dT/dy.
template <FrameGroup G>
template <class Q>
struct SectionRotation<G>::Momentum {
  typename Q::Angular rate, moment;
};

template <FrameGroup G>
template <class Q>
struct SectionRotation<G>::Force {
  typename Q::Space f;
  typename Q::Angular m;
};

template <FrameGroup G>
SectionRotation<G>::SectionRotation(const Scalar& L, const Inertia& Ja, const Inertia& Jc,
                                    const Vector& beta)
    : L_(L), Ja_(Ja), Jc_(Jc), beta_(beta) {}

template <FrameGroup G>
auto SectionRotation<G>::places(const G& A, const G& B) const -> std::array<Place, 2> {
  const Vector r = (B.x - A.x) / L_ - 0.5 * (A.R.col(0) + B.R.col(0));
  const Rotation S = A.R.transpose().lazyProduct(B.R);
  return {Place{0, dim, -1, S, A.R.transpose().lazyProduct(r)},
          Place{dim, 0, 1, S.transpose(), B.R.transpose().lazyProduct(r)}};
}

template <FrameGroup G>
template <class Q>
auto SectionRotation<G>::node(const Place& me, typename Q::Frame S, typename Q::Turned rho,
                              const Motion<Q>& q) const -> Node<Q> {
  const typename Q::Rate dot = (me.sign / L_) * q.u - 0.5 * Q::about(q.w);
  const Vector ddot = (me.sign / L_) * q.udot - 0.5 * Values::about(q.wdot);
  return {me.sign, S, rho, dot, Q::cross(q.w, dot) + ddot, q.w, q.wdot};
}

/// rho' = R^T r' - w x rho.
template <FrameGroup G>
template <class Q>
typename Q::Space SectionRotation<G>::rate(const Node<Q>& me, const Node<Q>& other) const {
  return Q::turned(me.S, other.r_dot) + me.r_dot - Q::cross(me.w, me.rho);
}

/// By rho' and rho'' = R^T r'' - w x (2 rho' + w x rho) - w' x rho.
template <FrameGroup G>
template <class Q>
auto SectionRotation<G>::turn(const Node<Q>& me, const Node<Q>& other) const -> Turn<Q> {
  const typename Q::Space dot = rate<Q>(me, other), turning = 2.0 * dot + Q::cross(me.w, me.rho),
                          ddot = Q::turned(me.S, other.r_ddot) + me.r_ddot -
                                 Q::cross(me.w, turning) - Q::cross(me.wdot, me.rho);
  Turn<Q> t{
      me.w + Q::onto(Q::scaled(beta_, dot)), me.wdot + Q::onto(Q::scaled(beta_, ddot)), {}, {}, {}};
  t.Jy = times(Jc_, t.y);
  if constexpr (rd == 1) {
    t.y_rate = t.ydot;
    t.Jy_rate = times(Jc_, t.ydot);
  } else {
    t.y_rate = t.ydot + Q::cross(me.w, t.y);
    t.Jy_rate = times(Jc_, t.ydot) + Q::cross(me.w, t.Jy);
  }
  return t;
}

template <FrameGroup G>
template <class Q>
auto SectionRotation<G>::momentum(const Node<Q>& me, const Turn<Q>& my, const Turn<Q>& its) const
    -> Momentum<Q> {
  if constexpr (rd == 1) {
    const typename Q::Angular rate = times(Ja_, my.ydot) + its.Jy_rate;
    return {rate, rate};
  } else {
    const typename Q::Angular y = Q::turned(me.S, its.y), Jy = Q::turned(me.S, its.Jy),
                              y_rate = Q::turned(me.S, its.y_rate) - Q::cross(me.w, y),
                              Jy_rate = Q::turned(me.S, its.Jy_rate) - Q::cross(me.w, Jy),
                              p = times(Ja_, my.y) + 0.5 * (times(Jc_, y) + Jy);
    Momentum<Q> m;
    m.rate = times(Ja_, my.ydot) + 0.5 * (times(Jc_, y_rate) + Jy_rate);
    m.moment = m.rate + Q::cross(me.w, p) - 0.5 * (Q::cross(my.Jy, y) + Q::cross(my.y, Jy));
    return m;
  }
}

/// p' + w x p - dT/dh on w, and (d rho')^T B^T p'.
template <FrameGroup G>
template <class Q>
void SectionRotation<G>::add_force_of(const Node<Q>& me, const Turn<Q>& my, const Node<Q>& other,
                                      const Turn<Q>& its, Force<Q>& on_me,
                                      Force<Q>& on_other) const {
  const Momentum<Q> p = momentum<Q>(me, my, its);
  const typename Q::Space q = Q::scaled(beta_, Q::about(p.rate)), on = Q::turned(other.S, q);
  on_me.f = on_me.f + (me.sign / L_) * q;
  on_me.m = on_me.m + p.moment + Q::moment(q, me.rho) - 0.5 * Q::onto(q);
  on_other.f = on_other.f + (other.sign / L_) * on;
  on_other.m = on_other.m - 0.5 * Q::onto(on);
}

template <FrameGroup G>
template <class Q>
void SectionRotation<G>::add_force_of(const Node<Q>& A, const Node<Q>& B, Force<Q>& on_A,
                                      Force<Q>& on_B) const {
  const Turn<Q> y_A = turn<Q>(A, B), y_B = turn<Q>(B, A);
  add_force_of<Q>(A, y_A, B, y_B, on_A, on_B);
  add_force_of<Q>(B, y_B, A, y_A, on_B, on_A);
}

template <FrameGroup G>
auto SectionRotation<G>::motion(const Place& me, const Scalar* v, const Pair& a) -> Motion<Values> {
  const Eigen::Map<const Pair> rates(v);
  return {rates.template segment<sd>(me.at), a.template segment<sd>(me.at),
          rates.template segment<rd>(me.at + sd), a.template segment<rd>(me.at + sd)};
}

template <FrameGroup G>
void SectionRotation<G>::add_force(const G& A, const G& B, const Scalar* v, const Pair& a,
                                   Pair& g) const {
  using Q = Values;
  const auto at = places(A, B);
  const Node<Q> n_A = node<Q>(at[0], at[0].S, at[0].rho, motion(at[0], v, a)),
                n_B = node<Q>(at[1], at[1].S, at[1].rho, motion(at[1], v, a));
  Force<Q> on_A{g.template head<sd>(), g.template segment<rd>(sd)},
      on_B{g.template segment<sd>(dim), g.template tail<rd>()};
  add_force_of<Q>(n_A, n_B, on_A, on_B);
  g << on_A.f, on_A.m, on_B.f, on_B.m;
}

/// P: d rho = P [h_A; h_B], rho' = P [v_A; v_B].
template <FrameGroup G>
auto SectionRotation<G>::relative_gradient(const Place& me) const -> RelativeGradient {
  RelativeGradient P;
  if (me.at == 0)
    P.template leftCols<sd>().setIdentity();
  else
    P.template leftCols<sd>() = me.S;
  P.template middleCols<rd>(turn_of(me.at)) = RotationOf<G>::cross(me.rho) - 0.5 * turning();
  P.template middleCols<rd>(turn_of(me.other)) = -0.5 * me.S.lazyProduct(turning());
  return P;
}

template <FrameGroup G>
template <int n>
auto SectionRotation<G>::by_increments(const Eigen::Matrix<Scalar, n, relative>& D,
                                       const Rotation& S) const
    -> Eigen::Matrix<Scalar, n, 2 * dim> {
  const Eigen::Matrix<Scalar, n, sd> by_q = D.template leftCols<sd>() / L_;
  Eigen::Matrix<Scalar, n, 2 * dim> out;
  out << -by_q, D.template middleCols<rd>(turn_of(0)), by_q.lazyProduct(S),
      D.template middleCols<rd>(turn_of(dim));
  return out;
}

template <FrameGroup G>
auto SectionRotation<G>::gradient(const Place& me) const -> Gradient {
  Rotation S = me.S;
  if (me.at != 0) S.transposeInPlace();
  return by_increments<sd>(relative_gradient(me), S);
}

/// (J_c S + S J_c)/2, in a plane J_c.
template <FrameGroup G>
auto SectionRotation<G>::coupling(const Place& me) const -> Inertia {
  if constexpr (rd == 1)
    return Jc_;
  else
    return 0.5 * (Jc_.lazyProduct(me.S) + me.S.lazyProduct(Jc_));
}

/// y = Y [v_A; v_B].
template <FrameGroup G>
auto SectionRotation<G>::turn_gradient(const Place& me) const -> TurnGradient {
  const Turning B = beta_.asDiagonal() * turning();
  TurnGradient Y = B.transpose().lazyProduct(gradient(me));
  Y.template middleCols<rd>(me.at + sd) += Inertia::Identity();
  return Y;
}

template <FrameGroup G>
void SectionRotation<G>::add_mass(const G& A, const G& B, PairMatrix& M) const {
  const auto at = places(A, B);
  const TurnGradient Y_A = turn_gradient(at[0]), Y_B = turn_gradient(at[1]);
  const TurnGradient p_A = Ja_.lazyProduct(Y_A) + coupling(at[0]).lazyProduct(Y_B),
                     p_B = Ja_.lazyProduct(Y_B) + coupling(at[1]).lazyProduct(Y_A);
  M += Y_A.transpose().lazyProduct(p_A) + Y_B.transpose().lazyProduct(p_B);
}

template <FrameGroup G>
auto SectionRotation<G>::by_rates(const Place& me, const Scalar* v) const -> Node<ByRates> {
  constexpr int K = 2 * dim;
  const Motion<Values> q = motion(me, v, Pair::Zero());
  return node<ByRates>(
      me, me.S, me.rho,
      {free_at<sd, K>(me.at, q.u), q.udot, free_at<rd, K>(me.at + sd, q.w), q.wdot});
}

template <FrameGroup G>
auto SectionRotation<G>::by_frames(const Place& me, const Scalar* v, const Pair& a) const
    -> Node<ByFrames> {
  const Motion<Values> q = motion(me, v, a);
  return node<ByFrames>(me, {me.S, turn_of(me.at), turn_of(me.other)},
                        {me.rho, relative_gradient(me)}, {q.u, q.udot, q.w, q.wdot});
}

template <FrameGroup G>
template <class Q>
void SectionRotation<G>::add_derivative(const Node<Q>& A, const Node<Q>& B, const Rotation& S,
                                        PairMatrix& K) const {
  constexpr int n = Q::columns;
  const Force<Q> none{fixed<sd, n>(Vector(Vector::Zero())), fixed<rd, n>(Angular(Angular::Zero()))};
  Force<Q> on_A = none, on_B = none;
  add_force_of<Q>(A, B, on_A, on_B);
  Eigen::Matrix<Scalar, 2 * dim, n> D;
  D << on_A.f.d, on_A.m.d, on_B.f.d, on_B.m.d;
  if constexpr (n == relative)
    K += by_increments<2 * dim>(D, S);
  else
    K += D;
}

template <FrameGroup G>
void SectionRotation<G>::add_gyroscopic_tangent(const G& A, const G& B, const Scalar* v,
                                                PairMatrix& C) const {
  const auto at = places(A, B);
  add_derivative<ByRates>(by_rates(at[0], v), by_rates(at[1], v), at[0].S, C);
}

template <FrameGroup G>
void SectionRotation<G>::add_stiffness(const G& A, const G& B, const Scalar* v, const Pair& a,
                                       PairMatrix& K) const {
  const auto at = places(A, B);
  add_derivative<ByFrames>(by_frames(at[0], v, a), by_frames(at[1], v, a), at[0].S, K);
}

template <FrameGroup G>
auto SectionRotation<G>::kinetic_energy(const G& A, const G& B, const Scalar* v) const -> Scalar {
  using Q = Values;
  const auto at = places(A, B);
  const Node<Q> n_A = node<Q>(at[0], at[0].S, at[0].rho, motion(at[0], v, Pair::Zero())),
                n_B = node<Q>(at[1], at[1].S, at[1].rho, motion(at[1], v, Pair::Zero()));
  const Angular y_A = n_A.w + Q::onto(beta_.cwiseProduct(rate<Q>(n_A, n_B))),
                y_B = n_B.w + Q::onto(beta_.cwiseProduct(rate<Q>(n_B, n_A)));
  return 0.5 * (y_A.dot(Ja_ * y_A) + y_B.dot(Ja_ * y_B)) + y_A.dot(coupling(at[0]) * y_B);
}

/// p . B d rho' of each node, and what S does to J_c.
template <FrameGroup G>
void SectionRotation<G>::add_kinetic_gradient(const G& A, const G& B, const Scalar* v,
                                              Pair& g) const {
  using Q = ByFrames;
  const auto at = places(A, B);
  const Node<Q> nodes[] = {by_frames(at[0], v, Pair::Zero()), by_frames(at[1], v, Pair::Zero())};
  const RelativeGradient dots[] = {rate<Q>(nodes[0], nodes[1]).d, rate<Q>(nodes[1], nodes[0]).d};
  Eigen::Matrix<Scalar, 1, relative> by = Eigen::Matrix<Scalar, 1, relative>::Zero();
  const Eigen::Map<const Pair> rates(v);
  const Angular y[] = {turn_gradient(at[0]) * rates, turn_gradient(at[1]) * rates};
  for (int k = 0; k < 2; ++k) {
    const Angular p = Ja_ * y[k] + coupling(at[k]) * y[1 - k];
    by += beta_.cwiseProduct(Values::about(p)).transpose() * dots[k];
    if constexpr (rd == 3)
      by += 0.5 * y[k].transpose() * Q::turned(nodes[k].S, Angular(Jc_ * y[1 - k])).d;
  }
  g += by_increments<1>(by, at[0].S).transpose();
}

template class SectionRotation<SE2>;
template class SectionRotation<SE3>;
template void SectionRotation<SE2Of<Lanes>>::add_force(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                       const Lanes*, const Pair&, Pair&) const;
template void SectionRotation<SE2Of<Lanes>>::add_mass(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                      PairMatrix&) const;
template void SectionRotation<SE2Of<Lanes>>::add_gyroscopic_tangent(const SE2Of<Lanes>&,
                                                                    const SE2Of<Lanes>&,
                                                                    const Lanes*,
                                                                    PairMatrix&) const;
template void SectionRotation<SE2Of<Lanes>>::add_stiffness(const SE2Of<Lanes>&, const SE2Of<Lanes>&,
                                                           const Lanes*, const Pair&,
                                                           PairMatrix&) const;
template auto SectionRotation<SE2Of<Lanes>>::kinetic_energy(const SE2Of<Lanes>&,
                                                            const SE2Of<Lanes>&, const Lanes*) const
    -> Scalar;
template void SectionRotation<SE3Of<Lanes>>::add_force(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                       const Lanes*, const Pair&, Pair&) const;
template void SectionRotation<SE3Of<Lanes>>::add_mass(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                      PairMatrix&) const;
template void SectionRotation<SE3Of<Lanes>>::add_gyroscopic_tangent(const SE3Of<Lanes>&,
                                                                    const SE3Of<Lanes>&,
                                                                    const Lanes*,
                                                                    PairMatrix&) const;
template void SectionRotation<SE3Of<Lanes>>::add_stiffness(const SE3Of<Lanes>&, const SE3Of<Lanes>&,
                                                           const Lanes*, const Pair&,
                                                           PairMatrix&) const;
template auto SectionRotation<SE3Of<Lanes>>::kinetic_energy(const SE3Of<Lanes>&,
                                                            const SE3Of<Lanes>&, const Lanes*) const
    -> Scalar;

}  // namespace liesl
