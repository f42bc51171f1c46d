/// @file
/// The formalisms beside each other: the same limit, the same order, the known constants.

#include "mbs/run.hpp"
#include "reference/published.hpp"

namespace liesl::test::formalisms_test {
namespace {

Mechanism with(Mechanism m, Formalism f) {
  m.formalism = f;
  return m;
}

/// Largest error of the position of the heavy top at t = 1.
double top_error(Formalism f, double step, NodeUpdate update = NodeUpdate::AsFormalism) {
  Mechanism top = with(test::heavy_top(), f);
  top.update = update;
  const auto r = test::run_spatial(top, test::options(1, step, 0.9, 1e-9));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  return (r.trajectory().frames(r.last())->x - test::heavy_top_one.x).cwiseAbs().maxCoeff();
}

TEST(Formalisms, HeavyTopIsOfSecondOrderInAll) {
  for (const auto f : {Formalism::SE3, Formalism::R3SO3, Formalism::Classical}) {
    const double coarse = top_error(f, 2.5e-4), fine = top_error(f, 1.25e-4);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << to_string(f);
  }
}

TEST(Formalisms, TopByR3SO3HasTheSmallerConstant) {
  const double screw = top_error(Formalism::SE3, 1.25e-4, NodeUpdate::Screw);
  const double ratio = screw / top_error(Formalism::R3SO3, 1.25e-4);
  EXPECT_GT(ratio, 8);
  EXPECT_LT(ratio, 18);
}

Eigen::Vector2d pendulum_tip(Formalism f, int elements, double step) {
  const auto r =
      test::run_planar(with(test::pendulum(elements), f), test::options(0.5, step, 0.8, 1e-8));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  return r.trajectory().frames(r.last())[elements].x;
}

TEST(Formalisms, PendulumConvergesToTheSameMotion) {
  const Eigen::Vector2d exact = pendulum_tip(Formalism::SE3, 128, 2.5e-4);
  for (const auto f : {Formalism::SE3, Formalism::R3SO3, Formalism::Classical}) {
    const double coarse = (pendulum_tip(f, 16, 2.5e-4) - exact).norm();
    const double fine = (pendulum_tip(f, 64, 2.5e-4) - exact).norm();
    EXPECT_LT(fine, 2e-4) << to_string(f);
    EXPECT_LT(fine, coarse / 3) << to_string(f);
  }
}

/// A pendulum as a chain of segments comes with order 2 to its limit, which is that of beams with
/// shear and rotary inertia by rotations and displacements of their own but for (radius/length)^2:
/// bending stiffness and weight held, a quarter of it at half the side.
TEST(Formalisms, ChainsOfSegmentsComeToR3SO3) {
  const auto tip = [](Formalism f, double side, int n) -> Eigen::Vector2d {
    Mechanism m = with(test::pendulum(n), f);
    auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
    for (Section& s : beam.sections) s.shape = Rectangle{side, side};
    beam.material.E *= std::pow(0.01 / side, 2);
    m.gravity_scale = TimeFunction::expression("t < 0.2 ? sin(2.5*pi*t)^2 : 1");
    const auto r = test::run_planar(m, test::options(0.5, 1e-3, 0.8, 1e-9));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    return r.trajectory().frames(r.last())[n].x;
  };
  const auto chain = [&](double side, int n) { return tip(Formalism::Segments, side, n); };
  const auto apart = [&](double side) {
    const Eigen::Vector2d limit = (4 * chain(side, 64) - chain(side, 32)) / 3,
                          beam = (4 * tip(Formalism::R3SO3, side, 128) -
                                  tip(Formalism::R3SO3, side, 64)) /
                                 3;
    return (limit - beam).norm();
  };
  const double thick = apart(0.04), thin = apart(0.02);
  EXPECT_NEAR(std::log2(thick / thin), 2, 0.2);
  EXPECT_LT(thin, 2e-4);
  const Eigen::Vector2d a = chain(0.01, 16), b = chain(0.01, 32), c = chain(0.01, 64);
  EXPECT_NEAR(std::log2((a - b).norm() / (b - c).norm()), 2, 0.1);
}

TEST(Formalisms, ClassicalIsR3SO3InAPlane) {
  const auto a = pendulum_tip(Formalism::R3SO3, 8, 1e-3);
  const auto b = pendulum_tip(Formalism::Classical, 8, 1e-3);
  EXPECT_LT((a - b).norm(), 1e-5);
}

/// A stiff slider-crank, whose bending is small: largest midspan offset of the rod, m.
template <class G>
double largest_bend(const Mechanism& m, const Space<G>& space) {
  const auto r = test::run<G>(m, space, test::options(0.12, 1e-4, 0.8, 1e-7));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  double largest = 0;
  for (int i = 0; i < r.trajectory().size(); ++i) {
    const G* H = r.trajectory().frames(i) + r.model->first_node(1);
    const Eigen::VectorXd chord = (H[8].x - H[0].x).normalized(), mid = H[4].x - H[0].x;
    largest = std::max(largest, (mid - chord.dot(mid) * chord).norm());
  }
  return largest;
}

/// The slider-crank with a rod and a crank that many times as stiff.
Mechanism stiffer(double times) {
  Mechanism m = test::slider_crank({});
  for (auto& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->material.E *= times;
  return m;
}

TEST(Formalisms, AgreeOnTheBendingOfTheSliderCrank) {
  const Mechanism m = stiffer(1);
  const auto plane = *find_plane(m).plane;
  const double lie = largest_bend<SE3>(with(m, Formalism::SE3), {});
  for (const auto f : {Formalism::R3SO3, Formalism::Classical})
    EXPECT_NEAR(largest_bend<SE2>(with(m, f), plane), lie, 0.02 * lie) << to_string(f);
  EXPECT_NEAR(largest_bend<SE3>(with(m, Formalism::Floating), {}),
              largest_bend<SE2>(with(m, Formalism::Floating), plane), 1e-6 * lie);
  EXPECT_LT(largest_bend<SE2>(with(m, Formalism::Rigid), plane), 1e-12);
}

/// A body linear in its frame knows nothing of the axial force in its bending stiffness: it is off
/// by the ratio of that force to the buckling load.
TEST(Formalisms, FloatingFrameAgreesToFirstOrderInTheFlexibility) {
  const auto plane = *find_plane(stiffer(1)).plane;
  const auto off = [&](double times) {
    const Mechanism m = stiffer(times);
    const double lie = largest_bend<SE2>(with(m, Formalism::SE3), plane);
    return std::abs(largest_bend<SE2>(with(m, Formalism::Floating), plane) / lie - 1);
  };
  EXPECT_LT(off(1), 0.05);
  EXPECT_NEAR(std::log2(off(8) / off(32)) / 2, 1, 0.1);
}

TEST(Formalisms, RotationVectorsSurviveTurnsOnlyWhenRescaled) {
  Mechanism m = test::heavy_top();
  m.bodies[0].velocity.setZero();
  m.bodies[0].angular_velocity = Vec3(0, 0, 20);  // past six turns in 2 s
  m.bodies[0].velocity = Vec3(0, 0, 20).cross(Vec3(0, 1, 0));
  auto o = test::options(2, 2.5e-4, 0.9, 1e-8);
  const auto lie = test::run_spatial(m, o);
  ASSERT_EQ(lie.report().status, SolveStatus::Converged) << lie.report().reason;
  const Vec3 x = lie.trajectory().frames(lie.last())->x;
  m.formalism = Formalism::Classical;
  const auto rescaled = test::run_spatial(m, o);
  ASSERT_EQ(rescaled.report().status, SolveStatus::Converged) << rescaled.report().reason;
  EXPECT_LT((rescaled.trajectory().frames(rescaled.last())->x - x).norm(), 2e-2);
  o.rescale = false;
  const auto lost = test::run_spatial(m, o);
  EXPECT_EQ(lost.report().status, SolveStatus::NotConverged);
  EXPECT_NE(lost.report().reason.find("a rotation vector comes near 2 pi"), std::string::npos)
      << lost.report().reason;
  EXPECT_TRUE(lost.trajectory().v(lost.last()).allFinite());
}

}  // namespace
}  // namespace liesl::test::formalisms_test
