/// @file
/// `liesl export --to matrices` and `solid.matrices`: there and back, and what is refused.
#include <Eigen/Dense>
#include <cmath>
#include <numeric>

#include "apps/hdf5_set.hpp"
#include "apps/mesh/matrix_file.hpp"
#include "apps/mesh/matrix_market.hpp"
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

/// A part, and what it is condensed to.
using Part = liesl::PartMatrices;
NodalMatrices by(const Eigen::MatrixXd& G, const NodalMatrices& m) {
  const Eigen::MatrixXd K = G.transpose() * m.K * G, M = G.transpose() * m.M * G;
  return {(0.5 * (K + K.transpose())).sparseView(), (0.5 * (M + M.transpose())).sparseView()};
}

/// G with the freedoms `held` as q and the others as K lets them follow.
Eigen::MatrixXd following(const NodalMatrices& m, const std::vector<int>& held) {
  std::vector<int> rest;
  for (int i = 0; i < m.K.rows(); ++i)
    if (std::find(held.begin(), held.end(), i) == held.end()) rest.push_back(i);
  const Eigen::MatrixXd K = m.K;
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(K.rows(), Eigen::Index(held.size()));
  G(held, Eigen::all).setIdentity();
  G(rest, Eigen::all) =
      -Eigen::MatrixXd(K(rest, rest)).ldlt().solve(Eigen::MatrixXd(K(rest, held)));
  return G;
}

/// To both ends and every so many nodes.
Part to_nodes(const Part& part, int every) {
  std::vector<int> nodes, freedoms;
  for (int i = 0; i < part.nodes.node_count(); ++i) {
    const double x = part.nodes.nodes(0, i);
    if (x > 1e-9 && x < 0.2 - 1e-9 && i % every != 0) continue;
    nodes.push_back(i);
    for (int a = 0; a < 2; ++a) freedoms.push_back(2 * i + a);
  }
  return {{2, part.nodes.nodes(Eigen::all, nodes), {}, {}},
          by(following(part.matrices, freedoms), part.matrices)};
}

/// To two nodes with rotations in the middle of the ends, which are rigid.
Part to_frames(const Part& part) {
  const int count = part.nodes.node_count();
  Part out;
  out.nodes.dim = 2;
  out.nodes.nodes = Eigen::Matrix3Xd::Zero(3, 2);
  out.nodes.nodes.col(0) << 0, 0.01, 0;
  out.nodes.nodes.col(1) << 0.2, 0.01, 0;
  std::vector<Eigen::Triplet<double>> T;
  int size = 6;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d x = part.nodes.nodes.col(i);
    const bool left = x[0]<1e-9, right = x[0]> 0.2 - 1e-9;
    if (!left && !right) {
      for (int a = 0; a < 2; ++a) T.emplace_back(2 * i + a, size++, 1);
      continue;
    }
    const Eigen::Vector3d r = x - out.nodes.nodes.col(right);
    for (int a = 0; a < 2; ++a) {
      T.emplace_back(2 * i + a, 3 * right + a, 1);
      T.emplace_back(2 * i + a, 3 * right + 2, a == 0 ? -r[1] : r[0]);
    }
  }
  Eigen::SparseMatrix<double> tie(2 * count, size);
  tie.setFromTriplets(T.begin(), T.end());
  const NodalMatrices tied = by(tie, part.matrices);
  std::vector<int> held(6);
  std::iota(held.begin(), held.end(), 0);
  out.matrices = by(following(tied, held), tied);
  return out;
}

/// A superelement of another program: its mass couples x, y and rotations. It moves as the mesh it
/// is condensed from, by files of both kinds.
TEST_F(PartMatrices, CondensedPartsMoveAsTheirMesh) {
  const Part part = read_matrix_file(dir_ / "matrices/bar.h5");
  const auto moves = [&](const Part& c, int modes, const std::string& tie, const char* force,
                         double within) {
    const std::string pull = std::string("loads.pull.force=[30, ") + force + ", 0]";
    const std::string tip = "bodies.bar.solid.interfaces.tip.tie=\"" + tie + "\"";
    ASSERT_EQ(run({"run", dir_ / "mesh.toml", "-o", results(), "-q", "-f", "--no-report", "--set",
                   "bodies.bar.solid.modes=" + std::to_string(modes), "--set", tip, "--set", pull})
                  .code,
              0);
    const DataSet mesh = read_set(results() / "results.h5", "/responses/tip");
    SolidMesh nodes = c.nodes;
    for (int i = 0; i < nodes.node_count(); ++i) {
      const double x = nodes.nodes(0, i);
      if (x < 1e-9) nodes.sets["root"].push_back(i);
      if (x > 0.2 - 1e-9) nodes.sets["tip"].push_back(i);
    }
    write_matrix_file(dir_ / "c.h5", {nodes, c.matrices});
    std::ofstream(dir_ / "K.mtx") << symmetric_text(c.matrices.K.triangularView<Eigen::Lower>(),
                                                    "N/m");
    std::ofstream(dir_ / "M.mtx") << symmetric_text(c.matrices.M.triangularView<Eigen::Lower>(),
                                                    "kg");
    std::ofstream(dir_ / "x.mtx") << dense_text(nodes.nodes.topRows(2).transpose(), "m");
    const auto list = [&](const char* set) {
      std::string numbers;
      for (const int node : nodes.sets[set]) numbers += std::to_string(node + 1) + ",";
      return "nodes = [" + numbers + "]";
    };
    for (const bool hdf5 : {true, false}) {
      const std::string files =
          hdf5 ? "file = \"c.h5\"" : R"(stiffness = "K.mtx", mass = "M.mtx", nodes = "x.mtx")";
      const std::string root = hdf5 ? "set = \"root\"" : list("root"),
                        held = hdf5 ? "set = \"tip\"" : list("tip");
      const std::string text =
          "name = \"bar\"\ngravity = [0, -9.81, 0]\n[bodies.bar.solid]\nmatrices = { " + files +
          " }\nat = [0.1, 0.2, 0]\norientation = [0, 0, 0.4]\ndamping = 1e-6\nmodes = " +
          std::to_string(modes) + "\ninterfaces = { root = { " + root + " }, tip = { tie = \"" +
          tie + "\", " + held + ", point = [0.2, 0.01] } }\n" + kMotion;
      const Outcome o =
          run({"run", write("c.toml", text), "-o", dir_ / "given", "--quiet", "-f", "--set", pull});
      ASSERT_EQ(o.code, 0) << o.out << o.err;
      const DataSet given = read_set(dir_ / "given/results.h5", "/responses/tip");
      ASSERT_EQ(mesh.shape, given.shape);
      double largest = 0, difference = 0;
      for (std::size_t i = 0; i < mesh.values.size(); ++i) {
        largest = std::max(largest, std::abs(mesh.values[i]));
        difference = std::max(difference, std::abs(mesh.values[i] - given.values[i]));
      }
      EXPECT_LT(difference, within * largest);
    }
  };
  moves(to_nodes(part, 7), 5, "averaged", "2e3", 3e-2);
  moves(to_nodes(part, 2), 5, "averaged", "2e3", 2e-3);  // the more nodes, the nearer
  // Two frames do not tell what turns with the bar between them: slowly, where that is little.
  moves(to_frames(part), 0, "rigid", "20", 1e-3);
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
  has(said_of("bar_mass.mtx", "1 1 ", "1 1 1e9"),
      "the mass of rigid motions is not that of a rigid body");
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
