#include "mbs/solids/solid_statics.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <stdexcept>
#include <utility>

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Replaces the rows and columns of held coordinates by a diagonal of the size of the others.
void hold(SolidModel::Sparse& K, const std::vector<int>& held) {
  std::vector<char> is_held(K.cols(), 0);
  for (int c : held) is_held[c] = 1;
  const double scale = K.diagonal().mean();
  for (int j = 0; j < K.outerSize(); ++j)
    for (SolidModel::Sparse::InnerIterator k(K, j); k; ++k)
      if (is_held[k.row()] || is_held[j]) k.valueRef() = k.row() == j ? scale : 0;
}

}  // namespace

SolidStatics::SolidStatics(SolidModel& model, SolidSupport support, MatrixXd outputs)
    : model_(model), support_(std::move(support)), C_(std::move(outputs)) {
  if (C_.size() == 0) C_.resize(model.size(), 0);
  if (C_.rows() != model.size())
    throw std::invalid_argument("outputs have " + std::to_string(C_.rows()) +
                                " rows, expected the " + std::to_string(model.size()) +
                                " coordinates of the part");
  for (int c : support_.fixed)
    if (c < 0 || c >= model.size())
      throw std::invalid_argument("support: coordinate " + std::to_string(c) + " does not exist");
  f_.resize(model.size(), 0);
}

/// Coordinates that keep the part from moving rigidly while reactions are zero: the best
/// conditioned ones where the mass is, so that ersatz material does not carry the round-off.
void SolidStatics::hold_determinately(const SolidModel::Sparse& M) {
  const VectorXd weight = VectorXd(M.diagonal()).cwiseSqrt();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(
      (weight.asDiagonal() * model_.rigid_motions()).transpose());
  const auto& order = qr.colsPermutation().indices();
  held_.assign(order.data(), order.data() + model_.rigid_count());
}

SolidStatus SolidStatics::solve(const VectorXd& v) {
  v_ = v;
  if (!v.allFinite() || !f_.allFinite()) return SolidStatus::NotFinite;
  K_ = model_.stiffness(v);
  held_ = support_.fixed;
  if (support_.inertia_relief) {
    const SolidModel::Sparse& M = model_.mass(v);
    MR_ = M.selfadjointView<Eigen::Lower>() * model_.rigid_motions();
    RMR_inverse_ = MatrixXd(model_.rigid_motions().transpose() * MR_).inverse();
    if (!RMR_inverse_.allFinite()) return SolidStatus::NotFinite;
    hold_determinately(M);
  }
  hold(K_, held_);
  if (!factor_.factor(K_)) return SolidStatus::Unsupported;
  MatrixXd all(model_.size(), cases() + outputs());
  all << f_, C_;
  Solved solved = solve_columns(all);
  const auto n = f_.cols(), m = C_.cols();
  cases_ = {{}, {}, solved.acceleration.leftCols(n), solved.relief.topRows(n)};
  outputs_ = {
      {}, solved.u.bottomRows(m), solved.acceleration.rightCols(m), solved.relief.bottomRows(m)};
  q_ = solved.q.leftCols(n);
  u_ = solved.u.topRows(n);
  y_ = C_.transpose() * q_;
  return q_.allFinite() ? SolidStatus::Solved : SolidStatus::NotFinite;
}

SolidStatics::Solved SolidStatics::solve_columns(const MatrixXd& f) const {
  Solved s;
  MatrixXd rhs = f;
  s.acceleration.resize(model_.rigid_count(), f.cols());
  s.relief.resize(f.cols(), 0);
  if (support_.inertia_relief) {
    s.acceleration = RMR_inverse_ * (model_.rigid_motions().transpose() * f);
    rhs.noalias() -= MR_ * s.acceleration;
  }
  for (int c : held_) rhs.row(c).setZero();
  s.q = factor_.solve(rhs);
  if (support_.inertia_relief) {
    s.q -= model_.rigid_motions() * (RMR_inverse_ * (MR_.transpose() * s.q)).eval();
    s.relief = (model_.T() * (model_.rigid_motions() * s.acceleration)).transpose();
  }
  s.u = (model_.T() * s.q).transpose();
  return s;
}

