/// @file
/// Tolerances so tight that rounding of the iteration is about as large. Status, reason and figures
/// speak of the design that is returned (version 0.1 ended "infeasible" with a design that met all
/// limits).
#include "apps/program.hpp"

namespace liesl::test::tight_tolerances_test {
namespace {

using TightTolerances = Program;
using TightTolerancesSlow = Program;

/// Below the round-off of forces and positions a step has converged where it can come no nearer.
TEST_F(TightTolerances, BelowRoundOffAMotionReachesItsEnd) {
  double before = 0;
  for (const char* tolerance : {"1e-11", "1e-14"}) {
    const Outcome o = run({"run", scene("four_bar"), "-o", results(), "-q", "-f", "--no-report",
                           "--set", std::string("simulation.tolerance=") + tolerance, "--set",
                           "simulation.tangent=exact"});
    ASSERT_EQ(o.code, 0) << o.out << o.err;
    const Json s = summary();
    EXPECT_EQ(s["rejected_steps"], 0);
    const double bend = s["responses"]["bend"]["max_abs"];
    if (before > 0) EXPECT_NEAR(bend, before, 1e-9 * before);
    before = bend;
  }
}

TEST_F(TightTolerancesSlow, StatusSpeaksOfTheDesignThatIsReturned) {
  const double tolerance = 1e-6;
  const Outcome o = run({"optimize", study("slider_crank_both"), "-o", results(), "--no-report",
                         "--no-verify", "--set", "cycle.feasibility=1e-6", "--set",
                         "cycle.tolerance=1e-6", "--set", "cycle.objective_tolerance=1e-6"});
  const Json s = summary();
  double worst = -1;
  for (const auto& [name, limit] : s["constraints"].items())
    worst =
        std::max(worst, limit["max_abs_final"].get<double>() / limit["limit"].get<double>() - 1);
  EXPECT_NEAR(s["worst_constraint"].get<double>(), worst, 1e-9);
  EXPECT_EQ(s["status"], "optimal") << s["reason"];
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_LE(worst, tolerance);
  EXPECT_LE(s["kkt_residual"].get<double>(), 1e-2);

  // The design that was written, simulated on its own: it asks for a tolerance that resolves this.
  ASSERT_EQ(run({"run", results() / "design.toml", "-o", dir_ / "again", "--no-report"}).code, 0);
  const Json again = Json::parse(text_of(dir_ / "again" / "summary.json"));
  EXPECT_NEAR(again["responses"]["bend"]["max_abs"].get<double>(),
              s["constraints"]["rod_bending"]["max_abs_final"].get<double>(), 1e-12);
}

}  // namespace
}  // namespace liesl::test::tight_tolerances_test
