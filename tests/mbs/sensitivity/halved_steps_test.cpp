/// @file
/// Derivatives of motions whose steps are halved or adaptive, where they are made from checkpoints
/// of every fifth step: those of the steps that were taken, that other parameters may not take. So
/// differences are of motions on the same steps.

#include <algorithm>

#include "mbs/sensitivity/forms.hpp"
#include "mbs/solvers/initial_state.hpp"

namespace liesl::test::halved_steps_test {
namespace {

constexpr int kEvery = 5;

/// Corrections, of which long steps at the start and of the fast crank need more.
SimulationOptions few_corrections(double duration) {
  auto o = tight(duration, 8e-4);
  o.max_iterations = 4;
  return o;
}

SimulationOptions adaptive(double duration) {
  auto o = tight(duration, 8e-4);
  o.adaptive = true;
  o.error_tolerance = 1e-5;
  o.step_min = 2e-4;  // of shorter ones differences have the round-off
  return o;
}

/// Outputs [size x steps + 1] of a mechanism on the steps that another motion took.
template <class G>
MatrixXd on_steps_of(const Tape<G>& tape, const Mechanism& m, const Outputs<G>& outputs) {
  const auto model = Model<G>::build(m, space_of<G>(m));
  SimulationOptions o = tape.options;
  o.max_iterations = 40;
  State<G> s = model.initial_state();
  make_consistent(model, o, s);
  GeneralizedAlpha<G> integrator(model, o);
  integrator.start(s);
  MatrixXd y(outputs.size(), tape.steps() + 1);
  Eigen::Index n = 0;
  y.col(n) = outputs.values(s);
  for (const Attempt& attempt : tape.attempts) {
    if (!attempt.accepted) continue;
    EXPECT_TRUE(integrator.step(s, attempt.h).converged) << attempt.t;
    s.t = attempt.t;
    y.col(++n) = outputs.values(s);
  }
  return y;
}

template <class G>
class HalvedSteps : public ::testing::Test {
 protected:
  const Mechanism machine = sensitive_machine();
  const std::vector<Quantity> all = quantities(machine);

  /// A motion some of whose steps were halved, and others not.
  Taped<G> halved(double duration) const {
    Taped<G> run(machine, few_corrections(duration), kEvery);
    EXPECT_GT(run.run.report.rejected_steps, 0);
    const auto& attempts = run.tape.attempts;
    const auto whole = std::count_if(attempts.begin(), attempts.end(), [&](const Attempt& a) {
      return a.accepted && a.h == run.tape.options.step;
    });
    EXPECT_GT(whole, 0);
    EXPECT_LT(whole, run.tape.steps());
    return run;
  }
  /// A motion some of whose steps were refused for their error.
  Taped<G> adapted(double duration) const {
    Taped<G> run(machine, adaptive(duration), kEvery);
    EXPECT_GT(run.run.report.refused_steps, 0);
    EXPECT_LT(run.run.report.smallest_step, run.tape.options.step);
    return run;
  }
};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(HalvedSteps, Groups);

TYPED_TEST(HalvedSteps, DirectEqualsAdjoint) {
  for (const double duration : {0.008, 0.04, 0.28})  // 14, 85 and 1158 steps
    expect_direct_equals_adjoint<TypeParam>(this->halved(duration), this->all);
}

TYPED_TEST(HalvedSteps, EqualDifferencesOnTheSameSteps) {
  using G = TypeParam;
  const Taped<G> run = this->halved(0.024);
  const Outputs<G> outputs(run.model);
  expect_differences<G>(run, this->all, {.linear = kLoadsOfTheMachine},
                        [&](std::size_t p, double change) {
                          Mechanism changed = this->machine;
                          this->all[p].set(changed, this->all[p].nominal * (1 + change));
                          return on_steps_of(run.tape, changed, outputs);
                        });
}

TYPED_TEST(HalvedSteps, DirectEqualsAdjointOnAdaptiveSteps) {
  expect_direct_equals_adjoint<TypeParam>(this->adapted(0.04), this->all);
}

TYPED_TEST(HalvedSteps, EqualDifferencesOnTheSameAdaptiveSteps) {
  using G = TypeParam;
  const Taped<G> run = this->adapted(0.024);
  const Outputs<G> outputs(run.model);
  expect_differences<G>(run, this->all, {.linear = kLoadsOfTheMachine},
                        [&](std::size_t p, double change) {
                          Mechanism changed = this->machine;
                          this->all[p].set(changed, this->all[p].nominal * (1 + change));
                          return on_steps_of(run.tape, changed, outputs);
                        });
}

/// What differences are taken of: with nothing changed, the motion itself.
TYPED_TEST(HalvedSteps, TheSameStepsGiveTheSameMotion) {
  using G = TypeParam;
  const Taped<G> run = this->halved(0.024);
  const Outputs<G> outputs(run.model);
  const VectorXd end = outputs.values(run.tape.end);
  const MatrixXd again = on_steps_of(run.tape, this->machine, outputs);
  EXPECT_LT((again.rightCols(1) - end).norm(), 1e-9 * end.norm());
}

}  // namespace
}  // namespace liesl::test::halved_steps_test
