/// @file
/// Consistent start: assembly, velocities, accelerations; constraints that repeat or contradict.

#include "mbs/solvers/initial_state.hpp"

#include "mbs/bodies/beam.hpp"
#include "mbs/run.hpp"
#include "mbs/system/constraint_rank.hpp"

namespace liesl::test::initial_state_test {
namespace {

using test::options;

/// Beams replaced by rigid links of the same ends: r = 0.15, l = 0.45 m.
Mechanism rigid_slider_crank(double rate, double ramp) {
  auto m = test::slider_crank();
  RigidSpec crank = test::block({0, 0, 0}, 0.5, 1e-3), rod = test::block({0.15, 0, 0}, 0.3, 2e-3);
  crank.centre = {0.075, 0, 0};
  rod.centre = {0.15, 0, 0};
  const Port crank_end{0, 0, SE3(Mat3::Identity(), {0.15, 0, 0})};
  const Port rod_end{1, 0, SE3(Mat3::Identity(), {0.3, 0, 0})};
  m.bodies[0].kind = crank;
  m.bodies[1].kind = rod;
  m.joints[1] = {"pin", JointType::Revolute, crank_end, {1, 0}};
  m.joints[2] = {"wrist", JointType::Revolute, rod_end, {2, 0}};
  m.drives = {{0, 0, TimeFunction::rate(rate, ramp)}};
  return m;
}

TEST(InitialState, OpenJointsAreAssembled) {
  auto m = test::slider_crank();
  std::get<RigidSpec>(m.bodies[2].kind).frame.x += Vec3(2e-4, 0, 0);
  auto& rod = std::get<BeamSpec>(m.bodies[1].kind);
  for (auto& H : rod.nodes) H.x += Vec3(-1e-4, 1e-4, 0);
  auto model = Model<SE3>::build(m, {});
  State<SE3> s = model.initial_state();
  const auto start = make_consistent(model, options(0.12, 1e-4), s);
  ASSERT_EQ(start.status, SolveStatus::Converged) << start.reason;
  EXPECT_GT(start.moved, 1e-5);
  EXPECT_LT(start.moved, 5e-4);
  Equations<SE3> eq(model);
  eq.evaluate(s, s.rows, {0, 1});
  EXPECT_LT(eq.constraint_residual(), 1e-12);
}

TEST(InitialState, ClosedScenesAreNotMoved) {
  for (const auto& m : {test::slider_crank(), test::pendulum(8), test::four_bar(4)}) {
    auto model = Model<SE3>::build(m, {});
    State<SE3> s = model.initial_state();
    const auto start = make_consistent(model, options(1, 1e-3), s);
    EXPECT_EQ(start.status, SolveStatus::Converged) << start.reason;
    EXPECT_LT(start.moved, 1e-14);
    EXPECT_LT(start.velocity_change, 1e-14);
  }
}

TEST(InitialState, VelocitiesAreThoseOfRigidLinks) {
  test::SliderCrank p;
  p.ramp = 0;
  auto model = Model<SE3>::build(test::slider_crank(p), {});
  State<SE3> s = model.initial_state();
  const auto start = make_consistent(model, options(0.12, 1e-4), s);
  ASSERT_EQ(start.status, SolveStatus::Converged) << start.reason;
  EXPECT_NEAR(start.velocity_change, 150 * 0.15, 1e-3 * 150 * 0.15);
  for (int b = 0; b < 2; ++b) {
    const double omega = b == 0 ? 150 : -75;  // r Omega/l at the dead point
    for (int k = 0; k < 9; ++k) {
      const auto v = s.v.segment<6>(6 * (9 * b + k));
      EXPECT_NEAR(v[5], omega, 1e-3 * 150);
      EXPECT_NEAR(v[1], 22.5 * (b == 0 ? k / 8.0 : 1 - k / 8.0), 1e-3 * 22.5);
    }
    const auto& beam = dynamic_cast<const Beam<SE3>&>(*model.bodies[std::size_t(b)]);
    for (int e = 0; e < beam.elements(); ++e) {
      const auto rate =
          (BeamElement<SE3>::P(beam.element(e).d0()) * s.v.segment<12>(6 * (9 * b + e))).eval();
      EXPECT_LT(rate.norm(), 1e-3 * 150 / 8) << b << " " << e;
    }
  }
}

TEST(InitialState, AccelerationsOfRigidLinks) {
  const double r = 0.15, l = 0.3, W = 150;
  auto model = Model<SE2>::build(rigid_slider_crank(W, 0), {});
  State<SE2> s = model.initial_state();
  const auto start = make_consistent(model, options(0.12, 1e-4), s);
  ASSERT_EQ(start.status, SolveStatus::Converged) << start.reason;
  const double slider = -r * W * W * (1 + r / l);
  EXPECT_NEAR(s.vdot[6], slider, 1e-9 * std::abs(slider));
  // At the dead point the rod's frame accelerates by -r W^2 along x; vdot = R' a - w x u.
  const double w = -r / l * W;
  EXPECT_NEAR(s.vdot[3], -r * W * W + w * r * W, 1e-9 * r * W * W);
  EXPECT_NEAR(s.v[5], w, 1e-10 * W);
  const auto wrist = test::joint_wrench(model, s.H.data(), s.lambda, 2);
  EXPECT_NEAR(wrist[0], 0.2 * slider, 1e-9 * 0.2 * std::abs(slider));
  const auto pin = test::joint_wrench(model, s.H.data(), s.lambda, 1);
  const double rod = 0.3 * (-r * W * W - 0.15 * w * w);  // centre of mass half way
  EXPECT_NEAR(pin[0], 0.2 * slider + rod, 1e-9 * std::abs(pin[0]));
}

TEST(InitialState, AccelerationOfAPhysicalPendulum) {
  RigidSpec body = test::block({0, 0, 0}, 3, 0.05);
  body.centre = {0.4, 0, 0};
  Mechanism m;
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"arm", body}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  auto model = Model<SE3>::build(m, {});
  State<SE3> s = model.initial_state();
  ASSERT_EQ(make_consistent(model, options(1, 1e-3), s).status, SolveStatus::Converged);
  const double inertia = 0.05 + 3 * 0.16, alpha = -3 * 9.81 * 0.4 / inertia;
  EXPECT_NEAR(s.vdot[5], alpha, 1e-11);
  const auto force = test::joint_wrench(model, s.H.data(), s.lambda, 0);
  EXPECT_NEAR(force[1], 3 * 9.81 + 3 * alpha * 0.4, 1e-11);
}

TEST(Redundancy, RigidSpatialLoopIsNamedAndRunsLikeThePlanarOne) {
  const auto m = rigid_slider_crank(20, 0.05);
  const auto spatial = test::run_spatial(m, options(0.1, 5e-4, 0.8, 1e-8));
  const auto planar = test::run_planar(m, options(0.1, 5e-4, 0.8, 1e-8));
  ASSERT_EQ(spatial.report().status, SolveStatus::Converged) << spatial.report().reason;
  ASSERT_EQ(spatial.result.start.redundant.size(), 1u);
  EXPECT_NE(spatial.result.start.redundant[0].find("joint 'guide' repeats rows of"),
            std::string::npos)
      << spatial.result.start.redundant[0];
  EXPECT_TRUE(planar.result.start.redundant.empty());
  EXPECT_EQ(spatial.report().warnings.size(), 1u);
  for (int i = 0; i < planar.trajectory().size(); ++i)
    EXPECT_NEAR(planar.trajectory().frames(i)[2].x.x(), spatial.trajectory().frames(i)[2].x.x(),
                1e-9);
  EXPECT_EQ(mobility(*planar.model, planar.model->initial_state()).free, 0);
}

TEST(Redundancy, DoubledJointIsNamedAndChangesNothing) {
  const auto once = test::slider_crank();
  auto twice = once;
  auto twin = once.joints[1];
  twin.name = "twin";
  twice.joints.push_back(twin);
  const auto a = test::run_planar(once, options(0.03, 1e-4, 0.8, 1e-8));
  const auto b = test::run_planar(twice, options(0.03, 1e-4, 0.8, 1e-8));
  ASSERT_EQ(b.report().status, SolveStatus::Converged) << b.report().reason;
  ASSERT_EQ(b.result.start.redundant.size(), 1u);
  EXPECT_EQ(b.result.start.redundant[0],
            "joint 'twin' repeats rows of 'pin': 2 of its 2 rows are left out");
  for (int i = 0; i < a.trajectory().size(); ++i)
    EXPECT_LT((a.trajectory().v(i) - b.trajectory().v(i)).norm(), 1e-9 * 150);
}

Mechanism two_drives(const TimeFunction& first, const TimeFunction& second) {
  auto m = test::slider_crank();
  auto twin = m.joints[0];
  twin.name = "second motor";
  m.joints.push_back(twin);
  m.drives = {{0, 0, first}, {4, 0, second}};
  return m;
}

TEST(Redundancy, ContradictionAtTheStartIsNamed) {
  const auto r = test::run_planar(
      two_drives(TimeFunction::rate(10, 0.1), TimeFunction::constant(0.1)), options(0.1, 1e-3));
  EXPECT_EQ(r.report().status, SolveStatus::Inconsistent);
  EXPECT_NE(r.report().reason.find("'second motor'"), std::string::npos) << r.report().reason;
  EXPECT_NE(r.report().reason.find("0.1 rad"), std::string::npos) << r.report().reason;
}

TEST(Redundancy, ContradictionDuringTheMotionIsNamed) {
  const auto r = test::run_planar(
      two_drives(TimeFunction::rate(10, 0.05), TimeFunction::rate(11, 0.05)), options(0.05, 1e-3));
  EXPECT_EQ(r.report().status, SolveStatus::Inconsistent);
  EXPECT_NE(r.report().reason.find("'second motor'"), std::string::npos) << r.report().reason;
}

TEST(InitialState, JointsThatCannotCloseAreInconsistentAndNamed) {
  auto m = test::four_bar(2);
  m.joints.push_back({"too far", JointType::Spherical, {0, 0}, {1, 2}});
  const auto r = test::run_planar(m, options(0.1, 1e-3));
  EXPECT_EQ(r.report().status, SolveStatus::Inconsistent);
  EXPECT_NE(r.report().reason.find("' stays "), std::string::npos) << r.report().reason;
}

TEST(InitialState, BodyWithoutMassIsSingular) {
  auto m = test::slider_crank();
  m.joints.pop_back();
  std::get<RigidSpec>(m.bodies[2].kind).mass = 0;
  std::get<RigidSpec>(m.bodies[2].kind).inertia.setZero();
  const auto r = test::run_spatial(m, options(0.01, 1e-4));
  EXPECT_EQ(r.report().status, SolveStatus::Singular);
  EXPECT_NE(r.report().reason.find("'slider'"), std::string::npos) << r.report().reason;
  EXPECT_EQ(r.trajectory().size(), 0);
}

/// A point mass has no inertia of its own to be acted on through; it moves as the limit of a ball:
/// what the ball adds is of first order in its inertia.
TEST(InitialState, PointMassIsTheLimitOfASmallBall) {
  const auto tip = [](double inertia) {
    auto m = test::pendulum(4);
    m.bodies.push_back({"payload", test::block({1, 0, 0}, 0.5, inertia)});
    m.joints.push_back({"grip", JointType::Fixed, {0, 4}, {1, 0}});
    const auto r = test::run_spatial(m, options(0.2, 1e-3, 0.8, 1e-9));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    return std::pair(r.trajectory().frames(r.last())[4].x, r.trajectory().vdot(0).eval());
  };
  const auto [x, vdot] = tip(0);
  double before = 0;
  for (const double inertia : {1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
    const auto [ball, ball_vdot] = tip(inertia);
    const double off = (vdot - ball_vdot).norm();
    EXPECT_LT((x - ball).norm(), 1e-8);
    if (before > 0) {
      EXPECT_NEAR(before / off, 10, 0.1) << inertia;
    }
    before = off;
  }
  EXPECT_LT(before, 1e-6 * vdot.norm());
}

/// At its dead point a parallelogram may go on in two ways: its rows depend on each other there
/// alone, and none may be dropped.
TEST(Redundancy, DeadPointIsNamedAndNothingIsLeftOut) {
  Mechanism m;
  RigidSpec crank = test::block({0, 0, 0}, 1, 1e-2), coupler = test::block({0.2, 0, 0}, 1, 1e-2),
            rocker = test::block({0.5, 0, 0}, 1, 1e-2);
  m.bodies = {{"crank", crank}, {"coupler", coupler}, {"rocker", rocker}};
  const auto at = [](int body, double x) {
    return Port{body, 0, SE3(Mat3::Identity(), {x, 0, 0})};
  };
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}},
              {"pin", JointType::Revolute, at(0, 0.2), {1, 0}},
              {"elbow", JointType::Revolute, at(1, 0.5), at(2, 0.2)},
              {"pivot", JointType::Revolute, {}, {2, 0}}};
  for (const bool driven : {false, true}) {
    if (driven) m.drives = {{0, 0, TimeFunction::rate(6, 0)}};
    const auto r = test::run_planar(m, options(0.1, 1e-3));
    EXPECT_EQ(r.report().status, SolveStatus::Singular);
    EXPECT_NE(r.report().reason.find("dead point"), std::string::npos) << r.report().reason;
    EXPECT_TRUE(r.result.start.redundant.empty());
  }
}

