/// @file
/// Identities of a meshed part whose nodes all move: power, rigid motions, tangents, mass, patch
/// test.

#include "mbs/bodies/continuum.hpp"

#include <Eigen/LU>

#include "mbs/bodies/driven_block.hpp"
#include "mbs/bodies/nodal_statics.hpp"
#include "mbs/solids/meshes.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/step_tangent.hpp"
#include "reference/ties.hpp"

namespace liesl::test::continuum_test {
namespace {

using Eigen::VectorXd;

/// A short block.
template <class G>
SolidSpec block_of(double damping, SolidLaw law) {
  SolidSpec block = G::space_dim == 2 ? continuum_block({0.4, 0.1, 0.05}, 4, 2, 0, kSoftBlock, law)
                                      : continuum_block({0.4, 0.1, 0.05}, 3, 1, 1, kSoftBlock, law);
  block.damping = damping;
  return block;
}

template <class G>
class ContinuumTest : public ::testing::Test {
 protected:
  using Tangent = typename G::Tangent;

  explicit ContinuumTest(double damping = 0)
      : model(Model<G>::build(mechanism(damping), space_of<G>(mechanism(damping)))),
        body(*model.bodies[0]) {
    s = disturbed(model, 0.02);
  }
  static Mechanism mechanism(double damping) {
    return driven<G>(block_of<G>(damping, SolidLaw::StVenantKirchhoff));
  }
  BodyState<G> state() const { return model.body_state(s, 0); }
  VectorXd internal(const State<G>& at) const {
    VectorXd r = VectorXd::Zero(body.size());
    ForceScale scale;
    body.add_internal(model.body_state(at, 0), r.data(), scale);
    return r;
  }
  VectorXd inertia(const typename Body<G>::Vector& g) const {
    VectorXd r = VectorXd::Zero(body.size());
    ForceScale scale;
    body.add_inertia(state(), g, r.data(), scale);
    return r;
  }
  /// Energy after the time t at the rates of the state.
  BodyEnergy energy(double t) const {
    State<G> at = s;
    model.retract(at, t * s.v + 0.5 * t * t * s.vdot);
    at.v += t * s.vdot;
    return body.energy(model.body_state(at, 0), gravity);
  }
  double slope(double BodyEnergy::*part) const {
    const double h = 2e-6;
    return (energy(h).*part - energy(-h).*part) / (2 * h);
  }

