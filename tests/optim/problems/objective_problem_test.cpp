/// @file
/// Efforts near a design, by the responses to first order.

#include "optim/problems/objective_problem.hpp"

#include <gtest/gtest.h>

#include "optim/nlp/check_derivatives.hpp"

namespace liesl::test::objective_problem_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Torques v = (T_0/T)^2 (a + B y) at records with weights, and variables x = [y; T].
struct Torques {
  static constexpr int records = 12, tables = 3;
  const double T_0 = 0.6;
  VectorXd a = VectorXd::Random(records), w = VectorXd::Random(records).cwiseAbs();
  MatrixXd B = MatrixXd::Random(records, tables);

  VectorXd at(const VectorXd& x) const {
    const double ratio = T_0 / x[tables];
    return ratio * ratio * (a + B * x.head(tables));
  }
  MatrixXd by(const VectorXd& x) const {
    MatrixXd d(records, tables + 1);
    const double ratio = T_0 / x[tables];
    d << ratio * ratio * B, -2 / x[tables] * at(x);
    return d;
  }
  double effort(const VectorXd& x) const { return x[tables] * w.dot(at(x).cwiseAbs2()); }
  ObjectiveProblem problem(const VectorXd& x) const {
    const MatrixXd d = by(x);
    VectorXd by_effort = 2 * x[tables] * d.transpose() * w.cwiseProduct(at(x));
    by_effort[tables] += effort(x) / x[tables];
    const MatrixXd curvature = x[tables] * d.transpose() * w.asDiagonal() * d;
    std::vector<NlpVariable> variables;
    for (int i = 0; i < tables; ++i)
      variables.push_back({"y" + std::to_string(i), x[i] - 1, x[i] + 1, x[i]});
    variables.push_back({"T", 0.3, 1.2, x[tables]});
    return ObjectiveProblem({tables, 3, 2, effort(x), by_effort, curvature, 5}, x, variables);
  }
  double objective(const VectorXd& x) const { return 5 + 3 * x[tables] + 2 * effort(x); }
};

double value(ObjectiveProblem& problem, const VectorXd& x) {
  double f = 0;
  VectorXd none;
  problem.values(x, f, none);
  return f;
}

const VectorXd kDesign = (VectorXd(4) << 0.3, -0.2, 0.5, 0.7).finished();

/// Exact in values of tables, which torques are linear in, and in the duration by itself.
TEST(ObjectiveProblem, IsExactInTablesAndInTheDuration) {
  const Torques torques;
  ObjectiveProblem problem = torques.problem(kDesign);
  EXPECT_NEAR(value(problem, kDesign), torques.objective(kDesign), 1e-12);
  VectorXd tables = kDesign, duration = kDesign;
  tables.head(3) += VectorXd::Constant(3, 0.4);
  duration[3] = 1.1;
  EXPECT_NEAR(value(problem, tables), torques.objective(tables), 1e-12);
  EXPECT_NEAR(value(problem, duration), torques.objective(duration), 1e-12);
}

TEST(ObjectiveProblem, DifferentiatesRight) {
  const Torques torques;
  ObjectiveProblem problem = torques.problem(kDesign);
  DerivativeCheckOptions options;
  options.every_variable = true;
  const VectorXd away = kDesign + (VectorXd(4) << 0.1, -0.2, 0.15, 0.1).finished();
  const DerivativeReport report = check_derivatives(problem, away, options);
  EXPECT_TRUE(report.right) << report.text();
}

}  // namespace
}  // namespace liesl::test::objective_problem_test
