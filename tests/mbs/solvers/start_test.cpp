/// @file
/// Where a motion starts: in equilibrium, where a drive says, and what is seen of every step.

#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl::test::start_test {
namespace {

using test::options;

/// A steel strip that its weight bends.
Mechanism sagging(Formalism formalism = Formalism::SE3) {
  BeamSpec spec;
  spec.nodes = straight({0, 0, 0}, {1, 0, 0}, 6);
  spec.sections.assign(6, Section{"strip", Rectangle{0.02, 0.002}});
  spec.material = {"steel", 210e9, 0.3, 7850};
  Mechanism m = test::cantilever(spec);
  m.gravity = {0, 0, -9.81};
  m.formalism = formalism;
  return m;
}

/// Lowest and highest tip over a motion.
std::pair<double, double> tip_range(const Mechanism& m, StartChoice start) {
  SimulationOptions o = options(0.3, 1e-3);
  o.start = start;
  const auto run = test::run_spatial(m, o);
  EXPECT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  double low = 1, high = -1;
  for (int n = 0; n <= run.last(); ++n) {
    const double z = run.trajectory().frames(n)[6].x.z();
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return {low, high};
}

class Start : public ::testing::TestWithParam<Formalism> {};

/// From equilibrium nothing moves; from the undeformed shape the tip falls to twice the sag.
TEST_P(Start, FromEquilibriumNothingMoves) {
  const Mechanism m = sagging(GetParam());
  const auto [low, high] = tip_range(m, StartChoice::Equilibrium);
  const double sag = -test::tip_displacement(m).z();
  EXPECT_GT(sag, 0.01);
  EXPECT_NEAR(low, -sag, 1e-7);
  EXPECT_NEAR(high, -sag, 1e-7);
  const auto struck = tip_range(m, StartChoice::Assembled);
  EXPECT_LT(struck.first, -1.8 * sag);
  EXPECT_NEAR(struck.second, 0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(WithStatics, Start,
                         ::testing::Values(Formalism::SE3, Formalism::R3SO3, Formalism::Classical),
                         [](const auto& of) { return std::string(to_string(of.param)); });

TEST(StartTest, WithoutAnEquilibriumNothingStarts) {
  Mechanism m = sagging();
  m.joints.clear();
  SimulationOptions o = options(0.1, 1e-3);
  o.start = StartChoice::Equilibrium;
  const auto run = test::run_spatial(m, o);
  EXPECT_EQ(run.report().status, SolveStatus::Singular);
  EXPECT_NE(run.report().reason.find("no equilibrium to start from"), std::string::npos);
}

/// A drive that starts at half a radian turns crank and rod; it does not bend them.
class DriveElsewhere : public ::testing::TestWithParam<Formalism> {};

TEST_P(DriveElsewhere, TurnsTheMechanism) {
  Mechanism m = test::slider_crank({4});
  m.formalism = GetParam();
  m.drives[0].motion =
      TimeFunction::table({0, 1}, {0.5, 10.5}, TimeFunction::Interpolation::Linear);
  const auto run = test::run_planar(m, options(0.01, 1e-4));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  State<SE2> s = run.model->initial_state();
  run.trajectory().read(0, s);
  for (int b : {0, 1}) {
    const BodyState<SE2> at = run.model->body_state(s, b);
    for (int e = 0; e < 4; ++e)
      EXPECT_LT(run.model->bodies[std::size_t(b)]->strain(at, e).norm(), 1e-9) << b << " " << e;
  }
  const auto q = joint_coordinates(m, *run.model, m.drives[0].joint, s);
  EXPECT_NEAR(q.at(0), 0.5, 1e-10);
  bool told = false;
  for (const auto& w : run.report().warnings)
    told = told || w.find("a drive is not at its joint's position") != std::string::npos;
  EXPECT_TRUE(told);
}

INSTANTIATE_TEST_SUITE_P(Flexible, DriveElsewhere,
                         ::testing::Values(Formalism::SE3, Formalism::R3SO3, Formalism::Segments),
                         [](const auto& of) { return std::string(to_string(of.param)); });

/// What an observer sees does not depend on how many steps are recorded, and halved steps are seen.
TEST(StartTest, EveryAcceptedStepIsSeen) {
  const Mechanism m = sagging();
  const auto model = Model<SE3>::build(m, {});
  std::vector<double> seen[2];
  for (const int every : {1, 7}) {
    SimulationOptions o = options(0.1, 1e-3);
    o.output_every = every;
    int recorded = 0;
    std::vector<double>& tips = seen[every == 7];
    const auto run =
        simulate<SE3>(model, o, {}, nullptr, [&](const State<SE3>& s, bool is_recorded) {
          tips.push_back(s.H[6].x.z());
          recorded += is_recorded;
        });
    EXPECT_EQ(static_cast<long>(tips.size()), run.report.steps + 1);
    EXPECT_EQ(recorded, run.trajectory.size());
  }
  EXPECT_EQ(seen[0], seen[1]);
}

/// Damping takes the energy that the balance would otherwise blame on the integrator.
TEST(StartTest, DampingIsInThePower) {
  const std::pair<Formalism, int> cases[] = {
      {Formalism::SE3, 2}, {Formalism::SE3, 4}, {Formalism::R3SO3, 2}, {Formalism::Floating, 2}};
  for (const auto& [formalism, order] : cases) {
    Mechanism m = sagging(formalism);
    m.gravity.setZero();
    auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
    beam.damping = 2e-3;
    beam.order = order;
    for (auto& s : beam.sections) s.shape = Rectangle{0.02, 0.01};
    m.loads.push_back(test::tip_load(m, {0, 0, 2}));
    m.loads[0].scale = TimeFunction::expression("sin(20*t)^4");
    const auto model = Model<SE3>::build(m, {});
    Equations<SE3> eq(model);
    double off[2] = {0, 0}, taken = 0, energy = 0;
    for (int k = 0; k < 2; ++k) {
      double before = 0, work = 0, start = 0, t = 0, lost = 0;
      const auto run = simulate<SE3>(
          model, options(0.3, 2e-3 / (1 << k), 0.9), {}, nullptr, [&](const State<SE3>& s, bool) {
            const double p = power(model, eq, s), e = total(mechanical_energy(model, s));
            const double d = model.bodies[0]->dissipation(model.body_state(s, 0));
            if (s.t == 0) {
              start = e;
            } else {
              work += 0.5 * (s.t - t) * (p + before);
              taken += k * (s.t - t) * d;
            }
            before = p;
            t = s.t;
            lost = start + work - e;
            energy = std::max(energy, e);
            off[k] = std::max(off[k], std::abs(lost));
          });
      ASSERT_EQ(run.report.status, SolveStatus::Converged) << run.report.reason;
    }
    EXPECT_GT(taken, 0.1 * energy) << to_string(formalism);
    EXPECT_LT(off[1], 0.02 * taken) << to_string(formalism);
    EXPECT_NEAR(std::log2(off[0] / off[1]), 2, 0.3) << to_string(formalism);
  }
}

}  // namespace
}  // namespace liesl::test::start_test
