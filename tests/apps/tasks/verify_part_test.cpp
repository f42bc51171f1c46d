#include "apps/tasks/verify_part.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/study/load_study.hpp"
#include "tests/apps/program.hpp"

namespace liesl::test::verify_part_test {
namespace {

/// A few designs of a shipped study, and its part at the last one.
struct PartUnderLoads {
  explicit PartUnderLoads(const char* name) : file(study(name)) {
    const Study study = read({});
    out = optimize_part_task(study, {}, 0, {}, {});
  }

  Study read(const std::vector<std::string>& changes) const {
    std::vector<std::string> all = changes;
    all.insert(all.begin(), "cycle.max=2");
    return load_study(file, all);
  }
  std::vector<VerifiedLimit> verified() {
    return verify_part(out, read({}), [this](const auto& changes) { return read(changes); });
  }
  /// Of the final outline on another grid.
  StaticCheck check(const std::string& cells) const {
    Study s = read({cells});
    Mechanism& m = s.scene.mechanism;
    for (BodySpec& body : m.bodies)
      if (body.name == out.parts[0].name)
        std::get<SolidSpec>(body.kind).outline = out.parts[0].outline;
    PartShape part(m, m.body(out.parts[0].name), {});
    const SolidTask task = solid_task(s.spec, part);
    return dynamic_cast<const PartAnalysis&>(*PartModel(task).analyse(part.design.start(), {}))
        .check;
  }

  std::string file;
  OptimizeOutcome out;
};

/// Errors against a grid four times as fine lie within a factor of 3 of the estimates.
TEST(VerifyPart, ErrorsAreThoseAgainstAFinerGrid) {
  PartUnderLoads part("cantilever");
  const std::vector<VerifiedLimit> limits = part.verified();
  ASSERT_EQ(limits.size(), 1u);
  ASSERT_TRUE(limits[0].known);
  const StaticCheck fine = part.check("bodies.plate.solid.mesh.cells=[320, 160]");
  const auto& summary = part.out.summary;
  const auto& sag = summary.constraints.at(0);
  const double error = std::abs(sag.max_abs_final - fine.limits[0].value);
  EXPECT_GT(error, 0.0);
  EXPECT_LT(error, 3 * *sag.error_mesh);
  EXPECT_GT(error, *sag.error_mesh / 3);
  EXPECT_DOUBLE_EQ(limits[0].mesh, *sag.error_mesh / sag.limit);
  EXPECT_FALSE(sag.error_step);
  EXPECT_DOUBLE_EQ(summary.more["worst_constraint_error"].get<double>(), limits[0].mesh);
}

TEST(VerifyPart, TheObjectiveHasItsError) {
  PartUnderLoads part("cantilever_holes");
  part.verified();
  const StaticCheck fine = part.check("bodies.plate.solid.mesh.cells=[320, 160]");
  const auto& objective = part.out.summary.more["objective"];
  const double error = std::abs(objective["final"].get<double>() - fine.objective),
               estimate = objective["error"]["mesh"].get<double>();
  EXPECT_LT(error, 3 * estimate);
  EXPECT_GT(error, estimate / 3);
  // The box of its interface holds one node of a grid half as fine: no order is seen.
  EXPECT_EQ(part.out.summary.more["verification"]["runs"], 2);
}

TEST(VerifyPart, WithoutRoomTheLimitsAreNotVerified) {
  PartUnderLoads part("cantilever_holes");
  Study coarse = part.read({});
  const auto large = verify_part(part.out, coarse, [&part](const auto& changes) {
    if (!changes.empty()) throw InputError({{"study.toml", 1, 1, "too many", "fewer", ""}});
    return part.read({});
  });
  EXPECT_TRUE(large.empty());
  EXPECT_NE(part.out.summary.warnings.back().find("were not verified: bodies.plate.solid.mesh"),
            std::string::npos)
      << part.out.summary.warnings.back();
}

}  // namespace
}  // namespace liesl::test::verify_part_test
