/// @file
/// The program on a scene with a meshed part: figures, files, load sets.
#include <cmath>

#include "apps/hdf5_set.hpp"
#include "apps/program.hpp"

namespace liesl::test::solid_run_test {
namespace {

class SolidRun : public Program {
 protected:
  /// A short run of the shipped scene on a coarser mesh.
  Outcome command(const char* name, const Words& more = {}) const {
    Words words = {
        name,    scene("meshed_slider_crank"),           "-o",    results(),
        "--set", "bodies.rod.solid.mesh.cells=[75, 15]", "--set", "simulation.duration=0.005"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(SolidRun, SaysHowFarTheModesReach) {
  const Outcome o = command("run");
  ASSERT_EQ(o.code, 0) << o.err;
  const Json rod = summary()["parts"]["rod"];
  EXPECT_EQ(rod["cells"], 1125);
  EXPECT_EQ(rod["unknowns"], 3 + 8);
  EXPECT_EQ(rod["modes"], 8);
  const double limit = rod["right_up_to_hz"];
  EXPECT_GT(limit, 1e4);
  ASSERT_EQ(rod["free_hz"].size(), 12u);
  ASSERT_EQ(rod["reduced_hz"].size(), 11u);
  for (std::size_t i = 0; i < rod["reduced_hz"].size(); ++i) {
    const double full = rod["free_hz"][i], reduced = rod["reduced_hz"][i];
    EXPECT_GT(reduced, full * (1 - 1e-6)) << "a reduced part is stiffer";
    if (full < limit) {
      EXPECT_LT(reduced, 1.01 * full);
    }
  }
}

/// Shipped parts keep enough modes for what excites them.
TEST_F(SolidRun, ShippedPartsAreRightUpToTwiceTheirHighestHarmonic) {
  for (const char* name : {"meshed_slider_crank", "connecting_rod"}) {
    ASSERT_EQ(run({"run", scene(name), "-o", results(), "--force"}).code, 0);
    const Json rod = summary()["parts"]["rod"];
    const double harmonic = rod["harmonic_hz"];
    EXPECT_GE(rod["right_up_to_hz"], 2 * harmonic) << name;
    EXPECT_LE(rod["modes_needed"], rod["modes"]) << name;
    EXPECT_EQ(rod["harmonic_share"], 1e-3);
    // Far above the 50 Hz of the drive: the combustion takes a twentieth of a turn.
    EXPECT_GT(harmonic, 10 * 50) << name;
    EXPECT_LT(harmonic, 30 * 50) << name;
    EXPECT_TRUE(summary()["warnings"].empty()) << name;
  }
}

TEST_F(SolidRun, WarnsOfTooFewModesAndSaysHowManyWouldDo) {
  const Words shipped = {"run",   scene("meshed_slider_crank"), "-o",   results(), "--force",
                         "--set", "bodies.rod.solid.modes=0",   "--set"};
  Words few = shipped, enough = shipped;
  few.push_back("simulation.step=5e-5");
  ASSERT_EQ(run(few).code, 0);
  const Json rod = summary()["parts"]["rod"];
  EXPECT_LT(rod["right_up_to_hz"], 2 * double(rod["harmonic_hz"]));
  const int needed = rod["modes_needed"];
  EXPECT_GT(needed, 0);
  const std::string would_do = "bodies.rod.solid.modes = " + std::to_string(needed) + " would do";
  ASSERT_EQ(summary()["warnings"].size(), 1u);
  EXPECT_NE(std::string(summary()["warnings"][0]).find(would_do), std::string::npos);
  enough.push_back("bodies.rod.solid.modes=" + std::to_string(needed));
  ASSERT_EQ(run(enough).code, 0);
  EXPECT_GE(summary()["parts"]["rod"]["right_up_to_hz"],
            2 * double(summary()["parts"]["rod"]["harmonic_hz"]));
  EXPECT_TRUE(summary()["warnings"].empty());
}

/// A plate that is shaken: far below its first frequency its loads are those of the force.
TEST_F(SolidRun, AHarmonicForceGivesItsFrequency) {
  const auto text = [](double hz) {
    return R"([materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies.plate.solid]
mesh = { from = [0, 0], to = [0.2, 0.05], cells = [16, 4] }
material = "steel"
thickness = 0.01
damping = 1e-5
interfaces = { root = { set = "x_min" }, tip = { set = "x_max" } }
[joints]
clamp = { fixed = ["ground", "plate.root"] }
[loads.shaker]
at = "plate.tip"
force = [3, 1, 0]
scale = "sin(2*pi*)" +
           std::to_string(hz) + R"(*t)^2"
[simulation]
duration = 0.5
step = 1e-3
)";
  };
  for (const double hz : {11., 40.}) {
    const Outcome o = run({"run", write("plate.toml", text(hz)), "-o", results(), "--force"});
    ASSERT_EQ(o.code, 0) << o.err;
    // sin^2 has twice the frequency.
    EXPECT_NEAR(summary()["parts"]["plate"]["harmonic_hz"], 2 * hz, 2 / 0.5);
  }
}

TEST_F(SolidRun, KeepsTheDeformedMesh) {
  ASSERT_EQ(command("run").code, 0);
  const auto cells = read_set(results() / "results.h5", "/meshes/rod/cells");
  EXPECT_EQ(cells.shape, (std::vector<hsize_t>{1125, 4}));
  const auto position = read_set(results() / "results.h5", "/meshes/rod/position");
  ASSERT_EQ(position.shape, (std::vector<hsize_t>{101, 76 * 16, 3}));
  // At the start it lies where the scene puts it: its corners.
  EXPECT_NEAR(position.values[0], 0.06 - 0.025, 1e-12);
  EXPECT_NEAR(position.values[1], -0.025, 1e-12);
  // Without its deformation it is the rod at rest, moved: two corners keep their distance.
  const auto displacement = read_set(results() / "results.h5", "/meshes/rod/displacement");
  ASSERT_EQ(displacement.shape, position.shape);
  const std::size_t last = 100 * 76 * 16 * 3, other = last + 75 * 3;
  double rigid = 0, deformed = 0;
  for (int i = 0; i < 3; ++i) {
    const double x = position.values[other + i] - position.values[last + i];
    const double u = displacement.values[other + i] - displacement.values[last + i];
    rigid += (x - u) * (x - u);
    deformed += x * x;
  }
  EXPECT_NEAR(std::sqrt(rigid), 0.245, 1e-12);
  EXPECT_GT(std::abs(std::sqrt(deformed) - 0.245), 1e-9);
  const std::string xdmf = text_of(results() / "results.xdmf");
  EXPECT_NE(xdmf.find("rod mesh"), std::string::npos);
  EXPECT_NE(xdmf.find("Quadrilateral"), std::string::npos);
}

/// Cells of four nodes are quadrilaterals or tetrahedra: results say which, also when they are
/// read.
TEST_F(SolidRun, ResultsNameTheKindOfCell) {
  write("part.inp",
        "*NODE\n1, 0, 0, 0\n2, 0, 1, 0\n3, 0, 0, 1\n4, 2, 0, 0\n5, 2, 1, 0\n6, 2, 0, 1\n"
        "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n2, 2, 5, 3, 4\n3, 3, 5, 6, 4\n"
        "*NSET, NSET=left\n1, 2, 3\n*NSET, NSET=right\n4, 5, 6\n");
  const fs::path file = write("scene.toml", R"(name = "prism"
gravity = [0, -9.81, 0]
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies.part.solid]
mesh = { file = "part.inp" }
material = "steel"
modes = 1
interfaces = { left = { set = "left" }, right = { set = "right", tie = "averaged" } }
[joints]
hinge = { revolute = ["ground", "part.left"] }
[simulation]
duration = 1e-2
step = 1e-3
)");
  const Outcome o = run({"run", file, "-o", results()});
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_NE((o.out + o.err).find("bend too stiffly"), std::string::npos) << o.out << o.err;
  EXPECT_EQ(read_set(results() / "results.h5", "/meshes/part/cells").shape,
            (std::vector<hsize_t>{3, 4}));
  EXPECT_NE(text_of(results() / "results.xdmf").find("\"Tetrahedron\""), std::string::npos);
  ASSERT_EQ(run({"export", results(), "--to", "xdmf"}).code, 0);
  const std::string xdmf = text_of(results() / "results.xdmf");
  EXPECT_NE(xdmf.find("\"Tetrahedron\""), std::string::npos);
  EXPECT_NE(xdmf.find("meshes.h5:/meshes/part/cells"), std::string::npos);
  fs::remove(results() / "meshes.h5");  // which is made of results.h5 alone, and again
  const Outcome page = run({"report", results()});
  EXPECT_EQ(page.code, 0) << page.err;
  ASSERT_EQ(run({"export", results(), "--to", "xdmf"}).code, 0);
  EXPECT_TRUE(fs::exists(results() / "meshes.h5"));
}

/// What results.h5 kept in full and what `export` makes of the amplitudes are one.
TEST_F(SolidRun, ExportMakesTheDeformedMeshOfTheAmplitudes) {
  ASSERT_EQ(command("run").code, 0);
  const auto kept = read_set(results() / "results.h5", "/meshes/rod/position");
  const auto kept_u = read_set(results() / "results.h5", "/meshes/rod/displacement");
  const Outcome o = run({"export", results(), "--to", "xdmf"});
  ASSERT_EQ(o.code, 0) << o.err;
  const auto made = read_set(results() / "meshes.h5", "/meshes/rod/position");
  const auto made_u = read_set(results() / "meshes.h5", "/meshes/rod/displacement");
  ASSERT_EQ(made.shape, kept.shape);
  ASSERT_FALSE(made.values.empty());
  for (std::size_t i = 0; i < kept.values.size(); ++i) {
    ASSERT_NEAR(made.values[i], kept.values[i], 1e-13);
    ASSERT_NEAR(made_u.values[i], kept_u.values[i], 1e-15);
  }
  const std::string xdmf = text_of(results() / "results.xdmf");
  EXPECT_NE(xdmf.find("meshes.h5:/meshes/rod/position"), std::string::npos);
  EXPECT_NE(xdmf.find("results.h5:/bodies/crank/position"), std::string::npos);
}

TEST_F(SolidRun, LargeMeshesAreLeftToExport) {
  const Words words = {"run",        scene("meshed_slider_crank"),
                       "-o",         results(),
                       "--set",      "bodies.rod.solid.mesh.cells=[150, 30]",
                       "--no-report"};
  ASSERT_EQ(run(words).code, 0);
  EXPECT_LT(fs::file_size(results() / "results.h5"), 5e6) << "57 MB with positions at each record";
  EXPECT_EQ(text_of(results() / "results.xdmf").find("rod mesh"), std::string::npos);
  ASSERT_EQ(run({"export", results()}).code, 0);
  EXPECT_NE(text_of(results() / "results.xdmf").find("rod mesh"), std::string::npos);
  const Outcome cases = run({"export", results(), "--cases", "all"});
  EXPECT_EQ(cases.code, 2);
  EXPECT_NE(cases.err.find("--cases"), std::string::npos) << "has no effect on xdmf, so is refused";
  const Outcome part = run({"export", scene("meshed_slider_crank"), "--part", "rod"});
  EXPECT_EQ(part.code, 2);
  for (const char* to : {"--to calculix", "--to nastran", "--to matrices"})
    EXPECT_NE(part.err.find(to), std::string::npos) << part.err;
}

/// The stress of a mode at the centre of a cell, by hand: plane stress of the mean gradient.
TEST_F(SolidRun, StressOfTheAmplitudesIsThatOfTheirDisplacements) {
  ASSERT_EQ(command("run", {"--no-report"}).code, 0);
  const auto file = results() / "results.h5";
  const auto cells = read_set(file, "/meshes/rod/cells"),
             x = read_set(file, "/meshes/rod/reference"),
             basis = read_set(file, "/meshes/rod/basis"),
             stress = read_set(file, "/meshes/rod/stress_basis");
  const std::size_t M = cells.shape[0], N = x.shape[0];
  ASSERT_EQ(stress.shape, (std::vector<hsize_t>{basis.shape[0], M, 3}));
  const double E = 210e9, nu = 0.3, factor = E / (1 - nu * nu);
  for (const std::size_t k : {std::size_t{0}, std::size_t{4}})
    for (std::size_t e = 0; e < M; e += 97) {
      const auto node = [&](int c) { return std::size_t(cells.values[4 * e + std::size_t(c)]); };
      const auto at = [&](int c, int i) { return x.values[3 * node(c) + std::size_t(i)]; };
      const auto u = [&](int c, int i) {
        return basis.values[3 * (N * k + node(c)) + std::size_t(i)];
      };
      const double a = at(1, 0) - at(0, 0), b = at(3, 1) - at(0, 1);  // a rectangle
      const auto along = [&](int i) { return (u(1, i) + u(2, i) - u(0, i) - u(3, i)) / (2 * a); };
      const auto across = [&](int i) { return (u(3, i) + u(2, i) - u(0, i) - u(1, i)) / (2 * b); };
      const double ex = along(0), ey = across(1), g = along(1) + across(0);
      const double* s = &stress.values[3 * (M * k + e)];
      const double size = factor * (std::abs(ex) + std::abs(ey) + std::abs(g));
      EXPECT_NEAR(s[0], factor * (ex + nu * ey), 1e-9 * size);
      EXPECT_NEAR(s[1], factor * (ey + nu * ex), 1e-9 * size);
      EXPECT_NEAR(s[2], factor * (1 - nu) / 2 * g, 1e-9 * size);
    }
}

TEST_F(SolidRun, LoadSetsGiveBackTheDeformation) {
  const Outcome o = command("esl");
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_LT(summary()["identity"]["rod"]["linear"], 1e-8);
  const auto e = read_set(results() / "loads.h5", "/loads/rod/coordinates");
  EXPECT_EQ(e.shape, (std::vector<hsize_t>{101, 11}));
  const auto shapes = read_set(results() / "loads.h5", "/loads/rod/shapes");
  EXPECT_EQ(shapes.shape[0], 11u);
}

TEST_F(SolidRun, BadPartsAreRefused) {
  const Outcome cut = command("run", {"--set", "bodies.rod.solid.outline.shank.width=0.1"});
  EXPECT_EQ(cut.code, 2);
  EXPECT_NE(cut.err.find("'small_end' is cut off"), std::string::npos) << cut.err;
  EXPECT_FALSE(fs::exists(results()));
}

}  // namespace
}  // namespace liesl::test::solid_run_test
