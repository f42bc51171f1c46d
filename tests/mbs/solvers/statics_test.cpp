/// @file
/// Static equilibria against closed forms and published values.

#include "mbs/solvers/statics.hpp"

#include <gtest/gtest.h>

#include "mbs/static_cases.hpp"
#include "reference/mechanisms.hpp"

namespace liesl::test::statics_test {
namespace {

using test::solve;
using test::tight;
using test::tip_displacement;

constexpr auto kConverged = SolveStatus::Converged;

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

/// Linear Timoshenko cantilever: the element is exact but for 1/(4 n^2) of the bending part.
TEST(Statics, LinearCantileverTip) {
  const double L = 2, EI = 50, GA = 300, P = 1e-7;
  for (int n : {1, 2, 7}) {
    Mechanism m = test::cantilever(test::beam(straight({0, 0, 0}, {L, 0, 0}, n),
                                              test::section(test::diagonal(1e3, GA, 40, EI))));
    m.loads.push_back(test::tip_load(m, {0, P, 0}));
    const double bend = P * L * L * L / (3 * EI) * (1 - 1.0 / (4 * n * n)), shear = P * L / GA;
    EXPECT_NEAR(tip_displacement(m).y() / (bend + shear), 1, 1e-8) << n;
  }
}

/// A cantilever under a pure end moment closes to a circle, exactly, for three elements or more.
TEST(Statics, RollUpClosesInOneLoadStep) {
  for (int n : {3, 5, 10}) {
    const auto spatial = solve(test::roll_up(n));
    ASSERT_EQ(spatial.result.report.status, kConverged) << spatial.result.report.reason;
    EXPECT_EQ(spatial.result.report.steps, 1) << n;
    EXPECT_EQ(spatial.result.report.rejected_steps, 0);
    expect_near(spatial.frame(n).x, Vec3::Zero(), 1e-12);
    const auto plane = find_plane(test::roll_up(n));
    ASSERT_TRUE(plane.plane);
    const auto planar = solve<SE2>(test::roll_up(n), tight(), *plane.plane);
    ASSERT_EQ(planar.result.report.status, kConverged) << planar.result.report.reason;
    expect_near(planar.frame(n).x, Vec3::Zero(), 1e-12);
  }
}

/// Two elements would turn by pi each, where the logarithm has no unique value.
TEST(Statics, RollUpWithTwoElementsFailsCleanly) {
  SimulationOptions o = tight();
  for (int steps : {1, 10}) {
    o.load_steps = steps;
    const auto solved = solve(test::roll_up(2), o);
    EXPECT_EQ(solved.result.report.status, SolveStatus::NotConverged);
    EXPECT_FALSE(solved.result.report.reason.empty());
    for (int i = 0; i < solved.result.trajectory.size(); ++i)
      for (int k = 0; k < 3; ++k) EXPECT_TRUE(solved.result.trajectory.frames(i)[k].x.allFinite());
  }
}

TEST(Statics, Bend45InOneLoadStep) {
  SimulationOptions o;
  o.type = SimulationType::Static;
  const auto solved = solve(test::bend45(8, 600), o);
  const auto& r = solved.result;
  ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
  EXPECT_EQ(r.report.steps, 1);
  EXPECT_EQ(r.report.rejected_steps, 0);
  EXPECT_LE(r.report.newton_iterations, 8);
  EXPECT_EQ(r.negative.back(), 0);
}

/// The last correction squares the error.
TEST(Statics, Bend45IsQuadratic) {
  SimulationOptions o = tight();
  o.tolerance = 1e-9;
  const auto solved = solve(test::bend45(8, 600), o);
  ASSERT_EQ(solved.result.report.status, kConverged);
  const auto& e = solved.result.residuals;
  ASSERT_GE(e.size(), 3u);
  const size_t last = e.size() - 1;
  EXPECT_LT(e[last - 1], e[last - 2] * e[last - 2]);
  EXPECT_LT(e[last], 0.1 * e[last - 1] * e[last - 1]);
}

/// Curved elements, P = 600, as tabulated; order 2 with ratio 4.00.
TEST(Statics, Bend45OnCoarseMeshes) {
  const Vec3 u4 = tip_displacement(test::bend45(4, 600));
  const Vec3 u8 = tip_displacement(test::bend45(8, 600));
  const Vec3 u16 = tip_displacement(test::bend45(16, 600));
  const Vec3 u32 = tip_displacement(test::bend45(32, 600));
  expect_near(u4, {-23.2316, -13.4987, 52.9053}, 6e-5);
  expect_near(u8, {-23.4788297, -13.5782031, 53.3331826}, 6e-8);
  expect_near(u16, {-23.5399286, -13.5979498, 53.4394833}, 6e-8);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR((u16 - u8)[i] / (u32 - u16)[i], 4, 0.04);
}

TEST(Statics, Bend45Converged) {
  const auto limit = [](double P, double shear, double J) {
    const Vec3 coarse = tip_displacement(test::bend45(32, P, shear, J));
    return test::richardson(coarse, tip_displacement(test::bend45(64, P, shear, J)));
  };
  expect_near(limit(300, 1, 1. / 6), {-11.93156, -7.04454, 40.19189}, 6e-6);
  expect_near(limit(450, 1, 1. / 6), {-18.47212, -10.78114, 48.50293}, 6e-6);
  expect_near(limit(600, 1, 1. / 6), {-23.5602396, -13.6045213, 53.4748588}, 3e-7);
  expect_near(limit(600, 5. / 6, 0.140577), {-23.8190919, -13.7316457, 53.6079864}, 3e-7);
}

/// Transverse dead load on an inextensible, unshearable cantilever (Mattiasson 1981): shortening,
/// deflection, tip angle. The strains of EA = GA = c vanish like 1/c, the mesh error like 1/n^2 and
/// 1/n^4: extrapolated in all three.
TEST(Statics, Elastica) {
  const auto tip = [](double lambda, int n, double c) -> Vec3 {
    Mechanism m = test::cantilever(
        test::beam(straight({0, 0, 0}, {1, 0, 0}, n), test::section(test::diagonal(c, c, 1, 1))));
    m.loads.push_back(test::tip_load(m, {0, lambda, 0}));
    const auto plane = find_plane(m);
    const auto solved = solve<SE2>(m, tight(), *plane.plane);
    EXPECT_EQ(solved.result.report.status, kConverged) << solved.result.report.reason;
    const SE3 H = solved.frame(n);
    return {1 - H.x.x(), H.x.y(), std::atan2(H.R(1, 0), H.R(0, 0))};
  };
  const auto rigid = [&](double lambda, int n) {  // 1/c -> 0
    return Vec3(2 * tip(lambda, n, 2e5) - tip(lambda, n, 1e5));
  };
  const std::pair<double, Vec3> rows[] = {{1, {0.0564332363, 0.3017207738, 0.4613519497}},
                                          {2, {0.1606417208, 0.4934574804, 0.7817498316}},
                                          {5, {0.3876283607, 0.7137915236, 1.2153681176}},
                                          {10, {0.5549955978, 0.8106090249, 1.4302855388}}};
  for (const auto& [lambda, reference] : rows) {
    const Vec3 a = rigid(lambda, 16), b = rigid(lambda, 32), c = rigid(lambda, 64);
    const Vec3 first = test::richardson(a, b), second = test::richardson(b, c);
    const Vec3 limit = second + (second - first) / 15;
    expect_near(limit, reference, 1e-9);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR((b - a)[i] / (c - b)[i], 4, 0.1);
  }
}

/// Constant strains, hence exact for any mesh.
TEST(Statics, Helix) {
  for (const int order : {2, 4})
    for (int n : {10, 20, 100}) {
      SimulationOptions o = tight();
      o.load_steps = 10;
      const auto solved = solve(test::helix(n, order), o);
      ASSERT_EQ(solved.result.report.status, kConverged) << solved.result.report.reason;
      expect_near(solved.frame(n).x, test::end_of_helix(), 1e-10);
    }
}

TEST(Statics, RigidMotionChangesNoLocalQuantity) {
  SE3::Tangent h;
  h << 3, -20, 7, 0.9, -1.7, 0.4;
  const SE3 H = SE3::exp(h);
  SimulationOptions o = tight();
  o.tolerance = 1e-13;
  const auto here = solve(test::bend45(8, 600), o);
  const auto there = solve(test::moved(test::bend45(8, 600), H), o);
  ASSERT_EQ(here.result.report.status, kConverged);
  ASSERT_EQ(there.result.report.status, kConverged);
  double worst = 0;
  for (int k = 0; k <= 8; ++k) {
    const SE3 a = H * here.frame(k), b = there.frame(k);
    worst = std::max({worst, (a.x - b.x).norm() / 100, (a.R - b.R).norm()});
  }
  EXPECT_LT(worst, 3e-14);
  EXPECT_EQ(here.result.report.newton_iterations, there.result.report.newton_iterations);
}

/// In few steps or many, or along the arc.
TEST(Statics, EndDoesNotDependOnThePath) {
  const auto tip = [](int steps, bool arc) {
    Mechanism m = test::bend45(8, 300);
    m.loads.push_back(test::tip_load(m, Vec3::Zero(), {0, 4000, 9000}));
    SimulationOptions o = tight();
    o.tolerance = 1e-13;
    o.load_steps = steps;
    o.arc_length = arc;
    return tip_displacement(m, o);
  };
  const Vec3 a = tip(4, false), b = tip(7, false), c = tip(5, true);
  EXPECT_LT((a - b).norm() / 100, 2e-14);
  EXPECT_LT((a - c).norm() / 100, 2e-14);
}

/// Loads have their value at the time `at`, times the load factor, and drives that at `at` alone.
TEST(Statics, TimeAndLoadFactorAreTwoThings) {
  const auto tip = [](const TimeFunction& scale, double at, double max_load) {
    Mechanism m = test::bend45(4, 300);
    m.loads[0].scale = scale;
    SimulationOptions o = tight();
    o.at = at;
    o.max_load = max_load;
    return tip_displacement(m, o);
  };
  const auto table =
      TimeFunction::table({0, 0.5, 2}, {0.2, 1, 1}, TimeFunction::Interpolation::Linear);
  const auto constant = [](double f) { return TimeFunction::constant(f); };
  EXPECT_LT((tip(table, 0, 1) - tip(constant(0.2), 0, 1)).norm(), 1e-9);
  EXPECT_LT((tip(table, 2, 1) - tip(constant(1), 0, 1)).norm(), 1e-9);
  EXPECT_LT((tip(table, 0.25, 0.5) - tip(constant(0.3), 7, 1)).norm(), 1e-9);
}

TEST(Statics, SpreadAndGravityLoadsAgree) {
  const double w = 3;  // N/m, large deflection
  const auto scene = [&] {
    return test::cantilever(test::beam(straight({0, 0, 0}, {2, 0, 0}, 6),
                                       test::section(test::diagonal(1e4, 1e4, 4, 4))));
  };
  Mechanism heavy = scene(), loaded = scene();
  heavy.gravity = {0, -w, 0};  // unit mass per length
  LoadSpec l;
  l.port = {0, 0};
  l.spread = true;
  l.force = {0, -w, 0};
  loaded.loads.push_back(l);
  const auto a = solve(heavy), b = solve(loaded);
  ASSERT_EQ(a.result.report.status, kConverged) << a.result.report.reason;
  ASSERT_EQ(b.result.report.status, kConverged) << b.result.report.reason;
  expect_near(a.frame(6).x, b.frame(6).x, 1e-10);
  EXPECT_LT(a.frame(6).x.y(), -0.5);
}

/// A drive on the hinge bends nothing; a spring there carries the tip load.
TEST(Statics, SpringOnAJointCoordinate) {
  Mechanism m = test::cantilever(test::beam(straight({0, 0, 0}, {1, 0, 0}, 4),
                                            test::section(test::diagonal(1e9, 1e9, 1e7, 1e7))));
  m.joints[0].type = JointType::Revolute;
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 0;
  spring.stiffness = 20;
  m.forces.push_back(spring);
  m.loads.push_back(test::tip_load(m, {0, 10, 0}));
  const auto solved = solve(m);
  ASSERT_EQ(solved.result.report.status, kConverged) << solved.result.report.reason;
  const double q = std::atan2(solved.frame(4).x.y(), solved.frame(4).x.x());
  EXPECT_NEAR(20 * q, 10 * std::cos(q), 1e-4);
  EXPECT_EQ(solved.result.negative.back(), 0);
}

TEST(Statics, FreeMotionIsNamed) {
  Mechanism m = test::cantilever(test::beam(straight({1, 0, 0}, {3, 0, 0}, 4),
                                            test::section(test::diagonal(1e6, 1e6, 1e2, 1e2))));
  m.bodies[0].name = "arm";
  m.joints[0].type = JointType::Revolute;
  m.loads.push_back(test::tip_load(m, {0, 0, 1}));
  auto hinged = solve(m).result.report;
  EXPECT_EQ(hinged.status, SolveStatus::Singular);
  EXPECT_NE(
      hinged.reason.find("body 'arm' can rotate about (0, 0, 1) through (1, 0, 0) at its node 0"),
      std::string::npos)
      << hinged.reason;
  m.joints[0].type = JointType::Prismatic;
  m.joints[0].axis = Vec3::UnitY();
  auto sliding = solve(m).result.report;
  EXPECT_EQ(sliding.status, SolveStatus::Singular);
  EXPECT_NE(sliding.reason.find("body 'arm' can move along (0, 1, 0)"), std::string::npos)
      << sliding.reason;
  m.joints.clear();
  auto free = solve(m).result.report;
  EXPECT_EQ(free.status, SolveStatus::Singular);
  EXPECT_NE(free.reason.find("6 free motions"), std::string::npos) << free.reason;
}

TEST(Statics, StopsOnRequest) {
  auto model = Model<SE3>::build(test::bend45(4, 100), {});
  SimulationOptions o = tight();
  o.load_steps = 10;
  const auto result = solve_static(model, o, [](double load) { return load < 0.25; });
  EXPECT_EQ(result.report.status, SolveStatus::Interrupted);
  EXPECT_EQ(result.trajectory.size(), 4);
  EXPECT_DOUBLE_EQ(result.trajectory.time(3), 0.3);
}

/// A slender cantilever far past what one load step can do: smaller ones, or a clean end.
TEST(Statics, NeverANumberThatIsNone) {
  for (double P : {1e3, 1e6, 1e12}) {
    Mechanism m = test::bend45(4, P);
    SimulationOptions o = tight();
    const auto solved = solve(m, o);
    const auto& t = solved.result.trajectory;
    for (int i = 0; i < t.size(); ++i)
      for (int k = 0; k < 5; ++k)
        EXPECT_TRUE(t.frames(i)[k].x.allFinite() && t.frames(i)[k].R.allFinite());
    if (solved.result.report.status != kConverged) {
      EXPECT_EQ(solved.result.report.status, SolveStatus::NotConverged);
      EXPECT_FALSE(solved.result.report.reason.empty());
    }
  }
}

}  // namespace
}  // namespace liesl::test::statics_test
