/// @file
/// Sensitivities of motions in which all nodes of a meshed part move, by what is beside it, by its
/// material, thickness, lengths and outline: direct against adjoint, against differences, and
/// against those of beams.

#include <map>

#include "mbs/sections/shape_dimensions.hpp"
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

/// With a slower crank, 1000 steps of which need no shorter ones.
void expect_both_forms_by_the_outline(Tie tie, const std::vector<int>& of_steps, int nz = 0) {
  Mechanism m = machine_with_hole(SolidLaw::StVenantKirchhoff, nz);
  if (tie == Tie::Averaged) part(m).model = with_ties(*part(m).model, tie);
  m.drives = {{0, 0, TimeFunction::rate(50, 0.04)}};
  for (const int steps : of_steps)
    nz == 0 ? expect_direct_equals_adjoint<SE2>(steps, m, of_the_hole(m), 4e-4)
            : expect_direct_equals_adjoint<SE3>(steps, m, of_the_hole(m), 4e-4);
}

TEST(ContinuumSensitivity, ByAnOutlineDirectEqualsAdjoint) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    const Mechanism m = machine_with_hole(law);
    expect_direct_equals_adjoint<SE2>(20, m, of_the_hole(m));
  }
  const Mechanism m = machine_with_hole(SolidLaw::StVenantKirchhoff);
  expect_direct_equals_adjoint<SE2>(100, m, of_the_hole(m));
  expect_both_forms_by_the_outline(Tie::Rigid, {10, 100, 1000});
}

TEST(ContinuumSensitivity, ByAnOutlineInSpaceDirectEqualsAdjoint) {
  expect_both_forms_by_the_outline(Tie::Rigid, {10, 100}, 1);
}

