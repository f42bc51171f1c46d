/// @file
/// Meshed parts whose nodes all move, with an outline: forces, tangents, derivatives by numbers of
/// the outline, and cells that are void.

#include <numbers>

#include "mbs/bodies/continuum.hpp"
#include "mbs/bodies/driven_block.hpp"
#include "mbs/solids/connectivity.hpp"
#include "mbs/step_sweep.hpp"
#include "mbs/step_tangent.hpp"
#include "reference/ties.hpp"

namespace liesl::test::continuum_outline_test {
namespace {

using Eigen::VectorXd;

/// A hole about its middle, which leaves cells void.
template <class G>
SolidSpec block_with_hole(SolidLaw law = SolidLaw::StVenantKirchhoff, double damping = 1e-4) {
  SolidSpec block =
      continuum_block({0.4, 0.1, 0.05}, 16, 4, G::space_dim == 2 ? 0 : 1, kSoftBlock, law);
  block.damping = damping;
  cut_hole(block, 0.2, 0, 0.04);
  return block;
}

template <class G>
Model<G> model_of(const SolidSpec& part) {
  const Mechanism m = driven<G>(part);
  return Model<G>::build(m, space_of<G>(m));
}

template <class G>
typename Body<G>::Vector weight() {
  return 3 * Body<G>::Vector::Ones();
}

template <class G>
VectorXd internal(const Body<G>& body, const BodyState<G>& s) {
  VectorXd r = VectorXd::Zero(body.size());
  ForceScale scale;
  body.add_internal(s, r.data(), scale);
  return r;
}

template <class G>
VectorXd inertia(const Body<G>& body, const BodyState<G>& s) {
  VectorXd r = VectorXd::Zero(body.size());
  ForceScale scale;
  body.add_inertia(s, weight<G>(), r.data(), scale);
  return r;
}

/// All that is linear in the energies of the cells.
template <class G>
std::vector<VectorXd> all_of(const Body<G>& body, const BodyState<G>& s) {
  VectorXd along = VectorXd::LinSpaced(body.size(), 1, 2);
  for (int k = 0; k < body.nodes(); ++k)  // positions do not turn
    if (body.kind(k) == NodeKind::Position)
      along.segment(G::dim * k + G::space_dim, G::rotation_dim).setZero();
  const BodyEnergy e = body.energy(s, weight<G>());
  VectorXd masses(3);
  masses << body.total_mass(), e.kinetic, e.potential;
  return {internal<G>(body, s),
          inertia<G>(body, s),
          body.stiffness().sparse * along,
          body.mass().sparse * along,
          masses,
          VectorXd::Constant(1, e.elastic),
          VectorXd::Constant(1, body.dissipation(s))};
}

template <class G>
class ContinuumOutline : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ContinuumOutline, Groups);

/// Bit for bit.
TYPED_TEST(ContinuumOutline, WithoutEffectChangesNothing) {
  using G = TypeParam;
  SolidSpec plain = block_with_hole<G>(), all = plain;
  plain.outline = {};
  cut_hole(all, 10, 0, 0.01);
  const auto a = model_of<G>(plain), b = model_of<G>(all);
  const State<G> s = disturbed(a, 2e-3);
  const auto of_a = all_of<G>(*a.bodies[0], a.body_state(s, 0)),
             of_b = all_of<G>(*b.bodies[0], b.body_state(s, 0));
  for (std::size_t i = 0; i < of_a.size(); ++i) EXPECT_EQ((of_a[i] - of_b[i]).norm(), 0) << i;
}

/// Of its fractions, but for a millionth that empty cells keep.
TYPED_TEST(ContinuumOutline, WeighsWhatItsMaterialDoes) {
  using G = TypeParam;
  const SolidSpec part = block_with_hole<G>();
  const auto model = model_of<G>(part);
  const double material = part.model->total_mass(solid_fractions(part).value);
  EXPECT_NEAR(material, 50 * (0.04 - std::numbers::pi * 0.04 * 0.04), 2e-3 * material);
  EXPECT_NEAR(model.bodies[0]->total_mass(), material, 1e-6 * material);
}

TYPED_TEST(ContinuumOutline, ForcesHaveThePowerOfTheEnergies) {
  using G = TypeParam;
  const auto model = model_of<G>(block_with_hole<G>(SolidLaw::NeoHookean, 0));
  const State<G> s = disturbed(model, 2e-3);
  const auto energy = [&](double t) {
    State<G> at = s;
    model.retract(at, t * s.v + 0.5 * t * t * s.vdot);
    at.v += t * s.vdot;
    const BodyEnergy e = model.bodies[0]->energy(model.body_state(at, 0), weight<G>());
    return Eigen::Vector2d(e.elastic, e.kinetic + e.potential);
  };
  const double h = 1e-6;
  const Eigen::Vector2d slope = (energy(h) - energy(-h)) / (2 * h);
  const auto state = model.body_state(s, 0);
  EXPECT_NEAR(internal<G>(*model.bodies[0], state).dot(s.v), slope[0], 1e-7 * std::abs(slope[0]));
  EXPECT_NEAR(inertia<G>(*model.bodies[0], state).dot(s.v), slope[1], 1e-7 * std::abs(slope[1]));
}

TYPED_TEST(ContinuumOutline, DoesNotSeeRigidMotions) {
  using G = TypeParam;
  const auto model = model_of<G>(block_with_hole<G>());
  const Body<G>& body = *model.bodies[0];
  const G moved = G::exp(2.1 * G::Tangent::Ones());
  State<G> at = model.initial_state();
  for (auto& H : at.H) H = moved * H;
  for (const int k : model.positions()) at.H[k].R = body.reference[k].R;
  body.turn_axes(at.H.data());
  for (int k = 0; k < body.nodes(); ++k)
    EXPECT_LT((at.H[k].R - (moved * body.reference[k]).R).norm(), 1e-12) << k;
  at.v.setZero();
  EXPECT_LT(internal<G>(body, model.body_state(at, 0)).norm(), 1e-12 * body.axial_stiffness());
  EXPECT_FALSE(body.fault(at.H.data()));
}

/// Of a step in motion and of statics, both laws, damped; in motion also against its transposed.
TYPED_TEST(ContinuumOutline, TangentsAreExact) {
  using G = TypeParam;
  constexpr int dim = G::dim, sd = G::space_dim;
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    const auto model = model_of<G>(block_with_hole<G>(law));
    StepTangent<G> tangent(model, options(0.02, 5e-4, 0.8, 1e-9), 10);
    tangent.expect_exact("motion", 40);
    tangent.expect_transposed("motion");
    State<G> at = model.initial_state();
    Random random(3);
    VectorXd h = 1e-3 * random.vector(model.size());
    for (const int k : model.positions()) h.segment(dim * k + sd, dim - sd).setZero();
    model.retract(at, h);
    at.lambda = 100 * random.vector(model.constraints());
    expect_exact_statics(model, at, {0, 1}, "statics", 40);
  }
}

