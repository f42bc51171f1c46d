/// @file
/// Natural frequencies against closed forms.

#include "mbs/solvers/modes.hpp"

#include <gtest/gtest.h>

#include "mbs/linalg/constrained_modes.hpp"
#include "mbs/solvers/static_newton.hpp"
#include "mbs/static_cases.hpp"

namespace liesl::test::modes_test {
namespace {

constexpr auto kConverged = SolveStatus::Converged;

SimulationOptions first(int count) {
  SimulationOptions o = test::tight();
  o.type = SimulationType::Modes;
  o.modes = count;
  return o;
}

template <FrameGroup G = SE3>
ModesResult<G> modes(const Mechanism& m, int count, const Space<G>& space = {}) {
  auto model = Model<G>::build(m, space);
  return solve_modes(model, first(count));
}

/// Rectangular rod of width b and height h along x, L = 1, E = rho = 1, nu = 0.3, shear factor 5/6.
BeamSpec rod(int n, double b, double h) {
  Section s;
  s.shape = Rectangle{b, h};
  s.shear_factor = {5. / 6, 5. / 6};
  BeamSpec spec = test::beam(straight({0, 0, 0}, {1, 0, 0}, n), s);
  spec.material = {"", 1, 0.3, 1};
  return spec;
}

/// Both ends held against displacement, the first one against twist too; the second one slides
/// along x with a slider of next to no mass.
Mechanism simply_supported(BeamSpec spec) {
  const int n = static_cast<int>(spec.sections.size());
  Mechanism m;
  m.bodies.push_back({"beam", std::move(spec)});
  RigidSpec slider;
  slider.frame.x = {1, 0, 0};
  slider.mass = 1e-12;
  slider.inertia = 1e-12 * Mat3::Identity();
  m.bodies.push_back({"slider", slider});
  JointSpec left, right, guide;
  left.name = "left";
  left.type = JointType::Universal;
  left.axis = Vec3::UnitY();
  left.axis2 = Vec3::UnitZ();
  left.b = {0, 0};
  right.name = "right";
  right.type = JointType::Spherical;
  right.a = {0, n};
  right.b = {1, 0};
  guide.name = "guide";
  guide.type = JointType::Prismatic;
  guide.axis = Vec3::UnitX();
  guide.b = {1, 0};
  m.joints = {left, right, guide};
  return m;
}

/// omega^2 of a pinned-pinned Timoshenko beam, wave number j pi/L (the lower branch).
double timoshenko(int j, double A, double I, double k, double G) {
  const double beta2 = j * j * M_PI * M_PI;
  const double a = A * I / (k * G * A), b = A + I * beta2 + I * A * beta2 / (k * G * A);
  return (b - std::sqrt(b * b - 4 * a * I * beta2 * beta2)) / (2 * a);
}

/// Slender cantilever: omega = (beta L)^2 sqrt(EI/(rho A))/L^2.
TEST(Modes, EulerBernoulliCantilever) {
  const double h = 1e-3, roots[] = {1.8751040687, 4.6940911330, 7.8547574382};
  double error[3][2];
  for (int k = 0; k < 2; ++k) {
    const Mechanism m = test::cantilever(rod(16 << k, 2 * h, h));
    const auto plane = find_plane(m);
    const auto r = modes(m, 6);
    ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
    // Two planes, the stiffer one at twice the frequency: 1 z, 1 y, 2 z, ...
    std::vector<double> soft;
    for (int j = 0; j < 6; ++j) {
      const int tip = SE3::dim * (16 << k);
      if (std::abs(r.shapes(tip + 2, j)) > std::abs(r.shapes(tip + 1, j)))
        soft.push_back(r.omega[j]);
    }
    ASSERT_GE(soft.size(), 3u);
    for (int j = 0; j < 3; ++j)
      error[j][k] = soft[j] / (roots[j] * roots[j] * h / std::sqrt(12.0)) - 1;
    for (double residual : r.residuals) EXPECT_LT(residual, 1e-10);
  }
  for (int j = 0; j < 3; ++j) {
    EXPECT_NEAR(error[j][0] / error[j][1], 4, 0.3);
    EXPECT_LT(std::abs(error[j][0] + 4 * (error[j][1] - error[j][0]) / 3), 2e-4);
  }
}

TEST(Modes, TimoshenkoSimplySupported) {
  const double b = 0.05, h = 0.2, A = b * h, I = b * h * h * h / 12;
  for (int j = 1; j <= 3; ++j) {
    const double exact = std::sqrt(timoshenko(j, A, I, 5. / 6, 1 / 2.6));
    double error[2];
    for (int k = 0; k < 2; ++k) {
      const auto r = modes(simply_supported(rod(32 << k, b, h)), 30);
      ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
      error[k] = 1;
      for (double omega : r.omega)
        if (std::abs(omega / exact - 1) < std::abs(error[k])) error[k] = omega / exact - 1;
    }
    EXPECT_LT(std::abs(error[1]), 4e-3 * j * j / 9);
    EXPECT_NEAR(error[0] / error[1], 4, 0.2);
  }
}

TEST(Modes, FreeBeamHasItsRigidMotions) {
  Mechanism m;
  m.bodies.push_back({"beam", rod(20, 0.02, 0.01)});
  const auto spatial = modes(m, 8);
  ASSERT_EQ(spatial.report.status, kConverged) << spatial.report.reason;
  for (int j = 0; j < 6; ++j) EXPECT_EQ(spatial.omega[j], 0) << j;
  const double root = 4.7300407449, expected = root * root * 0.01 / std::sqrt(12.0);
  EXPECT_NEAR(spatial.omega[6] / expected, 1, 5e-3);
  Space<SE2> plane;
  const auto planar = modes<SE2>(m, 5, plane);
  ASSERT_EQ(planar.report.status, kConverged) << planar.report.reason;
  for (int j = 0; j < 3; ++j) EXPECT_EQ(planar.omega[j], 0) << j;
  EXPECT_NEAR(planar.omega[3] / (2 * expected), 1, 5e-3);
}

TEST(Modes, LongFreeBeamByLanczosHasItsRigidMotions) {
  Mechanism m;
  m.bodies.push_back({"beam", rod(100, 0.02, 0.01)});
  const auto r = modes(m, 8);
  ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
  for (int j = 0; j < 6; ++j) EXPECT_EQ(r.omega[j], 0) << j;
  const double root = 4.7300407449;
  EXPECT_NEAR(r.omega[6] / (root * root * 0.01 / std::sqrt(12.0)), 1, 5e-4);
}

/// A rigid body hinged at distance l from its centre of mass: omega^2 = m g l/(I + m l^2).
TEST(Modes, RigidPendulum) {
  const double g = 9.81, l = 0.4, mass = 3, I = 0.2;
  Mechanism m;
  m.gravity = {0, -g, 0};
  RigidSpec body;
  body.frame.x = {0, -l, 0};
  body.mass = mass;
  body.inertia = Vec3(0.1, 0.05, I).asDiagonal();
  m.bodies.push_back({"bob", body});
  JointSpec hinge;
  hinge.name = "hinge";
  hinge.type = JointType::Revolute;
  hinge.b = {0, 0, SE3(Mat3::Identity(), Vec3(0, l, 0))};
  m.joints.push_back(hinge);
  const double omega = std::sqrt(mass * g * l / (I + mass * l * l));
  const auto spatial = modes(m, 1);
  ASSERT_EQ(spatial.report.status, kConverged) << spatial.report.reason;
  ASSERT_EQ(spatial.omega.size(), 1u);
  EXPECT_NEAR(spatial.omega[0], omega, 1e-10);
  const auto planar = modes<SE2>(m, 3, *find_plane(m).plane);
  ASSERT_EQ(planar.omega.size(), 1u);
  EXPECT_NEAR(planar.omega[0], omega, 1e-10);
  EXPECT_NEAR(planar.frequency[0], omega / (2 * M_PI), 1e-10);

  m.gravity = {0, g, 0};  // upside down: unstable
  const auto inverted = modes(m, 1);
  ASSERT_EQ(inverted.report.status, kConverged) << inverted.report.reason;
  EXPECT_EQ(inverted.omega[0], 0);
  EXPECT_NEAR(inverted.eigenvalue[0], -omega * omega, 1e-9);
  EXPECT_FALSE(inverted.report.warnings.empty());
}

TEST(Modes, PlanarOnesAreAmongTheSpatialOnes) {
  Mechanism m = test::cantilever(rod(10, 0.03, 0.05));
  m.loads.push_back(test::tip_load(m, {0, 1e-7, 0}));  // bends it visibly
  const auto plane = find_plane(m);
  ASSERT_TRUE(plane.plane);
  const auto planar = modes<SE2>(m, 4, *plane.plane);
  const auto spatial = modes(m, 25);
  ASSERT_EQ(planar.report.status, kConverged) << planar.report.reason;
  ASSERT_EQ(spatial.report.status, kConverged) << spatial.report.reason;
  for (double omega : planar.omega) {
    double nearest = 1;
    for (double other : spatial.omega) nearest = std::min(nearest, std::abs(other / omega - 1));
    EXPECT_LT(nearest, 1e-9) << omega;
  }
}

/// A tension stiffens: pinned string-like beam, omega^2 = beta^4 EI + beta^2 N per mass.
TEST(Modes, PrestressedBeam) {
  const double b = 0.02, h = 0.01, A = b * h, I = b * h * h * h / 12, N = 2e-8;
  Mechanism m = simply_supported(rod(64, b, h));
  m.loads.push_back(test::tip_load(m, {N, 0, 0}));
  const auto r = modes(m, 1);
  ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
  const double beta2 = M_PI * M_PI;
  EXPECT_NEAR(r.eigenvalue[0] / ((I * beta2 * beta2 + N * beta2) / A), 1, 3e-3);
}

TEST(Modes, DenseAndLanczosAgree) {
  auto model = Model<SE3>::build(simply_supported(rod(30, 0.02, 0.01)), {});
  const SimulationOptions o = first(8);
  StaticNewton<SE3> newton(model, o);
  State<SE3> s = model.initial_state();
  const Eigen::SparseMatrix<double> A = newton.tangent(s);
  Eigen::SparseMatrix<double> M(model.size(), model.size());
  M.setIdentity();
  const auto dense = constrained_modes(A, M, 8, ModesMethod::Dense);
  const auto lanczos = constrained_modes(A, M, 8, ModesMethod::Lanczos);
  ASSERT_TRUE(dense.converged && lanczos.converged);
  for (int j = 0; j < 8; ++j) {
    EXPECT_NEAR(lanczos.lambda[j] / dense.lambda[j], 1, 1e-7) << j;
    EXPECT_LT(lanczos.residuals[j], 1e-11);
    EXPECT_LT(dense.residuals[j], 1e-10);
  }
}

TEST(Modes, ShapesAreMassNormalisedAndKeepTheJoints) {
  auto model = Model<SE3>::build(simply_supported(rod(60, 0.02, 0.01)), {});
  const auto r = solve_modes(model, first(5));
  ASSERT_EQ(r.report.status, kConverged) << r.report.reason;
  Eigen::VectorXd Mphi = Eigen::VectorXd::Zero(model.size());
  for (int i = 0; i < 5; ++i) {
    Mphi.setZero();
    model.bodies[0]->mass().multiply_add(r.shapes.col(i).data(), Mphi.data());
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(r.shapes.col(j).dot(Mphi), i == j ? 1 : 0, 1e-8) << i << j;
    EXPECT_LT(r.shapes.col(i).head<3>().norm(), 1e-9 * r.shapes.col(i).norm());
  }
}

}  // namespace
}  // namespace liesl::test::modes_test
