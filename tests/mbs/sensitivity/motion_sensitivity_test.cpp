/// @file
/// Derivatives of a motion by parameters: direct form, adjoint form and differences of simulations.

#include "mbs/sensitivity/motion_sensitivity.hpp"

#include "mbs/sensitivity/forms.hpp"

namespace liesl::test::motion_sensitivity_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::expect_differences;
using test::expect_direct_equals_adjoint;
using test::Outputs;
using test::Quantity;
using test::Taped;

template <class G>
class MotionSensitivity : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(MotionSensitivity, Groups);

TYPED_TEST(MotionSensitivity, DirectEqualsAdjoint) {
  const Mechanism machine = test::sensitive_machine();
  for (const int steps : {10, 100, 1000})
    expect_direct_equals_adjoint<TypeParam>(steps, machine, test::quantities(machine));
}

/// Every step stretches, and with it what the drive does in it.
TYPED_TEST(MotionSensitivity, DirectEqualsAdjointByTheDuration) {
  Mechanism machine = test::sensitive_machine();
  machine.loads.pop_back();  // follows time, not the duration
  const int steps = 100;
  const Parameter duration{"duration", {StepDerivative{1 / (steps * 2e-4)}}};
  expect_direct_equals_adjoint<TypeParam>(steps, machine, {{steps * 2e-4, {}, duration}});
}

TYPED_TEST(MotionSensitivity, EqualsDifferencesOfSimulations) {
  const Mechanism machine = test::sensitive_machine();
  expect_differences<TypeParam>(machine, test::quantities(machine), {.linear = kLoadsOfTheMachine});
}

/// Beams of fourth order with damping, and under loads per length that follow the rod and turn it:
/// the first quantities, those of sections, among them, and the load.
TYPED_TEST(MotionSensitivity, OfFourthOrderEqualsDifferencesAndTheAdjointForm) {
  Mechanism machine = test::sensitive_machine();
  for (const std::size_t b : {0, 1}) std::get<BeamSpec>(machine.bodies[b].kind).order = 4;
  for (const bool follower : {true, false}) {
    LoadSpec spread = machine.loads[0];
    spread.spread = true;
    spread.follower = follower;
    spread.force = {5, -40, 0};
    spread.moment = {0, 0, 2};
    machine.loads.push_back(spread);
  }
  std::vector<Quantity> all = test::quantities(machine);
  all.resize(5);
  all.push_back({2,
                 [](Mechanism& c, double p) { c.loads[2].moment.z() = p; },
                 {"moment per length", {LoadDerivative{2, 0, {}, {0, 0, 0}, {0, 0, 1}}}}});
  expect_direct_equals_adjoint<TypeParam>(100, machine, all);
  expect_differences<TypeParam>(machine, all, {.linear = {"moment per length"}});
}

/// From static equilibrium under its weight, its loads and its spring: every parameter moves the
/// start. Of rubber: the round-off of the equilibrium, EA/L times that of positions, is divided by
/// the square of the step in accelerations.
TYPED_TEST(MotionSensitivity, FromEquilibrium) {
  const Mechanism machine = test::sensitive_machine(7e8);
  auto o = test::tight(0.02, 4e-4);
  o.start = StartChoice::Equilibrium;
  const auto all = test::quantities(machine);
  expect_direct_equals_adjoint<TypeParam>(Taped<TypeParam>(machine, o), all);
  expect_differences<TypeParam>(machine, all, {.simulation = o});
}

/// Slow, with long steps: after 10 of 0.2 ms that round-off is 2e-9 of accelerations.
TYPED_TEST(MotionSensitivity, FromEquilibriumDirectEqualsAdjoint) {
  constexpr double kRate = 20, kStep = 2e-3;
  Mechanism machine = test::sensitive_machine(7e8);
  machine.drives = {{0, 0, TimeFunction::rate(kRate, 0.02)}};
  auto all = test::quantities(machine);
  all.back().parameter = {"drive", {DriveDerivative{0, 1 / kRate}}};
  for (const int steps : {10, 100, 1000}) {
    auto o = test::tight(steps * kStep, kStep);
    o.start = StartChoice::Equilibrium;
    expect_direct_equals_adjoint<TypeParam>(Taped<TypeParam>(machine, o), all);
  }
}

