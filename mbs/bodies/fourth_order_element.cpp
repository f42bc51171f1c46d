#include "mbs/bodies/fourth_order_element.hpp"

#include <stdexcept>

#include "mbs/bodies/body.hpp"
#include "mbs/bodies/line_load.hpp"

namespace liesl {

template <FrameGroup G>
FourthOrderElement<G>::FourthOrderElement(const G& A, const G& B, const Matrix& K,
                                          const Matrix& M_s)
    : law_(relative(A, B), K),
      M_s_(M_s),
      C0_(law_.stiffness_at_rest()),
      inertia_(length(), HermiteInertia<G>::coefficients(length(), M_s, bending_share())),
      mass_(inertia_.mass(A, B)) {}

template <FrameGroup G>
FourthOrderElement<G>::FourthOrderElement(const FourthOrderElement& of, const Matrix& dK,
                                          const Matrix& dM_s)
    : law_(of.law_),
      M_s_(dM_s),
      C0_(law_.stiffness_at_rest_by(dK)),
      dK_(dK),
      inertia_(length(), HermiteInertia<G>::coefficients(length(), of.M_s_, of.bending_share()),
               HermiteInertia<G>::derivative(length(), of.M_s_, of.bending_share(), dM_s,
                                             bending_share_by(dK))),
      mass_(inertia_.mass(G::identity(), G::exp(d0()))) {}

/// eta = (L^2/12)(K^-1)_rr C_ii: shear i, and the rotation r that bends along i.
template <FrameGroup G>
auto FourthOrderElement<G>::bending_share() const -> Share {
  Share eta = Share::Zero();
  const Matrix &C = law_.stiffness_at_rest(), &f = law_.section_flexibility();
  for (int i = 1; i < G::space_dim; ++i) {
    const int r = dim - i;
    eta[i] = length() * length() / 12 * C(i, i) * f(r, r);
  }
  return eta;
}

template <FrameGroup G>
auto FourthOrderElement<G>::bending_share_by(const Matrix& dK) const -> Share {
  Share eta = Share::Zero();
  const Matrix &C = law_.stiffness_at_rest(), &f = law_.section_flexibility();
  const Matrix dC = law_.stiffness_at_rest_by(dK), df = -f * dK * f;
  for (int i = 1; i < G::space_dim; ++i) {
    const int r = dim - i;
    eta[i] = length() * length() / 12 * (dC(i, i) * f(r, r) + C(i, i) * df(r, r));
  }
  return eta;
}

template <FrameGroup G>
void FourthOrderElement<G>::need_law(const char* what) const {
  if (dK_)
    throw std::logic_error(std::string("the derivative of a beam element of fourth order has no ") +
                           what);
}

template <FrameGroup G>
auto FourthOrderElement<G>::conjugate_to(const Tangent& d, const Tangent& e) const -> Tangent {
  const Tangent n = law_.stress(d, e);
  if (!dK_) return law_.conjugate(d, n);
  return law_.conjugate_by(d, n, law_.stress_by(d, n, *dK_), *dK_);
}

template <FrameGroup G>
auto FourthOrderElement<G>::viscous(const Tangent& d, const Tangent& n, const Tangent& rate) const
    -> Tangent {
  if (!dK_) return law_.viscous(d, n, rate);
  return law_.viscous_by(d, n, law_.stress_by(d, n, *dK_), rate, *dK_);
}

template <FrameGroup G>
auto FourthOrderElement<G>::stress(const G& A, const G& B) const -> Tangent {
  const Tangent d = relative(A, B), n = law_.stress(d, (d - d0()) / length());
  return dK_ ? law_.stress_by(d, n, *dK_) : n;
}

template <FrameGroup G>
auto FourthOrderElement<G>::conjugate(const G& A, const G& B) const -> Tangent {
  const Tangent d = relative(A, B);
  return conjugate_to(d, (d - d0()) / length());
}

/// F dn = Y dd/L.
template <FrameGroup G>
auto FourthOrderElement<G>::stress_gradient(const G& A, const G& B) const -> Matrix {
  need_law("gradient of its section force");
  const Tangent d = relative(A, B);
  return law_.stiffness(d) * law_.Y(d, law_.stress(d, (d - d0()) / length())) / length();
}

template <FrameGroup G>
auto FourthOrderElement<G>::extrapolated(const G& A, const G& B, const Tangent& about,
                                         const Pair& delta) const -> Tangent {
  const Tangent d = relative(A, B);
  return law_.stress(d, (d - d0() + law_.Y(d, about) * (P(d) * delta)) / length());
}

template <FrameGroup G>
double FourthOrderElement<G>::elastic_energy(const G& A, const G& B) const {
  const Tangent d = relative(A, B), e = (d - d0()) / length(), n = law_.stress(d, e);
  return 0.5 * length() * e.dot(dK_ ? law_.stress_by(d, n, *dK_) : n);
}

template <FrameGroup G>
double FourthOrderElement<G>::dissipation(const G& A, const G& B, const double* v,
                                          double damping) const {
  const Tangent d = relative(A, B), rate = P(d) * Eigen::Map<const Pair>(v);
  return damping * rate.dot(viscous(d, law_.stress(d, (d - d0()) / length()), rate));
}

template <FrameGroup G>
void FourthOrderElement<G>::internal_force(const G& A, const G& B, const double* v, double damping,
                                           Pair& g, const double* about) const {
  if (!about && !dK_) return law_.force(A, B, v, damping, g);
  Second::transmit(
      A, B,
      [&](const Tangent& d, const Matrix& Ti) -> Tangent {
        const Tangent n = law_.stress(d, (d - d0()) / length());
        const Tangent at = about ? Tangent(Eigen::Map<const Tangent>(about)) : n;
        Tangent f = about ? Tangent(law_.conjugate(d, at) + law_.Y(d, at).transpose() * (n - at))
                          : conjugate_to(d, (d - d0()) / length());
        if (damping > 0) f += damping * viscous(d, at, Second::relative_rate(d, Ti, v));
        return f;
      },
      g);
}

template <FrameGroup G>
auto FourthOrderElement<G>::constant_tangent() const -> PairMatrix {
  const Gradient p = P(d0());
  return p.transpose() * C0_ * p / length();
}

template <FrameGroup G>
auto FourthOrderElement<G>::damping_tangent(const G& A, const G& B, const double* v,
                                            double damping) const -> PairMatrix {
  need_law("tangent");
  return law_.damping_tangent(A, B, v, damping);
}

template <FrameGroup G>
auto FourthOrderElement<G>::damped_tangent(const G& A, const G& B, const Tangent& n,
                                           const double* v, double damping) const -> PairMatrix {
  need_law("tangent");
  return law_.tangent(A, B, n, v, damping);
}

namespace {

/// Of dead forces nothing is left beyond the shares.
template <FrameGroup G>
bool acts(const SpreadLoad<G>& load) {
  return load.follower || !load.wrench.template tail<G::rotation_dim>().isZero(0);
}

}  // namespace

template <FrameGroup G>
auto FourthOrderElement<G>::load_shares() const -> PairMatrix {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  const double L = length();
  const auto X = SectionRotation<G>::turning();
  PairMatrix W = PairMatrix::Zero();
  W.diagonal().setConstant(L / 2);
  W.template block<rd, sd>(sd, 0) = L * L / 12 * X.transpose();
  W.template block<rd, sd>(dim + sd, dim) = -L * L / 12 * X.transpose();
  return W;
}

template <FrameGroup G>
auto FourthOrderElement<G>::spread_curvature(const G& A, const G& B,
                                             const SpreadLoad<G>& load) const -> Pair {
  if (!acts(load)) return Pair::Zero();
  return -LineLoad<G>(law_, load, A, B).force();
}

template <FrameGroup G>
auto FourthOrderElement<G>::spread_curvature_tangent(const G& A, const G& B,
                                                     const SpreadLoad<G>& load) const
    -> PairMatrix {
  if (!acts(load)) return PairMatrix::Zero();
  return -LineLoad<G>(law_, load, A, B).tangent();
}

template <FrameGroup G>
auto FourthOrderElement<G>::spread_derivative(const G& A, const G& B,
                                              const SpreadLoad<G>& load) const -> Pair {
  if (!dK_ || !acts(load)) return Pair::Zero();
  return -LineLoad<G>(law_, load, A, B).force_by(*dK_);
}

template <FrameGroup G>
auto FourthOrderElement<G>::inertia_stiffness(const G& A, const G& B, const double* v,
                                              const Pair& a, const Vector& gravity) const
    -> PairMatrix {
  PairMatrix k = inertia_.stiffness(A, B, v, a);
  if (gravity.squaredNorm() > 0) inertia_.add_weight_tangent(A, B, gravity, mass(A, B), k);
  return k;
}

template class FourthOrderElement<SE2>;
template class FourthOrderElement<SE3>;

}  // namespace liesl
