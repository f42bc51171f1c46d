/// @file
/// Small motions out of the plane of a motion: Euler's load, the growth beyond it, what stays.

#include "mbs/solvers/plane_stability.hpp"

#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"

namespace liesl::test::plane_stability_test {
namespace {

constexpr double kEI = 10, kInPlane = 4000, kMass = 2;  // N m^2, kg/m

/// A column along x that is soft out of the plane x-y, under a share of its Euler load.
Mechanism column(double share) {
  SE3::Tangent K, M;
  K << 1e7, 1e7, 1e7, 500, kEI, kInPlane;
  M << kMass, kMass, kMass, 1e-6, 5e-7, 5e-7;
  Mechanism m = cantilever(beam(straight({0, 0, 0}, {1, 0, 0}, 24), section(K, M)));
  m.loads = {tip_load(m, {-share * M_PI * M_PI * kEI / 4, 0, 0})};
  m.gravity = {0, -1e-9, 0};  // singles out the plane
  return m;
}

/// The growth out of the plane at the equilibrium under the load.
std::optional<double> growth(const Mechanism& m) {
  const auto model = Model<SE2>::build(m, space_of<SE2>(m));
  SimulationOptions o = tight();
  const auto found = solve_static(model, o);
  EXPECT_EQ(found.report.status, SolveStatus::Converged) << found.report.reason;
  State<SE2> s = model.initial_state();
  found.trajectory.read(found.trajectory.size() - 1, s);
  return PlaneStability(m, model).growth(s);
}

TEST(PlaneStability, BeginsAtEulersLoad) {
  const auto below = growth(column(0.99)), above = growth(column(1.01));
  ASSERT_TRUE(below && above);
  EXPECT_EQ(*below, 0);
  EXPECT_GT(*above, 0);
}

/// By Rayleigh's quotient of the buckling shape 1 - cos(pi x/2), exact to first order in
/// e = P/P_E - 1: omega^2 = -e (pi^2/4) (pi^2/8) / (3/2 - 4/pi) EI/m.
TEST(PlaneStability, GrowsAsTheColumnBuckles) {
  const double e = 0.03;
  const auto rate = growth(column(1 + e));
  ASSERT_TRUE(rate);
  const double slope = M_PI * M_PI / 4 * M_PI * M_PI / 8 / (1.5 - 4 / M_PI);
  EXPECT_NEAR(*rate / std::sqrt(e * slope * kEI / kMass), 1, 0.02);
}

/// Nothing grows in a slider-crank that runs, whose inertia presses and pulls its rod.
TEST(PlaneStability, MotionsOfStiffLinkagesStay) {
  const Mechanism m = slider_crank({4});
  const auto r = run_planar(m, options(0.08, 4e-4));
  PlaneStability stability(m, *r.model);
  State<SE2> s = r.model->initial_state();
  for (int i = 0; i < r.trajectory().size(); i += 10) {
    r.trajectory().read(i, s);
    const auto rate = stability.growth(s);
    ASSERT_TRUE(rate) << i;
    EXPECT_EQ(*rate, 0) << i;
  }
}

/// A rod so thin out of the plane that its inertia buckles it sideways.
TEST(PlaneStability, SlenderRodMayBuckle) {
  Mechanism m = slider_crank({4});
  auto& rod = std::get<BeamSpec>(m.bodies[1].kind);
  for (Section& s : rod.sections) s.shape = Rectangle{0.02, 0.001};
  const auto r = run_planar(m, options(0.08, 4e-4));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  PlaneStability stability(m, *r.model);
  State<SE2> s = r.model->initial_state();
  double fastest = 0;
  for (int i = 0; i < r.trajectory().size(); i += 10) {
    r.trajectory().read(i, s);
    fastest = std::max(fastest, stability.growth(s).value_or(-1));
  }
  EXPECT_GT(fastest, 10);
}

/// Bodies in floating frames have nodes that follow others: it is not told.
TEST(PlaneStability, SaysWhereItCannotTell) {
  Mechanism m = slider_crank({4});
  m.formalism = Formalism::Floating;
  const auto model = Model<SE2>::build(m, space_of<SE2>(m));
  EXPECT_FALSE(PlaneStability(m, model).growth(model.initial_state()));
}

}  // namespace
}  // namespace liesl::test::plane_stability_test
