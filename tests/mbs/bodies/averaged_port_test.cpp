/// @file
/// Ports of meshed parts in full motion that move as their nodes do on average: power, balance,
/// tangents; faces that stay free to deform; the reduced part with the same interface.

#include "mbs/bodies/averaged_port.hpp"

#include "mbs/bodies/continuum.hpp"
#include "mbs/run.hpp"
#include "mbs/solids/meshes.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/step_tangent.hpp"
#include "reference/continuum.hpp"
#include "reference/ties.hpp"

namespace liesl::test::averaged_port_test {
namespace {

using Eigen::VectorXd;

const Material kFoam = {"foam", 2e6, 0.3, 1000};
constexpr double kLong = 0.4, kHigh = 0.1, kFoamThickness = 0.05;
constexpr double kNodeStiffness = 100;  // of a node of an averaged interface, of E times thickness

SolidSpec foam(int nx, int ny, int nz, Tie tie, const Material& material = kFoam) {
  SolidSpec s = continuum_block({kLong, kHigh, kFoamThickness}, nx, ny, nz, material);
  s.model = with_ties(*s.model, tie);
  return s;
}

template <class G>
Mechanism driven_foam() {
  const bool space = G::space_dim == 3;
  Mechanism m;
  SolidSpec part = space ? foam(3, 1, 1, Tie::Averaged) : foam(4, 2, 0, Tie::Averaged);
  part.damping = 1e-4;
  part.frame = SE3(SO3::exp({0, 0, 0.4}).R, {0.1, 0.2, 0});
  m.bodies = {{"part", part}};
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}}};
  m.drives = {{0, 0, TimeFunction::rate(30, 0.02)}};
  m.gravity = {1, -9.81, space ? 2.0 : 0.0};
  LoadSpec push;
  push.name = "push";
  push.port = {0, 1};
  push.force = {40, -60, space ? 25.0 : 0.0};
  m.loads = {push};
  return m;
}

/// Away from rest, all nodes in motion.
template <class G>
class AveragedPortTest : public ::testing::Test {
 protected:
  AveragedPortTest()
      : model(Model<G>::build(driven_foam<G>(), space_of<G>(driven_foam<G>()))),
        body(*model.bodies[0]) {
    Random random(7);
    s = model.initial_state();
    VectorXd h = 0.01 * random.vector(model.size());
    s.v = random.vector(model.size());
    s.vdot = random.vector(model.size());
    for (const int k : model.positions())
      for (auto* x : {&h, &s.v, &s.vdot})
        x->template segment<G::rotation_dim>(G::dim * k + G::space_dim).setZero();
    model.retract(s, h);
  }
  VectorXd forces(bool inertia) const {
    VectorXd r = VectorXd::Zero(body.size()), still = r;
    ForceScale scale;
    BodyState<G> at = model.body_state(s, 0);
    if (inertia)
      body.add_inertia(at, model.gravity, r.data(), scale);
    else {
      at.v = still.data();  // without damping
      body.add_internal(at, r.data(), scale);
    }
    return r;
  }
  BodyEnergy energy(double t) const {
    State<G> at = s;
    model.retract(at, t * s.v + 0.5 * t * t * s.vdot);
    at.v += t * s.vdot;
    return body.energy(model.body_state(at, 0), model.gravity);
  }

  Model<G> model;
  const Body<G>& body;
  State<G> s;
};

using PlaneAndSpace = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(AveragedPortTest, PlaneAndSpace);

TYPED_TEST(AveragedPortTest, ForcesHaveThePowerOfTheEnergies) {
  const double h = 2e-6;
  const BodyEnergy up = this->energy(h), down = this->energy(-h);
  const double elastic = (up.elastic - down.elastic) / (2 * h),
               kinetic = (up.kinetic - down.kinetic) / (2 * h),
               potential = (up.potential - down.potential) / (2 * h);
  EXPECT_NEAR(this->forces(false).dot(this->s.v), elastic, 1e-7 * std::abs(elastic));
  EXPECT_NEAR(this->forces(true).dot(this->s.v), kinetic + potential,
              1e-7 * (std::abs(kinetic) + std::abs(potential)));
}

