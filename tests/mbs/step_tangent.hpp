#pragma once
/// @file
/// The iteration matrix against differences of the residual: of a step at a state of a motion, and
/// of statics; its solutions against its transposed solutions.

#include <gtest/gtest.h>

#include "mbs/run.hpp"
#include "mbs/solvers/dynamics.hpp"
#include "mbs/solvers/iteration_matrix.hpp"

namespace liesl::test {

/// Columns that are unknowns: not of nodes that follow others, nor turns of positions, nor what
/// pads amplitudes.
template <FrameGroup G>
std::vector<int> unknowns(const Model<G>& model) {
  std::vector<int> out;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body<G>& body = *model.bodies[b];
    const int first = G::dim * model.first_node(static_cast<int>(b));
    for (int i = 0; i < body.size() - body.padding(); ++i) {
      const NodeKind kind = body.kind(i / G::dim);
      const bool held = kind == NodeKind::Position && i % G::dim >= G::space_dim;
      if (kind != NodeKind::Follower && !held) out.push_back(first + i);
    }
  }
  for (int i = 0; i < model.constraints(); ++i) out.push_back(model.size() + i);
  return out;
}

/// Error of column j of A against differences of the residual, relative to the column (absolute if
/// it is zero, up to rounding of the matrix): the best of the steps h = 1e-1 ... 1e-10, and of
/// their extrapolations to h = 0 (Richardson), which are of order h^2, h^4 ... h^12. Rounding
/// leaves eps F/h, F what cancels in the residual: across a wire, axial forces of 1e8 times the
/// bending stiffness, so that differences of order 2 have no step with 1e-7.
template <class Residual>
double column_error(const Eigen::SparseMatrix<double>& A, int j, const Residual& residual) {
  constexpr int kOrders = 6;
  double best = 1;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  const Eigen::VectorXd column = A.col(j);
  const double zero = 1e-15 * A.norm();
  const double size = column.norm() > zero ? column.norm() : 1;
  std::vector<Eigen::VectorXd> coarser;  // by order, of the step before
  for (double h = 0.1; h > 5e-11; h /= std::sqrt(10.)) {
    x[j] = h;
    const Eigen::VectorXd up = residual(x), down = residual(-x);
    std::vector<Eigen::VectorXd> now = {(up - down) / (2 * h)};
    double power = 10;
    for (std::size_t k = 0; k < coarser.size() && k + 1 < kOrders; ++k, power *= 10)
      now.push_back(now[k] + (now[k] - coarser[k]) / (power - 1));
    for (const Eigen::VectorXd& slope : now) best = std::min(best, (slope - column).norm() / size);
    coarser = std::move(now);
  }
  return best;
}

/// At most about `most` columns, spread over all, within 1e-7 of their differences.
template <class Residual>
void expect_derivative(const Eigen::SparseMatrix<double>& A, const std::vector<int>& columns,
                       int most, const Residual& residual, const std::string& what) {
  ASSERT_FALSE(columns.empty()) << what;
  const std::size_t every = std::max<std::size_t>(1, columns.size() / std::size_t(most));
  double worst = 0;
  int at = 0;
  for (std::size_t j = 0; j < columns.size(); j += every)
    if (const double error = column_error(A, columns[j], residual); !(error <= worst))
      worst = error, at = columns[j];
  EXPECT_LE(worst, 1e-7) << what << ": column " << at << " of " << A.cols();
}

constexpr int kAllColumns = 1 << 30;

/// The matrix of statics at a state at rest. @param columns of it, if not all unknowns
template <FrameGroup G>
void expect_exact_statics(const Model<G>& model, const State<G>& s, const LoadLevel& level,
                          const std::string& what, int most = kAllColumns,
                          const std::vector<int>& columns = {}) {
  State<G> still = s;
  still.v.setZero();
  still.vdot.setZero();
  Equations<G> equations(model);
  equations.evaluate(still, s.rows, level);
  IterationMatrix<G> statics(model);
  statics.take_prestress(equations, still);
  const Eigen::SparseMatrix<double> K = statics.assemble(equations, still, level);
  const auto residual = [&](const Eigen::VectorXd& x) {
    State<G> at = still;
    model.retract(at, x.head(model.size()));
    at.lambda += x.tail(model.constraints());
    equations.evaluate(at, s.rows, level);
    Eigen::VectorXd out(x.size());
    out << equations.r, equations.phi;
    return out;
  };
  expect_derivative(K, columns.empty() ? unknowns(model) : columns, most, residual,
                    what + ", statics");
}

