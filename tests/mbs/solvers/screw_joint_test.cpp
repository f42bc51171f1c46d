/// @file
/// Screw joint: closed forms of motion, reaction, equilibrium and frequency; the same motion in
/// every formalism; what it refuses.

#include <array>

#include "mbs/run.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/static_cases.hpp"

namespace liesl::test::screw_joint_test {
namespace {

constexpr double kMass = 2, kInertia = 0.05, kGravity = 9.81;
constexpr std::array kFormalisms = {Formalism::SE3, Formalism::R3SO3, Formalism::Classical,
                                    Formalism::Floating, Formalism::Rigid};

/// Nut on a vertical screw (z up), its centre of mass on the axis.
Mechanism nut(double pitch) {
  Mechanism m;
  m.name = "nut";
  m.gravity = {0, 0, -kGravity};
  m.bodies = {{"nut", test::block({0, 0, 0.3}, kMass, kInertia)}};
  m.joints = {{"thread", JointType::Screw, {}, {0, 0}}};
  m.joints[0].pitch = pitch;
  return m;
}

/// A beam across the screw, held by the thread at its middle: it twists and bends as it falls.
Mechanism propeller(Formalism formalism, int elements) {
  Mechanism m = nut(0.4);
  SE3::Tangent K, M;
  K << 1e4, 4e3, 4e3, 6, 10, 10;
  M << 1, 1, 1, 2e-3, 1e-3, 1e-3;
  m.bodies = {
      {"blade", test::straight_beam({-0.5, 0, 0}, {0.5, 0, 0}, elements, test::full(K, M), {})}};
  m.joints[0].b = {0, elements / 2};
  m.formalism = formalism;
  return m;
}

double acceleration(double pitch) {
  return -kGravity / (1 + kInertia * std::pow(2 * M_PI / pitch, 2) / kMass);
}

template <class G>
void expect_converged(const test::Run<G>& r) {
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
}

/// A constant acceleration: the integrator has no error but round-off and its tolerance.
TEST(ScrewJoint, NutFallsWithTheInertiaOfItsRotation) {
  for (const auto formalism : kFormalisms)
    for (const double pitch : {1.3, 0.2, -0.2, 0.01}) {
      SCOPED_TRACE(std::string(to_string(formalism)) + ", pitch " + std::to_string(pitch));
      Mechanism m = nut(pitch);
      m.formalism = formalism;
      const auto r = test::run_spatial(m, test::options(1, 0.01, 0.8, 1e-10));
      expect_converged(r);
      const int angle = test::row_of(*r.model, 0, 0);
      for (int i = 0; i < r.trajectory().size(); ++i) {
        const double t = r.trajectory().time(i), fall = 0.5 * acceleration(pitch) * t * t;
        ASSERT_NEAR(r.trajectory().frames(i)->x.z() - 0.3, fall, 1e-8 * std::abs(pitch)) << t;
        ASSERT_NEAR(r.trajectory().rows(i)[angle], 2 * M_PI / pitch * fall, 1e-7) << t;
      }
    }
}

TEST(ScrewJoint, NutFallsAlongAnyAxis) {
  const SE3 H = test::oblique();
  const double pitch = 0.2;
  const auto r = test::run_spatial(test::moved(nut(pitch), H), test::options(1, 0.01, 0.8, 1e-10));
  expect_converged(r);
  const Vec3 fallen = r.trajectory().frames(r.last())->x - r.trajectory().frames(0)->x;
  EXPECT_LT((fallen - H.R * Vec3(0, 0, 0.5 * acceleration(pitch))).norm(), 1e-9);
}

/// The thread carries m (g + a); its moment about the axis is -force pitch / (2 pi).
TEST(ScrewJoint, ReactionIsThatOfAFrictionlessThread) {
  const double pitch = 0.2, a = acceleration(pitch);
  const auto r = test::run_spatial(nut(pitch), test::options(0.5, 0.01, 0.8, 1e-10));
  expect_converged(r);
  for (const int i : {0, 10, r.last()}) {
    const SE3::Tangent w = test::joint_wrench(*r.model, r.trajectory().frames(i),
                                              Eigen::VectorXd(r.trajectory().lambda(i)), 0);
    EXPECT_NEAR(w[2], kMass * (kGravity + a), 1e-7);
    EXPECT_NEAR(w[5], -w[2] * pitch / (2 * M_PI), 1e-9);
    EXPECT_NEAR(w[5], kInertia * a * 2 * M_PI / pitch, 1e-7);
    SE3::Tangent rest = w;
    rest[2] = rest[5] = 0;
    EXPECT_LT(rest.norm(), 1e-9);
  }
}

/// Twenty turns at constant speed: the drive gives the moment m g pitch / (2 pi), for either hand.
TEST(ScrewJoint, DrivenAngleLiftsByThePitchATurn) {
  for (const double pitch : {0.05, -0.05}) {
    Mechanism m = nut(pitch);
    m.drives = {{0, 0, TimeFunction::rate(40 * M_PI, 0)}};
    m.bodies[0].velocity = {0, 0, 20 * pitch};
    m.bodies[0].angular_velocity = {0, 0, 40 * M_PI};
    const auto r = test::run_spatial(m, test::options(1, 0.002, 0.8, 1e-10));
    expect_converged(r);
    EXPECT_NEAR(r.trajectory().frames(r.last())->x.z(), 0.3 + 20 * pitch, 1e-9);
    const auto& c = r.model->couplings[0];
    ASSERT_EQ(c.constraints, 6);
    int drive = -1;
    for (int k = 0; k < c.constraints; ++k)
      if (c.rows[std::size_t(k)].coordinate == 0) drive = k;
    EXPECT_NEAR(-r.trajectory().lambda(r.last())[drive], kMass * kGravity * pitch / (2 * M_PI),
                1e-7);
  }
}

/// k q = -m g pitch / (2 pi), over several turns; omega^2 = k / (J + m (pitch / 2 pi)^2) about it.
TEST(ScrewJoint, SpringOnTheAngleBalancesTheWeight) {
  const double pitch = 0.2, lead = pitch / (2 * M_PI), turns = 3;
  Mechanism m = nut(pitch);
  ForceSpec spring;
  spring.joint = 0;
  spring.stiffness = kMass * kGravity * lead / (turns * 2 * M_PI);
  m.forces = {spring};
  SimulationOptions o = test::tight();
  o.load_steps = 12;
  const auto solved = test::solve(m, o);
  ASSERT_EQ(solved.result.report.status, SolveStatus::Converged) << solved.result.report.reason;
  EXPECT_NEAR(solved.frame(0).x.z(), 0.3 - turns * pitch, 1e-9);
  o.type = SimulationType::Modes;
  o.modes = 2;
  auto model = Model<SE3>::build(m, {});
  const auto modes = solve_modes(model, o);
  ASSERT_EQ(modes.report.status, SolveStatus::Converged) << modes.report.reason;
  ASSERT_EQ(modes.omega.size(), 1u);
  const double expected = std::sqrt(spring.stiffness / (kInertia + kMass * lead * lead));
  EXPECT_NEAR(modes.omega[0] / expected, 1, 1e-9);
}

/// Place of the middle of a propeller's blade after 0.3 s.
Vec3 middle(Formalism formalism, int elements, double step) {
  const auto r =
      test::run_spatial(propeller(formalism, elements), test::options(0.3, step, 0.9, 1e-9));
  expect_converged(r);
  return r.trajectory().frames(r.last())[elements / 2].x;
}

TEST(ScrewJoint, FormalismsConvergeToTheSameMotion) {
  const Vec3 coarse = middle(Formalism::SE3, 4, 2e-3), fine = middle(Formalism::SE3, 8, 1e-3);
  EXPECT_LT(fine.z(), -0.015);
  for (const auto f : {Formalism::R3SO3, Formalism::Classical}) {
    const double apart = (middle(f, 4, 2e-3) - coarse).norm();
    const double closer = (middle(f, 8, 1e-3) - fine).norm();
    EXPECT_LT(closer, 1e-3 * std::abs(fine.z())) << to_string(f);
    EXPECT_LT(closer, apart / 3) << to_string(f);
  }
}

/// Largest change of the energy of a falling blade; the integrator does not damp (rho = 1).
double drift(Formalism formalism, int elements, double step) {
  const auto r =
      test::run_spatial(propeller(formalism, elements), test::options(0.5, step, 1, 1e-9));
  expect_converged(r);
  const double start = test::total_energy(r, 0);
  double largest = 0;
  for (int i = 0; i < r.trajectory().size(); ++i)
    largest = std::max(largest, std::abs(test::total_energy(r, i) - start));
  State<SE3> s = r.model->initial_state();
  r.trajectory().read(r.last(), s);
  EXPECT_GT(mechanical_energy(*r.model, s).kinetic, 0.5);
  return largest;
}

/// The thread does no work on a flexible blade. On SE(3) the drift is that of the mesh, whose
/// weight is interpolated; elsewhere that of the step.
TEST(ScrewJoint, EnergyIsKept) {
  for (const auto f : {Formalism::R3SO3, Formalism::Classical}) {
    const double coarse = drift(f, 4, 4e-4), fine = drift(f, 4, 2e-4);
    EXPECT_LT(fine, 2e-7) << to_string(f);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << to_string(f);
  }
  const double coarse = drift(Formalism::SE3, 4, 2e-4), fine = drift(Formalism::SE3, 8, 2e-4);
  EXPECT_LT(coarse, 2e-5);
  EXPECT_LT(fine, coarse / 3);
}

/// A nut guided against rotation on a screw that turns: the thread lies between two bodies, and
/// its rows repeat some of the guide's.
TEST(ScrewJoint, TurningSpindleMovesAGuidedNut) {
  const double pitch = 0.02;
  Mechanism m = nut(pitch);
  m.bodies.insert(m.bodies.begin(), {"spindle", test::block({0, 0, 0}, 1, 1e-3)});
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}},
              {"guide", JointType::Prismatic, {}, {1, 0}, Vec3::UnitZ()},
              {"thread", JointType::Screw, {0, 0}, {1, 0}}};
  m.joints[2].pitch = pitch;
  m.drives = {{0, 0, TimeFunction::rate(20 * M_PI, 0.1)}};
  const auto r = test::run_spatial(m, test::options(1, 0.002, 0.8, 1e-9));
  expect_converged(r);
  const double turns = 10 * (1 - 0.5 * 0.1);
  EXPECT_NEAR(r.trajectory().frames(r.last())[1].x.z(), 0.3 - turns * pitch, 1e-8);
}

TEST(ScrewJoint, LeavesThePlane) {
  for (const Vec3& axis : {Vec3::UnitZ().eval(), Vec3::UnitX().eval()}) {
    Mechanism m = nut(0.1);
    m.gravity = {0, -kGravity, 0};
    m.bodies.push_back({"other", test::block({0.2, 0.1, 0.3}, 1, 1)});
    m.joints[0].axis = axis;
    const auto search = find_plane(m);
    EXPECT_FALSE(search.plane);
    EXPECT_NE(search.reason.find("'thread'"), std::string::npos);
    EXPECT_THROW(Model<SE2>::build(m, {}), std::invalid_argument);
  }
}

TEST(ScrewJoint, WithoutPitchIsRefused) {
  EXPECT_THROW(Model<SE3>::build(nut(0), {}), std::invalid_argument);
  EXPECT_THROW(Model<SE3>::build(nut(NAN), {}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::screw_joint_test