VectorXd SolidStatics::compliance() const { return f_.cwiseProduct(q_).colwise().sum(); }

/// g(n) = -s' mu^T K u_n - mu^T M (R a_n) - u_n^T M (R b): the change of the output with the
/// fraction of cell e. column >= 0: that column of mu for all cases; -1: column n for case n.
void SolidStatics::cell_weights(int e, const Solved& mu, int column, VectorXd& g) const {
  const CellMatrices& cell = model_.cell(e);
  const int dim = model_.mesh().dim, corners = model_.mesh().corners();
  const auto gather = [&](const ByFreedom& from, MatrixXd& into) {
    into.resize(from.rows(), dim * corners);
    for (int c = 0; c < corners; ++c)
      into.middleCols(dim * c, dim) = from.middleCols(model_.freedom(e, c), dim);
  };
  const auto mass_times = [&](const MatrixXd& x) {  // M for each component
    MatrixXd y = MatrixXd::Zero(x.rows(), x.cols());
    for (int i = 0; i < corners; ++i)
      for (int j = 0; j < corners; ++j)
        y.middleCols(dim * i, dim) += cell.M(i, j) * x.middleCols(dim * j, dim);
    return y;
  };
  const double slope = model_.law().slope(v_[e]);
  MatrixXd u, m, a, b;
  gather(u_, u);
  if (column >= 0) {
    m.resize(1, dim * corners);
    for (int i = 0; i < dim * corners; ++i)
      m(0, i) = mu.u(column, model_.freedom(e, i / dim) + i % dim);
    g.noalias() = -slope * (u * (cell.K * m.transpose()));
  } else {
    gather(mu.u, m);
    g = -slope * (u * cell.K).cwiseProduct(m).rowwise().sum();
  }
  if (!support_.inertia_relief) return;
  gather(cases_.relief, a);
  gather(mu.relief, b);
  if (column >= 0) {
    g.noalias() -= mass_times(a) * m.transpose();
    g.noalias() -= mass_times(u) * b.row(column).transpose();
  } else {
    g -= mass_times(a).cwiseProduct(m).rowwise().sum();
    g -= mass_times(u).cwiseProduct(b).rowwise().sum();
  }
}

void SolidStatics::accumulate(const Solved& mu, int column, const FractionGradient& dv,
                              MatrixXd& out) const {
  VectorXd g;
  for (int e = 0; e < dv.rows(); ++e) {
    FractionGradient::InnerIterator d(dv, e);
    if (!d) continue;
    cell_weights(e, mu, column, g);
    for (; d; ++d) out.col(d.col()) += d.value() * g;
  }
}

MatrixXd SolidStatics::output_gradient(int output, const FractionGradient& dv) const {
  MatrixXd out = MatrixXd::Zero(cases(), dv.cols());
  accumulate(outputs_, output, dv, out);
  return out;
}

MatrixXd SolidStatics::compliance_gradient(const FractionGradient& dv) const {
  MatrixXd out = MatrixXd::Zero(cases(), dv.cols());
  Solved self = cases_;
  self.u = u_;
  accumulate(self, -1, dv, out);
  return out;
}

void SolidStatics::add_adjoint_gradient(const MatrixXd& dS_dq, const FractionGradient& dv,
                                        MatrixXd& out) const {
  accumulate(solve_columns(dS_dq), -1, dv, out);
}

std::string reason(SolidStatus status) {
  switch (status) {
    case SolidStatus::Solved:
      return "solved";
    case SolidStatus::Unsupported:
      return "the supports leave a rigid motion of the part";
    case SolidStatus::NotFinite:
      return "loads, fractions or displacements are not finite numbers";
  }
  return {};
}

}  // namespace liesl
