/// @file
/// Studies that end infeasible from one start and optimal from another.
#include "optim/cycle/restarts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "optim/cycle/continuation.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/studies.hpp"

namespace liesl::test::restarts_test {
namespace {

struct RestartedRod {
  explicit RestartedRod(const std::vector<Change>& changes) : study(slider_crank_rod(changes)) {}
  CycleResult<SE2> optimise(const CycleHooks& hooks = {}, const History& resume = {}) const {
    return run_cycle<SE2>(study.scene.mechanism, space, study.scene.simulation, study.spec, hooks,
                          resume);
  }
  StudyCase study;
  Space<SE2> space = space_of<SE2>(study.scene.mechanism);
};

TEST(Restarts, StartAtSharesOfTheRanges) {
  StudySpec study;
  DesignSpec sizes;
  sizes.groups = 2;
  sizes.start = {0.3, 0.4};
  study.design = {sizes};
  ConstantSpec spring, drive;
  spring.start = 5;
  drive.start = 7;
  drive.quantity = ConstantQuantity::DriveValue;
  study.constants = {spring, drive};
  const std::vector<NlpVariable> variables = {
      {"a", 0, 1, 0.3}, {"b", 0, 2, 0.4}, {"spring", 10, 20, 5}, {"drive", 0, 10, 7}};
  const auto other = restarted(study, variables, 1);
  ASSERT_TRUE(other);
  EXPECT_DOUBLE_EQ(other->design[0].start[0], 0.9);
  EXPECT_DOUBLE_EQ(other->design[0].start[1], 1.8);
  EXPECT_DOUBLE_EQ(*other->constants[0].start, 19);
  EXPECT_DOUBLE_EQ(*other->constants[1].start, 7) << "a motion keeps its start";
  EXPECT_DOUBLE_EQ(restarted(study, variables, 3)->design[0].start[1], 0.2);
  const std::vector<NlpVariable> fixed = {
      {"a", 1, 1, 1}, {"b", 2, 2, 2}, {"spring", 5, 5, 5}, {"drive", 0, 10, 7}};
  EXPECT_FALSE(restarted(study, fixed, 1)) << "nothing would start elsewhere";
}

/// A rod that vibrates: from 11.38 mm no step brings it nearer to its limit, from 18.4 mm it is
/// met. Stopped in the first and in the second start, and resumed, it ends at the same design.
TEST(Restarts, EndOptimalWhereTheOwnStartIsInfeasible) {
  RestartedRod rod({motor(140), slider_mass(0.5), limit(0.75e-3)});
  const auto own = rod.optimise();
  ASSERT_EQ(own.status, CycleStatus::Infeasible) << "the case shows nothing any more";
  EXPECT_NE(own.reason.find("cycle.restarts"), std::string::npos) << own.reason;
  rod.study.spec.cycle.restarts = 3;
  std::vector<History> states;
  CycleHooks hooks;
  hooks.on_cycle = [&](const History& history) { states.push_back(history); };
  const auto r = rod.optimise(hooks);
  ASSERT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_LE(r.worst, 1e-3);
  EXPECT_LE(r.optimality->residual->stationarity, kOptimalResidual);
  EXPECT_EQ(r.mass_initial, own.mass_initial);
  ASSERT_GT(r.history.size(), own.history.size());
  EXPECT_EQ(states.back().size(), r.history.size());
  EXPECT_GT(r.effort.steps, own.effort.steps);
  EXPECT_EQ(r.history[own.history.size()].start, 1);
  EXPECT_DOUBLE_EQ(r.history[own.history.size()].x[0], 0.0184);
  ASSERT_FALSE(r.warnings.empty());
  EXPECT_NE(r.warnings.back().find("began again with every variable at 0.9"), std::string::npos);
  for (const std::size_t stop : {own.history.size() - 1, own.history.size() + 3}) {
    const auto resumed = rod.optimise({}, states[stop]);
    EXPECT_EQ(resumed.status, r.status) << resumed.reason;
    EXPECT_EQ(resumed.x, r.x) << stop;
    EXPECT_EQ(resumed.history.size(), r.history.size());
    EXPECT_EQ(resumed.effort.steps, r.effort.steps);
    EXPECT_EQ(resumed.mass_initial, r.mass_initial);
  }
}

TEST(Continuation, SlowsAllThatTheMotionHas) {
  auto study = slider_crank_rod();
  study.scene.mechanism.bodies[2].velocity = {2, 0, 0};
  study.scene.mechanism.gravity_scale = TimeFunction::expression("1 + t");
  const auto space = space_of<SE2>(study.scene.mechanism);
  const std::vector<Scenario<SE2>> given = {{study.scene.mechanism, space, study.scene.simulation}};
  const Scenario<SE2> slow = at_speed(given, 0.5).front();
  const auto& motion = slow.mechanism.drives[0].motion;
  EXPECT_EQ(motion(0.06), given[0].mechanism.drives[0].motion(0.03));
  EXPECT_EQ(motion.rate(0.06), 0.5 * given[0].mechanism.drives[0].motion.rate(0.03));
  EXPECT_EQ(slow.mechanism.gravity_scale(0.2), 1.1);
  EXPECT_EQ(slow.mechanism.bodies[2].velocity.x(), 1);
  EXPECT_EQ(slow.simulation.duration, 2 * given[0].simulation.duration);
  EXPECT_EQ(slow.simulation.step, 2 * given[0].simulation.step);
  EXPECT_EQ(slow.mechanism.penalty.step, 2 * given[0].mechanism.penalty.step);
  EXPECT_DOUBLE_EQ(stage_speed(0, 4), 0.9);
  EXPECT_DOUBLE_EQ(stage_speed(2, 4), 0.95);
  EXPECT_EQ(stage_speed(4, 4), 1);
}

/// The rod of the test above by slower motions instead of another start; stopped in the last stage
/// and resumed, it ends at the same design.
TEST(Continuation, EndsOptimalWhereTheOwnStartIsInfeasible) {
  RestartedRod rod({motor(140), slider_mass(0.5), limit(0.75e-3)});
  rod.study.spec.cycle.continuation = 8;
  std::vector<History> states;
  CycleHooks hooks;
  hooks.on_cycle = [&](const History& history) { states.push_back(history); };
  const auto r = rod.optimise(hooks);
  ASSERT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_LE(r.worst, 1e-3);
  EXPECT_LE(r.optimality->residual->stationarity, kOptimalResidual);
  EXPECT_EQ(r.simulation.trajectory.time(r.simulation.trajectory.size() - 1), 0.12);
  EXPECT_NE(r.warnings.back().find("0.9 of its speed"), std::string::npos) << r.warnings.back();
  EXPECT_EQ(r.history.front().start, 0);
  EXPECT_EQ(r.history.back().start, kMostRestarts + 9);
  const auto in_last = std::find_if(states.begin(), states.end(), [](const History& h) {
    return h.back().start == kMostRestarts + 9 && h.back().number == 2;
  });
  ASSERT_NE(in_last, states.end());
  const auto resumed = rod.optimise({}, *in_last);
  EXPECT_EQ(resumed.status, r.status) << resumed.reason;
  EXPECT_EQ(resumed.x, r.x);
  EXPECT_EQ(resumed.history.size(), r.history.size());
}

/// Cycles are numbered from 1 in every start: a reason says which start one is of.
TEST(Restarts, ACycleThatARunIsStoppedInIsOfItsStart) {
  RestartedRod rod({duration(0.02), limit(1e-5)});
  rod.study.spec.cycle.restarts = 2;
  for (const int last : {0, 2}) {
    int start = -1;
    CycleHooks hooks;
    hooks.on_cycle = [&](const History& history) { start = history.back().start; };
    hooks.keep_going = [&] { return start < last; };
    const auto r = rod.optimise(hooks);
    ASSERT_EQ(r.status, CycleStatus::Interrupted) << r.reason;
    EXPECT_NE(r.reason.find("stopped in cycle "), std::string::npos) << r.reason;
    EXPECT_EQ(r.reason.find(" of restart 2 on request") != std::string::npos, last == 2)
        << r.reason;
  }
}

/// Where no start meets the limits, the answer is the design that exceeds them least.
TEST(Restarts, KeepTheDesignThatExceedsLimitsLeast) {
  RestartedRod rod({duration(0.02), limit(1e-5)});
  rod.study.spec.cycle.restarts = 2;
  const auto r = rod.optimise();
  ASSERT_EQ(r.status, CycleStatus::Infeasible) << r.reason;
  EXPECT_NE(r.reason.find("2 other starts came no nearer"), std::string::npos) << r.reason;
  std::map<int, double> worst;  // of the last design taken, by start
  for (const Cycle& c : r.history)
    if (c.taken) worst[c.start] = c.worst;
  ASSERT_EQ(worst.size(), 3u);
  for (const auto& [start, least] : worst) EXPECT_LE(r.worst, least) << start;
}

}  // namespace
}  // namespace liesl::test::restarts_test
