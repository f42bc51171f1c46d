/// @file
/// Derivatives of motions under every formalism and update: direct form, adjoint form and
/// differences of simulations.

#include "mbs/sensitivity/forms.hpp"

namespace liesl::test::formalism_sensitivity_test {
namespace {

/// A formalism, with an update of its own or not.
struct Case {
  const char* name;
  Formalism formalism;
  NodeUpdate update = NodeUpdate::AsFormalism;
  double largest = 0.16;  ///< relative change of differences; a larger one halves a step
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

const std::vector<Case> kCases{{"r3so3", Formalism::R3SO3},
                               {"classical", Formalism::Classical},
                               {"floating", Formalism::Floating},
                               {"rigid", Formalism::Rigid},
                               {"se3_by_r3so3", Formalism::SE3, NodeUpdate::R3SO3},
                               {"r3so3_by_screws", Formalism::R3SO3, NodeUpdate::Screw, 0.08}};

Mechanism under(Mechanism m, const Case& c) {
  m.formalism = c.formalism;
  m.update = c.update;
  return m;
}

/// Slow enough for floating frames, which do not stiffen beams of plastic.
void slow_down(Mechanism& m) {
  if (m.formalism == Formalism::Floating) m.drives = {{0, 0, TimeFunction::rate(50, 0.02)}};
}

std::vector<Quantity> quantities_of(const Mechanism& m) {
  auto all = quantities(m);
  if (m.formalism == Formalism::Floating) all.pop_back();  // the drive
  return all;
}

Mechanism in_a_plane(const Case& c, double E = 7e9) {
  Mechanism m = under(sensitive_machine(E), c);
  slow_down(m);
  return m;
}

/// In space the weight, the loads and the disc bend the beams out of the plane of their motion.
Mechanism out_of_plane(const Case& c, double E = 7e9) {
  Mechanism m = in_a_plane(c, E);
  m.gravity.z() = 2;
  m.loads[0].force.z() = 2;
  std::get<RigidSpec>(m.bodies[3].kind).centre.z() = 0.01;
  return m;
}

/// A beam of plastic with a mass at its tip, spun about no axis of it: its rotation vectors turn by
/// more than pi, and are rescaled on the way.
Mechanism spun_pendulum() {
  const Vec3 spin(9, 6, 20);
  Mechanism m;
  m.gravity = {0, -9.81, 2};
  m.bodies = {{"beam", straight_beam({0, 0, 0}, {0.4, 0, 0}, 3, round_section(0.03, 0.9),
                                     {"plastic", 7e9, 0.3, 1200})},
              {"bob", block({0.4, 0, 0}, 0.3, 2e-4)}};
  std::get<RigidSpec>(m.bodies[1].kind).centre = {0.01, 0.02, 0.015};
  m.bodies[0].angular_velocity = m.bodies[1].angular_velocity = spin;
  m.bodies[1].velocity = spin.cross(Vec3(0.4, 0, 0));
  m.joints = {{"ball", JointType::Spherical, {}, {0, 0}},
              {"bolt", JointType::Fixed, {0, 3}, {1, 0}}};
  return m;
}

std::vector<Quantity> quantities_of_the_pendulum(const Mechanism& m) {
  const auto beam = [](Mechanism& c) -> BeamSpec& { return std::get<BeamSpec>(c.bodies[0].kind); };
  const auto bob = [](Mechanism& c) -> RigidSpec& { return std::get<RigidSpec>(c.bodies[1].kind); };
  return {{0.03,
           [beam](Mechanism& c, double p) {
             for (const int e : {0, 1}) std::get<Circle>(beam(c).sections[e].shape).diameter = p;
           },
           {"diameter", {by_dimension(m, 0, {0, 1}, "diameter")}}},
          {1200,
           [beam](Mechanism& c, double p) { beam(c).material.rho = p; },
           {"rho", {by_density(m, 0)}}},
          {0.3,
           [bob](Mechanism& c, double p) { bob(c).mass = p; },
           {"mass of the bob", {RigidDerivative{1, 1}}}},
          {0.02,
           [bob](Mechanism& c, double p) { bob(c).centre.y() = p; },
           {"centre of the bob", {RigidDerivative{1, 0, {0, 1, 0}}}}}};
}

class FormalismSensitivity : public ::testing::TestWithParam<Case> {};

TEST_P(FormalismSensitivity, DirectEqualsAdjointInAPlane) {
  const Mechanism m = in_a_plane(GetParam());
  for (const int steps : {10, 100, 1000})
    expect_direct_equals_adjoint<SE2>(steps, m, quantities_of(m));
}

/// Rounding grows with EA (StiffnessSlow): with E = 7e9 up to 1.0e-10 of an output (classical). So
/// errors are relative to the largest output of their kind there, and with E = 4e9 to the output
/// itself, down to 1e-6 of its kind.
void expect_direct_equals_adjoint_in_space(const Case& c) {
  for (const auto& [E, least] : {std::pair(7e9, 1.0), std::pair(4e9, 1e-6)}) {
    const Mechanism m = out_of_plane(c, E);
    for (const int steps : {10, 100, 1000})
      expect_direct_equals_adjoint<SE3>(steps, m, quantities_of(m), 2e-4, 1, least);
  }
}

TEST_P(FormalismSensitivity, DirectEqualsAdjointInSpace) {
  expect_direct_equals_adjoint_in_space(GetParam());
}

/// Every step stretches, and with it what the drive does in it.
TEST_P(FormalismSensitivity, DirectEqualsAdjointByTheDuration) {
  Mechanism m = out_of_plane(GetParam());
  m.loads.pop_back();  // follows time, not the duration
  const int steps = 100;
  const Parameter duration{"duration", {StepDerivative{1 / (steps * 2e-4)}}};
  expect_direct_equals_adjoint<SE3>(steps, m, {{steps * 2e-4, {}, duration}});
}

TEST_P(FormalismSensitivity, EqualsDifferencesInAPlane) {
  const Mechanism m = in_a_plane(GetParam());
  expect_differences<SE2>(m, quantities_of(m),
                          {.largest = GetParam().largest, .linear = kLoadsOfTheMachine});
}

TEST_P(FormalismSensitivity, EqualsDifferencesInSpace) {
  const Mechanism m = out_of_plane(GetParam());
  expect_differences<SE3>(m, quantities_of(m),
                          {.largest = GetParam().largest, .linear = kLoadsOfTheMachine});
}

constexpr auto kName = [](const auto& of) { return std::string(of.param.name); };

/// Not of rigid bodies, whose motion a drive prescribes; of the others below.
INSTANTIATE_TEST_SUITE_P(All, FormalismSensitivity, ::testing::Values(kCases[0], kCases[1]), kName);

/// In floating frames with loads on every node: forces of an element act on its nodes and on the
/// frame.
TEST(FloatingSensitivity, DirectEqualsAdjoint) {
  const Mechanism plane = in_a_plane(kCases[2]), space = out_of_plane(kCases[2]);
  for (const int steps : {10, 100, 1000}) {
    expect_direct_equals_adjoint<SE2>(steps, plane, quantities_of(plane));
    expect_direct_equals_adjoint<SE3>(steps, space, quantities_of(space));
  }
}

/// Of rubber and slow: EA/L times round-off is smaller beside the forces, by sections 2.5e-8 of
/// them in place of 3e-7.
TEST(FloatingSensitivity, BySectionsEqualsDifferences) {
  Mechanism m = in_a_plane(kCases[2], 7e8);
  m.drives = {{0, 0, TimeFunction::rate(20, 0.02)}};
  auto all = quantities_of(m);
  all.resize(3);
  expect_differences<SE2>(m, all, {.largest = 0.08});
}

/// Let go instead of driven: masses, springs, dampers and loads set the motion of rigid bodies.
class LetGoSensitivity : public ::testing::TestWithParam<Case> {
 protected:
  Mechanism plane = in_a_plane(GetParam(), 7e8), space = out_of_plane(GetParam(), 7e8);
  std::vector<Quantity> all;
  DifferenceOptions by{.node = 0, .of_kind = true};