/// Each body has to be in balance, not only the heaviest one.
TEST(Dynamics, GrainBesideATonAtRestKeepsItsEnergy) {
  Mechanism m;
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"ton", test::block({0, -1, 0}, 1e3, 10)},
              {"grain", test::block({0.25, 0, 0}, 1e-6, 6.25e-10)}};
  m.joints = {{"heavy", JointType::Revolute, {}, {0, 0, SE3(Mat3::Identity(), {0, 1, 0})}},
              {"light", JointType::Revolute, {}, {1, 0, SE3(Mat3::Identity(), {-0.25, 0, 0})}}};
  const auto r = test::run_planar(m, options(1, 1e-3, 0.9));
  ASSERT_EQ(r.report().status, SolveStatus::Converged);
  const double start = test::total_energy(r, 0);
  for (int i = 0; i < r.trajectory().size(); ++i)
    EXPECT_NEAR(test::total_energy(r, i), start, 2e-3 * 1e-6 * 9.81 * 0.25);
}

/// The forces on a free body add up to nothing: only their parts say what small is.
TEST(Dynamics, FreeBodyTumbles) {
  Mechanism m;
  RigidSpec body = test::block({0, 0, 0}, 1, 1);
  body.inertia = Vec3(1, 2, 2.5).asDiagonal();
  m.bodies = {{"body", body, {1, 2, 0}, {0.1, 2, 0.1}}};
  const auto r = test::run_spatial(m, options(5, 0.005, 0.9));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  EXPECT_EQ(r.report().rejected_steps, 0);
  EXPECT_NEAR(test::total_energy(r, r.last()), test::total_energy(r, 0), 1e-3 * 6.5);
}

}  // namespace
}  // namespace liesl::test::initial_state_test
