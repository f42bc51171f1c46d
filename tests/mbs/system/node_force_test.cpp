/// @file
/// Section forces and stress of beams at the nodes: closed forms with their order on coarse meshes,
/// reactions of joints, the internal forces of a motion.

#include <numbers>

#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl::test::node_force_test {
namespace {

constexpr double kLength = 1, kDiameter = 0.02;
constexpr double kLarge = 1e-4;  // share of the stress that the bar's own sag is good for
const Material kSteel{"steel", 210e9, 0.3, 7850};

/// A clamped round bar along x.
Mechanism bar(int elements, Formalism formalism) {
  BeamSpec spec;
  spec.nodes = straight({0, 0, 0}, {kLength, 0, 0}, elements);
  spec.sections.assign(std::size_t(elements), Section{"circle", Circle{kDiameter}});
  spec.material = kSteel;
  Mechanism m = test::cantilever(spec);
  m.formalism = formalism;
  return m;
}

/// Half as thick at the free end, linear in between.
Mechanism tapered(Mechanism m) {
  auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
  const auto n = static_cast<double>(beam.sections.size());
  const auto at = [](double s) { return Section{"circle", Circle{kDiameter * (1 - s / 2)}}; };
  for (std::size_t e = 0; e < beam.sections.size(); ++e) {
    const auto first = static_cast<double>(e);
    beam.sections[e] = at((first + 0.5) / n);
    beam.ends.push_back({at(first / n), at((first + 1) / n)});
  }
  return m;
}

/// Of the bar in equilibrium.
double value_of(const Mechanism& m, const ResponseSpec& response) {
  const auto model = Model<SE3>::build(m, {});
  const auto solved = solve_static(model, test::tight());
  EXPECT_EQ(solved.report.status, SolveStatus::Converged) << solved.report.reason;
  State<SE3> s = model.initial_state();
  solved.trajectory.read(solved.trajectory.size() - 1, s);
  return ResponseValues<SE3>(m, model)(response, s)[0];
}

double largest_stress(const Mechanism& m) {
  ResponseSpec stress;
  stress.kind = ResponseKind::Stress;
  stress.body = 0;
  return value_of(m, stress);
}

double normal_force(const Mechanism& m, int element, ElementPlace place) {
  ResponseSpec force;
  force.kind = ResponseKind::SectionForce;
  force.body = 0;
  force.element = element;
  force.place = place;
  force.component = 0;
  return value_of(m, force);
}

/// Von Mises at the outline: bending, and the shear stress V/(k A) that every stress point has.
double root_stress(double moment, double shear, double diameter = kDiameter) {
  const double area = std::numbers::pi * diameter * diameter / 4;
  const double k = geometry(Section{"circle", Circle{diameter}}, kSteel.nu).ky;
  return std::hypot(8 * moment / (area * diameter), std::sqrt(3) * shear / (k * area));
}

void pull_at(Mechanism& m, int node, double force) {
  LoadSpec load = test::tip_load(m, {force, 0, 0});
  load.port.node = node;
  m.loads.push_back(load);
}

class NodeForces : public ::testing::TestWithParam<Formalism> {};

/// 12.73 MPa under 10 N by 1 ... 16 elements; in the middle of the first one it would be 1 - 1/(2n)
/// of that. What is left is the bending of the bar, of second order in the load.
TEST_P(NodeForces, RootStressUnderATipLoadIsRightOnEveryMesh) {
  EXPECT_NEAR(root_stress(10 * kLength, 10), 12.73e6, 0.005e6);
  for (const double force : {10., 1.})
    for (int n : {1, 2, 4, 8, 16}) {
      Mechanism m = bar(n, GetParam());
      m.loads.push_back(test::tip_load(m, {0, force, 0}));
      EXPECT_NEAR(largest_stress(m) / root_stress(force * kLength, force), 1, 1e-6 * force)
          << n << " elements";
    }
}

/// Under its weight q the root carries q L^2/2; what is missing falls with the square of the
/// length.
TEST_P(NodeForces, RootStressUnderWeightConvergesWithOrderTwo) {
  const double q = 9.81 * kSteel.rho * std::numbers::pi * kDiameter * kDiameter / 4;
  const double exact = root_stress(q * kLength * kLength / 2, q * kLength);
  std::vector<double> errors;
  for (int n : {2, 4, 8, 16}) {
    Mechanism m = bar(n, GetParam());
    m.gravity = {0, -9.81, 0};
    errors.push_back(std::abs(largest_stress(m) / exact - 1));
  }
  EXPECT_LT(errors[0], 0.2);
  if (errors[0] < kLarge) return;  // half of it to each node: exact
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 2, 0.1) << errors[i];
}

