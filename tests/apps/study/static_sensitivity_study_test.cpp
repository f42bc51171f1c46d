/// @file
/// Studies of equilibria by the sensitivities of statics: gradients, limits of members.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/scene/load_scene.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/studies.hpp"

namespace liesl::test::static_sensitivity_study_test {
namespace {

using Eigen::VectorXd;

/// A frame of two beams under a load, a spring at its tip; large displacements.
constexpr const char* kFrame = R"(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[sections]
tube = { type = "tube", diameter = 0.05, thickness = 0.003 }
[bodies]
a = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "tube", material = "steel", elements = 2 } }
b = { beam = { from = [1, 0, 0], to = [1, -0.6, 0], section = "tube", material = "steel", elements = 2 } }
[joints]
clamp = { fixed = ["ground", "a.start"] }
corner = { revolute = ["a.end", "b.start"] }
foot = { spherical = ["ground", "b.end"] }
[loads]
f = { at = "a.end", force = [3e3, -4e4, 0] }
[forces]
spring = { on = "corner", stiffness = 500 }
[simulation]
type = "static"
load_steps = 2
space = "spatial"
)";

Scene frame() { return read_scene(kFrame, "frame.toml"); }

std::vector<ResponseSpec> members() {
  std::vector<ResponseSpec> all;
  const auto add = [&](const char* name, ResponseKind kind) -> ResponseSpec& {
    all.emplace_back();
    all.back().name = name;
    all.back().kind = kind;
    all.back().body = 1;
    return all.back();
  };
  add("euler", ResponseKind::Buckling).factor = 0.8;
  add("wall", ResponseKind::LocalBuckling).factor = 0.7;
  add("mean", ResponseKind::AxialStress);
  add("down", ResponseKind::AxialStress).side = Side::Down;
  add("stress", ResponseKind::Stress).body = 0;
  add("compliance", ResponseKind::Compliance).body = 0;
  ResponseSpec& tip = add("tip", ResponseKind::Translation);
  tip.at = {0, 2, SE3::identity()};
  ResponseSpec& along = add("along", ResponseKind::Translation);
  along.at = tip.at;
  along.axis = Vec3(0, 1, 0);
  ResponseSpec& force = add("force", ResponseKind::JointForce);
  force.joint = 2;
  return all;
}

StudySpec frame_study() {
  StudySpec study;
  study.mass_of = {0, 1};
  study.design = {{"diameter", {0, 1}, {"diameter"}, 1, 0.02, 0.2, {}},
                  {"wall", {1}, {"thickness"}, 1, 0.001, 0.008, {}}};
  study.constants = {spring_stiffness("spring", 10, 1e4)};
  for (const ResponseSpec& r : members()) study.constraints.push_back({r, 1, false});
  return study;
}

/// Every gradient at every load step against central differences of whole equilibria.
TEST(StaticSensitivity, GradientsAreThoseOfTheEquilibria) {
  const Scene scene = frame();
  const StudySpec study = frame_study();
  const Space<SE3> space{};
  SimulationOptions options = scene.simulation;
  options.tolerance = 1e-12;
  const DesignSimulator<SE3> simulator(scene.mechanism, space, options, study);
  const VectorXd x = simulator.design().start();
  const auto run = simulator.run(x);
  ASSERT_TRUE(run.good()) << run.simulation.report.reason;
  EXPECT_EQ(run.worst_at, "load factor 1");
  std::vector<LimitedResponse> limited;
  for (std::size_t c = 0; c < study.constraints.size(); ++c)
    limited.push_back({static_cast<int>(c), study.constraints[c].response, 0, 0});
  const MotionGradients gradients(simulator.design(), run, x, limited);
  ASSERT_EQ(gradients.reason(), "");
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    VectorXd plus = x, minus = x;
    const double h = 1e-4 * x[j];
    plus[j] += h;
    minus[j] -= h;
    const auto up = simulator.run(plus), down = simulator.run(minus);
    for (int r = 0; r < gradients.responses(); ++r)
      for (int n = 1; n < gradients.records(r); ++n) {
        const auto k = static_cast<std::size_t>(n), c = static_cast<std::size_t>(r);
        const double slope = (up.limits[c].values[k] - down.limits[c].values[k]) / (2 * h);
        const VectorXd* dv = gradients.gradient(r, n);
        if (gradients.value(r, n) == 0) continue;
        ASSERT_TRUE(dv) << run.limits[c].name;
        const double size = gradients.value(r, n) / x[j];
        EXPECT_NEAR((*dv)[j], slope, 2e-6 * size)
            << run.limits[c].name << " by " << simulator.design().variables()[std::size_t(j)].name;
      }
  }
  for (const char* name : {"euler", "wall", "mean", "down"})  // the strut is compressed
    for (const auto& series : run.limits)
      if (series.name == name) {
        EXPECT_GT(series.largest, 0) << name;
      }
}

/// The Euler load of the response is the critical load that statics itself locates.
TEST(MemberResponse, ColumnBucklesWhereTheResponseIsOne) {
  constexpr const char* kColumn = R"(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[sections]
flat = { type = "rectangle", width = 0.03, height = 0.01 }
[bodies]
c = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "flat", material = "steel", elements = 16 } }
[joints]
clamp = { fixed = ["ground", "c.start"] }
[loads]
f = { at = "c.end", force = [-1000, 0, 0] }
[simulation]
type = "static"
critical = true
max_load = 2
load_steps = 4
[responses]
euler = { response = "buckling", of = "c", factor = 2 }
)";
  const Scene scene = read_scene(kColumn, "column.toml");
  const auto model = Model<SE3>::build(scene.mechanism, {});
  const auto found = solve_static(model, scene.simulation);
  ASSERT_FALSE(found.critical.empty());
  State<SE3> s = model.initial_state();
  found.trajectory.read(1, s);  // at half the load, straight
  const ResponseValues<SE3> values(scene.mechanism, model);
  const double share = values(scene.responses[0], s)[0] / s.t;  // of the load at factor 1
  EXPECT_NEAR(found.critical.front().load * share, 1, 0.01);
}

}  // namespace
}  // namespace liesl::test::static_sensitivity_study_test
