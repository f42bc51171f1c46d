/// @file
/// Values of drives and the duration as design variables, forces of drives and effort: closed forms
/// of a block that a drive moves, and gradients against differences.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/input/problem.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "optim/nlp/check_derivatives.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::motion_variables_test {
namespace {

using Eigen::VectorXd;

constexpr double kMass = 2;

std::string scene_text(const std::string& drive) {
  return R"(
[bodies]
block = { rigid = { at = [0, 0, 0], mass = 2, inertia = [1, 1, 1] } }
[joints]
rail = { prismatic = ["ground", "block.origin"], axis = [1, 0, 0], drive = )" +
         drive + R"( }
[simulation]
duration = 1
step = 5e-3
[responses]
force = { response = "drive_force", of = "rail" }
)";
}

Scene block() {
  return read_scene(
      scene_text("{ interpolation = \"cubic\", table = [[0, 0], [0.1, 0], [0.4, 0.3], [0.6, 0.8], "
                 "[0.9, 1], [1, 1]] }"),
      "block.toml");
}

StudySpec moved_block(const Scene& scene, const MotionObjective& objective) {
  StudySpec study;
  study.mass_of = {scene.mechanism.body("block")};
  study.drives = {
      {0, {0, 0.1, 0.4, 0.6, 0.9, 1}, {0, 0, 0.3, 0.8, 1, 1}, TimeFunction::Interpolation::Cubic}};
  study.duration = 1;
  ConstantSpec duration;
  duration.name = "duration";
  duration.quantity = ConstantQuantity::Duration;
  duration.lower = 0.2;
  duration.upper = 4;
  duration.start = 1;
  study.constants = {duration};
  study.motion_objective = objective;
  return study;
}

struct Runner {
  explicit Runner(StudySpec s) : study(std::move(s)) { study.cycle.method = CycleMethod::Full; }
  DesignRun<SE3> run(const VectorXd& x) {
    return DesignSimulator<SE3>(scene.mechanism, space, scene.simulation, study).run(x);
  }
  CycleResult<SE3> optimise() {
    return run_cycle<SE3>(scene.mechanism, space, scene.simulation, study);
  }
  Scene scene = block();
  Space<SE3> space = Space<SE3>{};
  StudySpec study;
};

/// m q'' of a smooth motion; positive where the drive pushes the coordinate up.
TEST(DriveForce, IsMassTimesAcceleration) {
  const Scene scene = read_scene(scene_text("{ expression = \"t - sin(t)\" }"), "block.toml");
  const auto space = Space<SE3>{};
  const auto model = Model<SE3>::build(scene.mechanism, space);
  const auto motion = simulate(model, scene.simulation);
  ASSERT_EQ(motion.report.status, SolveStatus::Converged);
  const ResponseValues<SE3> values(scene.mechanism, model);
  EXPECT_STREQ(unit(scene.responses[0], scene.mechanism), "N");
  State<SE3> s = model.initial_state();
  for (int n = 0; n < motion.trajectory.size(); ++n) {
    motion.trajectory.read(n, s);
    if (s.t < 0.3) continue;  // the multipliers of the first steps settle
    EXPECT_NEAR(values(scene.responses[0], s)[0], kMass * std::sin(s.t), 1e-4) << s.t;
  }
  const auto gradient = values.gradient(scene.responses[0], s);
  ASSERT_EQ(gradient[0].lambda.size(), 1u);
  EXPECT_EQ(gradient[0].lambda[0].value, -1);
}

/// The force goes with 1/T^2, so the fastest motion has T = T_0 sqrt(F_0/F).
TEST(Duration, FastestMotionUnderALimitOnTheForce) {
  Runner r(moved_block(block(), {.mass = 0, .duration = 1, .effort = 0, .responses = {}}));
  r.study.constraints = {{r.scene.responses[0], 20, false}};
  const double F0 = r.run(VectorXd::Constant(1, 1)).limits[0].largest;
  for (const double limit : {3 * F0, F0 / 3}) {
    r.study.constraints[0].limit = limit;
    const auto end = r.optimise();
    EXPECT_EQ(end.status, CycleStatus::Optimal) << end.reason;
    EXPECT_NEAR(end.x[0], std::sqrt(F0 / limit), 1e-3 * end.x[0]);
  }
}

