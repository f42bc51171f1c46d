/// @file
/// New holes: where they are proposed, what they become, and that they pay.
#include "optim/cycle/topology_cycle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "apps/study/load_study.hpp"
#include "mbs/levelset/shape_spec.hpp"
#include "optim/cycle/solid_task.hpp"
#include "optim/nlp/check_derivatives.hpp"
#include "reference/places.hpp"

namespace liesl::test {
namespace {

using Eigen::VectorXd;
using levelset::FeatureKind;
using levelset::ShapeSpec;

/// The shipped study on a coarser mesh.
Study cantilever(const std::vector<std::string>& more = {}) {
  std::vector<std::string> set = {"bodies.plate.solid.mesh.cells=[60, 30]"};
  set.insert(set.end(), more.begin(), more.end());
  return load_study(std::filesystem::path(test::kDataDir) / "studies/cantilever.toml", set);
}

SolidSpec& solid_of(Study& study) {
  return std::get<SolidSpec>(study.scene.mechanism.bodies[0].kind);
}

TopologyResult optimised(const Study& study, int most, const TopologyHooks& hooks = {}) {
  return optimise_topology(study.spec, study.scene.mechanism, 0, most, hooks);
}

TEST(TopologyCycle, AHoleMakesTheCantileverLighterAtTheSameLimit) {
  const Study study = cantilever();
  const TopologyResult without = optimised(study, 0), with = optimised(study, 1);
  ASSERT_EQ(without.shape.status, CycleStatus::Converged) << without.shape.reason;
  ASSERT_TRUE(without.proposal.nucleus) << without.proposal.reason;
  ASSERT_EQ(with.shape.status, CycleStatus::Converged) << with.shape.reason;
  ASSERT_EQ(with.holes.size(), 1u);
  EXPECT_TRUE(with.holes[0].pays);
  EXPECT_EQ(with.outline.features.size(), without.outline.features.size() + 2);
  const SolidCheck &a = without.shape.history.back().check, &b = with.shape.history.back().check;
  EXPECT_NEAR(a.worst, 0, study.spec.cycle.feasibility);
  EXPECT_LE(b.worst, study.spec.cycle.feasibility);
  EXPECT_LT(b.mass, 0.95 * a.mass);
  // The history goes on from the optimum without the hole, and is numbered through.
  EXPECT_EQ(with.shape.history[with.round - 1].x, without.shape.x);
  for (std::size_t i = 0; i < with.shape.history.size(); ++i)
    EXPECT_EQ(with.shape.history[i].number, static_cast<int>(i) + 1);
}

/// The Lagrangian with a small hole of the level set in the mesh, against the derivative.
TEST(TopologyCycle, TheGainIsWhatASmallHoleOfTheOutlineDoes) {
  Study study = cantilever({"bodies.plate.solid.mesh.cells=[160, 80]"});
  const TopologyResult r = optimised(study, 0);
  ASSERT_TRUE(r.proposal.nucleus) << r.proposal.reason;
  // At the optimum L = mass + lambda (sag/limit - 1) is stationary in the height: lambda from it.
  const auto figures = [&](const ShapeSpec& outline, double height) {
    solid_of(study).outline = outline;
    for (auto& f : solid_of(study).outline.features)
      if (f.name == "plate") f.values[4] = height;
    PartShape part(study.scene.mechanism, 0, study.spec.shapes.at(0));
    const SolidTask task = solid_task(study.spec, part);
    const auto check = StaticShape(task, part.design.start(), 1).check(part.design.start());
    return std::pair(check->mass, check->limits[0].excess);
  };
  const double h = r.shape.x[0], d = 1e-5;
  const auto up = figures(r.outline, h + d), down = figures(r.outline, h - d);
  const double lambda = -(up.first - down.first) / (up.second - down.second);
  ShapeSpec holed = r.outline;
  ShapeDesignSpec ignored;
  Nucleus small = *r.proposal.nucleus;
  insert_hole(small, solid_of(study).mesh, holed, ignored);
  const auto before = figures(r.outline, h), after = figures(holed, h);
  const double volume = std::numbers::pi * small.radius * small.radius * solid_of(study).thickness;
  const double change = after.first - before.first + lambda * (after.second - before.second);
  EXPECT_NEAR(-change / volume / small.gain, 1, 0.1);
}

TEST(TopologyCycle, NucleiKeepAwayFromEdgesInterfacesAndWalls) {
  const Study study = cantilever();
  const TopologyResult r = optimised(study, 0);
  const SolidTask task = solid_task(study.spec, *r.part);
  const auto proposed = [&](double wall) {
    return propose_hole(task, {{"edge", "plate", "tip", wall}}, r.shape.x);
  };
  const HoleProposal proposal = proposed(0.012);
  ASSERT_TRUE(proposal.nucleus) << proposal.reason;
  const Nucleus& n = *proposal.nucleus;
  for (const Interface& interface : r.part->model.interfaces())
    for (const int node : interface.nodes)
      EXPECT_GE((r.part->model.mesh().nodes.col(node) - n.place).norm(), n.radius + 0.012);
  EXPECT_LE(std::abs(n.place[1]) + n.radius + 0.012, r.shape.x[0] / 2);
  EXPECT_GT(n.gain, 0);
  EXPECT_LT(n.gain, task.model->material().rho);
  for (int e = 0; e < proposal.gain.size(); ++e)
    if (r.shape.fractions[e] < 1) {
      EXPECT_EQ(proposal.gain[e], 0);
    }
  EXPECT_NE(proposed(0.1).reason.find("far enough from all edges"), std::string::npos);
}

TEST(TopologyCycle, InsertedHolesAreFeaturesWithVariablesAndWalls) {
  Study study = cantilever();
  ShapeSpec& outline = solid_of(study).outline;
  ShapeDesignSpec& design = study.spec.shapes.at(0);
  design.walls = {{"rim", "plate", "tip", 0.01}, {"rim2", "plate", "wall", 0.004}};
  const Nucleus one{{0.1, 0.01, 0}, 0.008, 1}, two{{0.05, 0.01, 0}, 0.008, 1};
  EXPECT_EQ(insert_hole(one, solid_of(study).mesh, outline, design), "new_hole1");
  EXPECT_EQ(insert_hole(two, solid_of(study).mesh, outline, design), "new_hole2");
  EXPECT_TRUE(shape_errors(outline).empty());
  ASSERT_EQ(outline.features.size(), 4u);  // plate, the difference, two holes
  EXPECT_EQ(design.variables.size(), 1u + 2 * 4);
  ASSERT_EQ(design.walls.size(), 2u + 3 + 4);
  const WallSpec& between = *std::find_if(design.walls.begin(), design.walls.end(),
                                          [](const WallSpec& w) { return w.to == "new_hole1"; });
  EXPECT_EQ(between.feature, "new_hole2");
  EXPECT_EQ(between.least, 0.004);
  const auto shape = make_shape(outline);
  EXPECT_NEAR(shape->value({0.1, 0.01, 0}), -0.008, 1e-9);
  EXPECT_GT(shape->value({0.1, 0.02, 0}), 0);
  PartShape part(study.scene.mechanism, 0, design);  // what a study may hold
  EXPECT_EQ(part.design.start()[1], 0.1);
}

TEST(TopologyCycle, ASpatialNucleusIsAnEllipsoid) {
  ShapeSpec outline;
  outline.dim = 3;
  outline.features = {{"block", FeatureKind::Box, {0, 0, 0, 0, 0, 0, 2, 2, 2, 0}, {}},
                      {"bore", FeatureKind::Sphere, {1, 1, 1, 0, 0, 0, 0.3}, {}},
                      {"part", FeatureKind::Difference, {}, {"block", "bore"}}};
  ShapeDesignSpec design;
  insert_hole({{0.1, 0.2, -0.3}, 0.25, 1}, hex_grid({-1, -1, -1}, {1, 1, 1}, 8, 8, 8), outline,
              design);
  EXPECT_TRUE(shape_errors(outline).empty());
  EXPECT_EQ(outline.features[2].operands.size(), 3u);
  EXPECT_EQ(design.variables.size(), 6u);
  EXPECT_NEAR(make_shape(outline)->value({0.1, 0.2, -0.3 + 0.25}), 0, 1e-12);
}

TEST(TopologyCycle, SaysWhyThereIsNoProposal) {
  const TopologyResult stress =
      optimised(cantilever({"constraints={}",
                            "part_limits.peak={of=\"plate\", quantity=\"stress\", "
                            "limit=2e8}"}),
                1);
  EXPECT_FALSE(stress.proposal.nucleus);
  EXPECT_NE(stress.proposal.reason.find("no topological derivative of the stress limit 'peak'"),
            std::string::npos)
      << stress.proposal.reason;
  EXPECT_TRUE(stress.holes.empty());

  const TopologyResult infeasible = optimised(cantilever({"constraints.sag.limit=1e-5"}), 1);
  EXPECT_EQ(infeasible.shape.status, CycleStatus::Infeasible);
  EXPECT_NE(infeasible.proposal.reason.find("no optimum to start from"), std::string::npos);
}

TEST(TopologyCycle, AHoleThatDoesNotPayIsTakenOutAgain) {
  Study study = cantilever();
  study.spec.cycle.objective_tolerance = 0.9;  // asks for a tenth of the mass
  const TopologyResult without = optimised(study, 0), tried = optimised(study, 3);
  ASSERT_EQ(tried.holes.size(), 1u);
  EXPECT_FALSE(tried.holes[0].pays);
  EXPECT_EQ(tried.shape.x, without.shape.x);
  EXPECT_EQ(tried.shape.history.size(), without.shape.history.size());
  EXPECT_EQ(tried.outline.features.size(), without.outline.features.size());
  EXPECT_FALSE(tried.proposal.nucleus);
  EXPECT_NE(tried.proposal.reason.find("does not pay"), std::string::npos);
}

TEST(TopologyCycle, InterruptedWhileAHoleIsTriedItKeepsTheDesignBefore) {
  const Study study = cantilever();
  bool hole = false;
  TopologyHooks hooks;
  hooks.keep_going = [&] { return !hole; };
  hooks.on_hole = [&](const std::string&, const Nucleus&) { hole = true; };
  const TopologyResult r = optimised(study, 3, hooks), without = optimised(study, 0);
  EXPECT_EQ(r.shape.status, CycleStatus::Interrupted);
  EXPECT_EQ(r.shape.x, without.shape.x);
  EXPECT_EQ(r.holes.size(), 1u);
}

/// The gradients of a study with an inserted hole are those of any other study.
TEST(TopologyCycle, GradientsWithAnInsertedHolePassTheStepSweep) {
  Study study = cantilever();
  insert_hole({{0.09, 0.012, 0}, 0.009, 1}, solid_of(study).mesh, solid_of(study).outline,
              study.spec.shapes.at(0));
  PartShape part(study.scene.mechanism, 0, study.spec.shapes.at(0));
  const SolidTask task = solid_task(study.spec, part);
  StaticShape problem(task, part.design.start(), 100);
  const DerivativeReport report = check_derivatives(problem, part.design.start(), {});
  for (const auto& check : report.checks)
    EXPECT_LE(check.best_error, 1e-6) << check.function << '\n' << report.text();
}

}  // namespace
}  // namespace liesl::test
