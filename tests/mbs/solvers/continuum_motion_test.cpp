/// @file
/// Meshed parts whose nodes all move, in statics, modes and motion: against closed forms, published
/// values and the mesh as a linear structure.

#include "mbs/bodies/nodal_statics.hpp"
#include "mbs/run.hpp"
#include "mbs/solids/meshes.hpp"
#include "mbs/solids/reduction.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/solid_statics.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/solvers/simulation.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/system/response_value.hpp"
#include "reference/continuum.hpp"
#include "reference/meshed_rod.hpp"
#include "reference/spinning_bar.hpp"
#include "reference/ties.hpp"

namespace liesl::test::continuum_motion_test {
namespace {

using Eigen::VectorXd;

const Material kSoft = {"soft", 2e8, 0.3, 2000};

LoadSpec end_load(const Vec3& force) {
  LoadSpec load;
  load.name = "end";
  load.port = {0, 1};
  load.force = force;
  return load;
}

/// Frame of the free end of a clamped block in equilibrium.
SE3 end_in_equilibrium(const SolidSpec& part, const Vec3& force, int load_steps = 4) {
  Mechanism m = clamped(part);
  m.loads = {end_load(force)};
  SimulationOptions o = tight();
  o.max_iterations = 40;
  o.load_steps = load_steps;
  const auto found = solve<SE2>(m, o, *find_plane(m).plane);
  EXPECT_EQ(found.result.report.status, SolveStatus::Converged) << found.result.report.reason;
  return found.frame(1);
}

/// Elastica (Mattiasson 1981) at P L^2/EI = 2: [shortening, deflection, tip angle] to the second
/// order in the length of the cells, and in the limit of slender bars, over (h/L)^2.
TEST(Continuum, BendsAsTheElastica) {
  const Vec3 reference(0.1606417208, 0.4934574804, 0.7817498316);
  const auto tip = [](int n, double h) -> Vec3 {
    const double E = 1e6, EI = E * h * h * h / 12;
    const SE3 H =
        end_in_equilibrium(continuum_block({1, h, 1}, n, 1, 0, {"plate", E, 0, 1}), {0, 2 * EI, 0});
    return {1 - H.x.x(), H.x.y(), std::atan2(H.R(1, 0), H.R(0, 0))};
  };
  const Vec3 a = tip(32, 0.02), b = tip(64, 0.02), c = tip(128, 0.02);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::log2((a[i] - b[i]) / (b[i] - c[i])), 2, 0.12) << i;
  const Vec3 thin = richardson(b, c), thick = richardson(tip(64, 0.05), tip(128, 0.05));
  const Vec3 limit = (6.25 * thin - thick) / 5.25;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(limit[i], reference[i], 1e-6) << i;
}

/// Beyond the largest force of the linear law, E A sqrt(1/27) at l^2 = 1/3, there is equilibrium
/// only of a block pushed through itself, which is none.
TEST(Continuum, StaticsTakeNoInvertedCell) {
  const auto status = [](double share) {
    Mechanism m = clamped(continuum_block({1, 1, 1}, 2, 2, 0, {"foam", 1e3, 0, 100}));
    m.loads = {end_load({-share * 1e3 / std::sqrt(27.0), 0, 0})};
    m.joints.push_back({"guide", JointType::Prismatic, {}, {0, 1}, Vec3::UnitX()});
    return solve<SE2>(m, tight(), *find_plane(m).plane).result.report.status;
  };
  EXPECT_EQ(status(0.9), SolveStatus::Converged);
  EXPECT_EQ(status(1.5), SolveStatus::NotConverged);
}

/// A strip with a clamped end under an axial load: pi^2 EI/(4 L^2), less shear and what it is
/// compressed by before, which are of order (h/L)^2; with the square of the length of cells.
TEST(Continuum, BucklesUnderEulersLoad) {
  constexpr double kHeight = 0.04, kWidth = 0.1, kE = 1e9, kLoad = 1.2;
  const double euler = M_PI * M_PI / 4 * kE * kWidth * std::pow(kHeight, 3) / 12;
  const auto critical = [&](int cells) {
    Mechanism m =
        clamped(continuum_block({1, kHeight, kWidth}, cells, 2, 0, {"strip", kE, 0, 1000}));
    m.loads = {end_load({-kLoad * euler, 0, 0})};
    auto o = tight();
    o.critical = true;
    o.load_steps = 4;
    const auto result = solve<SE2>(m, o, *find_plane(m).plane).result;
    EXPECT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
    return result.critical.size() == 1 ? kLoad * result.critical[0].load : 0;
  };
  const double coarse = critical(10), middle = critical(20), fine = critical(40);
  EXPECT_NEAR((coarse - middle) / (middle - fine), 4, 0.4);
  EXPECT_NEAR(fine + (fine - middle) / 3, 1, 1.5 * kHeight * kHeight);
}

const Material kPanel = {"panel", 1, 1. / 3, 1};

/// Deflection of the middle of the loaded side of Cook's membrane of a kind of cells, n x n
/// squares, under a share of its traction.
double cooks_deflection(int nodes, int n, SolidLaw law, double load) {
  const SolidMesh mesh = cooks_membrane(cell_kind(2, nodes), n);
  NodalStatics<SE2> membrane(mesh, kPanel, law, 1,
                             nodes_where(mesh, [](const Vec3& x) { return x[0] > 1e-9; }));
  const VectorXd f = traction_load(SolidModel(mesh, kPanel, {}, {1, {}}), mesh.sets.at("x_max"),
                                   {0, load / 16, 0});
  constexpr int kLoadSteps = 4;
  for (int k = 1; k <= kLoadSteps; ++k) {
    membrane.force = double(k) / kLoadSteps *
                     Eigen::Map<const NodalStatics<SE2>::Points>(f.data(), 2, f.size() / 2);
    membrane.solve(48);
  }
  const int middle = middle_of_its_side(mesh);
  return membrane.place(middle).y() - mesh.nodes(1, middle);
}

/// Under a small load 23.96 of fine meshes times that.
TEST(Continuum, IsCooksMembraneAtRest) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean})
    EXPECT_NEAR(cooks_deflection(4, 32, law, 1e-6), 23.96e-6, 1e-3 * 23.96e-6);
}