/// What no variable changes counts in the objective, and moves no optimum.
TEST(Duration, MassThatStaysMovesNoOptimum) {
  Runner r(moved_block(block(), {.mass = 1, .duration = 1, .effort = 0, .responses = {}}));
  r.study.constraints = {{r.scene.responses[0], 20, false}};
  const double F0 = r.run(VectorXd::Constant(1, 1)).limits[0].largest;
  r.study.constraints[0].limit = 3 * F0;
  const auto end = r.optimise();
  EXPECT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_NEAR(end.x[0], std::sqrt(1. / 3), 1e-3 * end.x[0]);
  EXPECT_NEAR(end.history.back().objective, kMass + end.x[0], 1e-9);
}

/// Effort goes with 1/T^3: T + w J has its least where T^4 = 3 w J_0 T_0^3.
TEST(Duration, BalanceOfTimeAndEffort) {
  const Scene scene = block();
  MotionObjective objective{
      .mass = 0, .duration = 1, .effort = 0.05, .responses = {scene.responses[0]}};
  Runner r(moved_block(scene, objective));
  r.study.constraints = {{scene.responses[0], 1e4, false}};
  const double J0 = r.run(VectorXd::Constant(1, 1)).effort;
  EXPECT_NEAR(r.run(VectorXd::Constant(1, 2)).effort, J0 / 8, 1e-6 * J0);
  const auto end = r.optimise();
  EXPECT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_NEAR(end.x[0], std::pow(3 * objective.effort * J0, 0.25), 5e-3 * end.x[0]);
}

/// robot_codesign, to be simulated at designs.
struct Robot {
  explicit Robot(const Changes& changes) : study(full(shipped_study("robot_codesign", changes))) {}
  static Study full(Study study) {
    study.spec.cycle.method = CycleMethod::Full;
    return study;
  }
  const Study study;
  const Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  const DesignSimulator<SE2> simulator{study.scene.mechanism, space, study.scene.simulation,
                                       study.spec};
};

/// Torques, deflections and positions of the robot by walls, values of drives and the duration.
TEST(MotionVariables, GradientsAreThoseOfDifferencesWithSlopeTwo) {
  const Robot robot({"simulation.tolerance=1e-11"});
  const auto& study = robot.study;
  const auto& simulator = robot.simulator;
  const VectorXd x = simulator.design().start();
  const auto run = simulator.run(x);
  ASSERT_TRUE(run.good());
  std::vector<LimitedResponse> responses;
  for (std::size_t c = 0; c < study.spec.constraints.size(); ++c)
    responses.push_back({static_cast<int>(c), study.spec.constraints[c].response});
  const MotionGradients motion(simulator.design(), run, x, responses);
  ASSERT_TRUE(motion.reason().empty()) << motion.reason();
  const auto& variables = simulator.design().variables();
  const auto end = static_cast<Eigen::Index>(variables.size()) - 1;  // the duration
  for (const Eigen::Index j : {Eigen::Index{1}, end - 8, end - 3, end})
    for (int r = 0; r < motion.responses(); ++r) {
      int peak = 0;
      for (int n = 0; n < motion.records(r); ++n)
        if (motion.value(r, n) > motion.value(r, peak)) peak = n;
      const VectorXd* gradient = motion.gradient(r, peak);
      ASSERT_NE(gradient, nullptr);
      std::vector<double> error;
      for (const double step : {4e-3, 2e-3, 1e-3}) {
        const double h = step * (variables[std::size_t(j)].upper - variables[std::size_t(j)].lower);
        VectorXd above = x, below = x;
        above[j] += h;
        below[j] -= h;
        const auto value = [&](const VectorXd& at) {
          return simulator.run(at).limits[std::size_t(r)].values[std::size_t(peak)];
        };
        error.push_back(std::abs((value(above) - value(below)) / (2 * h) - (*gradient)[j]));
      }
      const double size = motion.value(r, peak) / variables[std::size_t(j)].upper;
      const std::string what = variables[std::size_t(j)].name + ", " +
                               study.spec.constraints[std::size_t(r)].response.name;
      EXPECT_LT(error[2], 2e-2 * size) << what;
      if (error[2] > 1e-5 * size) {
        EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.5) << what;
        EXPECT_NEAR(std::log2(error[1] / error[2]), 2, 0.5) << what;
      }
    }
}

