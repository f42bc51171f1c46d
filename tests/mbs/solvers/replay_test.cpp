/// @file
/// A tape gives the states of its simulation again, bit for bit, from every checkpoint.

#include "mbs/solvers/replay.hpp"

#include <gtest/gtest.h>

#include "mbs/run.hpp"
#include "reference/mechanisms.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::replay_test {
namespace {

template <FrameGroup G>
void expect_same_bits(const State<G>& a, const State<G>& b) {
  EXPECT_EQ(a.t, b.t);
  for (std::size_t k = 0; k < a.H.size(); ++k) {
    EXPECT_EQ(a.H[k].R, b.H[k].R) << "node " << k << " at t = " << a.t;
    EXPECT_EQ(a.H[k].x, b.H[k].x) << "node " << k << " at t = " << a.t;
  }
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.vdot, b.vdot);
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.w, b.w);
  EXPECT_EQ(a.lambda, b.lambda);
  EXPECT_EQ(a.rows, b.rows);
}

/// Stretches from the last to the first, by one replay; every state that was recorded is met.
template <FrameGroup G>
Report expect_replay(const Mechanism& m, const Space<G>& space, const SimulationOptions& o,
                     int every = 5) {
  const auto model = Model<G>::build(m, space);
  Tape<G> tape;
  tape.every = every;
  const auto run = simulate(model, o, {}, &tape);
  EXPECT_EQ(run.report.status, SolveStatus::Converged) << run.report.reason;
  EXPECT_EQ(tape.steps(), run.report.steps);
  EXPECT_EQ(static_cast<long>(tape.attempts.size()),
            run.report.steps + run.report.rejected_steps + run.report.refused_steps);
  Replay<G> replay(model, tape);
  EXPECT_GT(replay.stretches(), 2);
  std::map<double, State<G>> recorded;
  for (int n = 0; n < run.trajectory.size(); ++n)
    run.trajectory.read(n, recorded[run.trajectory.time(n)]);
  long steps = 0;
  std::size_t met = 0;
  for (int i = replay.stretches() - 1; i >= 0; --i) {
    State<G> last;
    replay.run(i, [&](const State<G>&, const State<G>& after, double) {
      ++steps;
      last = after;
      if (const auto found = recorded.find(after.t); found != recorded.end()) {
        State<G> seen = after;
        model.complete(seen);
        found->second.a = seen.a;  // is not recorded
        expect_same_bits(seen, found->second);
        ++met;
      }
    });
    if (last.H.empty()) continue;  // a checkpoint at the end
    const bool end = i + 1 == replay.stretches();
    expect_same_bits(last, end ? tape.end : tape.checkpoints[std::size_t(i) + 1].s);
  }
  EXPECT_EQ(steps, run.report.steps);
  EXPECT_EQ(met + 1, recorded.size());  // but the start
  return run.report;
}

TEST(Replay, WholeSteps) {
  expect_replay<SE2>(test::slider_crank({.elements = 4}), *find_plane(test::slider_crank()).plane,
                     test::options(0.01, 1e-4));
  expect_replay<SE3>(test::pendulum(4), {}, test::options(0.1, 1e-3), 7);
}

test::SliderCrank slender() {
  test::SliderCrank p;
  p.elements = 4;
  p.crank = p.rod = 0.004;
  p.slider = 0.5;
  p.ramp = 0;
  return p;
}

/// Refactorised tangents and halved steps: both are part of what the next steps depend on.
TEST(Replay, HalvedStepsAndOtherTangents) {
  auto o = test::options(0.04, 1e-3);
  o.max_iterations = 4;
  const auto report = expect_replay<SE2>(test::slider_crank(slender()),
                                         *find_plane(test::slider_crank()).plane, o, 5);
  EXPECT_GT(report.rejected_steps, 0);
  EXPECT_GT(report.tangent_refreshes, 0);
}

/// Corrections since the last tangent decide on the next.
TEST(Replay, RenewedTangents) {
  for (const int every : {1, 7}) {
    const auto report = expect_replay<SE3>(test::pendulum(8), {}, test::options(1, 5e-3), every);
    EXPECT_GT(report.tangent_renewals, 1);
  }
}

