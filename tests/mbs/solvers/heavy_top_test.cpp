/// @file
/// Heavy top against Runge-Kutta values: order 2 in positions, velocities and multipliers.

#include "mbs/run.hpp"
#include "reference/published.hpp"

namespace liesl::test::heavy_top_test {
namespace {

struct Error {
  double x = 0, omega = 0, reaction = 0, energy = 0;
};

double largest(const Vec3& v) { return v.cwiseAbs().maxCoeff(); }

Error error_at(const test::Run<SE3>& r, const test::HeavyTopState& exact, double step) {
  const int i = r.at(exact.t, step);
  const SE3* H = r.trajectory().frames(i);
  const SE3::Tangent wrench = test::joint_wrench(*r.model, H, r.trajectory().lambda(i), 0);
  const Vec3 force = H->R * wrench.head<3>();
  EXPECT_NEAR(r.trajectory().time(i), exact.t, 1e-12);
  EXPECT_LT(wrench.tail<3>().norm(), 1e-9);
  return {largest(H->x - exact.x), largest(r.trajectory().v(i).tail<3>() - exact.omega),
          largest(force - exact.reaction),
          std::abs(test::total_energy(r, i) - test::heavy_top_energy)};
}

/// The published errors are those of screw motions.
TEST(HeavyTop, ErrorsAreThePublishedOnesAndOfSecondOrder) {
  Mechanism top = test::heavy_top();
  top.update = NodeUpdate::Screw;
  std::vector<Error> errors, half;
  for (const auto& row : test::heavy_top_errors) {
    const auto r = test::run_spatial(top, test::options(1, row.step, 0.9, 1e-9));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    errors.push_back(error_at(r, test::heavy_top_one, row.step));
    half.push_back(error_at(r, test::heavy_top_half, row.step));
    EXPECT_NEAR(errors.back().x, row.x, 0.01 * row.x);
    EXPECT_NEAR(errors.back().omega, row.omega, 0.01 * row.omega);
    EXPECT_NEAR(errors.back().reaction, row.reaction, 0.01 * row.reaction);
  }
  for (std::size_t i = 0; i + 1 < errors.size(); ++i)
    for (const auto part : {&Error::x, &Error::omega, &Error::reaction}) {
      EXPECT_NEAR(std::log2(errors[i].*part / errors[i + 1].*part), 2, 0.05);
      EXPECT_NEAR(std::log2(half[i].*part / half[i + 1].*part), 2, 0.05);
    }
  EXPECT_NEAR(std::log2(errors[1].energy / errors[2].energy), 2, 0.1);
  EXPECT_LT(errors[2].energy, 1e-3 * test::heavy_top_energy);
}

TEST(HeavyTop, StartsWithTheEnergyOfTheReference) {
  const auto r = test::run_spatial(test::heavy_top(), test::options(1e-3, 1e-3));
  EXPECT_NEAR(test::total_energy(r, 0), test::heavy_top_energy, 1e-9);
  EXPECT_LT(r.result.start.velocity_change, 1e-12);
  EXPECT_LT(r.result.start.moved, 1e-12);
}

}  // namespace
}  // namespace liesl::test::heavy_top_test
