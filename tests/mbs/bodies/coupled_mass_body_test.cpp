/// @file
/// Parts whose mass couples components, or nodes with rotations: identities of their inertia, the
/// body of the mesh that they are condensed from, and the integrals where nothing is coupled.

#include "mbs/bodies/coupled_mass_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "mbs/bodies/rigid.hpp"
#include "mbs/run.hpp"
#include "mbs/solids/reduction.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test::coupled_mass_body_test {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

const Material kRubber{"rubber", 1e8, 0.3, 2000};

MeshModel meshed_bar(int dim) {
  return mesh_with_ends(dim == 2 ? quad_grid({-0.1, -0.1}, {1, 0.1}, 12, 4)
                                 : hex_grid({-0.1, -0.1, -0.05}, {1, 0.1, 0.05}, 8, 2, 2),
                        kRubber, {-0.1, 0, 0}, {1, 0.02, 0}, {0.1, {}});
}

/// K and M of the free mesh.
NodalMatrices free_matrices(const SolidModel& m) {
  const SolidModel free(m.mesh(), m.material(), {}, {m.thickness(), m.law()});
  const VectorXd v = VectorXd::Ones(m.mesh().cell_count());
  return {free.stiffness(v).selfadjointView<Eigen::Lower>(),
          free.mass(v).selfadjointView<Eigen::Lower>()};
}

SolidMesh nodes_alone(int dim, const Eigen::Matrix3Xd& nodes) { return {dim, nodes, {}, {}}; }

/// Statically condensed to its ends and every seventh node: components are coupled.
MeshModel condensed_to_nodes(const SolidModel& mesh) {
  const int dim = mesh.mesh().dim;
  const NodalMatrices all = free_matrices(mesh);
  std::vector<int> kept, rest, freedoms;
  std::vector<Interface> interfaces = mesh.interfaces();
  for (Interface& f : interfaces) f.nodes.clear();
  Eigen::Matrix3Xd nodes(3, mesh.mesh().node_count());
  for (int i = 0; i < mesh.mesh().node_count(); ++i) {
    const Vector3d x = mesh.mesh().nodes.col(i);
    const bool left = x[0]<-0.0999, right = x[0]> 0.999, inner = i % 7 == 1;
    for (int a = 0; a < dim; ++a) (left || right || inner ? freedoms : rest).push_back(dim * i + a);
    if (!(left || right || inner)) continue;
    if (left || right) interfaces[right].nodes.push_back(static_cast<int>(kept.size()));
    nodes.col(static_cast<Eigen::Index>(kept.size())) = x;
    kept.push_back(i);
  }
  const MatrixXd K = all.K, M = all.M;
  MatrixXd G = MatrixXd::Zero(K.rows(), static_cast<Eigen::Index>(freedoms.size()));
  G(freedoms, Eigen::all).setIdentity();
  G(rest, Eigen::all) = -MatrixXd(K(rest, rest)).ldlt().solve(MatrixXd(K(rest, freedoms)));
  const MatrixXd Kc = G.transpose() * K * G, Mc = G.transpose() * M * G;
  const NodalMatrices matrices = {Sparse((0.5 * (Kc + Kc.transpose())).sparseView()),
                                  Sparse((0.5 * (Mc + Mc.transpose())).sparseView())};
  return std::make_shared<const SolidModel>(
      nodes_alone(dim, nodes.leftCols(static_cast<Eigen::Index>(kept.size()))), matrices,
      interfaces);
}

/// Reduced to its two ports, nodes with rotations.
MeshModel condensed_to_ports(const SolidModel& mesh) {
  const ReducedSolid r =
      reduce(mesh, VectorXd::Ones(mesh.mesh().cell_count()), ReductionKind::CraigBampton, 0);
  std::vector<Interface> interfaces = mesh.interfaces();
  Eigen::Matrix3Xd nodes(3, 2);
  for (int k = 0; k < 2; ++k) {
    nodes.col(k) = interfaces[std::size_t(k)].point;
    interfaces[std::size_t(k)].nodes = {k};
  }
  return std::make_shared<const SolidModel>(nodes_alone(mesh.mesh().dim, nodes),
                                            NodalMatrices{r.K.sparseView(), r.M.sparseView()},
                                            interfaces);
}

enum class Condensed { Nodes, Ports };
template <class Group, Condensed kTo>
struct Kind {
  using G = Group;
  static constexpr Condensed to = kTo;
};

template <class K>
class CoupledMassTest : public ::testing::Test {
 protected:
  using G = typename K::G;
  static constexpr int dim = G::dim, sd = G::space_dim;
  using Tangent = typename G::Tangent;
  using Vector = typename Body<G>::Vector;

