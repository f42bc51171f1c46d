/// @file
/// Load sets of a meshed part: the static answer of the full mesh is the dynamic deformation.
#include "esl/solid_loads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "esl/load_patches.hpp"
#include "mbs/solids/solid_statics.hpp"
#include "mbs/solvers/dynamics.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::solid_loads_test {
namespace {

struct Moved {
  Mechanism mechanism = test::slider_crank_with_mesh(30, 3, 5);
  Model<SE2> model = Model<SE2>::build(mechanism, *find_plane(mechanism).plane);
  DynamicResult<SE2> result;
  SolidLoadSet loads;
  Moved() {
    SimulationOptions o;
    o.duration = 0.05;
    o.step = 2e-4;
    result = simulate(model, o);
    loads = extract_solid_loads(model, result.trajectory, 1);
  }
  const SolidSpec& rod() const { return std::get<SolidSpec>(mechanism.bodies[1].kind); }
};

const Moved& moved() {
  static const Moved m;
  return m;
}

Identity identity_of(const SolidLoadSet& loads, int cases) {
  const SolidModel& model = *moved().rod().model;
  return check_identity(model, solid_fractions(moved().rod()).value, loads, cases);
}

TEST(SolidLoads, GiveBackTheDynamicDeformation) {
  ASSERT_EQ(moved().result.report.status, SolveStatus::Converged);
  const Identity id = identity_of(moved().loads, 20);
  EXPECT_GE(id.cases, 10);
  EXPECT_LT(id.linear, 1e-8);
  EXPECT_LT(id.nonlinear, 1e-8);
}

TEST(SolidLoads, AreInEquilibrium) {
  const SolidModel& model = *moved().rod().model;
  const auto& loads = moved().loads;
  for (int n = 10; n < static_cast<int>(loads.t.size()); n += 40) {
    const Eigen::VectorXd f = loads.load(n);
    const Eigen::VectorXd sum = model.rigid_motions().transpose() * f;
    EXPECT_LT(sum.norm(), 1e-9 * f.norm()) << n;
  }
}

/// With inertia relief the same deformation but for a rigid motion: the stretch between the ports.
TEST(SolidLoads, DeformTheSameWithoutASupport) {
  const SolidModel& model = *moved().rod().model;
  const auto& loads = moved().loads;
  SolidStatics statics(model, SolidSupport::relief(), elongation_output(model, 0, 1));
  statics.set_loads(loads.shapes * loads.e);
  ASSERT_EQ(statics.solve(Eigen::VectorXd::Ones(model.mesh().cell_count())), SolidStatus::Solved);
  const Eigen::VectorXd dynamic =
      (elongation_output(model, 0, 1).transpose() * (loads.basis * loads.e)).transpose();
  EXPECT_LT((statics.y().transpose() - dynamic).cwiseAbs().maxCoeff(),
            1e-8 * dynamic.cwiseAbs().maxCoeff());
}

TEST(SolidLoads, OfOtherBodiesAreRefused) {
  EXPECT_THROW(extract_solid_loads(moved().model, moved().result.trajectory, 0),
               std::invalid_argument);
}

/// Forces and moments about the origin of interfaces and patches: that of a load in equilibrium,
/// and those of the patches are those of all free nodes.
TEST(SolidLoads, PatchesAndInterfacesBalance) {
  const SolidModel& model = *moved().rod().model;
  const LoadPatches patches = load_patches(model);
  EXPECT_GT(patches.places.cols(), kLoadPatches / 2);
  EXPECT_LT(patches.places.cols(), 2 * kLoadPatches);
  for (const int n : {40, 125, 201}) {
    const Eigen::VectorXd f = moved().loads.load(n);
    const auto inside = patches.of(f);
    Eigen::Vector3d force = inside.topRows<3>().rowwise().sum();
    Eigen::Vector3d moment = inside.bottomRows<3>().rowwise().sum();
    for (Eigen::Index p = 0; p < inside.cols(); ++p)
      moment +=
          Eigen::Vector3d(patches.places.col(p)).cross(Eigen::Vector3d(inside.col(p).head<3>()));
    const double size = force.norm(), turn = moment.norm();
    for (int k = 0; k < model.ports(); ++k) {
      const Eigen::Vector3d at(f[model.port(k)], f[model.port(k) + 1], 0);
      force += at;
      moment += model.interfaces()[std::size_t(k)].point.cross(at) +
                f[model.port(k) + 2] * Eigen::Vector3d::UnitZ();
    }
    EXPECT_GT(size, 1);
    EXPECT_LT(force.norm(), 1e-8 * size);
    EXPECT_LT(moment.norm(), 1e-8 * std::max(turn, size));
  }
}

TEST(SolidLoads, OfAPartAtRestAreNone) {
  SolidLoadSet still = moved().loads;
  still.e.setZero();
  EXPECT_EQ(identity_of(still, 8).linear, 0);
}

}  // namespace
}  // namespace liesl::test::solid_loads_test
