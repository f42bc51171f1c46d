/// @file
/// Sensitivities of motions in which all nodes of a meshed part move, by what is beside it, by its
/// material, thickness, lengths and outline: direct against adjoint, against differences, and
/// against those of beams.

#include <map>

#include "mbs/sensitivity/forms.hpp"
#include "mbs/sensitivity/meshed_quantities.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"
#include "reference/continuum.hpp"
#include "reference/meshed_rod.hpp"
#include "reference/ties.hpp"

namespace liesl::test::continuum_sensitivity_test {
namespace {

const Material kPlastic = {"plastic", 1e9, 0.3, 1200};

/// The rod with cells as many as `nz` > 0 says in space.
SolidSpec rod_of(SolidLaw law, int nz, double length, double thickness, const Material& material,
                 double height = kRodHeight) {
  SolidSpec rod = continuum_block({length, height, thickness}, nz > 0 ? 4 : 8, nz > 0 ? 1 : 2, nz,
                                  material, law);
  rod.frame.x = {0.15, 0, 0};
  rod.damping = 1e-5;
  return rod;
}

/// A slider-crank with a meshed rod.
Mechanism machine_with_continuum(SolidLaw law, int nz = 0) {
  Mechanism m = slider_crank_with(rod_of(law, nz, kRodLength, kRodThickness, kPlastic), 1);
  m.gravity = {0, -9.81, 0};
  return m;
}

constexpr double kStoutHeight = 0.04;
const Material kSoftRod = {"soft", 1e8, 0.3, 1200};

/// Bends as the rod above does, with a tenth of its E: differences have less round-off.
Mechanism machine_with_stout_rod(SolidLaw law) {
  Mechanism m =
      slider_crank_with(rod_of(law, 0, kRodLength, kRodThickness, kSoftRod, kStoutHeight), 1);
  m.gravity = {0, -9.81, 0};
  return m;
}

/// Its length, which all nodes of the mesh follow, and its height.
std::vector<Quantity> lengths(const Mechanism& m, double height = kRodHeight) {
  return {by_nearby("length of the rod", m, kRodLength,
                    [](Mechanism& c, double p) {
                      stretch_rod(c, 0, p / kRodLength);
                      std::get<RigidSpec>(c.bodies[2].kind).frame.x = {0.15 + p, 0, 0};
                    }),
          by_nearby("height of the rod", m, height,
                    [height](Mechanism& c, double p) { stretch_rod(c, 1, p / height); })};
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

TEST(ContinuumSensitivity, ByItsOwnParametersDirectEqualsAdjoint) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean})
    expect_direct_equals_adjoint<SE2>(20, machine_with_continuum(law),
                                      scales_of_the_part(machine_with_continuum(law)));
  const Mechanism in_space = machine_with_continuum(SolidLaw::StVenantKirchhoff, 1);
  expect_direct_equals_adjoint<SE3>(5, in_space, scales_of_the_part(in_space));
}

TEST(ContinuumSensitivity, ByItsOwnParametersAreThoseOfDifferences) {
  DifferenceOptions options;
  options.of_kind = true;
  options.largest = 0.3;
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean})
    expect_differences<SE2>(machine_with_continuum(law),
                            scales_of_the_part(machine_with_continuum(law)), options);
}

/// States go with the mesh, as of beams on the group. 100 steps of 0.4 ms: with 0.2 ms round-off of
/// the accelerations, which goes as 1/(beta h^2), is 0.9e-10 to 1.2e-10 by itself, by the factors
/// of the motion (LU or Cholesky) and the kernel of OpenBLAS.
TEST(ContinuumSensitivity, ByLengthsBothFormsAgree) {
  const Mechanism m = machine_with_continuum(SolidLaw::NeoHookean);
  expect_direct_equals_adjoint<SE2>(20, m, lengths(m), 2e-4, 1, 1);
  expect_direct_equals_adjoint<SE2>(100, m, lengths(m), 4e-4);
  const Mechanism in_space = machine_with_continuum(SolidLaw::StVenantKirchhoff, 1);
  expect_direct_equals_adjoint<SE3>(50, in_space, lengths(in_space), 2e-4, 1, 1);
}

/// Of the rod with ten times its E round-off leaves 3e-7 of the differences.
TEST(ContinuumSensitivity, ByLengthsAreThoseOfDifferences) {
  DifferenceOptions options;
  options.of_kind = true;
  options.largest = 0.1;
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    const Mechanism m = machine_with_stout_rod(law);
    expect_differences<SE2>(m, lengths(m, kStoutHeight), options);
  }
}

