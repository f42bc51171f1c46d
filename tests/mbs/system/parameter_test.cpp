/// @file
/// Derivatives of the equations of motion by parameters: against central differences of the
/// residual of rebuilt models, at states of a running motion; and as linear functions of the law.

#include <Eigen/Eigenvalues>

#include "mbs/bodies/modal.hpp"
#include "mbs/bodies/rigid.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/run.hpp"
#include "mbs/solids/reduction.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "mbs/step_sweep.hpp"
#include "mbs/system/parameter_residual.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test::parameter_test {
namespace {

using Eigen::VectorXd;
using levelset::FeatureKind;
using test::options;

TimeFunction wave(double amplitude, double rate) {
  return TimeFunction::expression(std::to_string(amplitude) + "*(1.3+sin(" + std::to_string(rate) +
                                  "*t))");
}

TimeFunction sum_of_waves(double a, double rate_a, double b, double rate_b) {
  const auto term = [](double amplitude, double rate) {
    return std::to_string(amplitude) + "*(1.3+sin(" + std::to_string(rate) + "*t))";
  };
  return TimeFunction::expression(term(a, rate_a) + "+" + term(b, rate_b));
}

/// A slider-crank with all that has parameters: springs on a joint and between ports, an actuator,
/// loads of all kinds, weight, a slider whose centre of mass is off its frame.
Mechanism machine(Formalism formalism) {
  Mechanism m = test::slider_crank({4});
  m.formalism = formalism;
  m.gravity = {1, -9.81, 0};
  for (int b : {0, 1}) std::get<BeamSpec>(m.bodies[std::size_t(b)].kind).damping = 2e-5;
  auto& slider = std::get<RigidSpec>(m.bodies[2].kind);
  slider.centre = {0.02, -0.01, 0};
  m.drives[0].motion = TimeFunction::rate(60, 0.02);
  ForceSpec on_joint, between, actuator;
  on_joint.joint = 2;
  on_joint.stiffness = 5;
  on_joint.damping = 0.02;
  on_joint.rest = 0.1;
  between.a = {-1, 0, SE3(Mat3::Identity(), {0.2, 0.3, 0})};
  between.b = {1, 2, SE3(Mat3::Identity(), {0.01, 0.02, 0})};
  between.stiffness = 300;
  between.damping = 2;
  between.rest = 0.2;
  between.force = wave(3, 40);
  actuator.joint = 3;
  actuator.force = wave(20, 70);
  m.forces = {on_joint, between, actuator};
  LoadSpec dead, follower, spread, spread_follower;
  dead.port = {1, 1, SE3(Mat3::Identity(), {0, 0.02, 0})};
  dead.force = {5, -8, 0};
  dead.moment = {0, 0, 0.3};
  dead.scale = wave(1, 50);
  follower = dead;
  follower.follower = true;
  follower.port = {0, 3};
  spread = dead;
  spread.port = {1, 0};
  spread.spread = true;
  spread_follower = spread;
  spread_follower.port = {0, 0};
  spread_follower.follower = true;
  m.loads = {dead, follower, spread, spread_follower};
  return m;
}

/// A parameter as a change of the data, p = 0 as they are, and as its derivative there.
struct Case {
  std::function<void(Mechanism&, double)> change;
  Parameter parameter;
  double step;  ///< of the differences, a few per cent of the data
};

BeamSpec& beam(Mechanism& m, int b) { return std::get<BeamSpec>(m.bodies[std::size_t(b)].kind); }
RigidSpec& slider(Mechanism& m) { return std::get<RigidSpec>(m.bodies[2].kind); }

/// Components of loads; functions of time.
std::vector<Case> changes_of_loads_and_functions() {
  std::vector<Case> all;
  for (int l = 0; l < 4; ++l) {
    const LoadDerivative by{l, 0, {{0.5, wave(2, 90)}}, {1, 2, 0}, {0, 0, 0.1}};
    all.push_back({[by, l](Mechanism& c, double p) {
                     LoadSpec& load = c.loads[std::size_t(l)];
                     load.force += p * by.force;
                     load.moment += p * by.moment;
                   },
                   {"components of load " + std::to_string(l),
                    {LoadDerivative{l, 0, {}, by.force, by.moment}}},
                   0.1});
    all.push_back({[l](Mechanism& c, double p) {
                     c.loads[std::size_t(l)].scale = sum_of_waves(1, 50, 0.5 * p * 2, 90);
                   },
                   {"scale of load " + std::to_string(l), {LoadDerivative{l, 0, by.scale}}},
                   0.1});
  }
  for (int f : {1, 2})
    all.push_back({[f](Mechanism& c, double p) {
                     c.forces[std::size_t(f)].force =
                         sum_of_waves(f == 1 ? 3 : 20, f == 1 ? 40 : 70, 3 * p, 20);
                   },
                   {"function of force " + std::to_string(f),
                    {ForceDerivative{f, 0, 0, 0, 0, {{3, wave(1, 20)}}}}},
                   0.1});
  all.push_back(
      {[](Mechanism& c, double p) { c.drives[0].motion = TimeFunction::rate(60 + 7 * p, 0.02); },
       {"motion of the drive", {DriveDerivative{0, 0, {{7, TimeFunction::rate(1, 0.02)}}}}},
       0.1});
  return all;
}

std::vector<Case> cases(const Mechanism& m) {
  std::vector<Case> all = changes_of_loads_and_functions();
  all.push_back({[](Mechanism& c, double p) {
                   for (int e : {1, 2})
                     std::get<Circle>(beam(c, 1).sections[std::size_t(e)].shape).diameter += p;
                 },
                 {"diameter of two elements", {by_dimension(m, 1, {1, 2}, "diameter")}},
                 5e-4});
  all.push_back({[](Mechanism& c, double p) {
                   for (int b : {0, 1})
                     for (Section& s : beam(c, b).sections) std::get<Circle>(s.shape).diameter += p;
                 },
                 {"diameters of two beams",
                  {by_dimension(m, 0, {}, "diameter"), by_dimension(m, 1, {}, "diameter")}},
                 5e-4});
  all.push_back({[](Mechanism& c, double p) { beam(c, 1).material.E += p; },
                 {"E", {by_youngs_modulus(m, 1)}},
                 1e10});
  all.push_back({[](Mechanism& c, double p) { beam(c, 0).material.rho += p; },
                 {"rho", {by_density(m, 0)}},
                 400});
  RigidDerivative rigid{2, 1.5, {0.2, -0.7, 0}, Vec3(2, 3, 4).asDiagonal()};
  all.push_back({[rigid](Mechanism& c, double p) {
                   slider(c).mass += p * rigid.mass;
                   slider(c).centre += p * rigid.centre;
                   slider(c).inertia += p * rigid.inertia;
                 },
                 {"mass, centre and inertia", {rigid}},
                 1e-2});
  for (int f = 0; f < 3; ++f) {
    const ForceDerivative law{f, 7, 0.3, -0.2, 0.8};
    all.push_back(
        {[law, f](Mechanism& c, double p) {
           ForceSpec& force = c.forces[std::size_t(f)];
           if (f < 2) {
             force.stiffness += p * law.stiffness;
             force.damping += p * law.damping;
             force.rest += p * law.rest;
           }
           const TimeFunction F = force.force;
           if (f > 0)
             force.force = wave((f == 1 ? 3 : 20) * (1 + law.factor * p), f == 1 ? 40 : 70);
         },
         {"force " + std::to_string(f), {f < 2 ? law : ForceDerivative{f, 0, 0, 0, law.factor}}},
         0.1});
  }
  for (int l = 0; l < 4; ++l)
    all.push_back(
        {[l](Mechanism& c, double p) { c.loads[std::size_t(l)].scale = wave(1 + 0.7 * p, 50); },
         {"load " + std::to_string(l), {LoadDerivative{l, 0.7}}},
         0.1});
  all.push_back(
      {[](Mechanism& c, double p) { c.drives[0].motion = TimeFunction::rate(60 * (1 + p), 0.02); },
       {"drive", {DriveDerivative{0, 1}}},
       0.1});
  return all;
}

/// r and phi of a model at a state, one below the other.
template <class G>
VectorXd equations(const Model<G>& model, const State<G>& s) {
  Equations<G> eq(model);
  eq.evaluate(s, s.rows, {s.t, 1});
  VectorXd all(eq.r.size() + eq.phi.size());
  all << eq.r, eq.phi;
  return all;
}

/// Every parameter at a state in the middle of a motion.
template <class G>
void expect_derivatives(const Mechanism& m, const Space<G>& space) {
  const auto run = test::run<G>(m, space, options(0.03, 5e-4));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  State<G> s = run.model->initial_state();
  run.trajectory().read(run.last() - 7, s);
  ASSERT_GT(s.v.norm(), 1);
  ASSERT_GT(s.vdot.norm(), 10);
  for (const Case& c : cases(m)) {
    const ParameterResidual<G> derivative(m, *run.model, c.parameter);
    VectorXd r_p = VectorXd::Zero(run.model->size()),
             phi_p = VectorXd::Zero(run.model->constraints());
    derivative.add(s, s.rows, {s.t, 1}, r_p, phi_p);
    VectorXd elsewhere = r_p;
    for (const int node : derivative.nodes())
      elsewhere.template segment<G::dim>(G::dim * node).setZero();
    EXPECT_EQ(elsewhere.norm(), 0) << "acts on other nodes than it says: " << c.parameter.name;
    VectorXd exact(r_p.size() + phi_p.size());
    exact << r_p, phi_p;
    const auto at = [&](double p) {
      Mechanism changed = m;
      c.change(changed, p);
      return equations(Model<G>::build(changed, space), s);
    };
    if (exact.norm() == 0) {
      EXPECT_EQ(m.formalism, Formalism::Rigid) << c.parameter.name;
      EXPECT_EQ((at(c.step) - at(-c.step)).norm(), 0) << c.parameter.name;
      continue;
    }
    const VectorXd scale = VectorXd::Constant(exact.size(), exact.cwiseAbs().maxCoeff());
    test::expect_second_order(test::central_first(at, 0), exact, scale, c.step, 1e-7,
                              c.parameter.name);
    double best = 1;
    for (double h = c.step / 4; h > 1e-4 * c.step; h /= 4)
      best = std::min(best, (test::central_first(at, 0)(h) - exact).norm() / exact.norm());
    EXPECT_LT(best, 1e-7) << c.parameter.name << " " << to_string(m.formalism);
  }
}

class Parameters : public ::testing::TestWithParam<Formalism> {};

TEST_P(Parameters, AreTheDifferencesOfTheResidualInThePlane) {
  const Mechanism m = machine(GetParam());
  const auto search = find_plane(m);
  ASSERT_TRUE(search.plane) << search.reason;
  expect_derivatives<SE2>(m, *search.plane);
}

TEST_P(Parameters, AreTheDifferencesOfTheResidualInSpace) {
  expect_derivatives<SE3>(machine(GetParam()), {});
}

/// With damping, and with loads per length that follow, whose forces depend on the section.
TEST(ParametersOfOrder4, AreTheDifferencesOfTheResidual) {
  Mechanism m = machine(Formalism::SE3);
  for (int b : {0, 1}) beam(m, b).order = 4;
  expect_derivatives<SE2>(m, test::space_of<SE2>(m));
  expect_derivatives<SE3>(m, {});
}

INSTANTIATE_TEST_SUITE_P(EveryFormalism, Parameters,
                         ::testing::Values(Formalism::SE3, Formalism::R3SO3, Formalism::Classical,
                                           Formalism::Rigid),
                         [](const auto& of) { return std::string(to_string(of.param)); });

TEST(ParameterOfAMechanism, SaysAllThatIsWrongWithIt) {
  const Mechanism m = machine(Formalism::SE3);
  const auto model = Model<SE3>::build(m, {});
  const Parameter bad{"bad",
                      {BeamDerivative{2, {}, {}}, RigidDerivative{0}, LoadDerivative{9, 1},
                       BeamDerivative{0, {}, {}}}};
  try {
    const ParameterResidual<SE3> residual(m, model, bad);
    FAIL();
  } catch (const std::invalid_argument& e) {
    for (const char* part :
         {"'bad'", "beam, got 2", "rigid body, got 0", "load, got 9", "4 elements"})
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << part << ": " << e.what();
  }
  EXPECT_THROW(by_dimension(m, 2, {}, "diameter"), std::invalid_argument);
  EXPECT_THROW(by_dimension(m, 0, {4}, "diameter"), std::invalid_argument);
  EXPECT_THROW(by_dimension(m, 0, {}, "width"), std::invalid_argument);
}

/// Random laws, states and accelerations of a body of its own.
template <class G>
class BodyDerivative : public ::testing::Test {
 protected:
  static constexpr int dim = G::dim;
  using Tangent = typename G::Tangent;

