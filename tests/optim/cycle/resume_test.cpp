/// @file
/// An interrupted run that goes on is the run without the interruption: the same designs to the
/// last bit, and the same effort.
#include <gtest/gtest.h>

#include <algorithm>

#include "optim/cycle/motion_cycle.hpp"
#include "reference/studies.hpp"

namespace liesl::test::resume_test {
namespace {

/// Linear rows without a static image reject designs.
void choose(StudyCase& s, CycleMethod method) {
  s.spec.cycle.method = method;
  if (method != CycleMethod::Full) return;
  s.spec.cycle.approximation = Approximation::Linear;
  s.spec.cycle.move_limit = 1;
}

class Resume : public testing::TestWithParam<CycleMethod> {
 protected:
  const StudyCase study_ =
      slider_crank_rod({duration(0.02), [](StudyCase& s) { choose(s, GetParam()); }});
  CycleResult<SE2> optimise(const CycleHooks& hooks, const std::vector<Cycle>& resume) const {
    return run_cycle<SE2>(study_.scene.mechanism, space_of<SE2>(study_.scene.mechanism),
                          study_.scene.simulation, study_.spec, hooks, resume);
  }
};

TEST_P(Resume, IsBitEqualFromEveryCycle) {
  std::vector<std::vector<Cycle>> states;
  CycleHooks hooks;
  hooks.on_cycle = [&](const std::vector<Cycle>& history) { states.push_back(history); };
  const CycleResult<SE2> whole = optimise(hooks, {});
  ASSERT_TRUE(closed(whole.status)) << whole.reason;
  ASSERT_GE(states.size(), 3u);
  states.pop_back();  // after the last one it has ended
  if (GetParam() == CycleMethod::Full) {
    EXPECT_TRUE(std::ranges::any_of(whole.history, [](const Cycle& c) { return !c.taken; }));
  }
  for (const auto& state : states) {
    const CycleResult<SE2> resumed = optimise({}, state);
    EXPECT_EQ(resumed.status, whole.status) << state.size();
    EXPECT_EQ(resumed.reason, whole.reason) << state.size();
    EXPECT_EQ(resumed.x, whole.x) << state.size() << ": " << (resumed.x - whole.x).norm();
    EXPECT_EQ(resumed.mass, whole.mass);
    EXPECT_EQ(resumed.load_change, whole.load_change);
    ASSERT_EQ(resumed.history.size(), whole.history.size());
    EXPECT_EQ(resumed.effort.steps, whole.effort.steps);
    EXPECT_EQ(resumed.effort.newton_iterations, whole.effort.newton_iterations);
    EXPECT_EQ(resumed.effort.factorizations, whole.effort.factorizations);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Resume,
                         testing::Values(CycleMethod::Esl1, CycleMethod::Full, CycleMethod::Esl),
                         [](const auto& of) {
                           return of.param == CycleMethod::Esl    ? "esl"
                                  : of.param == CycleMethod::Full ? "full"
                                                                  : "esl1";
                         });

}  // namespace
}  // namespace liesl::test::resume_test
