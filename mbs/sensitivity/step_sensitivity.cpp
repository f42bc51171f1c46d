#include "mbs/sensitivity/step_sensitivity.hpp"

#include <cmath>
#include <stdexcept>

#include "mbs/linalg/block_product.hpp"
#include "mbs/system/penalty.hpp"

namespace liesl {

using Eigen::MatrixXd;

namespace {

constexpr double kShared = 1e-10;  // of B M^-1 B^T: rows that repeat others share forces

/// diag(T_k) x or diag(T_k^T) x.
template <class Blocks>
MatrixXd scaled(const Blocks& T, const MatrixXd& x) {
  constexpr int dim = Blocks::value_type::RowsAtCompileTime;
  MatrixXd y = MatrixXd::Zero(x.rows(), x.cols());
  for (size_t k = 0; k < T.size(); ++k) {
    const auto at = dim * static_cast<Eigen::Index>(k);
    add_block_product(T[k], x, at, y, at);
  }
  return y;
}
template <class Blocks>
MatrixXd scaled_transposed(const Blocks& T, const MatrixXd& x) {
  constexpr int dim = Blocks::value_type::RowsAtCompileTime;
  MatrixXd y = MatrixXd::Zero(x.rows(), x.cols());
  for (size_t k = 0; k < T.size(); ++k) {
    const auto at = dim * static_cast<Eigen::Index>(k);
    add_block_product(T[k].transpose(), x, at, y, at);
  }
  return y;
}

/// The least compliance with which rows of joints that repeat others share forces: a share of
/// the largest sum of B_ij^2/M_jj.
double little_compliance(const Eigen::SparseMatrix<double>& start, Eigen::Index n) {
  const Eigen::VectorXd M = start.diagonal();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(start.rows());
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(start, j); it; ++it)
      if (it.row() >= n && M[j] > 0) sum[it.row()] += it.value() * it.value() / M[j];
  return kShared * sum.maxCoeff();
}

}  // namespace

StateSensitivity StateSensitivity::zero(int n, int m, int columns) {
  const MatrixXd none = MatrixXd::Zero(n, columns);
  return {none, none, none, none, MatrixXd::Zero(m, columns)};
}

StateSensitivity& StateSensitivity::operator+=(const StateSensitivity& other) {
  eta += other.eta;
  v += other.v;
  a += other.a;
  w += other.w;
  lambda += other.lambda;
  return *this;
}

MatrixXd StateSensitivity::transposed_product(const StateSensitivity& cotangents) const {
  return eta.transpose() * cotangents.eta + v.transpose() * cotangents.v +
         a.transpose() * cotangents.a + w.transpose() * cotangents.w +
         lambda.transpose() * cotangents.lambda;
}

template <FrameGroup G>
StepSensitivity<G>::StepSensitivity(const Model<G>& model, double rho_inf)
    : model_(model),
      weights_(rho_inf),
      damping_(damping_of_penalties(model)),
      coordinates_(model, false),
      equations_(model),
      matrix_(model),
      before_(model),
      after_(model) {
  if (model.penalty.form == ConstraintForm::Augmented && !model.redundant.empty())
    throw std::invalid_argument(
        "there are no sensitivities where augmented penalties share the forces of rows that repeat "
        "others: simulation.constraints = \"penalty\" has them, and \"multipliers\" leaves the "
        "rows "
        "out; " +
        model.redundant.front());
}

template <FrameGroup G>
bool StepSensitivity<G>::linearise(const State<G>& s, const Eigen::VectorXd& previous,
                                   const RateTangents<G>& rates, bool factor) {
  equations_.damping = at_start_ ? 0 : damping_;
  equations_.evaluate_couplings(s, previous, {s.t, 1});
  matrix_.take_own_stress(equations_);
  matrix_.assemble(equations_, s, {s.t, 1}, &rates);
  return !factor || matrix_.factor_kept();
}

