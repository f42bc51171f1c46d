/// @file
/// Trusses: the bars and joints that they become, forces in closed form, faults at their places.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"
#include "mbs/solvers/statics.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl::test::truss_scene_test {
namespace {

using test::changed;

/// A tripod under a load at its top, and a bar between two of its feet that carries nothing.
const std::string kTripod = R"([materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }

[sections]
bar = { type = "circle", diameter = 0.01 }
thick = { type = "circle", diameter = 0.02 }

[bodies.t.truss]
material = "steel"
section = "bar"
sections = { ties = "thick" }
held = ["a", "b", "c"]

[bodies.t.truss.nodes]
a = [1, 0, 0]
b = [-0.5, 0.8660254037844386, 0]
c = [-0.5, -0.8660254037844386, 0]
top = [0, 0, 2]

[bodies.t.truss.bars]
legs = [["a", "top"], ["b", "top"], ["top", "c"]]
ties = [["a", "b"]]

[loads]
weight = { at = "t.top", force = [0, 0, -30] }

[simulation]
type = "static"

[responses]
sink = { response = "translation", at = "t.top", axis = [0, 0, 1] }
leg = { response = "axial_stress", of = "t_legs3" }
tie = { response = "axial_stress", of = "t_ties1" }
)";

TEST(TrussScene, IsBarsAndJoints) {
  const Mechanism m = read_scene(kTripod, "t.toml").mechanism;
  ASSERT_EQ(m.bodies.size(), 4u);
  EXPECT_GE(m.body("t_legs1"), 0);
  EXPECT_GE(m.body("t_ties1"), 0);
  EXPECT_EQ(std::get<BeamSpec>(m.bodies[std::size_t(m.body("t_ties1"))].kind).sections[0].name,
            "thick");
  int universal = 0;
  for (const JointSpec& j : m.joints) universal += j.type == JointType::Universal;
  EXPECT_EQ(m.joints.size(), 7u);  // five held ends, two at the top
  EXPECT_EQ(universal, 4);         // one a bar
}

/// N = -P/(3 cos) in each leg, u = -P L/(3 EA cos^2), cos = 2/sqrt(5); nothing in the tie.
TEST(TrussScene, ForcesAreThoseOfTheTripod) {
  const Scene scene = read_scene(kTripod, "t.toml");
  const auto model = Model<SE3>::build(scene.mechanism, {});
  const auto result = solve_static(model, scene.simulation);
  ASSERT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
  State<SE3> s = model.initial_state();
  result.trajectory.read(result.trajectory.size() - 1, s);
  const ResponseValues<SE3> values(scene.mechanism, model);
  const double A = M_PI * 0.01 * 0.01 / 4, L = std::sqrt(5), cosine = 2 / L;
  const double sigma = -10 / cosine / A;
  EXPECT_NEAR(values(scene.responses[0], s)[0] / (sigma * L / 210e9 / cosine), 1, 1e-5);
  EXPECT_NEAR(values(scene.responses[1], s)[0] / sigma, 1, 1e-5);
  EXPECT_NEAR(values(scene.responses[2], s)[0] / sigma, 0, 1e-9);
}

TEST(TrussScene, FaultsAreSaidAtTheirPlaces) {
  struct Fault {
    const char *from, *to, *said;
  };
  const Fault faults[] = {
      {"[\"a\", \"b\"]]", "[\"a\", \"d\"]]", "has no node 'd'"},
      {"[\"a\", \"b\"]]", "[\"a\"]]", "a bar that is no pair of nodes"},
      {"[\"a\", \"b\"]]", "[\"a\", \"a\"]]", "a bar of zero length"},
      {"[\"a\", \"b\"]]", "[\"top\", \"a\"]]", "has two bars from 'top' to 'a'"},
      {"ties = [[\"a\", \"b\"]]", "ties = [[\"a\", \"b\"]]\ntop = [[\"b\", \"c\"]]",
       "a node and a group of bars 'top'"},
      {"top = [0, 0, 2]", "top = [0, 0, 2]\nfree = [3, 3, 3]", "a node 'free' without a bar"},
      {"held = [\"a\", \"b\", \"c\"]", "held = [\"a\", \"x\"]", "has no node 'x'"},
      {"sections = { ties", "sections = { cords", "has no group of bars 'cords'"},
      {"\"t.top\", force", "\"t.tip\", force", "has no node 't.tip'"},
      {"of = \"t_legs3\"", "of = \"t\"", "'t' is of 4 bars"},
      {"of = \"t_legs3\"", "of = \"t.legs\"", "'t.legs' is of 3 bars"},
      {"section = \"bar\"", "section = \"bars\"", "section 'bars', which the scene has not"},
      {"material = \"steel\"", "material = \"stel\"", "material 'stel', which the scene has not"},
      {"response = \"axial_stress\", of = \"t_legs3\"",
       "response = \"local_buckling\", of = \"t_legs3\"", "no wall whose buckling is known"},
  };
  for (const Fault& f : faults) {
    std::string said;
    try {
      read_scene(changed(kTripod, f.from, f.to), "t.toml");
    } catch (const InputError& error) {
      said = error.what();
    }
    EXPECT_NE(said.find(f.said), std::string::npos) << f.to << ": " << said;
    EXPECT_NE(said.find("t.toml:"), std::string::npos) << said;
    EXPECT_EQ(said.find("t.toml:0"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace liesl::test::truss_scene_test
