/// @file
/// Meshed parts in statics and modes: against beams, closed forms and the full mesh.

#include <array>
#include <numbers>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/linalg/symmetric_modes.hpp"
#include "mbs/run.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/solvers/static_newton.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/step_sweep.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test::solid_statics_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::tight;

constexpr auto kConverged = SolveStatus::Converged;
constexpr double kLength = 0.5, kHeight = 0.02, kWidth = 0.01;

/// A bar along x between the interfaces "a" and "b".
/// @param layers through the width: 0 for a planar mesh
SolidSpec bar(double from, double length, int cells, double nu, int layers = 0) {
  SolidSpec s;
  s.frame.x = {from, 0, 0};
  const Vec3 half(0, kHeight / 2, kWidth / 2), end(length, 0, 0);
  s.model = test::mesh_with_ends(
      layers > 0 ? hex_grid(-half, end + half, cells, 2, layers)
                 : quad_grid(-half.head<2>(), (end + half).head<2>(), cells, 2),
      {"steel", 210e9, nu, 7850}, Vec3::Zero(), {length, 0, 0}, {kWidth, {}});
  s.modes = 4;  // no multiple of 3 or 6: some amplitudes are padding
  return s;
}

constexpr double kEI = 210e9 * kWidth * kHeight * kHeight * kHeight / 12;

/// n bars in a row, the first one clamped, a dead force at the end of the last.
Mechanism cantilever(int n, double nu, const Vec3& force, int layers = 0, int cells = 24) {
  Mechanism m;
  JointSpec joint;
  for (int i = 0; i < n; ++i) {
    m.bodies.push_back({"bar" + std::to_string(i),
                        bar(kLength * i / n, kLength / n, std::max(4, cells / n), nu, layers)});
    joint.b = {i, 0};
    joint.name = "joint" + std::to_string(i);
    m.joints.push_back(joint);
    joint.a = {i, 1};
  }
  LoadSpec load;
  load.name = "tip";
  load.port = {n - 1, 1};
  load.force = force;
  m.loads.push_back(load);
  return m;
}

struct Tip {
  SolveStatus status = SolveStatus::NotConverged;
  Vec3 moved = Vec3::Zero();
  double angle = 0;
  Report report;
};

template <class G>
Tip solved(const Mechanism& m, const Space<G>& space, const SimulationOptions& o = tight()) {
  auto model = Model<G>::build(m, space);
  const auto result = solve_static(model, o);
  const int body = m.loads[0].port.body, node = model.first_node(body) + m.loads[0].port.node;
  const auto& t = result.trajectory;
  const SE3 H = space.embed(t.frames(t.size() - 1)[node], SE3::identity());
  return {result.report.status, H.x - m.frame(m.loads[0].port).x, std::atan2(H.R(1, 0), H.R(0, 0)),
          result.report};
}

/// In the plane, or in space.
Tip tip_of(const Mechanism& m, const SimulationOptions& o = tight()) {
  if (std::get<SolidSpec>(m.bodies[0].kind).mesh().dim == 3) return solved<SE3>(m, {}, o);
  const auto found = find_plane(m);
  EXPECT_TRUE(found.plane) << found.reason;
  return solved<SE2>(m, *found.plane, o);
}

/// P L^3/(3 EI) + P L/(5/6 G A); Poisson's ratio stiffens the clamp, where the section cannot
/// change its height, by parts of height/length.
TEST(SolidStatics, SmallDeflectionsAreThoseOfTheBeam) {
  const double P = 1;
  for (const double nu : {0.0, 0.3})
    for (const int layers : {0, 2}) {
      const Tip tip = tip_of(cantilever(1, nu, {0, P, 0}, layers, 50));
      ASSERT_EQ(tip.status, kConverged) << tip.report.reason;
      const double G = 210e9 / (2 * (1 + nu)), bend = P * std::pow(kLength, 3) / (3 * kEI),
                   shear = P * kLength / (5. / 6 * G * kWidth * kHeight);
      EXPECT_NEAR(tip.moved.y() / (bend + shear), 1, nu > 0 ? 0.01 : 1e-3) << nu << " " << layers;
    }
}