/// A rod whose ends move with the average of their nodes. By its height round-off of the stiffness
/// that ties them leaves 1.7e-7 of the differences and 5e-10 between both forms.
TEST(ContinuumSensitivity, OfAveragedInterfacesAreThoseOfDifferences) {
  const auto law = SolidLaw::NeoHookean;
  Mechanism m = machine_with_stout_rod(law);
  part(m).model = with_ties(*part(m).model, Tie::Averaged);
  auto all = scales_of_the_part(m);
  all.pop_back();  // the thickness
  all.push_back(lengths(m, kStoutHeight)[0]);
  expect_direct_equals_adjoint<SE2>(20, m, all, 2e-4, 1, 1);
  DifferenceOptions options;
  options.of_kind = true;
  options.largest = 0.1;
  expect_differences<SE2>(m, all, options);
}

/// Energy depends on the law itself; central differences of one more step of Richardson.
TEST(ContinuumSensitivity, OfTheEnergyIsThatOfDifferences) {
  const auto law = SolidLaw::NeoHookean;
  const Mechanism m = machine_with_continuum(law);
  const auto o = tight(0.02, 4e-4);
  ResponseSpec energy;
  energy.kind = ResponseKind::Energy;
  const auto all = scales_of_the_part(m);
  const Taped<SE2> run(m, o);
  const auto parameters = run.parameters(all);
  const ResponseValues<SE2> values(run.mechanism, run.model);
  const ResponseSensitivity<SE2> of(run.model, values, energy, parameters);
  MatrixXd exact;
  const auto end = direct_sensitivity<SE2>(
      run.model, run.tape, parameters,
      [&](long, const State<SE2>& s, const auto& ds) { exact = of(s, ds); });
  ASSERT_TRUE(end.complete()) << end.reason;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const auto at = [&](double change) -> MatrixXd {
      Mechanism changed = m;
      all[p].set(changed, all[p].nominal * (1 + change));
      const Taped<SE2> near(changed, o);
      State<SE2> s = near.model.initial_state();
      near.run.trajectory.read(near.run.trajectory.size() - 1, s);
      return ResponseValues<SE2>(near.mechanism, near.model)(energy, s);
    };
    const double slope = all[p].nominal * exact(0, Eigen::Index(p));
    const double size = std::max(std::abs(slope), 1e-2 * std::abs(at(0)(0, 0)));
    const double best = Differences(at, 0.16, 4).least([&](const MatrixXd& y) {
      return std::abs(y(0, 0) - slope) / size;
    });
    EXPECT_LT(best, 1e-7) << all[p].parameter.name;
  }
}

const Material kHoledRod = {"softer", 4e7, 0.3, 1200};  // a change of 1 mm is above round-off

/// A rod of cells of 20 mm with a hole off its middle that leaves a cell void: until the radius or
/// the place of the hole has changed by 1 mm, its edge passes no place at which cells are sampled.
Mechanism machine_with_hole(SolidLaw law, int nz = 0) {
  SolidSpec rod = continuum_block({kRodLength, 0.06, kRodThickness}, 15, 3, nz, kHoledRod, law);
  rod.frame.x = {0.15, 0, 0};
  rod.damping = 1e-5;
  cut_hole(rod, 0.075, 0.005, 0.019);
  Mechanism m = slider_crank_with(rod, 1);
  m.gravity = {0, -9.81, 0};
  return m;
}

/// A number of the outline of the rod.
Quantity of_the_hole(const Mechanism& m, const std::string& name) {
  const auto& rod = std::get<SolidSpec>(m.bodies[1].kind);
  return {outline_values(rod)[outline_number(rod, name)],
          [name](Mechanism& c, double p) { set_outline(part(c), name, p); },
          {name, {SolidDerivative{1, fractions_by(rod, name)}}}};
}

std::vector<Quantity> of_the_hole(const Mechanism& m) {
  return {of_the_hole(m, "hole.radius"), of_the_hole(m, "hole.x"), of_the_hole(m, "hole.y")};
}

TEST(ContinuumSensitivity, ByAnOutlineDirectEqualsAdjoint) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    const Mechanism m = machine_with_hole(law);
    expect_direct_equals_adjoint<SE2>(20, m, of_the_hole(m));
  }
  const Mechanism m = machine_with_hole(SolidLaw::StVenantKirchhoff);
  expect_direct_equals_adjoint<SE2>(100, m, of_the_hole(m));
  const Mechanism in_space = machine_with_hole(SolidLaw::StVenantKirchhoff, 1);
  expect_direct_equals_adjoint<SE3>(5, in_space, of_the_hole(in_space));
}

TEST(ContinuumSensitivity, ByAnOutlineAreThoseOfDifferences) {
  DifferenceOptions options;
  options.of_kind = true;
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    const Mechanism m = machine_with_hole(law);
    for (const auto& [name, largest] : std::map<std::string, double>{
             {"hole.radius", 0.045}, {"hole.x", 0.012}, {"hole.y", 0.18}}) {
      options.largest = largest;
      options.samples = name == "hole.x" ? 24 : 0;  // 1 mm is little of its place: round-off
      expect_differences<SE2>(m, {of_the_hole(m, name)}, options);
    }
  }
}

