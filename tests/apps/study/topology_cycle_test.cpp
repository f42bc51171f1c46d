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
#include "mbs/solids/solid_model.hpp"
#include "optim/nlp/check_derivatives.hpp"
#include "optim/problems/mesh_statics.hpp"
#include "optim/problems/solid_task.hpp"
#include "reference/places.hpp"

namespace liesl::test::topology_cycle_test {
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

using Result = Topology<PartEnd>;

Result optimised(const Study& study, int most, const TopologyHooks& hooks = {},
                 const RoundHistory& resume = {}) {
  return optimise_in_rounds<PartEnd>(
      study.spec, study.scene.mechanism, most,
      [](const StudySpec& spec, const Mechanism& mechanism, const CycleHooks& cycle,
         const std::vector<Cycle>& cycles) {
        return optimise_outline(spec, mechanism, 0, cycle, cycles);
      },
      hooks, resume);
}

const PartEnd& end(const Result& r) { return r.last.end; }
const ShapeSpec& outline(const Result& r) {
  return std::get<SolidSpec>(end(r).mechanism.bodies[0].kind).outline;
}

TEST(TopologyCycle, AHoleMakesTheCantileverLighterAtTheSameLimit) {
  const Study study = cantilever();
  const Result without = optimised(study, 0), with = optimised(study, 1);
  ASSERT_EQ(end(without).status, CycleStatus::Optimal) << end(without).reason;
  ASSERT_TRUE(without.next) << without.reason;
  ASSERT_EQ(end(with).status, CycleStatus::Optimal) << end(with).reason;
  ASSERT_EQ(with.holes.size(), 1u);
  EXPECT_TRUE(with.holes[0].kept);
  EXPECT_EQ(outline(with).features.size(), outline(without).features.size() + 2);
  const StaticCheck &a = end(without).final, &b = end(with).final;
  EXPECT_NEAR(a.worst, 0, study.spec.cycle.feasibility);
  EXPECT_LE(b.worst, study.spec.cycle.feasibility);
  EXPECT_LT(b.mass, 0.95 * a.mass);
  // The round of the hole goes on from the optimum without it.
  EXPECT_EQ(with.before.size(), end(without).history.size());
  EXPECT_EQ(end(with).history.front().x[0], end(without).x[0]);
}

/// The Lagrangian with a small hole of the level set in the mesh, against the derivative.
TEST(TopologyCycleSlow, TheGainIsWhatASmallHoleOfTheOutlineDoes) {
  Study study = cantilever({"bodies.plate.solid.mesh.cells=[160, 80]"});
  const Result r = optimised(study, 0);
  ASSERT_TRUE(r.next) << r.reason;
  // At the optimum L = mass + lambda (sag/limit - 1) is stationary in the height: lambda from it.
  const auto figures = [&](const ShapeSpec& shape, double height) {
    solid_of(study).outline = shape;
    for (auto& f : solid_of(study).outline.features)
      if (f.name == "plate") f.values[4] = height;
    PartShape part(study.scene.mechanism, 0, study.spec.shapes.at(0));
    const SolidTask task = solid_task(study.spec, part);
    const auto x = part.design.start();
    const auto check = EslProblem(std::make_unique<MeshStatics>(task), task.cycle, x).check(x);
    return std::pair(check->mass, check->limits[0].excess);
  };
  const double h = end(r).x[0], d = 1e-5;
  const auto up = figures(outline(r), h + d), down = figures(outline(r), h - d);
  const double lambda = -(up.first - down.first) / (up.second - down.second);
  ShapeSpec holed = outline(r);
  ShapeDesignSpec ignored;
  Nucleus small = *r.next->hole.nucleus;
  insert_hole(small, solid_of(study).mesh(), holed, ignored);
  const auto before = figures(outline(r), h), after = figures(holed, h);
  const double volume =
      std::numbers::pi * small.radius * small.radius * solid_of(study).model->thickness();
  const double change = after.first - before.first + lambda * (after.second - before.second);
  EXPECT_NEAR(-change / volume / small.gain, 1, 0.1);
}

TEST(TopologyCycle, NucleiKeepAwayFromEdgesInterfacesAndWalls) {
  const Study study = cantilever();
  const Result r = optimised(study, 0);
  const SolidTask task = solid_task(study.spec, *end(r).part);
  const auto proposed = [&](double wall) {
    return propose_hole(task, {{"edge", "plate", "tip", wall}}, end(r).x);
  };
  const HoleProposal proposal = proposed(0.012);
  ASSERT_TRUE(proposal.nucleus) << proposal.reason;
  const Nucleus& n = *proposal.nucleus;
  for (const Interface& interface : end(r).part->model.interfaces())
    for (const int node : interface.nodes)
      EXPECT_GE((end(r).part->model.mesh().nodes.col(node) - n.place).norm(), n.radius + 0.012);
  EXPECT_LE(std::abs(n.place[1]) + n.radius + 0.012, end(r).x[0] / 2);
  EXPECT_GT(n.gain, 0);
  EXPECT_LT(n.gain, task.model->material().rho);
  for (int e = 0; e < proposal.gain.size(); ++e)
    if (end(r).fractions[e] < 1) {
      EXPECT_EQ(proposal.gain[e], 0);
    }
  EXPECT_NE(proposed(0.1).reason.find("far enough from all edges"), std::string::npos);
}

TEST(TopologyCycle, InsertedHolesAreFeaturesWithVariablesAndWalls) {
  Study study = cantilever();
  ShapeSpec& shape_spec = solid_of(study).outline;
  ShapeDesignSpec& design = study.spec.shapes.at(0);
  design.walls = {{"rim", "plate", "tip", 0.01}, {"rim2", "plate", "wall", 0.004}};
  const Nucleus one{{0.1, 0.01, 0}, 0.008, 1}, two{{0.05, 0.01, 0}, 0.008, 1};
  EXPECT_EQ(insert_hole(one, solid_of(study).mesh(), shape_spec, design), "new_hole1");
  EXPECT_EQ(insert_hole(two, solid_of(study).mesh(), shape_spec, design), "new_hole2");
  EXPECT_TRUE(shape_errors(shape_spec).empty());
  ASSERT_EQ(shape_spec.features.size(), 4u);  // plate, the difference, two holes
  EXPECT_EQ(design.variables.size(), 1u + 2 * 4);
  ASSERT_EQ(design.walls.size(), 2u + 3 + 4);
  const WallSpec& between = *std::find_if(design.walls.begin(), design.walls.end(),
                                          [](const WallSpec& w) { return w.to == "new_hole1"; });
  EXPECT_EQ(between.feature, "new_hole2");
  EXPECT_EQ(between.least, 0.004);
  const auto shape = make_shape(shape_spec);
  EXPECT_NEAR(shape->value({0.1, 0.01, 0}), -0.008, 1e-9);
  EXPECT_GT(shape->value({0.1, 0.02, 0}), 0);
  PartShape part(study.scene.mechanism, 0, design);  // what a study may hold
  EXPECT_EQ(part.design.start()[1], 0.1);
}

TEST(TopologyCycle, ASpatialNucleusIsAnEllipsoid) {
  ShapeSpec block;
  block.dim = 3;
  block.features = {{"block", FeatureKind::Box, {0, 0, 0, 0, 0, 0, 2, 2, 2, 0}, {}},
                    {"bore", FeatureKind::Sphere, {1, 1, 1, 0, 0, 0, 0.3}, {}},
                    {"part", FeatureKind::Difference, {}, {"block", "bore"}}};
  ShapeDesignSpec design;
  insert_hole({{0.1, 0.2, -0.3}, 0.25, 1}, hex_grid({-1, -1, -1}, {1, 1, 1}, 8, 8, 8), block,
              design);
  EXPECT_TRUE(shape_errors(block).empty());
  EXPECT_EQ(block.features[2].operands.size(), 3u);
  EXPECT_EQ(design.variables.size(), 6u);
  EXPECT_NEAR(make_shape(block)->value({0.1, 0.2, -0.3 + 0.25}), 0, 1e-12);
}

TEST(TopologyCycle, SaysWhyThereIsNoProposal) {
  const Result stress =
      optimised(cantilever({"constraints={}",
                            "part_limits.peak={of=\"plate\", quantity=\"stress\", "
                            "limit=2e8}"}),
                1);
  EXPECT_FALSE(stress.next);
  EXPECT_NE(stress.reason.find("no topological derivative of the stress limit 'peak'"),
            std::string::npos)
      << stress.reason;
  EXPECT_TRUE(stress.holes.empty());

  const Result infeasible = optimised(cantilever({"constraints.sag.limit=1e-5"}), 1);
  EXPECT_EQ(end(infeasible).status, CycleStatus::Infeasible);
  EXPECT_NE(infeasible.reason.find("no optimum to start from"), std::string::npos);
}

TEST(TopologyCycle, AHoleThatDoesNotReduceTheObjectiveIsRemoved) {
  Study study = cantilever();
  study.spec.cycle.objective_tolerance = 0.9;  // asks for a tenth of the mass
  const Result without = optimised(study, 0), tried = optimised(study, 3);
  ASSERT_EQ(tried.holes.size(), 1u);
  EXPECT_FALSE(tried.holes[0].kept);
  EXPECT_EQ(end(tried).x, end(without).x);
  EXPECT_EQ(end(tried).history.size(), end(without).history.size());
  EXPECT_EQ(outline(tried).features.size(), outline(without).features.size());
  EXPECT_FALSE(tried.next);
  EXPECT_NE(tried.reason.find("does not reduce"), std::string::npos);
}

TEST(TopologyCycle, InterruptedWhileAHoleIsTriedItKeepsTheDesignBefore) {
  const Study study = cantilever();
  bool hole = false;
  TopologyHooks hooks;
  hooks.keep_going = [&] { return !hole; };
  hooks.on_hole = [&](const std::string&, const Nucleus&) { hole = true; };
  const Result r = optimised(study, 3, hooks), without = optimised(study, 0);
  EXPECT_EQ(end(r).status, CycleStatus::Interrupted);
  EXPECT_EQ(end(r).x, end(without).x);
  EXPECT_EQ(r.holes.size(), 1u);
}

TEST(TopologyCycleSlow, InterruptedInAnyRoundAndResumedEndsAtTheSameDesign) {
  const Study study = cantilever();
  const Result whole = optimised(study, 1);
  ASSERT_EQ(whole.holes.size(), 1u);
  for (const bool in_second : {false, true}) {
    RoundHistory kept;
    TopologyHooks hooks;
    hooks.on_round_cycle = [&](const RoundHistory& rounds) { kept = rounds; };
    hooks.keep_going = [&] {
      return kept.size() < (in_second ? 2u : 1u) || kept.back().size() < 2;
    };
    EXPECT_EQ(end(optimised(study, 1, hooks)).status, CycleStatus::Interrupted);
    const Result resumed = optimised(study, 1, {}, kept);
    EXPECT_EQ(end(resumed).status, end(whole).status) << end(resumed).reason;
    EXPECT_EQ(end(resumed).x, end(whole).x);
    EXPECT_EQ(resumed.holes.size(), 1u);
  }
}

/// The gradients of a study with an inserted hole are those of any other study.
TEST(TopologyCycle, GradientsWithAnInsertedHolePassTheStepSweep) {
  Study study = cantilever();
  insert_hole({{0.09, 0.012, 0}, 0.009, 1}, solid_of(study).mesh(), solid_of(study).outline,
              study.spec.shapes.at(0));
  PartShape part(study.scene.mechanism, 0, study.spec.shapes.at(0));
  const SolidTask task = solid_task(study.spec, part);
  EslProblem problem(std::make_unique<MeshStatics>(task, 100), task.cycle, part.design.start());
  const DerivativeReport report = check_derivatives(problem, part.design.start(), {});
  for (const auto& check : report.checks)
    EXPECT_LE(check.best_error, 1e-6) << check.function << '\n' << report.text();
}

}  // namespace
}  // namespace liesl::test::topology_cycle_test
