/// @file
/// New holes under the loads of a motion: the arm of a robot, without its openings.
#include <gtest/gtest.h>

#include "optim/cycle/topology_cycle.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::motion_topology_test {
namespace {

/// A plate whose height is the only variable; holes keep 10 mm from its edge and the flanges.
Study plain_arm() {
  Study study = shipped_study("robot_arm_lattice");
  const int body = study.spec.shapes.begin()->first;
  auto& features = std::get<SolidSpec>(study.scene.mechanism.bodies[body].kind).outline.features;
  const auto is_opening = [](const std::string& name) { return name.starts_with("opening"); };
  std::erase_if(features, [&](const auto& feature) { return is_opening(feature.name); });
  for (auto& feature : features) std::erase_if(feature.operands, is_opening);
  study.spec.shapes.at(body) = {
      {{"height", {{"plate.height", 1}}, 0.07, 0.0885, {}}},
      {{"shoulder", "plate", "shoulder", 0.01}, {"elbow", "plate", "elbow", 0.01}}};
  study.spec.cycle.objective_tolerance = 1e-3;
  study.spec.cycle.optimality = OptimalityCheck::Never;
  return study;
}

TEST(MotionTopologySlow, AHoleMakesTheArmLighterAtTheSameLimit) {
  const Study study = plain_arm();
  const Mechanism& mechanism = study.scene.mechanism;
  const SimulationOptions& simulation = study.scene.simulation;
  const Space<SE2> space = space_of<SE2>(mechanism);
  using End = CycleResult<SE2>;
  const auto optimised = [&](int most) {
    return optimise_in_rounds<End>(study.spec, mechanism, most,
                                   [&](const StudySpec& spec, const Mechanism& at,
                                       const CycleHooks& hooks, const std::vector<Cycle>& resume) {
                                     return run_cycle<SE2>(at, space, simulation, spec, hooks,
                                                           resume);
                                   },
                                   {});
  };
  const Topology<End> proposed = optimised(0), holed = optimised(1);
  const End &without = proposed.last.end, &with = holed.last.end;
  ASSERT_TRUE(closed(without.status)) << without.reason;
  EXPECT_TRUE(proposed.holes.empty());
  ASSERT_TRUE(proposed.next) << proposed.reason;
  EXPECT_GT(proposed.next->hole.nucleus->gain, 0);
  EXPECT_LE(proposed.next->hole.nucleus->gain, 2700 * (1 + 1e-12)) << "more than the density";

  ASSERT_EQ(holed.holes.size(), 1u);
  EXPECT_TRUE(holed.holes[0].kept) << holed.holes[0].reason;
  EXPECT_EQ(holed.holes[0].before, without.mass);
  EXPECT_LT(with.mass, (1 - 1e-3) * without.mass);
  EXPECT_LE(with.worst, 1e-3);
  EXPECT_EQ(holed.first.first->mass, without.mass_initial);
  EXPECT_EQ(with.x.size(), 5);
}

}  // namespace
}  // namespace liesl::test::motion_topology_test