/// By radius and place of the hole, its interfaces rigid and averaged.
TYPED_TEST(ContinuumOutline, DerivativesAreThoseOfDifferences) {
  using G = TypeParam;
  for (const Tie tie : {Tie::Rigid, Tie::Averaged}) {
    SolidSpec part = block_with_hole<G>(SolidLaw::NeoHookean);
    part.model = with_ties(*part.model, tie);
    cut_hole(part, 0.2013, 0.0021, 0.0374);
    const auto model = model_of<G>(part);
    const State<G> s = disturbed(model, 2e-3);
    for (const std::string name : {"hole.radius", "hole.x", "hole.y"}) {
      const auto derivative = model.bodies[0]->derivative(FractionDerivative{
          part.model.get(), solid_fractions(part).value, fractions_by(part, name)});
      const auto exact = all_of<G>(*derivative, model.body_state(s, 0));
      const auto at = [&](double p) {
        SolidSpec changed = part;
        set_outline(changed, name, p);
        const auto near = model_of<G>(changed);
        return all_of<G>(*near.bodies[0], near.body_state(s, 0));
      };
      const double p = outline_values(part)[outline_number(part, name)], h = 1e-6;
      const auto up = at(p + h), down = at(p - h);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const VectorXd slope = (up[i] - down[i]) / (2 * h);
        EXPECT_GT(exact[i].norm(), 0) << name << i;
        EXPECT_LT((slope - exact[i]).norm(), 1e-7 * exact[i].norm()) << name << i;
      }
    }
  }
}

/// Node of the mesh at a place in its axes.
int mesh_node(const SolidSpec& part, double x, double y) {
  for (int i = 0; i < part.mesh().node_count(); ++i)
    if ((part.mesh().nodes.col(i) - Vec3(x, y, 0)).norm() < 1e-9) return i;
  throw std::runtime_error("no node there");
}

/// In the void they may, whatever the law of the material.
TEST(ContinuumVoid, CellsMayFold) {
  const SolidSpec part = block_with_hole<SE2>(SolidLaw::NeoHookean);
  const auto model = model_of<SE2>(part);
  const auto& body = *ContinuumBody<SE2>::of(*model.bodies[0]);
  const auto moved = [&](double x, double y) {
    State<SE2> s = model.initial_state();
    SE2& H = s.H[std::size_t(body.node_of(mesh_node(part, x, y)))];
    H.x += H.R * Eigen::Vector2d(0.06, 0);  // beyond the next two nodes
    return s;
  };
  const State<SE2> in_void = moved(0.2, 0), in_material = moved(0.05, 0);
  EXPECT_FALSE(body.fault(in_void.H.data()));
  EXPECT_EQ(body.no_forces(in_void.H.data()), "");
  EXPECT_TRUE(internal<SE2>(body, model.body_state(in_void, 0)).allFinite());
  EXPECT_NE(body.fault(in_material.H.data()).value().what.find("is inverted"), std::string::npos);
  EXPECT_NE(body.no_forces(in_material.H.data()).find("has no stress"), std::string::npos);
}

/// That of the material in each cell that has any, whatever its share.
TEST(ContinuumVoid, HasNoStress) {
  const SolidSpec part = block_with_hole<SE2>();
  const auto model = model_of<SE2>(part);
  const auto& body = *ContinuumBody<SE2>::of(*model.bodies[0]);
  ContinuumBody<SE2>::Points x;
  body.positions(model.initial_state().H.data(), x);
  const Eigen::MatrixXd stress = body.stresses_at(1.01 * x);
  const VectorXd v = solid_fractions(part).value;
  int empty = 0;
  for (int e = 0; e < v.size(); ++e) {
    const bool is_void = v[e] < kLeastFraction;
    empty += is_void;
    EXPECT_LT((stress.col(e) - (is_void ? 0 : 1) * stress.col(0)).norm(),
              1e-9 * stress.col(0).norm())
        << e;
  }
  EXPECT_EQ(empty, 4);
  EXPECT_GT(stress(0, 0), 0);
}

}  // namespace
}  // namespace liesl::test::continuum_outline_test