  CoupledMassTest() {
    spec.model = K::to == Condensed::Nodes ? condensed_to_nodes(*mesh) : condensed_to_ports(*mesh);
    spec.modes = K::to == Condensed::Nodes ? 4 : 0;
    body = make<CoupledMassBody<G>>(spec, Matrix3d::Identity());
    move(0.05);
  }
  template <class Kind>
  std::unique_ptr<Kind> make(const SolidSpec& of, const Matrix3d& turn) const {
    std::vector<G> ports;
    for (const Interface& f : of.interfaces()) {
      const Vector3d x = turn * f.point;
      ports.push_back(place);
      ports.back().x = place.x + place.R * x.head<sd>();
    }
    return std::make_unique<Kind>("bar", of, ports, turn);
  }
  void move(double size) {
    Random numbers{5};
    H = body->reference;
    for (auto& frame : H) frame = frame * G::exp(Tangent(size * numbers.vector(dim)));
    v = numbers.vector(body->size());
    vdot = numbers.vector(body->size());
    w = size * numbers.vector(body->size());
  }
  /// The state after the frames, amplitudes and velocities have changed.
  template <class F>
  auto changed(const VectorXd& by, const VectorXd& dv, const VectorXd& da, const F& f) const {
    auto Ht = H;
    VectorXd vt = v + dv, at = vdot + da, wt = w;
    for (int k = 0; k < body->nodes(); ++k) {
      const Tangent d = by.template segment<dim>(dim * k);
      if (body->kind(k) == NodeKind::Frame) Ht[k] = H[k] * G::exp(d);
      if (body->kind(k) == NodeKind::Amplitudes) wt.template segment<dim>(dim * k) += d;
    }
    return f(BodyState<G>{Ht.data(), vt.data(), at.data(), wt.data()});
  }
  VectorXd force(const BodyState<G>& s, const Vector& g) const {
    VectorXd r = VectorXd::Zero(body->size());
    ForceScale scale;
    body->add_inertia(s, g, r.data(), scale);
    return r;
  }
  BodyState<G> state() const { return {H.data(), v.data(), vdot.data(), w.data()}; }
  /// Slope of f along changes of the three.
  template <class F>
  auto slope(const VectorXd& by, const VectorXd& dv, const VectorXd& da, const F& f) const {
    const double h = 1e-5;
    using Value = std::decay_t<decltype(f(state()))>;
    return Value((changed(h * by, h * dv, h * da, f) - changed(-h * by, -h * dv, -h * da, f)) /
                 (2 * h));
  }

  MeshModel mesh = meshed_bar(G::space_dim);
  SolidSpec spec;
  G place = G::exp(Tangent(0.3 * Tangent::Ones()));
  Vector gravity = 3 * Vector::Ones();
  std::unique_ptr<CoupledMassBody<G>> body;
  std::vector<G> H;
  VectorXd v, vdot, w;
};

using Kinds = ::testing::Types<Kind<SE2, Condensed::Nodes>, Kind<SE3, Condensed::Nodes>,
                               Kind<SE2, Condensed::Ports>, Kind<SE3, Condensed::Ports>>;
TYPED_TEST_SUITE(CoupledMassTest, Kinds);

TYPED_TEST(CoupledMassTest, InertiaAndWeightHaveThePowerOfTheirEnergies) {
  const VectorXd& v = this->v;
  const auto rate = [&](auto of) {
    return this->slope(v, this->vdot, 0 * v, [&](const auto& s) {
      return Eigen::Matrix<double, 1, 1>(of(this->body->energy(s, this->gravity)));
    })[0];
  };
  const double kinetic = rate([](const BodyEnergy&e) { return e.kinetic; }),
               potential = rate([](const BodyEnergy&e) { return e.potential; });
  const VectorXd inertia = this->force(this->state(), 0 * this->gravity),
                 weight = this->force(this->state(), this->gravity) - inertia;
  EXPECT_NEAR(inertia.dot(v), kinetic, 1e-7 * std::abs(kinetic));
  EXPECT_NEAR(weight.dot(v), potential, 1e-7 * std::abs(potential));
}

