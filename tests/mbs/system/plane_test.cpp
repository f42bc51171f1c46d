/// @file
/// Which scenes are planar, why others are not, and the map between plane and space.

#include "mbs/system/plane.hpp"

#include <functional>

#include "mbs/run.hpp"
#include "mbs/sections/section_law.hpp"

namespace liesl::test::plane_test {
namespace {

using Change = std::function<void(Mechanism&)>;

struct Case {
  Change change;
  std::string reason;  ///< part of it; empty: planar
};

RigidSpec& slider(Mechanism& m) { return std::get<RigidSpec>(m.bodies[2].kind); }
Mechanism changed(const Change& change) {
  auto m = test::slider_crank();
  slider(m).centre = {0, 0.01, 0};  // the other points are on a line
  change(m);
  return m;
}
BeamSpec& rod(Mechanism& m) { return std::get<BeamSpec>(m.bodies[1].kind); }
LoadSpec load(const Vec3& force, const Vec3& moment, bool follower = false) {
  LoadSpec l;
  l.name = "push";
  l.port = {1, 4};
  l.force = force;
  l.moment = moment;
  l.follower = follower;
  return l;
}
ForceSpec spring(int joint, int coordinate) {
  ForceSpec f;
  f.name = "spring";
  f.joint = joint;
  f.coordinate = coordinate;
  f.stiffness = 1;
  return f;
}
void turn_section(Mechanism& m, double angle) {
  for (auto& s : rod(m).sections) s.shape = Rectangle{0.01, 0.02};
  for (auto& H : rod(m).nodes)
    H.R = H.R * Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix();
}

std::vector<Case> cases() {
  return {
      {[](Mechanism&) {}, ""},
      {[](Mechanism& m) {
         m.gravity = {0, -9.81, 0};
       },
       ""},
      {[](Mechanism& m) {
         m.gravity = {0, 0, -9.81};
       },
       "gravity leaves the plane"},
      {[](Mechanism& m) { m.joints[1].axis = Vec3(0.1, 0, 1).normalized(); },
       "the axis of joint 'pin' is neither in the plane nor normal to it"},
      {[](Mechanism& m) { m.joints[2].type = JointType::Spherical; }, ""},
      {[](Mechanism& m) {
         slider(m).centre = {0, 0.01, 0.01};
       },
       "the axis of joint 'motor'"},
      {[](Mechanism& m) {
         slider(m).centre = {0.01, 0.02, 0};
       },
       ""},
      {[](Mechanism& m) { slider(m).inertia(0, 2) = slider(m).inertia(2, 0) = 2e-5; },
       "'slider' has no principal axis of inertia normal to the plane"},
      {[](Mechanism& m) { slider(m).inertia(0, 1) = slider(m).inertia(1, 0) = 2e-5; }, ""},
      {[](Mechanism& m) {
         m.bodies[2].velocity = {0, 0, 1};
       },
       "the initial velocity of 'slider' leaves the plane"},
      {[](Mechanism& m) {
         m.bodies[0].angular_velocity = {0, 0, 5};
       },
       ""},
      {[](Mechanism& m) {
         m.bodies[0].angular_velocity = {0, 5, 0};
       },
       "the initial velocity of 'crank' leaves the plane"},
      {[](Mechanism& m) {
         m.loads = {load({1, 2, 0}, {0, 0, 3})};
       },
       ""},
      {[](Mechanism& m) {
         m.loads = {load({1, 0, 2}, {0, 0, 3})};
       },
       "load 'push' leaves the plane"},
      {[](Mechanism& m) {
         m.loads = {load({1, 2, 0}, {1, 0, 3})};
       },
       "load 'push'"},
      {[](Mechanism& m) {
         m.loads = {load({1, 2, 0}, {0, 0, 3}, true)};
       },
       ""},
      {[](Mechanism& m) {
         m.loads = {load({1, 2, 1}, {0, 0, 3}, true)};
       },
       "load 'push' leaves the plane"},
      {[](Mechanism& m) { m.forces = {spring(1, 0)}; }, ""},
      {[](Mechanism& m) {
         m.joints[1].type = JointType::Cylindrical;
         m.forces = {spring(1, 1)};
       },
       ""},
      {[](Mechanism& m) {
         m.joints[1].type = JointType::Cylindrical;
         m.forces = {spring(1, 0)};
       },
       "force 'spring' acts out of the plane"},
      {[](Mechanism& m) {
         m.joints[3].type = JointType::Cylindrical;
         m.drives.push_back({3, 1, TimeFunction::constant(0)});
       },
       "joint 'guide' is driven out of the plane"},
      {[](Mechanism& m) { turn_section(m, M_PI / 2); }, ""},
      {[](Mechanism& m) { turn_section(m, 0.3); },
       "a section of 'rod' has no principal axis normal to the plane"},
      {[](Mechanism& m) { rod(m).nodes[4].x.z() += 1e-3; }, "point"},
  };
}

TEST(FindPlane, SaysYesOrWhyNot) {
  int i = 0;
  for (const auto& c : cases()) {
    for (const bool tilted : {false, true}) {
      auto m = changed(c.change);
      if (tilted) m = test::moved(m, test::oblique());
      const auto found = find_plane(m);
      EXPECT_EQ(found.plane.has_value(), c.reason.empty()) << i << ": " << found.reason;
      EXPECT_FALSE(found.reason.empty());
      if (!c.reason.empty()) {
        EXPECT_NE(found.reason.find(c.reason), std::string::npos) << i << ": " << found.reason;
      }
      if (found.plane && !tilted) {
        EXPECT_LT((found.plane->frame.R - Mat3::Identity()).norm(), 1e-12) << i;
      }
    }
    ++i;
  }
}

TEST(FindPlane, OtherScenes) {
  EXPECT_TRUE(find_plane(test::pendulum(4)).plane);
  EXPECT_TRUE(find_plane(test::spin_up(4)).plane);
  EXPECT_TRUE(find_plane(test::four_bar(4)).plane);
  EXPECT_FALSE(find_plane(test::heavy_top()).plane);
  EXPECT_FALSE(find_plane(test::flying_beam(4)).plane);
  EXPECT_FALSE(find_plane(Mechanism()).plane);
  EXPECT_EQ(find_plane(Mechanism()).reason, "there are no bodies");
  auto m = test::four_bar(4);
  m.gravity = {0, -9.81, 1e-3};
  EXPECT_EQ(find_plane(m).reason, "gravity leaves the plane");
}

/// It turns the body out of the plane, along which it acts; a moment is the same everywhere.
TEST(FindPlane, AForceOffThePlaneLeavesIt) {
  auto m = test::pendulum(4);
  LoadSpec load;
  load.port = {0, 4, SE3(Mat3::Identity(), {0, 0, 0.1})};
  load.moment = {0, 0, 1};
  m.loads = {load};
  EXPECT_TRUE(find_plane(m).plane) << find_plane(m).reason;
  m.loads[0].force = {0, 3, 0};
  EXPECT_FALSE(find_plane(m).plane);
  m.loads[0].port.offset.x = {0, 0.1, 0};
  EXPECT_TRUE(find_plane(m).plane) << find_plane(m).reason;
}

TEST(Space, ReduceAndEmbedAreInverse) {
  test::Random random(9);
  Space<SE2> plane;
  plane.frame = test::oblique();
  for (int i = 0; i < 20; ++i) {
    const SE2 h = SE2::exp(SE2::Tangent(3 * random.vector(3)));
    // own axes turned about the in-plane x axis by any angle
    SE3 own = SE3::identity();
    own.R = Eigen::AngleAxisd(3 * random(), Vec3::UnitX()).toRotationMatrix();
    const SE3 H = plane.embed(h, own);
    const SE3 align = plane.alignment(H);
    const SE2 back = plane.reduce(H, align);
    EXPECT_LT(SE3::log(plane.embed(back, align).inverse() * H).norm(), 1e-13);
    EXPECT_LT((back.x - h.x).norm(), 1e-13);
    const SE2::Tangent v = random.vector(3);
    EXPECT_LT((plane.reduce_local(plane.embed_local(v, align), align) - v).norm(), 1e-14);
    // velocities: the embedded motion has the embedded velocity
    const SE3 moved = plane.embed(back * SE2::exp(1e-6 * v), align);
    const SE3::Tangent rate = SE3::log(H.inverse() * moved) / 1e-6;
    EXPECT_LT((rate - plane.embed_local(v, align)).norm(), 1e-5);
  }
}

TEST(Space, TurnedSectionsBendAboutTheRightAxis) {
  // Rectangle 10 mm wide (y), 20 mm high (z): turned by 90 degrees y is normal to the plane.
  for (const double angle : {0.0, M_PI / 2, -M_PI / 2, M_PI}) {
    auto m = changed([angle](Mechanism& scene) { turn_section(scene, angle); });
    const auto found = find_plane(m);
    ASSERT_TRUE(found.plane) << found.reason;
    const SE3& H = rod(m).nodes[0];
    const auto law = section_law(rod(m).sections[0], rod(m).material);
    const auto K = found.plane->reduce_law(law.K, found.plane->alignment(H));
    const bool upright = std::abs(std::sin(angle)) < 0.5;
    EXPECT_NEAR(K(2, 2), upright ? law.K(5, 5) : law.K(4, 4), 1e-9 * K(2, 2));
    EXPECT_NEAR(K(1, 1), upright ? law.K(1, 1) : law.K(2, 2), 1e-9 * K(1, 1));
    EXPECT_NEAR(K(0, 0), law.K(0, 0), 1e-9 * K(0, 0));
  }
}

}  // namespace
}  // namespace liesl::test::plane_test
