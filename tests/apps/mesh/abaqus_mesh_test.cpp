#include "apps/mesh/abaqus_mesh.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/input/problem.hpp"
#include "mbs/solids/meshes.hpp"

namespace liesl::test::abaqus_mesh_test {
namespace {

/// Two hexahedra on top of each other, as preprocessors write them: comments, a cell over two
/// lines, sets in three ways, a mass and a step that are passed over, a node without a cell.
const std::string kTower = R"(*HEADING
a tower
** its nodes
*NODE, NSET=Nall
1, 0, 0, 0
2, 1, 0, 0
3, 1., 1., 0.
4, 0, 1, 0
11, 0, 0, 1
12, 1, 0, 1
13, 1, 1, 1
14, 0, 1, 1
21, 0, 0, 2.5e0
22, 1, 0, 2.5
23, 1, 1, 2.5
24, 0, 1, 2.5
99, 7, 7, 7
*Element, type=C3D8I, elset=Eall
1, 1, 2, 3, 4, 11, 12, 13, 14
2, 11, 12, 13, 14, 21,
   22, 23, 24
*ELEMENT, TYPE=MASS, ELSET=M
3, 99
*NSET, NSET=Foot, GENERATE
1, 4, 1
*NSET, NSET=head
21, 22,
23, 24
*NSET, NSET=ends
FOOT, head
*MATERIAL, NAME=STEEL
*ELASTIC
210e9, 0.3
*STEP
*STATIC
*END STEP
)";

std::string tower_with(const std::string& from, const std::string& to) {
  std::string text = kTower;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::vector<InputProblem> problems_of_inp(const std::string& text) {
  try {
    read_abaqus("part.inp", text);
  } catch (const InputError& e) {
    return e.problems;
  }
  return {};
}

struct Case {
  std::string text, words;
  int line;
};

void expect_problems(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    const auto problems = problems_of_inp(c.text);
    ASSERT_FALSE(problems.empty()) << c.words;
    const bool found = std::any_of(problems.begin(), problems.end(), [&](const InputProblem& p) {
      return p.line == c.line && p.text().find(c.words) != std::string::npos;
    });
    EXPECT_TRUE(found) << c.words << ": " << problems[0].text();
    EXPECT_EQ(problems[0].file, "part.inp");
  }
}

TEST(AbaqusMesh, ReadsHexahedraAndNodeSets) {
  const SolidMesh mesh = read_abaqus("part.inp", kTower);
  EXPECT_EQ(mesh.dim, 3);
  EXPECT_EQ(mesh.node_count(), 12);  // without the unused one
  ASSERT_EQ(mesh.cell_count(), 2);
  EXPECT_NEAR(mesh.cell_size(0), 1, 1e-14);
  EXPECT_NEAR(mesh.cell_size(1), 1.5, 1e-14);
  for (const int node : mesh.sets.at("Foot")) EXPECT_EQ(mesh.nodes(2, node), 0);
  for (const int node : mesh.sets.at("head")) EXPECT_EQ(mesh.nodes(2, node), 2.5);
  EXPECT_EQ(mesh.sets.at("Foot").size(), 4u);
  EXPECT_EQ(mesh.sets.at("ends").size(), 8u);
  EXPECT_EQ(mesh.sets.at("Nall").size(), 12u);
}

TEST(AbaqusMesh, ReadsQuadrilaterals) {
  const SolidMesh mesh = read_abaqus("part.inp", R"(*NODE
1, 0, 0
2, 2, 0
3, 2, 1
4, 0, 1
*ELEMENT, TYPE=CPS4R
7, 1, 2, 3, 4
*NSET, NSET=left
1, 4
)");
  EXPECT_EQ(mesh.dim, 2);
  EXPECT_NEAR(mesh.cell_size(0), 2, 1e-14);
  EXPECT_EQ(mesh.sets.at("left"), (std::vector<int>{0, 3}));
}

/// Elements of order 2: a tetrahedron whose edge is bent, a hexahedron over two lines.
TEST(AbaqusMesh, ReadsNodesAtEdges) {
  const SolidMesh mesh = read_abaqus("part.inp", R"(*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 0, 1, 0
4, 0, 0, 1
5, 0.5, -0.05, 0
6, 0.5, 0.5, 0
7, 0, 0.5, 0
8, 0, 0, 0.5
9, 0.5, 0, 0.5
10, 0, 0.5, 0.5
*ELEMENT, TYPE=C3D10M
1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10
*NSET, NSET=base
1, 2, 3, 5, 6, 7
)");
  EXPECT_EQ(mesh.kind().abaqus, "C3D10");
  EXPECT_EQ(mesh.sets.at("base").size(), 6u);
  EXPECT_GT(mesh.cell_size(0), 1.0 / 6 + 1e-3);  // the edge bulges
  EXPECT_EQ(mesh.nodes_of(0).col(4), Eigen::Vector3d(0.5, -0.05, 0));

  const SolidMesh whole = in_cells(hex_grid({0, 0, 0}, {1, 1, 2}, 1, 1, 1), cell_kind(3, 20));
  std::string text = "*NODE\n";
  for (int i = 0; i < 20; ++i)
    text += fmt::format("{},{},{},{}\n", i + 1, whole.nodes(0, i), whole.nodes(1, i),
                        whole.nodes(2, i));
  text += "*ELEMENT, TYPE=C3D20R\n9";
  for (int i = 0; i < 20; ++i)
    text += fmt::format("{}{}", i == 15 ? ",\n" : ", ", whole.cells(i, 0) + 1);
  const SolidMesh read = read_abaqus("part.inp", text + "\n");
  EXPECT_EQ(read.kind().nodes, 20);
  EXPECT_EQ(read.nodes_of(0), whole.nodes_of(0));
}

TEST(AbaqusMesh, EveryMistakeSaysWhereAndWhatWasExpected) {
  const std::vector<Case> cases = {
      {"", "no cells", 1},
      {"nothing of the kind\n", "no cells", 1},
      {tower_with("type=C3D8I", "type=C3D15"), "elements of type 'C3D15'", 18},
      {tower_with("type=C3D8I", "type=C3D15"), "CPS3, CPS4, CPS6, CPS8, C3D4", 18},
      {tower_with("type=C3D8I", "type=C3D10"),
       "an element has 8 nodes; expected 10, as its TYPE=C3D10 says; hint: of 8 nodes are CPS8, "
       "C3D8",
       19},
      {tower_with("*ELEMENT, TYPE=MASS, ELSET=M\n3, 99", "*ELEMENT, TYPE=C3D4\n3, 1, 2, 4, 11"),
       "several kinds of cells: 4-node tetrahedron here, 8-node hexahedron in line 19", 23},
      {tower_with("*Element, type", "*ELGEN\n1, 2, 1, 1\n*Element, type"), "*ELGEN is not read",
       18},
      {tower_with("*Element, type", "*NGEN\n1, 4, 1\n*Element, type"), "*NGEN is not read", 18},
      {tower_with("*HEADING", "*SYSTEM\n0, 0, 1\n*HEADING"), "*SYSTEM is not read", 1},
      {tower_with("*Element, type", "*NCOPY, CHANGE NUMBER=100\n*Element, type"),
       "*NCOPY is not read", 18},
      {tower_with("*NODE, NSET", "*NODE, SYSTEM=C, NSET"), "SYSTEM of *NODE is not read", 4},
      {tower_with("*NSET, NSET=head", "*NSET, NSET=head, ELSET=Eall"), "ELSET of *NSET", 26},
      {tower_with("type=C3D8I", "type=CPS4"), "an element has 8 nodes", 19},
      {tower_with("1, 1, 2, 3, 4, 11", "1, 1, 4, 3, 2, 11"), "inverted or flat", 19},
      {tower_with("11, 12, 13, 14, 21,", "11, 12, 13, 14, 55,"), "node 55 does not exist", 20},
      {tower_with("   22, 23, 24", "   22, 23"), "an element has 7 nodes", 20},
      {tower_with("2, 1, 0, 0", "2, one, 0, 0"), "'one' is not a number", 6},
      {tower_with("2, 1, 0, 0", "2, nan, 0, 0"), "node 2 lies at (nan, 0, 0)", 6},
      {tower_with("14, 0, 1, 1", "13, 0, 1, 1"), "node 13 is there twice", 12},
      {tower_with("22,\n23, 24", "22,\n23, 77"), "node 77 of set 'head' does not exist", 28},
      {tower_with("FOOT, head", "FOOT, hed"), "there is no node set 'hed'", 30},
      {tower_with("1, 4, 1", "4, 1, 1"), "GENERATE", 25},
      {tower_with("1, 4, 1", "1, 99999999999999, 1"), "GENERATE", 25},
      {tower_with("NSET=head", "N"), "*NSET without a name", 26},
      {tower_with("*HEADING", "*INCLUDE, INPUT=a.inp"), "*INCLUDE is not read", 1},
  };
  expect_problems(cases);
}

/// Which set, what was expected, and what there is.
TEST(AbaqusMesh, MistakesOfSetsNameTheSetAndWhatThereIs) {
  const std::string last = "first, last, step: whole numbers, last from first on, step above 0";
  const auto foot = [](const std::string& line) { return tower_with("1, 4, 1", line); };
  const auto head = [](const std::string& line) {
    return tower_with("22,\n23, 24", "22,\n" + line);
  };
  expect_problems({
      {foot("4, 1, -1"), "GENERATE of set 'Foot' by '4, 1, -1' is not read; expected " + last, 25},
      {foot("1, 4, 1, 7"), "by '1, 4, 1, 7' is not read; expected " + last, 25},
      {foot("1,,1"), "by '1, , 1' is not read", 25},
      {foot("4, 1, 1"), "'4, 1, 1' generates nothing, or too much; expected " + last, 25},
      {foot("1, 4, 0"), "'1, 4, 0' generates nothing, or too much", 25},
      {foot("1000, 2000, 1"),
       "set 'Foot' by '1000, 2000, 1' meets no node; expected nodes of *NODE above this line; "
       "hint: "
       "those above are 1 to 99",
       25},
      {head("23, 77"),
       "node 77 of set 'head' does not exist; expected a node of *NODE above this line; hint: "
       "those "
       "above are 1 to 99",
       28},
      {head("23, -24"),
       "'-24' of set 'head' is no number of a node; expected a whole number, or the name of a set",
       28},
      {head("23,, 24"), "'' of set 'head' is no number of a node", 28},
      {tower_with("FOOT, head", "FOOT, hed"),
       "there is no node set 'hed', a part of set 'ends'; expected a set that stands above this "
       "line; hint: did you mean 'head'?",
       30},
      {tower_with("FOOT, head", "FOOT, Eall"), "hint: 'Eall' is a set of elements", 30},
      {tower_with("*NSET, NSET=ends\nFOOT", "*NSET, NSET=bare\n*NSET, NSET=ends\nbare"),
       "set 'bare', a part of set 'ends', has no nodes yet", 31},
      {tower_with("*NODE, NSET", "*NSET, NSET=early\n1, 2\n*NODE, NSET"),
       "node 1 of set 'early' does not exist; expected a node of *NODE above this line; hint: "
       "there "
       "is none above",
       5},
  });
  for (const char* line : {"4, 1, -1", "a, b", "1000, 2000"})  // not of 'ends', which names it
    EXPECT_EQ(problems_of_inp(foot(line)).size(), 1u) << line;
}

TEST(AbaqusMesh, SetsWithoutNodesAreThere) {
  const SolidMesh mesh = read_abaqus(
      "part.inp", tower_with("*MATERIAL", "*NSET, NSET=bare\n*NSET, NSET=mass\n99\n*MATERIAL"));
  EXPECT_TRUE(mesh.sets.at("bare").empty());
  EXPECT_TRUE(mesh.sets.at("mass").empty());
}

TEST(AbaqusMesh, AMessageIsWholeWhereTheFileHasANul) {
  const std::string cell = std::string("2") + '\0' + "4";
  const auto problems = problems_of_inp(tower_with("22,\n23, 24", "22,\n23, " + cell));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].text().find("'2\\x004' of set 'head' is no number of a node; expected"),
            std::string::npos)
      << problems[0].text();
}

TEST(AbaqusMesh, AWrongElementTypeIsOneProblem) {
  std::string text = tower_with("type=C3D8I", "type=C3D10");
  const auto block = text.find("2, 11, 12");
  for (int i = 3; i < 100; ++i) text.insert(block, fmt::format("{}, 1, 2, 3, 4, 11\n", i));
  EXPECT_EQ(problems_of_inp(text).size(), 1);
}

}  // namespace
}  // namespace liesl::test::abaqus_mesh_test
