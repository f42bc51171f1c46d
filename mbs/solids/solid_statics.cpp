#include "mbs/solids/solid_statics.hpp"

#include <tbb/parallel_for.h>

#include <stdexcept>
#include <utility>

#include "mbs/linalg/dense.hpp"

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

SolidStatics::SolidStatics(const SolidModel& model, SolidSupport support, MatrixXd outputs)
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
  TR_ = model.T() * model.rigid_motions();
}

/// Coordinates that keep the part from moving rigidly while reactions are zero: the best
/// conditioned ones where the mass is, so that ersatz material does not carry the round-off.
void SolidStatics::hold_determinately(const SolidModel::Sparse& M) {
  const VectorXd weight = VectorXd(M.diagonal()).cwiseSqrt();
  const Eigen::VectorXi order =
      linalg::pivoted_columns((weight.asDiagonal() * model_.rigid_motions()).transpose()).order;
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
    RMR_inverse_ = linalg::inverse(model_.rigid_motions().transpose() * MR_);
    if (!RMR_inverse_.allFinite()) return SolidStatus::NotFinite;
    hold_determinately(M);
  }
  hold(K_, held_);
  if (!factor_.factor(K_)) return SolidStatus::Unsupported;
  all_.rhs.resize(model_.size(), cases() + outputs());
  all_.rhs << f_, C_;
  solve_columns(all_);
  y_ = C_.transpose() * q();
  return all_.q.allFinite() ? SolidStatus::Solved : SolidStatus::NotFinite;
}

/// Solves for s.rhs, which is overwritten.
void SolidStatics::solve_columns(Solved& s) const {
  const MatrixXd& R = model_.rigid_motions();
  s.acceleration = MatrixXd::Zero(model_.rigid_count(), s.rhs.cols());
  if (support_.inertia_relief) {
    s.acceleration = RMR_inverse_ * (R.transpose() * s.rhs);
    s.rhs.noalias() -= MR_ * s.acceleration;
  }
  for (int c : held_) s.rhs.row(c).setZero();
  s.q = factor_.solve(s.rhs);
  if (support_.inertia_relief) s.q.noalias() -= R * (RMR_inverse_ * (MR_.transpose() * s.q)).eval();
  s.u = model_.T() * s.q;
}

VectorXd SolidStatics::compliance() const { return f_.cwiseProduct(q()).colwise().sum(); }

/// P = s' K mu + M R b, Q = M mu, where b balances the output.
SolidStatics::CellWeights SolidStatics::cell_weights(int e, const double* mu,
                                                     const double* rigid_b) const {
  const int dim = model_.mesh().dim, n = dim * model_.mesh().nodes_per_cell();
  CellVector local(n), rigid(n);
  for (int i = 0; i < n; ++i) {
    const int at = model_.freedom(e, i / dim) + i % dim;
    local[i] = mu[at];
    rigid[i] = rigid_b[at];
  }
  CellWeights w;
  w.P.noalias() = model_.cell(e).K * local;
  w.P *= model_.law().slope(v_[e]);
  if (support_.inertia_relief) {
    w.P.noalias() += model_.cell_mass(e) * rigid;
    w.Q.noalias() = model_.cell_mass(e) * local;
  }
  return w;
}

void SolidStatics::accumulate(const Solved& mu, int column, const FractionGradient& dv,
                              MatrixXd& out) const {
  const int dim = model_.mesh().dim, n = dim * model_.mesh().nodes_per_cell();
  std::vector<int> touched;
  for (int e = 0; e < dv.rows(); ++e)
    if (FractionGradient::InnerIterator(dv, e)) touched.push_back(e);
  std::vector<CellWeights> fixed;  // of the one output, for all cases
  if (column >= 0) {
    const VectorXd b = TR_ * mu.acceleration.col(column);
    for (int e : touched) fixed.push_back(cell_weights(e, mu.u.col(column).data(), b.data()));
  }
  MatrixXd change = MatrixXd::Zero(dv.cols(), cases());  // a case is a column: no two threads meet
  tbb::parallel_for(0, cases(), [&](int k) {
    const VectorXd a = TR_ * all_.acceleration.col(k);
    const VectorXd b = column < 0 ? VectorXd(TR_ * mu.acceleration.col(k)) : VectorXd();
    const double* u = all_.u.col(k).data();
    for (std::size_t t = 0; t < touched.size(); ++t) {
      const int e = touched[t];
      const CellWeights own =
          column < 0 ? cell_weights(e, mu.u.col(k).data(), b.data()) : CellWeights();
      const CellWeights& w = column < 0 ? own : fixed[t];
      double g = 0;
      for (int i = 0; i < n; ++i) {
        const int at = model_.freedom(e, i / dim) + i % dim;
        g -= w.P[i] * u[at];
        if (support_.inertia_relief) g -= w.Q[i] * a[at];
      }
      for (FractionGradient::InnerIterator d(dv, e); d; ++d) change(d.col(), k) += d.value() * g;
    }
  });
  out += change.transpose();
}

MatrixXd SolidStatics::output_gradient(int output, const FractionGradient& dv) const {
  MatrixXd out = MatrixXd::Zero(cases(), dv.cols());
  accumulate(all_, cases() + output, dv, out);
  return out;
}

MatrixXd SolidStatics::compliance_gradient(const FractionGradient& dv) const {
  MatrixXd out = MatrixXd::Zero(cases(), dv.cols());
  accumulate(all_, -1, dv, out);
  return out;
}

void SolidStatics::add_adjoint_gradient(const MatrixXd& dS_dq, const FractionGradient& dv,
                                        MatrixXd& out) const {
  Solved mu;
  mu.rhs = dS_dq;
  solve_columns(mu);
  accumulate(mu, -1, dv, out);
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
