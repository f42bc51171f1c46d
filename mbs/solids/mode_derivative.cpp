#include "mbs/solids/mode_derivative.hpp"

#include <stdexcept>

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kModeTolerance = 1e-9;  // of the residual in the norm of K^-1
constexpr double kSmallestGap = 1e-6;    // 1 - lambda_k/lambda of what is not kept
constexpr int kMostCorrections = 500;    // corrections; some tens are enough

[[noreturn]] void refuse_pair() {
  throw std::invalid_argument(
      "a mode of a meshed part that is kept has the frequency of one that is not, so that their "
      "span has no derivative: expected one mode more or fewer (`modes`)");
}

/// a_k . b_k of all columns.
VectorXd products(const MatrixXd& a, const MatrixXd& b) {
  return a.cwiseProduct(b).colwise().sum();
}

}  // namespace

ModeDerivative::ModeDerivative(const SolidModel& model, const VectorXd& v, const MatrixXd& basis)
    : v_(v), Psi_(basis), inner_(model.size() - model.rigid_count() * model.ports()) {
  for (int k = 0; k < Psi_.cols(); ++k)
    (Psi_.col(k).tail(Psi_.rows() - inner_).isZero(0) ? modes_ : shapes_).push_back(k);
  K_ = model.stiffness(v).topLeftCorner(inner_, inner_);
  M_ = model.mass(v).topLeftCorner(inner_, inner_);
  Phi_ = Psi_.topRows(inner_)(Eigen::all, modes_);
  MPhi_ = M_.selfadjointView<Eigen::Lower>() * Phi_;
  lambda_ = products(Phi_, K_.selfadjointView<Eigen::Lower>() * Phi_)
                .cwiseQuotient(products(Phi_, MPhi_));
  if (!factor_.factor(K_))
    throw std::runtime_error("the stiffness between the interfaces is not positive definite");
}

MatrixXd ModeDerivative::operator()(const SolidModel& model, const VectorXd& dv) const {
  const MatrixXd dK_Psi = model.stiffness_derivative(v_, dv).selfadjointView<Eigen::Lower>() * Psi_;
  MatrixXd out = MatrixXd::Zero(Psi_.rows(), Psi_.cols());
  if (!shapes_.empty())
    out.topRows(inner_)(Eigen::all, shapes_) =
        -factor_.solve(MatrixXd(dK_Psi.topRows(inner_)(Eigen::all, shapes_)));
  if (modes_.empty()) return out;
  const SolidModel::Sparse dM = model.mass(dv).topLeftCorner(inner_, inner_);
  MatrixXd loads = dM.selfadjointView<Eigen::Lower>() * Phi_;
  loads = loads * lambda_.asDiagonal() - dK_Psi.topRows(inner_)(Eigen::all, modes_);
  out.topRows(inner_)(Eigen::all, modes_) = complement(loads);
  return out;
}

/// (K - lambda_k M) z_k = P loads_k with z_k M-orthogonal to the modes: positive definite there as
/// long as the modes are the lowest ones.
MatrixXd ModeDerivative::complement(const MatrixXd& loads) const {
  const auto preconditioned = [this](const MatrixXd& r) {
    MatrixXd z = factor_.solve(r);
    z -= Phi_ * (MPhi_.transpose() * z);
    return z;
  };
  const auto K = K_.selfadjointView<Eigen::Lower>(), M = M_.selfadjointView<Eigen::Lower>();
  MatrixXd x = MatrixXd::Zero(loads.rows(), loads.cols());
  MatrixXd r = loads - MPhi_ * (Phi_.transpose() * loads);
  MatrixXd z = preconditioned(r), d = z;
  VectorXd now = products(r, z);
  const VectorXd enough = kModeTolerance * kModeTolerance * now;
  for (int n = 0; (now.array() > enough.array()).any(); ++n) {
    MatrixXd A_d = K * d;
    A_d -= (M * d) * lambda_.asDiagonal();
    const VectorXd curvature = products(d, A_d);
    VectorXd length = VectorXd::Zero(now.size());
    for (Eigen::Index k = 0; k < now.size(); ++k)
      if (now[k] > enough[k]) length[k] = now[k] / curvature[k];
    if (n == kMostCorrections || (length.array() < 0).any() || !length.allFinite()) refuse_pair();
    x += d * length.asDiagonal();
    r -= A_d * length.asDiagonal();
    r -= MPhi_ * (Phi_.transpose() * r).eval();
    z = preconditioned(r);
    const VectorXd next = products(r, z);
    d = z + d * next.cwiseQuotient(now.cwiseMax(1e-300)).asDiagonal();
    now = next;
  }
  const VectorXd stiff = products(x, K * x),
                 left = stiff - products(x, M * x).cwiseProduct(lambda_);
  if ((left.array() < kSmallestGap * stiff.array()).any()) refuse_pair();
  return x;
}

}  // namespace liesl