/// Elastica of Mattiasson 1981 at P L^2/EI = 1: n linear parts in frames
/// that turn converge to it with order 2.
TEST(SolidStatics, PartsInARowConvergeToTheElasticaWithOrderTwo) {
  const double P = kEI / (kLength * kLength);
  Vec3 finest;
  for (const int n : {2, 4, 8, 16}) {
    const Tip tip = tip_of(cantilever(n, 0, {0, P, 0}, 0, 64));
    ASSERT_EQ(tip.status, kConverged) << tip.report.reason;
    finest = tip.moved;
  }
  // What is left is shear: P L/(5/6 G A), 3e-4 of the length here.
  const double shear = P / (5. / 6 * 105e9 * kWidth * kHeight);
  EXPECT_NEAR(finest.y() / kLength, 0.3017207738 + shear, 3e-4);
  EXPECT_NEAR(-finest.x() / kLength, 0.0564332363, 5e-4);
  const Tip coarse = tip_of(cantilever(2, 0, {0, P, 0}, 0, 64)),
            middle = tip_of(cantilever(4, 0, {0, P, 0}, 0, 64)),
            fine = tip_of(cantilever(8, 0, {0, P, 0}, 0, 64));
  const double ratio = (coarse.moved - middle.moved).norm() / (middle.moved - fine.moved).norm();
  EXPECT_NEAR(std::log2(ratio), 2, 0.2);
}

TEST(SolidStatics, ArcLengthEndsWhereLoadStepsEnd) {
  const Mechanism m = cantilever(4, 0.3, {-3e3, 2e4, 0});
  SimulationOptions arc = tight();
  arc.arc_length = true;
  arc.load_steps = 5;
  const Tip steps = tip_of(m), path = tip_of(m, arc);
  ASSERT_EQ(steps.status, kConverged) << steps.report.reason;
  ASSERT_EQ(path.status, kConverged) << path.report.reason;
  EXPECT_LT((steps.moved - path.moved).norm(), 1e-8 * kLength);
  EXPECT_GT(steps.moved.norm(), 0.1 * kLength);
}

/// The exact tangent: few corrections a load step, however far the frames turn.
TEST(SolidStatics, LargeTurnsTakeFewCorrections) {
  SimulationOptions o = tight();
  o.load_steps = 20;
  const Tip tip = tip_of(cantilever(4, 0.3, {0, 3 * kEI / (kLength * kLength), 0}), o);
  ASSERT_EQ(tip.status, kConverged) << tip.report.reason;
  EXPECT_GT(tip.angle, 0.9);
  EXPECT_EQ(tip.report.rejected_steps, 0);
  EXPECT_LE(tip.report.newton_iterations, 6 * o.load_steps);
}

/// A bar on a hinge with a spring: k theta = (P L + m g L/2) cos(theta), the bar all but rigid.
TEST(SolidStatics, ABarOnAHingeTurnsToWhereItsMomentsBalance) {
  for (const int layers : {0, 1}) {
    const double k = 40, P = 100, g = 10;
    Mechanism m = cantilever(1, 0.3, {0, -P, 0}, layers);
    auto& solid = std::get<SolidSpec>(m.bodies[0].kind);
    solid.model = test::of_material(*solid.model, {"stiff", 1e15, 0.3, 7850});
    m.gravity = {0, -g, 0};
    m.joints[0].type = JointType::Revolute;
    ForceSpec spring;
    spring.name = "spring";
    spring.joint = 0;
    spring.stiffness = k;
    m.forces.push_back(spring);
    const double mass = 7850 * kLength * kWidth * kHeight;
    double theta = 0;  // Newton's method
    for (int i = 0; i < 30; ++i) {
      const double M = (P + mass * g / 2) * kLength;
      theta -= (k * theta - M * std::cos(theta)) / (k + M * std::sin(theta));
    }
    const Tip tip = tip_of(m);
    ASSERT_EQ(tip.status, kConverged) << tip.report.reason;
    EXPECT_NEAR(tip.angle, -theta, 5e-6) << layers;  // it bends by 2e-6
    EXPECT_GT(theta, 0.7);
  }
}

TEST(SolidStatics, WhatNothingHoldsIsNamed) {
  Mechanism m = cantilever(1, 0.3, {0, 1, 0});
  m.joints.clear();
  const Tip tip = tip_of(m);
  EXPECT_EQ(tip.status, SolveStatus::Singular);
  EXPECT_NE(tip.report.reason.find("'bar0' can move along"), std::string::npos)
      << tip.report.reason;
}

