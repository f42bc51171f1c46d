/// @file
/// Beams as CalculiX meshes them: pieces at jumps of outlines, which fill each element.
#include "apps/export/beam_mesh.hpp"

#include <gtest/gtest.h>

namespace liesl::test::beam_mesh_test {
namespace {

constexpr double kLength = 0.05;  // of an element, m

/// Elements along x, of these sections.
BeamDeck beam(const std::vector<Shape>& shapes) {
  BeamDeck deck;
  for (std::size_t e = 0; e < shapes.size(); ++e)
    deck.sections.push_back({"s" + std::to_string(e), shapes[e]});
  for (std::size_t k = 0; k <= shapes.size(); ++k)
    deck.nodes.emplace_back(Mat3::Identity(), Vec3(kLength * static_cast<double>(k), 0, 0));
  for (std::size_t e = 0; e < shapes.size(); ++e)
    deck.middles.emplace_back(Mat3::Identity(),
                              Vec3(kLength * (static_cast<double>(e) + 0.5), 0, 0));
  deck.cases.resize(1);
  deck.cases[0].force.assign(deck.nodes.size(), Vec3::Zero());
  deck.cases[0].moment = deck.cases[0].force;
  return deck;
}

/// From the first node of the beam to the last, each node once, with middles in the middle.
void expect_chain(const BeamMesh& mesh) {
  int at = 1;
  std::size_t used = 1;
  for (std::size_t e = 0; e < mesh.pieces.size(); ++e) {
    double length = 0;
    for (const int number : mesh.pieces[e]) {
      const auto [first, middle, last] = mesh.elements.at(number);
      EXPECT_EQ(first, at);
      const Vec3 &a = mesh.nodes.at(first).x, &b = mesh.nodes.at(last).x;
      EXPECT_LE((mesh.nodes.at(middle).x - 0.5 * (a + b)).norm(), 1e-15);
      EXPECT_GT(b[0], a[0]);
      length += b[0] - a[0];
      at = last;
      used += 2;
    }
    EXPECT_EQ(at, static_cast<int>(2 * e + 3)) << "nodes of the beam keep their numbers";
    EXPECT_NEAR(length, kLength, 1e-15);
  }
  EXPECT_EQ(mesh.nodes.size(), used);
}

TEST(BeamMesh, ElementsOfOneOutlineAreWhole) {
  for (const Shape& wall : {Shape(Tube{0.01, 0.001}), Shape(Tube{0.01, 0.002})}) {
    const BeamMesh mesh = beam_mesh(beam({Tube{0.01, 0.001}, wall, Tube{0.01, 0.001}}));
    expect_chain(mesh);
    EXPECT_EQ(mesh.elements.size(), 3u);
    EXPECT_FALSE(mesh.by_node || mesh.knots);
  }
}

TEST(BeamMesh, BarsPassFromOneOutlineToTheNextWithoutAKnot) {
  const BeamDeck deck = beam({Circle{0.01}, Rectangle{0.02, 0.03}, Rectangle{0.02, 0.03}});
  const BeamMesh mesh = beam_mesh(deck);
  expect_chain(mesh);
  EXPECT_TRUE(mesh.by_node);
  EXPECT_FALSE(mesh.knots);
  ASSERT_EQ(mesh.pieces, (std::vector<std::vector<int>>{{1, 4}, {5, 2}, {3}}));
  const auto outline = [&](int node) { return mesh.nodes.at(node).outline; };
  EXPECT_EQ(outline(1), (Outline{0.01, 0.01}));
  EXPECT_EQ(outline(3), (Outline{0.015, 0.02})) << "the mean where they meet";
  EXPECT_EQ(outline(7), (Outline{0.02, 0.03}));
  for (const int number : {1, 2}) {  // the longest piece has its own outline all along
    const Outline own = outline(2 * number);
    EXPECT_EQ(own, number == 1 ? (Outline{0.01, 0.01}) : (Outline{0.02, 0.03}));
    const auto& nodes = mesh.elements.at(number);
    EXPECT_EQ(outline(nodes[0]), own);
    EXPECT_EQ(outline(nodes[2]), own);
  }
  EXPECT_NEAR(mesh.nodes.at(mesh.elements.at(4)[0]).x[0], kLength - 0.001, 1e-15)
      << "a tenth of the smaller outline before the node";
}

/// However short: pieces do not overlap.
TEST(BeamMesh, ElementsShorterThanTheirOutlineAreCutAtQuarters) {
  const BeamMesh mesh = beam_mesh(beam({Circle{1.0}, Circle{2.0}, Circle{1.0}}));
  expect_chain(mesh);
  EXPECT_EQ(mesh.pieces[1].size(), 3u);
  EXPECT_NEAR(mesh.nodes.at(mesh.elements.at(2)[0]).x[0], 1.25 * kLength, 1e-15);
  expect_chain(beam_mesh(beam({Tube{1.0, 0.1}, Tube{2.0, 0.1}, Tube{1.0, 0.1}})));
}

TEST(BeamMesh, TubesKeepTheirKnotsBetweenPiecesThatGrow) {
  const BeamMesh mesh = beam_mesh(beam({Circle{0.01}, Tube{0.012, 0.001}, Tube{0.012, 0.001}}));
  expect_chain(mesh);
  EXPECT_TRUE(mesh.knots);
  EXPECT_FALSE(mesh.by_node);
  double before = 0;
  for (const int number : mesh.pieces[1]) {
    const auto& nodes = mesh.elements.at(number);
    const double length = mesh.nodes.at(nodes[2]).x[0] - mesh.nodes.at(nodes[0]).x[0];
    EXPECT_GT(length, 1.9 * before);
    before = length;
  }
  EXPECT_GE(mesh.pieces[1].size(), 3u);
  EXPECT_EQ(mesh.pieces[2].size(), 1u);
}

/// CalculiX joins unlike kinds by its knot, whatever their outline.
TEST(BeamMesh, OtherKindsOfOneOutlineJump) {
  const BeamMesh bars = beam_mesh(beam({Circle{0.01}, Rectangle{0.01, 0.01}, Circle{0.01}})),
                 tubes = beam_mesh(beam({Circle{0.01}, Tube{0.01, 0.001}, Circle{0.01}})),
                 walls = beam_mesh(beam({Tube{0.01, 0.002}, Tube{0.01, 0.001}}));
  EXPECT_TRUE(bars.by_node);
  EXPECT_EQ(bars.pieces[1].size(), 3u);
  EXPECT_TRUE(tubes.knots);
  EXPECT_GT(tubes.pieces[1].size(), 3u);
  EXPECT_FALSE(walls.knots || walls.by_node);
}

TEST(BeamMesh, OfADeckTheTextHasOutlinesOfBarsAtTheirNodes) {
  const std::string one = calculix_text(beam({Circle{0.01}, Circle{0.01}})),
                    bars = calculix_text(beam({Circle{0.01}, Circle{0.02}, Tube{0.02, 0.001}}));
  EXPECT_EQ(one.find("THICKNESS"), std::string::npos);
  EXPECT_NE(bars.find("SECTION=CIRC, NODAL THICKNESS\n"), std::string::npos) << bars;
  EXPECT_NE(bars.find("SECTION=PIPE\n"), std::string::npos) << bars;
  EXPECT_NE(bars.find("*NODAL THICKNESS\n1, 1.000000000000e-02, 1.000000000000e-02\n"),
            std::string::npos)
      << bars;
  const std::string nodes = bars.substr(bars.find("*NODAL THICKNESS"));
  EXPECT_EQ(nodes.find("\n7, 2.0"), std::string::npos) << "of the tube alone";
  EXPECT_NE(bars.find("*ELSET, ELSET=SECTION2\n5,\n2,\n"), std::string::npos) << bars;
}

}  // namespace
}  // namespace liesl::test::beam_mesh_test