TEST(ContinuumSensitivitySlow, ByAnOutlineDirectEqualsAdjoint) {
  expect_both_forms_by_the_outline(Tie::Averaged, {10, 100, 1000});
  expect_both_forms_by_the_outline(Tie::Rigid, {1000}, 1);
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

/// The pendulum as a mesh of n x 2 quadrilaterals, or of n hexahedra as thick as high.
template <class G>
void mesh_pendulum(Mechanism& m, int n, double length, double side) {
  const Material soft{"soft", 5e8, 0.3, 7800};
  m.bodies[0].kind = G::space_dim == 2 ? continuum_block({length, side, kSide}, n, 2, 0, soft)
                                       : continuum_block({length, side, side}, n, 1, 1, soft);
}

/// In space on a spherical joint, pushed out of its plane at its end. @param slender so many times
/// as thin, as stiff for its weight
template <class G>
Mechanism swinging(int n, Formalism formalism, bool meshed, double slender) {
  Mechanism m = pendulum(n);
  auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
  for (Section& s : beam.sections) {
    s.shape = Rectangle{kSide / slender, kSide / slender};
    s.torsion_constant /= std::pow(slender, 4);
  }
  beam.material.E *= slender * slender;
  m.formalism = formalism;
  m.gravity_scale = TimeFunction::expression("t < 0.2 ? sin(2.5*pi*t)^2 : 1");
  if (meshed) mesh_pendulum<G>(m, n, 1, kSide);
  if (G::space_dim == 2) return m;
  m.joints[0].type = JointType::Spherical;
  LoadSpec push;
  push.name = "push";
  push.port = {0, meshed ? 1 : n};
  push.force = {0, 0, 0.5 / (slender * slender)};
  push.scale = TimeFunction::expression("sin(5*pi*t)^2");
  m.loads = {push};
  return m;
}

/// E, rho, the side of the section (in the plane its height), the length.
template <class G>
std::vector<Quantity> of_the_pendulum(const Mechanism& m, int n, bool meshed) {
  const auto nothing = [](Mechanism&, double) {};
  if (!meshed) {
    BeamDerivative side = by_dimension(m, 0, {}, "width");
    if (G::space_dim == 3) side += by_dimension(m, 0, {}, "height");
    const auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
    return {{beam.material.E, nothing, {"E", {by_youngs_modulus(m, 0)}}},
            {beam.material.rho, nothing, {"rho", {by_density(m, 0)}}},
            {dimension(beam.sections[0].shape, "width"), nothing, {"side", {side}}},
            by_nearby("length", m, 1, [n](Mechanism& c, double p) {
              std::get<BeamSpec>(c.bodies[0].kind).nodes = straight({0, 0, 0}, {p, 0, 0}, n);
            })};
  }
  return {
      {5e8, nothing, {"E", {SolidScale{0, 1 / 5e8, 0}}}},
      {7800, nothing, {"rho", {SolidScale{0, 0, 1 / 7800.}}}},
      by_nearby("side", m, kSide, [n](Mechanism& c, double p) { mesh_pendulum<G>(c, n, 1, p); }),
      by_nearby("length", m, 1, [n](Mechanism& c, double p) { mesh_pendulum<G>(c, n, p, kSide); })};
}

/// p dy/dp of the tip at the end, a column each of `of_the_pendulum`.
template <class G>
MatrixXd of_the_tip(int n, Formalism formalism, bool meshed = false, double slender = 1) {
  const Taped<G> run(swinging<G>(n, formalism, meshed, slender), tight(0.3, 2e-3));
  const auto all = of_the_pendulum<G>(run.mechanism, n, meshed);
  const auto tip = std::size_t(meshed ? 1 : n);
  const auto parameters = run.parameters(all);
  MatrixXd out;
  const auto end = direct_sensitivity<G>(
      run.model, run.tape, parameters, [&](long, const State<G>& s, const auto& ds) {
        out = s.H[tip].R * ds.eta.middleRows(G::dim * Eigen::Index(tip), G::space_dim);
      });
  EXPECT_TRUE(end.complete()) << end.reason;
  for (std::size_t p = 0; p < all.size(); ++p) out.col(Eigen::Index(p)) *= all[p].nominal;
  return out;
}

/// How far p dy/dp of chains and continua is from that of the beam on the group, 16 and 32 elements
/// extrapolated; recorded.
template <class G>
class FromTheBeam {
 public:
  FromTheBeam()
      : limit_((4 * of_the_tip<G>(32, Formalism::SE3) - of_the_tip<G>(16, Formalism::SE3)) / 3) {
    record("limit", limit_);
  }
  double chain(int n) const {
    return off("segments_" + std::to_string(n), of_the_tip<G>(n, Formalism::Segments));
  }
  double continuum(int n) const {
    return off("continuum_" + std::to_string(n), of_the_tip<G>(n, Formalism::SE3, true));
  }

 private:
  static void record(const std::string& name, const MatrixXd& by) {
    for (int p = 0; p < by.cols(); ++p) {
      std::string components;
      for (int i = 0; i < by.rows(); ++i) components += std::to_string(by(i, p)) + " ";
      ::testing::Test::RecordProperty(name + "_" + std::to_string(p), components);
    }
  }
  /// Of the parameter by which it is farthest off, of its norm.
  double off(const std::string& name, const MatrixXd& found) const {
    const Eigen::RowVectorXd share =
        (found - limit_).colwise().norm().cwiseQuotient(limit_.colwise().norm());
    record(name, found);
    for (int p = 0; p < found.cols(); ++p)
      ::testing::Test::RecordProperty("off_" + name + "_" + std::to_string(p),
                                      std::to_string(1e6 * share[p]));
    return share.maxCoeff();
  }
  MatrixXd limit_;
};

/// Tables of docs/sensitivities.md: segments, the beam on the group and the continuum come to one
/// value, with the square of the length of their elements.
TEST(ContinuumSensitivities, ComeToThoseOfBeams) {
  const FromTheBeam<SE2> off;
  off.chain(16);
  EXPECT_LT(off.chain(32), 1e-3);
  off.continuum(20);
  const double coarse = off.continuum(40), fine = off.continuum(80);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.4);
  EXPECT_LT(fine, 5e-4);
}

/// What a chain has not, shear and rotary inertia, goes with (radius/length)^2.
TEST(ContinuumSensitivities, InSpaceChainsDifferBySlendernessSquared) {
  const auto off = [](double slender) {
    const auto limit = [slender](Formalism formalism) -> MatrixXd {
      return (4 * of_the_tip<SE3>(64, formalism, false, slender) -
              of_the_tip<SE3>(32, formalism, false, slender)) /
             3;
    };
    const MatrixXd beam = limit(Formalism::SE3);
    return VectorXd((limit(Formalism::Segments) - beam)
                        .colwise()
                        .norm()
                        .cwiseQuotient(beam.colwise().norm())
                        .transpose());
  };
  const VectorXd thick = off(1), thin = off(2);
  for (int p = 0; p < 3; ++p) {  // by the length it is little
    RecordProperty("slender_" + std::to_string(p), std::to_string(1e6 * thin[p]));
    EXPECT_NEAR(std::log2(thick[p] / thin[p]), 2, 0.5) << p;
  }
}

/// One hexahedron thick, it has further to come.
TEST(ContinuumSensitivities, InSpaceComeToThoseOfBeams) {
  const FromTheBeam<SE3> off;
  const double chain = off.chain(16), longer = off.chain(32);
  EXPECT_LT(longer, chain);
  EXPECT_LT(longer, 1.5e-3);
  off.continuum(20);
  const double coarse = off.continuum(40), fine = off.continuum(80);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.4);
  EXPECT_LT(fine, 1.5e-3);
}

}  // namespace
}  // namespace liesl::test::continuum_sensitivity_test