  void SetUp() override {
    plane.drives.clear();
    space.drives.clear();
    all = quantities(plane);
    all.pop_back();  // the drive
    by.simulation.tolerance = 1e-12;
    if (plane.formalism != Formalism::Rigid) return;
    std::erase_if(all, [](const Quantity& q) { return q.parameter.name == "E"; });
    by.simulation = tight(0.3, 2e-3);
    by.simulation.tolerance = 1e-12;
    by.largest = 0.4;  // its motion is nearly linear in loads and masses
  }
};

TEST_P(LetGoSensitivity, DirectEqualsAdjoint) {
  for (const int steps : {10, 100, 1000}) {
    expect_direct_equals_adjoint<SE2>(steps, plane, all, 2e-4, 0, 1);
    expect_direct_equals_adjoint<SE3>(steps, space, all, 2e-4, 0, 1);
  }
}

TEST_P(LetGoSensitivity, EqualsDifferencesInAPlane) { expect_differences<SE2>(plane, all, by); }

TEST_P(LetGoSensitivity, EqualsDifferencesInSpace) { expect_differences<SE3>(space, all, by); }

INSTANTIATE_TEST_SUITE_P(All, LetGoSensitivity, ::testing::Values(kCases[2], kCases[3]), kName);

/// Elements of one formalism with the update of another.
TEST(UpdateSensitivity, EqualsTheAdjointFormAndDifferencesInAPlane) {
  for (const Case& c : {kCases[4], kCases[5]}) {
    const Mechanism m = in_a_plane(c);
    for (const int steps : {10, 100, 1000})
      expect_direct_equals_adjoint<SE2>(steps, m, quantities_of(m));
    expect_differences<SE2>(m, quantities_of(m),
                            {.largest = c.largest, .linear = kLoadsOfTheMachine});
  }
}

TEST(UpdateSensitivity, DirectEqualsAdjointInSpace) {
  for (const Case& c : {kCases[4], kCases[5]}) expect_direct_equals_adjoint_in_space(c);
}

/// How near differences come to the gradients, over E in GPa: the table of docs/sensitivities.md.
/// Their error is round-off of positions times EA/L; it falls with E, and that of the gradients is
/// not seen. best_p is that of parameter p, in 1e-9.
struct OverStiffness {
  const char* name;
  int update;  ///< of kCases
  double E;
  double error, adjoint;  ///< allowed: of differences, of the adjoint form in space; 0: not asked
};
std::ostream& operator<<(std::ostream& out, const OverStiffness& c) { return out << c.name; }
class StiffnessSlow : public ::testing::TestWithParam<OverStiffness> {};

TEST_P(StiffnessSlow, BoundsHowNearDifferencesCome) {
  const Case& c = kCases[std::size_t(GetParam().update)];
  const double E = GetParam().E * 1e9;
  Mechanism m = in_a_plane(c, E);
  DifferenceOptions options{
      .largest = c.largest, .error = GetParam().error, .linear = kLoadsOfTheMachine};
  options.linear.push_back("rest");  // of the spring, which is soft
  auto all = quantities_of(m);
  if (m.formalism == Formalism::Floating) {
    m.drives = {{0, 0, TimeFunction::rate(20, 0.02)}};
    all = quantities_of(m);
    all.resize(3);
    options.largest = 0.08;
  }
  expect_differences<SE2>(m, all, options);
  const Mechanism space = out_of_plane(c, E);
  if (GetParam().adjoint > 0)
    expect_direct_equals_adjoint<SE3>(100, space, quantities_of(space), 2e-4, 1, 1e-6,
                                      GetParam().adjoint);
}

INSTANTIATE_TEST_SUITE_P(All, StiffnessSlow,
                         ::testing::Values(OverStiffness{"screws_21", 5, 21, 7e-7, 2e-10},
                                           OverStiffness{"screws_14", 5, 14, 3e-7, 2e-10},
                                           OverStiffness{"screws_7", 5, 7, 1e-7, 1.5e-10},
                                           OverStiffness{"screws_3_5", 5, 3.5, 1e-7, 1e-10},
                                           OverStiffness{"r3so3_updates_21", 4, 21, 7e-7, 2e-10},
                                           OverStiffness{"r3so3_updates_14", 4, 14, 3e-7, 2e-10},
                                           OverStiffness{"r3so3_updates_7", 4, 7, 1e-7, 1.5e-10},
                                           OverStiffness{"r3so3_updates_3_5", 4, 3.5, 1e-7, 1e-10},
                                           OverStiffness{"r3so3_7", 0, 7, 1e-7, 1.5e-10},
                                           OverStiffness{"floating_7", 2, 7, 4e-7, 0},
                                           OverStiffness{"floating_0_7", 2, 0.7, 5e-8, 0}),
                         kName);

class SpunPendulumSensitivity : public ::testing::TestWithParam<Case> {};

/// Multipliers are forces of 30 N beside moments of 0.01 N m, which have their rounding.
TEST_P(SpunPendulumSensitivity, DirectEqualsAdjoint) {
  const Mechanism m = under(spun_pendulum(), GetParam());
  for (const int steps : {10, 150, 1000})
    expect_direct_equals_adjoint<SE3>(steps, m, quantities_of_the_pendulum(m), 1.5e-3, 0, 1);
}

/// Rounding of 110 steps adds up, with little damping: of `classical` by the diameter it ends
/// extrapolations at 1.1e-7, a fit to many differences at 4e-8. Sections of floating frames, whose
/// high modes change phase many times, are above.
TEST_P(SpunPendulumSensitivity, EqualsDifferences) {
  const Mechanism m = under(spun_pendulum(), GetParam());
  auto all = quantities_of_the_pendulum(m);
  if (m.formalism == Formalism::Floating) all.erase(all.begin());
  auto o = tight(0.165, 1.5e-3);
  o.tolerance = m.formalism == Formalism::Classical ? 1e-11 : 1e-12;  // steps are not halved
  const double largest = m.formalism == Formalism::Rigid       ? 0.16
                         : m.formalism == Formalism::Classical ? 0.04
                                                               : 0.06;
  expect_differences<SE3>(m, all,
                          {.simulation = o,
                           .node = 0,
                           .largest = largest,
                           .of_kind = true,
                           .samples = m.formalism == Formalism::Classical ? 48 : 0});
}

/// What the pendulum is there for: after a whole turn the rotation vectors were rescaled.
TEST(SpunPendulum, TurnsByMoreThanPi) {
  const Mechanism m = under(spun_pendulum(), kCases[1]);
  const Taped<SE3> run(m, tight(0.165, 1.5e-3));
  double largest = 0;
  bool rescaled = false;
  Vec3 before = Vec3::Zero();
  Replay<SE3> replay(run.model, run.tape);
  for (int i = 0; i < replay.stretches(); ++i)
    replay.run(i, [&](const State<SE3>&, const State<SE3>& after, double) {
      const Vec3 psi = after.w.segment<3>(3);
      largest = std::max(largest, psi.norm());
      rescaled = rescaled || psi.dot(before) < 0;
      before = psi;
    });
  EXPECT_LE(largest, M_PI);
  EXPECT_TRUE(rescaled);
}

INSTANTIATE_TEST_SUITE_P(All, SpunPendulumSensitivity, ::testing::ValuesIn(kCases), kName);

}  // namespace
}  // namespace liesl::test::formalism_sensitivity_test