/// [M B^T; B 0], nodes that follow others held by the identity. Where rows repeat others it is
/// factored with a little compliance, which refinement takes out again.
template <FrameGroup G>
bool StepSensitivity<G>::start(const State<G>& s) {
  at_start_ = true;
  in_equilibrium_ = false;
  const auto n = static_cast<size_t>(model_.nodes());
  rates_.v.assign(n, G::Matrix::Zero());
  rates_.vdot.assign(n, G::Matrix::Zero());
  linearise(s, s.rows, rates_, false);
  const auto& S = matrix_.matrix();
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < S.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(S, j); it; ++it)
      if ((it.row() >= model_.size()) != (it.col() >= model_.size()))
        entries.emplace_back(it.row(), it.col(), it.value());
  std::vector<bool> held(static_cast<size_t>(model_.size()), true);
  const auto& M = matrix_.mass();
  for (int j = 0; j < M.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(M, j); it; ++it) {
      entries.emplace_back(it.row(), it.col(), it.value());
      held[static_cast<size_t>(it.row())] = false;
    }
  for (int i = 0; i < model_.size(); ++i)
    if (held[static_cast<size_t>(i)]) entries.emplace_back(i, i, 1);
  start_matrix_.resize(S.rows(), S.cols());
  start_matrix_.setFromTriplets(entries.begin(), entries.end());
  start_lu_ = SparseLu();
  if (model_.penalty.form == ConstraintForm::Multipliers || model_.redundant.empty())
    return start_lu_.factor(start_matrix_);
  const double little = little_compliance(start_matrix_, model_.size());
  for (int i = model_.size(); i < S.rows(); ++i) entries.emplace_back(i, i, -little);
  Eigen::SparseMatrix<double> shared(S.rows(), S.cols());
  shared.setFromTriplets(entries.begin(), entries.end());
  return start_lu_.factor(shared);
}

template <FrameGroup G>
bool StepSensitivity<G>::equilibrium(const State<G>& s, const LoadLevel& level) {
  at_start_ = in_equilibrium_ = true;
  equations_.damping = 0;
  equations_.evaluate_couplings(s, s.rows, level);
  matrix_.take_prestress(equations_, s);
  start_matrix_ = matrix_.assemble(equations_, s, level);
  start_lu_ = SparseLu();
  return start_lu_.factor(start_matrix_);
}

template <FrameGroup G>
bool StepSensitivity<G>::step(const State<G>& before, const State<G>& after, double h,
                              bool factor) {
  if (model_.update != NodeUpdate::RotationVector) return linearise_step(before, after, h, factor);
  State<G> reached = after;
  undo_rescale(model_, coordinates_, before, reached);
  return linearise_step(before, reached, h, factor);
}

template <FrameGroup G>
bool StepSensitivity<G>::linearise_step(const State<G>& before, const State<G>& after, double h,
                                        bool factor) {
  at_start_ = false;
  h_ = h;
  Eigen::VectorXd dq, u, udot;
  coordinates_.difference(before, after, dq);
  coordinates_.rates(after, u, udot);
  Eigen::VectorXd u_before, udot_before;
  coordinates_.rates(before, u_before, udot_before);
  const auto& [am, af, gamma, beta] = weights_;
  by_step_a_ = u_before / (beta * h) - 2 * dq / (beta * h * h);
  by_step_v_ = h * (1 - gamma) * before.a + h * gamma * (after.a + by_step_a_);
  coordinates_.increments(after, dq, ahead_);
  if (model_.update == NodeUpdate::Screw) {
    take_screws(dq);
  } else {
    coordinates_.rate_tangents(after, dq, u, udot, weights_.at(h), rates_);
    coordinates_.increments(before, -dq, back_);
    before_.take(coordinates_, before);
    after_.take(coordinates_, after);
  }
  return linearise(after, before.rows, rates_, factor);
}

/// T^-1(-dq) = T^-1(dq) - ad(dq); rates follow the frames by gamma' T^-1(dq), beta' T^-1(dq).
template <FrameGroup G>
void StepSensitivity<G>::take_screws(const Eigen::VectorXd& dq) {
  const TangentWeights w = weights_.at(h_);
  rates_.v = rates_.vdot = back_ = ahead_;
  for (auto& T : rates_.v) T *= w.damping;
  for (auto& T : rates_.vdot) T *= w.mass;
  for (const int k : model_.frames()) back_[k] -= G::ad(dq.template segment<dim>(dim * k));
}

