/// @file
/// Rods, cylinders, bushings, springs with tables, ports at an offset, gravity over time: closed
/// forms.

#include <Eigen/Eigenvalues>

#include "mbs/model/coupled_springs.hpp"
#include "mbs/run.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/step_tangent.hpp"

namespace liesl::test::force_elements_test {
namespace {

constexpr double kGravity = 9.81;

/// A mass on a massless rod, let go beside its hinge: the rod carries 3 m g at the lowest point,
/// m g (3 sin) on the way.
TEST(Rod, CarriesAPendulum) {
  const double L = 0.7, mass = 2;
  Mechanism m;
  m.gravity = {0, -kGravity, 0};
  m.bodies = {{"bob", block({L, 0, 0}, mass, 0.1)}};
  m.joints = {{"string", JointType::Rod, {}, {0, 0}}};
  const auto r = run_spatial(m, options(1, 1e-3, 1, 1e-10));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  double lowest = 0;
  for (int i = 0; i < r.trajectory().size(); ++i) {
    const Vec3 x = r.trajectory().frames(i)->x;
    ASSERT_NEAR(x.norm(), L, 1e-9);
    const double tension = r.trajectory().lambda(i)[0];
    ASSERT_NEAR(tension, 3 * mass * kGravity * -x.y() / L, 2e-4 * mass * kGravity);
    lowest = std::min(lowest, x.y());
  }
  EXPECT_NEAR(lowest, -L, 1e-4);
}

/// A boom on a hinge lifted by a cylinder from the ground point B to its lug C: the law of cosines
/// gives its angle, moments about the hinge the force.
Mechanism boom() {
  Mechanism m;
  m.gravity = {0, -kGravity, 0};
  m.ground_points["foot"] = {0.2, -0.5, 0};
  RigidSpec rigid = block({1, 0, 0}, 5, 0.3);
  rigid.points["hinge"] = {0, 0, 0};
  rigid.points["lug"] = {0.8, 0, 0};
  m.bodies = {{"boom", rigid}};
  m.joints = {{"hinge", JointType::Revolute, {}, *m.port("boom.hinge")},
              {"lift", JointType::Cylinder, *m.port("ground.foot"), *m.port("boom.lug")}};
  return m;
}

/// Angle between the arms to the foot and to the lug at a length of the cylinder.
double enclosed(double length) {
  const double a = 0.8, b = std::hypot(0.2, 0.5);
  return std::acos((a * a + b * b - length * length) / (2 * a * b));
}

TEST(Cylinder, LiftsABoom) {
  const double rest = std::hypot(0.6, 0.5), stroke = 0.25;
  Mechanism m = boom();
  m.drives = {{1, 0, TimeFunction::expression("0.25*(1-cos(pi*t))/2")}};
  for (const bool planar : {true, false}) {
    const auto check = [&](const auto& r) {
      ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
      const double angle = enclosed(rest + stroke) - enclosed(rest);
      EXPECT_NEAR(r.trajectory().rows(r.last())[row_of(*r.model, 0, 0)], angle, 1e-9);
      EXPECT_NEAR(r.trajectory().rows(r.last())[row_of(*r.model, 1, 0)], stroke, 1e-9);
    };
    if (planar)
      check(run_planar(m, options(1, 0.01, 0.8, 1e-9)));
    else
      check(run_spatial(m, options(1, 0.01, 0.8, 1e-9)));
  }
}

/// Held by the driven cylinder at rest: F times its lever is the moment of the weight.
TEST(Cylinder, CarriesTheWeight) {
  Mechanism m = boom();
  m.drives = {{1, 0, TimeFunction::constant(0)}};
  const auto model = Model<SE3>::build(m, {});
  const auto result = solve_static(model, tight());
  ASSERT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
  const auto& c = model.couplings[1];
  ASSERT_EQ(c.constraints, 1);
  const Vec3 along = Vec3(0.6, 0.5, 0).normalized();
  const double lever = 0.8 * along.y();
  const auto& t = result.trajectory;
  EXPECT_NEAR(-t.lambda(t.size() - 1)[c.first_constraint], 5 * kGravity / lever, 1e-7);
}

/// With stiffness, damping and force it is the force law between its ports.
TEST(Cylinder, IsTheForceLawBetweenItsPorts) {
  Mechanism m = boom();
  ForceSpec f;
  f.name = "lift";
  f.joint = 1;
  f.stiffness = 4000;
  f.damping = 60;
  f.force = TimeFunction::expression("90+30*sin(5*t)");
  m.forces = {f};
  Mechanism other = boom();
  other.joints.pop_back();
  f.joint = -1;
  f.a = *m.port("ground.foot");
  f.b = *m.port("boom.lug");
  f.rest = std::hypot(0.6, 0.5);
  other.forces = {f};
  const auto a = run_planar(m, options(1, 5e-3, 0.8, 1e-10)),
             b = run_planar(other, options(1, 5e-3, 0.8, 1e-10));
  ASSERT_EQ(a.report().status, SolveStatus::Converged) << a.report().reason;
  for (int i = 0; i < a.trajectory().size(); ++i) {
    ASSERT_LT((a.trajectory().frames(i)->x - b.trajectory().frames(i)->x).norm(), 1e-9);
    ASSERT_NEAR(total_energy(a, i), total_energy(b, i), 1e-8);
  }
}

constexpr double kStiffness[] = {1e4, 2e4, 3e4, 400, 500, 600};

/// A block in a bushing alone, beside its centre of mass.
Mechanism mounted() {
  Mechanism m;
  m.bodies = {{"block", block({0.1, 0.2, 0.3}, 4, 0.05)}};
  m.joints = {{"mount", JointType::Bushing, {}, {0, 0}}};
  for (int i = 0; i < 6; ++i) {
    ForceSpec f;
    f.name = "mount." + std::to_string(i);
    f.joint = 0;
    f.coordinate = i;
    f.stiffness = kStiffness[i];
    m.forces.push_back(f);
  }
  return m;
}

/// F/k along each axis, M/k about each.
TEST(Bushing, GivesInSixDirections) {
  for (int i = 0; i < 6; ++i) {
    Mechanism m = mounted();
    LoadSpec l;
    l.port = {0, 0};
    (i < 3 ? l.force : l.moment)[i % 3] = 0.01 * kStiffness[i];
    m.loads = {l};
    const auto solved = solve(m, tight());
    ASSERT_EQ(solved.result.report.status, SolveStatus::Converged) << solved.result.report.reason;
    SE3::Tangent moved;
    moved << solved.frame(0).x - Vec3(0.1, 0.2, 0.3), SO3::log(solved.frame(0).R);
    EXPECT_LT((moved - 0.01 * SE3::Tangent::Unit(i)).norm(), 1e-10)
        << i << " " << moved.transpose();
  }
}

TEST(Bushing, HasSixFrequencies) {
  SimulationOptions o = tight();
  o.type = SimulationType::Modes;
  o.modes = 6;
  const auto model = Model<SE3>::build(mounted(), {});
  const auto modes = solve_modes(model, o);
  ASSERT_EQ(modes.omega.size(), 6u) << modes.report.reason;
  std::vector<double> expected;
  for (int i = 0; i < 6; ++i) expected.push_back(std::sqrt(kStiffness[i] / (i < 3 ? 4 : 0.05)));
  std::sort(expected.begin(), expected.end());
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(modes.omega[i] / expected[i], 1, 1e-9);
}

/// The block in a plane, let go with a turn, beside another one.
Mechanism in_a_plane(Mechanism m) {
  m.bodies[0].kind = block({0.1, 0.2, 0}, 4, 0.05);
  m.gravity = {3, -kGravity, 0};
  m.bodies[0].angular_velocity = {0, 0, 4};
  m.bodies.push_back({"other", block({0.6, -0.1, 0}, 1, 1)});
  m.joints.push_back({"axle", JointType::Revolute, {}, {1, 0}});
  return m;
}

/// The motion in the plane is that in space.
void expect_plane_kept(const Mechanism& m) {
  const auto plane = run_planar(m, options(0.1, 1e-3, 0.8, 1e-10));
  const auto space = run_spatial(m, options(0.1, 1e-3, 0.8, 1e-10));
  ASSERT_EQ(plane.report().status, SolveStatus::Converged) << plane.report().reason;
  const auto a =
      plane.model->space.embed(*plane.trajectory().frames(plane.last()), SE3::identity());
  const auto& b = *space.trajectory().frames(space.last());
  EXPECT_LT((a.x - b.x).norm() + (a.R - b.R).norm(), 1e-8);
}

/// A symmetric matrix that couples all coordinates, of the size of kStiffness.
Eigen::MatrixXd coupled() {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6, 6);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      K(i, j) = (i == j ? 1 : 0.3 / (1 + i + j) * (i % 2 == j % 2 ? 1 : -1)) *
                std::sqrt(kStiffness[i] * kStiffness[j]);
  return K;
}

/// The block in a bushing of a matrix, with a damper of the same shape.
Mechanism mounted_on(const Eigen::MatrixXd& K, double damping = 0) {
  Mechanism m = mounted();
  m.forces.clear();
  for (const CoupledSpring& spring : coupled_springs(K)) {
    ForceSpec f;
    f.name = "mount." + std::to_string(spring.coordinate);
    f.joint = 0;
    f.coordinate = spring.coordinate;
    f.stiffness = spring.stiffness;
    f.damping = damping * spring.stiffness;
    f.shares = spring.shares;
    m.forces.push_back(f);
  }
  return m;
}

/// K^-1 f, of a small load: angles are right for small ones.
TEST(Bushing, OfAMatrixGivesByItsInverse) {
  const Eigen::MatrixXd K = coupled();
  SimulationOptions o = tight();
  o.tolerance = 1e-9;  // springs on sums pull against each other
  for (int i = 0; i < 6; ++i) {
    Mechanism m = mounted_on(K);
    const double load = 1e-4 * kStiffness[i];
    LoadSpec l;
    l.port = {0, 0};
    (i < 3 ? l.force : l.moment)[i % 3] = load;
    m.loads = {l};
    const auto solved = solve(m, o);
    ASSERT_EQ(solved.result.report.status, SolveStatus::Converged) << solved.result.report.reason;
    SE3::Tangent moved;
    moved << solved.frame(0).x - Vec3(0.1, 0.2, 0.3), SO3::log(solved.frame(0).R);
    const Eigen::VectorXd expected = K.inverse().col(i) * load;
    EXPECT_LT((moved - expected).norm(), 1e-3 * expected.norm()) << i;
  }
}

TEST(Bushing, OfAMatrixHasItsFrequencies) {
  SimulationOptions o = tight();
  o.type = SimulationType::Modes;
  o.modes = 6;
  const Eigen::MatrixXd K = coupled();
  const auto model = Model<SE3>::build(mounted_on(K), {});
  const auto modes = solve_modes(model, o);
  ASSERT_EQ(modes.omega.size(), 6u) << modes.report.reason;
  Eigen::VectorXd scale(6);
  scale << 2, 2, 2, std::sqrt(0.05), std::sqrt(0.05), std::sqrt(0.05);
  const Eigen::MatrixXd scaled =
      scale.cwiseInverse().asDiagonal() * K * scale.cwiseInverse().asDiagonal();
  const Eigen::VectorXd squares =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(modes.omega[std::size_t(i)] / std::sqrt(squares[i]), 1, 1e-8) << i;
}

/// A singular matrix has fewer springs; one with a negative eigenvalue is none.
TEST(Bushing, MatrixIsMadeOfItsPivots) {
  Eigen::Matrix3d K;
  K << 4, 2, 0, 2, 1, 0, 0, 0, 5;
  const auto springs = coupled_springs(K);
  ASSERT_EQ(springs.size(), 2u);
  EXPECT_EQ(springs[0].stiffness, 4);
  ASSERT_EQ(springs[0].shares.size(), 1u);
  EXPECT_EQ(springs[0].shares[0].weight, 0.5);
  EXPECT_EQ(springs[1].coordinate, 2);
  K(1, 1) = 1 - 1e-10;  // a number of ten digits
  EXPECT_EQ(coupled_springs(K).size(), 2u);
  K(1, 1) = 0.9;
  EXPECT_THROW(coupled_springs(K), std::invalid_argument);
}

/// What couples the plane with what is out of it leaves the plane; blocks by themselves do not.
TEST(Bushing, MatrixKeepsThePlaneIfItsBlocksDo) {
  Eigen::MatrixXd K = coupled();
  const auto in_plane = [](int i) { return i < 2 || i == 5; };
  const auto search = find_plane(in_a_plane(mounted_on(K)));
  EXPECT_FALSE(search.plane);
  EXPECT_NE(search.reason.find("couples a coordinate in the plane"), std::string::npos)
      << search.reason;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      if (in_plane(i) != in_plane(j)) K(i, j) = 0;
  expect_plane_kept(in_a_plane(mounted_on(K)));
}

TEST(Bushing, IterationMatrixOfAMatrixIsExact) {
  Mechanism m = mounted_on(coupled(), 0.01);
  m.gravity = {0, -kGravity, 2};
  m.bodies[0].angular_velocity = {3, 1, 2};
  const auto model = Model<SE3>::build(m, {});
  StepTangent<SE3> step(model, options(1, 2e-3, 0.8, 1e-10), 20);
  step.expect_exact("coupled bushing", kAllColumns);
}

/// Decays as exp(-c t / 2m) cos: a damped oscillator, second order in the step.
TEST(Bushing, Dampens) {
  std::vector<double> errors;
  for (const double step : {2e-3, 1e-3}) {
    Mechanism m = mounted();
    m.forces[0].damping = 30;
    m.bodies[0].velocity = {1, 0, 0};
    const auto r = run_spatial(m, options(0.2, step, 1, 1e-11));
    const double decay = 30 / (2 * 4.), omega = std::sqrt(1e4 / 4 - decay * decay);
    const double x = std::exp(-decay * 0.2) * std::sin(omega * 0.2) / omega;
    errors.push_back(std::abs(r.trajectory().frames(r.last())->x.x() - 0.1 - x));
  }
  EXPECT_LT(errors[1], 1e-4);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2);
}

