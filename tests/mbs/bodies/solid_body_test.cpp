/// @file
/// Identities of a meshed part in a floating frame: forces are gradients, inertia is that of the
/// full mesh, rigid motions cost nothing; a bar that spins, against closed forms.

#include "mbs/bodies/solid_body.hpp"

#include <Eigen/LU>
#include <numbers>

#include "mbs/bodies/rigid.hpp"
#include "mbs/run.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test::solid_body_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using levelset::FeatureKind;

/// A bar of length 1 with a hole off its middle, in the plane or in space.
SolidSpec bar_with_hole(int dim) {
  SolidSpec s;
  s.model = test::mesh_with_ends(dim == 2 ? quad_grid({-0.1, -0.1}, {1, 0.1}, 22, 4)
                                          : hex_grid({-0.1, -0.1, -0.05}, {1, 0.1, 0.05}, 11, 4, 2),
                                 {"steel", 1e9, 0.3, 2000}, {-0.1, 0, 0}, {1, 0.02, 0}, {0.1, {}});
  s.outline = {dim,
               {{"bar", FeatureKind::HalfSpace, {2, 0, 0}, {}},
                {"hole", FeatureKind::Circle, {0.4, 0.03, 0, 0.05}, {}},
                {"all", FeatureKind::Difference, {}, {"bar", "hole"}}}};
  if (dim == 3)
    for (int i : {0, 1})
      s.outline.features[i].values.insert(s.outline.features[i].values.begin() + 3, 3, 0.);
  s.modes = 5;
  return s;
}

template <class G>
class SolidBodyTest : public ::testing::Test {
 protected:
  static constexpr int kDim = G::dim;
  using Tangent = typename G::Tangent;
  using Vector = typename Body<G>::Vector;

  SolidBodyTest() : body(make(Matrix3d::Identity())) { move(0.1); }

  std::unique_ptr<SolidBody<G>> make(const Matrix3d& turn) const {
    std::vector<G> ports;
    for (const Interface& f : spec.interfaces()) {
      const Vector3d x = turn * f.point;
      ports.push_back(place * G::exp(Tangent::Zero()));
      ports.back().x = place.x + place.R * x.head<G::space_dim>();
    }
    return std::make_unique<SolidBody<G>>("bar", spec, ports, turn);
  }
  /// A state with displacements of a size.
  void move(double size) {
    test::Random numbers{5};
    H = body->reference;
    for (auto& frame : H) frame = frame * G::exp(Tangent(size * numbers.vector(kDim)));
    v = numbers.vector(body->size());
    vdot = numbers.vector(body->size());
    w = size * numbers.vector(body->size());
    for (int k = 0; k < body->nodes(); ++k)
      if (body->kind(k) == NodeKind::Frame) w.template segment<kDim>(kDim * k).setZero();
  }
  /// A state that the body has in a rigid motion.
  void move_rigidly() {
    test::Random numbers{6};
    H[0] = body->reference[0] * G::exp(Tangent(numbers.vector(kDim)));
    v.setZero();
    vdot.setZero();
    w.setZero();
    const Tangent v0 = numbers.vector(kDim), a0 = numbers.vector(kDim);
    for (int k = 0; k < body->points(); ++k) {
      const G X = body->reference[0].inverse() * body->reference[k];
      H[k] = H[0] * X;
      v.template segment<kDim>(kDim * k) = X.AdInv() * v0;
      vdot.template segment<kDim>(kDim * k) = X.AdInv() * a0;
    }
  }
  BodyEnergy energy(double t) const {
    auto Ht = H;
    VectorXd vt = v + t * vdot, wt = w;
    for (int k = 0; k < body->nodes(); ++k) {
      const Tangent d = t * v.template segment<kDim>(kDim * k) +
                        0.5 * t * t * vdot.template segment<kDim>(kDim * k);
      if (body->kind(k) == NodeKind::Frame) Ht[k] = H[k] * G::exp(d);
      if (body->kind(k) == NodeKind::Amplitudes) wt.template segment<kDim>(kDim * k) += d;
    }
    return body->energy({Ht.data(), vt.data(), vdot.data(), wt.data()}, gravity);
  }
  BodyState<G> state() const { return {H.data(), v.data(), vdot.data(), w.data()}; }
  VectorXd inertia(const Vector& g) const {
    VectorXd r = VectorXd::Zero(body->size());
    ForceScale scale;
    body->add_inertia(state(), g, r.data(), scale);
    return r;
  }
  VectorXd internal() const {
    VectorXd r = VectorXd::Zero(body->size());
    ForceScale scale;
    body->add_internal(state(), r.data(), scale);
    return r;
  }

