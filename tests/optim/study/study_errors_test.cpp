/// @file
/// A study with errors is refused by the library, whoever made it, with all of them at once.
#include "optim/study/study_errors.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "mbs/run.hpp"
#include "optim/problems/design_run.hpp"
#include "reference/studies.hpp"

namespace liesl::test::study_errors_test {
namespace {

std::string joined(const std::vector<std::string>& errors) {
  std::string text;
  for (const auto& e : errors) text += e + "\n";
  return text;
}

TEST(StudyErrors, AGoodStudyHasNone) {
  for (const StudyCase& study :
       {slider_crank_rod(), svanberg_cantilever(), esl_oscillates(), esl_non_optimal()})
    EXPECT_EQ(joined(study_errors(study.spec, study.scene.mechanism)), "") << study.spec.name;
}

TEST(StudyErrors, AllAreListedWithPlaceExpectedAndGot) {
  const StudyCase good = slider_crank_rod();
  StudySpec study = good.spec;
  study.cycle.max = 0;
  study.cycle.move_limit = 1.5;
  study.cycle.min_cases = 0;
  study.design[0].lower = 0.03;
  study.design[0].properties = {"girth"};
  study.design[0].start = {0.01, 0.02};
  study.constraints[0].limit = 0;
  study.mass_of.push_back(study.mass_of[0]);
  study.mass_of.push_back(99);
  study.part_limits.push_back({"heavy", study.mass_of[0], SolidResponse::Mass, 1, 1});
  const std::string text = joined(study_errors(study, good.scene.mechanism));
  for (const char* said :
       {"cycle.max: expected >= 1, got 0", "cycle.move_limit: expected in (0, 1], got 1.5",
        "cycle.min_cases: expected >= 1, got 0", "got [0.03, ", "got \"girth\"",
        "one for each of 4 groups, got 2", "expected a limit > 0, got 0", "got 99",
        "part limit 'heavy': expected a meshed part, got 'rod'"})
    EXPECT_NE(text.find(said), std::string::npos) << said << " is missing in\n" << text;
  EXPECT_NE(text.find("got " + std::to_string(study.mass_of[0]) + " twice"), std::string::npos)
      << text;
}

TEST(StudyErrors, AreRefusedBeforeAnythingIsSimulated) {
  const StudyCase good = slider_crank_rod();
  StudySpec study = good.spec;
  study.cycle.max = -1;
  study.cycle.tolerance = 0;
  try {
    DesignSimulator<SE2>(good.scene.mechanism, space_of<SE2>(good.scene.mechanism),
                         good.scene.simulation, study);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("cycle.max"), std::string::npos) << text;
    EXPECT_NE(text.find("cycle.tolerance"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace liesl::test::study_errors_test
