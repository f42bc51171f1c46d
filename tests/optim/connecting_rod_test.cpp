/// @file
/// The outline of a connecting rod under the loads of its own motion: the shipped study.
#include <gtest/gtest.h>

#include <cmath>

#include "optim/cycle/esl_cycle.hpp"
#include "reference/shipped.hpp"

namespace liesl {
namespace {

/// The study's rod without holes: its motion and mass.
DesignRun<SE2> solid_rod(const Study& study) {
  Mechanism mechanism = study.scene.mechanism;
  const int body = study.spec.shapes.begin()->first;
  auto& features = std::get<SolidSpec>(mechanism.bodies[body].kind).outline.features;
  const auto is_hole = [](const std::string& name) { return name.starts_with("hole"); };
  std::erase_if(features, [&](const auto& feature) { return is_hole(feature.name); });
  for (auto& feature : features) std::erase_if(feature.operands, is_hole);
  StudySpec spec = study.spec;
  spec.shapes.clear();
  const Space<SE2> space = test::space_of<SE2>(mechanism);
  return DesignSimulator<SE2>(mechanism, space, study.scene.simulation, spec)
      .run(Eigen::VectorXd());
}

TEST(ConnectingRodSlow, IsAQuarterLighterThanTheSolidRod) {
  const Study study = test::shipped_study("connecting_rod");
  const DesignRun<SE2> solid = solid_rod(study);
  ASSERT_TRUE(solid.good());
  EXPECT_NEAR(1.5 * solid.limits[0].largest / solid.limits[0].limit, 1, 1e-3);

  const Space<SE2> space = test::space_of<SE2>(study.scene.mechanism);
  const CycleResult<SE2> r =
      run_cycle<SE2>(study.scene.mechanism, space, study.scene.simulation, study.spec);
  EXPECT_EQ(r.status, CycleStatus::Converged) << r.reason;
  EXPECT_LE(r.history.size(), 12u);
  EXPECT_LE(r.worst, 1e-3);
  EXPECT_NEAR(r.final[0].largest / r.final[0].limit, 1, 1e-3) << "the limit is reached";
  EXPECT_LE(r.mass, 0.75 * solid.mass);
}

}  // namespace
}  // namespace liesl