/// What acts out of the plane is relaxed in it: the plane is found, and the motion the same.
TEST(Bushing, KeepsThePlane) {
  Mechanism m = in_a_plane(mounted());
  expect_plane_kept(m);
  m.forces[2].rest = 0.01;  // pushes out of the plane
  EXPECT_FALSE(find_plane(m).plane);
}

TEST(Bushing, IterationMatrixIsExact) {
  Mechanism m = mounted();
  m.gravity = {0, -kGravity, 2};
  m.bodies[0].angular_velocity = {3, 1, 2};
  for (auto& f : m.forces) f.damping = 0.01 * f.stiffness;
  const auto model = Model<SE3>::build(m, {});
  StepTangent<SE3> step(model, options(1, 2e-3, 0.8, 1e-10), 20);
  step.expect_exact("bushing", kAllColumns);
}

/// A mass on a spring f(x): statics follow the table, the energy gives the speed at the middle.
Mechanism hardening(TimeFunction::Interpolation how) {
  Mechanism m;
  m.bodies = {{"mass", block({0, 0, 0}, 2, 0.1)}};
  m.joints = {{"guide", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()}};
  ForceSpec f;
  f.name = "spring";
  f.joint = 0;
  f.rest = 0.1;
  f.curve.emplace(std::vector<double>{-0.2, -0.1, 0.1, 0.2},
                  std::vector<double>{-300, -50, 50, 300}, how);
  m.forces = {f};
  return m;
}