  SolidSpec spec = bar_with_hole(G::space_dim);
  G place = G::exp(Tangent(0.3 * Tangent::Ones()));
  Vector gravity = 3 * Vector::Ones();
  std::unique_ptr<SolidBody<G>> body;
  std::vector<G> H;
  VectorXd v, vdot, w;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(SolidBodyTest, Groups);

TYPED_TEST(SolidBodyTest, InternalForceHasThePowerOfTheElasticEnergy) {
  const double h = 1e-5, rate = (this->energy(h).elastic - this->energy(-h).elastic) / (2 * h);
  EXPECT_NEAR(this->internal().dot(this->v), rate, 1e-7 * std::abs(rate));
}

TYPED_TEST(SolidBodyTest, InertiaHasThePowerOfTheKineticEnergy) {
  const double h = 1e-5, rate = (this->energy(h).kinetic - this->energy(-h).kinetic) / (2 * h);
  EXPECT_NEAR(this->inertia(0 * this->gravity).dot(this->v), rate, 1e-7 * std::abs(rate));
}

TYPED_TEST(SolidBodyTest, WeightHasThePowerOfThePotentialEnergy) {
  const double h = 1e-5, rate = (this->energy(h).potential - this->energy(-h).potential) / (2 * h);
  const VectorXd weight = this->inertia(this->gravity) - this->inertia(0 * this->gravity);
  EXPECT_NEAR(weight.dot(this->v), rate, 1e-7 * std::abs(rate));
}

TYPED_TEST(SolidBodyTest, MatricesAreThoseOfTheForcesAtReference) {
  constexpr int dim = TypeParam::dim;
  this->H = this->body->reference;
  this->w.setZero();
  this->v.setZero();
  const auto& M = this->body->mass();
  for (std::size_t j = 0; j < M.nodes.size(); ++j)
    for (int i = 0; i < dim; ++i) {
      const int column = dim * int(j) + i;
      // Padding of the last slot has a mass for the solver only.
      if (column >= dim + dim + this->spec.modes) continue;
      this->vdot = VectorXd::Unit(this->body->size(), dim * M.nodes[j] + i);
      const VectorXd r = this->inertia(0 * this->gravity);
      for (std::size_t k = 0; k < M.nodes.size(); ++k)
        EXPECT_LT((M.dense.template block<dim, 1>(dim * int(k), column) -
                   r.template segment<dim>(dim * M.nodes[k]))
                      .norm(),
                  1e-12 * M.dense.norm());
    }
}

/// A rigid motion costs no strain; its inertia force is that of the rigid body, whose mass, centre
/// and inertia are computed from the cells.
TYPED_TEST(SolidBodyTest, ARigidMotionIsThatOfTheRigidBody) {
  using G = TypeParam;
  constexpr int dim = G::dim, sd = G::space_dim;
  this->move_rigidly();
  EXPECT_LT(this->internal().norm(), 1e-12 * this->body->stiffness().dense.norm());
  const SolidModel& model = *this->spec.model;
  const VectorXd fraction = solid_fractions(this->spec).value;
  double mass = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (int e = 0; e < model.mesh().cell_count(); ++e) {  // cells are boxes
    const Eigen::Matrix3Xd x = model.mesh().corners_of(e);
    const Vector3d centre = x.rowwise().mean() - this->spec.interfaces()[0].point;
    const Vector3d half = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()) / 2;
    const double m = fraction[e] * model.cell_masses()[e];
    mass += m;
    first += m * centre;
    second += m * centre * centre.transpose();
    second.diagonal() += m / 3 * half.cwiseAbs2();
  }
  typename G::Matrix inertia;
  if constexpr (sd == 3) {
    const Matrix3d S = hat(first);
    inertia << mass * Matrix3d::Identity(), -S, S, second.trace() * Matrix3d::Identity() - second;
  } else {
    inertia << mass, 0, -first[1], 0, mass, first[0], -first[1], first[0], second.trace();
  }
  const Rigid<G> rigid("bar", this->body->reference[0], inertia);
  typename G::Tangent expected = G::Tangent::Zero(), found = expected;
  ForceScale scale;
  rigid.add_inertia(this->state(), this->gravity, expected.data(), scale);
  const VectorXd r = this->inertia(this->gravity);
  for (int k = 0; k < this->body->points(); ++k) {
    const G X = this->body->reference[0].inverse() * this->body->reference[k];
    found += X.AdInv().transpose() * r.template segment<dim>(dim * k);
  }
  EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm());
  EXPECT_NEAR(this->body->total_mass(), mass, 1e-12 * mass);
  const auto whole = rigid.energy(this->state(), this->gravity),
             energy = this->body->energy(this->state(), this->gravity);
  EXPECT_NEAR(energy.kinetic, whole.kinetic, 1e-10 * whole.kinetic);
  EXPECT_NEAR(energy.potential, whole.potential, 1e-10 * std::abs(whole.potential));
  EXPECT_LT(energy.elastic, 1e-12 * whole.kinetic);
  // The same as made rigid by itself.
  const Rigid<G> made("bar", std::shared_ptr<const Body<G>>(std::move(this->body)));
  typename G::Tangent by_itself = G::Tangent::Zero();
  made.add_inertia(this->state(), this->gravity, by_itself.data(), scale);
  EXPECT_LT((by_itself - expected).norm(), 1e-10 * expected.norm());
}