/// Elastic forces of the whole do no work along a rigid motion, whatever the shape: force and
/// moment on the port are those on its nodes.
TYPED_TEST(AveragedPortTest, ForcesAndMomentsBalance) {
  using G = TypeParam;
  constexpr int sd = G::space_dim;
  const VectorXd r = this->forces(false);
  for (int j = 0; j < G::dim; ++j) {
    VectorXd along = VectorXd::Zero(r.size());
    for (int k = 0; k < this->body.nodes(); ++k) {
      const typename G::Tangent x = this->s.H[k].AdInv() * G::Tangent::Unit(j);
      const int of = this->body.kind(k) == NodeKind::Frame ? G::dim : sd;
      along.segment(G::dim * k, of) = x.head(of);
    }
    EXPECT_LT(std::abs(r.dot(along)), 1e-12 * r.norm() * along.norm()) << j;
  }
}

TYPED_TEST(AveragedPortTest, TangentsAreExact) {
  constexpr int dim = TypeParam::dim, sd = TypeParam::space_dim;
  StepTangent<TypeParam> tangent(this->model, options(0.02, 5e-4, 0.8, 1e-9), 30);
  tangent.expect_exact("motion");
  tangent.expect_transposed("motion");
  State<TypeParam> at = this->model.initial_state();
  Random random(3);
  VectorXd h = 5e-3 * random.vector(this->model.size());
  for (const int k : this->model.positions()) h.segment(dim * k + sd, dim - sd).setZero();
  this->model.retract(at, h);
  at.lambda = 100 * random.vector(this->model.constraints());
  expect_exact_statics(this->model, at, {0, 1}, "statics");
}

/// Ports and nodes alike, so that nothing is strained.
TYPED_TEST(AveragedPortTest, FallAsAllElse) {
  using G = TypeParam;
  Mechanism m = driven_foam<G>();
  m.joints.clear();
  m.drives.clear();
  m.loads.clear();
  const double t = 0.02;
  const auto model = Model<G>::build(m, space_of<G>(m));
  const auto result = simulate(model, options(t, 1e-3, 0.8, 1e-9));
  ASSERT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
  const auto& all = result.trajectory;
  for (int k = 0; k < model.nodes(); ++k) {
    const auto fallen = (all.frames(all.size() - 1)[k].x - all.frames(0)[k].x).eval();
    EXPECT_LT((fallen - 0.5 * t * t * model.gravity).norm(), 1e-9 * fallen.norm()) << k;
  }
}

/// A port that moves alone, its nodes at rest: V = n k d^2/2 of a displacement, T = m u^2/2.
template <class G>
std::pair<double, double> stiffness_and_mass(const SolidSpec& part, int port) {
  const Mechanism m = clamped(part);
  const auto model = Model<G>::build(m, space_of<G>(m));
  State<G> s = model.initial_state();
  const double d = 1e-4;
  VectorXd h = VectorXd::Zero(model.size());
  h[G::dim * port] = d;
  model.retract(s, h);
  s.v[G::dim * port] = 1;
  const BodyEnergy e = model.bodies[0]->energy(model.body_state(s, 0),
                                               G::Tangent::Zero().template head<G::space_dim>());
  const double n =
      static_cast<double>(part.interfaces()[static_cast<std::size_t>(port)].nodes.size());
  return {2 * e.elastic / (n * d * d), 2 * e.kinetic};
}

/// Of the cells that touch the interface, whatever those elsewhere are like.
TEST(AveragedPorts, AreAsStiffAsTheCellsAtThem) {
  SolidSpec part = foam(4, 1, 1, Tie::Averaged);
  SolidMesh mesh = part.mesh();
  mesh.nodes.row(0) = mesh.nodes.row(0).array().square() / kLong;  // 25 to 175 mm long
  part.model =
      std::make_shared<const SolidModel>(mesh, kFoam, part.interfaces(), SolidModel::Options{});
  for (const int port : {0, 1}) {
    const double size = std::cbrt((port ? 7 : 1) * kLong / 16 * kHigh * kFoamThickness);
    EXPECT_NEAR(stiffness_and_mass<SE3>(part, port).first / (kNodeStiffness * kFoam.E * size), 1,
                1e-6);
  }
}