/// Half as thick at the tip: (1 - x)/(1 - x/2)^3 is largest in the middle, at a node of all meshes.
/// The sections of the middles of the elements beside it would be 1/(12 n) thicker and thinner.
TEST_P(NodeForces, StressOfATaperIsThatOfTheSectionAtTheNode) {
  for (int n : {2, 8}) {
    Mechanism m = tapered(bar(n, GetParam()));
    m.loads.push_back(test::tip_load(m, {0, 1, 0}));
    EXPECT_NEAR(largest_stress(m) / root_stress(kLength / 2, 1, 0.75 * kDiameter), 1, 2e-6)
        << n << " elements";
  }
}

/// Under its weight, int_0^L rho A x dx at the root, with order 2 from 16 elements on (1.69
/// and 1.85 between 4, 8 and 16).
TEST_P(NodeForces, StressOfATaperUnderWeightConvergesWithOrderTwo) {
  const double q = 9.81 * kSteel.rho * std::numbers::pi * kDiameter * kDiameter / 4;  // at the root
  const double exact = root_stress(q * kLength * kLength * 11 / 48, q * kLength * 7 / 12);
  std::vector<double> errors;
  for (int n : {16, 32, 64}) {
    Mechanism m = tapered(bar(n, GetParam()));
    m.gravity = {0, -9.81, 0};
    errors.push_back(std::abs(largest_stress(m) / exact - 1));
  }
  EXPECT_LT(errors[0], 0.01);
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 2, 0.1) << errors[i];
}

/// The normal force at the root of a bar that hangs, q L: that of the middle of its first element
/// would be 1 - 1/(2n) of it, of first order and unsafe. A taper carries int rho A g dx, with
/// order 2.
TEST_P(NodeForces, RootOfAHangingBarCarriesItsWeight) {
  const double q = 9.81 * kSteel.rho * std::numbers::pi * kDiameter * kDiameter / 4;
  for (int n : {2, 4, 16}) {
    Mechanism m = bar(n, GetParam());
    m.gravity = {9.81, 0, 0};
    EXPECT_NEAR(normal_force(m, 0, ElementPlace::First) / (q * kLength), 1, 1e-6) << n;
    EXPECT_NEAR(normal_force(m, n - 1, ElementPlace::Last) / (q * kLength), 0, 1e-6) << n;
  }
  std::vector<double> errors;
  for (int n : {4, 8, 16, 32}) {
    Mechanism m = tapered(bar(n, GetParam()));
    m.gravity = {9.81, 0, 0};
    errors.push_back(
        std::abs(normal_force(m, 0, ElementPlace::First) / (q * kLength * 7 / 12) - 1));
  }
  EXPECT_LT(errors.back(), 2e-3);
  for (std::size_t i = 2; i < errors.size(); ++i)
    EXPECT_GT(std::log2(errors[i - 1] / errors[i]), 1.7) << errors[i];
}

/// So do mean stress and the share of the Euler load, of a bar that hangs and of one that stands.
TEST_P(NodeForces, MembersCarryTheirWeightAtTheirEnds) {
  const double area = std::numbers::pi * kDiameter * kDiameter / 4, q = 9.81 * kSteel.rho * area;
  const double euler = std::pow(std::numbers::pi / (2 * kLength), 2) * kSteel.E *
                       std::pow(kDiameter, 4) * std::numbers::pi / 64;
  for (int n : {2, 4, 16})
    for (const double weight : {9.81, -9.81}) {
      Mechanism m = bar(n, GetParam());
      m.gravity = {weight, 0, 0};
      ResponseSpec r;
      r.body = 0;
      r.kind = ResponseKind::AxialStress;
      const double sign = weight > 0 ? 1 : -1;
      EXPECT_NEAR(value_of(m, r) / (q * kLength / area), sign, 1e-6) << n;
      r.side = weight > 0 ? Side::Down : Side::Up;  // the free end
      EXPECT_NEAR(value_of(m, r) / (q * kLength / area), 0, 1e-6) << n;
      r.side = Side::Both;
      r.kind = ResponseKind::Buckling;
      r.factor = 2;
      EXPECT_NEAR(value_of(m, r) / (q * kLength / euler), weight > 0 ? 0 : 1, 1e-6) << n;
    }
}

