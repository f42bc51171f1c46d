/// @file
/// The matrix of Newton's method against finite differences of the residual, with everything on it,
/// in statics and at states of a motion, for every formalism; products and solutions.

#include "mbs/solvers/iteration_matrix.hpp"

#include <gtest/gtest.h>

#include "mbs/every_joint.hpp"
#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/step_tangent.hpp"

namespace liesl::test::iteration_matrix_test {
namespace {

/// Two beams and a rigid body in the plane of x and y (or, with `tilt`, in space): joints with
/// multipliers, springs, an actuator, gravity, dead, follower and spread loads, ports off the
/// nodes.
Mechanism everything(bool spatial) {
  Mechanism m;
  m.gravity = {1, -9, spatial ? 2.0 : 0.0};
  const Section s = test::section((SE3::Tangent() << 90, 40, 50, 7, 8, 9).finished());
  m.bodies.push_back({"a", test::beam(straight({0, 0, 0}, {2, 0, 0}, 2), s)});
  m.bodies.push_back({"b", test::beam(straight({3, 1, 0}, {3, 3, 0}, 2), s)});
  RigidSpec block;
  block.frame.x = {2.5, 0.5, 0};
  block.mass = 2;
  block.inertia = Vec3(1, 2, 3).asDiagonal();
  block.centre = {0.1, 0.2, 0};
  m.bodies.push_back({"block", block});
  const auto off = [](double x, double y) { return SE3(Mat3::Identity(), Vec3(x, y, 0)); };
  JointSpec clamp, pin, slide;
  clamp.name = "clamp";
  clamp.b = {0, 0};
  pin.name = "pin";
  pin.type = spatial ? JointType::Universal : JointType::Revolute;
  pin.a = {0, 2};
  pin.b = {2, 0, off(-0.5, -0.5)};
  slide.name = "slide";
  slide.type = JointType::Cylindrical;
  slide.axis = Vec3::UnitX();
  slide.a = {2, 0, off(0.5, 0.5)};
  slide.b = {1, 0};
  m.joints = {clamp, pin, slide};
  ForceSpec turn, tie, push;
  turn.name = "turn";
  turn.joint = 1;
  turn.stiffness = 6;
  turn.rest = 0.3;
  tie.name = "tie";
  tie.a = {0, 1, off(0.1, 0.2)};
  tie.b = {1, 1};
  tie.stiffness = 11;
  tie.rest = 1;
  push.name = "push";
  push.joint = 2;
  push.force = TimeFunction::constant(4);
  m.forces = {turn, tie, push};
  LoadSpec dead, follower, spread;
  dead.port = {2, 0, off(0.3, -0.4)};
  dead.force = {5, 6, spatial ? 7.0 : 0.0};
  dead.moment = {spatial ? 3.0 : 0.0, 0, 8};
  follower = dead;
  follower.port = {1, 2};
  follower.follower = true;
  spread = dead;
  spread.port = {0, 0};
  spread.spread = true;
  m.loads = {dead, follower, spread};
  return m;
}

/// With elements of order 4, one beam under a dead load and moment per length, both under one that
/// follows.
Mechanism of_order_4(Mechanism m) {
  for (int b : {0, 1}) {
    std::get<BeamSpec>(m.bodies[std::size_t(b)].kind).order = 4;
    LoadSpec load = m.loads[2];
    load.port.body = b;
    load.follower = true;
    m.loads.push_back(load);
  }
  return m;
}

template <FrameGroup G>
void expect_tangent(const Space<G>& space, const Mechanism& mechanism) {
  const auto model = Model<G>::build(mechanism, space);
  const LoadLevel level{0.7, 0.7};
  State<G> s = model.initial_state();
  s.v.setZero();
  const auto turn = [](int k) {  // a state off every symmetry
    typename G::Tangent h;
    for (int i = 0; i < G::dim; ++i) h[i] = 0.2 * std::sin(1 + 2.3 * i + 1.7 * k);
    return h;
  };
  Eigen::VectorXd turns(model.size());
  for (int k = 0; k < model.nodes(); ++k) turns.segment<G::dim>(G::dim * k) = turn(k);
  model.retract(s, turns);
  for (int i = 0; i < s.lambda.size(); ++i) s.lambda[i] = 3 * std::cos(1 + i);
  Equations<G> eq(model);
  eq.observe(s, s.rows, s.rows);
  eq.evaluate(s, s.rows, level);
  IterationMatrix<G> system(model);
  system.take_prestress(eq, s);
  const Eigen::MatrixXd A = system.assemble(eq, s, level);
  EXPECT_EQ(Eigen::MatrixXd(system.assemble(eq, s, level)), A);  // the second time by index

  const int n = model.size(), m = model.constraints();
  const double h = 1e-6;
  Eigen::MatrixXd difference(n + m, n);
  for (int j = 0; j < n; ++j) {
    const auto at = [&](double step) {
      State<G> moved = s;
      model.retract(moved, step * Eigen::VectorXd::Unit(n, j));
      eq.evaluate(moved, s.rows, level);
      return (Eigen::VectorXd(n + m) << eq.r, eq.phi).finished();
    };
    difference.col(j) = (at(h) - at(-h)) / (2 * h);
  }
  EXPECT_LT((A.leftCols(n) - difference).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_EQ(A.topRightCorner(n, m), A.bottomLeftCorner(m, n).transpose());
  EXPECT_TRUE(A.bottomRightCorner(m, m).isZero(0));
}

TEST(StaticTangent, IsTheDerivativeInSpace) {
  expect_tangent<SE3>({}, everything(true));
  expect_tangent<SE3>({}, of_order_4(everything(true)));
}

TEST(StaticTangent, IsTheDerivativeInThePlane) {
  const auto plane = find_plane(everything(false));
  ASSERT_TRUE(plane.plane) << plane.reason;
  expect_tangent<SE2>(*plane.plane, everything(false));
  expect_tangent<SE2>(*plane.plane, of_order_4(everything(false)));
}

/// A drive brings a hinge to its position at the time asked for: the beam turns, nothing bends.
TEST(StaticTangent, DriveIsAtTheTimeAskedFor) {
  Mechanism m = test::cantilever(
      test::beam(straight({0, 0, 0}, {1, 0, 0}, 2), test::section(test::diagonal(10, 10, 10, 10))));
  m.joints[0].type = JointType::Revolute;
  DriveSpec drive;
  drive.motion = TimeFunction::table({0, 1}, {0.5, 5.5}, TimeFunction::Interpolation::Linear);
  m.drives.push_back(drive);
  SimulationOptions o = test::tight();
  o.load_steps = 2;
  for (const double at : {0.0, 0.4, 1.0}) {
    o.at = at;
    const auto solved = test::solve(m, o);
    ASSERT_EQ(solved.result.report.status, SolveStatus::Converged) << solved.result.report.reason;
    EXPECT_NEAR(solved.frame(2).x.x(), std::cos(0.5 + 5 * at), 1e-10);
    EXPECT_NEAR(solved.frame(2).x.y(), std::sin(0.5 + 5 * at), 1e-10);
  }
}

/// The same clamp twice: left out once, told, and the result is that of one.
TEST(StaticTangent, RedundantJointsAreLeftOut) {
  Mechanism m = test::bend45(4, 300);
  m.joints.push_back(m.joints[0]);
  m.joints[1].name = "again";
  const auto solved = test::solve(m);
  ASSERT_EQ(solved.result.report.status, SolveStatus::Converged) << solved.result.report.reason;
  EXPECT_FALSE(solved.result.report.warnings.empty());
  const Vec3 once = test::solve(test::bend45(4, 300)).frame(4).x;
  EXPECT_LT((solved.frame(4).x - once).norm(), 1e-9);
}

/// The same in motion: damping in beams, springs and hinges, a drive, velocities from the start.
Mechanism everything_in_motion(bool spatial, Formalism formalism) {
  Mechanism m = everything(spatial);
  m.formalism = formalism;
  for (int b : {0, 1}) std::get<BeamSpec>(m.bodies[std::size_t(b)].kind).damping = 0.02;
  for (auto& f : m.forces) f.damping = 0.7;
  m.joints[0].type = JointType::Revolute;
  DriveSpec drive;
  drive.motion = TimeFunction::rate(2, 0.1);
  m.drives.push_back(drive);
  return m;
}

template <class G>
class IterationMatrixTest : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(IterationMatrixTest, Groups);

constexpr Formalism kFormalisms[] = {Formalism::SE3, Formalism::R3SO3, Formalism::Classical,
                                     Formalism::Rigid};

TYPED_TEST(IterationMatrixTest, IsTheDerivativeOfTheResidualOfAStep) {
  using G = TypeParam;
  for (const Formalism formalism : kFormalisms) {
    const Mechanism m = everything_in_motion(G::space_dim == 3, formalism);
    const auto model = Model<G>::build(m, test::space_of<G>(m));
    test::StepTangent<G> step(model, test::options(1, 0.02), 12);
    step.expect_exact(to_string(formalism));
  }
}

/// Damped, and under loads per length that follow and turn.
TYPED_TEST(IterationMatrixTest, IsTheDerivativeForBeamsOfOrder4) {
  using G = TypeParam;
  const Mechanism m = of_order_4(everything_in_motion(G::space_dim == 3, Formalism::SE3));
  const auto model = Model<G>::build(m, test::space_of<G>(m));
  test::StepTangent<G> step(model, test::options(1, 0.02), 12);
  step.expect_exact("order 4");
}

/// Nodes with amplitudes, frames that follow, the convective forces of modes.
TYPED_TEST(IterationMatrixTest, IsTheDerivativeForFloatingFrames) {
  using G = TypeParam;
  const Mechanism m = everything_in_motion(G::space_dim == 3, Formalism::Floating);
  const auto model = Model<G>::build(m, test::space_of<G>(m));
  test::StepTangent<G> step(model, test::options(1, 0.02), 12);
  step.expect_exact("floating");
}

/// Of a step and of statics, in every formalism.
template <FrameGroup G>
void expect_exact_joint(const JointKind& kind, const Vec3& axis, const Vec3& axis2) {
  for (const Formalism formalism : kFormalisms) {
    Mechanism m = jointed(kind, axis, axis2);
    m.formalism = formalism;
    const std::string what = std::string(kind.name) + ", " + to_string(formalism);
    const auto model = Model<G>::build(m, Space<G>());
    test::StepTangent<G> step(model, test::options(1, 0.02, 0.8, 1e-9), 12);
    ASSERT_GT(step.state().v.norm(), 0.1) << what;
    step.expect_exact(what);
    test::expect_exact_statics(model, step.state(), {step.state().t, 1}, what);
  }
}

/// Every row of the table of joints, about axes that are none of the scene's.
TEST(EveryJoint, IterationMatrixIsTheDerivativeInSpace) {
  for (const JointKind& kind : joint_kinds())
    expect_exact_joint<SE3>(kind, Vec3(1, 2, 2) / 3, Vec3(2, 1, -2) / 3);
}

/// The axis normal to the plane, and in it; a screw leaves the plane.
TEST(EveryJoint, IterationMatrixIsTheDerivativeInThePlane) {
  for (const JointKind& kind : joint_kinds()) {
    if (kind.pitch) continue;
    expect_exact_joint<SE2>(kind, Vec3::UnitZ(), Vec3(0.6, 0.8, 0));
    expect_exact_joint<SE2>(kind, Vec3(0.6, 0.8, 0), Vec3::UnitZ());
  }
}

/// Componentwise backward error of A x = b: max_i |A x - b|_i / (|A| |x| + |b|)_i (Oettli, Prager
/// 1964). S has entries from 1 (constraints) to beta' M + K, so that a norm says little.
double backward_error(const Eigen::MatrixXd& A, const Eigen::MatrixXd& x,
                      const Eigen::MatrixXd& b) {
  const Eigen::MatrixXd size = A.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs();
  return ((A * x - b).cwiseAbs().array() / size.array()).maxCoeff();
}

/// <S a, b> = <a, S^T b>, and both solutions: with constraints, at a state of a motion.
TYPED_TEST(IterationMatrixTest, SolvesAndSolvesTransposed) {
  using G = TypeParam;
  const Mechanism m = everything_in_motion(G::space_dim == 3, Formalism::SE3);
  const auto model = Model<G>::build(m, test::space_of<G>(m));
  test::StepTangent<G> step(model, test::options(1, 0.02), 12);
  auto& S = step.matrix();
  ASSERT_GT(model.constraints(), 0);
  ASSERT_TRUE(S.factor());
  test::Random random{5};
  const int n = static_cast<int>(step.S().rows());
  Eigen::MatrixXd a(n, 3), b(n, 3);
  for (int j = 0; j < 3; ++j) {
    a.col(j) = random.vector(n);
    b.col(j) = random.vector(n);
  }
  Eigen::MatrixXd x = a, y = b;
  S.lu().solve(x);
  S.lu().solve_transposed(y);
  EXPECT_LT(backward_error(step.S(), x, a), 1e-12);
  EXPECT_LT(backward_error(step.S().transpose(), y, b), 1e-12);
  EXPECT_GT((step.S() * y - b).norm(), 1e-3 * b.norm()) << "S is not symmetric";
  const Eigen::MatrixXd one = a.transpose() * y, other = x.transpose() * b;  // a' S^-T b
  EXPECT_LT((one - other).norm(), 1e-10 * one.norm());
}

}  // namespace
}  // namespace liesl::test::iteration_matrix_test