/// Second algorithm: accelerations of all nodes of the mesh, times the consistent mass matrix,
/// projected on the modes and on the rigid motions of the deformed mesh.
TYPED_TEST(SolidBodyTest, InertiaIsThatOfTheNodesOfTheMesh) {
  using G = TypeParam;
  constexpr int dim = G::dim, sd = G::space_dim;
  // One interface: e is eta alone, and the forces on its slots are those on the modes.
  const SolidModel& both = *this->spec.model;
  this->spec.model = std::make_shared<const SolidModel>(
      both.mesh(), both.material(), std::vector{both.interfaces()[0]},
      SolidModel::Options{both.thickness(), both.law()});
  this->body = this->make(Matrix3d::Identity());
  this->move(0.1);
  const int n = this->spec.modes;
  const VectorXd e = this->w.segment(dim, n), de = this->v.segment(dim, n),
                 dde = this->vdot.segment(dim, n);
  const SolidModel& model = *this->spec.model;
  const VectorXd fraction = solid_fractions(this->spec).value;
  const Eigen::MatrixXd phi = model.T() * this->body->basis();
  const VectorXd u = phi * e, du = phi * de, ddu = phi * dde;
  Vector3d v0 = Vector3d::Zero(), a0 = v0, omega = v0, alpha = v0;
  v0.head<sd>() = this->v.template head<sd>();
  a0.head<sd>() = this->vdot.template head<sd>() - this->H[0].R.transpose() * this->gravity;
  omega.tail<G::rotation_dim>() = this->v.template segment<G::rotation_dim>(sd);
  alpha.tail<G::rotation_dim>() = this->vdot.template segment<G::rotation_dim>(sd);
  VectorXd a(model.node_freedoms()), r(model.node_freedoms());
  for (int i = 0; i < model.mesh().node_count(); ++i) {
    Vector3d x = model.mesh().nodes.col(i) - this->spec.interfaces()[0].point,
             rate = Vector3d::Zero(), fast = rate;
    x.head<sd>() += u.segment<sd>(sd * i);
    rate.head<sd>() = du.segment<sd>(sd * i);
    fast.head<sd>() = ddu.segment<sd>(sd * i);
    const Vector3d all = a0 + omega.cross(v0) + alpha.cross(x) + omega.cross(omega.cross(x)) +
                         2 * omega.cross(rate) + fast;
    a.segment<sd>(sd * i) = all.head<sd>();
    r.segment<sd>(sd * i) = x.head<sd>();
  }
  VectorXd f = VectorXd::Zero(a.size());
  const int corners = model.mesh().corners();
  for (int c = 0; c < model.mesh().cell_count(); ++c) {
    VectorXd local(sd * corners);
    for (int k = 0; k < corners; ++k)
      local.segment<sd>(sd * k) = a.segment<sd>(model.freedom(c, k));
    const VectorXd force = fraction[c] * (model.cell_mass(c) * local);
    for (int k = 0; k < corners; ++k)
      f.segment<sd>(model.freedom(c, k)) += force.segment<sd>(sd * k);
  }
  typename G::Tangent on_frame = G::Tangent::Zero();
  for (int i = 0; i < model.mesh().node_count(); ++i) {
    Vector3d x = Vector3d::Zero(), force = x;
    x.head<sd>() = r.segment<sd>(sd * i);
    force.head<sd>() = f.segment<sd>(sd * i);
    on_frame.template head<sd>() += force.head<sd>();
    on_frame.template tail<G::rotation_dim>() += x.cross(force).template tail<G::rotation_dim>();
  }
  const VectorXd found = this->inertia(this->gravity), modal = phi.transpose() * f;
  EXPECT_LT((found.template head<dim>() - on_frame).norm(), 1e-10 * on_frame.norm());
  EXPECT_LT((found.segment(dim, n) - modal).norm(), 1e-10 * modal.norm());
}

