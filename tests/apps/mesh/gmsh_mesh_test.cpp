#include "apps/mesh/gmsh_mesh.hpp"

#include <gtest/gtest.h>

#include "apps/input/problem.hpp"

namespace liesl::test::gmsh_mesh_test {
namespace {

/// Two quadrilaterals side by side, a named line on the left, a node that no cell uses.
const std::string kTwoQuads = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "left end"
2 8 "plate"
$EndPhysicalNames
$Entities
0 1 1 0
4 0 0 0 0 1 0 1 7 0
1 0 0 0 2 1 0 1 8 1 4
$EndEntities
$Nodes
1 7 1 17
2 1 0 7
1
2
3
11
12
13
17
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1.2 0
9 9 0
$EndNodes
$Elements
2 3 1 3
1 4 1 1
1 1 11
2 1 3 2
2 1 2 12 11
3 2 3 13 12
$EndElements
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kTwoQuads;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::vector<InputProblem> problems_of(const std::string& text) {
  try {
    read_gmsh("part.msh", text);
  } catch (const InputError& e) {
    return e.problems;
  }
  return {};
}

TEST(Gmsh, ReadsCellsAndNamedInterfaces) {
  const SolidMesh mesh = read_gmsh("part.msh", kTwoQuads);
  EXPECT_EQ(mesh.dim, 2);
  EXPECT_EQ(mesh.node_count(), 6);  // without the unused one
  EXPECT_EQ(mesh.cell_count(), 2);
  EXPECT_NEAR(mesh.cell_size(0) + mesh.cell_size(1), 2.1, 1e-14);
  ASSERT_EQ(mesh.sets.size(), 1u);
  const auto& left = mesh.sets.at("left end");
  ASSERT_EQ(left.size(), 2u);
  for (int node : left) EXPECT_EQ(mesh.nodes(0, node), 0);
}

TEST(Gmsh, ReadsHexahedraWithNamedFaces) {
  const SolidMesh mesh = read_gmsh("cube.msh", R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 3 "base"
$EndPhysicalNames
$Entities
0 0 1 1
1 0 0 0 1 1 0 1 3 0
1 0 0 0 1 1 1 0 0
$EndEntities
$Nodes
1 8 1 8
3 1 0 8
1 2 3 4 5 6 7 8
0 0 0 1 0 0 1 1 0 0 1 0
0 0 1 1 0 1 1 1 1 0 1 1
$EndNodes
$Elements
2 2 1 2
2 1 3 1
1 1 2 3 4
3 1 5 1
2 1 2 3 4 5 6 7 8
$EndElements
)");
  EXPECT_EQ(mesh.dim, 3);
  EXPECT_NEAR(mesh.cell_size(0), 1, 1e-14);
  EXPECT_EQ(mesh.sets.at("base"), (std::vector<int>{0, 1, 2, 3}));
}

/// The corner of a cube; its nodes at edges are numbered by Gmsh.
std::string tetrahedra(int type, const std::string& nodes) {
  return R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 3 "base"
$EndPhysicalNames
$Entities
0 0 1 1
1 0 0 0 1 1 0 1 3 0
1 0 0 0 1 1 1 0 0
$EndEntities
$Nodes
1 10 1 10
3 1 0 10
1 2 3 4 5 6 7 8 9 10
0 0 0 1 0 0 0 1 0 0 0 1
0.5 0 0 0.5 0.5 0 0 0.5 0 0 0 0.5 0 0.5 0.5 0.5 0 0.5
$EndNodes
$Elements
2 2 1 2
2 1 )" + std::string(type == 4 ? "2 1\n1 1 2 3" : "9 1\n1 1 2 3 5 6 7") +
         "\n3 1 " + std::to_string(type) + " 1\n2 " + nodes + "\n$EndElements\n";
}

TEST(Gmsh, ReadsTetrahedraWithNodesAtTheirEdges) {
  for (const int type : {4, 11}) {
    const SolidMesh mesh =
        read_gmsh("corner.msh", tetrahedra(type, type == 4 ? "1 2 3 4" : "1 2 3 4 5 6 7 8 9 10"));
    EXPECT_EQ(mesh.kind().gmsh, type);
    EXPECT_NEAR(mesh.cell_size(0), 1.0 / 6, 1e-15);
    EXPECT_EQ(mesh.sets.at("base").size(), type == 4 ? 3u : 6u);
    for (const int node : mesh.sets.at("base")) EXPECT_EQ(mesh.nodes(2, node), 0);
    for (int n = 4; n < mesh.kind().nodes; ++n) {
      const auto& [a, b] = cell_edges(mesh.kind())[std::size_t(n - 4)];
      const Eigen::Matrix3Xd x = mesh.nodes_of(0);
      EXPECT_EQ(x.col(n), (x.col(a) + x.col(b)) / 2) << n;
    }
  }
}

TEST(Gmsh, InvertedTetrahedraAreNamedByTheirLine) {
  const auto problems = problems_of(tetrahedra(4, "2 1 3 4"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].line, 25);
  EXPECT_NE(problems[0].text().find("the cell is inverted or flat"), std::string::npos);
  EXPECT_NE(problems[0].text().find("the fourth corner"), std::string::npos);
}

/// A triangle with a node in the last quarter of its edge, a tetrahedron with two nodes at edges
/// exchanged: not the corners are wrong, which would be said.
TEST(Gmsh, CellsFoldedByNodesAtTheirEdgesAreToldFromInvertedOnes) {
  const std::string triangle = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 1 0
1 0 0 0 1 1 0 0 0
$EndEntities
$Nodes
1 6 11 16
2 1 0 6
11 12 13 14 15 16
0 0 0 1 0 0 0 1 0
0.8 0 0 0.5 0.5 0 0 0.5 0
$EndNodes
$Elements
1 1 1 1
2 1 9 1
1 11 12 13 14 15 16
$EndElements
)";
  const auto folded = [](const std::vector<InputProblem>& problems, const std::string& where) {
    EXPECT_EQ(problems.size(), 1u);
    const std::string said = problems.empty() ? "" : problems[0].text();
    EXPECT_NE(said.find("the cell is folded by its nodes at edges: node " + where),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("; expected nodes at edges in their middle"), std::string::npos) << said;
    EXPECT_NE(said.find("Mesh.SecondOrderLinear = 1"), std::string::npos) << said;
    EXPECT_EQ(said.find("corner"), std::string::npos) << said;
  };
  folded(problems_of(triangle), "14 is 0.3 of the edge between nodes 11 and 12 off its middle");
  folded(problems_of(tetrahedra(11, "1 2 3 4 6 5 7 8 9 10")),
         "6 is 0.5 of the edge between nodes 1 and 2 off its middle");
  const auto inverted = problems_of(tetrahedra(11, "2 1 3 4 5 7 6 9 8 10"));
  ASSERT_EQ(inverted.size(), 1u);
  EXPECT_NE(inverted[0].text().find("the fourth corner"), std::string::npos);
}

