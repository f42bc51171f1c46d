/// @file
/// `liesl export --to matrices` and `solid.matrices`: there and back, and what is refused.
#include <cmath>

#include "apps/hdf5_set.hpp"
#include "apps/program.hpp"

namespace liesl::test::part_matrices_test {
namespace {

const std::string kMotion = R"([joints]
pin = { revolute = ["ground", "bar.root"] }
[loads]
pull = { at = "bar.tip", force = [30, 2e3, 0] }
[simulation]
duration = 5e-3
step = 5e-5
[responses]
tip = { response = "displacement", at = "bar.tip", axis = [0, 1, 0] }
)";
const std::string kMesh = R"(name = "bar"
gravity = [0, -9.81, 0]
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies.bar.solid]
mesh = { from = [0, 0], to = [0.2, 0.02], cells = [30, 4] }
material = "steel"
thickness = 0.01
at = [0.1, 0.2, 0]
orientation = [0, 0, 0.4]
modes = 5
damping = 1e-6
interfaces = { root = { set = "x_min" }, tip = { set = "x_max", tie = "averaged", point = [0.2, 0.01] } }
[bodies.bar.solid.outline]
bar = { type = "rectangle", x = 0.1, y = 0.01, width = 0.2, height = 0.02 }
hole = { type = "circle", x = 0.1, y = 0.01, radius = 0.006 }
part = { type = "difference", of = ["bar", "hole"] }
)";

/// As NAME.toml names them.
const std::string kThree =
    R"(stiffness = "bar_stiffness.mtx", mass = "bar_mass.mtx", nodes = "bar_nodes.mtx")";

class PartMatrices : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    const Outcome o = run({"export", write("mesh.toml", kMesh + kMotion), "--to", "matrices",
                           "--part", "bar", "-o", dir_ / "matrices"});
    ASSERT_EQ(o.code, 0) << o.err;
  }
  /// The scene with the part that was exported, beside its files.
  fs::path back(const std::string& from = "", const std::string& to = "") const {
    std::string part = text_of(dir_ / "matrices/bar.toml");
    if (const auto at = part.find(from); !from.empty()) {
      EXPECT_NE(at, std::string::npos) << from;
      part.replace(at, from.size(), to);
    }
    std::ofstream(dir_ / "matrices/scene.toml") << "name = \"bar\"\ngravity = [0, -9.81, 0]\n"
                                                << part << kMotion;
    return dir_ / "matrices/scene.toml";
  }
  /// The motions in "results" and "given".
  void expect_alike() const {
    // Positions as they are; rates to what a step's residual leaves. The displacement, of 1.2 mm,
    // is a difference of positions: to what those are held to.
    double size = 0;
    for (const auto& [name, within] : {std::pair{"/bodies/bar/position", 1e-12},
                                       {"/bodies/bar/velocity", 1e-10},
                                       {"/responses/tip", 1e-12}}) {
      const DataSet mesh = read_set(results() / "results.h5", name),
                    given = read_set(dir_ / "given/results.h5", name);
      ASSERT_EQ(mesh.shape, given.shape) << name;
      ASSERT_FALSE(mesh.values.empty()) << name;
      double largest = 0, difference = 0;
      for (std::size_t i = 0; i < mesh.values.size(); ++i) {
        largest = std::max(largest, std::abs(mesh.values[i]));
        difference = std::max(difference, std::abs(mesh.values[i] - given.values[i]));
      }
      EXPECT_GT(largest, 0) << name;
      if (size == 0) size = largest;
      const bool displacement = name == std::string("/responses/tip");
      EXPECT_LT(difference, within * (displacement ? size : largest)) << name;
    }
  }
  /// What is said of a file in which one line was changed.
  std::string said_of(const char* file, const std::string& start, const std::string& line) const {
    const fs::path path = dir_ / "matrices" / file;
    const std::string before = text_of(path);
    const auto at = before.find("\n" + start) + 1;
    std::ofstream(path) << before.substr(0, at) + line + before.substr(before.find('\n', at));
    const Outcome o = run({"check", back()});
    EXPECT_EQ(o.code, 2) << o.err;
    std::ofstream(path) << before;
    return o.out + o.err;
  }
};

TEST_F(PartMatrices, AMeshThatIsWrittenAndReadBackMovesAlike) {
  ASSERT_EQ(run({"run", dir_ / "mesh.toml", "-o", results(), "--quiet", "--no-report"}).code, 0);
  for (const std::string& files : {kThree, std::string("file = \"bar.h5\"")}) {
    const Outcome o = run(
        {"run", back(kThree, files), "-o", dir_ / "given", "--quiet", "--no-report", "--force"});
    ASSERT_EQ(o.code, 0) << o.err;
    expect_alike();
  }
}

TEST_F(PartMatrices, ReportsAndPicturesDoWithoutCells) {
  EXPECT_EQ(run({"run", back(), "-o", results(), "--quiet"}).code, 0);
  EXPECT_TRUE(fs::exists(results() / "report.html"));
  const Outcome o = run({"export", back(), "--to", "calculix", "--part", "bar", "-o", dir_ / "x"});
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.err.find("given by matrices"), std::string::npos) << o.err;
}

TEST_F(PartMatrices, HasACompliance) {
  const auto check = [this](const std::string& response) {
    return run(
        {"check", back(), "--set", "responses={s={response=\"" + response + "\",of=\"bar\"}}"});
  };
  EXPECT_EQ(check("compliance").code, 0);
  const Outcome o = check("stress");
  EXPECT_EQ(o.code, 2);
  for (const char* words : {"part 'bar' is known by its matrices, which tell no stress",
                            "expected a part with a 'mesh'"})
    EXPECT_NE((o.out + o.err).find(words), std::string::npos) << o.err;
}

TEST_F(PartMatrices, FaultsOfTheFilesAreNamedAtTheirPlaces) {
  const auto has = [](const std::string& text, const char* words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  has(said_of("bar_mass.mtx", "1 1 ", "1 1 nan"), "bar_mass.mtx:4:1: 'nan' is not finite");
  has(said_of("bar_stiffness.mtx", "1 1 ", "1 1 1e15"),
      "a rigid displacement is none of the stiff");
  has(said_of("bar_nodes.mtx", "155 2", "154 2"), "310 x 310, the nodes have 308 displacements");
  has(said_of("bar_mass.mtx", "1 1 ", "1 1 1e9"), "the mass matrix is not that of a solid");
  const auto refused = [&](const fs::path& scene, const char* words) {
    const Outcome o = run({"check", scene});
    EXPECT_EQ(o.code, 2);
    has(o.out + o.err, words);
  };
  refused(back("bar_mass.mtx", "none.mtx"), "none.mtx");
  refused(back("stiffness = \"bar_stiffness.mtx\", ", ""), "has matrices without 'stiffness'");
  refused(back("stiffness =", "file = \"bar.h5\", stiffness ="),
          "has matrices in a 'file', and 'stiffness'");
  refused(back(kThree, "file = \"bar_mass.mtx\""), "it is no HDF5 file");
  ASSERT_EQ(run({"run", dir_ / "mesh.toml", "-o", dir_ / "matrices/r", "--quiet"}).code, 0);
  refused(back(kThree, "file = \"r/results.h5\""), "it has no data set 'nodes'");
  refused(back("modes", "thickness = 0.1\nmodes"),
          "has 'thickness', although it is given by matrices");
  refused(back("nodes = [", "nodes = [156, "), "has no node 156");
  refused(back("nodes = [", "nodes = [1.5, "), "has no node 1.5");
}

}  // namespace
}  // namespace liesl::test::part_matrices_test
