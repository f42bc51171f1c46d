#include "mbs/bodies/four_elements.hpp"

#include <algorithm>

namespace liesl {
namespace {

template <class T, class Of>
auto each(const Four<T>& four, const Of& of) {
  Four<std::remove_cvref_t<std::invoke_result_t<const Of&, const T&>>> out;
  std::transform(four.begin(), four.end(), out.begin(),
                 [&](const T* one) { return &std::invoke(of, *one); });
  return out;
}

}  // namespace

template <FrameGroup G>
FourElements<G>::FourElements(int first, int count, const Elements4& elements)
    : first_(first),
      count_(count),
      law_(each(elements, &Element::law)),
      inertia_(each(elements, &Element::inertia)) {}

template <FrameGroup G>
auto FourElements<G>::frames(const BodyState<G>& s, int shift) const -> Frame {
  Four<G> H;
  for (int lane = 0; lane < Lanes::size; ++lane) H[lane] = s.H + at(lane) + shift;
  return {gather(H, &G::R), gather(H, &G::x)};
}

template <FrameGroup G>
auto FourElements<G>::pairs(const double* x) const -> Pair {
  const double *a = x + dim * at(0), *b = x + dim * at(1), *c = x + dim * at(2),
               *d = x + dim * at(3);
  Pair all;
  for (int i = 0; i < 2 * dim; ++i) all[i] = {a[i], b[i], c[i], d[i]};
  return all;
}

template <FrameGroup G>
auto FourElements<G>::section_forces(const typename G::Tangent* of_chain) const -> Tangent {
  Four<typename G::Tangent> four;
  for (int lane = 0; lane < Lanes::size; ++lane) four[lane] = of_chain + at(lane);
  return gather(four, std::identity());
}

template <FrameGroup G>
void FourElements<G>::add(const Pair& g, double* r) const {
  for (int lane = 0; lane < count_; ++lane)
    for (int i = 0; i < 2 * dim; ++i) r[dim * (first_ + lane) + i] += g[i][lane];
}

template <FrameGroup G>
double FourElements<G>::sum(const Lanes& each) const {
  double sum = 0;
  for (int lane = 0; lane < count_; ++lane) sum += each[lane];
  return sum;
}

/// vdot - [R^T gravity; 0] of both nodes.
template <FrameGroup G>
auto FourElements<G>::apparent(const BodyState<G>& s, const Frame& A, const Frame& B,
                               const Space& gravity) const -> Pair {
  constexpr int sd = G::space_dim;
  Pair a = pairs(s.vdot);
  a.template head<sd>() -= A.R.transpose().lazyProduct(gravity);
  a.template segment<sd>(dim) -= B.R.transpose().lazyProduct(gravity);
  return a;
}

template <FrameGroup G>
void FourElements<G>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                                  ForceScale& scale) const {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  const Frame A = frames(s, 0), B = frames(s, 1);
  const Pair v = pairs(s.v), a = apparent(s, A, B, gravity.template cast<Lanes>());
  Pair g;
  inertia_.force(A, B, v.data(), a, g);
  add(g, r);
  scale.force +=
      sum(g.template head<sd>().squaredNorm() + g.template segment<sd>(dim).squaredNorm());
  scale.moment +=
      sum(g.template segment<rd>(sd).squaredNorm() + g.template tail<rd>().squaredNorm());
}

template <FrameGroup G>
void FourElements<G>::add_internal(const BodyState<G>& s, double damping, double* r,
                                   ForceScale& scale) const {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  Pair v, g;
  if (damping > 0) v = pairs(s.v);
  law_.force(frames(s, 0), frames(s, 1), v.data(), damping, g);
  add(g, r);
  scale.force += sum(g.template head<sd>().squaredNorm());
  scale.moment += sum(g.template segment<rd>(sd).squaredNorm());
}

