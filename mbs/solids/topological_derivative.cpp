#include "mbs/solids/topological_derivative.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Value at the centre of a cell, with the functions N of its nodes there: dim x columns.
MatrixXd at_centre(int dim, const VectorXd& N, const MatrixXd& local) {
  MatrixXd centre = MatrixXd::Zero(dim, local.cols());
  for (Eigen::Index c = 0; c < N.size(); ++c) centre += N[c] * local.middleRows(dim * c, dim);
  return centre;
}

/// Displacements and the rigid accelerations that balance their loads, node freedoms x columns.
struct Fields {
  MatrixXd u, acceleration;
};

/// sum over the columns of both, by cell.
VectorXd of_holes(const SolidStatics& statics, const Fields& load, const Fields& output) {
  const SolidModel& model = statics.model();
  const int dim = model.mesh().dim;
  const double rho = model.material().rho;
  const CellKind& kind = model.mesh().kind();
  const VectorXd N = cell_functions(kind, reference_centre(kind)).N;
  VectorXd out(model.mesh().cell_count());
  for (int e = 0; e < out.size(); ++e) {
    const MatrixXd u = model.at_cell(e, load.u), mu = model.at_cell(e, output.u);
    const MatrixXd sigma = model.cell(e).stress * u, tau = model.cell(e).stress * mu;
    out[e] = 0;
    for (Eigen::Index n = 0; n < sigma.cols(); ++n)
      out[e] += hole_effect(dim, model.material(), sigma.col(n), tau.col(n));
    if (!statics.inertia_relief()) continue;
    const MatrixXd a = at_centre(dim, N, model.at_cell(e, load.acceleration));
    const MatrixXd b = at_centre(dim, N, model.at_cell(e, output.acceleration));
    out[e] +=
        rho * (at_centre(dim, N, mu).cwiseProduct(a) + at_centre(dim, N, u).cwiseProduct(b)).sum();
  }
  return out;
}

}  // namespace

HoleForm hole_form(int dim, double nu) {
  if (dim == 2) return {4, -1};
  const double k = 3 * (1 - nu) / (2 * (7 - 5 * nu));
  return {10 * (1 + nu) * k, -(1 + 5 * nu) * k};
}

double hole_effect(int dim, const Material& material, const VectorXd& sigma, const VectorXd& tau) {
  const HoleForm form = hole_form(dim, material.nu);
  const double product = sigma.head(dim).dot(tau.head(dim)) +
                         2 * sigma.tail(sigma.size() - dim).dot(tau.tail(tau.size() - dim));
  return (form.product * product + form.trace * sigma.head(dim).sum() * tau.head(dim).sum()) /
         material.E;
}

VectorXd compliance_of_holes(const SolidStatics& statics, const VectorXd& w) {
  const Fields cases{statics.u(), statics.acceleration().leftCols(statics.cases())};
  return of_holes(statics, {cases.u * w.asDiagonal(), cases.acceleration * w.asDiagonal()}, cases);
}

VectorXd output_of_holes(const SolidStatics& statics, int output, const VectorXd& w) {
  const MatrixXd acceleration = statics.acceleration();
  return of_holes(statics, {statics.u() * w, acceleration.leftCols(statics.cases()) * w},
                  {statics.adjoint(output), acceleration.col(statics.cases() + output)});
}

}  // namespace liesl