/// The lighter the elements, the more the round-off of the equilibrium accelerates their nodes.
TEST(MotionVariables, AFineMeshStartsAtRest) {
  const Robot robot({"bodies.arm1.beam.elements=48", "bodies.arm2.beam.elements=48"});
  const auto& [study, space, simulator] = robot;
  const VectorXd x = simulator.design().start();
  const auto run = simulator.run(x);
  ASSERT_TRUE(run.good());
  const MotionGradients motion(simulator.design(), run, x,
                               {{0, study.spec.constraints.front().response}});
  EXPECT_EQ(motion.reason(), "");
}

/// The torques hold the duration in several steps at once, between which their maxima go to and
/// fro: a kink of the largest value, on which steps that see one of its sides creep.
TEST(MotionVariables, MaximaThatGoToAndFroEndAtAnOptimum) {
  const std::string held = ".bounds=[0.0019999, 0.0020001]";  // the walls stay
  const Study study =
      shipped_study("robot_codesign", {"design.arm1_walls" + held, "design.arm2_walls" + held});
  const auto r = run_cycle<SE2>(study.scene.mechanism, space_of<SE2>(study.scene.mechanism),
                                study.scene.simulation, study.spec);
  EXPECT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  ASSERT_TRUE(r.optimality && r.optimality->holds());
  int held_by = 0;  // steps of the motion that carry the optimum
  for (const LimitPrice& price : r.optimality->prices)
    held_by += price.name == "shoulder" || price.name == "elbow";
  EXPECT_GE(held_by, 2);
  EXPECT_LT(r.x[r.x.size() - 1], 0.48) << "s; 0.4991 where rows of one step alone crept to";
}

TEST(MotionVariables, BadInputIsRefusedWithItsPlace) {
  const auto refused = [](const Changes& changes, const std::string& why, std::size_t places = 1) {
    try {
      shipped_study("robot_codesign", changes);
      ADD_FAILURE() << "not refused: " << why;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
      EXPECT_EQ(error.problems.size(), places) << error.what();
    }
  };
  refused({"design.elbow_3.property=drive.table.9"}, "is no row of the table of the drive");
  refused({"design.elbow_3.property=drive.table.x"}, "drive.table.1 to drive.table.5");
  refused({"design.elbow_3.property=drive.table.0"}, "row 0 is where the motion starts");
  refused({"design.elbow_4.property=drive.table.3", "design.elbow_4.bounds=[0.5, 0.9]"},
          "is already varied by 'elbow_3'");
  refused({"design.elbow_3.of=elbwo"}, "there is no joint 'elbwo'");
  refused({"design.elbow_3.of=elbwo"}, "did you mean 'elbow'?");
  refused({"design.duration.of=simulate"}, "'simulate' has no duration");
  refused({"design.duration.property=durration"}, "did you mean 'duration'?");
  refused({"design.elbow_3.bounds=[0.8, 1]"}, "outside the bounds");
  refused({"design.duration.bounds=[0, 1]"}, "durations > 0");
  refused({"objective.weights.mass=0", "objective.weights.duration=0"}, "all weights are zero");
  refused({"objective.weights.effort=1"}, "effort has a weight, but no responses");
  refused({"objective.minimize=mass"}, "the objective is not \"weighted\"");
  refused({"cycle.method=esl"}, "the objective is of the motion", 12);
  refused({"joints.elbow.drive={rate=1, ramp=0.1}"}, "has no drive with a table", 5);
  refused({"responses.elbow_torque.of=flange"}, "has no coordinate 0");
}

}  // namespace
}  // namespace liesl::test::motion_variables_test
