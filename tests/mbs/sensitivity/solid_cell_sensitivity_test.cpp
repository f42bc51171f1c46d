/// @file
/// Sensitivities of motions of meshed parts whose nodes all move, of every kind of cell, over 1000
/// steps and against differences: by E, rho, thickness, lengths and what is beside the part.

#include "mbs/sensitivity/forms.hpp"
#include "mbs/sensitivity/meshed_quantities.hpp"
#include "mbs/solids/meshes.hpp"
#include "reference/continuum.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::solid_cell_sensitivity_test {
namespace {

constexpr double kHeight = 0.06, kDepth = 0.03;

/// Cells of a rod, and of how many boxes of them it is.
struct Case {
  const char* name;
  int dim, nodes, boxes;
  SolidLaw law = SolidLaw::StVenantKirchhoff;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

/// A slider-crank with a stout meshed rod: round-off of positions is little beside the forces of a
/// soft one. In space its weight bends it out of the plane of its motion, too.
Mechanism machine_with_rod(const Case& c, double E) {
  const Material material = {"soft", E, 0.3, 1200};
  SolidSpec rod = continuum_block({kRodLength, kHeight, kDepth}, c.boxes, 1, c.dim == 3 ? 1 : 0,
                                  material, c.law);
  rod.model = mesh_with_ends(in_cells(rod.mesh(), cell_kind(c.dim, c.nodes)), material,
                             Vec3::Zero(), {kRodLength, 0, 0}, {kDepth, {}});
  rod.frame.x = {0.15, 0, 0};
  rod.damping = 1e-5;
  Mechanism m = slider_crank_with(rod, 1);
  m.gravity = {0, -9.81, c.dim == 3 ? 10. : 0.};
  return m;
}

/// All that scales the rod, and the mass that it drives.
std::vector<Quantity> scales_of(const Mechanism& m) {
  auto all = scales_of_the_part(m);
  all.push_back({0.2,
                 [](Mechanism& c, double p) { std::get<RigidSpec>(c.bodies[2].kind).mass = p; },
                 {"mass of the slider", {RigidDerivative{2, 1}}}});
  return all;
}

/// These, and lengths, which nodes follow. By its depth of hexahedra alone: of tetrahedra round-off
/// leaves 2e-7 of the differences.
std::vector<Quantity> with_lengths(const Mechanism& m) {
  auto all = scales_of(m);
  all.push_back(by_nearby("length", m, kRodLength, [](Mechanism& c, double p) {
    stretch_rod(c, 0, p / kRodLength);
    std::get<RigidSpec>(c.bodies[2].kind).frame.x = {0.15 + p, 0, 0};
  }));
  all.push_back(by_nearby("height", m, kHeight,
                          [](Mechanism& c, double p) { stretch_rod(c, 1, p / kHeight); }));
  const CellKind& kind = part(m).mesh().kind();
  if (kind.dim == 3 && kind.family != CellFamily::Simplex)
    all.push_back(by_nearby("depth", m, kDepth,
                            [](Mechanism& c, double p) { stretch_rod(c, 2, p / kDepth); }));
  return all;
}

/// By lengths not after 10 steps: few outputs have grown by them, the others are round-off.
template <FrameGroup G>
void expect_both_forms(const Mechanism& m) {
  constexpr double kStep = 4e-4;
  expect_direct_equals_adjoint<G>(10, m, scales_of(m), kStep);
  for (const int steps : {100, 1000})
    expect_direct_equals_adjoint<G>(steps, m, with_lengths(m), kStep);
}

void expect_both_forms_of(const Case& c) {
  const Mechanism m = machine_with_rod(c, 1e8);
  c.dim == 2 ? expect_both_forms<SE2>(m) : expect_both_forms<SE3>(m);
}

void expect_differences_of(const Case& c) {
  const Mechanism m = machine_with_rod(c, 1e7);
  const DifferenceOptions options{.largest = 0.1, .of_kind = true};
  c.dim == 2 ? expect_differences<SE2>(m, with_lengths(m), options)
             : expect_differences<SE3>(m, with_lengths(m), options);
}

class SolidCellSensitivity : public ::testing::TestWithParam<Case> {};

TEST_P(SolidCellSensitivity, DirectEqualsAdjoint) { expect_both_forms_of(GetParam()); }
TEST_P(SolidCellSensitivity, EqualsDifferences) { expect_differences_of(GetParam()); }

constexpr auto kCellName = [](const auto& of) { return std::string(of.param.name); };

INSTANTIATE_TEST_SUITE_P(All, SolidCellSensitivity,
                         ::testing::Values(Case{"T3", 2, 3, 4}, Case{"T6", 2, 6, 3},
                                           Case{"Q4", 2, 4, 4},
                                           Case{"Q4_neo_hookean", 2, 4, 4, SolidLaw::NeoHookean},
                                           Case{"Q8", 2, 8, 2}, Case{"T4", 3, 4, 3},
                                           Case{"H8", 3, 8, 3}),
                         kCellName);

class SolidCellSensitivitySlow : public ::testing::TestWithParam<Case> {};

TEST_P(SolidCellSensitivitySlow, DirectEqualsAdjoint) { expect_both_forms_of(GetParam()); }
TEST_P(SolidCellSensitivitySlow, EqualsDifferences) { expect_differences_of(GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, SolidCellSensitivitySlow,
                         ::testing::Values(Case{"H8_neo_hookean", 3, 8, 3, SolidLaw::NeoHookean},
                                           Case{"T10", 3, 10, 1}, Case{"H20", 3, 20, 1}),
                         kCellName);

}  // namespace
}  // namespace liesl::test::solid_cell_sensitivity_test