template <FrameGroup G>
auto FourElements<G>::stiffness(const Motion& m, const BodyState<G>& s, const Vector& gravity,
                                double damping, const typename G::Tangent* stress,
                                const PairMatrix& M) const -> PairMatrix {
  const Space weight = gravity.template cast<Lanes>();
  const Tangent d = Frame::log(m.A.inverse() * m.B);
  const Tangent n = stress ? section_forces(stress) : law_.stress(d, strain(d));
  PairMatrix k = inertia_.stiffness(m.A, m.B, m.v.data(), apparent(s, m.A, m.B, weight));
  if (gravity.squaredNorm() > 0) inertia_.add_weight_tangent(m.A, m.B, weight, M, k);
  k += law_.tangent(m.A, m.B, n, m.v.data(), damping);
  return k;
}

template <FrameGroup G>
auto FourElements<G>::damping_matrix(const Motion& m, double damping) const -> PairMatrix {
  PairMatrix c = inertia_.gyroscopic_tangent(m.A, m.B, m.v.data());
  if (damping > 0) c += law_.damping_tangent(m.A, m.B, m.v.data(), damping);
  return c;
}

template <FrameGroup G>
void FourElements<G>::add(const PairMatrix& k, Matrices& A) const {
  for (int lane = 0; lane < count_; ++lane)
    A.add_element(first_ + lane, k.unaryExpr([lane](const Lanes& x) { return x[lane]; }).eval());
}

template <FrameGroup G>
void FourElements<G>::add_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                                  double damping, const typename G::Tangent* stress,
                                  Matrices& A) const {
  const Motion m = motion(s);
  const PairMatrix M = inertia_.mass(m.A, m.B);
  PairMatrix k = w.mass * M;
  if (w.stiffness != 0) k += w.stiffness * stiffness(m, s, gravity, damping, stress, M);
  if (w.damping != 0) k += w.damping * damping_matrix(m, damping);
  add(k, A);
}

template <FrameGroup G>
void FourElements<G>::add_tangents(const BodyState<G>& s, const Vector& gravity, double damping,
                                   const typename G::Tangent* stress, Matrices& K, Matrices& C,
                                   Matrices& M) const {
  const Motion m = motion(s);
  const PairMatrix mass = inertia_.mass(m.A, m.B);
  add(mass, M);
  add(stiffness(m, s, gravity, damping, stress, mass), K);
  add(damping_matrix(m, damping), C);
}

template <FrameGroup G>
void FourElements<G>::add_energy(const BodyState<G>& s, const Vector& gravity,
                                 BodyEnergy& energy) const {
  const Frame A = frames(s, 0), B = frames(s, 1);
  const Tangent d = Frame::log(A.inverse() * B), e = strain(d);
  energy.kinetic += sum(inertia_.kinetic_energy(A, B, pairs(s.v).data()));
  energy.elastic += sum(0.5 * law_.length() * e.dot(law_.stress(d, e)));
  energy.potential += sum(inertia_.weight_potential(A, B, gravity.template cast<Lanes>()));
}

template <FrameGroup G>
void FourElements<G>::strains(const BodyState<G>& s, typename G::Tangent* eps) const {
  const Tangent all = strain(Frame::log(frames(s, 0).inverse() * frames(s, 1)));
  for (int lane = 0; lane < count_; ++lane)
    for (int i = 0; i < dim; ++i) eps[first_ + lane][i] = all[i][lane];
}

/// -g_A and g_B.
template <FrameGroup G>
void FourElements<G>::end_forces(const BodyState<G>& s,
                                 std::array<typename G::Tangent, 2>* n) const {
  Pair g;
  law_.force(frames(s, 0), frames(s, 1), nullptr, 0, g);
  for (int lane = 0; lane < count_; ++lane)
    for (int i = 0; i < dim; ++i) {
      n[first_ + lane][0][i] = -g[i][lane];
      n[first_ + lane][1][i] = g[dim + i][lane];
    }
}

template class FourElements<SE2>;
template class FourElements<SE3>;

}  // namespace liesl
