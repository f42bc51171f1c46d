/// @file
/// The plain ESL cycle of simulation and sizing, to its ends: converged, and every other one.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "mbs/system/response_value.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "optim/problems/motion_problem.hpp"
#include "reference/studies.hpp"
#include "reference/svanberg_beam.hpp"

namespace liesl::test::cycle_test {
namespace {

template <FrameGroup G = SE2>
CycleResult<G> cycle(const StudyCase& study, const CycleHooks& hooks = {},
                     const std::vector<Cycle>& resume = {}) {
  const Space<G> space = space_of<G>(study.scene.mechanism);
  StudySpec spec = study.spec;
  spec.cycle.method = CycleMethod::Esl;
  return run_cycle<G>(study.scene.mechanism, space, study.scene.simulation, spec, hooks, resume);
}

StudyCase rod(const std::vector<Change>& changes = {}) { return slider_crank_rod(changes); }

/// Largest |bend| over every step of a motion that is simulated anew, m; infinite if it fails.
double largest_deflection(const StudyCase& study, const Eigen::VectorXd& x) {
  const Sizing sizing(study.spec.design, study.scene.mechanism);
  Mechanism sized = study.scene.mechanism;
  sizing.apply(x, sized);
  const Motion<SE2> motion(sized, study.scene.simulation);
  if (!motion.good()) return std::numeric_limits<double>::infinity();
  const ResponseValues<SE2> values(motion.mechanism, motion.model);
  State<SE2> s = motion.model.initial_state();
  double largest = 0;
  for (int n = 0; n < motion.trajectory().size(); ++n) {
    motion.trajectory().read(n, s);
    largest = std::max(largest, values(study.spec.constraints[0].response, s).norm());
  }
  return largest;
}

double rod_mass(const Eigen::VectorXd& diameters) {
  return 7850 * M_PI / 4 * 0.3 / static_cast<double>(diameters.size()) * diameters.squaredNorm();
}

void expect_finite(const CycleResult<SE2>& r) {
  EXPECT_TRUE(r.x.allFinite());
  EXPECT_TRUE(std::isfinite(r.mass) && std::isfinite(r.worst) &&
              std::isfinite(r.load_change.value_or(0)));
  EXPECT_FALSE(r.reason.empty());
  for (const auto& c : r.history) {
    EXPECT_TRUE(c.x.allFinite() && c.next.allFinite());
    EXPECT_TRUE(std::isfinite(c.mass) && std::isfinite(c.worst));
  }
}

/// No design of the history is better than the one returned.
void expect_best(const CycleResult<SE2>& r, double allowed) {
  for (const auto& c : r.history) {
    if (r.worst <= allowed) {
      EXPECT_TRUE(c.worst > allowed || c.mass >= r.mass) << c.number;
    } else {
      EXPECT_GE(c.worst, r.worst) << c.number;
    }
  }
}

TEST(RodCycle, ConvergesToALimitThatEveryStepOfTheMotionMeets) {
  const StudyCase study = rod();
  const auto r = cycle(study);
  ASSERT_EQ(r.status, CycleStatus::Converged) << r.reason;
  EXPECT_LE(r.history.size(), 8u);
  expect_finite(r);
  expect_best(r, 1e-3);
  EXPECT_NEAR(r.mass, rod_mass(r.x), 1e-12);
  const double largest = largest_deflection(study, r.x);
  EXPECT_NEAR(largest, 1e-3 * (1 + r.worst), 1e-12);
  EXPECT_LE(largest, 1.001e-3);
  EXPECT_GE(largest, 0.998e-3) << "the limit is not used";
  ASSERT_EQ(r.identity.size(), 1u);
  EXPECT_LT(r.identity[0].second.nonlinear, 1e-10);
}

TEST(RodCycle, IsLighterThanTheBestUniformRod) {
  const StudyCase study = rod();
  const auto r = cycle(study);
  double thin = 0.006, thick = 0.018;
  const auto deflection = [&](double d) {
    return largest_deflection(study, Eigen::VectorXd::Constant(4, d));
  };
  const double limit = 1e-3 * (1 + std::max(0.0, r.worst));  // no advantage by the tolerance
  ASSERT_GT(deflection(thin), limit);
  ASSERT_LT(deflection(thick), limit);
  while (thick - thin > 1e-6) {
    const double d = 0.5 * (thin + thick);
    (deflection(d) > limit ? thin : thick) = d;
  }
  const double uniform = rod_mass(Eigen::VectorXd::Constant(4, thin));
  EXPECT_LT(r.mass, 0.99 * uniform) << "uniform " << thin;
}

TEST(RodCycleSlow, EndsAtTheSameDesignFromOtherStarts) {
  const auto r = cycle(rod());
  const std::vector<std::vector<double>> starts = {{0.006}, {0.018}, {0.018, 0.006, 0.006, 0.018}};
  for (const auto& values : starts) {
    SCOPED_TRACE(testing::PrintToString(values));
    const auto other = cycle(rod({start(values)}));
    EXPECT_EQ(other.status, CycleStatus::Converged) << other.reason;
    ASSERT_EQ(other.x.size(), r.x.size());
    EXPECT_LT(((other.x - r.x).cwiseQuotient(r.x)).cwiseAbs().maxCoeff(), 0.01);
    EXPECT_NEAR(other.mass, r.mass, 3e-3 * r.mass);
  }
}

TEST(RodCycleSlow, EndsAtTheSameDesignInThePlaneAndInSpace) {
  const auto plane = cycle<SE2>(rod());
  const auto space = cycle<SE3>(rod());
  EXPECT_EQ(space.status, CycleStatus::Converged) << space.reason;
  EXPECT_EQ(space.history.size(), plane.history.size());
  EXPECT_LT((space.x - plane.x).norm(), 1e-5 * plane.x.norm());
}

TEST(RodCycleSlow, EndsAtTheSameDesignWithEveryOptimiser) {
  const auto exact = cycle(rod());
  const auto with = [](Optimizer optimizer, NlpModel model) -> Change {
    return [=](StudyCase& s) {
      s.spec.cycle.optimizer = optimizer;
      s.spec.cycle.model = model;
    };
  };
  const std::map<std::string, Change> choices = {
      {"separable", with(Optimizer::Ipopt, NlpModel::Separable)},
      {"mma", with(Optimizer::Mma, NlpModel::Exact)},
      {"ccsaq", with(Optimizer::Ccsaq, NlpModel::Exact)},
      {"slsqp", with(Optimizer::Slsqp, NlpModel::Exact)}};
  for (const auto& [choice, change] : choices) {
    const auto other = cycle(rod({change}));
    EXPECT_EQ(other.status, CycleStatus::Converged) << choice << ": " << other.reason;
    EXPECT_NEAR(other.mass, exact.mass, 2e-3 * exact.mass) << choice;
    EXPECT_LT((other.x - exact.x).norm(), 5e-3 * exact.x.norm()) << choice;
  }
}

TEST(StaticCycle, EndsAfterOneRoundAtThePublishedOptimum) {
  // Without inertia the loads do not follow the design: one optimisation, whose answer a second
  // simulation confirms. (The third one sees that the loads stay.)
  const auto r = cycle(svanberg_cantilever({[](StudyCase& s) { s.spec.cycle.move_limit = 0.9; }}));
  ASSERT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_LE(r.history.size(), 3u);
  EXPECT_LT(std::abs(r.history[1].worst), 1e-5) << "the first answer does not hold";
  EXPECT_NEAR(r.mass, SvanbergBeam::optimum, 1e-4 * SvanbergBeam::optimum);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR((r.x[i] - 2e-5) / 0.01, SvanbergBeam::solution[i],
                1e-3 * SvanbergBeam::solution[i]);
}

TEST(CycleEnds, InfeasibleWithTheNameOfTheLimit) {
  const auto r = cycle(rod({limit(1e-5)}));
  EXPECT_EQ(r.status, CycleStatus::Infeasible) << r.reason;
  EXPECT_NE(r.reason.find("'bending' cannot be met"), std::string::npos) << r.reason;
  EXPECT_GT(r.worst, 1);
  expect_finite(r);
  expect_best(r, 1e-3);
}

TEST(CycleEnds, InfeasibleAtOnceWhereTheLimitIsHopeless) {
  const auto r = cycle(rod({limit(1e-12)}));
  EXPECT_EQ(r.status, CycleStatus::Infeasible) << r.reason;
  EXPECT_NE(r.reason.find("'bending' cannot be met"), std::string::npos) << r.reason;
  int iterations = 0;
  for (const auto& c : r.history) iterations += c.iterations;
  EXPECT_LT(iterations, 60) << "Ipopt alone: 600 a cycle";
  expect_finite(r);
}

TEST(CycleEnds, SimulationFailedWithTheReason) {
  const auto r = cycle(rod({motor(1e7)}));
  EXPECT_EQ(r.status, CycleStatus::SimulationFailed);
  EXPECT_NE(r.reason.find("at t = "), std::string::npos) << r.reason;
  EXPECT_TRUE(r.history.empty());
}

TEST(CycleEnds, CycleLimitWithTheBestDesign) {
  const auto r = cycle(rod({[](StudyCase& s) { s.spec.cycle.max = 2; }}));
  EXPECT_EQ(r.status, CycleStatus::CycleLimit) << r.reason;
  EXPECT_EQ(r.history.size(), 3u) << "two answers, each simulated";
  expect_finite(r);
  expect_best(r, 1e-3);
}

TEST(CycleEnds, WildMovesOfAFlexiblePartEndWithAStatusAndTheBestDesign) {
  const Change wild = [](StudyCase& s) {
    s.spec.design[0].lower = 0.001;
    s.spec.design[0].upper = 0.05;
    s.spec.cycle.move_limit = 0.95;
    s.spec.cycle.max = 8;
    s.scene.simulation.step = 2.5e-4;
  };
  for (const double most : {3e-2, 1e-2}) {
    const auto r = cycle(rod({limit(most), wild, duration(0.06)}));
    EXPECT_TRUE(r.status == CycleStatus::CycleLimit || r.status == CycleStatus::Oscillating ||
                r.status == CycleStatus::Converged)
        << r.reason;
    ASSERT_FALSE(r.history.empty());
    expect_finite(r);
    expect_best(r, 1e-3);
    EXPECT_LE(r.worst, 1e-3) << "the start meets the limit";
    EXPECT_LE(r.mass, r.history.front().mass);
  }
}

TEST(CycleEnds, OscillatingWhereEveryAnswerIsFurtherFromTheFixedPoint) {
  const auto r = cycle(esl_oscillates());
  ASSERT_EQ(r.status, CycleStatus::Oscillating) << r.reason;
  expect_finite(r);
  expect_best(r, 1e-3);
  // The answer in closed form: x -> x u(x) / limit = x / (0.985 x - 1.5), x in mm.
  int unlimited = 0;
  for (const auto& c : r.history) {
    if (c.answer.size() == 0) continue;
    const double x = 1e3 * c.x[0], answer = x / std::abs(0.985 * x - 1.5);
    if (std::abs(answer / x - 1) > 0.99 * c.move || answer > 10 || answer < 1) continue;
    ++unlimited;
    EXPECT_NEAR(1e3 * c.answer[0], answer, 0.01 * answer) << c.number;
  }
  EXPECT_GE(unlimited, 3);
  const double fixed_point = 2.5e-3 / 0.985;
  EXPECT_LE(r.worst, 1e-3) << "the best design meets the limit";
  EXPECT_NEAR(r.x[0], fixed_point, 0.01 * fixed_point);
}

/// Cost of the two springs of Stolpe's example, x in mm.
const Eigen::Vector2d kStolpesEnd(5 - 4 * 0.001, 0.001), kStolpesOptimum(0.001, 1.25 - 0.00025);

TEST(Optimality, EndOfStolpesCycleIsNotCalledOptimal) {
  const auto r = cycle(esl_non_optimal());
  ASSERT_EQ(r.status, CycleStatus::Converged) << r.reason;
  expect_finite(r);
  EXPECT_LT((1e3 * r.x - kStolpesEnd).norm(), 0.02) << 1e3 * r.x.transpose();
  ASSERT_TRUE(r.optimality && r.optimality->residual);
  EXPECT_FALSE(r.optimality->holds());
  // As of the closed form (tests/optim/nlp/kkt_test.cpp).
  EXPECT_NEAR(r.optimality->residual->stationarity, 1 - 0.2 / 0.68, 0.02);
  EXPECT_EQ(r.optimality->residual->worst_variable, "x1");
  EXPECT_GT(r.optimality->residual->worst_slope, 0);
  EXPECT_NE(r.reason.find("the dynamic optimality conditions do not hold"), std::string::npos)
      << r.reason;
  EXPECT_FALSE(r.warnings.empty());
}

/// The start is lighter than where the plain cycle ends, and meets the limits.
TEST(Optimality, AnEarlierDesignThatIsReturnedIsNamed) {
  StudyCase study = esl_non_optimal();
  study.spec.design[0].start = {0.001};
  study.spec.design[1].start = {0.0012};
  const auto r = cycle(study);
  ASSERT_EQ(r.status, CycleStatus::Converged) << r.reason;
  EXPECT_NEAR(r.x[1], 0.0012, 1e-12);
  EXPECT_TRUE(r.reason.ends_with("the design is that of cycle 1, the best that meets all limits"))
      << r.reason;
  EXPECT_NEAR(r.history.front().worst, -0.14, 0.005);
}

TEST(Optimality, HoldsAtStolpesOptimumAndNowhereElse) {
  const StudyCase study = esl_non_optimal();
  const Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  const DesignSimulator<SE2> simulator(study.scene.mechanism, space, study.scene.simulation,
                                       study.spec);
  const auto check = [&](const Eigen::VectorXd& x) {
    const auto run = simulator.run(x);
    const auto statics = motion_problem(study.spec, simulator, run, x, 0.5);
    return check_optimality_by_differences(simulator, run, x, *statics, 1e-2);
  };
  const DynamicOptimality right = check(1e-3 * kStolpesOptimum);
  ASSERT_TRUE(right.residual) << right.reason;
  EXPECT_TRUE(right.holds()) << right.brief();
  EXPECT_LT(right.residual->stationarity, 0.01);
  EXPECT_EQ(right.simulations, 3) << "one at the lower bound, two inside";
  const DynamicOptimality between = check(1e-3 * Eigen::Vector2d(1, 1));  // on the limit
  EXPECT_FALSE(between.holds()) << between.brief();
  const DynamicOptimality slack = check(1e-3 * Eigen::Vector2d(5, 5));
  // Nothing holds the mass up: its slope over a range, 9.999 mm, against that of 5 + 5 mm.
  EXPECT_NEAR(slack.residual->stationarity, 0.9999, 1e-6);
}

TEST(Optimality, HoldsWithoutInertia) {
  // Loads that do not follow the design: the static optimum is the optimum.
  const auto r = cycle(svanberg_cantilever());
  ASSERT_TRUE(r.optimality && r.optimality->residual);
  EXPECT_LT(r.optimality->residual->stationarity, 1e-3) << r.optimality->brief();
  EXPECT_EQ(r.reason.find("do not hold"), std::string::npos);
}

TEST(Optimality, IsCheckedAsAsked) {
  const Change quick = duration(0.05),
               never = [](StudyCase&s) { s.spec.cycle.optimality = OptimalityCheck::Never; };
  EXPECT_FALSE(cycle(rod({quick, never})).optimality);
  const auto sensitivities = cycle(rod({quick, groups(8)}));
  ASSERT_TRUE(sensitivities.optimality && sensitivities.optimality->residual);
  EXPECT_EQ(sensitivities.optimality->simulations, 0);
}

/// Runs until `simulations` have been begun, then asks to stop.
CycleResult<SE2> interrupted(const StudyCase& study, size_t simulations, std::vector<Cycle>& kept) {
  double before = 1e9;
  size_t begun = 0;
  CycleHooks hooks;
  hooks.on_cycle = [&](const std::vector<Cycle>& history) { kept = history; };
  hooks.progress = [&](double t) {
    begun += t < before;
    before = t;
    return begun < simulations || t < 0.06;
  };
  return cycle(study, hooks);
}

TEST(CycleEnds, InterruptedAndResumedIsAsIfNothingHadHappened) {
  const StudyCase study = rod({start(0.006)});
  const auto whole = cycle(study);
  for (const size_t simulations : {2u, 4u, 7u}) {
    std::vector<Cycle> kept;
    const auto part = interrupted(study, simulations, kept);
    EXPECT_EQ(part.status, CycleStatus::Interrupted);
    ASSERT_EQ(kept.size(), simulations - 1);
    expect_best(part, 1e-3);
    const auto r = cycle(study, {}, kept);
    EXPECT_EQ(r.status, whole.status) << r.reason;
    EXPECT_EQ(r.history.size(), whole.history.size()) << simulations;
    EXPECT_EQ(r.mass_initial, whole.mass_initial);
    ASSERT_EQ(r.x.size(), whole.x.size());
    EXPECT_LT((r.x - whole.x).norm(), 1e-6 * whole.x.norm()) << simulations;
    expect_best(r, 1e-3);
  }
}

/// Stopped within the static problem: half an optimum is no end of the cycle, and no next design.
TEST(CycleEnds, StoppedInTheStaticProblemIsInterruptedAndResumesToTheSameDesign) {
  const StudyCase study = rod({start(0.006)});
  const auto whole = cycle(study);
  int asked = 0;
  std::vector<Cycle> kept;
  CycleHooks hooks;
  hooks.keep_going = [&] { return ++asked < 3; };
  hooks.on_cycle = [&](const History& history) { kept = history; };
  const auto part = cycle(study, hooks);
  EXPECT_EQ(part.status, CycleStatus::Interrupted) << part.reason;
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].answer.size(), 0);
  EXPECT_EQ(kept[0].next.size(), 0);
  const auto r = cycle(study, {}, kept);
  EXPECT_EQ(r.status, whole.status) << r.reason;
  EXPECT_EQ(r.history.size(), whole.history.size());
  EXPECT_EQ(r.x, whole.x);
}

TEST(CycleEnds, ResumeRefusesAnotherStudy) {
  std::vector<Cycle> kept(1);
  kept[0].x = Eigen::VectorXd::Constant(3, 0.01);
  EXPECT_THROW(cycle(rod(), {}, kept), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::cycle_test