/// A load at a node is no spread load: with a load in the middle of the bar, up or down, and one
/// beside it, both sides have what hangs on them.
TEST_P(NodeForces, LoadsAtNodesAreNotSpread) {
  const double q = 9.81 * kSteel.rho * std::numbers::pi * kDiameter * kDiameter / 4;
  for (const double pull : {-300., 300.}) {
    Mechanism m = bar(8, GetParam());
    m.gravity = {9.81, 0, 0};
    for (int node : {3, 4}) pull_at(m, node, pull);
    const auto expect = [&](int element, ElementPlace place, double x, double loads) {
      EXPECT_NEAR(normal_force(m, element, place), q * (kLength - x) + loads * pull, 1e-5 * q)
          << element << " " << pull;
    };
    expect(0, ElementPlace::First, 0, 2);
    expect(2, ElementPlace::Last, 0.375, 2);
    expect(4, ElementPlace::First, 0.5, 0);
    expect(7, ElementPlace::First, 0.875, 0);
  }
}

/// Bars without mass or weight: loads at all nodes stay where they are.
TEST_P(NodeForces, LoadsAtAllNodesAreNotSpread) {
  Mechanism m = bar(3, GetParam());
  for (int node : {1, 2}) pull_at(m, node, 100);
  for (const auto place : {ElementPlace::First, ElementPlace::Last}) {
    EXPECT_NEAR(normal_force(m, 0, place), 200, 1e-4);
    EXPECT_NEAR(normal_force(m, 1, place), 100, 1e-4);
    EXPECT_NEAR(normal_force(m, 2, place), 0, 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Flexible, NodeForces,
                         ::testing::Values(Formalism::SE3, Formalism::R3SO3, Formalism::Classical,
                                           Formalism::Floating),
                         [](const auto& of) { return std::string(to_string(of.param)); });

/// A bend of 45 degrees far bent by its load: what the clamp transmits is the section force there,
/// and every node inside is in equilibrium by itself.
TEST(NodeForce, AreTheReactionOfTheClampAndInEquilibrium) {
  const Mechanism m = test::bend45(8, 600);
  const auto model = Model<SE3>::build(m, {});
  SimulationOptions o = test::tight();
  o.load_steps = 4;
  const auto solved = solve_static(model, o);
  ASSERT_EQ(solved.report.status, SolveStatus::Converged);
  State<SE3> s = model.initial_state();
  solved.trajectory.read(solved.trajectory.size() - 1, s);
  const BodyState<SE3> at = model.body_state(s, 0);
  const Body<SE3>& body = *model.bodies[0];
  const auto force = [&](int e, ElementPlace place) { return body.section_force(at, e, place); };

  const SE3::Tangent reaction = test::joint_wrench(model, s.H.data(), s.lambda, 0);
  const SE3::Tangent root = force(0, ElementPlace::First);
  EXPECT_LT((root + reaction).norm(), 1e-7 * root.norm());
  EXPECT_GT(root.tail<3>().norm(), 1e3);
  for (int e = 1; e < body.elements(); ++e)
    EXPECT_LT((force(e - 1, ElementPlace::Last) - force(e, ElementPlace::First)).norm(),
              1e-7 * root.norm());
  const Vec3 tip = s.H[8].R * force(7, ElementPlace::Last).head<3>();
  EXPECT_LT((tip - Vec3(0, 0, 600)).norm(), 1e-6 * 600);
}

/// Elements of order 4, too: the root of a bar that hangs carries its weight.
TEST(NodeForce, OfBeamsOfOrderFourCarryTheWeight) {
  const double q = 9.81 * kSteel.rho * std::numbers::pi * kDiameter * kDiameter / 4;
  for (int n : {2, 4}) {
    Mechanism m = bar(n, Formalism::SE3);
    std::get<BeamSpec>(m.bodies[0].kind).order = 4;
    m.gravity = {9.81, 0, 0};
    EXPECT_NEAR(normal_force(m, 0, ElementPlace::First) / (q * kLength), 1, 1e-6) << n;
    EXPECT_NEAR(normal_force(m, n - 1, ElementPlace::Last) / (q * kLength), 0, 1e-6) << n;
  }
}

/// Two bars of other thickness in one beam: at the root, away from the step, all of the weight; at
/// the step an error that falls with the length of the elements.
TEST(NodeForce, OfASteppedBarCarryTheWeight) {
  std::vector<double> errors;
  for (int n : {8, 16, 32}) {
    Mechanism m = bar(n, Formalism::SE3);
    auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
    for (std::size_t e = beam.sections.size() / 2; e < beam.sections.size(); ++e)
      beam.sections[e].shape = Circle{kDiameter / 2};
    m.gravity = {9.81, 0, 0};
    const double q = 9.81 * kSteel.rho * std::numbers::pi * kDiameter * kDiameter / 4;
    EXPECT_NEAR(normal_force(m, 0, ElementPlace::First) / (q * kLength * 5 / 8), 1, 1e-6) << n;
    const double below = q * kLength / 8;
    errors.push_back(std::abs(normal_force(m, n / 2, ElementPlace::First) / below - 1));
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 1, 0.1) << errors[i];
}

/// A quarter of a circle, clamped, under its weight along the tangent of its root: the normal force
/// there is all of it, but for an error that falls with the square of the length.
TEST(NodeForce, OfAnArcCarryTheWeight) {
  const double a = std::numbers::pi * kDiameter * kDiameter / 4;
  std::vector<double> errors;
  for (int n : {4, 8, 16, 32}) {
    Mechanism m = bar(n, Formalism::SE3);
    auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
    beam.nodes = arc(
        Arc::with_radius(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 0.5, std::numbers::pi / 2), n);
    m.gravity = {9.81, 0, 0};
    const double weight = 9.81 * kSteel.rho * a * 0.5 * std::numbers::pi / 2;
    errors.push_back(std::abs(normal_force(m, 0, ElementPlace::First) / weight - 1));
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_GT(std::log2(errors[i - 1] / errors[i]), 1.7) << errors[i];
}

/// In the plane, in motion: at the pin the rod's section force is what the pin transmits, but for
/// an error that falls with the square of the length of the elements.
TEST(NodeForce, AtAPinAreTheForceOfTheJoint) {
  std::vector<double> errors;
  for (int n : {4, 8, 16}) {
    Mechanism m = test::slider_crank({n});
    m.drives[0].motion = TimeFunction::rate(60, 0.02);
    const auto run = test::run_planar(m, test::options(0.03, 1e-4));
    ASSERT_EQ(run.report().status, SolveStatus::Converged);
    State<SE2> s = run.model->initial_state();
    run.trajectory().read(run.trajectory().size() - 1, s);
    ResponseSpec force;
    force.kind = ResponseKind::SectionForce;
    force.body = 1;
    force.place = ElementPlace::First;
    const SE3::Tangent pin = joint_force(m, *run.model, 1, s);
    ASSERT_GT(pin.norm(), 10) << "a force to compare with";
    double error = 0;
    for (force.component = 0; force.component < 2; ++force.component)
      error += std::abs(ResponseValues<SE2>(m, *run.model)(force, s)[0] + pin[force.component]);
    errors.push_back(error);
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_GT(std::log2(errors[i - 1] / errors[i]), 1.7) << errors[i];
}

/// In motion the forces at both sides of a node differ by its share of the internal force, which is
/// its load in the equivalent static load case.
TEST(NodeForce, MakeTheLoadsOfTheEquivalentStaticCases) {
  Mechanism m = test::slider_crank({4});
  m.drives[0].motion = TimeFunction::rate(60, 0.02);
  const auto run = test::run_planar(m, test::options(0.03, 5e-4));
  ASSERT_EQ(run.report().status, SolveStatus::Converged);
  State<SE2> s = run.model->initial_state();
  const Body<SE2>& body = *run.model->bodies[1];
  for (int n = 7; n < run.trajectory().size(); n += 7) {
    run.trajectory().read(n, s);
    const BodyState<SE2> at = run.model->body_state(s, 1);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(body.size()), internal = f;
    ForceScale scale;
    body.add_internal(at, internal.data(), scale);
    for (int e = 0; e < body.elements(); ++e) {
      f.segment<3>(3 * e) -= body.section_force(at, e, ElementPlace::First);
      f.segment<3>(3 * e + 3) += body.section_force(at, e, ElementPlace::Last);
    }
    EXPECT_LT((f - internal).norm(), 1e-9 * internal.norm());
    EXPECT_GT(internal.norm(), 1);
  }
}

}  // namespace
}  // namespace liesl::test::node_force_test