  typename Body<G>::Vector gravity = 3 * Body<G>::Vector::Ones();
  Model<G> model;
  const Body<G>& body;
  State<G> s;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ContinuumTest, Groups);

TYPED_TEST(ContinuumTest, ForcesHaveThePowerOfTheEnergies) {
  const double elastic = this->slope(&BodyEnergy::elastic),
               kinetic = this->slope(&BodyEnergy::kinetic),
               potential = this->slope(&BodyEnergy::potential);
  const VectorXd still = this->inertia(0 * this->gravity);
  EXPECT_NEAR(this->internal(this->s).dot(this->s.v), elastic, 1e-7 * std::abs(elastic));
  EXPECT_NEAR(still.dot(this->s.v), kinetic, 1e-7 * std::abs(kinetic));
  EXPECT_NEAR((this->inertia(this->gravity) - still).dot(this->s.v), potential,
              1e-7 * std::abs(potential));
}

TYPED_TEST(ContinuumTest, EnergyGradientsAreDerivatives) {
  const BodyEnergy weight{0.7, 1.3, -0.4};
  VectorXd h = VectorXd::Zero(this->body.size()), v = h;
  this->body.add_energy_gradient(this->state(), this->gravity, weight, h.data(), v.data());
  const auto value = [&](const State<TypeParam>& at) {
    const BodyEnergy e = this->body.energy(this->model.body_state(at, 0), this->gravity);
    return weight.kinetic * e.kinetic + weight.elastic * e.elastic + weight.potential * e.potential;
  };
  const double step = 1e-5;
  for (const int i : unknowns(this->model)) {
    if (i >= this->body.size()) continue;
    const VectorXd unit = step * VectorXd::Unit(this->body.size(), i);
    State<TypeParam> up = this->s, down = this->s;
    this->model.retract(up, unit);
    this->model.retract(down, -unit);
    EXPECT_NEAR(h[i], (value(up) - value(down)) / (2 * step), 1e-6 * h.norm());
    up = down = this->s;
    up.v += unit;
    down.v -= unit;
    EXPECT_NEAR(v[i], (value(up) - value(down)) / (2 * step), 1e-6 * v.norm());
  }
}

/// A rigid motion of the whole makes no force; stiffness in the axes of the nodes is that at rest.
TYPED_TEST(ContinuumTest, DoesNotSeeRigidMotions) {
  using G = TypeParam;
  const G moved = G::exp(2.1 * G::Tangent::Ones());
  State<G> at = this->model.initial_state();
  for (auto& H : at.H) H = moved * H;
  for (const int k : this->model.positions()) at.H[k].R = this->model.bodies[0]->reference[k].R;
  this->body.turn_axes(at.H.data());
  for (int k = 0; k < this->body.nodes(); ++k)
    EXPECT_LT((at.H[k].R - (moved * this->body.reference[k]).R).norm(), 1e-12) << k;
  at.v.setZero();
  EXPECT_LT(this->internal(at).norm(), 1e-12 * this->body.axial_stiffness());
  auto A = this->body.stiffness();
  this->body.exact_tangent(this->model.body_state(at, 0), 0 * this->gravity, {}, nullptr, A);
  const auto& K = this->body.stiffness().sparse;
  EXPECT_LT((A.sparse - K).norm(), 1e-11 * K.norm());
  EXPECT_FALSE(this->body.fault(at.H.data()));
}

TYPED_TEST(ContinuumTest, WeighsWhatItsMeshDoes) {
  EXPECT_NEAR(this->body.total_mass(), 0.4 * 0.1 * 0.05 * 1000, 1e-12);
  State<TypeParam> rigid = this->model.initial_state();
  rigid.v.setZero();
  for (int k = 0; k < this->body.nodes(); ++k)  // all along y of the block
    rigid.v[TypeParam::dim * k + 1] = 2;
  const auto e = this->body.energy(this->model.body_state(rigid, 0), this->gravity);
  EXPECT_NEAR(e.kinetic, 0.5 * this->body.total_mass() * 4, 1e-12);
}

/// Of a step in motion and of statics, both laws, damped.
TYPED_TEST(ContinuumTest, TangentsAreExact) {
  constexpr int dim = TypeParam::dim, sd = TypeParam::space_dim;
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    const Mechanism m = driven<TypeParam>(block_of<TypeParam>(1e-4, law));
    const auto damped = Model<TypeParam>::build(m, space_of<TypeParam>(m));
    StepTangent<TypeParam> tangent(damped, options(0.02, 5e-4, 0.8, 1e-9), 30);
    tangent.expect_exact("motion");
    tangent.expect_transposed("motion");
    State<TypeParam> at = damped.initial_state();
    Random random(3);
    VectorXd h = 5e-3 * random.vector(damped.size());
    for (const int k : damped.positions()) h.segment(dim * k + sd, dim - sd).setZero();
    damped.retract(at, h);
    at.lambda = 100 * random.vector(damped.constraints());
    expect_exact_statics(damped, at, {0, 1}, "statics");
  }
}

/// A cell that is pushed through itself is named.
TYPED_TEST(ContinuumTest, NamesACellThatIsInverted) {
  State<TypeParam> at = this->model.initial_state();
  const int node = this->model.positions().front();
  at.H[node].x +=
      0.5 * (at.H[node].R * TypeParam::Tangent::Unit(0).template head<TypeParam::space_dim>());
  EXPECT_NE(this->body.fault(at.H.data()).value().what.find("of 'block' is inverted"),
            std::string::npos);
}

/// Of a cell whose law has no stress, here at a point, there are no forces; it is named.
TYPED_TEST(ContinuumTest, NamesACellWithoutStress) {
  const Mechanism m = driven<TypeParam>(block_of<TypeParam>(0, SolidLaw::NeoHookean));
  const auto neo = Model<TypeParam>::build(m, space_of<TypeParam>(m));
  State<TypeParam> at = neo.initial_state();
  EXPECT_EQ(neo.bodies[0]->no_forces(at.H.data()), "");
  for (const int k : neo.positions()) at.H[k].x = at.H[neo.positions().front()].x;
  EXPECT_NE(neo.bodies[0]->no_forces(at.H.data()).find("of 'block' has no stress"),
            std::string::npos);
}

/// Stress of Cauchy of a deformation F, Pa: F S F^T/J with S = lambda tr(E) 1 + 2 mu E, or
/// (mu (F F^T - 1) + lambda ln J 1)/J.
Mat3 cauchy_stress(const Mat3& F, SolidLaw law, const Material& m) {
  const double mu = m.G(), lambda = 2 * mu * m.nu / (1 - 2 * m.nu), J = F.determinant();
  const Mat3 one = Mat3::Identity(), E = (F.transpose() * F - one) / 2;
  if (law == SolidLaw::NeoHookean)
    return (mu * (F * F.transpose() - one) + lambda * std::log(J) * one) / J;
  return F * (lambda * E.trace() * one + 2 * mu * E) * F.transpose() / J;
}

/// With the thickness at which there is no stress across the plane.
Mat3 without_stress_across(Mat3 F, SolidLaw law, const Material& m) {
  double low = 0.5, high = 2;
  for (int i = 0; i < 60; ++i) {
    F(2, 2) = (low + high) / 2;
    (cauchy_stress(F, law, m)(2, 2) > 0 ? high : low) = F(2, 2);
  }
  return F;
}

/// Stretches in axes askew to the mesh, turned.
template <class G>
Mat3 homogeneous(const Vec3& stretches, SolidLaw law, const Material& m) {
  constexpr bool flat = G::space_dim == 2;
  const auto turn = [](double angle) {
    return SO3::exp(angle * (flat ? Vec3(0, 0, 1) : Vec3(0.6, 0, 0.8))).R;
  };
  const Mat3 F = turn(0.8) * stretches.asDiagonal() * turn(-0.3);
  return flat ? without_stress_across(F, law, m) : F;
}

/// A kind of cells, with edges bent or not.
struct PatchOf {
  int dim, nodes;
  bool bent = false;
};

class ContinuumPatch : public ::testing::TestWithParam<PatchOf> {
 protected:
  template <class G>
  static void expect_passed(const Vec3& stretches) {
    const auto [dim, nodes, bent] = GetParam();
    const SolidMesh straight = distorted(cell_kind(dim, nodes)),
                    mesh = bent ? with_bent_edges(straight) : straight;
    for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
      const Mat3 F = homogeneous<G>(stretches, law, kSoftBlock),
                 exact = cauchy_stress(F, law, kSoftBlock);
      const auto taken = [&](int i) {
        return (F * mesh.nodes.col(i)).template head<G::space_dim>();
      };
      std::vector<int> free;
      for (int i = 0; i < mesh.node_count(); ++i)
        if (inside(mesh, i)) free.push_back(i);
      ASSERT_FALSE(free.empty());
      NodalStatics<G> patch(mesh, kSoftBlock, law, 0.1, free);
      Random random(9);
      for (int i = 0; i < mesh.node_count(); ++i) patch.place(i) = taken(i);
      for (const int i : free) patch.place(i) += 0.01 * random.vector(G::space_dim);
      patch.solve(2);
      for (const int i : free) EXPECT_LT((patch.place(i) - taken(i)).norm(), 2e-12) << i;
      const Eigen::MatrixXd stress = patch.body.stresses_at(patch.places());
      double off = 0;
      for (int e = 0; e < stress.cols(); ++e)
        for (int i = 0; i < dim; ++i) {
          off = std::max(off, std::abs(stress(i, e) - exact(i, i)));
          if (i < stress.rows() - dim)
            off = std::max(off, std::abs(stress(dim + i, e) - exact(i, (i + 1) % dim)));
        }
      EXPECT_LT(off, 1e-12 * kSoftBlock.E) << to_string(law);
    }
  }
  static void expect_passed_in_its_space(const Vec3& stretches) {
    if (GetParam().dim == 2)
      expect_passed<SE2>(stretches);
    else
      expect_passed<SE3>(stretches);
  }
};

