/// @file
/// Parameters from neighbouring mechanisms: they are those that are given by hand, and what has no
/// derivative is refused by its name.

#include "apps/tasks/mechanism_derivative.hpp"

#include <gtest/gtest.h>

#include "mbs/model/beam_ends.hpp"
#include "reference/continuum.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::mechanism_derivative_test {
namespace {

using Change = std::function<void(Mechanism&, double)>;

Mechanism machine() {
  Mechanism m = test::slider_crank({4});
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 1;
  spring.stiffness = 20;
  spring.damping = 0.1;
  spring.rest = 0.3;
  m.forces = {spring};
  LoadSpec load;
  load.name = "load";
  load.port = {1, 2};
  load.force = {3, -8, 0};
  m.loads = {load};
  return m;
}

Parameter parameter(const Change& change, double step = 1e-3, const Mechanism& m = machine()) {
  const auto changed = [&](double by) {
    Mechanism other = m;
    change(other, by);
    return other;
  };
  SimulationOptions simulation;
  simulation.duration = 0.1;
  return parameter_of("p", m, changed, step, simulation);
}

std::string refusal(const Change& change, const Mechanism& m = machine()) {
  try {
    parameter(change, 1e-3, m);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

BeamSpec& rod(Mechanism& m) { return std::get<BeamSpec>(m.bodies[1].kind); }
RigidSpec& slider(Mechanism& m) { return std::get<RigidSpec>(m.bodies[2].kind); }

template <class Part>
Part only(const Parameter& p) {
  EXPECT_EQ(p.parts.size(), 1u);
  const Part* part = p.parts.size() == 1 ? std::get_if<Part>(&p.parts[0]) : nullptr;
  EXPECT_TRUE(part);
  return part ? *part : Part{};
}

void expect_same_laws(const BeamDerivative& a, const BeamDerivative& b) {
  ASSERT_EQ(a.laws.size(), b.laws.size());
  for (std::size_t e = 0; e < a.laws.size(); ++e) {
    EXPECT_LE((a.laws[e].K - b.laws[e].K).norm(), 1e-10 * b.laws[e].K.norm());
    EXPECT_LE((a.laws[e].M - b.laws[e].M).norm(), 1e-10 * b.laws[e].M.norm());
  }
  ASSERT_EQ(a.stress.size(), b.stress.size());
  for (std::size_t e = 0; e < a.stress.size(); ++e)
    for (std::size_t k = 0; k < a.stress[e].size(); ++k)
      EXPECT_LE((a.stress[e][k] - b.stress[e][k]).norm(), 1e-10 * b.stress[e][k].norm());
}

TEST(MechanismDerivative, OfSectionsAndMaterials) {
  const Mechanism m = machine();
  const auto diameters = parameter([](Mechanism& c, double p) {
    for (int e : {1, 3}) std::get<Circle>(rod(c).sections[std::size_t(e)].shape).diameter += p;
  });
  expect_same_laws(only<BeamDerivative>(diameters), by_dimension(m, 1, {1, 3}, "diameter"));
  const double h = 2e8;
  expect_same_laws(
      only<BeamDerivative>(parameter([](Mechanism& c, double p) { rod(c).material.E += p; }, h)),
      by_youngs_modulus(m, 1));
  expect_same_laws(
      only<BeamDerivative>(parameter([](Mechanism& c, double p) { rod(c).material.rho += p; }, 8)),
      by_density(m, 1));
}

/// The diameter at the root of a taper: it moves the sections at both ends of an element by other
/// shares than that in the middle.
TEST(MechanismDerivative, OfTapers) {
  const auto root = [](Mechanism& c, double p) {
    const auto at = [p](double s) {
      return Section{"round", Circle{(0.01 + p) * (1 - s) + 0.006 * s}};
    };
    BeamSpec& beam = rod(c);
    beam.ends.clear();
    for (int e = 0; e < 4; ++e) {
      beam.sections[std::size_t(e)] = at((e + 0.5) / 4);
      beam.ends.push_back({at(e / 4.), at((e + 1) / 4.)});
    }
  };
  Mechanism m = machine();
  root(m, 0);
  const auto by_root = only<BeamDerivative>(parameter(root, 1e-4, m));
  Mechanism perturbed[] = {m, m};
  const double h = 1e-7;
  root(perturbed[0], -h);
  root(perturbed[1], h);
  for (std::size_t e = 0; e < 4; ++e) {
    const auto before = element_stress_points(rod(perturbed[0]), e);
    const auto after = element_stress_points(rod(perturbed[1]), e);
    for (std::size_t k = 0; k < after.size(); ++k) {
      const auto difference = ((after[k].S - before[k].S) / (2 * h)).eval();
      EXPECT_LE((by_root.stress[e][k] - difference).norm(), 1e-7 * difference.norm()) << e << k;
    }
    for (const auto place : {ElementPlace::First, ElementPlace::Middle, ElementPlace::Last}) {
      const auto K = [&](Mechanism& c) {
        return section_law(section_at(rod(c), e, place), rod(c).material).K;
      };
      const auto difference = ((K(perturbed[1]) - K(perturbed[0])) / (2 * h)).eval();
      EXPECT_LE((by_root.law_at(e, place).K - difference).norm(), 1e-7 * difference.norm()) << e;
    }
  }
}

TEST(MechanismDerivative, OfMassesForcesAndLoads) {
  const auto rigid = only<RigidDerivative>(parameter([](Mechanism& c, double p) {
    slider(c).mass += 2 * p;
    slider(c).inertia(2, 2) += 3 * p;
    slider(c).centre.y() += 4 * p;
  }));
  EXPECT_EQ(rigid.body, 2);
  EXPECT_NEAR(rigid.mass, 2, 1e-10);
  EXPECT_NEAR(rigid.inertia(2, 2), 3, 1e-10);
  EXPECT_NEAR(rigid.centre.y(), 4, 1e-10);
  const auto force = only<ForceDerivative>(parameter([](Mechanism& c, double p) {
    c.forces[0].stiffness += 2 * p;
    c.forces[0].damping += 3 * p;
    c.forces[0].rest += 4 * p;
  }));
  EXPECT_NEAR(force.stiffness, 2, 1e-10);
  EXPECT_NEAR(force.damping, 3, 1e-10);
  EXPECT_NEAR(force.rest, 4, 1e-10);
  EXPECT_TRUE(force.function.empty());
  const auto load = only<LoadDerivative>(
      parameter([](Mechanism& c, double p) { c.loads[0].force.x() += 5 * p; }));
  EXPECT_EQ(load.factor, 0);
  EXPECT_NEAR(load.force.x(), 5, 1e-10);
  EXPECT_EQ(load.force.y(), 0);
}

/// Functions of time: a value in a table of a drive against the difference of tables that are
/// hardly apart.
TEST(MechanismDerivative, OfTablesOfDrives) {
  using enum TimeFunction::Interpolation;
  for (const auto how : {Linear, Cubic, Quintic}) {
    const auto table = [how](double p) {
      return TimeFunction::table({0, 0.02, 0.05, 0.1}, {0, 0.3 + p, 1.1, 1.5}, how);
    };
    const auto drive = only<DriveDerivative>(
        parameter([&](Mechanism& c, double p) { c.drives[0].motion = table(p); }));
    EXPECT_EQ(drive.factor, 0);
    const double h = 1e-6;
    for (const double t : {0., 0.005, 0.01, 0.02, 0.03, 0.06, 0.1}) {
      double by_p = 0;
      for (const auto& f : drive.motion) by_p += f.weight * f.function(t);
      EXPECT_NEAR(by_p, (table(h)(t) - table(-h)(t)) / (2 * h), 1e-8) << t;
    }
  }
}

/// Gravity, geometry, damping, axes: by mechanisms at values near p, whose weights differentiate.
TEST(MechanismDerivative, OfAllElseIsByMechanismsNearBy) {
  const std::vector<Change> changes = {[](Mechanism& c, double p) { c.gravity.y() += p; },
                                       [](Mechanism& c, double p) { rod(c).nodes[2].x.y() += p; },
                                       [](Mechanism& c, double p) { rod(c).damping += p * p; },
                                       [](Mechanism& c, double p) { c.joints[0].axis.x() += p; }};
  for (const Change& change : changes) {
    const auto mechanisms = only<NearbyMechanisms>(parameter(change));
    ASSERT_TRUE(mechanisms.at);
    double constant = 0;
    for (std::size_t i = 0; i < mechanisms.at->size(); ++i) constant += mechanisms.weight(i);
    EXPECT_NEAR(constant, 0, 1e-12 * std::abs(mechanisms.weight(0)));
  }
}

/// An entry of the matrix of a bushing changes what its springs act on.
TEST(MechanismDerivative, OfSharesIsByMechanismsNearBy) {
  only<NearbyMechanisms>(parameter([](Mechanism& c, double p) {
    c.forces[0].stiffness += 2 * p;
    c.forces[0].shares = {{1, 0.5 + p}};
  }));
}

TEST(MechanismDerivative, WhatHasNoneIsRefusedByName) {
  EXPECT_NE(refusal([](Mechanism&, double) {}).find("'p' changes nothing"), std::string::npos);
}

/// A change of the meshed rod that builds it anew.
Change built_anew(
    const std::function<void(SolidMesh&, Material&, SolidModel::Options&, double)>& change) {
  return [change](Mechanism& m, double p) {
    auto& solid = std::get<SolidSpec>(m.bodies[1].kind);
    SolidMesh mesh = solid.mesh();
    Material material = solid.model->material();
    SolidModel::Options options{solid.model->thickness(), solid.model->law()};
    change(mesh, material, options, p);
    solid.model =
        std::make_shared<const SolidModel>(std::move(mesh), material, solid.interfaces(), options);
  };
}

Mechanism with_mesh(SolidMotion as) {
  Mechanism m = slider_crank_with_mesh(10, 2, 1);
  std::get<SolidSpec>(m.bodies[1].kind).as = as;
  return m;
}

/// Its matrices are proportional to E, rho and the thickness.
TEST(MechanismDerivative, OfMeshedPartsByMaterialAndThickness) {
  for (const SolidMotion as : {SolidMotion::Reduced, SolidMotion::Continuum}) {
    const Mechanism m = with_mesh(as);
    const auto scale = [&m](const auto& change) {
      return only<SolidScale>(parameter(built_anew(change), 1e-3, m));
    };
    const SolidScale by_E = scale([](auto&, Material& of, auto&, double p) { of.E *= 1 + p; });
    EXPECT_EQ(by_E.body, 1);
    EXPECT_NEAR(by_E.E, 1, 1e-12);
    EXPECT_EQ(by_E.mass(), 0);
    const SolidScale by_rho = scale([](auto&, Material& of, auto&, double p) { of.rho *= 1 + p; });
    EXPECT_EQ(by_rho.stiffness(), 0);
    EXPECT_NEAR(by_rho.rho, 1, 1e-12);
    const SolidScale by_thickness =
        scale([](auto&, auto&, SolidModel::Options& of, double p) { of.thickness *= 1 + p; });
    EXPECT_NEAR(by_thickness.stiffness(), 1, 1e-12);
    EXPECT_NEAR(by_thickness.mass(), 1, 1e-12);
    EXPECT_EQ(by_thickness.E, 0);  // stress does not follow
  }
}

/// Numbers of an outline change the fractions of cells, to first order by the numbers alone.
TEST(MechanismDerivative, OfOutlinesIsOfTheFractionsOfTheirCells) {
  for (const SolidMotion as : {SolidMotion::Reduced, SolidMotion::Continuum}) {
    Mechanism m = with_mesh(as);
    auto& holed_rod = std::get<SolidSpec>(m.bodies[1].kind);
    cut_hole(holed_rod, 0.1, 0.001, 0.004);
    const auto by = only<SolidDerivative>(parameter(
        [](Mechanism& c, double p) {
          auto& holed = std::get<SolidSpec>(c.bodies[1].kind);
          set_outline(holed, "hole.radius", 0.004 + 2 * p);
          set_outline(holed, "hole.x", 0.1 - p);
        },
        1e-4, m));
    const Eigen::VectorXd exact =
        2 * fractions_by(holed_rod, "hole.radius") - fractions_by(holed_rod, "hole.x");
    EXPECT_EQ(by.body, 1);
    ASSERT_GT(exact.norm(), 0);
    EXPECT_LT((by.fractions - exact).norm(), 1e-10 * exact.norm());
  }
}

/// Of a continuum what else changes is by nearby mechanisms; the modes of a reduced part have no
/// derivative by it.
TEST(MechanismDerivative, OfMeshesAndPoissonsRatioOfAContinuumAlone) {
  const Change stretched =
                   built_anew([](SolidMesh&mesh, auto&, auto&, double p) { mesh.nodes *= 1 + p; }),
               poisson = built_anew([](auto&, Material&of, auto&, double p) { of.nu += p; });
  for (const Change& change : {stretched, poisson}) {
    EXPECT_TRUE(
        only<NearbyMechanisms>(parameter(change, 1e-3, with_mesh(SolidMotion::Continuum))).at);
    EXPECT_NE(refusal(change, with_mesh(SolidMotion::Reduced)).find("of the meshed body 'rod'"),
              std::string::npos);
  }
}

/// The number of unknowns would change.
TEST(MechanismDerivative, OfFinerMeshesIsRefused) {
  const Change finer = [](Mechanism& m, double p) {
    auto& solid = std::get<SolidSpec>(m.bodies[1].kind);
    if (p != 0) solid = meshed_rod(solid.frame.x, 12, 2, 1);
  };
  EXPECT_NE(refusal(finer, with_mesh(SolidMotion::Reduced)).find("the kind of body 'rod'"),
            std::string::npos);
}

}  // namespace
}  // namespace liesl::test::mechanism_derivative_test