template <FrameGroup G>
void StepSensitivity<G>::take_known(const StateSensitivity& local, Known& k) const {
  const auto& [am, af, gamma, beta] = weights_;
  StateSensitivity copy;
  if (model_.update != NodeUpdate::Screw) {
    copy = local;
    before_.to_coordinates(copy);
  }
  const StateSensitivity& s = model_.update == NodeUpdate::Screw ? local : copy;
  k.x0 = scaled(back_, s.eta);
  k.a0 = -s.v / (beta * h_) - (1 / (2 * beta) - 1) * s.a;
  k.v0 = (1 - gamma / beta) * s.v + h_ * (1 - gamma / (2 * beta)) * s.a;
  k.w0 = ((1 - am) * k.a0 + am * s.a - af * s.w) / (1 - af);
}

template <FrameGroup G>
StateSensitivity StepSensitivity<G>::lag(const StateSensitivity& before,
                                         const StateSensitivity& after) const {
  const TangentWeights w = weights_.at(h_);
  Known k;
  take_known(before, k);
  const MatrixXd x = scaled(ahead_, after.eta) - k.x0;
  StateSensitivity out;
  out.a = x / (weights_.beta * h_ * h_) + k.a0 - after.a;
  out.v = w.damping * x + k.v0 - after.v;
  out.w = w.mass * x + k.w0 - after.w;
  return out;
}

template <FrameGroup G>
void StepSensitivity<G>::add_step(const ResidualDerivative& by_p, Known& k) const {
  if (by_p.lag) {
    k.a0 += by_p.lag->a;
    k.v0 += by_p.lag->v;
    k.w0 += by_p.lag->w;
  }
  if (by_p.step.size() == 0) return;
  k.a0 += by_step_a_ * by_p.step;
  k.v0 += by_step_v_ * by_p.step;
  k.w0 += (1 - weights_.alpha_m) / (1 - weights_.alpha_f) * by_step_a_ * by_p.step;
}

template <FrameGroup G>
void StepSensitivity<G>::take_at_held_frames(const Known& k, RateChange& change) const {
  const TangentWeights w = weights_.at(h_);
  change.v = k.v0 - w.damping * k.x0;
  change.vdot = k.w0 - w.mass * k.x0;
  after_.at_held_frames(change.v, change.vdot);
}

template <FrameGroup G>
template <class F>
void StepSensitivity<G>::each_damped_block(F f) const {
  for (size_t k = 0; k < model_.couplings.size() && damping_ > 0; ++k) {
    const auto& c = model_.couplings[k];
    const auto B = equations_.couplings[k].B.topRows(c.constraints);
    if (c.a.body >= 0) f(c.first_constraint, dim * c.a.node, damping_ * B.template leftCols<dim>());
    if (c.b.body >= 0)
      f(c.first_constraint, dim * c.b.node, damping_ * B.template rightCols<dim>());
  }
}

template <FrameGroup G>
void StepSensitivity<G>::finish(const Known& k, const MatrixXd& solution,
                                StateSensitivity& s) const {
  const TangentWeights w = weights_.at(h_);
  s.eta = solution.topRows(model_.size());
  s.lambda = solution.bottomRows(model_.constraints());
  const MatrixXd x = scaled(ahead_, s.eta) - k.x0;
  s.a = x / (weights_.beta * h_ * h_) + k.a0;
  s.v = w.damping * x + k.v0;
  s.w = w.mass * x + k.w0;
  after_.to_local(s);
}

template <FrameGroup G>
bool StepSensitivity<G>::solve(MatrixXd& x) {
  return refined_.solve_kept(matrix_.lu(), matrix_.matrix(), false, model_.size(), x);
}

template <FrameGroup G>
bool StepSensitivity<G>::forward(const ResidualDerivative& by_p, StateSensitivity& s) {
  if (at_start_) return start_forward(by_p, s);
  take_known(s, known_);
  add_step(by_p, known_);
  take_at_held_frames(known_, change_);
  const auto n = model_.size();
  force_ = by_p.r;
  matrix_.add_mass_product(change_.vdot, false, force_);
  matrix_.add_damping_product(change_.v, false, force_);
  rhs_.resize(n + model_.constraints(), by_p.r.cols());
  rhs_ << -force_, -by_p.phi;
  each_damped_block([&](int row, int column, const auto& block) {
    rhs_.middleRows(n + row, block.rows()) -= block * change_.v.template middleRows<dim>(column);
  });
  if (!solve(rhs_)) return false;
  finish(known_, rhs_, s);
  return true;
}

