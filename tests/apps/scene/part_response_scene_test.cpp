/// @file
/// Stress and compliance of meshed parts in scenes: what is read, what is refused at its place, and
/// that they are those of the fields that results and pages show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/run.hpp"

namespace liesl::test::part_response_scene_test {
namespace {

const std::string kRod = R"toml(name = "rod"
gravity = [0, -9.81, 0]
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }

[bodies.rod.solid]
mesh = { from = [0, -0.01], to = [0.2, 0.01], cells = [24, 4] }
thickness = 0.01
material = "steel"
interfaces = { root = { set = "x_min" }, tip = { set = "x_max" } }
outline.bar = { type = "rectangle", x = 0.1, width = 0.2, height = 0.02 }
outline.hole = { type = "circle", x = 0.08, radius = 0.006 }
outline.rod = { type = "difference", of = ["bar", "hole"] }

[joints]
motor = { revolute = ["ground", "rod.root"], drive = { rate = 20, ramp = 0.02 } }
[loads]
pull = { at = "rod.tip", force = [300, 200, 0] }
[simulation]
duration = 0.02
step = 2e-4
[responses]
most = { response = "stress", of = "rod" }
soft = { response = "compliance", of = "rod" }
)toml";

/// The same in space, without a hole.
std::string in_space() {
  std::string text =
      changed(kRod, "{ from = [0, -0.01], to = [0.2, 0.01], cells = [24, 4] }",
              "{ from = [0, -0.01, 0], to = [0.2, 0.01, 0.01], cells = [12, 2, 1] }");
  const auto from = text.find("outline.bar"), to = text.find("\n[joints]");
  return changed(text.erase(from, to - from), "thickness = 0.01\n", "");
}

double von_mises_of(const std::vector<double>& s) {
  if (s.size() == 3) return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * s[2] * s[2]);
  const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
  return std::sqrt((a * a + b * b + c * c) / 2 + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

/// v^(1/2) times the von Mises stress of each cell, the largest by record.
std::vector<double> largest_of_the_field(const output::MeshResult& mesh) {
  const std::size_t cells = mesh.fractions.size(), N = mesh.dim() == 2 ? 3 : 6;
  const std::size_t count = mesh.basis.size() / mesh.reference.size();
  EXPECT_EQ(mesh.stress_basis.size(), count * cells * N);
  std::vector<double> out(mesh.amplitudes.size() / count, 0.0);
  for (std::size_t n = 0; n < out.size(); ++n)
    for (std::size_t e = 0; e < cells; ++e) {
      std::vector<double> stress(N, 0.0);
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t c = 0; c < N; ++c)
          stress[c] += mesh.amplitudes[count * n + k] * mesh.stress_basis[N * (cells * k + e) + c];
      out[n] = std::max(out[n], std::sqrt(mesh.fractions[e]) * von_mises_of(stress));
    }
  return out;
}

/// Of all records, `within` of the largest value. One body and no spring: its energy is the whole.
void expect_fields(const std::string& text, double within) {
  const Scene scene = read_scene(text, "rod.toml");
  const RunOutcome out = run_task(scene, choose_space(scene));
  ASSERT_EQ(out.status, SolveStatus::Converged) << out.summary.reason;
  const auto& responses = out.results.responses;
  ASSERT_EQ(responses.size(), 2u);
  EXPECT_EQ(responses[0].unit, "Pa");
  EXPECT_EQ(responses[1].unit, "J");
  const auto field = largest_of_the_field(out.results.meshes.at(0));
  ASSERT_EQ(field.size(), responses[0].values.size());
  const double most = *std::max_element(field.begin(), field.end());
  EXPECT_GT(most, 1e6);
  for (std::size_t n = 0; n < field.size(); ++n) {
    EXPECT_NEAR(responses[0].values[n], field[n], within * most) << n;
    const double twice = 2 * out.results.energies.elastic[n];
    EXPECT_NEAR(responses[1].values[n], twice, 1e-12 * std::abs(twice)) << n;
  }
}

TEST(PartResponseScene, StressAndComplianceAreThoseOfTheFieldsOfAReducedPart) {
  expect_fields(kRod, 1e-9);
  expect_fields(in_space(), 1e-9);
}

/// Results have its stress to 1 %.
TEST(PartResponseScene, OfAContinuumTheyAreThoseOfItsFields) {
  expect_fields(changed(kRod, "thickness", "as = \"continuum\"\nthickness"), 0.03);
}

struct Fault {
  const char *from, *to;
  std::vector<const char*> words;
};

TEST(PartResponseScene, OtherResponsesAreRefusedAtTheirPlace) {
  const auto read = [](const auto& text, const auto& file) { read_scene(text, file); };
  const std::vector<Fault> faults = {{"\"stress\", of = \"rod\"",
                                      "\"section_force\", of = @\"rod\", component = \"N\"",
                                      {"body 'rod' is a meshed part, which has no section_force",
                                       "expected a beam", "deflection, stress and compliance"}},
                                     {"\"stress\", of = \"rod\"",
                                      "\"axial_stress\", of = @\"rod\"",
                                      {"which has no axial_stress", "expected a beam"}}};
  for (const Fault& f : faults)
    expect_refused(MarkedText(changed(kRod, f.from, f.to)), "scene.toml", read, f.words);
}

TEST(PartResponseScene, OfARigidPartIsSaidToBeZero) {
  const std::string text =
      changed(kRod, "tip =", "mid = { box = { from = [0.099, -1], to = [0.101, 1] } }, tip =") +
      "bend = { response = \"deflection\", of = \"rod\", at = \"mid\" }\n";
  const Scene scene = read_scene(text, "rod.toml", {"simulation.formalism=\"rigid\""});
  const auto said = [&scene](const std::string& name) {
    const std::string words =
        "response '" + name + "' is 0 by definition: 'rod' is simulated as a rigid body";
    return std::count(scene.warnings.begin(), scene.warnings.end(), words);
  };
  EXPECT_EQ(said("most"), 1);
  EXPECT_EQ(said("soft"), 1);
  EXPECT_EQ(said("bend"), 1);
}

}  // namespace
}  // namespace liesl::test::part_response_scene_test
