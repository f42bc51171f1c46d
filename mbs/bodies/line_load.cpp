#include "mbs/bodies/line_load.hpp"

namespace liesl {

template <FrameGroup G>
LineLoad<G>::LineLoad(const CondensedLaw<G>& law, const SpreadLoad<G>& load, const G& A, const G& B)
    : law_(law),
      load_(load),
      L_(law.length()),
      d_(BeamElement<G>::relative(A, B)),
      P_(BeamElement<G>::P(d_)),
      p_(load.wrench) {
  if (!load.follower) {
    mu_A_.template tail<rd>() = mu_B_.template tail<rd>() = load.wrench.template tail<rd>();
    if constexpr (rd == 3) {
      mu_A_.template tail<3>() = A.R.transpose() * load.wrench.template tail<3>();
      mu_B_.template tail<3>() = B.R.transpose() * load.wrench.template tail<3>();
    }
    p_ = 0.5 * (mu_A_ + mu_B_);
  }
  const Matrix a = G::ad(d_), &f = law.section_flexibility();
  const Tangent y = f * p_;
  free_.n = law.stress(d_, (d_ - law.d0()) / L_);
  free_.z = f * (a.transpose() * free_.n);
  dn_ = law.stress(d_, L_ / 12 * (a * y));
  loaded_ = {free_.n + dn_, free_.z + f * (a.transpose() * dn_) - L_ * y};
}

/// n + (L/12) ad(z)^T n, with p less without.
template <FrameGroup G>
auto LineLoad<G>::conjugate_change() const -> Tangent {
  const Tangent dz = loaded_.z - free_.z;
  return dn_ + L_ / 12 * (G::ad(dz).transpose() * loaded_.n + G::ad(free_.z).transpose() * dn_);
}

template <FrameGroup G>
auto LineLoad<G>::force() const -> Pair {
  const Tangent on_d = -conjugate_change() - L_ / 12 * (mu_B_ - mu_A_);
  Pair f = P_.transpose() * on_d;
  if (!load_.follower) return f;
  Tangent straight = Tangent::Unit(0);  // -+ L^2/12 across the axis is in the shares
  straight *= L_;
  const Tangent across = L_ / 12 * (G::ad(Tangent(d_ - straight)).transpose() * p_);
  const Tangent both =
      L_ * L_ / 24 * (G::ad(Tangent(L_ * law_.slope_of_axis() + loaded_.z)).transpose() * p_);
  f.template head<dim>() += both - across;
  f.template tail<dim>() += both + across;
  return f;
}

/// dz/dd = K^-1 [N(n) + ad(d)^T dn/dd]
template <FrameGroup G>
auto LineLoad<G>::slope_gradient() const -> Matrix {
  const Matrix n_d = law_.stiffness(d_) * law_.Y(d_, loaded_.n, loaded_.z) / L_;
  return law_.section_flexibility() *
         (CondensedLaw<G>::force_operator(loaded_.n) + G::ad(d_).transpose() * n_d);
}

/// d(R^T m) = (R^T m) x dw in the slope, by Y^T F^-1 (L/12) ad(d) - (L^2/12) N of K^-1 dp, and at
/// the nodes.
template <FrameGroup G>
void LineLoad<G>::add_turning_of_moments(Gradient& by_h) const {
  if constexpr (rd == 3) {
    const Matrix by_p =
        (law_.Y(d_, loaded_.n, loaded_.z).transpose() * law_.stiffness(d_) * G::ad(d_) * L_ / 12 -
         L_ * L_ / 12 * CondensedLaw<G>::force_operator(loaded_.n)) *
        law_.section_flexibility();
    using Vector = typename G::Vector;
    const typename G::Rotation at_A = hat(Vector(mu_A_.template tail<3>())),
                               at_B = hat(Vector(mu_B_.template tail<3>()));
    by_h.template middleCols<3>(sd) -= 0.5 * by_p.template rightCols<3>() * at_A;
    by_h.template rightCols<3>() -= 0.5 * by_p.template rightCols<3>() * at_B;
    by_h.template block<3, 3>(sd, sd) += L_ / 12 * at_A;
    by_h.template block<3, 3>(sd, dim + sd) -= L_ / 12 * at_B;
  }
}

template <FrameGroup G>
auto LineLoad<G>::conjugate_tangent() const -> Gradient {
  const Matrix hessian = law_.hessian(d_, loaded_.n, loaded_.z) - law_.hessian(d_, free_.n);
  Gradient by_h = -hessian * P_;
  if (!load_.follower) add_turning_of_moments(by_h);
  return by_h;
}

template <FrameGroup G>
auto LineLoad<G>::tangent() const -> PairMatrix {
  const Tangent on_d = -conjugate_change() - L_ / 12 * (mu_B_ - mu_A_);
  PairMatrix k = P_.transpose() * conjugate_tangent();
  k.template topRows<dim>() += G::dTinvT(-d_, on_d) * P_;
  k.template bottomRows<dim>() += G::dTinvT(d_, on_d) * P_;
  if (!load_.follower) return k;
  const Gradient across = L_ / 12 * CondensedLaw<G>::force_operator(p_) * P_;
  const Gradient both = L_ * L_ / 24 * CondensedLaw<G>::force_operator(p_) * slope_gradient() * P_;
  k.template topRows<dim>() += both - across;
  k.template bottomRows<dim>() += both + across;
  return k;
}

template <FrameGroup G>
auto LineLoad<G>::conjugate_by(const Slope& of, const Tangent& dn, const Tangent& dz) const
    -> Tangent {
  return dn + L_ / 12 * (G::ad(dz).transpose() * of.n + G::ad(of.z).transpose() * dn);
}

/// F n' = -F' n + (L/12) ad(d) y', y' = -K^-1 K' y, and z' = K^-1 [ad(d)^T n' - K' z].
template <FrameGroup G>
auto LineLoad<G>::force_by(const Matrix& dK) const -> Pair {
  const Matrix a = G::ad(d_), &f = law_.section_flexibility();
  const Tangent dy = -f * (dK * (f * p_));
  const auto slope = [&](const Slope& of, const Tangent& dn) -> Tangent {
    return f * (a.transpose() * dn - dK * of.z);
  };
  const Tangent dn_free = law_.stress_by(d_, free_.n, dK),
                dn = law_.stress_by(d_, loaded_.n, dK) + law_.stress(d_, L_ / 12 * (a * dy));
  const Tangent dz = slope(loaded_, dn);
  const Tangent on_d =
      conjugate_by(free_, dn_free, slope(free_, dn_free)) - conjugate_by(loaded_, dn, dz);
  Pair g = P_.transpose() * on_d;
  if (!load_.follower) return g;
  const Tangent both = L_ * L_ / 24 * (G::ad(dz).transpose() * p_);
  g.template head<dim>() += both;
  g.template tail<dim>() += both;
  return g;
}

template class LineLoad<SE2>;
template class LineLoad<SE3>;

}  // namespace liesl
