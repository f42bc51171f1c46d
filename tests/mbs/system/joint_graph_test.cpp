/// @file
/// Closed loops of bodies and joints, and the flexible bodies that a joint is set against.

#include "mbs/system/joint_graph.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace liesl::test::joint_graph_test {
namespace {

using Ends = JointGraph::Ends;
using Bodies = std::vector<int>;
using Flexible = std::vector<bool>;

/// Sets of joints that are one loop, without bridges.
std::set<std::set<int>> loops(const JointGraph& graph) {
  std::map<int, std::set<int>> by_loop;
  for (std::size_t j = 0; j < graph.loops().size(); ++j)
    if (graph.loops()[j] >= 0) by_loop[graph.loops()[j]].insert(static_cast<int>(j));
  std::set<std::set<int>> found;
  for (const auto& [loop, joints] : by_loop) found.insert(joints);
  return found;
}

using Sets = std::set<std::set<int>>;

/// Crank 0, rod 1 and slider 2, with a flag 3 on the slider.
TEST(JointGraph, WhatHangsOnALoopIsNotPartOfIt) {
  const JointGraph graph(4, {{-1, 0}, {0, 1}, {1, 2}, {-1, 2}, {2, 3}});
  EXPECT_EQ(loops(graph), (Sets{{0, 1, 2, 3}}));
  const Flexible flexible{true, true, false, true};
  for (const Ends& ends : {Ends{-1, 0}, Ends{0, 1}, Ends{1, 2}, Ends{-1, 2}, Ends{2, -1}})
    EXPECT_EQ(graph.beside(ends, flexible), (Bodies{0, 1})) << ends[0] << ' ' << ends[1];
  EXPECT_EQ(graph.beside({2, 3}, flexible), Bodies{3});
  EXPECT_EQ(graph.beside({2, 3}, {true, true, true, false}), Bodies{2});
  EXPECT_EQ(graph.beside({2, 3}, {true, true, false, false}), Bodies{1}) << "the nearest";
  EXPECT_EQ(graph.beside({0, 1}, {false, false, false, true}), Bodies{3}) << "a rigid loop";
}

TEST(JointGraph, LoopsThatShareOneBodyAreTwo) {
  const JointGraph graph(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}});
  EXPECT_EQ(loops(graph), (Sets{{0, 1, 2}, {3, 4, 5}}));
  const Flexible all(5, true);
  EXPECT_EQ(graph.beside({0, 1}, all), (Bodies{0, 1, 2}));
  EXPECT_EQ(graph.beside({3, 4}, all), (Bodies{2, 3, 4}));
}

/// A four-bar with a further link from the middle of its rod to the ground is one, and so are loops
/// whose tree ways meet on the way up alone.
TEST(JointGraph, LoopsThatShareAJointAreOne) {
  const JointGraph four_bar(4, {{-1, 0}, {0, 1}, {1, 2}, {2, -1}, {1, 3}, {3, -1}});
  EXPECT_EQ(loops(four_bar), (Sets{{0, 1, 2, 3, 4, 5}}));
  const JointGraph ladder(6, {{0, 1}, {2, 3}, {4, 5}, {0, 2}, {1, 3}, {2, 4}, {3, 5}});
  EXPECT_EQ(loops(ladder), (Sets{{0, 1, 2, 3, 4, 5, 6}}));
}

TEST(JointGraph, AChainHasNoLoopAndItsNearestBodies) {
  const JointGraph chain(4, {{-1, 0}, {0, 1}, {1, 2}, {2, 3}});
  EXPECT_EQ(loops(chain), Sets{});
  const Flexible all(4, true), tool{false, false, false, true};
  EXPECT_EQ(chain.beside({-1, 0}, all), Bodies{0});
  EXPECT_EQ(chain.beside({0, 1}, all), (Bodies{0, 1}));
  EXPECT_EQ(chain.beside({-1, 0}, tool), Bodies{3});
  EXPECT_EQ(chain.beside({0, 1}, {true, false, true, true}), Bodies{0});
  EXPECT_EQ(chain.beside({0, 1}, Flexible(4, false)), Bodies{});
}

/// The ground is one vertex: mechanisms on it are apart, ways through it close loops only.
TEST(JointGraph, TheGroundPartsMechanisms) {
  const JointGraph graph(5, {{-1, 0}, {0, 1}, {1, -1}, {-1, 2}, {2, 3}, {3, -1}, {-1, 4}});
  EXPECT_EQ(loops(graph), (Sets{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(graph.beside({0, 1}, Flexible(5, true)), (Bodies{0, 1}));
  EXPECT_EQ(graph.beside({-1, 4}, Flexible(5, true)), Bodies{4});
  EXPECT_EQ(graph.beside({-1, 4}, {true, true, true, true, false}), Bodies{});
}

/// Two hinges of a door, and a body held on to itself.
TEST(JointGraph, JointsBetweenTheSameBodiesAreALoop) {
  const JointGraph graph(3, {{-1, 0}, {0, -1}, {0, 1}, {1, 1}, {1, 2}});
  EXPECT_EQ(loops(graph), (Sets{{0, 1}, {3}}));
  EXPECT_EQ(graph.beside({1, 1}, Flexible(3, true)), Bodies{1});
}

}  // namespace
}  // namespace liesl::test::joint_graph_test