/// Loads that bend it by a fifth and a third of its width: all kinds of cells come to one limit, by
/// three meshes (Aitken), slowly for the corner at the wall, where stress is singular; triangles of
/// constant strain are far off and come from below. tests/calculix/large_test.py has such a
/// membrane in space.
TEST(Continuum, IsCooksMembraneInLargeDeformation) {
  for (const auto& [law, load] :
       {std::pair{SolidLaw::StVenantKirchhoff, 0.5}, {SolidLaw::NeoHookean, 1.0}}) {
    std::vector<double> limits;
    for (const int nodes : {4, 6, 8, 3}) {
      const double a = cooks_deflection(nodes, 4, law, load),
                   b = cooks_deflection(nodes, 8, law, load),
                   c = cooks_deflection(nodes, 16, law, load), first = b - a, second = c - b;
      EXPECT_GT(first, 0) << nodes;
      EXPECT_GT(second, 0) << nodes;
      if (nodes == 3) {
        EXPECT_LT(c, limits[0]);
        EXPECT_GT(c, 0.9 * limits[0]);
        continue;
      }
      EXPECT_GT(std::log2(first / second), 1) << nodes;
      limits.push_back(c + second * second / (first - second));
      RecordProperty("of_" + std::to_string(nodes) + "_" + std::string(to_string(law)),
                     std::to_string(limits.back()));
      EXPECT_NEAR(limits.back() / limits[0], 1, 1e-3) << nodes;
    }
    EXPECT_LT(limits[0], 0.8 * 23.96 * load);
  }
}

/// Tension of a neo-Hookean bar without lateral contraction of the linear law, nu = 0: S_yy = 0 at
/// C_yy = 1, and N = mu A (l - 1/l) with mu = E/2.
TEST(Continuum, StretchesByItsLaw) {
  const double E = 300, A = 0.02, N = 4;
  const SE3 H = end_in_equilibrium(
      continuum_block({1, 0.1, 0.2}, 3, 2, 0, {"rubber", E, 0, 1}, SolidLaw::NeoHookean),
      {N, 0, 0});
  const double l = H.x.x();
  EXPECT_NEAR(0.5 * E * A * (l - 1 / l), N, 1e-9);
  const SE3 linear =
      end_in_equilibrium(continuum_block({1, 0.1, 0.2}, 3, 2, 0, {"rubber", E, 0, 1}), {N, 0, 0});
  const double s = linear.x.x();
  EXPECT_NEAR(0.5 * E * A * s * (s * s - 1), N, 1e-9);
}