  std::vector<ElementSection<G>> random_sections() {
    std::vector<ElementSection<G>> all;
    for (int e = 0; e < kElements; ++e) all.push_back({random.spd(dim), random.spd(dim)});
    return all;
  }
  std::vector<G> nodes() const {
    std::vector<G> frames{G::identity()};
    for (int e = 0; e < kElements; ++e)
      frames.push_back(frames.back() * G::exp(Tangent(0.3 * Tangent::Unit(0))));
    return frames;
  }
  std::unique_ptr<ModalBody<G>> modal(const std::vector<ElementSection<G>>& sections,
                                      const std::vector<int>& interfaces, int modes) const {
    return std::make_unique<ModalBody<G>>(
        std::make_unique<Beam<G>>("beam", nodes(), sections, 0.01), interfaces, modes);
  }
  void move(const Body<G>& body) {
    H.assign(body.reference.begin(), body.reference.end());
    for (G& frame : H) frame = frame * G::exp(Tangent(0.1 * random.vector(dim)));
    v = random.vector(body.size());
    vdot = random.vector(body.size());
    w = 0.1 * random.vector(body.size());
    for (auto* x : {&v, &vdot, &w})
      for (int k = 0; k < body.nodes(); ++k)
        if (body.kind(k) == NodeKind::Follower || (x == &w && body.kind(k) == NodeKind::Frame))
          x->template segment<dim>(dim * k).setZero();
  }
  VectorXd residual(const Body<G>& body) const {
    VectorXd r = VectorXd::Zero(body.size());
    ForceScale scale;
    const BodyState<G> s{H.data(), v.data(), vdot.data(), w.data()};
    body.add_internal(s, r.data(), scale);
    body.add_inertia(s, gravity, r.data(), scale);
    return r;
  }

