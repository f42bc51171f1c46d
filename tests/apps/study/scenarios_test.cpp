/// @file
/// One design for several motions, and limits that no static problem tells.
#include <gtest/gtest.h>

#include "optim/cycle/motion_cycle.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::scenarios_test {
namespace {

CycleResult<SE2> optimise(const Study& study) {
  const Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  std::vector<Scenario<SE2>> motions{{study.scene.mechanism, space, study.scene.simulation}};
  for (const Scene& scene : study.scenarios)
    motions.push_back({scene.mechanism, space, scene.simulation});
  return run_cycle<SE2>(motions, study.spec);
}

/// Largest value of the limit number `c` in a motion with the design x.
double largest(const Scene& scene, const Study& study, const Eigen::VectorXd& x, int c = 0) {
  const Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  const DesignSimulator<SE2> simulator(scene.mechanism, space, scene.simulation, study.spec);
  return simulator.run(x).limits[static_cast<std::size_t>(c)].largest;
}

TEST(Scenarios, OneDesignMeetsTheLimitInEachMotion) {
  const Study study = shipped_study("rod_three_speeds");
  ASSERT_EQ(study.spec.scenarios, (std::vector<std::string>{"over", "rated", "slow"}));
  const auto r = optimise(study);
  ASSERT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  const double limit = study.spec.constraints[0].limit;
  double most = largest(study.scene, study, r.x);
  for (const Scene& scene : study.scenarios) most = std::max(most, largest(scene, study, r.x));
  EXPECT_LE(most, limit * (1 + 1e-3));
  EXPECT_GE(most, limit * (1 - 1e-3));
  ASSERT_EQ(r.final.size(), 3u);
  EXPECT_NE(r.final[0].limits[0].largest, r.final[1].limits[0].largest);
  ASSERT_FALSE(r.optimality->prices.empty());
  EXPECT_EQ(r.optimality->prices[0].name, "bending (over)");

  // No lighter than the lightest of its worst motion, whose design is another one.
  Study alone = study;
  alone.scenarios.clear();
  alone.spec.scenarios.clear();
  const auto of_one = optimise(alone);
  ASSERT_EQ(of_one.status, CycleStatus::Optimal) << of_one.reason;
  EXPECT_GE(r.mass, of_one.mass * (1 - 1e-3));
}

TEST(Scenarios, TheSameMotionTwiceIsOne) {
  Study study = shipped_study("slider_crank_rod");
  const auto once = optimise(study);
  study.scenarios.push_back(study.scene);
  study.spec.scenarios = {"a", "b"};
  const auto twice = optimise(study);
  EXPECT_EQ(twice.status, CycleStatus::Optimal) << twice.reason;
  EXPECT_NEAR(twice.mass, once.mass, 2e-4 * once.mass);
}

/// What is said of rod_three_speeds with other scenarios; empty if they are taken.
std::string refusal_of(const std::string& scenarios) {
  try {
    shipped_study("rod_three_speeds", {"scenarios={" + scenarios + "}"});
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(Scenarios, HaveTheSameBodiesAndAreMotions) {
  const auto refusal = [](const std::string& change) {
    return refusal_of("a={}, b={set={" + change + "}}");
  };
  EXPECT_NE(refusal("\"bodies.rod.beam.elements\"=4").find("other bodies"), std::string::npos);
  EXPECT_NE(refusal("\"simulation.type\"=\"static\"").find("is no motion"), std::string::npos);
  EXPECT_NE(refusal("\"bodies.rodd.beam.elements\"=4").find("rodd"), std::string::npos);
  EXPECT_NE(refusal("\"sections.rod.diameter\"=0.02")
                .find("scenario 'b' changes what the design varies: 'rod_diameters'"),
            std::string::npos);
  EXPECT_EQ(refusal("\"sections.crank.diameter\"=0.021"), "");
  EXPECT_EQ(refusal("\"gravity\"=[0, 0, 0]"), "");
}

/// Whether it is the first or not: the one that is not as the scene is.
TEST(Scenarios, BlameTheOneThatDiffersFromTheScene) {
  const auto refusal = [](const std::string& change) {
    return refusal_of("a={set={" + change + "}}, b={}, c={}");
  };
  EXPECT_NE(refusal("\"bodies.rod.beam.elements\"=4").find("'a' has other bodies than 'b'"),
            std::string::npos);
  EXPECT_NE(refusal("\"simulation.type\"=\"static\"").find("'a' is no motion"), std::string::npos);
  EXPECT_NE(refusal("\"sections.rod.diameter\"=0.02").find("'a' changes what the design varies"),
            std::string::npos);
}

/// Of the payload: two bodies carry it.
TEST(MotionRows, LimitOnASpeedIsMetAndCostsMass) {
  Study study = shipped_study("robot_arms", {"cycle.feasibility=1e-6"});
  const auto without = optimise(study);
  ASSERT_EQ(without.status, CycleStatus::Optimal) << without.reason;
  ResponseSpec speed;
  speed.name = "speed";
  speed.kind = ResponseKind::Velocity;
  speed.at.body = study.scene.mechanism.body("payload");
  study.spec.constraints.push_back({speed, 10, false});
  const double loose = largest(study.scene, study, without.x, 2);
  const double most = largest(study.scene, study, 1.05 * without.x, 2);
  ASSERT_LT(most, loose) << "stiffer arms vibrate less";
  study.spec.constraints.back().limit = 0.5 * (loose + most);
  const auto with = optimise(study);
  EXPECT_EQ(with.status, CycleStatus::Optimal) << with.reason;
  EXPECT_GT(with.mass, without.mass * (1 + 1e-4));
  EXPECT_LT(with.mass, without.mass * 1.05);
  EXPECT_LE(with.final[0].limits[2].largest, study.spec.constraints[2].limit * (1 + 1e-6));
}

/// The driving force of a joint, which no static problem of a part tells.
TEST(MotionRows, LimitOnAJointForceHoldsAtTheOptimum) {
  Study study = shipped_study("slider_crank_rod", {"design.rod_diameters.start=0.013"});
  ResponseSpec force;
  force.name = "force";
  force.kind = ResponseKind::JointForce;
  force.joint = 1;  // crank and rod
  study.spec.constraints.push_back({force, 1e9, false});
  const auto free = optimise(study);
  const double most = free.final[0].limits[1].largest;
  study.spec.constraints[0].limit *= 1.3;  // a lighter rod is possible, and needs less force
  const auto bent = optimise(study);
  const double least = bent.final[0].limits[1].largest;
  ASSERT_LT(least, most);
  // Between the two the force decides: with the tighter limit on bending it cannot be met.
  study.spec.constraints[1].limit = 0.5 * (least + most);
  const auto both = optimise(study);
  EXPECT_EQ(both.status, CycleStatus::Optimal) << both.reason;
  EXPECT_LE(both.final[0].limits[1].largest, study.spec.constraints[1].limit * (1 + 1e-3));
  study.spec.constraints[0].limit /= 1.3;
  const auto neither = optimise(study);
  EXPECT_EQ(neither.status, CycleStatus::Infeasible) << neither.reason;
}

}  // namespace
}  // namespace liesl::test::scenarios_test
