#include "mbs/solids/continuum_cell.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mbs/linalg/dense.hpp"
#include "mbs/solids/incompatible_modes.hpp"
#include "mbs/solids/mesh.hpp"
#include "mbs/solids/strain_components.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kEnhanced = 30;            // iterations of alpha
constexpr double kEnhancedDone = 1e-14;  // last change of the strain, of the largest of the cell

}  // namespace

template <int D>
ContinuumCell<D>::ContinuumCell(const Positions& nodes, const Material& material, double thickness,
                                SolidLaw law)
    : material_(material), law_(law) {
  if (!(material.E > 0) || !(material.nu < 0.5) || !(material.nu > -1))
    throw std::invalid_argument("material '" + material.name +
                                "': expected E > 0 and -1 < nu < 0.5; nu = 0.5 is incompressible");
  const CellKind& kind = cell_kind(D, static_cast<int>(nodes.cols()));
  const bool enhanced = kind.family == CellFamily::Cube && kind.order == 1;
  const auto& quadrature = cell_quadrature(kind, QuadratureUse::Stiffness);
  const int points = static_cast<int>(quadrature.size());
  const MatrixXd dN0 = cell_functions(kind, reference_centre(kind)).dN;
  const IncompatibleModes modes(cell_jacobian(D, nodes, dN0));
  central_ = modes.inverse() * dN0;
  weight_.resize(points);
  enhanced_.setZero(kStrains * points, enhanced ? D * D : 0);
  MatrixXd weighted = MatrixXd::Zero(kStrains * points, kStrains * points);
  const auto rest = solid_law<D>(SolidLaw::StVenantKirchhoff, material,
                                 Eigen::Matrix<double, kStrains, 1>::Zero())
                        .tangent;
  for (int point = 0; point < points; ++point) {
    const Vector3d& xi = quadrature[static_cast<std::size_t>(point)].xi;
    const MatrixXd dN = cell_functions(kind, xi).dN, J = cell_jacobian(D, nodes, dN);
    const double det = linalg::determinant(J);
    gradient_.emplace_back(linalg::inverse(J) * dN);
    weight_[point] = quadrature[static_cast<std::size_t>(point)].weight * std::abs(det) *
                     (D == 2 ? thickness : 1);
    if (enhanced)
      enhanced_.template middleRows<kStrains>(kStrains * point) = modes.strains(xi, det);
    weighted.template block<kStrains, kStrains>(kStrains * point, kStrains * point) =
        weight_[point] * rest;
  }
  volume_ = weight_.sum();
  linear_ = weighted;
  if (!enhanced) return;
  const MatrixXd coupled = weighted * enhanced_;
  to_alpha_ = -linalg::LDLT(enhanced_.transpose() * coupled).solve(coupled.transpose());
  linear_ += coupled * to_alpha_;
  linear_ = (0.5 * (linear_ + linear_.transpose())).eval();
}

template <int D>
void ContinuumCell<D>::strain(const Positions& x, VectorXd& E) const {
  E.resize(strains());
  for (int g = 0; g < points(); ++g) {
    const Square F = x.lazyProduct(gradient_[g].transpose());
    auto at = E.template segment<kStrains>(kStrains * g);
    symmetric_components<D>(F, F, at);
    at.template head<D>().array() = 0.5 * (at.template head<D>().array() - 1);
    at.template tail<kStrains - D>() *= 0.5;
  }
}

template <int D>
void ContinuumCell<D>::strain_rate(const Positions& x, const Positions& v, VectorXd& rate) const {
  rate.resize(strains());
  for (int g = 0; g < points(); ++g) {
    const Square F = x.lazyProduct(gradient_[g].transpose()),
                 Fdot = v.lazyProduct(gradient_[g].transpose());
    symmetric_components<D>(F, Fdot, rate.template segment<kStrains>(kStrains * g));
  }
}

template <int D>
void ContinuumCell<D>::respond(const VectorXd& E, bool tangent, Response& out,
                               double factor) const {
  out.converged = true;
  if (law_ == SolidLaw::StVenantKirchhoff)
    respond_linearly(E, tangent, out);
  else
    respond_iterated(E, tangent, out);
  if (factor == 1) return;
  out.energy *= factor;
  out.stress *= factor;
  if (tangent) out.tangent *= factor;
}

