/// @file
/// Stress and compliance of a meshed part as limits of its motion: what is read and refused, and
/// where studies end.
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/good_scene.hpp"
#include "apps/study/rod_study.hpp"

namespace liesl::test::part_response_study_test {
namespace {

std::string constraint(const std::string& response) {
  return rod_text("[constraints]\npeak = { " + response + " }\n");
}

TEST(PartResponseStudy, IsALimitKnownByItsGradient) {
  for (const std::string name : {"stress", "compliance"}) {
    const Study study =
        read_rod(constraint("response = \"" + name + "\", of = \"rod\", limit = 1e8"));
    ASSERT_EQ(study.spec.constraints.size(), 1u);
    const ConstraintSpec& c = study.spec.constraints[0];
    EXPECT_FALSE(c.has_image);
    EXPECT_EQ(c.response.body, study.scene.mechanism.body("rod"));
    EXPECT_EQ(c.response.kind, name == "stress" ? ResponseKind::Stress : ResponseKind::Compliance);
  }
}

TEST(PartResponseStudy, AStressOfPascalsIsNoted) {
  const Study study = read_rod(constraint("response = \"stress\", of = \"rod\", limit = 50"));
  const auto& warnings = study.scene.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& w) {
    return w.starts_with("constraints.peak.limit = 50 Pa is far below");
  }));
}

TEST(PartResponseStudy, IsRefusedWhereOnlyStaticProblemsAreSolved) {
  const auto refuse = [](const std::string& text, const std::vector<const char*>& words) {
    const auto take = [](const auto& said, const auto& file) { read_rod(said, file); };
    expect_refused(MarkedText(text), "study.toml", take, words);
  };
  const std::string peak = constraint("response = @\"stress\", of = \"rod\", limit = 5e7");
  refuse(peak + "[cycle]\nmethod = \"esl\"\n",
         {"constraint 'peak' is of a meshed part in its motion, and the method \"esl\"",
          "expected an entry in [part_limits]"});
  refuse(peak + "[loads]\npull = { at = \"rod.small_end\", force = [1, 0, 0] }\n",
         {"is of a meshed part in its motion, and fixed loads have no motion",
          "expected an entry in [part_limits]"});
}

TEST(PartResponseStudy, StressEndsAtTheOptimumOfTheMotion) {
  const auto limited = [](double limit) {
    const std::string words = "response = \"stress\", of = \"rod\", limit = ";
    return optimise(read_rod(constraint(words + std::to_string(limit))));
  };
  const double limit = 80e6;
  const auto end = limited(limit);
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_NEAR(end.final.front().limits[0].largest / limit, 1, 1e-3);
  ASSERT_EQ(end.optimality->prices.size(), 1u);
  EXPECT_EQ(end.optimality->prices[0].name, "peak");
  // What the price says, against optima of other limits.
  const auto less = limited(0.99 * limit), more = limited(1.01 * limit);
  EXPECT_NEAR((less.mass - more.mass) / (0.02 * end.optimality->prices[0].price), 1, 0.03);
}

/// Twice the elastic energy is the work of the loads: the same limit in both families.
TEST(PartResponseStudy, ComplianceEndsWhereThatOfThePartLimitDoes) {
  const std::string limit = "limit = 1.25",
                    soft = "soft = { of = \"rod\", quantity = \"compliance\", " + limit + " }\n";
  const auto response =
      optimise(read_rod(constraint("response = \"compliance\", of = \"rod\", " + limit)));
  const auto part = optimise(read_rod(rod_text("[part_limits]\n" + soft)));
  ASSERT_EQ(response.status, CycleStatus::Optimal) << response.reason;
  ASSERT_EQ(part.status, CycleStatus::Optimal) << part.reason;
  EXPECT_NEAR(response.mass / part.mass, 1, 1e-4);
  EXPECT_NEAR(response.final.front().limits[0].largest, 1.25, 1e-3);
}

}  // namespace
}  // namespace liesl::test::part_response_study_test
