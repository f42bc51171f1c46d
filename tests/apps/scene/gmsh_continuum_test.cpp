/// @file
/// Parts from Gmsh whose nodes all move, from the file to the responses: triangles and tetrahedra
/// of both orders against closed forms and the beam on the group; what is refused, by the program.
#include <algorithm>
#include <cmath>

#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/run.hpp"
#include "reference/simplex_bar.hpp"
#include "reference/spinning_bar.hpp"

namespace liesl::test::gmsh_continuum_test {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// A kind of cells that Gmsh makes.
struct Simplex {
  const char* name;
  int dim, order;
  /// Boxes that are cut into them; in the plane none through the thickness.
  Vector3i boxes(int nx, int n = 1) const { return {nx, n, dim == 3 ? n : 0}; }
};
const Simplex kT3{"T3", 2, 1}, kT6{"T6", 2, 2}, kT4{"T4", 3, 1}, kT10{"T10", 3, 2};
const std::vector<Simplex> kEvery{kT3, kT6, kT4, kT10}, kQuadratic{kT6, kT10};

class GmshContinuum : public Program {
 protected:
  /// A scene with a bar of that size, beside the mesh of it: material `foam`, ports bar.left and
  /// bar.right. @param part further keys of the bar
  Scene scene_of(const Simplex& kind, const Vector3d& size, const Vector3i& boxes,
                 const std::string& foam, const std::string& part, const std::string& rest,
                 const std::vector<std::string>& changes = {}) const {
    write("bar.msh", gmsh_text(simplex_bar(size, boxes, kind.order), size[0]));
    const std::string thick = kind.dim == 2 ? fmt::format("thickness = {}\n", size[2]) : "";
    return read_scene(
        "[materials]\nfoam = " + foam +
            "\n[bodies.bar.solid]\nas = \"continuum\"\nmesh = { file = \"bar.msh\" }\n"
            "material = \"foam\"\n" +
            thick + part +
            "\n[bodies.bar.solid.interfaces]\nleft = { set = \"left\" }\n"
            "right = { set = \"right\" }\n" +
            rest +
            "\n[responses]\ntip = { response = \"position\", at = "
            "\"bar.right\" }\n",
        (dir_ / "scene.toml").string(), changes);
  }
  /// Where the tip is at every record, a column each.
  static Eigen::Matrix3Xd path_of(const Scene& scene) {
    const RunOutcome out = run_task(scene, choose_space(scene));
    EXPECT_EQ(out.status, SolveStatus::Converged) << out.summary.reason;
    const auto& tip = out.results.responses.at(0).values;
    return Eigen::Matrix3Xd::Map(tip.data(), 3, static_cast<Eigen::Index>(tip.size() / 3));
  }
  static Vector3d tip_of(const Scene& scene) { return path_of(scene).rightCols<1>(); }
  static std::string clamped_under(const Vector3d& force) {
    return fmt::format(
        "[joints]\nclamp = {{ fixed = [\"ground\", \"bar.left\"] }}\n[loads]\npull = {{ at = "
        "\"bar.right\", force = [{}, {}, {}] }}\n[simulation]\ntype = \"static\"\nload_steps = 8\n"
        "max_iterations = 40\ntolerance = 1e-11\n",
        force[0], force[1], force[2]);
  }
};

/// The mesh is read whole, and told where it bends too stiffly.
TEST_F(GmshContinuum, IsReadWithItsGroups) {
  for (const Simplex& kind : kEvery) {
    SCOPED_TRACE(kind.name);
    const Scene scene = scene_of(kind, {1, 0.2, 0.1}, kind.boxes(3), "{ E = 1e6, rho = 1000 }", "",
                                 clamped_under({1, 0, 0}));
    const auto& part = std::get<SolidSpec>(scene.mechanism.bodies[0].kind);
    EXPECT_EQ(part.as, SolidMotion::Continuum);
    EXPECT_EQ(part.mesh().kind().dim, kind.dim);
    EXPECT_EQ(part.mesh().kind().order, kind.order);
    EXPECT_EQ(part.mesh().kind().family, CellFamily::Simplex);
    double size = 0;
    for (int e = 0; e < part.mesh().cell_count(); ++e) size += part.mesh().cell_size(e);
    EXPECT_NEAR(size, kind.dim == 2 ? 0.2 : 0.02, 1e-14);
    ASSERT_EQ(part.interfaces().size(), 2u);
    for (const Interface& f : part.interfaces()) {
      const double x = f.name == "left" ? 0 : 1;
      EXPECT_LT((f.point - Vector3d(x, 0, 0)).norm(), 1e-14);
      for (const int node : f.nodes) EXPECT_NEAR(part.mesh().nodes(0, node), x, 1e-14);
    }
    const bool told = std::ranges::any_of(scene.warnings, [](const std::string& w) {
      return w.find("bend too stiffly") != std::string::npos;
    });
    EXPECT_EQ(told, kind.order == 1);
  }
}

/// Pulled without lateral contraction, nu = 0, which all of them can: N = E A l (l^2 - 1)/2 and
/// N = mu A (l - 1/l).
TEST_F(GmshContinuum, IsPulledAsItsLawSays) {
  for (const Simplex& kind : kEvery) {
    SCOPED_TRACE(kind.name);
    const double E = 300, A = 0.02, N = 2;
    const auto stretch = [&](const std::string& law) {
      return tip_of(scene_of(kind, {1, 0.2, 0.1}, kind.boxes(2), "{ E = 300, nu = 0, rho = 1 }",
                             "law = \"" + law + "\"", clamped_under({N, 0, 0})))
          .x();
    };
    const double l = stretch("st_venant_kirchhoff"), soft = stretch("neo_hookean");
    EXPECT_NEAR(0.5 * E * A * l * (l * l - 1), N, 1e-8);
    EXPECT_NEAR(0.5 * E * A * (soft - 1 / soft), N, 1e-8);
    EXPECT_GT(soft, l + 0.05);
  }
}

/// In motion: it turns about its end from the start, and gets longer by what its spin pulls.
TEST_F(GmshContinuum, SpunItGetsAsLongAsItsClosedForm) {
  for (const Simplex& kind : kEvery) {
    SCOPED_TRACE(kind.name);
    const double E = 1e6, rho = 1000, k = 0.1, omega = k * std::sqrt(E / rho);
    const std::string spin = fmt::format(
        "[bodies.bar]\nangular_velocity = [0, 0, {0}]\n[joints]\nhinge = {{ revolute = "
        "[\"ground\", "
        "\"bar.left\"], drive = {{ rate = {0} }} }}\n[simulation]\nduration = 1.2\nstep = 6e-3\n"
        "tolerance = 1e-8\n",
        omega);
    const double length =
        tip_of(scene_of(kind, {1, 0.2, 0.1}, kind.boxes(12), "{ E = 1e6, nu = 0, rho = 1000 }",
                        "damping = 0.05", spin))
            .norm();
    RecordProperty(std::string(kind.name) + "_longer",
                   std::to_string((length - 1) / (spun_length(k * k) - 1)));
    EXPECT_NEAR((length - 1) / (spun_length(k * k) - 1), 1, 0.01);
    EXPECT_NEAR((length - 1) / (std::tan(k) / k - 1), 1, 0.015);
  }
}

/// Elastica (Mattiasson 1981) at P L^2/EI = 2: [shortening, deflection]; shear adds 0.6 (h/L)^2 of
/// the deflection.
TEST_F(GmshContinuum, BendsAsTheElastica) {
  for (const Simplex& kind : kQuadratic) {
    SCOPED_TRACE(kind.name);
    const double h = 0.05, EI = 1e9 * h * h * h * h / 12;
    const Vector3d tip =
        tip_of(scene_of(kind, {1, h, h}, kind.boxes(20), "{ E = 1e9, nu = 0, rho = 1 }", "",
                        clamped_under({0, 2 * EI, 0})));
    RecordProperty(std::string(kind.name) + "_shortening", std::to_string(1 - tip.x()));
    RecordProperty(std::string(kind.name) + "_deflection", std::to_string(tip.y()));
    EXPECT_NEAR(1 - tip.x(), 0.1606417208, 0.005 * 0.1606417208);
    EXPECT_NEAR(tip.y(), 0.4934574804, 0.005 * 0.4934574804);
  }
}

constexpr const char* kSwingingFoam = "{ E = 1e6, nu = 0, rho = 1000 }";
constexpr const char* kSwing =
    "[joints]\nhinge = { revolute = [\"ground\", \"bar.left\"] }\n[simulation]\nduration = 0.25\n"
    "step = 1e-3\n";
constexpr const char* kSwingingBeam = R"toml(gravity = [0, -9.81, 0]
[materials]
foam = { E = 1e6, nu = 0, rho = 1000 }
[sections]
square = { type = "rectangle", width = 0.02, height = 0.02, shear_factor = 0.8333333333333334 }
[bodies]
bar = { beam = { from = [0, 0, 0], to = [0.5, 0, 0], section = "square", material = "foam", elements = 32 } }
[joints]
hinge = { revolute = ["ground", "bar.start"] }
[simulation]
duration = 0.25
step = 1e-3
[responses]
tip = { response = "position", at = "bar.end" }
)toml";

