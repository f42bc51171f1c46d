/// @file
/// Derivatives of responses by parameters over a motion, under formalisms other than se3: direct,
/// adjoint and differences.

#include "mbs/sensitivity/response_histories.hpp"

namespace liesl::test::formalism_responses_test {
namespace {

struct Case {
  const char* name;
  Formalism formalism;
  NodeUpdate update = NodeUpdate::AsFormalism;
  double largest = 0.16;  ///< relative change of differences; a larger one halves a step
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

/// Floating frames of rubber and slow, as in FloatingSensitivity: round-off of EA/L is smaller.
class FormalismResponses : public ::testing::TestWithParam<Case> {
 protected:
  template <FrameGroup G>
  void expect_gradients() const {
    const Case& c = GetParam();
    const bool floating = c.formalism == Formalism::Floating;
    Mechanism machine = sensitive_machine(floating ? 7e8 : 7e9);
    if (floating) machine.drives = {{0, 0, TimeFunction::rate(20, 0.02)}};
    machine.formalism = c.formalism;
    machine.update = c.update;
    auto all = quantities(machine);
    if (floating) all.pop_back();  // the drive
    auto responses = responses_of_the_machine();
    for (const auto& r : further_responses_of_the_machine()) responses.push_back(r);
    expect_response_gradients<G>(machine, tight(0.02, 4e-4), all, responses,
                                 {.largest = c.largest});
  }
};

TEST_P(FormalismResponses, HaveTheDerivativesOfDifferencesAndOfTheAdjointInAPlane) {
  expect_gradients<SE2>();
}

TEST_P(FormalismResponses, HaveThemInSpace) { expect_gradients<SE3>(); }

INSTANTIATE_TEST_SUITE_P(
    All, FormalismResponses,
    ::testing::Values(Case{"r3so3", Formalism::R3SO3}, Case{"classical", Formalism::Classical},
                      Case{"floating", Formalism::Floating, NodeUpdate::AsFormalism, 0.08},
                      Case{"se3_by_r3so3", Formalism::SE3, NodeUpdate::R3SO3}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace liesl::test::formalism_responses_test
