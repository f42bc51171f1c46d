/// @file
/// Scenes of meshed parts whose nodes all move: what is read, what is refused at its place, and
/// what their results show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/esl.hpp"
#include "apps/tasks/run.hpp"

namespace liesl::test::continuum_scene_test {
namespace {

using test::changed;

const std::string kFlap = R"toml(name = "flap"
[materials]
rubber = { E = 1e6, nu = 0.3, rho = 1000 }

[bodies.flap.solid]
as = "continuum"
mesh = { from = [0, 0], to = [0.3, 0.03], cells = [12, 2] }
material = "rubber"
thickness = 0.02

[bodies.flap.solid.interfaces]
root = { set = "x_min" }
tip = { set = "x_max" }

[joints]
clamp = { fixed = ["ground", "flap.root"] }

[loads]
push = { at = "flap.tip", force = [0, 0.3, 0] }

[simulation]
type = "static"
load_steps = 4

[responses]
tip = { response = "position", at = "flap.tip" }
)toml";

const SolidSpec& flap_of(const Scene& scene) {
  return std::get<SolidSpec>(scene.mechanism.bodies[0].kind);
}

TEST(ContinuumScene, IsRead) {
  EXPECT_EQ(flap_of(read_scene(kFlap, "a")).as, SolidMotion::Continuum);
  const std::string neo =
      changed(kFlap, "as = \"continuum\"", "as = \"continuum\"\nlaw = \"neo_hookean\"");
  EXPECT_EQ(flap_of(read_scene(neo, "a")).law, SolidLaw::NeoHookean);
  const std::string reduced = changed(kFlap, "as = \"continuum\"", "");
  EXPECT_EQ(flap_of(read_scene(reduced, "a")).as, SolidMotion::Reduced);
}

/// `to` replaces `from`; '@' in it marks where the problem is expected and is taken out.
struct BadContinuum {
  const char *name, *from, *to;
  std::vector<const char*> words;
};
void PrintTo(const BadContinuum& part, std::ostream* out) { *out << part.name; }
class BadContinuumScene : public testing::TestWithParam<BadContinuum> {};

TEST_P(BadContinuumScene, IsRefusedAtItsPlace) {
  const BadContinuum& c = GetParam();
  const test::MarkedText marked(changed(kFlap, c.from, c.to));
  const auto read = [](const auto& text, const auto& file) { read_scene(text, file); };
  test::expect_refused(marked, "scene.toml", read, c.words);
}

INSTANTIATE_TEST_SUITE_P(
    Parts, BadContinuumScene,
    testing::Values(
        BadContinuum{"Incompressible",
                     "nu = 0.3, rho = 1000 }\n\n[bodies.flap.solid]\nas = \"continuum\"\n"
                     "mesh = { from = [0, 0], to = [0.3, 0.03], cells = [12, 2] }\nmaterial = ",
                     "nu = 0.49995, rho = 1000 }\n\n[bodies.flap.solid]\nas = \"continuum\"\n"
                     "mesh = { from = [0, 0], to = [0.3, 0.03], cells = [12, 2] }\nmaterial = @",
                     {"is incompressible", "nu < 0.4999", "for rubber 0.49"}},
        BadContinuum{"OutlineThatCutsItsTipOff",
                     "[bodies.flap.solid.interfaces]\nroot = { set = \"x_min\" }\ntip = ",
                     "outline = { most = { type = \"half_space\", x = 0.2 } }\n\n"
                     "[bodies.flap.solid.interfaces]\nroot = { set = \"x_min\" }\ntip = @",
                     {"no material is left at interface 'tip'", "material between all"}},
        BadContinuum{"OutlineUnderAnAveragedInterface",
                     "[bodies.flap.solid.interfaces]\nroot = { set = \"x_min\" }\n"
                     "tip = { set = \"x_max\"",
                     "outline = { most = { type = \"half_space\", x = 1 }, corner = { type = "
                     "\"circle\", x = 0.3, y = 0.03, radius = 0.0295 }, flap = { type = "
                     "\"difference\", of = [\"most\", \"corner\"] } }\n\n"
                     "[bodies.flap.solid.interfaces]\nroot = { set = \"x_min\" }\n"
                     "tip = @{ set = \"x_max\", tie = \"averaged\"",
                     {"interface 'tip' over nodes in the void", "tie = \"rigid\""}},
        BadContinuum{"LawOfAReducedPart",
                     "as = \"continuum\"",
                     "law = @\"neo_hookean\"",
                     {"is linear in its frame", "as = \"continuum\""}},
        BadContinuum{"Modes",
                     "as = \"continuum\"",
                     "as = \"continuum\"\nmodes = @4",
                     {"as a continuum has no modes"}}),
    [](const auto& part) { return std::string(part.param.name); });

/// In plane stress the thickness gives way; cells in space become too stiff.
TEST(ContinuumScene, NearlyIncompressibleCellsAreNoted) {
  const auto notes = [](const std::string& nu, const std::string& third) {
    return read_scene("gravity = [0, -1, 0]\n[materials]\nrubber = { E = 1e6, nu = " + nu +
                          ", rho = 1000 }\n[bodies.bar.solid]\nas = \"continuum\"\n"
                          "material = \"rubber\"\n" +
                          (third.empty() ? "thickness = 0.1\n" : "") + "mesh = { from = [0, 0" +
                          third + "], to = [1, 0.1" + (third.empty() ? "" : ", 0.1") +
                          "], cells = [4, 1" + (third.empty() ? "" : ", 1") +
                          "] }\ninterfaces = { root = { set = \"x_min\" }, tip = { set = "
                          "\"x_max\" } }\n[joints]\nclamp = { fixed = [\"ground\", "
                          "\"bar.root\"] }\n[simulation]\nduration = 0.1\nstep = 1e-3\n",
                      "a")
        .warnings;
  };
  EXPECT_TRUE(notes("0.3", ", 0").empty());
  EXPECT_TRUE(notes("0.49", "").empty());
  const auto found = notes("0.49", ", 0");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("part 'bar' is nearly incompressible (nu = 0.49)"), std::string::npos);
}

