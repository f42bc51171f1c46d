/// @file
/// Stability of equilibria: counts of negative eigenvalues, critical loads, limit points.

#include <gtest/gtest.h>

#include <random>

#include "mbs/linalg/inertia.hpp"
#include "mbs/linalg/sparse_lu.hpp"
#include "mbs/static_cases.hpp"

namespace liesl::test::buckling_test {
namespace {

using test::solve;
using test::tight;

constexpr auto kConverged = SolveStatus::Converged;

/// Axially loaded straight cantilever, compressed in its axis; EA and GA large.
Mechanism column(int n, double P) {
  Mechanism m = test::cantilever(test::beam(
      straight({0, 0, 0}, {1, 0, 0}, n),
      test::section((SE3::Tangent() << 1e7, 1e7, 1e7, 1, 2, 1).finished())));  // EI_y = 2, EI_z = 1
  m.loads.push_back(test::tip_load(m, {-P, 0, 0}));
  return m;
}

/// Euler: pi^2 EI/(4 L^2) for either axis; the mesh is too stiff by O(h^2).
TEST(Buckling, EulerColumn) {
  SimulationOptions o = tight();
  o.critical = true;
  o.load_steps = 8;
  const double euler = M_PI * M_PI / 4;
  double error[2];
  for (int k = 0; k < 2; ++k) {
    const auto solved = solve(column(8 << k, 6), o);
    const auto& r = solved.result;
    ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
    ASSERT_EQ(r.critical.size(), 2u);
    EXPECT_EQ(r.critical[0].before, 0);
    EXPECT_EQ(r.critical[0].after, 1);
    EXPECT_EQ(r.critical[1].after, 2);
    EXPECT_FALSE(r.critical[0].limit_point);
    error[k] = 6 * r.critical[0].load / euler - 1;
    EXPECT_NEAR(r.critical[1].load / r.critical[0].load, 2, 1e-4);
    EXPECT_FALSE(r.report.warnings.empty());
  }
  EXPECT_LT(std::abs(error[1]), 2e-3);
  EXPECT_NEAR(error[0] / error[1], 4, 0.2);
}

/// A load beyond the critical one in one step is noticed too.
TEST(Buckling, OneStepAcrossTheCriticalLoad) {
  SimulationOptions o = tight();
  o.critical = true;
  const auto solved = solve(column(8, 4), o);
  ASSERT_EQ(solved.result.report.status, kConverged) << solved.result.report.reason;
  ASSERT_EQ(solved.result.critical.size(), 1u);
  EXPECT_EQ(solved.result.negative, (std::vector<int>{0, 1}));
  EXPECT_NEAR(4 * solved.result.critical[0].load, M_PI * M_PI / 4, 0.02);
}

/// Right-angle cantilever frame, load in its plane at the free end (Argyris): lateral buckling at
/// 1.0880 with 20 elements a leg, 1.0894 with 10.
TEST(Buckling, RightAngleFrame) {
  const auto frame = [](int n) {
    Section s;
    s.shape = Rectangle{30, 0.6};
    s.torsion_constant = 30 * 0.6 * 0.6 * 0.6 / 3;
    s.shear_factor = {5. / 6, 5. / 6};
    Mechanism m;
    for (const auto& [name, from, to] : {std::tuple{"first", Vec3(0, 0, 0), Vec3(240, 0, 0)},
                                         {"second", Vec3(240, 0, 0), Vec3(240, -240, 0)}}) {
      BeamSpec b = test::beam(straight(from, to, n), s);
      b.material = {"", 71240, 0.31, 1};
      m.bodies.push_back({name, b});
    }
    JointSpec clamp, corner;
    clamp.name = "clamp";
    clamp.b = {0, 0};
    corner.name = "corner";
    corner.a = {0, n};
    corner.b = {1, 0};
    m.joints = {clamp, corner};
    LoadSpec l;
    l.port = {1, n};
    l.force = {1, 0, 0};
    m.loads.push_back(l);
    return m;
  };
  SimulationOptions o = tight();
  o.critical = true;
  o.load_steps = 6;
  o.max_load = 1.2;
  for (const auto& [n, reference] : {std::pair{10, 1.0894}, {20, 1.0880}}) {
    const auto solved = solve(frame(n), o);
    ASSERT_EQ(solved.result.report.status, kConverged) << solved.result.report.reason;
    ASSERT_FALSE(solved.result.critical.empty());
    EXPECT_NEAR(solved.result.critical[0].load, reference, 6e-5);
    EXPECT_EQ(solved.result.critical[0].after, 1);
  }
}

/// Two springs from (-+a, 0) to an apex at height h that is pushed down between guides:
/// P(y) = 2 k y (l0/l - 1), l = sqrt(a^2 + y^2); limit points at l^3 = l0 a^2.
Mechanism shallow_truss(double a, double h, double k, double P) {
  Mechanism m;
  RigidSpec apex;
  apex.frame.x = {0, h, 0};
  apex.mass = 1;
  apex.inertia = Mat3::Identity();
  m.bodies.push_back({"apex", apex});
  JointSpec guide;
  guide.name = "guide";
  guide.type = JointType::Prismatic;
  guide.axis = Vec3::UnitY();
  guide.b = {0, 0};
  m.joints.push_back(guide);
  for (double side : {-1.0, 1.0}) {
    ForceSpec spring;
    spring.name = side < 0 ? "left" : "right";
    spring.a.offset.x = {side * a, 0, 0};
    spring.b = {0, 0};
    spring.stiffness = k;
    spring.rest = std::hypot(a, h);
    m.forces.push_back(spring);
  }
  LoadSpec l;
  l.port = {0, 0};
  l.force = {0, -P, 0};
  m.loads.push_back(l);
  return m;
}

TEST(Buckling, SnapThroughByArcLength) {
  const double a = 1, h = 0.3, k = 100, l0 = std::hypot(a, h), l = std::cbrt(l0 * a * a);
  const double y = std::sqrt(l * l - a * a), limit = 2 * k * y * (l0 / l - 1);
  const double P = 2 * limit;
  SimulationOptions o = tight();
  o.arc_length = true;
  o.load_steps = 12;
  const auto solved = solve(shallow_truss(a, h, k, P), o);
  const auto& r = solved.result;
  ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
  ASSERT_EQ(r.critical.size(), 2u);
  EXPECT_NEAR(P * r.critical[0].load, limit, 2e-5 * limit);
  EXPECT_NEAR(P * r.critical[1].load, -limit, 2e-5 * limit);
  for (const auto& c : r.critical) EXPECT_TRUE(c.limit_point);
  EXPECT_EQ(r.critical[0].before, 0);
  EXPECT_EQ(r.critical[0].after, 1);
  EXPECT_EQ(r.critical[1].after, 0);
  for (int i = 0; i < r.trajectory.size(); ++i) {  // every record is on the closed form
    const double yi = r.trajectory.frames(i)[0].x.y(), li = std::hypot(a, yi);
    EXPECT_NEAR(P * r.trajectory.time(i), 2 * k * yi * (l0 / li - 1), 1e-8);
  }
  EXPECT_DOUBLE_EQ(r.trajectory.time(r.trajectory.size() - 1), 1);
  EXPECT_LT(r.trajectory.frames(r.trajectory.size() - 1)[0].x.y(), -h);
}

/// Without arc length the load jumps over the unstable part, or stops before it: never a NaN.
TEST(Buckling, SnapThroughByLoadSteps) {
  SimulationOptions o = tight();
  o.load_steps = 20;
  const auto solved = solve(shallow_truss(1, 0.3, 100, 10), o);
  for (int i = 0; i < solved.result.trajectory.size(); ++i)
    EXPECT_TRUE(solved.result.trajectory.frames(i)[0].x.allFinite());
  EXPECT_TRUE(solved.result.report.status == kConverged ||
              solved.result.report.status == SolveStatus::NotConverged);
}

/// Arc length on a path without limit points is load stepping.
TEST(Buckling, ArcLengthReachesTheEndOfAStableBend) {
  SimulationOptions o = tight();
  o.arc_length = true;
  o.load_steps = 4;
  const Vec3 a = test::tip_displacement(test::bend45(8, 600), o);
  const Vec3 b = test::tip_displacement(test::bend45(8, 600));
  EXPECT_LT((a - b).norm(), 1e-9);
}

/// Sturm count against all eigenvalues, on random saddle points of every signature.
TEST(Inertia, CountsNegativeEigenvaluesOnTheNullSpace) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 40; ++trial) {
    const int n = 12, m = trial % 5;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + m, n + m);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n + m; ++j) A(i, j) = normal(random);
    A.topLeftCorner(n, n) += A.topLeftCorner(n, n).transpose().eval();
    A.diagonal().head(n).array() += trial % 7 - 3;
    A.bottomLeftCorner(m, n) = A.topRightCorner(n, m).transpose();
    const Eigen::SparseMatrix<double> S = A.sparseView();
    const auto found = negative_on_null_space(S, n);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, negative_on_null_space_dense(S, n)) << trial;
  }
}

