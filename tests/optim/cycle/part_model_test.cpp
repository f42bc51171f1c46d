/// @file
/// Shape optimisation under fixed loads: classical answers.
#include "optim/cycle/part_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"
#include "mbs/linalg/stop_after.hpp"

namespace liesl::test::part_model_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace levelset;

/// A quarter of a plate of 2 m with an elliptical hole in its middle, pulled along x and y.
struct QuarterPlate {
  LevelSetPtr shape;
  SolidModel model;
  std::unique_ptr<ShapeDesign> design;
  SolidTask task;

  QuarterPlate(int n, double a, double b, double ratio)
      : shape(make_shape(a, b)),
        model(quad_grid({0, 0}, {1, 1}, n, n), {"m", 210e9, 0.3, 7850}, {}, {}) {
    ShapeDesignSpec spec;
    spec.variables = {{"a", {{"hole.a", 1}}, 0.05, 0.5, {}}, {"b", {{"hole.b", 1}}, 0.05, 0.5, {}}};
    design = std::make_unique<ShapeDesign>(spec, *shape, model);
    task.design = design.get();
    task.shape = shape.get();
    task.model = &model;
    fix_nodes(task.support, model, model.mesh().sets.at("x_min"), "x");
    fix_nodes(task.support, model, model.mesh().sets.at("y_min"), "y");
    task.loads = traction_load(model, model.mesh().sets.at("x_max"), {1e6, 0, 0}) +
                 traction_load(model, model.mesh().sets.at("y_max"), {0, ratio * 1e6, 0});
    task.cases = {"biaxial"};
    const double full = 7850.0;
    task.limits = {{"mass", SolidResponse::Mass, 0, 1, full * (1 - std::numbers::pi / 4 * 0.02)}};
  }
  static LevelSetPtr make_shape(double a, double b) {
    std::vector<Operand> operands;
    operands.push_back({"plate", rectangle(9, 9)});
    operands.push_back({"hole", ellipse(a, b)});
    return subtract(std::move(operands));
  }
};

/// Of all holes of one area in a large plate under stresses s1 : s2 of the same sign, the ellipse
/// with the axes ratio a/b = s1/s2 stores the least energy, and has the same stress all round
/// (G. P. Cherepanov, Inverse problems of the plane theory of elasticity, J. Appl. Math. Mech. 38
/// (1974); L. T. Wheeler, Int. J. Solids Struct. 12 (1976)).
TEST(PartModel, HoleInAPlateTakesTheAxesRatioOfTheLoads) {
  QuarterPlate plate(80, 0.15, 0.15, 0.5);
  plate.task.objective = SolidResponse::Compliance;
  plate.task.cycle.move_cells = 3;
  const PartResult r = optimise_part(plate.task);
  EXPECT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_NEAR(r.x[0] / r.x[1] / 2, 1, 0.03);
  EXPECT_NEAR(r.x[0] * r.x[1], 0.02, 1e-3 * 0.02);
}

/// Relative changes of a term of the objective are of its value, of which there has to be one.
TEST(PartModel, TermThatIsZeroInAllLoadCasesIsNamed) {
  QuarterPlate plate(8, 0.15, 0.15, 0.5);
  SolidLimit term{"compliance", SolidResponse::Compliance, 0, 1, 0};
  term.weight = 1;
  plate.task.objective = SolidResponse::Mass;
  plate.task.limits = {term};
  const auto first = [&plate] {
    PartModel model(plate.task);
    const VectorXd x = plate.design->start();
    return model.static_problem(*model.analyse(x, {}), x, 0.1);
  };
  EXPECT_NO_THROW(first());
  plate.task.loads.setZero();
  try {
    first();
    ADD_FAILURE() << "nothing is loaded";
  } catch (const NoSensitivities& error) {
    EXPECT_STREQ(error.what(), "'compliance' of the objective is 0 in all load cases");
  }
}

/// Stopped within a factor or between solutions, anywhere: the best design so far is the answer,
/// and a run that goes on from its cycles ends where one without a break does.
TEST(PartModel, StoppedAnywhereItGoesOn) {
  const auto optimise = [](int looks, const std::vector<Cycle>& from) {
    QuarterPlate plate(12, 0.15, 0.15, 0.5);
    plate.task.objective = SolidResponse::Compliance;
    const StopAfter stop(looks);
    return optimise_part(plate.task, {}, from);
  };
  constexpr int kMany = 1 << 20;
  const PartResult whole = optimise(kMany, {});
  ASSERT_EQ(whole.status, CycleStatus::Optimal) << whole.reason;
  EXPECT_EQ(optimise(0, {}).status, CycleStatus::Interrupted);
  for (const int looks : {20, 40}) {
    const PartResult part = optimise(looks, {});
    ASSERT_EQ(part.status, CycleStatus::Interrupted) << looks << part.reason;
    EXPECT_NE(part.reason.find("on request"), std::string::npos) << part.reason;
    ASSERT_FALSE(part.history.empty()) << looks;
    const PartResult resumed = optimise(kMany, part.history);
    EXPECT_EQ(resumed.status, CycleStatus::Optimal) << resumed.reason;
    EXPECT_EQ(resumed.x, whole.x) << looks;
  }
}

}  // namespace
}  // namespace liesl::test::part_model_test
