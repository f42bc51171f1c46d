/// @file
/// Derivatives of stress and compliance of meshed parts over a motion, by material, thickness and
/// the radius of a hole: direct, adjoint and differences. Reduced parts, whose modes follow the
/// outline, and continua.

#include "mbs/sensitivity/meshed_quantities.hpp"
#include "mbs/sensitivity/response_histories.hpp"
#include "reference/continuum.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::part_stress_sensitivity_test {
namespace {

/// A rod with its first end held, whose other end a slider pulls and bends on an inclined guide,
/// and a load on its interface `loaded`, if there is one: stress grows all the time, and its
/// largest stays where it is. No density: what inertia changes of it is round-off beside that.
/// @param rate of the slider after 0.02 s, m/s
Mechanism pulled(const SolidSpec& rod, int loaded, double rate) {
  Mechanism m;
  m.bodies = {{"slider", block({kRodLength, 0, 0}, 0.2, 1e-4)}, {"rod", rod}};
  m.joints = {{"clamp", JointType::Fixed, {}, {1, 0}},
              {"wrist", JointType::Revolute, {1, 1}, {0, 0}},
              {"guide", JointType::Prismatic, {}, {0, 0}, Vec3(1, 1, 0).normalized()}};
  m.drives = {{2, 0, TimeFunction::rate(rate, 0.02)}};
  LoadSpec load;
  load.name = "load";
  load.port = {1, loaded};
  load.force = {20, 0, 0};
  load.scale = TimeFunction::expression("(50*t)^2");
  if (loaded > 0) m.loads = {load};
  return m;
}

std::vector<ResponseSpec> stress_and_compliance() {
  std::vector<ResponseSpec> all(2);
  all[0].kind = ResponseKind::Stress;
  all[1].kind = ResponseKind::Compliance;
  for (ResponseSpec& r : all) {
    r.name = name_of(r.kind);
    r.body = 1;
  }
  return all;
}

Quantity radius_of_the_hole(const Mechanism& m) {
  return {outline_values(part(m))[outline_number(part(m), "hole.radius")],
          [](Mechanism& c, double p) { set_outline(part(c), "hole.radius", p); },
          {"radius", {SolidDerivative{1, fractions_by(part(m), "hole.radius")}}}};
}

/// All but the density.
std::vector<Quantity> quantities_of(const Mechanism& m) {
  auto all = scales_of_the_part(m);
  std::erase_if(all, [](const Quantity& q) { return q.parameter.name == "rho"; });
  if (!part(m).outline.features.empty()) all.push_back(radius_of_the_hole(m));
  return all;
}

/// No corner of the 4 x 4 parts of a cell comes onto the edge of the hole with 7 % more or less.
constexpr double kRadius = 0.00465, kMost = 0.07;

template <class G>
class ReducedPartResponse : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ReducedPartResponse, Groups);

TYPED_TEST(ReducedPartResponse, HasItsDerivatives) {
  constexpr bool plane = TypeParam::space_dim == 2;
  SolidSpec rod = meshed_rod({0, 0, 0}, plane ? 30 : 16, plane ? 2 : 1, 4, plane ? 0 : 1);
  rod.model = of_material(*rod.model, {"plastic", 1e9, 0.3, 1200});
  if (plane) cut_hole(rod, 0.1, 0, kRadius);
  const Mechanism m = pulled(rod, 2, 0.01);
  expect_response_gradients<TypeParam>(m, tight(0.02, 4e-4), quantities_of(m),
                                       stress_and_compliance(), {.largest = kMost});
}

SolidSpec with_a_hole(SolidLaw law) {
  SolidSpec rod =
      continuum_block({kRodLength, 0.06, kRodThickness}, 15, 3, 0, {"softer", 4e7, 0.3, 1200}, law);
  cut_hole(rod, 0.075, 0.005, 0.019);
  return rod;
}

/// As of `ContinuumSensitivity`: until the radius has changed by 1 mm its edge passes no place at
/// which cells are sampled; a cell is void. Pulled ten times as far: the energy of the neo-Hookean
/// law has less round-off then. Not by the thickness: without a load no stress follows it, since
/// all forces of the rod grow with it alike; by E stress and compliance are linear.
TEST(ContinuumResponse, HasItsDerivatives) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    const Mechanism m = pulled(with_a_hole(law), 0, 0.1);
    auto all = quantities_of(m);
    std::erase_if(all, [](const Quantity& q) { return q.parameter.name == "thickness"; });
    ASSERT_EQ(all.size(), 2u);
    expect_response_gradients<SE2>(m, tight(0.02, 4e-4), all, stress_and_compliance(),
                                   {.largest = 0.045, .linear = {"E"}});
  }
}

/// At a constant state a change of the length strains the rod by more than its motion does: other
/// cells would have the largest stress.
TEST(ContinuumResponse, HasItsDerivativeByTheLength) {
  const Mechanism m = pulled(with_a_hole(SolidLaw::StVenantKirchhoff), 0, 0.1);
  const Quantity length = by_nearby("length", m, kRodLength, [](Mechanism& c, double p) {
    stretch_rod(c, 0, p / kRodLength);
    std::get<RigidSpec>(c.bodies[0].kind).frame.x = {p, 0, 0};
  });
  expect_response_gradients<SE2>(m, tight(0.02, 4e-4), {length}, stress_and_compliance(),
                                 {.largest = 0.01});
}

}  // namespace
}  // namespace liesl::test::part_stress_sensitivity_test
