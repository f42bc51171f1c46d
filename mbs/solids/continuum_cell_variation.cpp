/// @file
/// Derivatives of the forces of a cell by its nodes at rest.

#include "mbs/linalg/dense.hpp"
#include "mbs/solids/continuum_cell.hpp"
#include "mbs/solids/incompatible_modes.hpp"
#include "mbs/solids/mesh.hpp"
#include "mbs/solids/strain_components.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

template <int D>
auto ContinuumCell<D>::variation(const Positions& nodes, const Positions& change) const
    -> Variation {
  const CellKind& kind = cell_kind(D, this->nodes());
  const auto& quadrature = cell_quadrature(kind, QuadratureUse::Stiffness);
  const MatrixXd dN0 = cell_functions(kind, reference_centre(kind)).dN;
  const IncompatibleModes modes(cell_jacobian(D, nodes, dN0));
  const MatrixXd dJ0 = cell_jacobian(D, change, dN0);
  Variation by{{}, VectorXd(points()), MatrixXd::Zero(enhanced_.rows(), enhanced_.cols())};
  for (int g = 0; g < points(); ++g) {
    const Square stretch = gradient_[g].lazyProduct(change.transpose());
    by.gradient.emplace_back(-stretch.lazyProduct(gradient_[g]));
    by.weight[g] = weight_[g] * stretch.trace();
    if (enhanced_.cols() == 0) continue;
    const auto& xi = quadrature[static_cast<std::size_t>(g)].xi;
    const double det = linalg::determinant(cell_jacobian(D, nodes, cell_functions(kind, xi).dN));
    by.enhanced.template middleRows<kStrains>(kStrains * g) =
        modes.strains_variation(xi, det, dJ0, stretch.trace());
  }
  return by;
}

template <int D>
VectorXd ContinuumCell<D>::rate_variation(const Positions& x, const Positions& v,
                                          const Positions& dx, const Positions& dv,
                                          const Variation& by) const {
  VectorXd out(strains());
  Strain other;
  for (int g = 0; g < points(); ++g) {
    const auto gradient = gradient_[g].transpose(), change = by.gradient[g].transpose();
    const Square F = x.lazyProduct(gradient), Fdot = v.lazyProduct(gradient);
    const Square dF = dx.lazyProduct(gradient) + x.lazyProduct(change),
                 dFdot = dv.lazyProduct(gradient) + v.lazyProduct(change);
    symmetric_components<D>(dF, Fdot, out.template segment<kStrains>(kStrains * g));
    symmetric_components<D>(F, dFdot, other);
    out.template segment<kStrains>(kStrains * g) += other;
  }
  return out;
}

template <int D>
VectorXd ContinuumCell<D>::variation_of(SolidLaw law, const VectorXd& E, const VectorXd& alpha,
                                        const VectorXd& dE, const Variation& by) const {
  const bool enhanced = enhanced_.cols() > 0;
  VectorXd total = E, change = dE, stress(strains());
  if (enhanced) {
    total += enhanced_ * alpha;
    change += by.enhanced * alpha;
  }
  VectorXd out(strains());
  MatrixXd coupled(enhanced_.rows(), enhanced_.cols());  // w D M
  for (int g = 0; g < points(); ++g) {
    const auto rows = Eigen::seqN(kStrains * g, Eigen::fix<kStrains>);
    const auto at = solid_law<D>(law, material_, Strain(total(rows)));
    stress(rows) = weight_[g] * at.stress;
    out(rows) = by.weight[g] * at.stress + weight_[g] * at.tangent * change(rows);
    if (enhanced)
      coupled.template middleRows<kStrains>(kStrains * g).noalias() =
          weight_[g] * at.tangent * enhanced_.template middleRows<kStrains>(kStrains * g);
  }
  if (!enhanced) return out;
  const VectorXd off = by.enhanced.transpose() * stress + enhanced_.transpose() * out;
  out -= coupled * linalg::LDLT(enhanced_.transpose() * coupled).solve(off);
  return out;
}

template <int D>
VectorXd ContinuumCell<D>::linear_variation(const VectorXd& E, const VectorXd& dE,
                                            const Variation& by) const {
  const VectorXd alpha = enhanced_.cols() > 0 ? VectorXd(to_alpha_ * E) : VectorXd();
  return variation_of(SolidLaw::StVenantKirchhoff, E, alpha, dE, by);
}

template <int D>
VectorXd ContinuumCell<D>::stress_variation(const VectorXd& E, const VectorXd& dE,
                                            const Variation& by) const {
  if (law_ == SolidLaw::StVenantKirchhoff) return linear_variation(E, dE, by);
  Response response;
  respond_iterated(E, false, response);
  return variation_of(law_, E, response.alpha, dE, by);
}

template <int D>
void ContinuumCell<D>::add_force_variation(const Positions& x, const VectorXd& stress,
                                           const Positions& dx, const VectorXd& dstress,
                                           const Variation& by, Positions& df) const {
  for (int g = 0; g < points(); ++g) {
    const auto gradient = gradient_[g].transpose(), change = by.gradient[g].transpose();
    const Square S = as_tensor<D>(stress.template segment<kStrains>(kStrains * g)),
                 dS = as_tensor<D>(dstress.template segment<kStrains>(kStrains * g));
    const Square F = x.lazyProduct(gradient);
    const Square dF = dx.lazyProduct(gradient) + x.lazyProduct(change);
    df.noalias() += Square(dF * S + F * dS).lazyProduct(gradient_[g]) +
                    Square(F * S).lazyProduct(by.gradient[g]);
  }
}

#define LIESL_INSTANTIATE(D)                                                                      \
  template auto ContinuumCell<D>::variation(const Positions&, const Positions&) const->Variation; \
  template VectorXd ContinuumCell<D>::rate_variation(                                             \
      const Positions&, const Positions&, const Positions&, const Positions&, const Variation&)   \
      const;                                                                                      \
  template VectorXd ContinuumCell<D>::variation_of(SolidLaw, const VectorXd&, const VectorXd&,    \
                                                   const VectorXd&, const Variation&) const;      \
  template VectorXd ContinuumCell<D>::linear_variation(const VectorXd&, const VectorXd&,          \
                                                       const Variation&) const;                   \
  template VectorXd ContinuumCell<D>::stress_variation(const VectorXd&, const VectorXd&,          \
                                                       const Variation&) const;                   \
  template void ContinuumCell<D>::add_force_variation(const Positions&, const VectorXd&,          \
                                                      const Positions&, const VectorXd&,          \
                                                      const Variation&, Positions&) const;
LIESL_INSTANTIATE(2)
LIESL_INSTANTIATE(3)
#undef LIESL_INSTANTIATE

}  // namespace liesl
