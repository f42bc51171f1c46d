/// @file
/// The static problem of a meshed part: gradients of every response for every feature, screening,
/// what is said when no part is left.
#include "optim/problems/mesh_statics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mbs/levelset/shapes.hpp"
#include "optim/nlp/check_derivatives.hpp"
#include "optim/problems/esl_problem.hpp"

namespace liesl::test::mesh_statics_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

bool spatial(const std::string& feature) {
  return feature == "half-space" || feature == "sphere" || feature == "box with fillet" ||
         feature == "ellipsoid" || feature == "extrusion" || feature == "slab" ||
         feature == "mirror in space";
}

/// The feature as a hole; half-planes take a corner off, a slab a layer near one side.
LevelSetPtr void_of(const NamedShape& s) {
  constexpr double turn = 1.25 * std::numbers::pi;
  if (s.name == "half-plane") return placed_in_plane(1.0, 1.05, turn, half_space());
  if (s.name == "half-space") return placed({{1.0, 1.05, 0}, {0.1, 0.05, turn}}, half_space());
  if (s.name == "slab") return placed({{0, 0, 0.45}, {0.05, 0.04, 0.1}}, slab(0.2));
  return s.make();
}

/// A plate (or block) of 3 m between two ports with a feature and a round hole, all parameters of
/// the feature variable, all responses limited.
struct Block {
  levelset::LevelSetPtr shape;
  SolidModel model;
  std::unique_ptr<ShapeDesign> design;
  SolidTask task;

  explicit Block(const NamedShape& s)
      : shape(make_shape(void_of(s))), model(make_model(spatial(s.name))) {
    ShapeDesignSpec spec;
    std::set<std::string> names;  // an extrusion has two placements
    for (const auto& p : shape->parameters())
      if (p.name.starts_with("hole.") && names.insert(p.name).second)
        spec.variables.push_back({p.name,
                                  {{p.name, 1}},
                                  p.value - 0.02 > p.above ? p.value - 0.02 : p.value,
                                  p.value + 0.02,
                                  {}});
    spec.walls.push_back({"apart", "hole", "other", 0.05});
    design = std::make_unique<ShapeDesign>(spec, *shape, model);
    task.design = design.get();
    task.shape = shape.get();
    task.model = &model;
    fix_port(task.support, model, 0, model.mesh().dim == 2 ? "xyr" : "xyzr");
    const int b = model.port(1), r = model.rigid_count();
    task.outputs.resize(model.size(), 4);
    task.outputs << elongation_output(model, 0, 1), relative_output(model, 0, 1, 0),
        relative_output(model, 0, 1, 1), point_output(model);
    task.loads = MatrixXd::Zero(model.size(), 3);
    task.loads(b, 0) = 1e6;
    task.loads(b + 1, 1) = 3e5;
    task.loads(b + r - 1, 2) = 2e5;
    task.loads(b, 2) = -4e5;
    task.cases = {"pull", "shear", "bend"};
    task.limits = {
        {"long", SolidResponse::Output, 0, 1, 1e-5},  {"far", SolidResponse::Output, 1, 2, 1e-5},
        {"point", SolidResponse::Output, 3, 1, 1e-5}, {"work", SolidResponse::Compliance, 0, 1, 10},
        {"stress", SolidResponse::Stress, 0, 1, 1e6}, {"mass", SolidResponse::Mass, 0, 1, 1000},
        {"tone", SolidResponse::Frequency, 0, 1, 100}};
    task.cycle.min_cases = 3;
  }

 private:
  /// Displacement along y of a node far from the ports.
  static VectorXd point_output(const SolidModel& model) {
    Eigen::Index node;
    (model.mesh().nodes.colwise() - Eigen::Vector3d(-0.9, 1.2, 0)).colwise().norm().minCoeff(&node);
    return VectorXd::Unit(model.size(), model.coordinate(static_cast<int>(node), 1).value());
  }
  static LevelSetPtr make_shape(LevelSetPtr feature) {
    std::vector<Operand> operands;
    operands.push_back({"block", box(9, 9, 9)});
    operands.push_back({"hole", std::move(feature)});
    operands.push_back({"other", placed_in_plane(1.15, -1.17, 0, levelset::circle(0.22))});
    return subtract(std::move(operands));
  }
  static SolidModel make_model(bool space) {
    const SolidMesh mesh =
        space ? hex_grid({-1.5037, -1.4929, -0.7043}, {1.5011, 1.5053, 0.6971}, 8, 8, 4)
              : quad_grid({-1.5037, -1.4929}, {1.5011, 1.5053}, 15, 15);
    SolidModel::Options options;
    options.thickness = 0.1;
    return SolidModel(mesh, {"steel", 210e9, 0.3, 7850},
                      {{"left", mesh.sets.at("x_min"), {-1.5, 0, 0}, Tie::Rigid},
                       {"right", mesh.sets.at("x_max"), {1.5, 0, 0}, Tie::Rigid}},
                      options);
  }
};

EslProblem problem_of(const SolidTask& task, double cells) {
  return EslProblem(std::make_unique<MeshStatics>(task, cells), task.cycle, task.design->start());
}

DerivativeReport gradients_of(const Block& block, double largest_step) {
  EslProblem problem = problem_of(block.task, 100);
  DerivativeCheckOptions options;
  options.largest_step = largest_step;
  return check_derivatives(problem, block.design->start(), options);
}