TEST(Inertia, RefusesWhatIsNotFinite) {
  Eigen::SparseMatrix<double> A(2, 2);
  A.insert(0, 0) = NAN;
  A.insert(1, 1) = 1;
  A.makeCompressed();
  EXPECT_FALSE(negative_on_null_space(A, 2));
}

TEST(SparseLu, SolvesSeveralRightHandSidesAndRefactors) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  SparseLu lu;
  for (int round = 0; round < 5; ++round) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(9, 9), X = Eigen::MatrixXd::Random(9, 3);
    for (int i = 0; i < 9; ++i)
      for (int j = std::max(0, i - 2); j < std::min(9, i + 3); ++j) A(i, j) = normal(random);
    const Eigen::SparseMatrix<double> S = A.sparseView();
    ASSERT_TRUE(lu.factor(S));
    Eigen::MatrixXd b = A * X;
    lu.solve(b);
    EXPECT_LT((b - X).norm(), 1e-11 * A.inverse().norm() * A.norm());
    EXPECT_EQ(lu.determinant_sign(), A.determinant() > 0 ? 1 : -1);
    EXPECT_GT(lu.reciprocal_condition(), 0);
    EXPECT_EQ(lu.singular_column(), -1);
  }
}

TEST(SparseLu, NamesTheColumnWithoutPivot) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(4, 4);
  A.col(2).setZero();
  A(2, 2) = 1e-300;
  SparseLu lu;
  Eigen::SparseMatrix<double> S = A.sparseView(1e-310, 1);
  ASSERT_TRUE(lu.factor(S));
  S.coeffRef(2, 2) = 0;
  EXPECT_FALSE(lu.factor(S));
  EXPECT_EQ(lu.singular_column(), 2);
  EXPECT_EQ(lu.determinant_sign(), 0);
  S.coeffRef(2, 2) = NAN;
  EXPECT_FALSE(lu.factor(S));
  S.coeffRef(2, 2) = 3;
  EXPECT_TRUE(lu.factor(S));
}

