/// @file
/// Steps of a motion that are linearised side by side.

#include "mbs/sensitivity/linearised_steps.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "mbs/sensitivity/forms.hpp"

namespace liesl::test::linearised_steps_test {
namespace {

using Eigen::MatrixXd;

template <class G>
class LinearisedStepsIn : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(LinearisedStepsIn, Groups);

/// Derivatives at the end by the direct form, and a gradient by the adjoint one.
template <class G>
std::vector<MatrixXd> derivatives(const Taped<G>& run, const Parameters<G>& parameters) {
  MatrixXd eta, gradient;
  const auto direct = direct_sensitivity<G>(
      run.model, run.tape, parameters,
      [&](long, const State<G>&, const StateSensitivity& ds) { eta = ds.eta; });
  EXPECT_TRUE(direct.complete()) << direct.reason;
  const auto adjoint = adjoint_sensitivity<G>(
      run.model, run.tape, parameters, 1,
      [](long, const State<G>&, StateSensitivity& bars, MatrixXd&) { bars.v.array() += 1; },
      gradient);
  EXPECT_TRUE(adjoint.complete()) << adjoint.reason;
  return {eta, gradient};
}

/// To the last bit, with checkpoints after every step and with few of them.
TYPED_TEST(LinearisedStepsIn, GiveTheSameWhateverTheNumberOfThreads) {
  using G = TypeParam;
  const Mechanism machine = test::sensitive_machine();
  Taped<G> run(machine, test::tight(0.03, 2e-4));
  ASSERT_GT(run.model.size() + run.model.constraints(), 40) << "else there is one lane";
  const auto parameters = run.parameters(test::quantities(machine));
  const auto several = derivatives(run, parameters);
  EXPECT_GT(several[0].norm(), 0);
  EXPECT_GT(several[1].norm(), 0);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(derivatives(run, parameters), several);
}

TYPED_TEST(LinearisedStepsIn, EndWhereAStepHasNoSolution) {
  using G = TypeParam;
  const Taped<G> run(test::sensitive_machine(), test::tight(0.02, 2e-4));
  Steps<G> steps;
  for (const auto& checkpoint : run.tape.checkpoints) steps.states.push_back(checkpoint.s);
  steps.h.assign(steps.states.size() - 1, 2e-4);
  ASSERT_GT(steps.h.size(), 20u);
  for (const bool backwards : {false, true}) {
    LinearisedSteps<G> linearised(run.model, 0.8);
    std::vector<std::size_t> taken;
    const auto end = linearised.run(steps, backwards, [&](StepSensitivity<G>&, std::size_t k) {
      taken.push_back(k);
      return taken.size() < 10;
    });
    ASSERT_EQ(taken.size(), 10u);
    for (std::size_t i = 0; i < taken.size(); ++i)
      EXPECT_EQ(taken[i], backwards ? steps.h.size() - 1 - i : i);
    EXPECT_NE(end.reason.find(fmt::format("to t = {:.6g} s", steps.states[taken[9] + 1].t)),
              std::string::npos)
        << end.reason;
  }
}

}  // namespace
}  // namespace liesl::test::linearised_steps_test
