/// @file
/// Sensitivities of motions in which all nodes of a meshed part move, by what is beside it: direct
/// against adjoint, and against differences. Its own parameters have none yet.

#include "mbs/sensitivity/forms.hpp"
#include "reference/continuum.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test {
namespace {

/// A slider-crank with a meshed rod.
Mechanism machine_with_continuum(SolidLaw law, int nz = 0) {
  SolidSpec rod = continuum_block({kRodLength, kRodHeight, kRodThickness}, nz > 0 ? 4 : 8,
                                  nz > 0 ? 1 : 2, nz, {"plastic", 1e9, 0.3, 1200}, law);
  rod.frame.x = {0.15, 0, 0};
  rod.damping = 1e-5;
  Mechanism m = slider_crank_with(rod, 1);
  m.gravity = {0, -9.81, 0};
  return m;
}

std::vector<Quantity> mass_of_the_slider() {
  return {{0.2,
           [](Mechanism& m, double p) { std::get<RigidSpec>(m.bodies[2].kind).mass = p; },
           {"mass of the slider", {RigidDerivative{2, 1}}}}};
}

TEST(ContinuumSensitivity, DirectEqualsAdjoint) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean})
    expect_direct_equals_adjoint<SE2>(20, machine_with_continuum(law), mass_of_the_slider());
  expect_direct_equals_adjoint<SE3>(5, machine_with_continuum(SolidLaw::StVenantKirchhoff, 1),
                                    mass_of_the_slider());
}

TEST(ContinuumSensitivity, AreThoseOfDifferences) {
  DifferenceOptions options;
  options.of_kind = true;
  options.largest = 0.6;  // rounding of a stiff mesh asks for large steps
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean})
    expect_differences<SE2>(machine_with_continuum(law), mass_of_the_slider(), options);
}

TEST(ContinuumSensitivity, ItsOwnParametersAreRefused) {
  const Mechanism m = machine_with_continuum(SolidLaw::StVenantKirchhoff);
  const auto model = Model<SE2>::build(m, space_of<SE2>(m));
  const Parameter by = {"fractions", {SolidDerivative{1, Eigen::VectorXd::Ones(16)}}};
  EXPECT_THROW(ParameterResidual<SE2>(m, model, by), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test
