/// @file
/// Spin-up, flexible pendulum and free-flying beam against published values.

#include "mbs/run.hpp"
#include "reference/published.hpp"

namespace liesl::test::beam_motion_test {
namespace {

/// Largest lag of the tip behind the turning axis, and the extension at the end.
struct SpinUp {
  double lag = 0, at = 0, extension = 0;
};
SpinUp spin_up(int n, double step) {
  const auto m = test::spin_up(n);
  const auto r = test::run_planar(m, test::options(20, step));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  SpinUp out;
  double sum = 0;
  int count = 0;
  for (int i = 0; i < r.trajectory().size(); ++i) {
    const double t = r.trajectory().time(i), psi = m.drives[0].motion(t);
    const Eigen::Vector2d tip = r.trajectory().frames(i)[n].x;
    const double lag = -(-std::sin(psi) * tip.x() + std::cos(psi) * tip.y());
    if (lag > out.lag) out.lag = lag, out.at = t;
    if (t >= 15) sum += std::cos(psi) * tip.x() + std::sin(psi) * tip.y() - 10, ++count;
  }
  out.extension = sum / count;
  return out;
}

TEST(SpinUp, FiveElements) {
  const SpinUp s = spin_up(5, 2e-3);
  EXPECT_NEAR(s.lag, test::spin_up_lag_5, 1.5e-4);  // 0.56553 for every small step
  EXPECT_NEAR(s.at, 6.75, 0.05);
}

TEST(SpinUp, ConvergesToTheReference) {
  const SpinUp s = spin_up(40, 2e-3);
  EXPECT_NEAR(s.lag, test::spin_up_lag, 3e-4);
  EXPECT_NEAR(s.extension, test::spin_up_extension, 2e-3 * test::spin_up_extension);
}

void expect_tips(const test::PendulumTips& row, double tolerance) {
  const auto r = test::run_planar(test::pendulum(row.elements), test::options(1, row.step));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  const auto tip = [&](double t) {
    return r.trajectory().frames(r.at(t, row.step))[row.elements].x;
  };
  EXPECT_LT((tip(0.5) - row.half).cwiseAbs().maxCoeff(), tolerance) << tip(0.5).transpose();
  EXPECT_LT((tip(1.0) - row.one).cwiseAbs().maxCoeff(), tolerance) << tip(1.0).transpose();
}

TEST(Pendulum, SixteenElements) { expect_tips(test::pendulum_coarse, 1e-5); }
TEST(Pendulum, SixtyFourElements) { expect_tips(test::pendulum_fine, 1e-5); }

Vec3 momentum(const Model<SE3>& model, const Trajectory<SE3>& trajectory, int record) {
  Eigen::VectorXd local = Eigen::VectorXd::Zero(model.size());
  const Eigen::VectorXd v = trajectory.v(record);
  model.bodies[0]->mass().multiply_add(v.data(), local.data());
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < model.nodes(); ++k)
    sum += trajectory.frames(record)[k].R * local.segment<3>(6 * k);
  return sum;
}

test::Run<SE3> flying_beam(int n, double step, double duration) {
  auto r = test::run_spatial(test::flying_beam(n), test::options(duration, step, 0.9, 1e-8));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  return r;
}

TEST(FlyingBeam, MeetsThePublishedPositions) {
  const double h = 1e-2;
  const auto coarse = flying_beam(16, h, 5), fine = flying_beam(32, h, 5);
  for (const auto& row : test::flying_beam_states) {
    const int i = fine.at(row.t, h);
    const SE3 *C = coarse.trajectory().frames(i), *F = fine.trajectory().frames(i);
    const Vec3 A = F[0].x + (F[0].x - C[0].x) / 3;  // second order in the mesh
    const Vec3 B = F[32].x + (F[32].x - C[16].x) / 3;
    EXPECT_LT((A - row.A).cwiseAbs().maxCoeff(), 1.5e-3) << A.transpose();
    EXPECT_LT((B - row.B).cwiseAbs().maxCoeff(), 1.5e-3) << B.transpose();
  }
}

/// |p - 50| at 8 s, three seconds after the push.
double momentum_drift(int n, double step) {
  const auto r = flying_beam(n, step, 8);
  return (momentum(*r.model, r.trajectory(), r.last()) - Vec3(50, 0, 0)).norm();
}

TEST(FlyingBeam, LinearMomentumDriftsWithTheSquareOfTheStep) {
  const double a = momentum_drift(64, 0.02), b = momentum_drift(64, 0.01);
  EXPECT_NEAR(std::log2(a / b), 2, 0.1) << a << " " << b;
}

/// What the constant mass matrix leaves of the momentum of a bent element goes with its length.
TEST(FlyingBeam, LinearMomentumDriftsWithTheSquareOfTheElementLength) {
  const double a = momentum_drift(8, 2.5e-3), b = momentum_drift(16, 2.5e-3);
  EXPECT_NEAR(std::log2(a / b), 2, 0.1) << a << " " << b;
}

}  // namespace
}  // namespace liesl::test::beam_motion_test
