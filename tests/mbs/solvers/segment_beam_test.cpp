/// @file
/// Beams as chains of segments: tangents, energy, statics against closed forms and published
/// values, motion against the beam on the group.

#include "mbs/bodies/segment_beam.hpp"

#include "mbs/chains.hpp"
#include "mbs/run.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/solvers/simulation.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/step_tangent.hpp"

namespace liesl::test::segment_beam_test {
namespace {

/// A crank with a curved, damped rod of two sections under its weight, a spread and two point
/// loads, a spring to one of its inner nodes.
Mechanism machine() {
  Mechanism m = slider_crank({.elements = 4, .crank = 0.02, .rod = 0.016, .ramp = 0.02});
  for (std::size_t b : {0, 1})
    std::get<BeamSpec>(m.bodies[b].kind).material = {"plastic", 7e9, 0.3, 1200};
  auto& rod = std::get<BeamSpec>(m.bodies[1].kind);
  rod.nodes = arc(Arc::through({0.15, 0, 0}, {0.3, 0.02, 0}, {0.45, 0, 0}), 4);
  std::get<Circle>(rod.sections[2].shape).diameter = 0.012;
  rod.damping = 1e-5;
  m.gravity = {1, -9.81, 0};
  LoadSpec spread, push;
  spread.name = "spread";
  spread.port = {1, 0};
  spread.spread = true;
  spread.force = {3, -8, 0};
  push.name = "push";
  push.port = {1, 2};
  push.force = {-2, 5, 0};
  m.loads = {spread, push};
  ForceSpec spring;
  spring.name = "spring";
  spring.a = {-1, 0, SE3(Mat3::Identity(), {0.2, 0.3, 0})};
  spring.b = {1, 1};
  spring.stiffness = 300;
  spring.rest = 0.2;
  m.forces = {spring};
  return m;
}

TEST(SegmentBeam, TangentsAreExact) {
  for (const SegmentSpec& spec : kKinds) {
    const Mechanism m = segments(machine(), spec);
    const auto model = Model<SE2>::build(m, space_of<SE2>(m));
    StepTangent<SE2> tangent(model, options(0.02, 2e-4, 0.8, 1e-9), 40);
    tangent.expect_exact("motion");
    tangent.expect_transposed("motion");
    State<SE2> s = model.initial_state();
    Random random(3);
    Eigen::VectorXd h = 1e-2 * random.vector(model.size());
    for (const int k : model.positions()) h[3 * k + 2] = 0;
    model.retract(s, h);
    s.lambda = 100 * random.vector(model.constraints());
    expect_exact_statics(model, s, {0, 1}, "statics");
  }
}

/// A rigid motion of the whole makes no force, and the stiffness in the axes of the nodes is that
/// at rest.
TEST(SegmentBeam, DoesNotSeeRigidMotions) {
  for (const SegmentSpec& spec : kKinds) {
    const Mechanism m = segments(machine(), spec);
    const auto model = Model<SE2>::build(m, space_of<SE2>(m));
    const auto& body = *model.bodies[1];
    const SE2 moved = SE2::exp({0.7, -0.4, 2.3});
    std::vector<SE2> H;
    for (const SE2& at : body.reference) H.push_back(moved * at);
    for (int k = 1; k < body.elements(); ++k) H[k].R = SE2::exp({0, 0, 0.3}).R;
    body.turn_axes(H.data());
    for (int k = 0; k < body.nodes(); ++k)
      EXPECT_LT((H[k].R - (moved * body.reference[k]).R).norm(), 1e-12) << k;
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(body.size());
    const BodyState<SE2> s{H.data(), still.data(), still.data(), still.data()};
    Eigen::VectorXd r = still;
    ForceScale scale;
    body.add_internal(s, r.data(), scale);
    EXPECT_LT(r.norm(), 1e-9 * body.axial_stiffness());
    auto A = body.stiffness();
    body.exact_tangent(s, {0, 0}, {}, nullptr, A);
    for (int k = 0; k < A.blocks(); ++k)
      EXPECT_LT((A.D[k] - body.stiffness().D[k]).norm(), 1e-9 * body.stiffness().D[k].norm());
    for (std::size_t k = 0; k < A.U2.size(); ++k) {
      EXPECT_LT((A.U[k] - body.stiffness().U[k]).norm(), 1e-9 * body.stiffness().U[k].norm());
      EXPECT_LT((A.U2[k] - body.stiffness().U2[k]).norm(), 1e-9 * body.stiffness().D[k].norm());
    }
  }
}

/// A completed state completed again is itself; velocities are those of the positions.
TEST(SegmentBeam, CompletesItsAxesOnce) {
  const Mechanism m = segments(machine());
  const auto r = run_planar(m, options(0.02, 2e-4));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  State<SE2> s = r.model->initial_state(), again;
  r.trajectory().read(r.last(), s);
  again = s;
  r.model->complete(again);
  EXPECT_LT((again.v - s.v).norm(), 1e-10 * s.v.norm());
  EXPECT_LT((again.vdot - s.vdot).norm(), 1e-10 * s.vdot.norm());
  const int node = r.model->first_node(1) + 2;
  const double dt = 2e-4;  // the rate of its turn against the turn
  const auto angle = [&](int record) {
    const auto& R = r.trajectory().frames(record)[node].R;
    return std::atan2(R(1, 0), R(0, 0));
  };
  const double rate = (angle(r.last()) - angle(r.last() - 2)) / (2 * dt);
  EXPECT_NEAR(r.trajectory().v(r.last() - 1)[3 * node + 2], rate, 0.02 * std::abs(rate));
}

/// Neo-Hookean: N = EA/3 (l - 1/l^2) of an incompressible bar under its end force.
TEST(SegmentBeam, StretchesByItsPotential) {
  const double EA = 90, P = 60;
  Mechanism m =
      cantilever(beam(straight({0, 0, 0}, {2, 0, 0}, 4), section(diagonal(EA, EA, 1, 1))));
  m.loads = {tip_load(m, {P, 0, 0})};
  for (const auto potential : {AxialPotential::Linear, AxialPotential::NeoHookean}) {
    SCOPED_TRACE(int(potential));
    const auto r =
        solve<SE2>(segments(m, {potential, false}), tight(), *find_plane(roll_up(4)).plane);
    ASSERT_EQ(r.result.report.status, SolveStatus::Converged) << r.result.report.reason;
    const double l = r.frame(4).x.x() / 2;
    const double N =
        potential == AxialPotential::Linear ? EA * (l - 1) : EA / 3 * (l - 1 / (l * l));
    EXPECT_NEAR(N, P, 1e-8);
    EXPECT_GT(l, 1.5);
  }
}

/// A pure end moment closes it to a polygon whose nodes are on a circle: misalignments are equal.
TEST(SegmentBeam, RollsUp) {
  for (const int n : {4, 8}) {
    const auto r = solve<SE2>(segments(roll_up(n)), tight(), *find_plane(roll_up(n)).plane);
    ASSERT_EQ(r.result.report.status, SolveStatus::Converged) << r.result.report.reason;
    EXPECT_LT(r.frame(n).x.norm(), 1e-10) << n;
  }
}

/// Elastica (Mattiasson 1981), whose cantilever does not stretch: order 2, and the limit of fine
/// meshes and stiff axes.
TEST(SegmentBeam, BendsAsTheElastica) {
  const auto tip = [](double lambda, int n, double EA) -> Vec3 {
    Mechanism m =
        cantilever(beam(straight({0, 0, 0}, {1, 0, 0}, n), section(diagonal(EA, EA, 1, 1))));
    m.loads = {tip_load(m, {0, lambda, 0})};
    const auto r = solve<SE2>(segments(m), tight(), *find_plane(m).plane);
    EXPECT_EQ(r.result.report.status, SolveStatus::Converged) << r.result.report.reason;
    const SE3 H = r.frame(n);
    return {1 - H.x.x(), H.x.y(), std::atan2(H.R(1, 0), H.R(0, 0))};
  };
  const std::pair<double, Vec3> rows[] = {{1, {0.0564332363, 0.3017207738, 0.4613519497}},
                                          {2, {0.1606417208, 0.4934574804, 0.7817498316}},
                                          {5, {0.3876283607, 0.7137915236, 1.2153681176}},
                                          {10, {0.5549955978, 0.8106090249, 1.4302855388}}};
  for (const auto& [lambda, reference] : rows) {
    const auto stiff = [&, load = lambda](int n) {
      return Vec3(2 * tip(load, n, 2e5) - tip(load, n, 1e5));
    };
    const Vec3 a = stiff(16), b = stiff(32), c = stiff(64);
    const Vec3 limit = richardson(b, c) + (richardson(b, c) - richardson(a, b)) / 15;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(limit[i], reference[i], 1e-7) << lambda << ", " << i;
      EXPECT_NEAR(std::log2((a[i] - b[i]) / (b[i] - c[i])), 2, 0.05) << lambda << ", " << i;
    }
  }
}

/// Energy of a pendulum without dissipation, and of a damped one what its damping takes, to second
/// order in the step.
TEST(SegmentBeam, EnergyIsBalanced) {
  for (const SegmentSpec& spec : kKinds)
    for (const double damping : {0., 1e-4}) {
      Mechanism m = segments(pendulum(6), spec);
      std::get<BeamSpec>(m.bodies[0].kind).damping = damping;
      const auto unbalanced = [&](double step) {
        const auto r = run_planar(m, options(0.2, step, 1, 1e-10));
        EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
        Equations<SE2> equations(*r.model);
        return largest_energy_imbalance(
            r, step, [&](State<SE2>& s) { return power(*r.model, equations, s); });
      };
      const double coarse = unbalanced(2e-4), fine = unbalanced(1e-4);
      EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << damping << ": " << coarse << ", " << fine;
    }
}

/// One factorisation does for the whole motion: in the axes of the nodes the stiffness stays.
TEST(SegmentBeam, SliderCrankNeedsOneFactorisation) {
  const auto r = run_planar(segments(slider_crank({.elements = 8})), options(0.06, 1e-4));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  EXPECT_EQ(r.report().factorizations, std::vector<int>({1, 1, 1}));
  EXPECT_LE(double(r.report().newton_iterations), 3.5 * double(r.report().steps));
}

/// Bending of the rod: order 2 in the mesh.
TEST(SegmentBeam, SliderCrankConvergesWithOrderTwo) {
  const auto bend = [](int n) {
    const auto r = run_planar(segments(slider_crank({.elements = n})), options(0.06, 5e-5));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    return largest_chord_offset(r.trajectory(), n + 1, n);
  };
  const double a = bend(4), b = bend(8), c = bend(16);
  EXPECT_NEAR(std::log2((a - b) / (b - c)), 2, 0.2) << a << ", " << b << ", " << c;
}

/// In free vibration the errors of stiffness and consistent mass cancel to fourth order, so that
/// the order is seen at the tip of a heavy pendulum, in its static part.
TEST(SegmentBeam, PendulumConvergesWithOrderTwo) {
  const auto tip = [](int n) -> Eigen::Vector2d {
    const auto r = run_planar(segments(pendulum(n)), options(0.5, 5e-4, 0.8, 1e-9));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    return r.trajectory().frames(r.last())[n].x;
  };
  const auto a = tip(8), b = tip(16), c = tip(32);
  EXPECT_NEAR(std::log2((a - b).norm() / (b - c).norm()), 2, 0.3);
}

/// The difference to the beam with shear and rotary inertia falls with (radius/length)^2: a
/// cantilever of constant load over EI that swings under its weight, E and rho such that the motion
/// of the limit is one.
TEST(SegmentBeam, DiffersFromTheBeamOnTheGroupBySlendernessSquared) {
  const auto difference = [](double d) {
    const auto tip = [d](Formalism formalism, int n) -> Eigen::Vector2d {
      const double A = M_PI * d * d / 4, I = A * d * d / 16;
      Mechanism m;
      m.formalism = formalism;
      m.gravity = {0, -9.81, 0};
      m.gravity_scale = TimeFunction::expression("sin(2.5*pi*t)^2");  // strikes nothing
      m.bodies = {{"beam", straight_beam({0, 0, 0}, {1, 0, 0}, n, round_section(d, 0.9),
                                         {"soft", 5 / I, 0.3, 1 / A})}};
      m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
      const auto r = run_planar(m, options(0.2, 5e-4, 0.8, 1e-9));
      EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
      return r.trajectory().frames(r.last())[n].x;
    };
    const auto limit = [&](Formalism formalism) -> Eigen::Vector2d {
      return (4 * tip(formalism, 64) - tip(formalism, 32)) / 3;
    };
    return (limit(Formalism::Segments) - limit(Formalism::SE3)).norm();
  };
  const double a = difference(0.1), b = difference(0.05), c = difference(0.025);
  EXPECT_NEAR(std::log2(a / b), 2, 0.3) << a << ", " << b;
  EXPECT_NEAR(std::log2(b / c), 2, 0.3) << b << ", " << c;
}

/// With penalties and augmentations, too.
TEST(SegmentBeam, MovesWithEveryFormOfConstraints) {
  Mechanism m = segments(slider_crank({.elements = 4}));
  const auto exact = run_planar(m, options(0.04, 1e-4, 0.8, 1e-8));
  for (const auto form : {ConstraintForm::Penalty, ConstraintForm::Augmented}) {
    m.penalty.form = form;
    m.penalty.step = 1e-4;
    const auto r = run_planar(m, options(0.04, 1e-4, 0.8, 1e-8));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    EXPECT_LE(r.report().penalty.most_augmentations, 3);
    const double off =
        (r.trajectory().frames(r.last())[10].x - exact.trajectory().frames(exact.last())[10].x)
            .norm();
    EXPECT_LT(off, 1e-6) << to_string(form);
  }
}

/// Those of the cantilever of Euler and Bernoulli, and none of the rotations that inner nodes have
/// not: theirs would come before the fourth.
TEST(SegmentBeam, ModesAreThoseOfItsPositions) {
  Mechanism m = pendulum(32);
  m.joints[0].type = JointType::Fixed;
  const Space<SE2> plane = space_of<SE2>(m);
  m.gravity.setZero();
  SimulationOptions o;
  o.modes = 6;
  const auto chain = solve_modes(Model<SE2>::build(segments(m), plane), o);
  ASSERT_EQ(chain.report.status, SolveStatus::Converged) << chain.report.reason;
  ASSERT_EQ(chain.frequency.size(), 6u);
  const double radius = 0.01 / std::sqrt(12), speed = std::sqrt(5e8 / 7800);
  const double kL[] = {1.8751041, 4.6940911, 7.8547574, 10.9955407, 14.1371684, 17.2787597};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(chain.omega[i] / (kL[i] * kL[i] * radius * speed), 1, 0.02) << i;
}

/// Circular frequencies of a straight beam that bends, hardly with rotary inertia, clamped at its
/// start or pinned at both ends.
std::vector<double> bending_frequencies(int n, bool pinned, bool lumped, double EI, double mass) {
  constexpr double kStiff = 1e6, kRotary = 1e-8;
  Mechanism m = cantilever(
      beam(straight({0, 0, 0}, {1, 0, 0}, n),
           section(diagonal(kStiff, kStiff, EI, EI), diagonal(mass, mass, kRotary, kRotary))));
  if (pinned) {
    m.joints[0].type = JointType::Revolute;
    m.joints.push_back(
        {"other", JointType::Revolute, {-1, 0, SE3(Mat3::Identity(), {1, 0, 0})}, {0, n}});
  }
  SimulationOptions o;
  o.modes = 4;
  const auto found = solve_modes(Model<SE2>::build(segments(m, {AxialPotential::Linear, lumped}),
                                                   *find_plane(roll_up(4)).plane),
                                 o);
  EXPECT_EQ(found.report.status, SolveStatus::Converged) << found.report.reason;
  return {found.omega.begin(), found.omega.end()};
}

/// Pinned, closed form of the chain itself: omega_j^2 = EI/(rho A h^4) (2 - 2 cos theta)^2/g with
/// theta = j pi/n, g = (2 + cos theta)/3 of consistent mass, whose error is of fourth order, and 1
/// of lumped mass, of second order.
TEST(SegmentBeam, PinnedItVibratesAsItsClosedForm) {
  constexpr double EI = 3, mass = 0.7;
  for (const bool lumped : {false, true}) {
    std::vector<double> off;  // of the highest mode
    for (const int n : {8, 16, 32}) {
      const auto omega = bending_frequencies(n, true, lumped, EI, mass);
      ASSERT_EQ(omega.size(), 4u);
      for (std::size_t j = 0; j < 4; ++j) {
        const double mode = double(j + 1), theta = mode * M_PI / n,
                     g = lumped ? 1 : (2 + std::cos(theta)) / 3,
                     of_chain = std::sqrt(EI / mass / g) * (2 - 2 * std::cos(theta)) * n * n;
        EXPECT_NEAR(omega[j] / of_chain, 1, 2e-6) << n << ", mode " << mode;
      }
      off.push_back(std::abs(omega[3] / (std::pow(4 * M_PI, 2) * std::sqrt(EI / mass)) - 1));
    }
    EXPECT_NEAR(std::log2(off[1] / off[2]), lumped ? 2 : 4, 0.2);
  }
}

/// Clamped, with order 2 as Euler and Bernoulli say: cosh(kL) cos(kL) = -1.
TEST(SegmentBeam, ClampedItVibratesAsEulerAndBernoulliSayWithOrderTwo) {
  constexpr double EI = 3, mass = 0.7;
  const double kL[] = {1.87510406871196, 4.69409113297418, 7.85475743823761, 10.9955407348755};
  for (const bool lumped : {false, true}) {
    const auto a = bending_frequencies(16, false, lumped, EI, mass),
               b = bending_frequencies(32, false, lumped, EI, mass),
               c = bending_frequencies(64, false, lumped, EI, mass);
    ASSERT_EQ(c.size(), 4u);
    for (std::size_t j = 0; j < 4; ++j) {
      const double exact = kL[j] * kL[j] * std::sqrt(EI / mass);
      EXPECT_NEAR(std::log2((a[j] - exact) / (b[j] - exact)), 2, 0.1) << j;
      EXPECT_NEAR(std::log2((b[j] - exact) / (c[j] - exact)), 2, 0.1) << j;
      EXPECT_NEAR(richardson(b[j], c[j]) / exact, 1, 1e-4) << j;
    }
  }
}

TEST(SegmentBeam, WhatItCannotDoIsRefused) {
  Mechanism bolted = segments(pendulum(4));  // to a node that has no rotation
  bolted.bodies.push_back({"disc", block({0.5, 0, 0}, 1, 1)});
  bolted.joints.push_back({"bolt", JointType::Fixed, {0, 2}, {1, 0}});
  EXPECT_THROW(Model<SE2>::build(bolted, space_of<SE2>(bolted)), std::invalid_argument);
  bolted.joints.back().type = JointType::Revolute;
  EXPECT_NO_THROW(Model<SE2>::build(bolted, space_of<SE2>(bolted)));
  Mechanism coupled = segments(roll_up(4));
  auto& beam = std::get<BeamSpec>(coupled.bodies[0].kind);
  auto& full = std::get<FullSection>(beam.sections[1].shape);
  full.stiffness(0, 5) = full.stiffness(5, 0) = 1;
  EXPECT_THROW(Model<SE2>::build(coupled, space_of<SE2>(roll_up(4))), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::segment_beam_test
