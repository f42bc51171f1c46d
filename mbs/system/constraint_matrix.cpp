#include "mbs/system/constraint_matrix.hpp"

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

constexpr double kPerturbation = 0.02;  // of the mechanism's length
constexpr double kRepeated = 1e-7;  // relative pivots below are those of rows that repeat others
constexpr double kClosed = 1e-9;    // of the mechanism's length
constexpr double kDamping = 1e-12;  // least, of Levenberg and Marquardt
constexpr int kIterations = 30;

}  // namespace

template <FrameGroup G>
ConstraintMatrix<G>::ConstraintMatrix(const Model<G>& model) : model_(model), equations_(model) {
  column_.assign(model.nodes(), -1);
  for (size_t i = 0; i < model.couplings.size(); ++i) {
    const auto& c = model.couplings[i];
    for (const auto* port : {&c.a, &c.b}) {
      if (port->body < 0 || column_[port->node] >= 0) continue;
      column_[port->node] = G::dim * static_cast<int>(nodes_.size());
      nodes_.push_back(port->node);
    }
    for (int k = 0; k < c.constraints && !c.continued; ++k)
      rows_.push_back({static_cast<int>(i), k, c.rows[k].coordinate >= 0});
  }
  J_.setZero(static_cast<long>(rows_.size()), G::dim * static_cast<long>(nodes_.size()));
  phi_.setZero(J_.rows());
}

template <FrameGroup G>
const Eigen::MatrixXd& ConstraintMatrix<G>::evaluate(const State<G>& s) {
  State<G> at = s;
  at.lambda.setZero(model_.constraints());
  equations_.evaluate(at, s.rows, {s.t, 1});
  J_.setZero();
  for (long i = 0; i < J_.rows(); ++i) {
    const Row& row = rows_[i];
    add_gradient(row.coupling, row.equation, J_.row(i));
    const auto next = static_cast<size_t>(row.coupling) + 1;
    if (next < model_.couplings.size() && model_.couplings[next].continued)
      add_gradient(row.coupling + 1, 0, J_.row(i));
    phi_[i] = equations_.gap[model_.couplings[row.coupling].first_constraint + row.equation];
  }
  for (size_t k = 0; k < nodes_.size(); ++k)
    J_.template middleCols<G::rotation_dim>(G::dim * static_cast<long>(k) + G::space_dim) /=
        model_.length;
  return J_;
}

template <FrameGroup G>
void ConstraintMatrix<G>::add_gradient(
    int coupling, int equation, Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> out) {
  const auto& c = model_.couplings[coupling];
  const auto B = equations_.couplings[coupling].B.row(equation);
  if (c.a.body >= 0) out.template segment<G::dim>(column_[c.a.node]) += B.template head<G::dim>();
  if (c.b.body >= 0) out.template segment<G::dim>(column_[c.b.node]) += B.template tail<G::dim>();
}

template <FrameGroup G>
void ConstraintMatrix<G>::move(State<G>& s, const Eigen::VectorXd& step) const {
  Eigen::VectorXd delta = Eigen::VectorXd::Zero(model_.size());
  for (size_t k = 0; k < nodes_.size(); ++k) {
    auto h = delta.segment<G::dim>(G::dim * nodes_[k]);
    h = step.segment<G::dim>(G::dim * static_cast<long>(k));
    h.template tail<G::rotation_dim>() /= model_.length;
  }
  model_.retract(s, delta);
}

/// Levenberg-Marquardt with the square of the residual as damping converges quadratically to
/// solutions where rows repeat each other, too (N. Yamashita, M. Fukushima, On the rate of
/// convergence of the Levenberg-Marquardt method, Computing Suppl. 15 (2001) 239-249).
template <FrameGroup G>
std::optional<State<G>> ConstraintMatrix<G>::perturbed(const State<G>& s, int direction) {
  State<G> at = s;
  const auto joints_alone = [&] {
    evaluate(at);
    for (long i = 0; i < J_.rows(); ++i)
      if (rows_[i].drive) J_.row(i).setZero(), phi_[i] = 0;
  };
  joints_alone();
  Eigen::VectorXd motion(J_.cols());  // not orthogonal to anything in particular
  for (long i = 0; i < motion.size(); ++i)
    motion[i] =
        std::sin(1.0 + 0.7 * static_cast<double>(i) + 1.3 * direction * static_cast<double>(i + 1));
  motion -= linalg::shortest_least_squares(J_, J_ * motion, kRepeated);
  if (motion.norm() < 1e-6) return {};
  const double distance = kPerturbation * model_.length;
  move(at, distance * motion.normalized());
  Eigen::VectorXd moved = distance * motion.normalized();
  for (int i = 0; i < kIterations; ++i) {
    joints_alone();
    if (!phi_.allFinite()) return {};
    if (phi_.lpNorm<Eigen::Infinity>() <= kClosed * model_.length) {
      if (moved.norm() < 0.1 * distance) return {};  // back where it came from
      return at;
    }
    const double damping = phi_.squaredNorm() / (model_.length * model_.length);
    Eigen::MatrixXd JJ = J_ * J_.transpose();
    JJ.diagonal().array() += std::max(damping, kDamping);
    const Eigen::VectorXd step = -J_.transpose() * linalg::LDLT(JJ).solve(phi_);
    move(at, step);
    moved += step;
  }
  return {};
}

template class ConstraintMatrix<SE2>;
template class ConstraintMatrix<SE3>;

}  // namespace liesl