/// The rate of an expression is one of differences: 1e-13 is at rest.
TYPED_TEST(MotionSensitivity, FromEquilibriumWithADriveByAnExpression) {
  using G = TypeParam;
  Mechanism machine = test::sensitive_machine(7e8);
  machine.drives = {{0, 0, TimeFunction::expression("t/0.5 - sin(2*pi*t/0.5)/(2*pi)")}};
  auto o = test::tight(0.02, 4e-4);
  o.start = StartChoice::Equilibrium;
  const Quantity of = test::quantities(machine).front();
  const Taped<G> run(machine, o);
  ASSERT_GT(run.tape.checkpoints.at(0).s.v.norm(), 0);
  const Outputs<G> outputs(run.model);
  const int steps = int(run.tape.steps()), smooth = Outputs<G>::sd + Outputs<G>::dim;
  MatrixXd exact(outputs.size(), steps + 1);
  const auto end = direct_sensitivity<G>(run.model, run.tape, run.parameters({of}),
                                         [&](long step, const State<G>& s, const auto& ds) {
                                           exact.col(step) = outputs.derivatives(s, ds).col(0);
                                         });
  ASSERT_TRUE(end.complete()) << end.reason;
  const test::Differences differences(
      [&](double change) { return changed_motion<G>(machine, of, change, o, outputs); }, 0.16, 6);
  const VectorXd size = test::sizes(exact.cwiseAbs().rowwise().maxCoeff(), outputs.groups);
  const double best = differences.least([&](const MatrixXd& y) {
    const MatrixXd error = (y / of.nominal - exact).cwiseAbs();
    const VectorXd worst = error.rowwise().maxCoeff().cwiseQuotient(size);
    return worst.head(smooth).maxCoeff();
  });
  EXPECT_LT(best, 1e-7);
}

/// A load whose derivative has no value after 6 ms, a functional that has none: both forms say so,
/// and of the first step that they meet; states before have their derivatives.
TYPED_TEST(MotionSensitivity, EndsWhereADerivativeIsNotFinite) {
  using G = TypeParam;
  const Mechanism machine = test::sensitive_machine();
  const Taped<G> run(machine, test::tight(0.012, 4e-4));
  const auto known_until = [&](const char* until) {
    return run.parameters(
        {{1, {}, {"push", {LoadDerivative{0, 0, {{1, TimeFunction::expression(until)}}}}}}});
  };
  const auto parameters = known_until("sqrt(0.0062-t)");
  double last = 0;
  const auto direct = direct_sensitivity<G>(
      run.model, run.tape, parameters, [&](long, const State<G>& s, const StateSensitivity& ds) {
        EXPECT_TRUE(ds.eta.allFinite() && ds.w.allFinite() && ds.lambda.allFinite()) << s.t;
        last = s.t;
      });
  const char* const why = "have no finite solution";
  EXPECT_EQ(direct.reason, std::string("the equations of the step to t = 0.0064 s ") + why);
  EXPECT_NEAR(last, 0.006, 1e-12);
  MatrixXd gradient;
  const auto adjoint = [&](const Parameters<G>& by, double weight) {
    return adjoint_sensitivity<G>(
        run.model, run.tape, by, 1,
        [&](long, const State<G>&, StateSensitivity& bars, MatrixXd&) { bars.v(0, 0) += weight; },
        gradient);
  };
  EXPECT_EQ(adjoint(known_until("sqrt(0.02-t)"), 1).reason, "");
  EXPECT_TRUE(gradient.allFinite());
  EXPECT_EQ(adjoint(parameters, 1).reason,
            std::string("the equations of the step to t = 0.012 s ") + why);
  EXPECT_EQ(adjoint(known_until("sqrt(0.02-t)"), std::nan("")).reason,
            std::string("the equations of the step to t = 0.012 s ") + why);
}

TYPED_TEST(MotionSensitivity, RefusesAStartThatDependsOnParameters) {
  using G = TypeParam;
  const auto direct = [&](const Mechanism& m) {
    const Taped<G> run(m, test::options(1e-3, 1e-4));
    direct_sensitivity<G>(run.model, run.tape, run.parameters(test::quantities(m)),
                          [](long, const State<G>&, const StateSensitivity&) {});
  };
  Mechanism jerked = test::sensitive_machine();
  jerked.drives = {{0, 0, TimeFunction::rate(150, 0)}};
  EXPECT_THROW(direct(jerked), std::invalid_argument);
  jerked.bodies[0].angular_velocity = {0, 0, 150};
  jerked.bodies[1].velocity = {0, 0.15 * 150, 0};
  jerked.bodies[1].angular_velocity = {0, 0, -75};
  try {
    direct(jerked);
    ADD_FAILURE() << "the velocities at the start depend on the drive";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("a drive with a factor"), std::string::npos) << e.what();
  }
  EXPECT_NO_THROW(direct(test::sensitive_machine()));
}

}  // namespace
}  // namespace liesl::test::motion_sensitivity_test
