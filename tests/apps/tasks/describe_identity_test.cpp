/// @file
/// What is told of static problems that give a deformation back, and of those that have no
/// solution.
#include "apps/tasks/describe_identity.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace liesl::test::describe_identity_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

TEST(DescribeIdentity, HasTheDifferences) {
  std::vector<std::string> warnings;
  const auto j = describe_identity({1e-11, 2e-3, 8}, "rod", warnings);
  EXPECT_EQ(j.dump(), R"({"nonlinear":1e-11,"linear":0.002,"cases":8})");
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(difference_text(1e-11), "1.0e-11");
}

/// Null alone would be silent, infinite is no number of JSON.
TEST(DescribeIdentity, WithoutSolutionIsNullAndWarned) {
  std::vector<std::string> warnings;
  const auto j = describe_identity({kNone, 2e-3, 8}, "rod", warnings);
  EXPECT_TRUE(j["nonlinear"].is_null());
  EXPECT_EQ(j["linear"], 2e-3);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("'rod'"), std::string::npos) << warnings[0];
  EXPECT_EQ(difference_text(kNone), "no solution");
  describe_identity({kNone, kNone, 8}, "rod", warnings);
  EXPECT_EQ(warnings.size(), 2u) << "one for a part, not one for a number";
}

}  // namespace
}  // namespace liesl::test::describe_identity_test