TYPED_TEST(CoupledMassTest, TangentsAndEnergyGradientsAreThoseOfDifferences) {
  using G = typename TestFixture::G;
  typename Body<G>::Matrices K = this->body->stiffness(), C = K, M = K;
  this->body->exact_tangents(this->state(), this->gravity, nullptr, K, C, M);
  const int size = this->body->size();
  const VectorXd none = VectorXd::Zero(size);
  const auto inertia = [&](const BodyState<G>& s) { return this->force(s, this->gravity); };
  const auto force = [&](const BodyState<G>& s) {
    VectorXd r = inertia(s);
    ForceScale scale;
    this->body->add_internal(s, r.data(), scale);
    return r;
  };
  VectorXd by_h = none, by_v = none;
  const BodyEnergy weight{0.7, 1.3, 0.4};
  this->body->add_energy_gradient(this->state(), this->gravity, weight, by_h.data(), by_v.data());
  const auto energy = [&](const BodyState<G>& s) {
    const BodyEnergy e = this->body->energy(s, this->gravity);
    return Eigen::Matrix<double, 1, 1>(weight.kinetic * e.kinetic + weight.elastic * e.elastic +
                                       weight.potential * e.potential);
  };
  Random numbers{9};
  const auto times = [&](const typename Body<G>::Matrices& A, const VectorXd& d) {
    VectorXd chosen(A.dense.cols()), out = none;
    constexpr int dim = G::dim;
    for (std::size_t k = 0; k < A.nodes.size(); ++k)
      chosen.segment<dim>(dim * int(k)) = d.segment<dim>(dim * A.nodes[k]);
    const VectorXd r = A.dense * chosen;
    for (std::size_t k = 0; k < A.nodes.size(); ++k)
      out.segment<dim>(dim * A.nodes[k]) = r.segment<dim>(dim * int(k));
    return out;
  };
  for (int i = 0; i < 3; ++i) {
    VectorXd d = numbers.vector(size);
    d.tail(this->body->padding()).setZero();
    const VectorXd of_h = this->slope(d, none, none, force),
                   of_v = this->slope(none, d, none, inertia),
                   of_a = this->slope(none, none, d, inertia);
    EXPECT_LT((times(K, d) - of_h).norm(), 1e-7 * of_h.norm());
    EXPECT_LT((times(C, d) - of_v).norm(), 1e-8 * of_v.norm());
    EXPECT_LT((times(M, d) - of_a).norm(), 1e-8 * of_a.norm());
    const double e_h = this->slope(d, none, none, energy)[0],
                 e_v = this->slope(none, d, none, energy)[0];
    EXPECT_NEAR(by_h.dot(d), e_h, 1e-6 * by_h.norm() * d.norm());
    EXPECT_NEAR(by_v.dot(d), e_v, 1e-6 * by_v.norm() * d.norm());
  }
}

/// Who moves at a constant velocity beside the part finds the same forces.
TYPED_TEST(CoupledMassTest, AUniformVelocityChangesNoForce) {
  using G = typename TestFixture::G;
  constexpr int dim = G::dim, sd = G::space_dim;
  const VectorXd before = this->force(this->state(), this->gravity);
  for (int k = 0; k < this->body->points(); ++k) {
    const typename TestFixture::Vector V =
        this->H[std::size_t(k)].R.transpose() * (4 * this->gravity);
    typename G::Tangent boost = G::Tangent::Zero();
    boost.template head<sd>() = V;
    const typename G::Tangent v = this->v.template segment<dim>(dim * k);
    this->v.template segment<dim>(dim * k) += boost;
    // V is constant in space: its components in the axes of the node turn by -omega x V.
    typename G::Tangent turning = v;
    turning.template head<sd>().setZero();
    this->vdot.template segment<dim>(dim * k) -= G::ad(turning) * boost;
  }
  EXPECT_LT((this->force(this->state(), this->gravity) - before).norm(), 1e-11 * before.norm());
}