/// A model after some steps of a simulation: the last two states and what the last step was made
/// of.
template <FrameGroup G>
class StepTangent {
 public:
  /// @param damping of penalties, tau
  StepTangent(const Model<G>& model, SimulationOptions o, int steps, double damping = 0)
      : model_(model), coordinates_(model, false), equations_(model), matrix_(model) {
    o.rescale = false;  // rotation vectors stay those of the step
    s_ = model.initial_state();
    const InitialState start = make_consistent(model, o, s_);
    if (start.status != SolveStatus::Converged) throw std::runtime_error(start.reason);
    GeneralizedAlpha<G> integrator(model, o);
    integrator.start(s_);
    double h = o.step;
    for (int i = 0; i < steps; ++i) {
      old_ = s_;
      for (int halved = 0; !integrator.step(s_, h).converged; ++halved, h /= 2)
        if (halved == 8) throw std::runtime_error("the step does not converge");
    }
    for (const int k : model.positions()) {  // axes as they were held
      const auto Q = (old_.H[k].R.transpose() * s_.H[k].R).eval();
      for (auto* x : {&s_.v, &s_.vdot})
        x->template segment<G::space_dim>(G::dim * k) =
            (Q * x->template segment<G::space_dim>(G::dim * k)).eval();
      s_.H[k].R = old_.H[k].R;
    }
    equations_.damping = damping;
    weights_ = AlphaWeights(o.rho_inf).at(h);
    coordinates_.difference(old_, s_, dq_);
    coordinates_.rates(s_, u_, udot_);
    equations_.evaluate(s_, s_.rows, {s_.t, 1});
    coordinates_.rate_tangents(s_, dq_, u_, udot_, weights_, rates_);
    matrix_.take_prestress(equations_, s_);
    S_ = matrix_.assemble(equations_, s_, {s_.t, 1}, &rates_);
  }

  const State<G>& state() const { return s_; }
  const Eigen::SparseMatrix<double>& S() const { return S_; }
  IterationMatrix<G>& matrix() { return matrix_; }

  /// [r; phi] of the step whose correction is x = [delta; dlambda].
  Eigen::VectorXd residual(const Eigen::VectorXd& x) {
    Eigen::VectorXd e = Eigen::VectorXd::Zero(model_.size());
    coordinates_.increment(s_, dq_, x.head(model_.size()), e);
    State<G> at = s_;
    coordinates_.place(old_, dq_ + e, u_ + weights_.damping * e, udot_ + weights_.mass * e, at);
    at.lambda += x.tail(model_.constraints());
    equations_.evaluate(at, s_.rows, {s_.t, 1});
    Eigen::VectorXd out(x.size());
    out << equations_.r, equations_.phi;
    return out;
  }

  void expect_exact(const std::string& what, int most = kAllColumns) {
    expect_derivative(
        S_, unknowns(model_), most, [this](const Eigen::VectorXd& x) { return residual(x); }, what);
  }

  /// S x = a and S^T y = b: <x, b> = <a, y> within what rounding leaves of backward stable
  /// solutions, |y|^T (|S| |x| + |a|) and |x|^T (|S^T| |y| + |b|).
  /// @param refined one step of iterative refinement before (Skeel 1980, Math. Comp. 35)
  void expect_transposed(const std::string& what, bool refined = false) {
    ASSERT_TRUE(matrix_.factor()) << what;
    Random random{5};
    const int n = static_cast<int>(S_.rows());
    const Eigen::VectorXd a = random.vector(n), b = random.vector(n);
    Eigen::MatrixXd x = a, y = b;
    matrix_.lu().solve(x);
    matrix_.lu().solve_transposed(y);
    if (refined) {
      Eigen::MatrixXd dx = a - S_ * x, dy = b - S_.transpose() * y;
      matrix_.lu().solve(dx);
      matrix_.lu().solve_transposed(dy);
      x += dx;
      y += dy;
    }
    const Eigen::SparseMatrix<double> size = S_.cwiseAbs();
    const double bound =
        y.col(0).cwiseAbs().dot(size * x.cwiseAbs().col(0) + a.cwiseAbs()) +
        x.col(0).cwiseAbs().dot(size.transpose() * y.cwiseAbs().col(0) + b.cwiseAbs());
    EXPECT_LE(std::abs(x.col(0).dot(b) - y.col(0).dot(a)), 1e-12 * bound) << what;
  }

 private:
  const Model<G>& model_;
  NodeCoordinates<G> coordinates_;
  Equations<G> equations_;
  IterationMatrix<G> matrix_;
  State<G> old_, s_;
  TangentWeights weights_;
  Eigen::VectorXd dq_, u_, udot_;
  RateTangents<G> rates_;
  Eigen::SparseMatrix<double> S_;
};

}  // namespace liesl::test