/// The shapes and amplitudes of the results are where the nodes are: at the tip with the port.
TEST(ContinuumScene, ResultsShowItsMeshWhereItIs) {
  const Scene scene = read_scene(kFlap, "a");
  const RunOutcome out = run_task(scene, choose_space(scene));
  ASSERT_EQ(out.status, SolveStatus::Converged);
  ASSERT_EQ(out.results.meshes.size(), 1u);
  const auto& mesh = out.results.meshes[0];
  const auto& tip = out.results.responses[0].values;
  const std::size_t nodes = 13 * 3, records = out.results.times.size();
  ASSERT_EQ(mesh.reference.size(), 3 * nodes);
  ASSERT_EQ(mesh.positions.size(), mesh.records.size() * 3 * nodes);
  const double deflection = tip[3 * (records - 1) + 1] - 0.015;
  EXPECT_GT(deflection, 0.05);  // bent far: a fourth of its length
  const std::size_t last = 3 * nodes * (mesh.records.size() - 1);
  const std::size_t middle = 12 + 13;  // of the side x_max
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(mesh.positions[last + 3 * middle + i], tip[3 * (records - 1) + i], 1e-6);
  // The same from shapes and amplitudes.
  const std::size_t k = mesh.basis.size() / (3 * nodes);
  ASSERT_EQ(mesh.amplitudes.size(), records * k);
  double y = mesh.reference[3 * middle + 1];
  for (std::size_t j = 0; j < k; ++j)
    y += mesh.amplitudes[(records - 1) * k + j] * mesh.basis[3 * nodes * j + 3 * middle + 1];
  EXPECT_NEAR(y, tip[3 * (records - 1) + 1] - 0.015, 1e-6);
}