/// Constant matrices, weight and rigid motions are those of the mesh it is condensed from.
TYPED_TEST(CoupledMassTest, AtReferenceItIsTheMeshItIsCondensedFrom) {
  using G = typename TestFixture::G;
  constexpr int dim = G::dim;
  SolidSpec whole;
  whole.model = this->mesh;
  whole.modes = 0;
  SolidSpec own = this->spec;
  own.modes = 0;
  const Matrix3d turn = dim == 3 ? Matrix3d(Eigen::DiagonalMatrix<double, 3>(-1, -1, 1))
                                 : Matrix3d(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  const auto mesh = this->template make<SolidBody<G>>(whole, turn);
  const auto body = this->template make<CoupledMassBody<G>>(own, turn);
  const MatrixXd &M = mesh->mass().dense, &K = mesh->stiffness().dense;
  EXPECT_LT((body->mass().dense - M).norm(), 1e-9 * M.norm());
  EXPECT_LT((body->stiffness().dense - K).norm(), 1e-9 * K.norm());
  EXPECT_NEAR(body->total_mass(), mesh->total_mass(), 1e-10 * mesh->total_mass());
  Random numbers{3};
  std::vector<G> at = mesh->reference;
  VectorXd v(2 * dim), a(2 * dim), w = VectorXd::Zero(2 * dim), r = w, s = w;
  at[0] = at[0] * G::exp(typename G::Tangent(numbers.vector(dim)));
  const typename G::Tangent v0 = numbers.vector(dim), a0 = numbers.vector(dim);
  for (int k = 0; k < 2; ++k) {
    const G X = mesh->reference[0].inverse() * mesh->reference[std::size_t(k)];
    at[std::size_t(k)] = at[0] * X;
    v.template segment<dim>(dim * k) = X.AdInv() * v0;
    a.template segment<dim>(dim * k) = X.AdInv() * a0;
  }
  ForceScale scale;
  const BodyState<G> state{at.data(), v.data(), a.data(), w.data()};
  body->add_inertia(state, this->gravity, r.data(), scale);
  mesh->add_inertia(state, this->gravity, s.data(), scale);
  const G X = mesh->reference[0].inverse() * mesh->reference[1];
  const auto on_frame = [&](const VectorXd& f) {
    return typename G::Tangent(f.template head<dim>() +
                               X.AdInv().transpose() * f.template tail<dim>());
  };
  EXPECT_LT((on_frame(r) - on_frame(s)).norm(), 1e-9 * on_frame(s).norm());
}

/// Without coupling all of it is that of the integrals: a mass that couples by 1e-8.
template <class G>
void expect_the_integrals() {
  constexpr int dim = G::dim;
  const MeshModel mesh = meshed_bar(G::space_dim);
  NodalMatrices near = free_matrices(*mesh);
  const NodalMatrices given = near;
  // An elastic shape has no share in rigid motions: K u is one.
  const Eigen::Index size = near.K.rows();
  VectorXd shape = near.K * Random{2}.vector(int(size));
  shape *= std::sqrt(1e-8 * MatrixXd(near.M).diagonal().maxCoeff()) / shape.cwiseAbs().maxCoeff();
  near.M = Sparse((MatrixXd(near.M) + shape * shape.transpose()).sparseView());
  SolidSpec own, coupled;
  own.modes = coupled.modes = 4;
  own.model = std::make_shared<const SolidModel>(nodes_alone(G::space_dim, mesh->mesh().nodes),
                                                 given, mesh->interfaces());
  coupled.model = std::make_shared<const SolidModel>(nodes_alone(G::space_dim, mesh->mesh().nodes),
                                                     near, mesh->interfaces());
  ASSERT_FALSE(own.model->coupled_mass());
  ASSERT_TRUE(coupled.model->coupled_mass());
  std::vector<G> ports(2, G::identity());
  for (int k = 0; k < 2; ++k)
    ports[std::size_t(k)].x =
        mesh->interfaces()[std::size_t(k)].point.template head<G::space_dim>();
  const SolidBody<G> solid("bar", own, ports, Matrix3d::Identity());
  const CoupledMassBody<G> body("bar", coupled, ports, Matrix3d::Identity());
  Random numbers{5};
  std::vector<G> H = body.reference;
  for (auto& frame : H) frame = frame * G::exp(typename G::Tangent(0.05 * numbers.vector(dim)));
  const VectorXd v = numbers.vector(body.size()), a = numbers.vector(body.size()),
                 w = 0.05 * numbers.vector(body.size());
  const BodyState<G> s{H.data(), v.data(), a.data(), w.data()};
  const typename Body<G>::Vector gravity = Body<G>::Vector::Constant(3);
  typename Body<G>::Matrices A[3], B[3];
  solid.exact_tangents(s, gravity, nullptr, A[0], A[1], A[2]);
  body.exact_tangents(s, gravity, nullptr, B[0], B[1], B[2]);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT((A[i].dense - B[i].dense).norm(), 1e-6 * A[i].dense.norm()) << i;
  VectorXd r = VectorXd::Zero(body.size()), q = r;
  ForceScale scale;
  solid.add_inertia(s, gravity, r.data(), scale);
  body.add_inertia(s, gravity, q.data(), scale);
  EXPECT_LT((q - r).norm(), 1e-6 * r.norm());
  EXPECT_NEAR(body.energy(s, gravity).kinetic / solid.energy(s, gravity).kinetic, 1, 1e-6);
}

TEST(CoupledMass, WithoutCouplingItIsThatOfTheIntegrals) {
  expect_the_integrals<SE2>();
  expect_the_integrals<SE3>();
}

TEST(CoupledMass, MatricesHaveNoParameters) {
  SolidSpec spec;
  spec.model = condensed_to_ports(*meshed_bar(2));
  spec.modes = 0;
  const CoupledMassBody<SE2> body("bar", spec, {SE2::identity(), SE2::identity()},
                                  Matrix3d::Identity());
  EXPECT_THROW(body.derivative(ScaleDerivative{}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::coupled_mass_body_test
