/// @file
/// Springs and rigid masses as design variables: closed forms.
#include <gtest/gtest.h>

#include "optim/cycle/motion_cycle.hpp"
#include "reference/studies.hpp"

namespace liesl::test::constants_test {
namespace {

/// A mass on a spring, pushed by a constant force from rest: v(t) = F/sqrt(k m) sin(sqrt(k/m) t).
StudyCase block_on_a_spring() {
  StudyCase s;
  Mechanism& m = s.scene.mechanism;
  m.bodies = {{"block", block({0, 0, 0}, 2, 1)}};
  m.joints = {{"rail", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()}};
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 0;
  spring.stiffness = 50;
  m.forces = {spring};
  LoadSpec push;
  push.name = "push";
  push.port = {0, 0};
  push.force = {10, 0, 0};
  m.loads = {push};
  s.scene.simulation.duration = 2;
  s.scene.simulation.step = 2e-3;
  s.scene.simulation.rho_inf = 1;
  return s;
}

StudySpec lightest_block(double limit) {
  StudySpec study;
  study.mass_of = {0};
  ConstantSpec mass{.name = "mass",
                    .quantity = ConstantQuantity::Mass,
                    .force = -1,
                    .turns = false,
                    .body = study.mass_of[0],
                    .lower = 0.2,
                    .upper = 10,
                    .start = {}};
  ConstantSpec spring{.name = "spring",
                      .quantity = ConstantQuantity::Stiffness,
                      .force = 0,
                      .turns = false,
                      .body = -1,
                      .lower = 20,
                      .upper = 100,
                      .start = {}};
  study.constants = {mass, spring};
  ResponseSpec speed;
  speed.name = "speed";
  speed.kind = ResponseKind::Velocity;
  speed.at = {0, 0};
  speed.axis = Vec3::UnitX();
  study.constraints = {{speed, limit, false}};
  return study;
}

TEST(Constants, LightestBlockOnASpringIsThatOfTheClosedForm) {
  const auto scene = block_on_a_spring().scene;
  const double F = 10, k = 100, v = 0.9;
  StudySpec study = lightest_block(v);
  for (const CycleMethod method : {CycleMethod::Esl1, CycleMethod::Full}) {
    study.cycle.method = method;
    const auto r =
        run_cycle<SE3>(scene.mechanism, space_of<SE3>(scene.mechanism), scene.simulation, study);
    ASSERT_EQ(r.status, CycleStatus::Optimal) << r.reason;
    EXPECT_NEAR(r.x[1], k, 1e-3 * k) << "the stiffest spring";
    EXPECT_NEAR(r.mass, F * F / (k * v * v), 1e-3 * r.mass);
    EXPECT_NEAR(r.final[0].limits[0].largest, v, 1e-3 * v);
    // The limit's price: dm/dv v = -2 m.
    ASSERT_EQ(r.optimality->prices.size(), 1u);
    EXPECT_NEAR(r.optimality->prices[0].price, 2 * r.mass, 0.01 * r.mass);
  }
}

TEST(Constants, PlainMethodAndStaticsRefuseThem) {
  const auto scene = block_on_a_spring().scene;
  StudySpec study = lightest_block(0.9);
  study.cycle.method = CycleMethod::Esl;
  EXPECT_THROW(
      run_cycle<SE3>(scene.mechanism, space_of<SE3>(scene.mechanism), scene.simulation, study),
      std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::constants_test