/// Two critical loads between two load steps are told apart (EI_y and EI_z differ by 2 per cent).
TEST(Buckling, CriticalLoadsOfOneStepAreToldApart) {
  Mechanism m = column(8, 6);
  auto& section = std::get<FullSection>(std::get<BeamSpec>(m.bodies[0].kind).sections[0].shape);
  section.stiffness(4, 4) = 1.02;
  for (auto& s : std::get<BeamSpec>(m.bodies[0].kind).sections) s.shape = section;
  SimulationOptions o = tight();
  o.critical = true;
  for (const int steps : {1, 3, 40}) {
    o.load_steps = steps;
    const auto solved = solve(m, o);
    ASSERT_EQ(solved.result.report.status, kConverged) << solved.result.report.reason;
    const auto& critical = solved.result.critical;
    ASSERT_EQ(critical.size(), 2u) << steps;
    EXPECT_NEAR(critical[1].load / critical[0].load, 1.02, 1e-3);
    EXPECT_EQ(critical[0].after, 1);
    EXPECT_EQ(critical[1].before, 1);
    EXPECT_EQ(critical[1].after, 2);
  }
}

/// A cantilever under a follower force has no critical load of equilibria (Beck 1952: it flutters
/// at 20.05 EI/L^2); under the same dead force it has.
TEST(Buckling, FollowerForceHasNone) {
  SimulationOptions o = tight();
  o.critical = true;
  o.load_steps = 10;
  for (const bool follower : {false, true}) {
    Mechanism m = column(16, 19);
    m.loads[0].follower = follower;
    const auto solved = solve(m, o);
    ASSERT_EQ(solved.result.report.status, kConverged) << solved.result.report.reason;
    EXPECT_EQ(solved.result.critical.empty(), follower);
    bool told = false;
    for (const auto& w : solved.result.report.warnings)
      told = told || w.find("flutter") != std::string::npos;
    EXPECT_EQ(told, follower);
  }
}

}  // namespace
}  // namespace liesl::test::buckling_test