TEST(SpringTable, StaticsFollowIt) {
  for (const auto how : {TimeFunction::Interpolation::Linear, TimeFunction::Interpolation::Cubic}) {
    Mechanism m = hardening(how);
    const ForceCurve curve = *m.forces[0].curve;
    for (const double x : {0.04, 0.13, 0.19, 0.5, -0.27}) {
      LoadSpec l;
      l.port = {0, 0};
      l.force = {curve(x), 0, 0};
      m.loads = {l};
      SimulationOptions o = tight();
      o.load_steps = 10;
      const auto solved = solve(m, o);
      ASSERT_EQ(solved.result.report.status, SolveStatus::Converged)
          << x << solved.result.report.reason;
      EXPECT_NEAR(solved.frame(0).x.x(), 0.1 + x, 1e-9);
    }
  }
}

/// Pushed at x = -0.1 from rest: where the spring is relaxed its energy is that of the motion.
TEST(SpringTable, KeepsTheEnergy) {
  for (const auto tangent : {TangentStrategy::Constant, TangentStrategy::Exact}) {
    std::vector<double> drifts;
    Mechanism m = hardening(TimeFunction::Interpolation::Cubic);
    double fastest = 0;
    for (const double step : {4e-3, 2e-3, 1e-3}) {
      SimulationOptions o = options(1, step, 1, 1e-10);
      o.tangent = tangent;
      m.bodies[0].velocity = {2, 0, 0};
      const auto r = run_spatial(m, o);
      ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
      double largest = 0;
      fastest = 0;
      for (int i = 0; i < r.trajectory().size(); ++i) {
        largest = std::max(largest, std::abs(total_energy(r, i) - total_energy(r, 0)));
        fastest = std::max(fastest, std::abs(r.trajectory().v(i)[0]));
      }
      drifts.push_back(largest);
    }
    const double start = 0.5 * 2 * 4 + m.forces[0].curve->energy(-0.1);
    EXPECT_NEAR(fastest, std::sqrt(2 * start / 2), 1e-3);
    EXPECT_NEAR(std::log2(drifts[0] / drifts[2]), 4, 0.6) << drifts[0] << " " << drifts[2];
  }
}