  static constexpr int kElements = 3;
  test::Random random{5};
  typename Body<G>::Vector gravity = random.vector(G::space_dim);
  std::vector<G> H;
  VectorXd v, vdot, w;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(BodyDerivative, Groups);

/// A residual is linear in the law: in the direction of the law it is its own derivative, and the
/// same holds for its matrices and energies.
template <class G, class Test>
void expect_homogeneous(const Test& test, const Body<G>& body, const Body<G>& by_itself,
                        double tolerance) {
  const VectorXd r = test(body);
  EXPECT_LT((test(by_itself) - r).norm(), tolerance * r.norm());
}

TYPED_TEST(BodyDerivative, InTheDirectionOfTheLawIsTheResidualItself) {
  using G = TypeParam;
  const auto law = this->random_sections();
  const auto residual = [this](const Body<G>& b) { return this->residual(b); };
  const Beam<G> lie("beam", this->nodes(), law, 0.01);
  const ReissnerBeam<G> reissner("beam", this->nodes(), law, 0.01);
  const Rigid<G> rigid("beam", std::make_shared<Beam<G>>("beam", this->nodes(), law, 0.));
  const auto truncated = this->modal(law, {0, 2, 3}, 2), free = this->modal(law, {0}, 4);
  for (const Body<G>* body : std::initializer_list<const Body<G>*>{&lie, &reissner, &rigid,
                                                                   truncated.get(), free.get()}) {
    this->move(*body);
    const auto derivative = body->derivative(law);
    expect_homogeneous<G>(residual, *body, *derivative, 1e-12);
    EXPECT_NEAR(derivative->total_mass(), body->total_mass(), 1e-12 * body->total_mass());
    const auto* reduced = dynamic_cast<const FloatingBody<G>*>(body);
    if (!reduced) continue;
    const auto expect_equal = [&](const auto& found, const auto& expected) {
      const auto used = expected.dense.rows() - reduced->padding();
      const auto block = [used](const auto& A) { return A.dense.topLeftCorner(used, used).eval(); };
      EXPECT_LT((block(found) - block(expected)).norm(), 1e-12 * block(expected).norm());
      EXPECT_EQ(found.dense.bottomRows(reduced->padding()).norm(), 0);
    };
    expect_equal(derivative->mass(), body->mass());
    expect_equal(derivative->stiffness(), body->stiffness());
  }
}

/// The derivative is linear: of a sum of laws it is the sum.
TYPED_TEST(BodyDerivative, IsLinearInTheDirection) {
  const auto law = this->random_sections(), a = this->random_sections(),
             b = this->random_sections();
  auto sum = a;
  for (std::size_t e = 0; e < sum.size(); ++e) {
    sum[e].K = 2 * a[e].K - 3 * b[e].K;
    sum[e].M = 2 * a[e].M - 3 * b[e].M;
  }
  const auto body = this->modal(law, {0, 3}, 3);
  this->move(*body);
  const VectorXd expected =
      2 * this->residual(*body->derivative(a)) - 3 * this->residual(*body->derivative(b));
  EXPECT_LT((this->residual(*body->derivative(sum)) - expected).norm(), 1e-12 * expected.norm());
}

/// With all modes the rebuilt body is the same body in other coordinates, Psi eta.
TYPED_TEST(BodyDerivative, OfAModalBodyWithAllModesIsTheDifferenceOfRebuiltBodies) {
  using G = TypeParam;
  auto law = this->random_sections(), direction = this->random_sections();
  const auto body = this->modal(law, {0}, -1);
  this->move(*body);
  const int n = body->size() - G::dim;
  const Eigen::MatrixXd Psi = body->basis().bottomRows(n);
  const VectorXd w0 = this->w, v0 = this->v, a0 = this->vdot;
  // [force on the frame; Psi^-T times that on the amplitudes]
  const auto in_nodes = [&](const VectorXd& r, const Eigen::MatrixXd& basis) {
    VectorXd out = r;
    out.tail(n) = basis.transpose().partialPivLu().solve(r.tail(n));
    return out;
  };
  const auto at = [&](double p) -> VectorXd {
    auto changed = law;
    for (std::size_t e = 0; e < law.size(); ++e) {  // the inertia is not linear in p
      changed[e].K += p * direction[e].K;
      changed[e].M += (p + p * p * p) * direction[e].M;
    }
    const auto rebuilt = this->modal(changed, {0}, -1);
    const Eigen::MatrixXd basis = rebuilt->basis().bottomRows(n);
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(basis);
    this->w.tail(n) = lu.solve(Psi * w0.tail(n));
    this->v.tail(n) = lu.solve(Psi * v0.tail(n));
    this->vdot.tail(n) = lu.solve(Psi * a0.tail(n));
    return in_nodes(this->residual(*rebuilt), basis);
  };
  VectorXd exact = in_nodes(this->residual(*body->derivative(direction)), Psi);
  const VectorXd scale = VectorXd::Constant(exact.size(), exact.cwiseAbs().maxCoeff());
  test::expect_second_order(test::central_first(at, 0), exact, scale, 0.1, 1e-8, "modal");
  EXPECT_LT((test::central_first(at, 0)(1e-4) - exact).norm(), 1e-7 * exact.norm());
}

/// A meshed bar with two ports, all of it material.
template <class G>
SolidSpec bar(double exponent, double ratio = 1e-6) {
  SolidSpec s;
  s.model = test::mesh_with_ends(G::space_dim == 2 ? quad_grid({0, 0}, {1, 0.2}, 12, 4)
                                                   : hex_grid({0, 0, 0}, {1, 0.2, 0.1}, 8, 3, 2),
                                 {"soft", 1e7, 0.3, 1000}, {0, 0.1, 0}, {1, 0.1, 0},
                                 {0.1, {exponent, ratio}});
  s.modes = 4;
  s.damping = 0.01;
  return s;
}

/// Elastic eigenvalues of the free part in the space of its port motions and modes, 1/s^2: they do
/// not depend on the coordinates of that space.
VectorXd ritz_values(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M, int rigid,
                     Eigen::MatrixXd* vectors = nullptr) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> found(K, M);
  if (vectors) *vectors = found.eigenvectors().rightCols(K.cols() - rigid);
  return found.eigenvalues().tail(K.cols() - rigid);
}

/// The modes follow the fractions: all eigenvalues of the reduced part, which has few modes,
/// against differences of parts reduced anew.
TYPED_TEST(BodyDerivative, OfAMeshedPartIsTheDifferenceOfRebuiltParts) {
  using G = TypeParam;
  const SolidSpec spec = bar<G>(1.4);
  std::vector<G> ports(2, G::identity());
  for (int i : {0, 1})
    ports[std::size_t(i)].x = spec.interfaces()[std::size_t(i)].point.template head<G::space_dim>();
  const SolidBody<G> body("bar", spec, ports, Mat3::Identity());
  const SolidModel& model = *spec.model;
  const VectorXd v0 = solid_fractions(spec).value;
  VectorXd dv = VectorXd::Zero(v0.size());  // one quarter of the bar
  dv.head(dv.size() / 4) = this->random.vector(int(dv.size()) / 4);
  const auto derivative = body.derivative(FractionDerivative{&model, v0, dv});
  const auto used = body.stiffness().dense.rows() - body.padding();
  const auto block = [used](const auto& A) -> Eigen::MatrixXd {
    return A.dense.topLeftCorner(used, used);
  };
  const auto rebuilt = [&](double p) -> VectorXd {
    const ReducedSolid r = reduce(model, v0 + p * dv, ReductionKind::CraigBampton, body.modes());
    return ritz_values(r.K, r.M, G::dim);
  };
  Eigen::MatrixXd phi;
  const VectorXd lambda = ritz_values(block(body.stiffness()), block(body.mass()), G::dim, &phi);
  ASSERT_LT((rebuilt(0) - lambda).norm(), 1e-9 * lambda.norm());
  const Eigen::MatrixXd by_K = block(derivative->stiffness()) * phi,
                        by_M = block(derivative->mass()) * phi;
  const VectorXd exact = (phi.cwiseProduct(by_K).colwise().sum() -
                          phi.cwiseProduct(by_M).colwise().sum() * lambda.asDiagonal())
                             .transpose();
  test::expect_second_order(test::central_first(rebuilt, 0), exact, lambda, 0.1, 1e-7, "Ritz");
  EXPECT_NEAR(derivative->total_mass(), model.cell_masses().dot(dv), 1e-10 * body.total_mass());
}

/// A bar of square section has its bending modes in pairs. Where one of a pair is kept the span of
/// the modes has no derivative, by what tells the two apart; both together have one.
TEST(ParameterOfAPart, OneModeOfAPairHasNoDerivative) {
  SolidSpec spec = bar<SE3>(1.4);
  spec.model =
      test::mesh_with_ends(hex_grid({0, 0, 0}, {1, 0.1, 0.1}, 8, 2, 2), {"soft", 1e7, 0.3, 1000},
                           {0, 0.05, 0.05}, {1, 0.05, 0.05}, {0.1, {1.4, 1e-6}});
  std::vector<SE3> ports(2, SE3::identity());
  ports[1].x = {1, 0, 0};
  const SolidModel& model = *spec.model;
  const VectorXd v = solid_fractions(spec).value;
  VectorXd dv = VectorXd::Zero(v.size());
  dv.head(dv.size() / 3).setLinSpaced(0, 1);
  for (const int modes : {1, 2}) {
    spec.modes = modes;
    const SolidBody<SE3> body("bar", spec, ports, Mat3::Identity());
    const FractionDerivative law{&model, v, dv};
    if (modes == 1)
      EXPECT_THROW(body.derivative(law), std::invalid_argument);
    else
      EXPECT_NO_THROW(body.derivative(law));
  }
}

/// Integrals of a part and its modes against differences, of any change of both.
TEST(InertiaIntegralsOfAPart, DerivativeIsTheDifference) {
  const SolidSpec spec = bar<SE3>(1);
  const SolidModel& model = *spec.model;
  test::Random random(3);
  const VectorXd v = solid_fractions(spec).value, dv = random.vector(int(v.size()));
  const auto shapes = [&] {
    return random.vector(3 * model.size()).reshaped(model.size(), 3).eval();
  };
  const Eigen::MatrixXd modes = shapes(), dmodes = shapes();
  const auto flat = [](const InertiaIntegrals& I) {
    std::vector<double> all{I.mass};
    const auto add = [&all](const auto& A) {
      all.insert(all.end(), A.data(), A.data() + A.size());
    };
    add(I.first), add(I.second), add(I.mode);
    for (const auto& A : I.cross) add(A);
    for (const auto& A : I.product) add(A);
    return VectorXd(Eigen::Map<VectorXd>(all.data(), Eigen::Index(all.size())));
  };
  const auto at = [&](double p) -> VectorXd {
    return flat(inertia_integrals(model, v + p * dv, modes + p * dmodes));
  };
  const VectorXd exact = flat(inertia_integrals_derivative(model, v, modes, dv, dmodes));
  const VectorXd scale = VectorXd::Constant(exact.size(), exact.cwiseAbs().maxCoeff());
  test::expect_second_order(test::central_first(at, 0), exact, scale, 0.1, 1e-9, "integrals");
}

/// With a stiffness linear in the fractions, the derivative along the fractions is the residual.
TYPED_TEST(BodyDerivative, OfAMeshedPartAlongItsFractionsIsTheResidual) {
  using G = TypeParam;
  const SolidSpec spec = bar<G>(1, 1e-15);
  std::vector<G> ports(2, G::identity());
  for (int i : {0, 1})
    ports[std::size_t(i)].x = spec.interfaces()[std::size_t(i)].point.template head<G::space_dim>();
  const SolidBody<G> body("bar", spec, ports, Mat3::Identity());
  const SolidModel& model = *spec.model;
  const VectorXd full = solid_fractions(spec).value;
  const auto derivative = body.derivative(FractionDerivative{&model, full, full});
  this->move(body);
  expect_homogeneous<G>([this](const Body<G>& b) { return this->residual(b); }, body, *derivative,
                        1e-9);
  EXPECT_THROW(body.derivative(FractionDerivative{&model, full, full.head(3)}),
               std::invalid_argument);
  EXPECT_THROW(body.derivative(std::vector<ElementSection<G>>(3)), std::invalid_argument);
}

/// Stiffness and mass of all cells scale internal forces and those of inertia.
TYPED_TEST(BodyDerivative, OfAMeshedPartByItsScaleIsAShareOfTheResidual) {
  using G = TypeParam;
  const SolidSpec spec = bar<G>(1);
  std::vector<G> ports(2, G::identity());
  for (int i : {0, 1})
    ports[std::size_t(i)].x = spec.interfaces()[std::size_t(i)].point.template head<G::space_dim>();
  const SolidBody<G> body("bar", spec, ports, Mat3::Identity());
  this->move(body);
  const auto both = body.derivative(ScaleDerivative{1, 1});
  expect_homogeneous<G>([this](const Body<G>& b) { return this->residual(b); }, body, *both, 1e-9);
  const VectorXd K = this->residual(*body.derivative(ScaleDerivative{1, 0})),
                 M = this->residual(*body.derivative(ScaleDerivative{0, 1})),
                 all = this->residual(body);
  EXPECT_GT(K.norm(), 1e-6 * all.norm());
  EXPECT_GT(M.norm(), 1e-6 * all.norm());
  EXPECT_LT((K + M - all).norm(), 1e-12 * all.norm());
  EXPECT_NEAR(body.derivative(ScaleDerivative{0, 2})->total_mass(), 2 * body.total_mass(),
              1e-12 * body.total_mass());
}

/// A rigid part of a mesh: rebuilt bodies at all fractions.
TEST(ParameterOfAMechanism, FractionsOfARigidPart) {
  Mechanism m;
  m.formalism = Formalism::Rigid;
  m.gravity = {0, -9.81, 0};
  SolidSpec spec = bar<SE2>(1.4);
  spec.outline = {2, {{"hole", FeatureKind::HalfSpace, {0.61, 0, 0}, {}}}};
  m.bodies = {{"bar", spec}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  const Space<SE2> plane;
  const auto run = test::run<SE2>(m, plane, options(0.2, 5e-3));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  State<SE2> s = run.model->initial_state();
  run.trajectory().read(run.last(), s);
  const auto at = [&](double p) {
    Mechanism changed = m;
    std::get<SolidSpec>(changed.bodies[0].kind).outline.features[0].values[0] += p;
    return equations(Model<SE2>::build(changed, plane), s);
  };
  const Eigen::VectorXd dv = Eigen::MatrixXd(solid_fractions(spec).derivative).col(0);
  const ParameterResidual<SE2> derivative(m, *run.model, {"edge", {SolidDerivative{0, dv}}});
  VectorXd r_p = VectorXd::Zero(run.model->size()),
           phi_p = VectorXd::Zero(run.model->constraints());
  derivative.add(s, s.rows, {s.t, 1}, r_p, phi_p);
  VectorXd exact(r_p.size() + phi_p.size());
  exact << r_p, phi_p;
  ASSERT_GT(exact.norm(), 0);
  EXPECT_LT((test::central_first(at, 0)(1e-4) - exact).norm(), 1e-7 * exact.norm());
}

}  // namespace
}  // namespace liesl::test::parameter_test