/// Corners of quadratic cells have no mass of their own, or less than none: that of the part,
/// spread.
TEST(AveragedPorts, AtCornersOfQuadraticCellsHaveMass) {
  for (const bool triangles : {false, true}) {
    SolidSpec part = foam(3, 1, 0, Tie::Averaged);
    SolidMesh mesh = of_order_two(triangles ? split(part.mesh()) : part.mesh());
    part.model = std::make_shared<const SolidModel>(
        mesh, kFoam, part.interfaces(), SolidModel::Options{kFoamThickness, part.model->law()});
    const double all = kFoam.rho * kLong * kHigh * kFoamThickness,
                 share = 2.0 / mesh.node_count();  // both nodes of the interface
    EXPECT_NEAR(stiffness_and_mass<SE2>(part, 1).second / (1e-3 * share * all), 1, 1e-9)
        << (triangles ? "triangles" : "quadrilaterals");
  }
}

LoadSpec pull_of(const Vec3& force) {
  LoadSpec load;
  load.name = "pull";
  load.port = {0, 1};
  load.force = force;
  return load;
}

/// Where the port of the loaded end is, and how much the height of that end has changed.
struct Loaded {
  Vec3 moved;
  double height;
};

Loaded loaded(const SolidSpec& part, const Vec3& force) {
  Mechanism m = clamped(part);
  m.loads = {pull_of(force)};
  SimulationOptions o = tight();
  o.max_iterations = 40;
  const auto model = Model<SE2>::build(m, *find_plane(m).plane);
  const auto result = solve_static(model, o);
  EXPECT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
  const auto& t = result.trajectory;
  const SE2* H = t.frames(t.size() - 1);
  Loaded out{{H[1].x.x() - kLong, H[1].x.y(), 0}, 0};
  if (const auto* body = ContinuumBody<SE2>::of(*model.bodies[0])) {
    ContinuumBody<SE2>::Points x;
    body->positions(H, x);
    const auto& nodes = part.interfaces()[1].nodes;
    out.height = x(1, nodes.back()) - x(1, nodes.front()) - kHigh;
  }
  return out;
}

/// One cell high, so that nodes of equal force are pulled evenly: strain is the same everywhere and
/// the ends get thinner, as of rigid ends they do not.
TEST(AveragedPorts, AreAPatchTestAndLeaveTheFaceFree) {
  const double F = 0.1, EA = kFoam.E * kHigh * kFoamThickness, strain = F / EA,
               lag = 2 * F / (2 * kNodeStiffness * kFoam.E * kFoamThickness);
  const Loaded free = loaded(foam(4, 1, 0, Tie::Averaged), {F, 0, 0}),
               held = loaded(foam(4, 1, 0, Tie::Rigid), {F, 0, 0});
  EXPECT_NEAR(free.moved.x(), strain * kLong + lag, 1e-4 * strain * kLong);
  EXPECT_NEAR(free.height, -kFoam.nu * strain * kHigh, 1e-4 * strain * kHigh);
  EXPECT_LT(std::abs(held.height), 1e-9 * kHigh);
  EXPECT_LT(held.moved.x(), 0.99 * strain * kLong);
}

/// A small load moves it as the reduced part with the same interfaces, but for the lag.
TEST(AveragedPorts, AreThoseOfReducedParts) {
  const double F = 0.01, lag = F / (5 * kNodeStiffness * kFoam.E * kFoamThickness);
  SolidSpec part = foam(8, 4, 0, Tie::Averaged, {"foam", 2e6, 0.45, 1000});
  const Loaded all = loaded(part, {0, F, 0});
  part.as = SolidMotion::Reduced;
  part.modes = 0;
  const Loaded reduced = loaded(part, {0, F, 0});
  RecordProperty("off_1e9", std::to_string(1e9 * (all.moved.y() / reduced.moved.y() - 1)));
  EXPECT_NEAR(all.moved.y(), reduced.moved.y(), 0.01 * reduced.moved.y());
  EXPECT_GT(all.moved.y(), reduced.moved.y() + 0.9 * lag);
}

}  // namespace
}  // namespace liesl::test::averaged_port_test