TEST(Replay, AdaptiveSteps) {
  auto o = test::options(0.5, 1e-2);
  o.adaptive = true;
  o.error_tolerance = 1e-5;
  const auto report = expect_replay<SE3>(test::pendulum(4), {}, o);
  EXPECT_LT(report.smallest_step, o.step);
  EXPECT_GT(report.refused_steps, 0);
}

/// Attempts that failed, or were refused, and other tangents, between two checkpoints.
TEST(Replay, AdaptiveStepsThatFailToo) {
  auto o = test::options(0.04, 2e-3);
  o.adaptive = true;
  o.error_tolerance = 1e-5;
  o.max_iterations = 4;
  for (const int every : {1, 7}) {
    const auto report = expect_replay<SE2>(test::slider_crank(slender()),
                                           *find_plane(test::slider_crank()).plane, o, every);
    EXPECT_GT(report.refused_steps, 0);
    EXPECT_GT(report.rejected_steps, 0);
    EXPECT_GT(report.tangent_refreshes, 0);
  }
}

/// Rotation vectors that pass pi are changed after a step.
TEST(Replay, RescaledRotationVectors) {
  Mechanism m = test::slider_crank({.elements = 2});
  m.formalism = Formalism::Classical;
  m.drives = {{0, 0, TimeFunction::rate(150, 0)}};
  expect_replay<SE3>(m, {}, test::options(0.04, 2e-4));
}

TEST(Replay, AdaptiveTangentOfR3SO3) {
  Mechanism m = test::slider_crank(slender());
  m.formalism = Formalism::R3SO3;
  const auto report = expect_replay<SE3>(m, {}, test::options(0.01, 2e-4), 6);
  EXPECT_GT(report.tangent_refreshes, 0);
}

TEST(Replay, MeshedPartsAndPenalties) {
  const Mechanism meshed = test::slider_crank_with_mesh(30, 2, 3);
  expect_replay<SE2>(meshed, *find_plane(meshed).plane, test::options(0.01, 1e-4));
  Mechanism soft = test::slider_crank({.elements = 4});
  soft.penalty.form = ConstraintForm::Penalty;
  expect_replay<SE2>(soft, *find_plane(soft).plane, test::options(0.01, 1e-4));
}

/// Beyond 64 MB of states a tape keeps every sqrt(N)-th of its own accord.
TEST(Replay, OfALongMotionFromEveryRootOfItsSteps) {
  auto o = test::options(0.03, 5e-5);
  const Mechanism m = test::pendulum(100);
  const auto model = Model<SE3>::build(m, {});
  Tape<SE3> tape;
  const auto run = simulate(model, o, {}, &tape);
  ASSERT_EQ(run.report.status, SolveStatus::Converged) << run.report.reason;
  EXPECT_EQ(tape.every, 25);  // ceil(sqrt(600))
  EXPECT_EQ(tape.checkpoints.size(), 1 + 600 / 25);
  expect_replay<SE3>(m, {}, o, 0);
}

/// A short motion has all states on its tape, those that a replay gives.
TEST(Replay, OfAShortMotionHasNothingToSolve) {
  const Mechanism m = test::slider_crank(slender());
  auto o = test::options(0.04, 1e-3);
  o.max_iterations = 4;
  const auto model = Model<SE2>::build(m, *find_plane(m).plane);
  Tape<SE2> all, few;
  few.every = 5;
  const auto run = simulate(model, o, {}, &all);
  simulate(model, o, {}, &few);
  EXPECT_GT(run.report.rejected_steps, 0);
  EXPECT_EQ(static_cast<long>(all.checkpoints.size()), run.report.steps + 1);
  std::vector<State<SE2>> kept;
  std::vector<double> h;
  Replay<SE2> given(model, all), solved(model, few);
  for (int i = 0; i < given.stretches(); ++i)
    given.run(i, [&](const State<SE2>&, const State<SE2>& after, double step) {
      kept.push_back(after);
      h.push_back(step);
    });
  std::size_t n = 0;
  for (int i = 0; i < solved.stretches(); ++i)
    solved.run(i, [&](const State<SE2>&, const State<SE2>& after, double step) {
      expect_same_bits(after, kept.at(n));
      EXPECT_EQ(step, h.at(n++));
    });
  EXPECT_EQ(n, kept.size());
}

}  // namespace
}  // namespace liesl::test::replay_test