/// A scene turned as a whole gives the same, turned.
TEST(SolidStatics, DoNotDependOnWhereTheSceneLies) {
  const Mechanism m = cantilever(2, 0.3, {0, 2e4, 1e4}, 1, 16);
  Mechanism turned = m;
  const SE3 H = test::oblique();
  for (auto& body : turned.bodies)
    std::get<SolidSpec>(body.kind).frame = H * std::get<SolidSpec>(body.kind).frame;
  turned.loads[0].force = H.R * m.loads[0].force;
  const Tip a = tip_of(m), b = tip_of(turned);
  ASSERT_EQ(a.status, kConverged);
  ASSERT_EQ(b.status, kConverged);
  EXPECT_LT((H.R * a.moved - b.moved).norm(), 1e-8 * a.moved.norm());
}

// --- the tangent ---------------------------------------------------------------------------------

/// The exact tangent at a state far from rest is the derivative of internal force and weight.
template <class G>
void expect_tangent(const SolidSpec& spec) {
  constexpr int dim = G::dim;
  using Tangent = typename G::Tangent;
  std::vector<G> ports;
  for (const Interface& f : spec.interfaces()) {
    ports.push_back(G::exp(Tangent(0.4 * Tangent::Ones())));
    ports.back().x += ports.back().R * f.point.template head<G::space_dim>();
  }
  const SolidBody<G> body("bar", spec, ports, Eigen::Matrix3d::Identity());
  const typename Body<G>::Vector gravity = 1e7 * Body<G>::Vector::Ones();  // as strong as K e
  test::Random numbers{7};
  std::vector<G> H;
  for (const G& frame : body.reference) H.push_back(frame * G::exp(0.2 * numbers.vector(dim)));
  const VectorXd zero = VectorXd::Zero(body.size());
  VectorXd w = zero;
  for (int k = 0; k < body.nodes(); ++k)
    if (body.kind(k) == NodeKind::Amplitudes) w.segment<dim>(dim * k) = 0.1 * numbers.vector(dim);
  w.tail(body.padding()).setZero();
  const VectorXd direction = numbers.vector(body.size());
  const auto force = [&](double t) -> VectorXd {
    auto Ht = H;
    VectorXd wt = w;
    for (int k = 0; k < body.nodes(); ++k)
      if (body.kind(k) == NodeKind::Frame)
        Ht[k] = H[k] * G::exp(Tangent(t * direction.segment<dim>(dim * k)));
      else
        wt.segment<dim>(dim * k) += t * direction.segment<dim>(dim * k);
    VectorXd r = zero;
    ForceScale scale;
    const BodyState<G> s{Ht.data(), zero.data(), zero.data(), wt.data()};
    body.add_internal(s, r.data(), scale);
    body.add_inertia(s, gravity, r.data(), scale);
    return r;
  };
  auto A = body.stiffness();
  body.exact_tangent({H.data(), zero.data(), zero.data(), w.data()}, gravity, {}, nullptr, A);
  // All nodes carry unknowns, in order.
  const int real = body.size() - body.padding();
  const VectorXd exact = (A.dense.leftCols(real) * direction.head(real)).head(real);
  test::expect_second_order(
      [&](double h) -> VectorXd { return test::central_first(force, 0)(h).head(real); }, exact,
      exact.cwiseAbs().cwiseMax(1e-3 * exact.cwiseAbs().maxCoeff()), 2e-2, 1e-7, "tangent");
}

TEST(SolidStatics, TheTangentIsTheDerivativeOfAllForces) {
  expect_tangent<SE2>(bar(0, kLength, 8, 0.3));
  expect_tangent<SE3>(bar(0, kLength, 8, 0.3, 1));
}

// --- modes ---------------------------------------------------------------------------------------

std::vector<double> frequencies(const Mechanism& m, int count) {
  SimulationOptions o = tight();
  o.type = SimulationType::Modes;
  o.modes = count;
  const auto solve = [&](auto&& model) {
    const auto modes = solve_modes(model, o);
    EXPECT_EQ(modes.report.status, kConverged) << modes.report.reason;
    return modes.frequency;
  };
  if (std::get<SolidSpec>(m.bodies[0].kind).mesh().dim == 3) return solve(Model<SE3>::build(m, {}));
  return solve(Model<SE2>::build(m, *find_plane(m).plane));
}