TEST(Gmsh, NodesThatAreNowhereAndNodesThereTwiceAreNamedByTheirLines) {
  const auto problems = problems_of(with("2 1.2 0\n9 9 0", "2 nan 0\n-inf 9 0"));
  ASSERT_EQ(problems.size(), 2u);   // all of them, and no cells that follow from them
  EXPECT_EQ(problems[0].line, 29);  // of its coordinates
  EXPECT_EQ(problems[1].line, 30);
  EXPECT_NE(problems[0].what.find("node 13 lies at (2, nan, 0)"), std::string::npos)
      << problems[0].what;
  const auto twice = problems_of(with("13\n17\n", "13\n13\n"));
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_EQ(twice[0].line, 30);
  EXPECT_NE(twice[0].what.find("node 13 is there twice"), std::string::npos) << twice[0].what;
}

TEST(Gmsh, CellThatIsThereTwiceIsNamedByItsLines) {
  // The same nodes from another corner on.
  const auto problems = problems_of(with("3 2 3 13 12", "3 2 12 11 1"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].line, 38);
  EXPECT_NE(problems[0].what.find("the nodes of the cell in line 37"), std::string::npos)
      << problems[0].what;
}

/// Neither is inverted, but the second lies over the first, whose side it has the same way round; a
/// third one at a side is over one of two.
TEST(Gmsh, FoldedCellsAreNamedByTheirLines) {
  std::string folded = with("2 0 0\n0 1 0\n1 1 0\n2 1.2 0", "0.2 0.1 0\n0 1 0\n1 1 0\n0.2 0.9 0");
  folded.replace(folded.find("3 2 3 13 12"), 11, "3 2 12 13 3");
  const auto problems = problems_of(folded);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].line, 38);
  EXPECT_NE(problems[0].what.find("overlaps that in line 37"), std::string::npos)
      << problems[0].what;
  EXPECT_NE(problems[0].hint, "");

  std::string third =
      with("2 3 1 3\n1 4 1 1\n1 1 11\n2 1 3 2", "2 4 1 4\n1 4 1 1\n1 1 11\n2 1 3 3");
  third.replace(third.find("3 2 3 13 12"), 11, "3 2 3 13 12\n4 2 3 17 12");
  const auto over = problems_of(third);
  ASSERT_EQ(over.size(), 1u);
  EXPECT_EQ(over[0].line, 39);
  EXPECT_NE(over[0].what.find("overlaps that in line 38"), std::string::npos) << over[0].what;
}

