/// @file
/// Stresses of the cells of a meshed part in a floating frame: at their centres, from u = T Psi e.

#include "mbs/bodies/solid_body.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/stress_norm.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

template <FrameGroup G>
MatrixXd SolidBody<G>::cell_stresses(const BodyState<G>& s) const {
  const SolidModel& model = *model_;
  const int cells = model.mesh().cell_count();
  if (cells == 0) return {};
  const VectorXd q = basis_ * coordinates(s), u = model.T() * q;
  MatrixXd out(model.cell(0).stress.rows(), cells);
  for (int e = 0; e < cells; ++e) out.col(e) = central_stress(model, e, u);
  return out;
}

template <FrameGroup G>
MatrixXd SolidBody<G>::stress_basis(int cell) const {
  return model_->cell(cell).stress * model_->q_at_cell(cell, basis_);
}

template <FrameGroup G>
VectorXd SolidBody<G>::cell_stress(const BodyState<G>& s, int cell) const {
  return stress_basis(cell) * coordinates(s);
}

template <FrameGroup G>
void SolidBody<G>::add_cell_stress_gradient(const BodyState<G>& s, int cell, const VectorXd& f,
                                            double* h) const {
  add_coordinates_gradient(s, stress_basis(cell).transpose() * f, h);
}

template MatrixXd SolidBody<SE2>::cell_stresses(const BodyState<SE2>&) const;
template MatrixXd SolidBody<SE3>::cell_stresses(const BodyState<SE3>&) const;
template MatrixXd SolidBody<SE2>::stress_basis(int) const;
template MatrixXd SolidBody<SE3>::stress_basis(int) const;
template VectorXd SolidBody<SE2>::cell_stress(const BodyState<SE2>&, int) const;
template VectorXd SolidBody<SE3>::cell_stress(const BodyState<SE3>&, int) const;
template void SolidBody<SE2>::add_cell_stress_gradient(const BodyState<SE2>&, int, const VectorXd&,
                                                       double*) const;
template void SolidBody<SE3>::add_cell_stress_gradient(const BodyState<SE3>&, int, const VectorXd&,
                                                       double*) const;

}  // namespace liesl
