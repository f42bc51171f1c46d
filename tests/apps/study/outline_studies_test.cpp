/// @file
/// Outlines under the loads of the motion that they have a part in: the shipped studies.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <string>

#include "apps/tasks/outline_kinks.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/shipped.hpp"
#include "reference/solved.hpp"

namespace liesl::test::outline_studies_test {
namespace {

/// The study's part without its openings, named "hole...", "pocket..." or "opening...": its motion
/// and mass.
template <FrameGroup G>
DesignRun<G> full_part(const Study& study) {
  Mechanism mechanism = study.scene.mechanism;
  const int body = study.spec.shapes.begin()->first;
  auto& features = std::get<SolidSpec>(mechanism.bodies[body].kind).outline.features;
  const auto is_opening = [](const std::string& name) {
    return name.starts_with("hole") || name.starts_with("pocket") || name.starts_with("opening");
  };
  std::erase_if(features, [&](const auto& feature) { return is_opening(feature.name); });
  for (auto& feature : features) std::erase_if(feature.operands, is_opening);
  StudySpec spec = study.spec;
  spec.shapes.clear();
  return DesignSimulator<G>(mechanism, space_of<G>(mechanism), study.scene.simulation, spec)
      .run(Eigen::VectorXd());
}

/// What the program has found (status and worst limit: study.NAME.end).
void expect_limit_reached(const nlohmann::json& solved) {
  ASSERT_EQ(solved.at("constraints").size(), 1u);
  const auto& limit = solved.at("constraints").front();
  EXPECT_NEAR(limit.at("max_abs_final").get<double>() / limit.at("limit").get<double>(), 1, 1e-3);
}

TEST(ConnectingRod, IsAQuarterLighterThanTheSolidRod) {
  const Study study = shipped_study("connecting_rod");
  const auto solid = full_part<SE2>(study);
  ASSERT_TRUE(solid.good());
  EXPECT_NEAR(1.5 * solid.limits[0].largest / solid.limits[0].limit, 1, 1e-3);
  const nlohmann::json solved = solved_summary("connecting_rod");
  expect_limit_reached(solved);
  EXPECT_LE(solved.at("history").size(), 12u);
  EXPECT_LE(solved.at("mass_final").get<double>(), 0.75 * solid.mass);
}

/// On an eighth of the cells; the study itself takes minutes (data/studies/README.md). The limit is
/// 1.5 times what the solid rod on that grid needs. The edges of the pockets are drawn to planes of
/// this coarse grid, where the limit has a kink and no gradient vanishes: the end may be converged
/// only, and is then at them, named.
TEST(ConnectingRodSlow, InSpaceWithPocketsIsAQuarterLighterThanTheSolidRod) {
  const std::string coarse = R"(set={"bodies.rod.solid.mesh.cells"=[30,8,4]})";
  Study study = shipped_study("connecting_rod_3d", {coarse});
  const auto solid = full_part<SE3>(study);
  ASSERT_TRUE(solid.good());
  study.spec.constraints[0].limit = 1.5 * solid.limits[0].largest;
  study.spec.cycle.method = CycleMethod::Esl1;
  study.spec.cycle.max = 30;
  const Mechanism& mechanism = study.scene.mechanism;
  const auto r =
      run_cycle<SE3>(mechanism, space_of<SE3>(mechanism), study.scene.simulation, study.spec);
  EXPECT_TRUE(closed(r.status)) << r.reason;
  EXPECT_LE(r.worst, 1e-3);
  EXPECT_NEAR(r.final[0].limits[0].largest / r.final[0].limits[0].limit, 1, 1e-3)
      << "the limit is reached";
  EXPECT_LE(r.mass, 0.75 * solid.mass);
  if (r.status == CycleStatus::Optimal) return;
  const Design design(study.spec, study.scene.mechanism);
  const auto said = end_warnings("rod", design.part(0), design.of_part(0, r.x));
  ASSERT_EQ(said.size(), 1u) << r.reason;
  EXPECT_NE(said[0].find("pocket_height"), std::string::npos) << said[0];
}

/// The study goes on with finer models: the first outline is that of its start, whatever model the
/// last cycles are simulated with.
TEST(RobotArmLatticeSlow, HasAnOutlineForEachCycle) {
  const nlohmann::json solved = solved_summary("robot_arm_lattice");
  ASSERT_TRUE(solved.contains("refinement"));
  std::ifstream table(solved_folder("robot_arm_lattice") / "arm_outlines.csv");
  std::set<std::string> steps;
  std::string row;
  std::getline(table, row);
  while (std::getline(table, row)) steps.insert(row.substr(0, row.find(',')));
  EXPECT_GE(steps.size(), solved.at("cycles").get<std::size_t>());
  EXPECT_LE(steps.size(), solved.at("cycles").get<std::size_t>() + 1) << "the final design";
}

TEST(RobotArmLatticeSlow, IsAQuarterLighterThanTheFullArm) {
  const Study study = shipped_study("robot_arm_lattice");
  const auto full = full_part<SE2>(study);
  ASSERT_TRUE(full.good());
  EXPECT_LT(full.limits[0].largest, full.limits[0].limit);
  const nlohmann::json solved = solved_summary("robot_arm_lattice");
  expect_limit_reached(solved);
  EXPECT_LE(solved.at("mass_final").get<double>(), 0.75 * full.mass);
}

}  // namespace
}  // namespace liesl::test::outline_studies_test
