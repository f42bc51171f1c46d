#include "mbs/solids/stress_norm.hpp"

#include <cmath>
#include <stdexcept>

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// sigma_vm^2 = sigma^T V sigma, of 3 or 6 components.
const MatrixXd& von_mises_form(Eigen::Index components) {
  static const MatrixXd plane = [] {
    MatrixXd V = MatrixXd::Identity(3, 3);
    V(0, 1) = V(1, 0) = -0.5;
    V(2, 2) = 3;
    return V;
  }();
  static const MatrixXd space = [] {
    MatrixXd V = MatrixXd::Zero(6, 6);
    V.topLeftCorner(3, 3).setConstant(-0.5);
    V.diagonal().head(3).setOnes();
    V.diagonal().tail(3).setConstant(3);
    return V;
  }();
  return components == 3 ? plane : space;
}

}  // namespace

MatrixXd central_stress(const SolidModel& model, int cell, const Eigen::Ref<const MatrixXd>& u) {
  return model.cell(cell).stress * model.at_cell(cell, u);
}

Eigen::RowVectorXd von_mises(const MatrixXd& stresses) {
  const MatrixXd& V = von_mises_form(stresses.rows());
  return stresses.cwiseProduct(V * stresses).colwise().sum().cwiseMax(0.0).cwiseSqrt();
}

VectorXd von_mises_gradient(const VectorXd& stress) {
  const VectorXd weighted = von_mises_form(stress.size()) * stress;
  const double square = stress.dot(weighted);
  return square > 0 ? VectorXd(weighted / std::sqrt(square))
                    : VectorXd(VectorXd::Zero(stress.size()));
}

VectorXd relaxed_shares(const VectorXd& v, double relaxation) {
  return v.unaryExpr([relaxation](double share) { return std::pow(share, relaxation); });
}

VectorXd relaxed_shares_derivative(const VectorXd& v, const VectorXd& dv, double relaxation) {
  return v.binaryExpr(dv, [relaxation](double share, double change) {
    return share > 0 ? relaxation * std::pow(share, relaxation - 1) * change : 0;
  });
}

MatrixXd von_mises(const SolidStatics& statics, double relaxation) {
  const SolidModel& model = statics.model();
  const VectorXd share = relaxed_shares(statics.fractions(), relaxation);
  MatrixXd stress(model.mesh().cell_count(), statics.cases());
  for (int e = 0; e < model.mesh().cell_count(); ++e)
    stress.row(e) = share[e] * von_mises(central_stress(model, e, statics.u()));
  return stress;
}

StressNorm stress_norm(const SolidStatics& statics, const FractionGradient& dv,
                       const StressOptions& options) {
  const double p = options.p, q = options.relaxation;
  if (!(p >= 1 && q >= 0)) throw std::invalid_argument("stress norm: p >= 1 and relaxation >= 0");
  const SolidModel& model = statics.model();
  if (model.mesh().cell_count() == 0)
    throw std::invalid_argument("stress norm: a part known by its matrices has no cells");
  const int dim = model.mesh().dim, local = model.mesh().nodes_per_cell(), n = statics.cases();
  const MatrixXd& V = von_mises_form(dim == 2 ? 3 : 6);
  const MatrixXd stress = von_mises(statics, q);
  const Eigen::RowVectorXd largest = stress.colwise().maxCoeff();
  double total = 0;
  for (int e = 0; e < stress.rows(); ++e) total += model.cell(e).volume;

  // Against the largest stress, so that powers stay in range.
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(n);
  const Eigen::RowVectorXd unit = largest.cwiseMax(1e-300).cwiseInverse();
  for (int e = 0; e < stress.rows(); ++e)
    sum += model.cell(e).volume / total * stress.row(e).cwiseProduct(unit).array().pow(p).matrix();
  StressNorm S;
  S.value = largest.cwiseProduct(sum.array().pow(1 / p).matrix()).transpose();

  S.gradient = MatrixXd::Zero(n, dv.cols());
  MatrixXd dS_du = MatrixXd::Zero(model.node_freedoms(), n);
  for (int e = 0; e < stress.rows(); ++e) {
    const double v = statics.fractions()[e], w = model.cell(e).volume / total;
    // dS/d(relaxed stress of e) by case
    Eigen::RowVectorXd d(n);
    for (int k = 0; k < n; ++k)
      d[k] = S.value[k] > 0 ? w * std::pow(stress(e, k) / S.value[k], p - 1) : 0;
    if (v > 0)
      for (FractionGradient::InnerIterator x(dv, e); x; ++x)
        S.gradient.col(x.col()) += x.value() * q / v * d.cwiseProduct(stress.row(e)).transpose();
    const MatrixXd sigma = central_stress(model, e, statics.u());
    for (int k = 0; k < n; ++k)  // d(v^q sigma)/du = v^2q S^T V s / (v^q sigma)
      d[k] = stress(e, k) > 0 ? d[k] * std::pow(v, 2 * q) / stress(e, k) : 0;
    const MatrixXd g = model.cell(e).stress.transpose() * (V * sigma) * d.asDiagonal();
    for (int c = 0; c < local; ++c)
      dS_du.middleRows(model.freedom(e, c), dim) += g.middleRows(dim * c, dim);
  }
  if (dv.cols() == 0) return S;
  S.by_displacement = model.T().transpose() * dS_du;
  statics.add_adjoint_gradient(S.by_displacement, dv, S.gradient);
  return S;
}

}  // namespace liesl