/// Flat ends carry a constant force: no tangent, yet a step.
TEST(SpringTable, MayBeFlat) {
  Mechanism m = hardening(TimeFunction::Interpolation::Linear);
  m.forces[0].rest = 0;
  m.forces[0].curve.emplace(std::vector<double>{0, 1}, std::vector<double>{-8, -8},
                            TimeFunction::Interpolation::Linear);
  const auto r = run_spatial(m, options(1, 0.01, 0.8, 1e-10));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  EXPECT_NEAR(r.trajectory().frames(r.last())->x.x(), 0.5 * 8 / 2, 1e-8);
}

TEST(SpringTable, IterationMatrixIsExact) {
  Mechanism m = hardening(TimeFunction::Interpolation::Cubic);
  m.bodies[0].velocity = {2, 0, 0};
  const auto model = Model<SE3>::build(m, {});
  StepTangent<SE3> step(model, options(1, 2e-3, 0.8, 1e-10), 20);
  step.expect_exact("spring", kAllColumns);
}

/// A load at a lug is a force and its moment at the node.
TEST(BeamPoint, CarriesForceAndMoment) {
  Mechanism m =
      cantilever(beam(straight({0, 0, 0}, {2, 0, 0}, 4), section(diagonal(1e6, 1e6, 800, 1000))));
  auto& spec = std::get<BeamSpec>(m.bodies[0].kind);
  spec.points["lug"] = {4, {2, 0.3, 0.1}};
  const auto port = m.port("beam.lug");
  ASSERT_TRUE(port);
  EXPECT_LT((m.frame(*port).x - Vec3(2, 0.3, 0.1)).norm(), 1e-15);
  LoadSpec l = tip_load(m, {2, 0, 3});
  l.port = *port;
  Mechanism other = m;
  m.loads = {l};
  other.loads = {tip_load(other, l.force, Vec3(0, 0.3, 0.1).cross(l.force))};
  const double small = 1e-5;  // where a moment that is dead is one that follows
  m.loads[0].force *= small;
  other.loads[0].force *= small;
  other.loads[0].moment *= small;
  const SE3 a = solve(m, tight()).frame(4), b = solve(other, tight()).frame(4);
  EXPECT_LT((a.x - b.x).norm(), 1e-4 * (b.x - Vec3(2, 0, 0)).norm());
}

