/// @file
/// Forces of meshed parts whose nodes all move, by their nodes at rest: against differences of the
/// forces of nearby parts at states that go with them.

#include "mbs/bodies/driven_block.hpp"
#include "mbs/system/nearby_models.hpp"
#include "reference/ties.hpp"

namespace liesl::test::continuum_shape_test {
namespace {

using Eigen::VectorXd;

struct Case {
  const char* name;
  SolidLaw law;
  Tie tie;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

/// A mesh that is stretched and sheared, the more the farther from the first interface, which is
/// sheared, too.
SolidSpec deformed(SolidSpec part, double p) {
  const auto at = [p](const Vec3& X) -> Vec3 {
    return X + p * Vec3(0.8 * X.x() + X.y(), 0.5 * X.y() + 2 * X.x() * X.y(), 0.3 * X.z());
  };
  SolidMesh mesh = part.mesh();
  for (int i = 0; i < mesh.node_count(); ++i) mesh.nodes.col(i) = at(mesh.nodes.col(i));
  auto interfaces = part.interfaces();
  for (Interface& f : interfaces) f.point = at(f.point);
  const SolidModel& old = *part.model;
  part.model =
      std::make_shared<const SolidModel>(std::move(mesh), old.material(), std::move(interfaces),
                                         SolidModel::Options{old.thickness(), old.law()});
  return part;
}

template <class G>
SolidSpec block(const Case& of) {
  SolidSpec part =
      continuum_block({0.4, 0.1, 0.05}, 6, 2, G::space_dim == 2 ? 0 : 1, kSoftBlock, of.law);
  part.damping = 1e-3;
  part.model = with_ties(*part.model, of.tie);
  return deformed(part, 0.05);  // cells that are no parallelograms
}

template <class G>
Mechanism mechanism(const Case& of, double p) {
  return driven<G>(deformed(block<G>(of), p));
}

template <class G>
NearbyMechanisms nearby(const Case& of, double step) {
  return {std::make_shared<const std::array<Mechanism, 4>>(
              std::array<Mechanism, 4>{mechanism<G>(of, -2 * step), mechanism<G>(of, -step),
                                       mechanism<G>(of, step), mechanism<G>(of, 2 * step)}),
          step};
}

constexpr LoadLevel kLevel{0.01, 1};

/// By differences of all of the residual, of states that go with the geometry where `lifted`.
template <class G>
VectorXd by_differences(const Model<G>& model, const NearbyModels<G>& near, const State<G>& s,
                        bool lifted) {
  VectorXd r_p = VectorXd::Zero(model.size());
  State<G> at = s;
  for (const auto& neighbour : near.models()) {
    if (lifted) near.lift(*neighbour, s, at);
    Equations<G> all(neighbour->model);
    all.evaluate(at, s.rows, kLevel);
    r_p += neighbour->weight * all.r;
  }
  return r_p;
}

template <class G>
void expect_exact(const Case& of, bool lifted) {
  const Mechanism m = mechanism<G>(of, 0);
  const auto model = Model<G>::build(m, space_of<G>(m));
  const State<G> s = disturbed(model, 2e-3);
  VectorXd exact = VectorXd::Zero(model.size()), phi_p = VectorXd::Zero(model.constraints());
  const auto off = [&](double step) {
    const NearbyModels<G> near(nearby<G>(of, step), model);
    exact.setZero();
    if (lifted)
      near.add_lifted(s, s.rows, kLevel, exact, phi_p);
    else
      near.add(s, s.rows, kLevel, exact, phi_p);
    return (by_differences(model, near, s, lifted) - exact).norm() / exact.norm();
  };
  const double coarse = off(8e-3), fine = off(2e-3);  // above round-off
  EXPECT_LT(fine, 3e-8) << coarse;
  EXPECT_LT(fine, std::max(coarse / 100, 1e-11)) << coarse;  // 256 of fourth order
}

class ContinuumShape : public ::testing::TestWithParam<Case> {};

TEST_P(ContinuumShape, ForcesAreThoseOfDifferences) {
  for (const bool lifted : {true, false}) {
    SCOPED_TRACE(lifted ? "states go with the mesh" : "constant states");
    expect_exact<SE2>(GetParam(), lifted);
    expect_exact<SE3>(GetParam(), lifted);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ContinuumShape,
                         ::testing::Values(Case{"linear", SolidLaw::StVenantKirchhoff, Tie::Rigid},
                                           Case{"neo_hookean", SolidLaw::NeoHookean, Tie::Rigid},
                                           Case{"averaged", SolidLaw::NeoHookean, Tie::Averaged}),
                         [](const auto& of) { return std::string(of.param.name); });

/// Of another stiffness or damping the forces are differenced: no shape says what they change by.
TEST(ContinuumShapes, OfAnotherMaterialHaveNoDerivative) {
  const Case of{"linear", SolidLaw::StVenantKirchhoff, Tie::Rigid};
  const Mechanism m = mechanism<SE2>(of, 0);
  const auto model = Model<SE2>::build(m, space_of<SE2>(m));
  SolidSpec part = block<SE2>(of);
  const auto derivative = [&](const SolidSpec& other) {
    const Mechanism changed = driven<SE2>(other);
    const auto near = Model<SE2>::build(changed, model.space);
    return model.bodies[0]->by_shape({{1, near.bodies[0].get()}});
  };
  EXPECT_NE(derivative(part), nullptr);
  part.damping = 2e-3;
  EXPECT_EQ(derivative(part), nullptr);
  part = block<SE2>(of);
  part.law = SolidLaw::NeoHookean;
  EXPECT_EQ(derivative(part), nullptr);
}

}  // namespace
}  // namespace liesl::test::continuum_shape_test
