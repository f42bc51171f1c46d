/// @file
/// Sensitivities of motions of a meshed part that is reduced to its interfaces and modes: by its
/// material and thickness, which scale it, and by its outline, which the modes follow.

#include <algorithm>

#include "mbs/sensitivity/forms.hpp"
#include "mbs/sensitivity/meshed_quantities.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::reduced_part_test {
namespace {

constexpr int kMid = 2;  // interface of the rod
constexpr int kModes = 4;
/// No corner of the 4 x 4 parts of a cell comes onto the edge of the hole with 7 % more or less:
/// those around it are 4.30 and 5.00 mm from its centre.
constexpr double kRadius = 0.00465, kMost = 0.07, kMostInSpace = 0.16;

/// A slider-crank with a rod of plastic, of 30 x 2 cells with a hole; in space of hexahedra.
template <class G>
Mechanism machine() {
  constexpr bool plane = G::space_dim == 2;
  Mechanism m = slider_crank_with_mesh(plane ? 30 : 16, plane ? 2 : 1, kModes, plane ? 0 : 1);
  SolidSpec& rod = part(m);
  rod.model = of_material(*rod.model, {"plastic", 1e9, 0.3, 1200});
  rod.damping = 1e-5;
  if (plane)
    rod.outline = {2,
                   {{"bar", levelset::FeatureKind::HalfSpace, {2, 0, 0}, {}},
                    {"hole", levelset::FeatureKind::Circle, {0.1, 0, 0, kRadius}, {}},
                    {"all", levelset::FeatureKind::Difference, {}, {"bar", "hole"}}}};
  m.gravity = {0, -9.81, plane ? 0. : 2.};
  m.drives = {{0, 0, TimeFunction::rate(50, 0.02)}};
  return m;
}

Quantity radius_of_the_hole(const Mechanism& m) {
  const SolidSpec& rod = part(m);
  const auto names = levelset::make_shape(rod.outline)->parameters();
  const auto radius = std::find_if(names.begin(), names.end(),
                                   [](const auto& p) { return p.name == "hole.radius"; });
  const MatrixXd by_shape(solid_fractions(rod).derivative);
  return {kRadius,
          [](Mechanism& c, double p) { part(c).outline.features[1].values[3] = p; },
          {"radius", {SolidDerivative{1, VectorXd(by_shape.col(radius - names.begin()))}}}};
}

template <class G>
std::vector<Quantity> quantities_of(const Mechanism& m) {
  auto all = scales_of_the_part(m);
  if (G::space_dim == 2) all.push_back(radius_of_the_hole(m));
  return all;
}

template <class G>
class ReducedPart : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ReducedPart, Groups);

TYPED_TEST(ReducedPart, DirectEqualsAdjoint) {
  using G = TypeParam;
  const Mechanism m = machine<G>();
  for (const int steps : {10, 100, 1000})
    expect_direct_equals_adjoint<G>(steps, m, quantities_of<G>(m), 2e-4, kMid);
}

TYPED_TEST(ReducedPart, EqualsDifferencesOfSimulations) {
  using G = TypeParam;
  const Mechanism m = machine<G>();
  expect_differences<G>(m, quantities_of<G>(m),
                        {.node = kMid, .largest = G::space_dim == 2 ? kMost : kMostInSpace});
}

}  // namespace
}  // namespace liesl::test::reduced_part_test