/// Of the full mesh with the first port held.
VectorXd clamped_frequencies(const SolidSpec& spec, int count) {
  const SolidModel& model = *spec.model;
  const VectorXd v = solid_fractions(spec).value;
  const int held = model.port(0), r = model.rigid_count();
  Eigen::SparseMatrix<double> P(model.size(), model.size() - r);
  for (int i = 0, column = 0; i < model.size(); ++i)
    if (i < held || i >= held + r) P.insert(i, column++) = 1;
  const Eigen::SparseMatrix<double> K = model.stiffness(v).selfadjointView<Eigen::Lower>(),
                                    M = model.mass(v).selfadjointView<Eigen::Lower>();
  const SymmetricModes modes = symmetric_modes(P.transpose() * K * P, P.transpose() * M * P, count);
  EXPECT_TRUE(modes.converged);
  return modes.lambda.cwiseSqrt() / (2 * std::numbers::pi);
}

/// From above, within 1 % with as many internal modes; the first bending modes are those of
/// Euler-Bernoulli, f = (1.8751, 4.6941)^2/(2 pi L^2) sqrt(EI/(rho A)).
TEST(SolidModes, OfACantileverAreThoseOfTheFullMeshAndOfTheBeam) {
  for (const int layers : {0, 1}) {
    Mechanism m = cantilever(1, 0, {0, 0, 0}, layers, 40);
    m.loads.clear();
    auto& spec = std::get<SolidSpec>(m.bodies[0].kind);
    spec.modes = 11;
    const int count = 5;
    const std::vector<double> found = frequencies(m, count);
    const VectorXd full = clamped_frequencies(spec, count);
    ASSERT_EQ(found.size(), std::size_t(count));
    for (int i = 0; i < count; ++i) {
      EXPECT_GE(found[i], full[i] * (1 - 1e-7)) << i;
      EXPECT_LE(found[i], full[i] * 1.01) << i;
    }
    if (layers > 0) continue;  // bends both ways
    const double c =
        std::sqrt(kEI / (7850 * kWidth * kHeight)) / (2 * std::numbers::pi * kLength * kLength);
    EXPECT_NEAR(found[0] / (1.8751040687 * 1.8751040687 * c), 1, 3e-3);
    EXPECT_NEAR(found[1] / (4.6940911330 * 4.6940911330 * c), 1, 1.5e-2);
  }
}

/// All of the part's modes and no more: what pads the amplitudes is none.
TEST(SolidModes, AreAsManyAsTheUnknowns) {
  Mechanism m = cantilever(1, 0.3, {0, 0, 0});
  m.loads.clear();
  const std::vector<double> found = frequencies(m, 50);
  EXPECT_EQ(found.size(), 3u + 4u);  // the far port and the modes
  EXPECT_GT(found[0], 50);           // the padding's would be below 1 Hz
}

/// A free part has its rigid motions at zero, and above them the frequencies of the reduced part.
TEST(SolidModes, OfAFreePartAreItsFreeFrequencies) {
  Mechanism m;
  m.bodies = {{"bar", bar(0, kLength, 24, 0.3)}};
  const std::vector<double> found = frequencies(m, 8);
  const auto model = Model<SE2>::build(m, *find_plane(m).plane);
  const auto& body = dynamic_cast<const SolidBody<SE2>&>(*model.bodies[0]);
  const VectorXd own = body.free_frequencies(5, 4);
  for (int i = 0; i < 3; ++i) EXPECT_LT(found[i], 1e-3 * found[3]);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(found[3 + i] / own[i], 1, 1e-7) << i;
}

/// Hung up, a stiff bar swings as a rigid one: f = sqrt(3 g/(2 L))/(2 pi).
TEST(SolidModes, AHangingBarSwings) {
  Mechanism m = cantilever(1, 0.3, {0, 0, 0});
  m.loads.clear();
  m.joints[0].type = JointType::Revolute;
  m.gravity = {9.81, 0, 0};
  const double swing = std::sqrt(3 * 9.81 / (2 * kLength)) / (2 * std::numbers::pi);
  EXPECT_NEAR(frequencies(m, 2)[0] / swing, 1, 1e-3);
}

}  // namespace
}  // namespace liesl::test::solid_statics_test