/// Its ends averaged: a share of the mass of the part is that of its ports.
TEST(ContinuumSensitivity, ByAnOutlineWithAveragedInterfaces) {
  Mechanism m = machine_with_hole(SolidLaw::StVenantKirchhoff);
  part(m).model = with_ties(*part(m).model, Tie::Averaged);
  const std::vector<Quantity> radius = {of_the_hole(m, "hole.radius")};
  expect_direct_equals_adjoint<SE2>(20, m, radius);
  DifferenceOptions options;
  options.of_kind = true;
  options.largest = 0.045;
  expect_differences<SE2>(m, radius, options);
}

constexpr double kSide = 0.01;

/// The pendulum as a mesh of n x 2 quadrilaterals.
void mesh_pendulum(Mechanism& m, int n, double length, double height) {
  SolidSpec s = continuum_block({length, height, kSide}, n, 2, 0, {"soft", 5e8, 0.3, 7800});
  m.bodies[0].kind = s;
}

Mechanism swinging(int n, Formalism formalism, bool meshed) {
  Mechanism m = pendulum(n);
  m.formalism = formalism;
  m.gravity_scale = TimeFunction::expression("t < 0.2 ? sin(2.5*pi*t)^2 : 1");
  if (meshed) mesh_pendulum(m, n, 1, kSide);
  return m;
}

/// E, rho, the side of the section in the plane, the length.
std::vector<Quantity> of_the_pendulum(const Mechanism& m, int n, bool meshed) {
  const auto nothing = [](Mechanism&, double) {};
  if (!meshed)
    return {{5e8, nothing, {"E", {by_youngs_modulus(m, 0)}}},
            {7800, nothing, {"rho", {by_density(m, 0)}}},
            {kSide, nothing, {"side", {by_dimension(m, 0, {}, "width")}}},
            by_nearby("length", m, 1, [n](Mechanism& c, double p) {
              std::get<BeamSpec>(c.bodies[0].kind).nodes = straight({0, 0, 0}, {p, 0, 0}, n);
            })};
  return {
      {5e8, nothing, {"E", {SolidScale{0, 1 / 5e8, 0}}}},
      {7800, nothing, {"rho", {SolidScale{0, 0, 1 / 7800.}}}},
      by_nearby("side", m, kSide, [n](Mechanism& c, double p) { mesh_pendulum(c, n, 1, p); }),
      by_nearby("length", m, 1, [n](Mechanism& c, double p) { mesh_pendulum(c, n, p, kSide); })};
}

/// p dy/dp of the tip at the end, a column each of `of_the_pendulum`.
MatrixXd of_the_tip(int n, Formalism formalism, bool meshed = false) {
  const Taped<SE2> run(swinging(n, formalism, meshed), tight(0.3, 2e-3));
  const auto all = of_the_pendulum(run.mechanism, n, meshed);
  const auto tip = std::size_t(meshed ? 1 : n);
  const auto parameters = run.parameters(all);
  MatrixXd out;
  const auto end = direct_sensitivity<SE2>(
      run.model, run.tape, parameters, [&](long, const State<SE2>& s, const auto& ds) {
        out = s.H[tip].R * ds.eta.middleRows(3 * Eigen::Index(tip), 2);
      });
  EXPECT_TRUE(end.complete()) << end.reason;
  for (std::size_t p = 0; p < all.size(); ++p) out.col(Eigen::Index(p)) *= all[p].nominal;
  return out;
}

/// A table of docs/sensitivities.md: segments, the beam on the group and the continuum come to one
/// value, with the square of the length of their elements.
TEST(ContinuumSensitivities, ComeToThoseOfBeams) {
  const auto record = [](const std::string& name, const MatrixXd& by) {
    for (int p = 0; p < by.cols(); ++p)
      RecordProperty(name + "_" + std::to_string(p),
                     std::to_string(by(0, p)) + " " + std::to_string(by(1, p)));
  };
  const MatrixXd limit = (4 * of_the_tip(32, Formalism::SE3) - of_the_tip(16, Formalism::SE3)) / 3;
  record("limit", limit);
  const auto off = [&](const std::string& name, const MatrixXd& found) {
    const Eigen::RowVectorXd share =
        (found - limit).colwise().norm().cwiseQuotient(limit.colwise().norm());
    record(name, found);
    for (int p = 0; p < found.cols(); ++p)
      RecordProperty("off_" + name + "_" + std::to_string(p), std::to_string(1e6 * share[p]));
    return share.maxCoeff();
  };
  off("segments_16", of_the_tip(16, Formalism::Segments));
  EXPECT_LT(off("segments_32", of_the_tip(32, Formalism::Segments)), 1e-3);
  off("continuum_20", of_the_tip(20, Formalism::SE3, true));
  const double coarse = off("continuum_40", of_the_tip(40, Formalism::SE3, true)),
               fine = off("continuum_80", of_the_tip(80, Formalism::SE3, true));
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.4);
  EXPECT_LT(fine, 5e-4);
}

}  // namespace
}  // namespace liesl::test::continuum_sensitivity_test
