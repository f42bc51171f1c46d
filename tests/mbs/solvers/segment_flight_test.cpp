/// @file
/// Chains of segments that fly freely, and that are bolted to each other at an angle: closed forms,
/// and the beam on the group.

#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"

namespace liesl::test::segment_flight_test {
namespace {

constexpr double kThrow = 8, kUntil = 5;  // N, s: the largest force, half way

/// The flexible rod that is thrown in its plane by a force and a moment at its lower end (after J.
/// C. Simo, L. Vu-Quoc, J. Appl. Mech. 53 (1986) 849-863): L = 10, EA = 1e4, EI = 500, rho A = 1;
/// hardly any shear and rotary inertia, which a chain of segments has not.
Mechanism thrown_rod(int n, Formalism formalism) {
  SE3::Tangent K, M;
  K << 1e4, 1e6, 1e6, 500, 500, 500;
  M << 1, 1, 1, 1e-3, 1e-3, 1e-3;
  Mechanism m;
  m.formalism = formalism;
  m.bodies = {{"rod", straight_beam({6, 0, 0}, {0, 8, 0}, n, full(K, M), {})}};
  LoadSpec l;
  l.name = "throw";
  l.port = {0, 0};
  l.force = {kThrow, 0, 0};
  l.moment = {0, 0, -10 * kThrow};
  l.scale =
      TimeFunction::table({0, kUntil / 2, kUntil}, {0, 1, 0}, TimeFunction::Interpolation::Linear);
  m.loads = {l};
  return m;
}

Run<SE2> flight(int n, Formalism formalism) {
  auto r = run_planar(thrown_rod(n, formalism), options(8, 5e-3, 0.9, 1e-8));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  return r;
}

/// Linear momentum of a chain whose mass is linear along its segments, in inertial axes, N s.
Eigen::Vector2d momentum(const Run<SE2>& r, int record) {
  const auto& t = r.trajectory();
  const int n = r.model->nodes() - 1;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int k = 0; k <= n; ++k)
    sum += (k == 0 || k == n ? 0.5 : 1) * 10. / n * t.frames(record)[k].R *
           t.v(record).segment<2>(3 * k);
  return sum;
}

/// What the force gave it: its integral over time; a chain keeps it.
TEST(SegmentFlight, KeepsTheMomentumThatItIsGiven) {
  const auto r = flight(16, Formalism::Segments);
  for (const double t : {5., 6., 8.}) {
    const Eigen::Vector2d p = momentum(r, r.at(t, 5e-3));
    EXPECT_NEAR(p.x(), kThrow * kUntil / 2, 1e-3 * kThrow * kUntil / 2) << t;
    EXPECT_NEAR(p.y(), 0, 1e-3 * kThrow * kUntil / 2) << t;
  }
}

/// Order 2 in the length of a segment, to the motion of the beam on the group but for what that has
/// of shear and rotary inertia.
TEST(SegmentFlight, ConvergesToTheBeamOnTheGroup) {
  const auto ends = [](int n, Formalism formalism) -> Eigen::Vector4d {
    const auto r = flight(n, formalism);
    Eigen::Vector4d x;
    x << r.trajectory().frames(r.last())[0].x, r.trajectory().frames(r.last())[n].x;
    return x;
  };
  const auto chain = [&](int n) { return ends(n, Formalism::Segments); };
  const Eigen::Vector4d a = chain(8), b = chain(16), c = chain(32), limit = (4 * c - b) / 3,
                        beam = (4 * ends(16, Formalism::SE3) - ends(8, Formalism::SE3)) / 3;
  EXPECT_NEAR(std::log2((a - b).norm() / (b - c).norm()), 2, 0.2);
  EXPECT_LT((limit - beam).norm(), 5e-3) << limit.transpose() << ", " << beam.transpose();
}

/// A column of 1 m with an arm of 0.5 m bolted to its top at an angle, clamped, and pushed down at
/// the end of the arm.
Mechanism gallows(int n, Formalism formalism, double angle, double load) {
  const double EI = 1;
  const Section s = section(diagonal(1e6, 1e6, EI, EI));
  Mechanism m = cantilever(beam(straight({0, 0, 0}, {0, 1, 0}, n), s));
  m.formalism = formalism;
  const Vec3 tip(0.5 * std::cos(angle), 1 + 0.5 * std::sin(angle), 0);
  m.bodies.push_back({"arm", beam(straight({0, 1, 0}, tip, n), s)});
  m.joints.push_back({"bolt", JointType::Fixed, {0, n}, {1, 0}});
  LoadSpec push = tip_load(m, {0, -load, 0});
  push.port = end_of(m, 1);
  m.loads = {push};
  return m;
}

/// Of the arm's tip, against its place at rest.
Eigen::Vector2d sag(int n, Formalism formalism, double angle, double load) {
  const Mechanism m = gallows(n, formalism, angle, load);
  const auto plane = *find_plane(m).plane;
  const auto r = solve<SE2>(m, tight(), plane);
  EXPECT_EQ(r.result.report.status, SolveStatus::Converged) << r.result.report.reason;
  const Vec3 moved = r.frame(2 * n + 1).x - std::get<BeamSpec>(m.bodies[1].kind).nodes.back().x;
  return moved.head<2>();
}

/// Small deflections of Euler and Bernoulli: P l^2 cos^2 (l/3 + h)/EI down, the column bending and
/// the arm, whatever the angle of the bolt; a moment goes through it.
TEST(SegmentFlight, BoltedAtAnAngleItCarriesMoments) {
  constexpr double kLoad = 1e-4, l = 0.5, h = 1;
  for (const double angle : {0., M_PI / 6, -M_PI / 4, 3 * M_PI / 4}) {
    const auto c = std::cos(angle);
    const Eigen::Vector2d a = sag(8, Formalism::Segments, angle, kLoad),
                          b = sag(16, Formalism::Segments, angle, kLoad);
    const double down = -(4 * b.y() - a.y()) / 3;
    EXPECT_NEAR(down / (kLoad * l * l * c * c * (l / 3 + h)), 1, 2e-3) << angle;
  }
}

/// Large deflections: with order 2 those of the beam on the group.
TEST(SegmentFlight, BoltedAtAnAngleItBendsAsTheBeamOnTheGroup) {
  constexpr double kLoad = 0.8, kAngle = M_PI / 6;
  const Eigen::Vector2d fine = sag(64, Formalism::SE3, kAngle, kLoad),
                        limit = (4 * fine - sag(32, Formalism::SE3, kAngle, kLoad)) / 3;
  const double a = (sag(8, Formalism::Segments, kAngle, kLoad) - limit).norm(),
               b = (sag(16, Formalism::Segments, kAngle, kLoad) - limit).norm(),
               c = (sag(32, Formalism::Segments, kAngle, kLoad) - limit).norm();
  EXPECT_GT(limit.norm(), 0.15);
  EXPECT_NEAR(std::log2(a / b), 2, 0.2) << a << ", " << b;
  EXPECT_NEAR(std::log2(b / c), 2, 0.3) << b << ", " << c;
}

}  // namespace
}  // namespace liesl::test::segment_flight_test