/// Free modes are those of the mesh with its interfaces and its outline, whatever frame it is in.
TEST(Continuum, VibratesAsItsMesh) {
  const auto compare = [](const Mechanism& m, const auto& model, double error) {
    SimulationOptions o = tight();
    o.type = SimulationType::Modes;
    constexpr int rigid = std::decay_t<decltype(model)>::Vector::RowsAtCompileTime == 2 ? 3 : 6;
    o.modes = rigid + 4;
    const auto found = solve_modes(model, o);
    ASSERT_EQ(found.report.status, SolveStatus::Converged) << found.report.reason;
    const auto& solid = std::get<SolidSpec>(m.bodies[0].kind);
    const VectorXd mesh = free_frequencies(*solid.model, solid_fractions(solid).value, 4);
    for (int i = 0; i < rigid; ++i) EXPECT_LT(found.frequency[i], 1e-3 * mesh[0]);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(found.frequency[rigid + i], mesh[i], error * mesh[i]) << i;
  };
  Mechanism flat, space;
  flat.bodies = {{"part", continuum_block({0.4, 0.05, 0.02}, 12, 2, 0, kSoft)}};
  space.bodies = {{"part", continuum_block({0.4, 0.05, 0.02}, 8, 2, 1, kSoft)}};
  compare(flat, Model<SE2>::build(flat, *find_plane(flat).plane), 1e-7);
  compare(space, Model<SE3>::build(space, {}), 1e-7);
  SolidSpec holed = continuum_block({0.4, 0.05, 0.02}, 32, 4, 0, kSoft);
  cut_hole(holed, 0.19, 0.003, 0.018);  // empty cells keep a millionth of their mass
  flat.bodies = {{"part", holed}};
  compare(flat, Model<SE2>::build(flat, *find_plane(flat).plane), 1e-6);
}

/// A bar with a hole that is hardly bent against its reduced part, of the same cells and fractions;
/// pulled, beside the hole it gets longer.
TEST(Continuum, WithAHoleIsItsReducedPartWhereItHardlyBends) {
  SolidSpec bar = continuum_block({0.4, 0.05, 0.02}, 32, 4, 0, kSoft);
  const Vec3 force(1e-3, 1e-4, 0);
  const Vec3 whole = end_in_equilibrium(bar, force).x;
  cut_hole(bar, 0.19, 0.003, 0.018);
  const Vec3 continuum = end_in_equilibrium(bar, force).x;
  bar.as = SolidMotion::Reduced;
  const Vec3 reduced = end_in_equilibrium(bar, force).x, rest(0.4, 0, 0);
  const Vec3 error = (continuum - reduced).cwiseAbs().cwiseQuotient((reduced - rest).cwiseAbs());
  EXPECT_LT(error.head<2>().maxCoeff(), 1e-5);
  RecordProperty("off_along", std::to_string(1e6 * error[0]));
  RecordProperty("off_across", std::to_string(1e6 * error[1]));
  EXPECT_GT(continuum.x() - 0.4, 1.1 * (whole.x() - 0.4));
}

/// A notch whose walls come together and pass through each other: its empty cells turn inside out,
/// which is no end of the run.
TEST(Continuum, ANotchMayClose) {
  constexpr double kWidth = 0.0125;
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    SolidSpec bar = continuum_block({0.2, 0.1, 0.05}, 16, 8, 0, kSoft, law);
    cut_hole(bar, 0, 0, 1);
    bar.outline.features[1] = {"hole",
                               levelset::FeatureKind::Rectangle,
                               {0.1 + kWidth / 2, 0.0375, 0, kWidth, 0.125, 0},
                               {}};
    /// How far apart they are at the upper side.
    const auto opening = [&](double moment) {
      Mechanism m = clamped(bar);
      m.loads = {end_load(Vec3::Zero())};
      m.loads[0].moment = {0, 0, moment};
      SimulationOptions o = tight();
      o.load_steps = 4;
      const auto model = Model<SE2>::build(m, *find_plane(m).plane);
      const auto found = solve_static(model, o);
      EXPECT_EQ(found.report.status, SolveStatus::Converged) << found.report.reason;
      EXPECT_EQ(found.report.rejected_steps, 0);
      ContinuumBody<SE2>::Points x;
      ContinuumBody<SE2>::of(*model.bodies[0])
          ->positions(found.trajectory.frames(found.trajectory.size() - 1), x);
      const int left = 8 * 17 + 8;  // of the nodes at the upper side
      return x(0, left + 1) - x(0, left);
    };
    EXPECT_GT(opening(10), 0);
    EXPECT_LT(opening(120), -0.2 * kWidth);
  }
}