/// A pendulum that bends while it falls: over its whole motion within 3 % of what the beam on the
/// group bends by at most.
TEST_F(GmshContinuum, SwingsAsTheBeam) {
  const auto apart = [](const Eigen::Matrix3Xd& one, const Eigen::Matrix3Xd& other) {
    return (one - other).colwise().norm().maxCoeff();
  };
  const auto beam = path_of(read_scene(kSwingingBeam, "beam")),
             rigid = path_of(read_scene(kSwingingBeam, "beam", {"simulation.formalism=rigid"}));
  const double bends = apart(beam, rigid);
  EXPECT_GT(bends, 0.02);
  for (const Simplex& kind : kQuadratic) {
    SCOPED_TRACE(kind.name);
    const Scene scene = scene_of(kind, {0.5, 0.02, 0.02}, kind.boxes(20), kSwingingFoam, "", kSwing,
                                 {"gravity=[0,-9.81,0]"});
    const double off = apart(path_of(scene), beam);
    RecordProperty(std::string(kind.name) + "_off", std::to_string(off / bends));
    EXPECT_LT(off, 0.03 * bends);
  }
}

/// Cells of constant strain are too stiff, and come to the limit of those with nodes at their edges
/// with the square of their size.
TEST_F(GmshContinuum, TrianglesOfConstantStrainConverge) {
  const auto deflection = [this](const Simplex& kind, int n) {
    return tip_of(scene_of(kind, {1, 0.2, 0.1}, kind.boxes(8 * n, 2 * n),
                           "{ E = 1e6, nu = 0, rho = 1 }", "", clamped_under({0, 0.05, 0})))
        .y();
  };
  const double a = deflection(kT3, 2), b = deflection(kT3, 4), c = deflection(kT3, 8),
               limit = deflection(kT6, 4);
  EXPECT_LT(a, b);
  EXPECT_LT(b, c);
  EXPECT_NEAR(std::log2((limit - b) / (limit - c)), 2, 0.3);
  EXPECT_LT(limit - c, 0.05 * limit);
}