/// Along a direction that changes all variables.
void expect_right(const Block& block, const std::string& name) {
  const DerivativeReport report = gradients_of(block, 2e-3);
  EXPECT_EQ(report.failed_evaluations, 0) << name;
  EXPECT_EQ(report.checks.size(), 1 + 5 * 3 + 1 + 1 + 1) << name;
  for (const auto& check : report.checks)
    EXPECT_LE(check.best_error, 1e-6) << name << ": " << check.function << '\n' << report.text();
}

class ShapeDerivatives : public ::testing::TestWithParam<int> {};

TEST_P(ShapeDerivatives, OfEveryResponsePassTheStepSweep) {
  const NamedShape feature = all_shapes()[static_cast<std::size_t>(GetParam())];
  Block block(feature);
  expect_right(block, feature.name);
}

INSTANTIATE_TEST_SUITE_P(Features, ShapeDerivatives,
                         ::testing::Range(0, static_cast<int>(all_shapes().size())));

/// Single slopes differ, because second derivatives jump where the outline passes a node of the
/// sub-grid; a wrong gradient has slope 0, a one-sided one 1.
void expect_second_order(bool space) {
  std::vector<double> slopes;
  for (const NamedShape& feature : all_shapes()) {
    if (spatial(feature.name) != space) continue;
    const DerivativeReport report = gradients_of(Block(feature), 1e-2);
    for (const auto& check : report.checks)
      if (check.slope) slopes.push_back(*check.slope);
  }
  ASSERT_GE(slopes.size(), 60u);
  std::nth_element(slopes.begin(), slopes.begin() + slopes.size() / 2, slopes.end());
  EXPECT_NEAR(slopes[slopes.size() / 2], 2, 0.1);
}

TEST(MeshStatics, ErrorsOfDifferencesFallWithTheSquareOfTheStep) { expect_second_order(false); }

TEST(MeshStatics, OrderInSpace) { expect_second_order(true); }

TEST(MeshStatics, DerivativesOfOtherObjectivesPassTheStepSweep) {
  for (const SolidResponse objective : {SolidResponse::Compliance, SolidResponse::Stress}) {
    Block block(shape_named("super-ellipse"));
    block.task.objective = objective;
    expect_right(block, "super-ellipse");
  }
}

NamedShape ellipse_hole() { return shape_named("ellipse"); }

TEST(MeshStatics, ScreeningWithViolatorsAddedFindsTheOptimumOfAllCases) {
  const auto optimum = [](double screening, int min_cases, int& cases) {
    Block block(ellipse_hole());
    block.task.loads.conservativeResize(Eigen::NoChange, 24);
    block.task.cases.clear();
    for (int n = 0; n < 24; ++n) {
      block.task.loads.col(n) =
          std::cos(0.3 * n) * block.task.loads.col(0) + std::sin(0.3 * n) * block.task.loads.col(1);
    }
    for (int n = 0; n < 24; ++n) block.task.cases.push_back("case " + std::to_string(n));
    block.task.limits = {{"far", SolidResponse::Output, 1, 2, 0}};
    block.task.cycle.screening = screening;
    block.task.cycle.min_cases = min_cases;
    EslProblem first = problem_of(block.task, 100);
    block.task.limits[0].limit = first.check(block.design->start())->limits[0].value * 0.999;
    EslProblem problem = problem_of(block.task, 100);
    NlpWarmStart warm;
    const StaticAnswer answer = solve_static(problem, block.task.cycle, warm, {});
    cases = problem.load_cases();
    const auto check = problem.check(answer.result.x);
    EXPECT_LE(check->worst, 2e-6);
    return check->mass;
  };
  int few = 0, all = 0;
  const double screened = optimum(0.0, 1, few), full = optimum(0.999, 24, all);
  EXPECT_EQ(all, 24);
  EXPECT_LT(few, 12);
  EXPECT_NEAR(screened, full, 1e-6 * full);
}

TEST(MeshStatics, SaysWhichInterfaceIsCutAndGivesNoValue) {
  Block block(ellipse_hole());
  ShapeDesignSpec spec;
  spec.variables.push_back({"b", {{"hole.b", 1}}, 0.1, 3, {}});
  ShapeDesign design(spec, *block.shape, block.model);
  block.task.design = &design;
  block.task.limits.clear();
  EslProblem problem = problem_of(block.task, 1000);
  double f = 0;
  VectorXd g(problem.constraints().size());
  problem.values(VectorXd::Constant(1, 2.9), f, g);
  EXPECT_TRUE(std::isnan(f));
  EXPECT_NE(problem.undefined_reason().find("interface 'right'"), std::string::npos)
      << problem.undefined_reason();
  problem.values(design.start(), f, g);
  EXPECT_TRUE(std::isfinite(f));
  EXPECT_EQ(problem.undefined_reason(), "");
}

/// Each bound alone leaves a shape, both together fold the outline over itself.
TEST(MeshStatics, SaysThatAnOutlineCrossesItselfAndGivesNoValue) {
  Block block(shape_named("polyline"));
  ShapeDesignSpec spec;
  spec.variables = {{"right", {{"hole.p0.x", 1}}, -0.3, 0.7, {}},
                    {"left", {{"hole.p3.x", 1}, {"hole.p4.x", 1}}, -0.7, 0.05, {}}};
  const ShapeDesign design(spec, *block.shape, block.model);
  block.task.design = &design;
  block.task.limits.clear();
  EslProblem problem = problem_of(block.task, 1000);
  double f = 0;
  VectorXd g(problem.constraints().size());
  problem.values(Eigen::Vector2d(-0.3, 0.05), f, g);
  EXPECT_TRUE(std::isnan(f));
  EXPECT_NE(problem.undefined_reason().find("crosses itself"), std::string::npos)
      << problem.undefined_reason();
}

}  // namespace
}  // namespace liesl::test::mesh_statics_test