/// Largest change of the energy of a body that moves freely, over its first value.
template <class G>
double energy_drift(const Mechanism& m, double h) {
  auto r = run<G>(m, space_of<G>(m), options(0.02, h, 1.0, 1e-9));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  double drift = 0;
  const double before = total_energy(r, 0);
  for (int n = 0; n <= r.last(); ++n)
    drift = std::max(drift, std::abs(total_energy(r, n) - before));
  return drift / before;
}

/// It spins and vibrates, let go undeformed; without numerical damping the energy is kept to the
/// second order of the step.
TEST(Continuum, AFreeBodyKeepsItsEnergy) {
  Mechanism flat, space;
  flat.bodies = {
      {"part", continuum_block({0.4, 0.04, 0.02}, 10, 1, 0, kSoft), {1, 2, 0}, {0, 0, 100}}};
  space.bodies = {
      {"part", continuum_block({0.4, 0.04, 0.02}, 6, 1, 1, kSoft), {1, 2, 0}, {20, 40, 60}}};
  const double coarse = energy_drift<SE2>(flat, 5e-5), fine = energy_drift<SE2>(flat, 2.5e-5);
  EXPECT_LT(fine, 1e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
  const double coarse3 = energy_drift<SE3>(space, 5e-5), fine3 = energy_drift<SE3>(space, 2.5e-5);
  EXPECT_LT(fine3, 1e-4);
  EXPECT_NEAR(std::log2(coarse3 / fine3), 2, 0.2);
}

TEST(Continuum, ASpinningBarIsStiffenedByItsStretch) {
  const double E = 1e6, rho = 1000;
  for (const double k : {0.1, 0.5}) {
    const double omega = k * std::sqrt(E / rho);
    SolidSpec bar = continuum_block({1, 0.2, 0.1}, 16, 2, 0, {"bar", E, 0, rho});
    bar.damping = 0.05;  // so that it bends no more when the spin is uniform
    Mechanism m = clamped(bar);
    m.joints[0].type = JointType::Revolute;
    m.drives = {{0, 0, TimeFunction::rate(omega, 3)}};
    const auto r = run_planar(m, options(9, 6e-3, 0.8, 1e-8));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    const double longer = r.trajectory().frames(r.last())[1].x.norm() - 1;
    const double linear = std::tan(k) / k, exact = spun_length(k * k);
    EXPECT_NEAR(longer / (exact - 1), 1, 2e-3) << k;
    if (k < 0.2) {
      EXPECT_NEAR(longer / (linear - 1), 1, 0.01);
    } else {
      EXPECT_LT(longer / (linear - 1), 0.9);
    }
  }
}

/// Within 1 % of the beam on the group, with one factor for all steps.
template <class G>
void expect_as_the_beam(const SolidSpec& part, double duration, Tie tie = Tie::Rigid) {
  SolidSpec rod = part;
  rod.model = with_ties(*rod.model, tie);
  rod.as = SolidMotion::Continuum;
  const auto deflection = [&](const Mechanism& m, auto space) {
    using Space = decltype(space);
    using Group = std::conditional_t<std::is_same_v<Space, liesl::Space<SE2>>, SE2, SE3>;
    const auto r = run<Group>(m, space, options(duration, 1e-4));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    EXPECT_LE(20 * r.report().factorizations[1], r.report().steps);
    ::testing::Test::RecordProperty(
        "us_a_step_of_" + std::to_string(r.model->nodes()) + "_nodes" +
            (rod.law == SolidLaw::NeoHookean ? "_neo_hookean" : ""),
        std::to_string(1e6 * r.report().stepping_cpu_s / double(r.report().steps)));
    const ResponseSpec bend = bend_of_the_rod(m);
    const ResponseValues<Group> values(m, *r.model);
    State<Group> s = r.model->initial_state();
    double largest = 0;
    for (int n = 0; n <= r.last(); ++n) {
      r.trajectory().read(n, s);
      largest = std::max(largest, values(bend, s).norm());
    }
    return largest;
  };
  const Mechanism beam = slider_crank_with_beam(32), mesh = slider_crank_with(rod, 1);
  const double by_beam = deflection(beam, *find_plane(beam).plane);
  const double ratio = deflection(mesh, space_of<G>(mesh)) / by_beam;
  ::testing::Test::RecordProperty((tie == Tie::Rigid ? "bends_in_space_" : "averaged_in_space_") +
                                      std::to_string(G::space_dim) +
                                      (rod.law == SolidLaw::NeoHookean ? "_neo_hookean" : ""),
                                  std::to_string(ratio));
  EXPECT_NEAR(ratio, 1, 0.01);
}

TEST(Continuum, ASlenderRodBendsAsTheBeam) {
  expect_as_the_beam<SE2>(meshed_rod({0.15, 0, 0}, 60, 4, 0), 0.12);
  SolidSpec hexahedra = meshed_rod({0.15, 0, 0}, 60, 4, 0, 4);
  expect_as_the_beam<SE3>(hexahedra, 0.02);
  hexahedra.law = SolidLaw::NeoHookean;
  expect_as_the_beam<SE3>(hexahedra, 0.02);
}

TEST(Continuum, ASlenderRodWithAveragedInterfacesBendsAsTheBeam) {
  expect_as_the_beam<SE2>(meshed_rod({0.15, 0, 0}, 60, 4, 0), 0.12, Tie::Averaged);
  expect_as_the_beam<SE3>(meshed_rod({0.15, 0, 0}, 30, 2, 0, 2), 0.02, Tie::Averaged);
}

/// The tip of data/scenes/pendulum.toml after half a second; errors, and microseconds a step, of
/// both in a table of docs/accuracy_and_speed.md.
TEST(Continuum, APendulumSwingsAsTheBeam) {
  const auto tip = [](int n, bool meshed) -> Eigen::Vector2d {
    Mechanism m = pendulum(n);
    if (meshed)
      m.bodies[0].kind = continuum_block({1, 0.01, 0.01}, n, 2, 0, {"soft", 5e8, 0.3, 7800});
    const auto r = run_planar(m, options(0.5, 1e-3, 0.8, 1e-8));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    RecordProperty((meshed ? "continuum_us_" : "beam_us_") + std::to_string(n),
                   std::to_string(1e6 * r.report().stepping_cpu_s / double(r.report().steps)));
    return r.trajectory().frames(r.last())[meshed ? 1 : n].x;
  };
  const Eigen::Vector2d fine = tip(64, false), limit = (4 * fine - tip(32, false)) / 3;
  const auto error = [&](int n, bool meshed) {
    const double off = (tip(n, meshed) - limit).norm();
    RecordProperty((meshed ? "continuum_off_" : "beam_off_") + std::to_string(n),
                   std::to_string(1e6 * off));
    return off;
  };
  for (const int n : {4, 8, 16}) error(n, false);
  error(10, true);
  error(20, true);
  const double before = error(40, true), last = error(80, true);
  EXPECT_LT(last, 2e-4);
  EXPECT_LT(last, 0.5 * before);
}

/// A strip that is bent by 45 degrees, 64 x 1 cells, in one load step, as beams are.
TEST(Continuum, BendsFarInFewLoadSteps) {
  const double h = 0.02, E = 1e6, EI = E * h * h * h / 12;
  const auto solved = [&](int load_steps) {
    Mechanism m = clamped(continuum_block({1, h, 1}, 64, 1, 0, {"plate", E, 0, 1}));
    m.loads = {end_load({0, 2 * EI, 0})};
    SimulationOptions o = tight();
    o.max_iterations = 40;
    o.load_steps = load_steps;
    return solve<SE2>(m, o, *find_plane(m).plane);
  };
  const auto at_once = solved(1), slowly = solved(40);
  for (const auto* found : {&at_once, &slowly})
    ASSERT_EQ(found->result.report.status, SolveStatus::Converged) << found->result.report.reason;
  EXPECT_EQ(at_once.result.report.rejected_steps, 0);
  EXPECT_LE(at_once.result.report.newton_iterations, 12);
  EXPECT_LT((at_once.frame(1).x - slowly.frame(1).x).norm(), 1e-7);
}

/// Pushed through itself, a block of the linear law ends with the time and what to do; the
/// neo-Hookean one is pushed on.
TEST(Continuum, ACellThatIsInvertedEndsTheRun) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    Mechanism m = clamped(continuum_block({1, 1, 1}, 2, 2, 0, {"foam", 1e3, 0, 100}, law));
    m.joints.push_back({"press", JointType::Prismatic, {}, {0, 1}, Vec3::UnitX()});
    m.drives = {{1, 0, TimeFunction::rate(-0.7, 0.1)}};
    const auto r = run_planar(m, options(1.3, 5e-3));
    if (law == SolidLaw::StVenantKirchhoff) {
      EXPECT_EQ(r.report().status, SolveStatus::NotConverged);
      EXPECT_NE(r.report().reason.find("of 'part' is inverted at t = "), std::string::npos)
          << r.report().reason;
    } else {
      EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    }
  }
}

}  // namespace
}  // namespace liesl::test::continuum_motion_test