/// Mesh axes that are turned against those of the frames make the same body.
TYPED_TEST(SolidBodyTest, TurnedMeshesAreTheSameBody) {
  using G = TypeParam;
  constexpr int dim = G::dim;
  const Matrix3d turn = Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()).toRotationMatrix();
  const auto other = this->make(turn);  // its ports are the mirror image in y (and z)
  typename G::Matrix A = G::Matrix::Identity();
  A(1, 1) = -1;
  if (dim == 3) A(2, 2) = -1;
  if constexpr (dim == 6) A.diagonal() << 1, -1, -1, 1, -1, -1;
  const Eigen::MatrixXd &M = this->body->mass().dense, &N = other->mass().dense;
  const Eigen::MatrixXd &K = this->body->stiffness().dense, &L = other->stiffness().dense;
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(M.rows(), M.cols());
  T.topLeftCorner(dim, dim) = T.block(dim, dim, dim, dim) = A;
  EXPECT_LT((T.transpose() * N * T - M).norm(), 1e-9 * M.norm());
  EXPECT_LT((T.transpose() * L * T - K).norm(), 1e-9 * K.norm());
}

/// Holds the first interface and turns it at omega: displacements e at which nothing accelerates.
VectorXd steady(const SolidBody<SE2>& body, double omega) {
  const int n = body.size() - 3;
  std::vector<SE2> H(body.reference);
  const VectorXd rest = VectorXd::Zero(body.size());
  const auto residual = [&](const VectorXd& e) {
    VectorXd v = rest, w = rest, r = rest;
    for (int k = 0; k < body.points(); ++k) {
      const SE2 X = body.reference[0].inverse() * body.reference[k];
      if (k > 0) H[k] = H[0] * X * SE2::exp(SE2::Tangent(e.segment<3>(3 * (k - 1))));
      v.segment<3>(3 * k) = (H[0].inverse() * H[k]).AdInv() * SE2::Tangent(0, 0, omega);
    }
    w.tail(n) = e;
    ForceScale scale;
    const BodyState<SE2> s{H.data(), v.data(), rest.data(), w.data()};
    body.add_inertia(s, Eigen::Vector2d::Zero(), r.data(), scale);
    body.add_internal(s, r.data(), scale);
    return VectorXd(r.tail(n));
  };
  VectorXd e = VectorXd::Zero(n);
  for (int i = 0; i < 6; ++i) {
    Eigen::MatrixXd J(n, n);
    const double h = 1e-6;
    for (int j = 0; j < n; ++j)
      J.col(j) = (residual(e + h * VectorXd::Unit(n, j)) - residual(e - h * VectorXd::Unit(n, j))) /
                 (2 * h);
    for (int j = 0; j < n; ++j)
      if (J.col(j).norm() == 0) J(j, j) = 1;  // padding
    e -= J.partialPivLu().solve(residual(e));
  }
  return e;
}

/// EA u'' + rho A omega^2 (x + u) = 0, u(0) = 0, u'(L) = 0: u(L) = L (tan(k)/k - 1), k = omega L
/// sqrt(rho/E).
TEST(SolidBody, ASpinningBarGrowsAsTheClosedFormSays) {
  SolidSpec bar = bar_with_hole(2);
  const Material material{"steel", 1e9, 0, 2000};
  bar.model = test::mesh_with_ends(quad_grid({0, -0.02}, {1, 0.02}, 50, 2), material, Vec3::Zero(),
                                   {1, 0, 0}, {0.1, {}});
  bar.outline.features.clear();
  SE2 tip = SE2::identity();
  tip.x = {1, 0};
  const double c = std::sqrt(material.E / material.rho);
  double before = 0;
  for (int modes : {12, 24}) {  // the axial ones among them
    bar.modes = modes;
    const SolidBody<SE2> body("bar", bar, {SE2::identity(), tip}, Matrix3d::Identity());
    for (double k : {0.05, 0.3}) {
      const double exact = std::tan(k) / k - 1;
      const double off = steady(body, k * c)[0] / exact - 1;
      EXPECT_NEAR(off, 0, modes == 12 ? 2e-3 : 1e-3) << modes << ' ' << k;
      before = off;
    }
  }
  EXPECT_LT(std::abs(before), 1e-3);
}

}  // namespace
}  // namespace liesl::test::solid_body_test