/// x = -g t^3 / (6 T) while gravity grows as t/T; the energy counts the work of its growth.
TEST(GravityScale, RampIsACube) {
  std::vector<double> errors;
  for (const double step : {0.02, 0.01}) {
    Mechanism m;
    m.gravity = {0, -kGravity, 0};
    m.gravity_scale = TimeFunction::table({0, 2}, {0, 1}, TimeFunction::Interpolation::Linear);
    m.bodies = {{"stone", block({0, 0, 0}, 2, 0.1)}};
    const auto r = run_spatial(m, options(1, step, 1, 1e-11));
    errors.push_back(std::abs(r.trajectory().frames(r.last())->x.y() + kGravity / (6 * 2)));
    State<SE3> s = r.model->initial_state();
    Equations<SE3> eq(*r.model);
    double work = 0, before = 0, scale_before = 0, lost = 0;
    for (int i = 0; i < r.trajectory().size(); ++i) {
      r.trajectory().read(i, s);
      EXPECT_EQ(power(*r.model, eq, s), 0);
      const double scale = m.gravity_scale(s.t), V = weight_potential(*r.model, s);
      work += 0.5 * (scale - scale_before) * (V + before);
      before = V;
      scale_before = scale;
      lost = std::max(lost, std::abs(total_energy(r, i) - work));
    }
    EXPECT_LT(lost, 100 * step * step);
  }
  EXPECT_LT(errors[1], 1e-3);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.1);
}

/// Put on slowly the weight bends a beam to its static sag; at once, to twice that.
TEST(GravityScale, SlowRampDoesNotStrike) {
  const auto sag = [](const TimeFunction& scale) {
    Mechanism m =
        cantilever(beam(straight({0, 0, 0}, {1, 0, 0}, 4),
                        section(diagonal(1e6, 1e6, 800, 1000), diagonal(1, 1, 1e-3, 1e-3))));
    m.gravity = {0, -kGravity, 0};
    m.gravity_scale = scale;
    const auto r = run_planar(m, options(2, 2e-3, 1, 1e-9));
    double lowest = 0;
    for (int i = 0; i < r.trajectory().size(); ++i)
      lowest = std::min(lowest, r.trajectory().frames(i)[4].x.y());
    return -lowest / (kGravity / (8 * 1000));
  };
  EXPECT_NEAR(sag(TimeFunction::constant(1)), 2, 0.1);
  EXPECT_NEAR(sag(TimeFunction::table({0, 1}, {0, 1}, TimeFunction::Interpolation::Cubic)), 1,
              0.03);
}

}  // namespace
}  // namespace liesl::test::force_elements_test