/// With a hole, a cell is partly filled, its stress is that of the material, and the outline is
/// drawn by its level.
TEST(ContinuumScene, ResultsShowItsOutline) {
  const std::string holed =
      changed(kFlap, "[bodies.flap.solid.interfaces]",
              "outline = { most = { type = \"half_space\", x = 1 }, hole = { type = \"circle\", "
              "x = 0.15, y = 0.0225, radius = 0.006 }, flap = { type = \"difference\", "
              "of = [\"most\", \"hole\"] } }\n\n[bodies.flap.solid.interfaces]");
  const Scene scene = read_scene(holed, "a");
  const RunOutcome out = run_task(scene, choose_space(scene));
  ASSERT_EQ(out.status, SolveStatus::Converged);
  const auto& mesh = out.results.meshes[0];
  ASSERT_EQ(mesh.fractions.size(), 24u);
  EXPECT_LT(*std::min_element(mesh.fractions.begin(), mesh.fractions.end()), 0.9);
  EXPECT_EQ(mesh.level.size(), 13u * 3u);
  const Scene whole = read_scene(kFlap, "a");
  const RunOutcome plain = run_task(whole, choose_space(whole));
  EXPECT_GT(out.results.responses[0].values.end()[-2], plain.results.responses[0].values.end()[-2]);
}

/// An averaged tip bends as a rigid one but for what that stiffens its end.
TEST(ContinuumScene, TakesAveragedInterfaces) {
  const auto deflection = [](const std::string& text) {
    const Scene scene = read_scene(text, "a");
    const RunOutcome out = run_task(scene, choose_space(scene));
    EXPECT_EQ(out.status, SolveStatus::Converged);
    const auto& tip = out.results.responses[0].values;
    return tip[tip.size() - 2] - 0.015;
  };
  const double rigid = deflection(kFlap),
               averaged = deflection(changed(kFlap, "tip = { set = \"x_max\" }",
                                             "tip = { set = \"x_max\", tie = \"averaged\" }"));
  EXPECT_GT(averaged, rigid);
  EXPECT_NEAR(averaged, rigid, 0.02 * rigid);
}

/// In the middle of a pulled flap P/A of the thinner section, in the axes of the mesh, which turns
/// with its clamp.
TEST(ContinuumScene, ResultsShowItsStress) {
  const double P = 20, E = 1e6, nu = 0.3, A = 0.03 * 0.02;
  std::string pulled = changed(kFlap, "force = [0, 0.3, 0]", "force = [12, 16, 0]");
  pulled = changed(pulled, "thickness = 0.02",
                   "thickness = 0.02\norientation = [0, 0, 0.9272952180016122]");
  const Scene scene = read_scene(pulled, "a");
  const RunOutcome out = run_task(scene, choose_space(scene));
  ASSERT_EQ(out.status, SolveStatus::Converged);
  const auto& mesh = out.results.meshes[0];
  const std::size_t cells = 24, k = mesh.basis.size() / mesh.reference.size();
  ASSERT_EQ(mesh.stress_basis.size(), k * cells * 3);
  const std::size_t cell = 6, last = out.results.times.size() - 1;
  Vec3 stress = Vec3::Zero();
  for (std::size_t j = 0; j < k; ++j)
    for (std::size_t c = 0; c < 3; ++c)
      stress[int(c)] +=
          mesh.amplitudes[last * k + j] * mesh.stress_basis[3 * (cells * j + cell) + c];
  const double across = 1 - nu * P / (E * A), sigma = P / (A * across * across);
  EXPECT_NEAR(stress[0], sigma, 0.015 * sigma);
  EXPECT_LT(std::abs(stress[1]), 0.015 * sigma);
  EXPECT_LT(std::abs(stress[2]), 0.015 * sigma);
}

TEST(ContinuumScene, HasNoLoadSets) {
  const Scene scene = read_scene(kFlap, "a");
  const std::string said = test::refusal_of([&] { esl_task(scene, choose_space(scene)); });
  EXPECT_NE(said.find("part 'flap' is a continuum"), std::string::npos) << said;
  EXPECT_NE(said.find("as = \"reduced\""), std::string::npos) << said;
}

}  // namespace
}  // namespace liesl::test::continuum_scene_test
