/// @file
/// Meshed parts in motion: energy, against beams, in every formalism.

#include <algorithm>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/run.hpp"
#include "mbs/system/response_value.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::solid_motion_test {
namespace {

using test::options;

/// Largest change of the energy over its first value, of a part that moves freely.
template <class G>
double energy_drift(const Mechanism& m, const Space<G>& space, double h) {
  auto r = test::run<G>(m, space, options(0.02, h, 1.0, 1e-9));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  double drift = 0;
  const double before = test::total_energy(r, 0);
  for (int n = 0; n <= r.last(); ++n)
    drift = std::max(drift, std::abs(test::total_energy(r, n) - before));
  return drift / before;
}

SolidSpec block_of_hexahedra() {
  SolidSpec s;
  s.model = test::mesh_with_ends(hex_grid({0, -0.02, -0.01}, {0.4, 0.02, 0.01}, 16, 2, 2),
                                 {"soft", 2e8, 0.3, 2000}, Vec3::Zero(), {0.4, 0, 0});
  s.modes = 4;
  return s;
}

/// A bar that spins and vibrates: it has the shape at rest when centrifugal force is switched on.
Mechanism free_spin(const SolidSpec& bar, const Vec3& omega) {
  Mechanism m;
  m.bodies = {{"bar", bar, Vec3(1, 2, 0), omega}};
  return m;
}

/// With rho_inf = 1 nothing is dissipated: the energy of a free body that spins and vibrates is
/// kept to the second order of the step.
TEST(SolidMotion, AFreeBodyKeepsItsEnergy) {
  SolidSpec flat = test::meshed_rod({0, 0, 0}, 30, 2, 3);
  flat.model = test::of_material(*flat.model, {"soft", 2e8, 0.3, 2000});
  const Mechanism plane = free_spin(flat, {0, 0, 100});
  const auto found = find_plane(plane);
  ASSERT_TRUE(found.plane);
  const double coarse = energy_drift<SE2>(plane, *found.plane, 5e-5),
               fine = energy_drift<SE2>(plane, *found.plane, 2.5e-5);
  EXPECT_LT(fine, 1e-5);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
  const Mechanism space = free_spin(block_of_hexahedra(), {20, 40, 60});
  const double coarse3 = energy_drift<SE3>(space, {}, 5e-5),
               fine3 = energy_drift<SE3>(space, {}, 2.5e-5);
  EXPECT_LT(fine3, 1e-5);
  EXPECT_GT(std::log2(coarse3 / fine3), 1.7);
}

/// Largest value of a response over a run.
template <class G = SE2>
double largest(const Mechanism& m, const ResponseSpec& r, const SimulationOptions& o,
               const Space<G>& space) {
  auto run = test::run<G>(m, space, o);
  EXPECT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  const ResponseValues<G> values(m, *run.model);
  State<G> s = run.model->initial_state();
  double found = 0;
  for (int n = 0; n <= run.last(); ++n) {
    run.trajectory().read(n, s);
    found = std::max(found, values(r, s).cwiseAbs().maxCoeff());
  }
  return found;
}

double largest(const Mechanism& m, const ResponseSpec& r, const SimulationOptions& o) {
  return largest<SE2>(m, r, o, find_plane(m).plane.value());
}

ResponseSpec bend(const Mechanism& m, const char* mid) {
  ResponseSpec r;
  r.kind = ResponseKind::Displacement;
  r.at = *m.port(mid);
  r.axis = Vec3::UnitY();
  return r;
}

/// Against the geometrically exact beam: within 2 %, what a linear part in a floating frame and
/// plane stress against Timoshenko are apart.
TEST(SolidMotion, AMeshedRodBendsAsTheBeam) {
  const Mechanism mesh = test::slider_crank_with_mesh(), beam = test::slider_crank_with_beam();
  const auto o = options(0.12, 1e-4);
  const double by_mesh = largest(mesh, bend(mesh, "rod.mid"), o),
               by_beam = largest(beam, bend(beam, "rod.mid"), o);
  EXPECT_GT(by_beam, 1e-4);
  EXPECT_NEAR(by_mesh / by_beam, 1, 0.02);
}

/// Hexahedra on SE(3) against quadrilaterals in plane stress on SE(2): another element, another
/// group, the same rod.
TEST(SolidMotion, InSpaceItBendsAsInThePlane) {
  const Mechanism plane = test::slider_crank_with_mesh(30, 2, 4),
                  space = test::slider_crank_with_mesh(30, 2, 4, 1);
  const auto o = options(0.05, 1e-4);
  const double in_plane = largest(plane, bend(plane, "rod.mid"), o),
               in_space = largest<SE3>(space, bend(space, "rod.mid"), o, {});
  EXPECT_NEAR(in_space / in_plane, 1, 0.02);
}

TEST(SolidMotion, ElongationIsOfTwoPorts) {
  const Mechanism mesh = test::slider_crank_with_mesh(), beam = test::slider_crank_with_beam();
  ResponseSpec stretch;
  stretch.kind = ResponseKind::Elongation;
  stretch.at = *mesh.port("rod.start");
  stretch.to = *mesh.port("rod.end");
  ResponseSpec of_beam = stretch;
  of_beam.at = *beam.port("rod.start");
  of_beam.to = *beam.port("rod.end");
  const auto o = options(0.12, 1e-4);
  const double by_mesh = largest(mesh, stretch, o), by_beam = largest(beam, of_beam, o);
  EXPECT_GT(by_beam, 1e-6);
  EXPECT_NEAR(by_mesh / by_beam, 1, 0.1);  // bending shortens the beam, not the linear part
}

TEST(SolidMotion, EveryFormalismTakesIt) {
  Mechanism m = test::slider_crank_with_mesh(30, 2, 3);
  const auto r = bend(m, "rod.mid");
  const auto o = options(0.06, 1e-4);
  const double lie = largest(m, r, o);
  for (const auto f : {Formalism::R3SO3, Formalism::Classical, Formalism::Floating}) {
    m.formalism = f;
    EXPECT_NEAR(largest(m, r, o) / lie, 1, 1e-3) << to_string(f);
  }
  m.formalism = Formalism::Rigid;
  EXPECT_LT(largest(m, r, o), 1e-12);
}

/// The plane turned in space: the same motion.
TEST(SolidMotion, AnyPlaneWillDo) {
  Mechanism m = test::slider_crank_with_mesh(30, 2, 3);
  const auto r = bend(m, "rod.mid");
  const auto o = options(0.03, 1e-4);
  const double flat = largest(m, r, o);
  for (const SE3& turn : {SE3(SO3::exp({std::numbers::pi / 2, 0, 0}).R, {0, 0.3, 0}),
                          SE3(SO3::exp({std::numbers::pi, 0, 0}).R, {0, 0, 0})}) {
    Mechanism turned = m;
    for (auto& body : turned.bodies)
      if (auto* solid = std::get_if<SolidSpec>(&body.kind))
        solid->frame = turn * solid->frame;
      else
        std::get<RigidSpec>(body.kind).frame = turn * std::get<RigidSpec>(body.kind).frame;
    for (auto& j : turned.joints) j.axis = turn.R * j.axis;
    EXPECT_NEAR(largest(turned, r, o) / flat, 1, 1e-6);
  }
  // Only the mesh turned: its axes are mirrored against those of the plane.
  Mechanism mirrored = m;
  auto& rod = std::get<SolidSpec>(mirrored.bodies[1].kind);
  rod.frame.R = SO3::exp({std::numbers::pi, 0, 0}).R;
  EXPECT_NEAR(largest(mirrored, r, o) / flat, 1, 1e-6);
}

TEST(SolidMotion, PlanarMeshesAreNotForSpace) {
  const Mechanism m = test::slider_crank_with_mesh(10, 2, 1);
  EXPECT_THROW(Model<SE3>::build(m, {}), std::invalid_argument);
  Mechanism thick = free_spin(block_of_hexahedra(), {0, 0, 1});
  EXPECT_NE(find_plane(thick).reason.find("meshed in space"), std::string::npos);
}

}  // namespace
}  // namespace liesl::test::solid_motion_test
