/// @file
/// The linear absorber, optimised on its motion: peaks of the simulation and their gradients by
/// sensitivities, given to the optimisers as they are.

#include <gtest/gtest.h>

#include "mbs/sensitivity/motion_sensitivity.hpp"
#include "mbs/solvers/dynamics.hpp"
#include "optim/nlp/nlopt_driver.hpp"
#include "reference/published_sensitivities.hpp"

namespace liesl::test::linear_absorber_test {
namespace {

using Eigen::VectorXd;

/// min max|x''| over k and c, max|x| <= 1.
class Absorber : public Problem {
 public:
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }

  void values(const VectorXd& p, double& f, VectorXd& g) override {
    ++simulations;
    const Mechanism m = LinearAbsorber::make(p[0], p[1]);
    const auto model = Model<SE3>::build(m, Space<SE3>{});
    SimulationOptions options;
    options.duration = 6;
    options.step = 5e-3;
    options.rho_inf = 1;
    options.tolerance = 1e-10;
    Tape<SE3> tape;
    simulate(model, options, {}, &tape);
    Parameters<SE3> parameters;
    parameters.emplace_back(m, model, Parameter{"k", {ForceDerivative{0, 1}}});
    parameters.emplace_back(m, model, Parameter{"c", {ForceDerivative{0, 0, 1}}});
    double peak[] = {0, 0};
    const auto end = direct_sensitivity<SE3>(
        model, tape, parameters, [&](long, const State<SE3>& s, const StateSensitivity& ds) {
          const double y[] = {s.vdot[0], s.H[0].x[0]};
          const Eigen::RowVector2d dy[] = {ds.w.row(0), ds.eta.row(0)};
          for (int i : {0, 1})
            if (std::abs(y[i]) > peak[i]) {
              peak[i] = std::abs(y[i]);
              gradient_[i] = (y[i] > 0 ? 1 : -1) * dy[i];
            }
        });
    EXPECT_TRUE(end.complete()) << end.reason;
    f = peak[0];
    g[0] = peak[1] - 1;
  }
  void gradients(const VectorXd&, VectorXd& df, RowMatrix& dg) override {
    df = gradient_[0].transpose();
    dg.row(0) = gradient_[1];
  }
  int simulations = 0;

 private:
  std::vector<NlpVariable> variables_{{"k", 0.05, 2, 0.8}, {"c", 0.05, 2, 0.9}};
  std::vector<NlpConstraint> constraints_{{1, "displacement", 1}};
  Eigen::RowVector2d gradient_[2];
};

void expect_published(const NlpResult& r) {
  EXPECT_NEAR(r.f, LinearAbsorber::kAcceleration, 1e-4) << r.brief();
  EXPECT_NEAR(r.x[0], LinearAbsorber::kStiffness, 2e-3);
  EXPECT_NEAR(r.x[1], LinearAbsorber::kDamping, 2e-3);
  EXPECT_LT(r.violation, 1e-5);
}

NlpOptions moderate() {
  NlpOptions o;
  o.tolerance = 1e-6;
  o.feasibility = 1e-6;
  o.max_iterations = 60;
  return o;
}

TEST(LinearAbsorberOptimum, BySlsqpAndMma) {
  Absorber slsqp, mma;
  expect_published(solve_nlopt(slsqp, NloptMethod::Slsqp, moderate()));
  expect_published(solve_nlopt(mma, NloptMethod::Mma, moderate()));
  RecordProperty("simulations",
                 std::to_string(slsqp.simulations) + ", " + std::to_string(mma.simulations));
}

}  // namespace
}  // namespace liesl::test::linear_absorber_test