TEST_F(GmshContinuum, TetrahedraOfConstantStrainComeNearer) {
  const auto deflection = [this](const Simplex& kind, int n) {
    return tip_of(scene_of(kind, {1, 0.25, 0.25}, kind.boxes(4 * n, n),
                           "{ E = 1e6, nu = 0, rho = 1 }", "", clamped_under({0, 0.3, 0})))
        .y();
  };
  const double coarse = deflection(kT4, 1), fine = deflection(kT4, 3), limit = deflection(kT10, 1);
  EXPECT_LT(coarse, 0.9 * limit);
  EXPECT_LT(fine, limit);
  EXPECT_LT(limit - fine, 0.4 * (limit - coarse));
}

/// What the traps of docs/traps.md refuse has its place and says what to do.
struct BadMesh {
  std::string change;
  std::vector<const char*> words;
};

TEST_F(GmshContinuum, IsRefusedAtItsPlaceByTheProgram) {
  const fs::path traps = kData / ".." / "tests" / "traps";
  const auto run_with = [&](const std::string& change) {
    return run({"run", traps / "tetrahedra.toml", "-o", results(), "--force", "--set", change});
  };
  EXPECT_EQ(run_with("materials.foam.nu=0.49").code, 0);
  const auto mesh = [](const char* name) {
    return fmt::format("bodies.block.solid.mesh.file=\"{}.msh\"", name);
  };
  const std::vector<BadMesh> cases = {
      {mesh("inverted_t4"), {"inverted_t4.msh:29:1: ", "the fourth corner where"}},
      {mesh("folded_t4"), {"folded_t4.msh:29:1: ", "overlaps that in line 28", "; hint: "}},
      {mesh("inverted_t10"), {"inverted_t10.msh:33:1: ", "the fourth corner where"}},
      {mesh("folded_t10"),
       {"folded_t10.msh:33:1: ", "node 8 is 0.4 of the edge between nodes 1 and 4 off its middle",
        "; hint: move it there, straighten edges with Mesh.SecondOrderLinear"}},
      {mesh("two_pieces"),
       {"tetrahedra.toml:7:", "2 pieces without a node", "; hint: 'Coherence'"}},
      {mesh("hinged_pieces"), {"tetrahedra.toml:7:", "share no side", "; hint: 'Coherence'"}},
      {mesh("none"), {"none.msh", "no such file", "relative to the scene"}},
      {"materials.foam.nu=0.5", {"--set materials.foam.nu", "in (-1, 0.5)", "; hint: "}},
      {"materials.foam.nu=0.49995", {"tetrahedra.toml:8:", "incompressible", "nu < 0.4999"}},
      {"bodies.block.solid.interfaces.base.set=\"bottom\"",
       {"interfaces.base.set", "no set of nodes 'bottom'", "a physical group", "known: base"}}};
  for (const BadMesh& c : cases) {
    const Outcome outcome = run_with(c.change);
    EXPECT_EQ(outcome.code, 2) << c.change;
    for (const char* words : c.words)
      EXPECT_NE(outcome.err.find(words), std::string::npos) << words << " in\n" << outcome.err;
  }
}

}  // namespace
}  // namespace liesl::test::gmsh_continuum_test