template <int D>
void ContinuumCell<D>::respond_linearly(const VectorXd& E, bool tangent, Response& out) const {
  out.stress.resize(strains());
  out.stress.noalias() = linear_.template selfadjointView<Eigen::Lower>() * E;
  out.energy = 0.5 * out.stress.dot(E);
  if (tangent) out.tangent = linear_;
}

/// The law at all points of a cell with strains E + M alpha.
template <int D>
struct ContinuumCell<D>::Evaluation {
  MatrixXd tangents;    ///< w_g dS_g/dE_g, side by side
  MatrixXd coupled;     ///< w_g dS_g/dE_g M_g
  MatrixXd stiffness;   ///< sum_g M_g^T w_g dS_g/dE_g M_g
  VectorXd unbalanced;  ///< sum_g w_g M_g^T S_g
};

template <int D>
void ContinuumCell<D>::evaluate(const VectorXd& E, Response& out, Evaluation& at) const {
  const Eigen::Index modes = enhanced_.cols();
  at.tangents.resize(kStrains, strains());
  at.coupled.resize(strains(), modes);
  at.stiffness.setZero(modes, modes);
  at.unbalanced.setZero(modes);
  out.energy = 0;
  for (int g = 0; g < points(); ++g) {
    const auto M = enhanced_.template middleRows<kStrains>(kStrains * g);
    Strain strain = E.template segment<kStrains>(kStrains * g);
    if (modes > 0) strain.noalias() += M.lazyProduct(out.alpha);
    const auto law = solid_law<D>(law_, material_, strain);
    out.energy += weight_[g] * law.energy;
    auto stress = out.stress.template segment<kStrains>(kStrains * g);
    stress = weight_[g] * law.stress;
    auto tangent = at.tangents.template middleCols<kStrains>(kStrains * g);
    tangent = weight_[g] * law.tangent;
    if (modes == 0) continue;
    auto coupled = at.coupled.template middleRows<kStrains>(kStrains * g);
    coupled.noalias() = tangent.lazyProduct(M);
    at.stiffness.noalias() += M.transpose().lazyProduct(coupled);
    at.unbalanced.noalias() += M.transpose().lazyProduct(stress);
  }
}

/// Newton's method on alpha, from that of the linear law.
template <int D>
void ContinuumCell<D>::respond_iterated(const VectorXd& E, bool tangent, Response& out) const {
  const bool enhanced = enhanced_.cols() > 0;
  Evaluation at;
  out.stress.resize(strains());
  if (enhanced) out.alpha = to_alpha_ * E;
  linalg::LDLT factor(MatrixXd::Identity(1, 1));
  const double size = std::max(E.cwiseAbs().maxCoeff(), kEnhancedDone);
  out.converged = false;
  for (int i = 0; i < kEnhanced && !out.converged; ++i) {
    evaluate(E, out, at);
    if (!std::isfinite(out.energy)) break;
    out.converged = !enhanced;
    if (!enhanced) break;
    factor = linalg::LDLT(at.stiffness);
    const VectorXd step = factor.solve(at.unbalanced);
    out.alpha -= step;
    out.converged = (enhanced_ * step).cwiseAbs().maxCoeff() <= kEnhancedDone * (1 + size);
  }
  if (!out.converged) {
    out.energy = std::numeric_limits<double>::quiet_NaN();
    out.stress.setConstant(out.energy);
  }
  if (!tangent) return;
  out.tangent.setZero(strains(), strains());
  for (int g = 0; g < points(); ++g)
    out.tangent.template block<kStrains, kStrains>(kStrains * g, kStrains * g) =
        at.tangents.template middleCols<kStrains>(kStrains * g);
  if (enhanced) out.tangent.noalias() -= at.coupled * factor.solve(at.coupled.transpose());
}

template <int D>
void ContinuumCell<D>::add_force(const Positions& x, const VectorXd& stress, Positions& f) const {
  for (int g = 0; g < points(); ++g) {
    const Square F = x.lazyProduct(gradient_[g].transpose());
    const Square P = F * as_tensor<D>(stress.template segment<kStrains>(kStrains * g));
    f.noalias() += P.lazyProduct(gradient_[g]);
  }
}

