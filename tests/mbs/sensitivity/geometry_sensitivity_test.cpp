/// @file
/// Derivatives of motions by geometry and whatever else has no derivative of its own: direct form,
/// adjoint form and differences of simulations.

#include "mbs/sensitivity/forms.hpp"

namespace liesl::test::geometry_sensitivity_test {
namespace {

constexpr int kNode = 3;  // of the rod, at its end: inner nodes of a chain have no frame

void place(Mechanism& m, double crank, double rod) {
  const auto beam = [&m](std::size_t b, double from, double to) {
    std::get<BeamSpec>(m.bodies[b].kind).nodes = straight({from, 0, 0}, {to, 0, 0}, 3);
  };
  beam(0, 0, crank);
  beam(1, crank, crank + rod);
  std::get<RigidSpec>(m.bodies[2].kind).frame.x = {crank + rod, 0, 0};
  if (m.bodies.size() > 3) std::get<RigidSpec>(m.bodies[3].kind).frame.x = {crank / 3, 0, 0};
}

std::vector<Quantity> lengths(const Mechanism& m) {
  return {
      by_nearby("length of the crank", m, 0.15, [](Mechanism& c, double p) { place(c, p, 0.3); }),
      by_nearby("length of the rod", m, 0.3, [](Mechanism& c, double p) { place(c, 0.15, p); })};
}

constexpr double kDamping = 1e-3, kGravity = -981;  // that count beside the inertia

Mechanism damped_and_heavy(Mechanism m) {
  std::get<BeamSpec>(m.bodies[1].kind).damping = kDamping;
  m.gravity.y() = kGravity;
  return m;
}

std::vector<Quantity> damping_and_gravity(const Mechanism& m) {
  return {
      by_nearby("damping", m, kDamping,
                [](Mechanism& c, double p) { std::get<BeamSpec>(c.bodies[1].kind).damping = p; }),
      by_nearby("gravity", m, kGravity, [](Mechanism& c, double p) { c.gravity.y() = p; })};
}

/// Beams so stout that shear counts; of slender ones rounding of differences is 1e-6 of what
/// Poisson's ratio changes.
Mechanism stout(Mechanism m) {
  constexpr double kDiameter = 0.08, kE = 1e7;
  for (const std::size_t b : {0, 1}) {
    auto& beam = std::get<BeamSpec>(m.bodies[b].kind);
    beam.material.E = kE;
    for (auto& section : beam.sections) std::get<Circle>(section.shape).diameter = kDiameter;
  }
  return m;
}

/// Segments have no shear.
std::vector<Quantity> poissons_ratio(const Mechanism& m) {
  if (m.formalism == Formalism::Segments) return {};
  return {by_nearby("Poisson's ratio", m, 0.3, [](Mechanism& c, double p) {
    std::get<BeamSpec>(c.bodies[1].kind).material.nu = p;
  })};
}

/// Next to the start from a dead point few outputs have grown to more than a thousandth of their
/// kind, and the others are round-off of those: on the group the states go with the geometry
/// (`NearbyModels::lift`), other coordinates do not move along it, and EA/L times what the frames
/// move cancels the change of the strain by a length.
template <FrameGroup G>
void expect_both_forms(const Mechanism& m, const std::vector<Quantity>& all) {
  const bool lifted = m.formalism == Formalism::SE3;
  expect_direct_equals_adjoint<G>(10, m, all, 2e-4, kNode, lifted ? 1e-3 : 1e-6,
                                  lifted ? 1e-10 : 3e-8);
  expect_direct_equals_adjoint<G>(100, m, all, 2e-4, kNode, 1e-6, 3e-10);
}

struct Case {
  const char* name;
  Formalism formalism;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class GeometrySensitivity : public ::testing::TestWithParam<Case> {};

TEST_P(GeometrySensitivity, BothFormsAreThatOfDifferences) {
  Mechanism m = sensitive_machine(7e8);
  m.formalism = GetParam().formalism;
  if (m.formalism == Formalism::Segments) {  // the disc is bolted to an inner node
    m.bodies.pop_back();
    m.joints.pop_back();
  }
  expect_both_forms<SE2>(m, lengths(m));
  expect_differences<SE2>(m, lengths(m), {.node = kNode, .largest = 0.08});
  const Mechanism heavy = damped_and_heavy(m);
  expect_both_forms<SE2>(heavy, damping_and_gravity(heavy));
  expect_differences<SE2>(heavy, damping_and_gravity(heavy), {.node = kNode, .largest = 0.08});
  expect_both_forms<SE2>(m, poissons_ratio(m));
  const Mechanism short_beams = stout(m);
  expect_both_forms<SE2>(short_beams, poissons_ratio(short_beams));
  expect_differences<SE2>(short_beams, poissons_ratio(short_beams),
                          {.node = kNode, .largest = 0.08, .samples = 24});
}

INSTANTIATE_TEST_SUITE_P(All, GeometrySensitivity,
                         ::testing::Values(Case{"se3", Formalism::SE3},
                                           Case{"r3so3", Formalism::R3SO3},
                                           Case{"classical", Formalism::Classical},
                                           Case{"segments", Formalism::Segments}),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(GeometrySensitivities, InSpaceBothFormsAreThatOfDifferences) {
  Mechanism m = sensitive_machine(7e8);
  m.gravity.z() = 2;
  expect_both_forms<SE3>(m, lengths(m));
  expect_differences<SE3>(m, lengths(m), {.node = kNode, .largest = 0.08});
}

/// By the derivatives of the laws and by nearby mechanisms the same.
TEST(GeometrySensitivities, OfSectionsAreThoseOfTheirLaws) {
  const Mechanism m = sensitive_machine();
  const auto diameter = [](Mechanism& c, double p) {
    for (auto& s : std::get<BeamSpec>(c.bodies[1].kind).sections)
      std::get<Circle>(s.shape).diameter = p;
  };
  const Quantity laws{0.016, diameter, {"laws", {by_dimension(m, 1, {0, 1, 2}, "diameter")}}};
  const Taped<SE2> run(m, tight(0.02, 2e-4));
  const auto parameters = run.parameters({laws, by_nearby("nearby", m, 0.016, diameter)});
  const Outputs<SE2> outputs(run.model);
  double size = 0, off = 0;
  const auto end = direct_sensitivity<SE2>(
      run.model, run.tape, parameters, [&](long, const State<SE2>& s, const auto& ds) {
        const MatrixXd dy = outputs.derivatives(s, ds);
        size = std::max(size, dy.col(0).head<2>().norm());
        off = std::max(off, (dy.col(0) - dy.col(1)).head<2>().norm());
      });
  ASSERT_TRUE(end.complete()) << end.reason;
  EXPECT_LT(off, 1e-8 * size);
}

/// Named, not computed wrongly.
TEST(GeometrySensitivities, OfJointsThatOpenAndOfFloatingFramesAreRefused) {
  Mechanism m = sensitive_machine();
  const auto refusal = [&m](const Quantity& quantity) -> std::string {
    const Taped<SE2> run(m, tight(0.002, 2e-4));
    try {
      const auto parameters = run.parameters({quantity});
      direct_sensitivity<SE2>(run.model, run.tape, parameters, [](auto&&...) {});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const auto open = by_nearby("end of the rod", m, 0.3, [](Mechanism& c, double p) {
    std::get<BeamSpec>(c.bodies[1].kind).nodes = straight({0.15, 0, 0}, {0.15 + p, 0, 0}, 3);
  });
  EXPECT_NE(refusal(open).find("'end of the rod' opens joints"), std::string::npos)
      << refusal(open);
  m.formalism = Formalism::Floating;
  const auto rod = by_nearby("length", m, 0.3, [](Mechanism& c, double p) { place(c, 0.15, p); });
  EXPECT_NE(refusal(rod).find("floating frames"), std::string::npos) << refusal(rod);
}

}  // namespace
}  // namespace liesl::test::geometry_sensitivity_test
