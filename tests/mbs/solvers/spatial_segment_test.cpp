/// @file
/// Chains of segments in space: tangents, energy, statics against the elastica, motion against the
/// beam on the group. Planar ones in space are in tests/mbs/system/planar_spatial_test.cpp.

#include "mbs/bodies/spatial_segment_beam.hpp"
#include "mbs/chains.hpp"
#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/step_tangent.hpp"
#include "mbs/system/parameter_residual.hpp"

namespace liesl::test::spatial_segment_test {
namespace {

/// A rod of two sections on a spherical joint, thrown about, another bolted to its end across it
/// with a block at its own, under their weight, a spread and two point loads, a spring to an inner
/// node.
Mechanism machine() {
  const Material plastic{"plastic", 7e9, 0.3, 1200};
  const Vec3 end(0.3, 0.2, -0.1), tip(0.3, 0.1, -0.3);
  Mechanism m;
  m.bodies = {{"rod", straight_beam({0, 0, 0}, end, 4, round_section(0.016, 0.9), plastic)},
              {"arm", straight_beam(end, tip, 3, round_section(0.012, 0.9), plastic)},
              {"block", block(tip, 0.1, 1e-4)}};
  auto& rod = std::get<BeamSpec>(m.bodies[0].kind);
  std::get<Circle>(rod.sections[2].shape).diameter = 0.012;
  m.joints = {{"ball", JointType::Spherical, {}, {0, 0}},
              {"bolt", JointType::Fixed, {0, 4}, {1, 0}},
              {"held", JointType::Fixed, {1, 3}, {2, 0}}};
  m.gravity = {1, -9.81, 3};
  LoadSpec spread, push;
  spread.name = "spread";
  spread.port = {0, 0};
  spread.spread = true;
  spread.force = {3, -8, 5};
  push.name = "push";
  push.port = {0, 2};
  push.force = {-2, 5, -4};
  LoadSpec turn = push;
  turn.name = "turn";
  turn.port = {2, 0};
  turn.moment = {0.1, 0.2, -0.1};
  m.loads = {spread, push, turn};
  ForceSpec spring;
  spring.name = "spring";
  spring.a = {-1, 0, SE3(Mat3::Identity(), {0.2, 0.3, 0.2})};
  spring.b = {0, 1};
  spring.stiffness = 300;
  spring.rest = 0.2;
  m.forces = {spring};
  return m;
}

/// Columns that are unknowns, in statics but the spins of the ends, which a stiffness holds.
std::vector<int> free_of_spins(const Model<SE3>& model) {
  std::vector<int> out = unknowns(model);
  std::erase_if(out, [&](int column) {
    for (std::size_t b = 0; b < 2; ++b) {
      const int first = 6 * model.first_node(int(b)), last = first + model.bodies[b]->size() - 6;
      if (column == first + 3 || column == last + 3) return true;
    }
    return false;
  });
  return out;
}

TEST(SpatialSegmentBeam, TangentsAreExact) {
  for (const SegmentSpec& spec : kKinds) {
    const Mechanism m = segments(machine(), spec);
    const auto model = Model<SE3>::build(m, {});
    StepTangent<SE3> tangent(model, options(0.02, 2e-4, 0.8, 1e-9), 40);
    ASSERT_GT(tangent.state().v.norm(), 0.1);
    tangent.expect_exact("motion");
    tangent.expect_transposed("motion");
    State<SE3> s = model.initial_state();
    Random random(3);
    Eigen::VectorXd h = 1e-2 * random.vector(model.size());
    for (const int k : model.positions()) h.segment<3>(6 * k + 3).setZero();
    model.retract(s, h);
    s.lambda = 100 * random.vector(model.constraints());
    expect_exact_statics(model, s, {0, 1}, "statics", kAllColumns, free_of_spins(model));
  }
}

/// Bent far, too, where the series of the angle gives way to the arc tangent.
TEST(SpatialSegmentBeam, TangentsAreExactWhereItIsBentFar) {
  const Mechanism m = segments(machine());
  const auto model = Model<SE3>::build(m, {});
  State<SE3> s = model.initial_state();
  Random random(5);
  for (const int k : model.positions()) s.H[std::size_t(k)].x += 0.06 * random.vector(3);
  double largest = 0;
  for (int k = 1; k < 4; ++k) {
    const auto d = [&](int e) -> Vec3 { return s.H[std::size_t(e + 1)].x - s.H[std::size_t(e)].x; };
    largest = std::max(largest, std::acos(d(k - 1).normalized().dot(d(k).normalized())));
  }
  EXPECT_GT(largest, 0.7);
  expect_exact_statics(model, s, {0, 1}, "statics", kAllColumns, free_of_spins(model));
}

/// A rigid motion of the whole makes no force, and the stiffness in the axes of the nodes is that
/// at rest.
TEST(SpatialSegmentBeam, DoesNotSeeRigidMotions) {
  for (const SegmentSpec& spec : kKinds) {
    const Mechanism m = segments(machine(), spec);
    const auto model = Model<SE3>::build(m, {});
    const auto& body = *model.bodies[0];
    SE3::Tangent motion;
    motion << 0.7, -0.4, 0.3, 1.5, -0.9, 1.7;
    const SE3 moved = SE3::exp(motion);
    std::vector<SE3> H;
    for (const SE3& at : body.reference) H.push_back(moved * at);
    for (int k = 1; k < body.elements(); ++k) H[std::size_t(k)].R = SO3::exp({0.2, 0.3, 0.1}).R;
    body.turn_axes(H.data());
    for (int k = 0; k < body.nodes(); ++k) {
      const auto at = std::size_t(k);
      EXPECT_LT((H[at].R - (moved * body.reference[at]).R).norm(), 1e-12) << k;
    }
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(body.size());
    const BodyState<SE3> s{H.data(), still.data(), still.data(), still.data()};
    Eigen::VectorXd r = still;
    ForceScale scale;
    body.add_internal(s, r.data(), scale);
    EXPECT_LT(r.norm(), 1e-9 * body.axial_stiffness());
    auto A = body.stiffness();
    body.exact_tangent(s, {0, 0, 0}, {}, nullptr, A);
    for (std::size_t k = 0; k < A.D.size(); ++k) {
      const double size = body.stiffness().D[k].norm();
      EXPECT_LT((A.D[k] - body.stiffness().D[k]).norm(), 1e-9 * size) << k;
      EXPECT_LT((A.D[k] - A.D[k].transpose()).norm(), 1e-9 * size) << k;
      if (k < A.U2.size()) {
        EXPECT_LT((A.U[k] - body.stiffness().U[k]).norm(), 1e-9 * size) << k;
        EXPECT_LT((A.U2[k] - body.stiffness().U2[k]).norm(), 1e-9 * size) << k;
      }
    }
  }
}

/// Its forces are the derivatives of its energy, and add up to no force and no moment; none turns
/// an end about its axis.
TEST(SpatialSegmentBeam, ForcesComeFromItsEnergy) {
  for (const SegmentSpec& spec : kKinds) {
    const Mechanism m = segments(machine(), spec);
    const auto model = Model<SE3>::build(m, {});
    const auto& body = *model.bodies[0];
    State<SE3> s = model.initial_state();
    Random random(7);
    Eigen::VectorXd h = 2e-2 * random.vector(model.size());
    for (const int k : model.positions()) h.segment<3>(6 * k + 3).setZero();
    model.retract(s, h);
    Eigen::VectorXd r = Eigen::VectorXd::Zero(body.size());
    ForceScale scale;
    body.add_internal(model.body_state(s, 0), r.data(), scale);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (int k = 0; k < body.nodes(); ++k) {
      const SE3& H = s.H[std::size_t(k)];
      const Vec3 f = H.R * r.segment<3>(6 * k);
      force += f;
      moment += H.x.cross(f) + H.R * r.segment<3>(6 * k + 3);
    }
    EXPECT_LT(force.norm(), 1e-12 * r.norm());
    EXPECT_LT(moment.norm(), 1e-12 * r.norm());
    EXPECT_EQ(r[3], 0);
    EXPECT_EQ(r[body.size() - 3], 0);
    const auto energy = [&](int i, double change) {
      State<SE3> at = s;
      Eigen::VectorXd delta = Eigen::VectorXd::Zero(model.size());
      delta[i] = change;
      model.retract(at, delta);
      return body.energy(model.body_state(at, 0), Vec3::Zero()).elastic;
    };
    for (int i = 0; i < body.size(); ++i) {
      const double step = 1e-5;
      const double a = (energy(i, step) - energy(i, -step)) / (2 * step),
                   b = (energy(i, 2 * step) - energy(i, -2 * step)) / (4 * step);
      EXPECT_NEAR((4 * a - b) / 3, r[i], 1e-7 * r.norm()) << i;
    }
  }
}

/// A completed state completed again is itself; rates of the axes are those of their turns.
TEST(SpatialSegmentBeam, CompletesItsAxesOnce) {
  const Mechanism m = segments(machine());
  const auto r = run_spatial(m, options(0.02, 2e-4));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  State<SE3> s = r.model->initial_state(), again;
  r.trajectory().read(r.last(), s);
  again = s;
  r.model->complete(again);
  EXPECT_LT((again.v - s.v).norm(), 1e-10 * s.v.norm());
  EXPECT_LT((again.vdot - s.vdot).norm(), 1e-10 * s.vdot.norm());
  Eigen::VectorXd way = s.v;
  for (const int k : r.model->positions()) way.segment<3>(6 * k + 3).setZero();
  const auto moved = [&](double time) {
    State<SE3> at = s;
    r.model->retract(at, time * way);
    r.model->complete(at);
    return at.H;
  };
  const double step = 1e-6;
  const auto before = moved(-step), after = moved(step);
  for (const int k : r.model->positions()) {
    const auto at = std::size_t(k);
    const Vec3 turn = SO3::log(Mat3(before[at].R.transpose() * after[at].R)) / (2 * step);
    const Vec3 w = s.v.segment<3>(6 * k + 3);
    EXPECT_GT(w.norm(), 0.1) << k;
    EXPECT_LT((turn - w).norm(), 1e-7 * w.norm()) << turn.transpose() << ", " << w.transpose();
  }
}

/// Elastica (Mattiasson 1981) under a force askew to both axes of the sections: order 2, in the
/// plane of the force, and the limit of fine meshes and stiff axes.
TEST(SpatialSegmentBeam, BendsAsTheElasticaInAnyDirection) {
  const Vec3 across(0, std::cos(0.7), std::sin(0.7)), normal = Vec3::UnitX().cross(across);
  const auto tip = [&](double lambda, int n, double EA) -> Vec3 {
    Mechanism m =
        cantilever(beam(straight({0, 0, 0}, {1, 0, 0}, n), section(diagonal(EA, EA, 1, 1))));
    m.loads = {tip_load(m, lambda * across)};
    const auto r = solve<SE3>(segments(m), tight());
    EXPECT_EQ(r.result.report.status, SolveStatus::Converged) << r.result.report.reason;
    const SE3 H = r.frame(n);
    EXPECT_LT(std::abs(H.x.dot(normal)), 1e-10);
    return {1 - H.x.x(), H.x.dot(across), std::atan2(H.R.col(0).dot(across), H.R(0, 0))};
  };
  const std::pair<double, Vec3> rows[] = {{1, {0.0564332363, 0.3017207738, 0.4613519497}},
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

/// Newton's method goes about moments that are extrapolated, too: as many corrections as in a plane
/// but for one at round-off, and few where it bends in both directions.
TEST(SpatialSegmentBeam, StaticsTakeAsManyCorrectionsAsInThePlane) {
  const auto corrections = []<class G>(const Mechanism& m) {
    auto o = tight();
    o.max_iterations = 60;
    const auto model = Model<G>::build(m, space_of<G>(m));
    const auto report = solve_static(model, o).report;
    EXPECT_EQ(report.status, SolveStatus::Converged) << report.reason;
    EXPECT_EQ(report.steps, 1);
    return report.newton_iterations;
  };
  Mechanism bent =
      cantilever(beam(straight({0, 0, 0}, {1, 0, 0}, 4), section(diagonal(1e5, 1e5, 1, 1))));
  bent.loads = {tip_load(bent, {0, 1, 0})};
  Mechanism rolled = roll_up(8);
  rolled.loads[0].moment *= 0.5;
  for (const Mechanism& m : {segments(bent), segments(rolled)})
    EXPECT_LE(corrections.operator()<SE3>(m), corrections.operator()<SE2>(m) + 1);
  bent.loads[0].force = {0.5, 0.8, 0.6};
  bent.loads.push_back(bent.loads[0]);
  bent.loads[1].name = "push";
  bent.loads[1].port = {0, 2};
  bent.loads[1].force = {0, -1, 2};
  EXPECT_LE(corrections.operator()<SE3>(segments(bent)), 8);
}

/// A pure end moment about any axis normal to the beam closes it to a circle. At a quarter turn of
/// the end, on the grid of load steps, the tangent is singular.
TEST(SpatialSegmentBeam, RollsUp) {
  for (const int n : {4, 8})
    for (const double axis : {0., 0.4, 0.412, 1.472, 2.324, 3.932, 5.256}) {
      Mechanism m = roll_up(n);
      m.loads[0].moment = 20 * M_PI * Vec3(0, std::sin(axis), std::cos(axis));
      const auto r = solve<SE3>(segments(m));
      ASSERT_EQ(r.result.report.status, SolveStatus::Converged) << r.result.report.reason;
      EXPECT_LT(r.frame(n).x.norm(), 1e-10) << n << " segments, axis " << axis;
    }
}

/// Clamped, pushed along y at its end and along z in its middle, by forces that come at different
/// times: its tip moves in space.
Mechanism pushed(int n, double d, Formalism formalism) {
  const double A = M_PI * d * d / 4, I = A * d * d / 16;
  Mechanism m;
  m.formalism = formalism;
  m.gravity = {0, -9.81, 0};
  m.gravity_scale = TimeFunction::expression("sin(2.5*pi*t)^2");  // strikes nothing
  m.bodies = {{"beam", straight_beam({0, 0, 0}, {1, 0, 0}, n, round_section(d, 0.9),
                                     {"soft", 5 / I, 0.3, 1 / A})}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
  LoadSpec push;
  push.name = "push";
  push.port = {0, n / 2};
  push.force = {0, 0, 20};
  push.scale = TimeFunction::expression("sin(5*pi*t)^2");
  m.loads = {push};
  return m;
}

Vec3 tip_of(const Mechanism& m, int n, double duration, double step) {
  const auto r = run_spatial(m, options(duration, step, 0.8, 1e-9));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  return r.trajectory().frames(r.last())[n].x;
}

/// The difference to the beam with shear, torsion and rotary inertia falls with (radius/length)^2,
/// load over EI and mass constant.
TEST(SpatialSegmentBeam, DiffersFromTheBeamOnTheGroupBySlendernessSquared) {
  const auto difference = [](double d) {
    const auto limit = [&](Formalism formalism) -> Vec3 {
      const auto tip = [&](int n) { return tip_of(pushed(n, d, formalism), n, 0.2, 5e-4); };
      return (4 * tip(48) - tip(24)) / 3;
    };
    const Vec3 chain = limit(Formalism::Segments);
    EXPECT_GT(chain.tail<2>().cwiseAbs().minCoeff(), 0.05);
    return (chain - limit(Formalism::SE3)).norm();
  };
  const double a = difference(0.1), b = difference(0.05), c = difference(0.025);
  EXPECT_NEAR(std::log2(a / b), 2, 0.3) << a << ", " << b;
  EXPECT_NEAR(std::log2(b / c), 2, 0.3) << b << ", " << c;
}

/// A heavy pendulum on a spherical joint, thrown sideways.
Mechanism spherical_pendulum(int n, SegmentSpec spec = {}) {
  Mechanism m = segments(pendulum(n), spec);
  m.joints[0].type = JointType::Spherical;
  m.bodies[0].angular_velocity = {0, 3, 0};
  return m;
}

TEST(SpatialSegmentBeam, PendulumConvergesWithOrderTwo) {
  const auto tip = [](int n) { return tip_of(spherical_pendulum(n), n, 0.5, 5e-4); };
  const auto a = tip(8), b = tip(16), c = tip(32);
  EXPECT_GT(std::abs(c.z()), 0.1);
  EXPECT_NEAR(std::log2((a - b).norm() / (b - c).norm()), 2, 0.3);
}

/// Energy, and the moment of momentum about the vertical axis through the joint.
TEST(SpatialSegmentBeam, EnergyIsBalanced) {
  for (const SegmentSpec& spec : kKinds) {
    const Mechanism m = spherical_pendulum(6, spec);
    const auto unbalanced = [&](double step) {
      const auto r = run_spatial(m, options(0.2, step, 1, 1e-10));
      EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
      Equations<SE3> equations(*r.model);
      State<SE3> first = r.model->initial_state(), last = first;
      r.trajectory().read(0, first);
      r.trajectory().read(r.last(), last);
      const double spin = momentum(*r.model, first)[4];
      EXPECT_NEAR(momentum(*r.model, last)[4], spin, 1e-3 * std::abs(spin));
      return largest_energy_imbalance(r, step,
                                      [&](State<SE3>& s) { return power(*r.model, equations, s); });
    };
    const double coarse = unbalanced(2e-4), fine = unbalanced(1e-4);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << coarse << ", " << fine;
  }
}

/// One factorisation does for the whole motion: in the axes of the nodes the stiffness stays.
TEST(SpatialSegmentBeam, SliderCrankNeedsOneFactorisation) {
  const auto r = run_spatial(segments(slider_crank({.elements = 8})), options(0.06, 1e-4));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  EXPECT_EQ(r.report().factorizations, std::vector<int>({1, 1, 1}));
}

/// With penalties and augmentations, too.
TEST(SpatialSegmentBeam, MovesWithEveryFormOfConstraints) {
  Mechanism m = segments(slider_crank({.elements = 4}));
  const auto exact = run_spatial(m, options(0.04, 1e-4, 0.8, 1e-8));
  for (const auto form : {ConstraintForm::Penalty, ConstraintForm::Augmented}) {
    m.penalty.form = form;
    m.penalty.step = 1e-4;
    const auto r = run_spatial(m, options(0.04, 1e-4, 0.8, 1e-8));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    const double off =
        (r.trajectory().frames(r.last())[10].x - exact.trajectory().frames(exact.last())[10].x)
            .norm();
    EXPECT_LT(off, 1e-6) << to_string(form);
  }
}

std::string refusal(const Mechanism& m) {
  try {
    Model<SE3>::build(m, {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "not refused";
}

TEST(SpatialSegmentBeam, WhatItCannotDoIsRefused) {
  const Mechanism m = segments(pendulum(4));
  const auto beam = [](Mechanism& of) -> BeamSpec& {
    return std::get<BeamSpec>(of.bodies[0].kind);
  };
  const auto says = [](const Mechanism& of, const char* words) {
    EXPECT_NE(refusal(of).find(words), std::string::npos) << refusal(of);
  };
  EXPECT_NO_THROW(Model<SE3>::build(m, {}));
  Mechanism curved = m, twisted = m, flat = m, damped = m, coupled = segments(roll_up(4));
  beam(curved).nodes = arc(Arc::through({0, 0, 0}, {0.5, 0.1, 0}, {1, 0, 0}), 4);
  says(curved, "straight and not twisted");
  for (std::size_t k = 0; k < 5; ++k)
    beam(twisted).nodes[k].R = beam(twisted).nodes[k].R * SO3::exp({0.1 * double(k), 0, 0}).R;
  says(twisted, "straight and not twisted");
  beam(flat).sections[2].shape = Rectangle{0.01, 0.02};
  says(flat, "one bending stiffness");
  beam(damped).damping = 1e-5;
  says(damped, "expected damping = 0");
  std::get<FullSection>(beam(coupled).sections[1].shape).stiffness(0, 5) = 1;
  says(coupled, "without coupling");
  Mechanism hung = m;  // on a node that has no rotation
  hung.bodies.push_back({"disc", block({0.5, 0, 0}, 1, 1)});
  hung.joints.push_back({"pin", JointType::Revolute, {0, 2}, {1, 0}});
  says(hung, "which has no rotation");
  hung.joints.back().type = JointType::Spherical;
  EXPECT_NO_THROW(Model<SE3>::build(hung, {}));
}

/// A parameter of one side of a square would bend it more easily in one direction.
TEST(SpatialSegmentBeam, ParametersOfOneDirectionAreRefused) {
  const Mechanism m = segments(pendulum(4));
  const auto model = Model<SE3>::build(m, {});
  EXPECT_NO_THROW(ParameterResidual<SE3>(m, model, {"E", {by_youngs_modulus(m, 0)}}));
  EXPECT_THROW(ParameterResidual<SE3>(m, model, {"height", {by_dimension(m, 0, {}, "height")}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::spatial_segment_test