/// Patch test: an irregular mesh whose boundary follows a homogeneous deformation follows it
/// inside, with the stress of the law in all cells.
TEST_P(ContinuumPatch, IsPassedBySmallDeformations) {
  expect_passed_in_its_space({1.001, 0.9995, 1.0003});
}
TEST_P(ContinuumPatch, IsPassedByLargeDeformations) { expect_passed_in_its_space({1.5, 0.8, 1.1}); }

/// Tetrahedra of 10 nodes have a quadrature for straight edges.
INSTANTIATE_TEST_SUITE_P(Cells, ContinuumPatch,
                         ::testing::Values(PatchOf{2, 3}, PatchOf{2, 4}, PatchOf{2, 6},
                                           PatchOf{2, 8}, PatchOf{3, 4}, PatchOf{3, 8},
                                           PatchOf{3, 10}, PatchOf{3, 20}, PatchOf{2, 6, true},
                                           PatchOf{2, 8, true}, PatchOf{3, 20, true}),
                         [](const auto& info) {
                           return "Of" + std::to_string(info.param.nodes) + "NodesIn" +
                                  std::to_string(info.param.dim) + "D" +
                                  (info.param.bent ? "Bent" : "");
                         });

std::string refusal(const SolidSpec& part) {
  const Mechanism m = clamped(part);
  try {
    Model<SE2>::build(m, space_of<SE2>(m));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

/// What cannot be a continuum is refused with what would do.
TEST(Continuum, RefusesWhatItCannotBe) {
  SolidSpec part = continuum_block({0.4, 0.1, 0.05}, 4, 2, 0, kSoftBlock);
  EXPECT_EQ(refusal(part), "none");
  part = continuum_block({0.4, 0.1, 0.05}, 4, 2, 0, {"water", 1e6, 0.5, 1000});
  EXPECT_NE(refusal(part).find("is incompressible"), std::string::npos);
  SolidMesh apart = quad_grid({0, 0}, {1, 1}, 3, 1);
  apart.cells.col(1) = apart.cells.col(0);
  part.model = mesh_with_ends(apart, kSoftBlock, {0, 0.5, 0}, {1, 0.5, 0});
  EXPECT_NE(refusal(part).find("has a mesh of 2 pieces"), std::string::npos) << refusal(part);
}

/// Outlines that leave an interface bare, an island, or nothing under a force.
TEST(Continuum, RefusesOutlinesThatLeavePieces) {
  using levelset::FeatureKind;
  SolidSpec part = continuum_block({0.4, 0.1, 0.05}, 32, 8, 0, kSoftBlock);
  cut_hole(part, 0.2, 0, 0.04);
  EXPECT_EQ(refusal(part), "none");
  part.outline.features[0].values[0] = 0.3;
  EXPECT_NE(refusal(part).find("no material is left at interface 'b'"), std::string::npos);
  cut_hole(part, 0.2, 0, 0.04);
  part.outline.features.back().operands = {"plate", "gap"};
  part.outline.features.push_back({"island", FeatureKind::Circle, {0.2, 0, 0, 0.01}, {}});
  part.outline.features.push_back({"gap", FeatureKind::Difference, {}, {"hole", "island"}});
  EXPECT_NE(refusal(part).find("is cut into 2 pieces by its outline"), std::string::npos);
  cut_hole(part, 0.4, 0.05, 0.03);
  EXPECT_EQ(refusal(part), "none");
  part.model = with_ties(*part.model, Tie::Averaged);
  EXPECT_NE(refusal(part).find("averaged interface 'b' over nodes in the void"), std::string::npos);
}

}  // namespace
}  // namespace liesl::test::continuum_test