TEST(Gmsh, InvertedCellsAreNamedByTheirLines) {
  const auto problems = problems_of(with("2 1 2 12 11\n3 2 3 13 12", "2 1 11 12 2\n3 2 12 13 3"));
  ASSERT_EQ(problems.size(), 2u);  // all of them
  EXPECT_EQ(problems[0].line, 37);
  EXPECT_EQ(problems[1].line, 38);
  EXPECT_NE(problems[0].what.find("inverted"), std::string::npos);
}

TEST(Gmsh, EveryMistakeSaysWhereAndWhatWasExpected) {
  struct Case {
    std::string text, words;
    int line;
  };
  const std::vector<Case> cases = {
      {"", "empty", 1},
      {"hello", "not a Gmsh file", 1},
      {with("4.1 0 8", "2.2 0 8"), "format 2.2", 2},
      {with("4.1 0 8", "4.1 1 8"), "binary", 2},
      {with("2 1 3 2\n2 1 2 12 11\n3 2 3 13 12", "2 1 7 1\n2 1 2 12 11 3"), "1 5-node pyramids",
       36},
      {with("2 3 1 3\n1 4 1 1\n1 1 11\n2 1 3 2\n2 1 2 12 11\n",
            "3 3 1 3\n1 4 1 1\n1 1 11\n2 1 2 1\n2 1 2 11\n2 1 3 1\n"),
       "several kinds of cells: 4-node quadrilateral here, 3-node triangle in line 37", 39},
      {with("2 1 3 2", "2 1 99 2"), "type 99", 36},
      {with("3 2 3 13 12", "3 2 3 55 12"), "node 55 does not exist", 38},
      {with("2 1.2 0\n", "2 1.2 0.5\n"), "z = 0.5", 38},
      {with("2 1.2 0\n", "2 one 0\n"), "'one' is not a number", 29},
      {with("2 3 1 3\n", "2 3 1 3 3\n"), "", 0},
      {with("0 1 1 0\n", "0 -1 1 0\n"), "cannot be a count", 10},
  };
  for (const Case& c : cases) {
    const auto problems = problems_of(c.text);
    ASSERT_FALSE(problems.empty()) << c.words;
    EXPECT_NE(problems[0].text().find(c.words), std::string::npos) << problems[0].text();
    if (c.line > 0) {
      EXPECT_EQ(problems[0].line, c.line) << problems[0].text();
    }
    EXPECT_EQ(problems[0].file, "part.msh");
  }
}

/// A file cut anywhere is refused, and never read as something else.
TEST(Gmsh, AFileCutShortIsRefusedWhereverItIsCut) {
  const auto last = kTwoQuads.find("$EndElements");
  for (std::size_t n = 0; n < last; n += 3)
    EXPECT_THROW(read_gmsh("part.msh", kTwoQuads.substr(0, n)), InputError) << n;
}

}  // namespace
}  // namespace liesl::test::gmsh_mesh_test
