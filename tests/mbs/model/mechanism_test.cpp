/// @file
/// Ports by text and their frames.

#include "mbs/model/mechanism.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace liesl::test::mechanism_test {
namespace {

SE3 turned(const Vec3& w, const Vec3& x) {
  SE3::Tangent h = SE3::Tangent::Zero();
  h.tail<3>() = w;
  return {SE3::exp(h).R, x};
}

Mechanism scene() {
  BeamSpec even, odd;
  for (int i = 0; i <= 4; ++i) even.nodes.push_back(turned({0.1 * i, 0.2, 0}, {0.25 * i, 0, 1}));
  for (int i = 0; i <= 3; ++i) odd.nodes.push_back(turned({0, 0, 0}, {0, 0.1 * i, 0}));
  RigidSpec top;
  top.frame = turned({0.3, -0.4, 1.2}, {1, 2, 3});
  top.points = {{"tip", {4, 5, 6}}, {"pin", {1, 2, 3}}};
  Mechanism m;
  m.bodies = {{"rod", even}, {"crank", odd}, {"top", top}, {"arm.left", top}};
  return m;
}

TEST(Mechanism, BodiesByName) {
  const auto m = scene();
  EXPECT_EQ(m.body("rod"), 0);
  EXPECT_EQ(m.body("top"), 2);
  EXPECT_EQ(m.body("ro"), -1);
  EXPECT_EQ(m.body(""), -1);
}

TEST(Mechanism, PortsOfBeams) {
  const auto m = scene();
  EXPECT_EQ(m.port("rod.start")->node, 0);
  EXPECT_EQ(m.port("rod.end")->node, 4);
  EXPECT_EQ(m.port("rod.mid")->node, 2);
  EXPECT_EQ(m.port("rod.node3")->node, 3);
  EXPECT_EQ(m.port("crank.end")->body, 1);
  EXPECT_EQ(m.port("crank.end")->node, 3);
  const auto& nodes = std::get<BeamSpec>(m.bodies[0].kind).nodes;
  const SE3 H = m.frame(*m.port("rod.node3"));
  EXPECT_EQ(H.R, nodes[3].R);
  EXPECT_EQ(H.x, nodes[3].x);
}

TEST(Mechanism, NamedPointHasTheOrientationOfItsBody) {
  const auto m = scene();
  const auto& frame = std::get<RigidSpec>(m.bodies[2].kind).frame;
  const auto tip = m.port("top.tip");
  ASSERT_TRUE(tip);
  EXPECT_TRUE(m.frame(*tip).x.isApprox(Vec3(4, 5, 6), 1e-15));
  EXPECT_TRUE(m.frame(*tip).R.isApprox(frame.R, 1e-15));
  EXPECT_FALSE(tip->offset.x.isApprox(Vec3(3, 3, 3), 1e-3));  // local, the body is turned
  EXPECT_NEAR(tip->offset.x.norm(), Vec3(3, 3, 3).norm(), 1e-14);
  EXPECT_EQ(m.frame(*m.port("top.origin")).x, frame.x);
  EXPECT_EQ(m.frame(*m.port("top.origin")).R, frame.R);
}

TEST(Mechanism, GroundIsItsOffset) {
  const auto m = scene();
  auto ground = m.port("ground");
  ASSERT_TRUE(ground);
  EXPECT_EQ(ground->body, -1);
  EXPECT_EQ(m.frame(*ground).x, Vec3(0, 0, 0));
  ground->offset.x = {7, 8, 9};
  EXPECT_EQ(m.frame(*ground).x, Vec3(7, 8, 9));
}

TEST(Mechanism, DotsInBodyNames) { EXPECT_EQ(scene().port("arm.left.tip")->body, 3); }

TEST(Mechanism, UnknownPortsAreEmpty) {
  const auto m = scene();
  for (const char* text : {"", "rod", "rod.", ".start", "rod.middle", "rod.node", "rod.node5",
                           "rod.node-1", "rod.node03", "rod.node3x", "crank.mid", "top.start",
                           "top.nose", "rod.origin", "gear.start", "ground.start", "Rod.start"})
    EXPECT_FALSE(m.port(text)) << text;
  Mechanism empty;
  empty.bodies = {{"rod", BeamSpec{}}};
  EXPECT_FALSE(empty.port("rod.start"));
  EXPECT_TRUE(empty.port_names(0).empty());
}

TEST(Mechanism, EveryListedNameIsAPort) {
  const auto m = scene();
  for (int body = -1; body < int(m.bodies.size()); ++body)
    for (const auto& name : m.port_names(body)) {
      ASSERT_TRUE(m.port(name)) << name;
      EXPECT_EQ(m.port(name)->body, body) << name;
    }
  const auto rod = m.port_names(0), crank = m.port_names(1);
  EXPECT_EQ(rod.size(), 8u);  // start, end, mid, node0..4
  EXPECT_EQ(std::count(rod.begin(), rod.end(), "rod.mid"), 1);
  EXPECT_EQ(std::count(crank.begin(), crank.end(), "crank.mid"), 0);
  EXPECT_EQ(m.port_names(2), (std::vector<std::string>{"top.origin", "top.pin", "top.tip"}));
}

TEST(Mechanism, RefusesPortsThatCannotBe) {
  const auto m = scene();
  EXPECT_THROW(m.frame({.body = 9}), std::invalid_argument);
  EXPECT_THROW(m.frame({.body = -2}), std::invalid_argument);
  EXPECT_THROW(m.frame({.body = 0, .node = 5}), std::invalid_argument);
  EXPECT_THROW(m.port_names(4), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::mechanism_test
