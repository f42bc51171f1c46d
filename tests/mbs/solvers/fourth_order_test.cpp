/// @file
/// Orders of convergence of the beam of fourth order: statics, frequencies, motion.

#include <gtest/gtest.h>

#include <cmath>

#include "mbs/run.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/static_cases.hpp"
#include "reference/mechanisms.hpp"

namespace liesl::test::fourth_order_test {
namespace {

Mechanism of_order(Mechanism m, int order) {
  for (BodySpec& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->order = order;
  return m;
}

/// Slopes of the errors against `limit` over meshes each twice as fine.
void expect_order(const std::vector<Eigen::VectorXd>& values, const Eigen::VectorXd& limit,
                  double least, const std::string& what) {
  for (size_t i = 1; i < values.size(); ++i) {
    const double before = (values[i - 1] - limit).norm(), after = (values[i] - limit).norm();
    EXPECT_GE(std::log2(before / after), least) << what << ": " << before << " -> " << after;
  }
}

Mechanism elastica(int n) {
  Mechanism m = test::cantilever(
      test::beam(straight({0, 0, 0}, {1, 0, 0}, n), test::section(test::diagonal(1e5, 4e4, 2, 1))));
  m.loads.push_back(test::tip_load(m, {0, 6, 0}));
  return of_order(m, 4);
}

/// Out of the plane of a parabolic axis: bending, torsion, and a curvature that varies.
Mechanism parabola(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 16; ++i) points.push_back({i / 16.0, 0.5 * i * i / 256.0, 0});
  Mechanism m = test::cantilever(
      test::beam(spline(points, n), test::section(test::diagonal(1e5, 4e4, 2, 1))));
  m.loads.push_back(test::tip_load(m, {0.2, 1, 1.5}));
  return of_order(m, 4);
}

TEST(FourthOrder, StaticsConvergeWithTheFourthPower) {
  const std::pair<const char*, Mechanism (*)(int)> cases[] = {
      {"elastica", elastica},
      {"45 degree bend", [](int n) { return of_order(test::bend45(n, 600), 4); }},
      {"parabola", parabola}};
  for (const auto& [name, make] : cases) {
    std::vector<Eigen::VectorXd> tips;
    for (int n : {4, 8, 16}) tips.push_back(test::tip_displacement(make(n)));
    expect_order(tips, test::tip_displacement(make(128)), 3.8, name);
  }
}

/// Against the limit of fine meshes of second order, extrapolated (mbs/solvers/statics_test.cpp).
TEST(FourthOrder, FourElementsBendTo45DegreesWithin2e4) {
  const Vec3 tip = test::tip_displacement(of_order(test::bend45(4, 600), 4));
  EXPECT_LT((tip - Vec3(-23.5602396, -13.6045213, 53.4748588)).norm(), 0.02);
  const auto solved = test::solve(of_order(test::bend45(8, 600), 4));
  EXPECT_EQ(solved.result.report.steps, 1) << "in one load step";
}

TEST(FourthOrder, RollUpIsExact) {
  for (int n : {3, 5, 10}) {
    const auto spatial = test::solve(of_order(test::roll_up(n), 4));
    ASSERT_EQ(spatial.result.report.status, SolveStatus::Converged) << spatial.result.report.reason;
    EXPECT_EQ(spatial.result.report.steps, 1);
    EXPECT_LT(spatial.frame(n).x.norm(), 1e-11) << n;
    const auto plane = find_plane(of_order(test::roll_up(n), 4));
    const auto planar =
        test::solve<SE2>(of_order(test::roll_up(n), 4), test::tight(), *plane.plane);
    ASSERT_EQ(planar.result.report.status, SolveStatus::Converged) << planar.result.report.reason;
    EXPECT_LT(planar.frame(n).x.norm(), 1e-11) << n;
  }
}

/// A dead load along the axis and weight are exact in the shares: the deflection of a cantilever
/// under q is q L^4/(8 EI) + q L^2/(2 GA) at the tip of any mesh.
TEST(FourthOrder, SpreadLoadsAndWeightHaveTheirClosedForm) {
  const double L = 2, EI = 50, GA = 300, q = 1e-7;
  for (const bool weight : {false, true})
    for (int n : {1, 2, 5}) {
      Mechanism m =
          of_order(test::cantilever(test::beam(straight({0, 0, 0}, {L, 0, 0}, n),
                                               test::section(test::diagonal(1e3, GA, 40, EI)))),
                   4);
      if (weight) {
        m.gravity = {0, q, 0};
      } else {
        LoadSpec load = test::tip_load(m, {0, q, 0});
        load.spread = true;
        m.loads.push_back(load);
      }
      const double tip = q * std::pow(L, 4) / (8 * EI) + q * L * L / (2 * GA);
      EXPECT_NEAR(test::tip_displacement(m).y() / tip, 1, 1e-7) << n << weight;
    }
}

struct Cantilever {
  double length;
  SE3::Tangent stiffness, inertia;
};

Eigen::VectorXd frequencies(int n, const Cantilever& c) {
  Mechanism m = of_order(test::cantilever(test::beam(straight({0, 0, 0}, {c.length, 0, 0}, n),
                                                     test::section(c.stiffness, c.inertia))),
                         4);
  SimulationOptions o = test::tight();
  o.type = SimulationType::Modes;
  o.modes = 6;
  const auto modes = solve_modes(Model<SE3>::build(m, {}), o);
  EXPECT_EQ(modes.report.status, SolveStatus::Converged) << modes.report.reason;
  return Eigen::Map<const Eigen::VectorXd>(modes.omega.data(), 6);
}

/// Bending, torsion and tension of a slender cantilever, and of a sandwich, whose elements bend by
/// shear and by bending alike while its sections are heavy to turn: all with the fourth power.
TEST(FourthOrder, FrequenciesConvergeWithTheFourthPower) {
  const auto six = [](double a, double b, double c, double d, double e, double f) -> SE3::Tangent {
    return (SE3::Tangent() << a, b, c, d, e, f).finished();
  };
  const Cantilever cases[] = {{1, six(1e4, 3e3, 3e3, 2, 2, 3), six(1, 1, 1, 5e-4, 2e-4, 3e-4)},
                              {1, six(1e4, 3e3, 3e3, 2, 2, 2.2), six(1, 1, 1, 4e-3, 2e-3, 2e-3)}};
  for (const Cantilever& of : cases) {
    const Eigen::VectorXd limit = frequencies(192, of), coarse = frequencies(6, of),
                          middle = frequencies(24, of), fine = frequencies(48, of);
    for (int i = 0; i < 6; ++i) {
      const double before = std::abs(middle[i] - limit[i]), after = std::abs(fine[i] - limit[i]);
      EXPECT_GE(std::log2(before / after), 3.8) << "mode " << i << " at " << limit[i];
      EXPECT_LT(std::abs(coarse[i] - limit[i]), 0.02 * limit[i]);
    }
  }
}

/// Tip of the pendulum and bending of the slider-crank's rod over time, at one step size: what is
/// left of the difference is the mesh.
template <FrameGroup G>
Eigen::VectorXd motion(const Mechanism& m, const SimulationOptions& o, int node) {
  const auto run = test::run<G>(m, test::space_of<G>(m), o);
  EXPECT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  const auto& t = run.trajectory();
  Eigen::VectorXd x(2 * t.size());
  for (int i = 0; i < t.size(); ++i) x.segment<2>(2 * i) = t.frames(i)[node].x.template head<2>();
  return x / std::sqrt(t.size());
}

/// The pendulum of the scenes is let go at once, which starts waves of every length; here its
/// weight grows smoothly.
Mechanism smooth_pendulum(int n) {
  Mechanism m = of_order(test::pendulum(n), 4);
  m.gravity_scale =
      TimeFunction::expression("t<0.2 ? (t/0.2)^4*(35-84*(t/0.2)+70*(t/0.2)^2-20*(t/0.2)^3) : 1");
  return m;
}

template <FrameGroup G>
void expect_order_of_the_pendulum() {
  const auto tip = [](int n) {
    return motion<G>(smooth_pendulum(n), test::options(0.5, 1e-3, 0.8, 1e-10), n);
  };
  expect_order({tip(8), tip(16), tip(32)}, tip(64), 3.8, "pendulum");
}
TEST(FourthOrder, MotionOfThePendulumConvergesWithTheFourthPower) {
  expect_order_of_the_pendulum<SE2>();
}
TEST(FourthOrderSlow, MotionOfThePendulumInSpaceConvergesWithTheFourthPower) {
  expect_order_of_the_pendulum<SE3>();
}

TEST(FourthOrder, PendulumThatIsLetGoConvergesWithTheThirdPower) {
  const auto tip = [](int n) {
    return motion<SE2>(of_order(test::pendulum(n), 4), test::options(0.5, 1e-3, 0.8, 1e-10), n);
  };
  expect_order({tip(4), tip(8), tip(16)}, tip(64), 3, "pendulum");
}

/// Two elements a link are within 1e-6 m, as 16 to 32 of second order are. From 4 to 8 the order is
/// 3.9; 16 are within 4e-10 m, where the iteration ends.
TEST(FourthOrder, MotionOfTheSliderCrankConvergesWithTheFourthPower) {
  const auto middle = [](int n) {
    test::SliderCrank p;
    p.elements = n;
    return motion<SE2>(of_order(test::slider_crank(p), 4), test::options(0.06, 1e-4, 0.8, 1e-10),
                       n + 1 + n / 2);
  };
  const Eigen::VectorXd limit = middle(64);
  EXPECT_LT((middle(2) - limit).norm(), 1e-6);
  EXPECT_LT((middle(16) - limit).norm(), 1e-9);
  expect_order({middle(4), middle(8)}, limit, 3.8, "slider-crank");
}

/// Damped, it converges to the motion of damped elements of order 2, with the fourth power.
TEST(FourthOrder, DampedMotionConvergesWithTheFourthPower) {
  const auto tip = [](int n, int order) {
    Mechanism m = smooth_pendulum(n);
    auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
    beam.order = order;
    beam.damping = 2e-3;
    return motion<SE2>(m, test::options(0.5, 1e-3, 0.8, 1e-10), n);
  };
  const Eigen::VectorXd limit = tip(64, 4), coarse = tip(64, 2), fine = tip(128, 2);
  expect_order({tip(8, 4), tip(16, 4), tip(32, 4)}, limit, 3.8, "damped pendulum");
  EXPECT_GT(
      (tip(64, 4) - motion<SE2>(smooth_pendulum(64), test::options(0.5, 1e-3, 0.8, 1e-10), 64))
          .norm(),
      100 * (test::richardson(coarse, fine) - limit).norm());
}

TEST(FourthOrder, RefusesWhatItCannotDo) {
  Mechanism m = elastica(4);
  m.formalism = Formalism::R3SO3;
  EXPECT_THROW(Model<SE3>::build(m, {}), std::invalid_argument);
  m = elastica(4);
  std::get<BeamSpec>(m.bodies[0].kind).as = BeamModel::Modal;
  EXPECT_THROW(Model<SE3>::build(m, {}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::fourth_order_test
