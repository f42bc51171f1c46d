/// @file
/// The iteration matrix of every shipped scene against differences of its residual, in every
/// formalism, in the plane and (but for chains of segments) in space: of a step and of statics, at
/// a state of a running motion or on a path of equilibria; its solutions against its transposed
/// solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "apps/scene/load_scene.hpp"
#include "mbs/model/beam_order.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solvers/statics.hpp"
#include "mbs/step_tangent.hpp"
#include "reference/places.hpp"

namespace liesl::test::scene_tangent_test {
namespace {

namespace fs = std::filesystem;

constexpr Formalism kFormalisms[] = {Formalism::SE3,      Formalism::R3SO3, Formalism::Classical,
                                     Formalism::Floating, Formalism::Rigid, Formalism::Segments};
constexpr int kFewColumns = 30;  // of the formalisms that a scene does not ask for

/// Variants without a state to compare at, and why.
const std::map<std::string, std::string> kLeftOut = {
    {"stability/parallelogram, se3, plane", "a dead point"},  // refused at the start
    {"stability/parallelogram, se3, space", "a dead point"},
    {"scenes/crane_boom, segments, plane", "turns a node between the ends"},
};

/// Solutions are refined once: KLU takes a diagonal pivot from a thousandth of the largest entry
/// on, which lets entries grow (with the largest as the pivot these solutions, too, are backward
/// stable).
const std::set<std::string> kRefined = {"stability/esl_non_optimal, segments, plane"};

std::vector<std::string> scenes() {
  std::vector<std::string> list;
  for (const char* folder : {"scenes", "stability"})
    for (const auto& entry : fs::directory_iterator(fs::path(test::kDataDir) / folder))
      if (entry.path().extension() == ".toml")
        list.push_back(std::string(folder) + "/" + entry.path().stem().string());
  std::sort(list.begin(), list.end());
  return list;
}

bool has_beam(const Mechanism& m) {
  return std::any_of(m.bodies.begin(), m.bodies.end(), [](const BodySpec& body) {
    return std::holds_alternative<BeamSpec>(body.kind);
  });
}

bool has_planar_mesh(const Mechanism& m) {
  return std::any_of(m.bodies.begin(), m.bodies.end(), [](const BodySpec& body) {
    const auto* solid = std::get_if<SolidSpec>(&body.kind);
    return solid && solid->mesh().dim == 2;
  });
}

/// A tenth of the motion, but no more than a hundred steps.
int steps_of(const SimulationOptions& o) {
  return static_cast<int>(std::clamp(0.1 * o.duration / o.step, 12.0, 100.0));
}

template <FrameGroup G>
void compare_motion(const Model<G>& model, const SimulationOptions& o, int most,
                    const std::string& what) {
  test::StepTangent<G> step(model, o, steps_of(o));
  ASSERT_GT(step.state().v.norm(), 0) << what;
  step.expect_exact(what, most);
  step.expect_transposed(what, kRefined.contains(what));
  test::expect_exact_statics(model, step.state(), {step.state().t, 1}, what, most);
}

/// In the middle of the path.
template <FrameGroup G>
void compare_statics(const Model<G>& model, SimulationOptions o, int most,
                     const std::string& what) {
  o.critical = false;
  o.load_steps = std::max(o.load_steps, 4);
  const StaticResult<G> path = solve_static(model, o);
  ASSERT_GT(path.trajectory.size(), 2) << what << ": " << path.report.reason;
  State<G> s = model.initial_state();
  path.trajectory.read(path.trajectory.size() / 2, s);
  test::expect_exact_statics(model, s, {s.t, s.t}, what, most);
}

class SceneTangent : public ::testing::TestWithParam<std::string> {
 protected:
  template <FrameGroup G>
  void compare(const Scene& scene, const Space<G>& space, Formalism formalism, int most) {
    const std::string what =
        GetParam() + ", " + to_string(formalism) + ", " + (G::space_dim == 2 ? "plane" : "space");
    const auto left_out = kLeftOut.find(what);
    Mechanism m = scene.mechanism;
    m.formalism = formalism;
    for (std::size_t b = 0; b < m.bodies.size(); ++b)
      if (auto* beam = std::get_if<BeamSpec>(&m.bodies[b].kind))
        beam->order = default_order(m, static_cast<int>(b));
    try {
      const auto model = Model<G>::build(m, space);
      if (scene.simulation.type == SimulationType::Dynamic)
        compare_motion(model, scene.simulation, most, what);
      else
        compare_statics(model, scene.simulation, most, what);
      EXPECT_EQ(left_out, kLeftOut.end()) << what << " has a state to compare at";
    } catch (const std::exception& error) {
      ASSERT_NE(left_out, kLeftOut.end()) << what << ": " << error.what();
      EXPECT_NE(std::string(error.what()).find(left_out->second), std::string::npos)
          << what << ": " << error.what();
    }
  }
};

TEST_P(SceneTangent, IsTheDerivativeOfTheResidual) {
  const Scene scene = load_scene(fs::path(test::kDataDir) / (GetParam() + ".toml"));
  const Mechanism& m = scene.mechanism;
  const PlaneSearch found = find_plane(m);
  const bool in_space = !has_planar_mesh(m),
             moves = scene.simulation.type == SimulationType::Dynamic;
  ASSERT_TRUE(found.plane || in_space);
  for (const Formalism formalism : kFormalisms) {
    const bool given = formalism == m.formalism;
    if (!given && !has_beam(m)) continue;  // the formalism is that of beams
    if (!moves && (formalism == Formalism::Floating || formalism == Formalism::Rigid))
      continue;  // of motions only
    const int most = given ? test::kAllColumns : kFewColumns;
    if (found.plane) compare<SE2>(scene, *found.plane, formalism, most);
    const bool chains = formalism == Formalism::Segments;  // of the plane only
    if (in_space && !chains) compare<SE3>(scene, {}, formalism, found.plane ? kFewColumns : most);
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Shipped, SceneTangent, ::testing::ValuesIn(scenes()), test_name);

}  // namespace
}  // namespace liesl::test::scene_tangent_test
