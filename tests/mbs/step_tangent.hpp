#pragma once
/// @file
/// The iteration matrix of a step against differences of the residual, at a state of a motion.

#include <gtest/gtest.h>

#include "mbs/solvers/dynamics.hpp"
#include "mbs/solvers/iteration_matrix.hpp"

namespace liesl::testing {

/// A model after some steps of a simulation: the last two states and what the last step was made
/// of.
template <FrameGroup G>
class StepTangent {
 public:
  StepTangent(const Model<G>& model, SimulationOptions o, int steps)
      : model_(model), coordinates_(model, false), equations_(model), matrix_(model) {
    o.rescale = false;  // rotation vectors stay those of the step
    s_ = model.initial_state();
    const InitialState start = make_consistent(model, o, s_);
    EXPECT_EQ(start.status, SolveStatus::Converged) << start.reason;
    GeneralizedAlpha<G> integrator(model, o);
    integrator.start(s_);
    double h = o.step;
    for (int i = 0; i < steps; ++i) {
      old_ = s_;
      for (int halved = 0; !integrator.step(s_, h).converged; ++halved, h /= 2)
        if (halved == 8) throw std::runtime_error("the step does not converge");
    }
    weights_ = AlphaWeights(o.rho_inf).at(h);
    coordinates_.difference(old_, s_, dq_);
    coordinates_.rates(s_, u_, udot_);
    equations_.evaluate(s_, s_.q, {s_.t, 1});
    coordinates_.rate_tangents(s_, dq_, u_, udot_, weights_, rates_);
    matrix_.take_prestress(equations_, s_);
    S_ = matrix_.assemble(equations_, s_, {s_.t, 1}, &rates_);
  }

  const Eigen::SparseMatrix<double>& S() const { return S_; }
  IterationMatrix<G>& matrix() { return matrix_; }

  /// [r; phi] of the step whose correction is x = [delta; dlambda].
  Eigen::VectorXd residual(const Eigen::VectorXd& x) {
    Eigen::VectorXd e = Eigen::VectorXd::Zero(model_.size());
    coordinates_.increment(s_, dq_, x.head(model_.size()), e);
    State<G> at = s_;
    coordinates_.place(old_, dq_ + e, u_ + weights_.damping * e, udot_ + weights_.mass * e, at);
    at.lambda += x.tail(model_.constraints());
    equations_.evaluate(at, s_.q, {s_.t, 1});
    Eigen::VectorXd out(x.size());
    out << equations_.r, equations_.phi;
    return out;
  }

  /// Largest error of a column, relative to it: the best of steps 1e-3 ... 1e-7.
  double column_error(int j) {
    double best = 1;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(S_.cols());
    const Eigen::VectorXd column = S_.col(j);
    for (double h = 1e-3; h > 5e-8; h /= 10) {
      x[j] = h;
      const Eigen::VectorXd up = residual(x), down = residual(-x);
      best = std::min(best, ((up - down) / (2 * h) - column).norm() / column.norm());
    }
    return best;
  }

  /// Columns that are unknowns: not of nodes that follow others, nor what pads amplitudes.
  std::vector<int> columns() const {
    std::vector<int> out;
    for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
      const Body<G>& body = *model_.bodies[b];
      const int first = G::dim * model_.first_node(static_cast<int>(b));
      for (int i = 0; i < body.size() - body.padding(); ++i)
        if (body.kind(i / G::dim) != NodeKind::Follower) out.push_back(first + i);
    }
    for (int i = 0; i < model_.constraints(); ++i) out.push_back(model_.size() + i);
    return out;
  }

  /// Every `every`-th column within 1e-7 of its difference.
  void expect_exact(const std::string& what, int every = 1) {
    const std::vector<int> all = columns();
    double worst = 0;
    int at = 0;
    for (std::size_t j = 0; j < all.size(); j += static_cast<std::size_t>(every))
      if (const double error = column_error(all[j]); !(error <= worst)) worst = error, at = all[j];
    EXPECT_LE(worst, 1e-7) << what << ": column " << at << " of " << S_.cols() << " (node "
                           << at / G::dim << ", component " << at % G::dim << ")";
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

}  // namespace liesl::testing