template <int D>
void ContinuumCell<D>::strain_matrix(const Positions& x, MatrixXd& B) const {
  B.resize(strains(), D * nodes());
  for (int g = 0; g < points(); ++g) {
    const Square F = x.lazyProduct(gradient_[g].transpose());
    for (int a = 0; a < nodes(); ++a) {
      auto at = B.template block<kStrains, D>(kStrains * g, D * a);
      const auto dN = gradient_[g].col(a);
      for (int i = 0; i < D; ++i) at.row(i) = dN[i] * F.col(i).transpose();
      for (int s = D; s < kStrains; ++s) {
        const int i = s - D, j = (i + 1) % D;
        at.row(s) = dN[i] * F.col(j).transpose() + dN[j] * F.col(i).transpose();
      }
    }
  }
}

template <int D>
void ContinuumCell<D>::add_geometric(const VectorXd& stress, MatrixXd& K) const {
  for (int g = 0; g < points(); ++g) {
    const Square S = as_tensor<D>(stress.template segment<kStrains>(kStrains * g));
    const MatrixXd G = gradient_[g].transpose() * S * gradient_[g];
    for (int a = 0; a < nodes(); ++a)
      for (int b = 0; b < nodes(); ++b)
        K.template block<D, D>(D * a, D * b).diagonal().array() += G(a, b);
  }
}

template <int D>
auto ContinuumCell<D>::central_gradient(const Positions& x) const -> Square {
  return x.lazyProduct(central_.transpose());
}

template <int D>
double ContinuumCell<D>::smallest_determinant(const Positions& x) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Positions& gradient : gradient_)
    least = std::min(least, Square(x.lazyProduct(gradient.transpose())).determinant());
  return least;
}

template <int D>
auto ContinuumCell<D>::green_lagrange(const Square& F) -> Strain {
  Strain E;
  symmetric_components<D>(F, F, E);
  E.template head<D>().array() = 0.5 * (E.template head<D>().array() - 1);
  E.template tail<kStrains - D>() *= 0.5;
  return E;
}

template <int D>
auto ContinuumCell<D>::central_stress(const Positions& x) const
    -> Eigen::Matrix<double, kStrains, 1> {
  const Square F = central_gradient(x);
  Strain out = Strain::Zero();
  const auto at = solid_law<D>(law_, material_, green_lagrange(F));
  const double J = F.determinant() * at.across;
  if (!(J > 0)) return out;
  const Square sigma = F * as_tensor<D>(at.stress) * F.transpose() / J;
  out.template head<D>() = sigma.diagonal();
  for (int s = D; s < kStrains; ++s) out[s] = sigma(s - D, (s - D + 1) % D);
  return out;
}

/// Of y = A : F S F^T/J with A of f: dy = (2 A F S/J + F W - y F^-T) : dF, W the tensor of
/// dS/dE^T g/J - y d(ln across)/dE, g that of F^T A F as weights of the components of S.
template <int D>
void ContinuumCell<D>::add_central_stress_gradient(const Positions& x,
                                                   const Eigen::Matrix<double, kStrains, 1>& f,
                                                   Positions& g) const {
  const Square F = central_gradient(x);
  const auto at = solid_law<D>(law_, material_, green_lagrange(F));
  const double J = F.determinant() * at.across;
  if (!(J > 0)) return;
  Strain halved = f;
  halved.template tail<kStrains - D>() *= 0.5;
  const Square A = as_tensor<D>(halved), S = as_tensor<D>(at.stress), FAF = F.transpose() * A * F;
  const double y = (FAF * S).trace() / J;
  Strain on_S;
  on_S.template head<D>() = FAF.diagonal();
  for (int s = D; s < kStrains; ++s) on_S[s] = 2 * FAF(s - D, (s - D + 1) % D);
  const Strain on_E = at.tangent.transpose() * on_S / J - y * at.thinning;
  const Square on_F = 2 / J * A * F * S + F * as_tensor<D>(on_E) - y * F.inverse().transpose();
  g.noalias() += on_F.lazyProduct(central_);
}

template class ContinuumCell<2>;
template class ContinuumCell<3>;

}  // namespace liesl