template <FrameGroup G>
bool StepSensitivity<G>::backward(const ResidualDerivative& by_p, StateSensitivity& s,
                                  MatrixXd& p) {
  if (at_start_) return start_backward(by_p, s, p);
  const auto& [am, af, gamma, beta] = weights_;
  const TangentWeights w = weights_.at(h_);
  const auto n = model_.size(), m = model_.constraints();
  after_.to_local_transposed(s);
  const MatrixXd x = s.a / (beta * h_ * h_) + w.damping * s.v + w.mass * s.w;
  MatrixXd rhs(n + m, x.cols());
  rhs << s.eta + scaled_transposed(ahead_, x), s.lambda;
  if (!refined_.solve_kept(matrix_.lu(), matrix_.matrix(), true, n, rhs)) return false;
  const MatrixXd mu = rhs.topRows(n);
  MatrixXd Mmu = MatrixXd::Zero(n, mu.cols()), Cmu = Mmu;
  matrix_.add_mass_product(mu, true, Mmu);
  matrix_.add_damping_product(mu, true, Cmu);
  each_damped_block([&](int row, int column, const auto& block) {
    Cmu.template middleRows<dim>(column) +=
        block.transpose() * rhs.middleRows(n + row, block.rows());
  });
  after_.at_held_frames_transposed(Cmu, Mmu);
  p -= by_p.r.transpose() * mu + by_p.phi.transpose() * rhs.bottomRows(m);
  const MatrixXd w0 = s.w - Mmu, v0 = s.v - Cmu, a0 = s.a + (1 - am) / (1 - af) * w0;
  if (by_p.lag)
    p +=
        by_p.lag->a.transpose() * s.a + by_p.lag->v.transpose() * v0 + by_p.lag->w.transpose() * w0;
  if (by_p.step.size() > 0)
    p += by_p.step.transpose() * (by_step_a_.transpose() * a0 + by_step_v_.transpose() * v0);
  s.eta = scaled_transposed(back_, w.mass * Mmu + w.damping * Cmu - x);
  s.a = am / (1 - af) * w0 + h_ * (1 - gamma / (2 * beta)) * v0 - (1 / (2 * beta) - 1) * a0;
  s.v = (1 - gamma / beta) * v0 - a0 / (beta * h_);
  s.w = -af / (1 - af) * w0;
  s.lambda.setZero();
  before_.to_coordinates_transposed(s);
  return p.allFinite();
}

/// M w' + B^T lambda' = -r_p, B w' = -d^2/dt^2 Phi_p, a' = w': positions and velocities are those
/// of the scene; or the equilibrium.
template <FrameGroup G>
bool StepSensitivity<G>::start_forward(const ResidualDerivative& by_p, StateSensitivity& s) {
  const auto n = model_.size(), m = model_.constraints();
  MatrixXd rhs(n + m, by_p.r.cols());
  rhs << -MatrixXd(by_p.r), -by_p.phi;
  if (!refined_.solve(start_lu_, start_matrix_, false, n, rhs)) return false;
  s = StateSensitivity::zero(n, m, static_cast<int>(rhs.cols()));
  (in_equilibrium_ ? s.eta : s.w) = rhs.topRows(n);
  s.a = s.w;
  s.lambda = rhs.bottomRows(m);
  return true;
}

template <FrameGroup G>
bool StepSensitivity<G>::start_backward(const ResidualDerivative& by_p, StateSensitivity& s,
                                        MatrixXd& p) {
  const auto n = model_.size(), m = model_.constraints();
  MatrixXd rhs(n + m, s.w.cols());
  rhs << (in_equilibrium_ ? s.eta : MatrixXd(s.w + s.a)), s.lambda;
  if (!refined_.solve(start_lu_, start_matrix_, true, n, rhs)) return false;
  p -= by_p.r.transpose() * rhs.topRows(n) + by_p.phi.transpose() * rhs.bottomRows(m);
  s = StateSensitivity::zero(n, m, static_cast<int>(rhs.cols()));
  return p.allFinite();
}

template class StepSensitivity<SE2>;
template class StepSensitivity<SE3>;

}  // namespace liesl
