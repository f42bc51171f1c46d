/// @file
/// Responses: gradients and explicit derivatives against central differences, for every kind,
/// formalism and group, at states of a running motion; invariance under rigid motions.

#include <algorithm>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/run.hpp"
#include "mbs/step_sweep.hpp"
#include "mbs/system/response_value.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test::response_test {
namespace {

using Eigen::VectorXd;
using test::options;

/// A slider-crank under its weight with a spring to the ground and one on a joint.
Mechanism machine(Formalism formalism) {
  Mechanism m = test::slider_crank({4});
  m.formalism = formalism;
  m.gravity = {1, -9.81, 0};
  m.drives[0].motion = TimeFunction::rate(60, 0.02);
  ForceSpec on_joint, between;
  on_joint.joint = 2;
  on_joint.stiffness = 5;
  on_joint.rest = 0.1;
  between.a = {-1, 0, SE3(Mat3::Identity(), {0.2, 0.3, 0})};
  between.b = {1, 4, SE3(Mat3::Identity(), {0.01, 0.02, 0})};
  between.stiffness = 300;
  between.rest = 0.2;
  m.forces = {on_joint, between};
  JointSpec cylinder{"cylinder", JointType::Cylinder, between.a, between.b};
  m.joints.push_back(cylinder);
  ForceSpec inside;
  inside.joint = 4;
  inside.stiffness = 2;
  inside.damping = 0.03;
  inside.rest = 0.05;
  inside.force = TimeFunction::expression("0.07+0.01*sin(30*t)");
  inside.curve.emplace(std::vector<double>{-1, 0, 1}, std::vector<double>{-0.9, 0, 0.3},
                       TimeFunction::Interpolation::Cubic);
  m.forces.push_back(inside);
  return m;
}

/// Every kind of response of a beam (body 1) and of the joints of the machine.
std::vector<ResponseSpec> responses(bool planar) {
  const Port off{1, 2, SE3(SO3::exp({0, 0, 0.3}).R, {0.01, -0.02, 0})};
  std::vector<ResponseSpec> all;
  const auto add = [&](ResponseKind kind, auto set) {
    ResponseSpec r;
    r.kind = kind;
    r.body = 1;
    r.at = off;
    set(r);
    r.name = std::string(name_of(kind)) + " " + std::to_string(all.size());
    all.push_back(r);
  };
  const auto plain = [](ResponseSpec&) {};
  for (const auto kind :
       {ResponseKind::Position, ResponseKind::Velocity, ResponseKind::AngularVelocity,
        ResponseKind::Rotation, ResponseKind::Displacement, ResponseKind::Acceleration,
        ResponseKind::AngularAcceleration}) {
    for (const auto in : {Axes::Body, Axes::Inertial}) {
      add(kind, [in](ResponseSpec& r) { r.in = in; });
      add(kind, [in](ResponseSpec& r) { r.in = in, r.axis = Vec3(0.6, -0.8, 0); });
    }
  }
  for (const auto side : {Side::Up, Side::Down})
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX())})  // one side is 0
      add(ResponseKind::Position, [&](ResponseSpec& r) { r.axis = axis, r.side = side; });
  add(ResponseKind::Deflection, plain);
  add(ResponseKind::Deflection, [](ResponseSpec& r) { r.s = 0.61; });
  add(ResponseKind::Deflection, [](ResponseSpec& r) { r.everywhere = true; });
  add(ResponseKind::Elongation, [](ResponseSpec& r) { r.at = {1, 0}, r.to = {1, 4}; });
  add(ResponseKind::Elongation, [&](ResponseSpec& r) {
    r.at = off, r.to = {-1, 0, SE3(Mat3::Identity(), {1, 1, 0})};
  });
  add(ResponseKind::Coordinate, [](ResponseSpec& r) { r.joint = 1; });
  add(ResponseKind::Coordinate, [](ResponseSpec& r) { r.joint = 3; });
  add(ResponseKind::JointForce, [](ResponseSpec& r) { r.joint = 1; });
  add(ResponseKind::JointForce, [](ResponseSpec& r) { r.joint = 4; });
  for (const Axes in : {Axes::Inertial, Axes::Body})
    for (const int joint : {1, 4})
      add(ResponseKind::JointForce, [in, joint](ResponseSpec& r) {
        r.joint = joint, r.in = in;
        r.axis = Vec3(0.6, 0.8, 0);
      });
  for (int component : {0, 1, 2, 3, 4, 5})
    if (!planar || component == 0 || component == 1 || component == 5)
      for (const auto place : {ElementPlace::First, ElementPlace::Middle, ElementPlace::Last})
        add(ResponseKind::SectionForce,
            [&](ResponseSpec& r) { r.element = 2, r.component = component, r.place = place; });
  add(ResponseKind::Stress, plain);
  add(ResponseKind::Energy, plain);
  add(ResponseKind::Compliance, plain);
  return all;
}

/// A random change of all unknowns of a model, and the state it leads to.
template <class G>
struct Direction {
  VectorXd h, v, vdot, lambda;
  Direction(const Model<G>& model, test::Random& random)
      : h(random.vector(model.size())),
        v(random.vector(model.size())),
        vdot(random.vector(model.size())),
        lambda(random.vector(model.constraints())) {
    for (const int k : model.amplitudes()) h.template segment<G::dim>(G::dim * k) *= 1e-3;
  }

  State<G> from(const Model<G>& model, const State<G>& s, double p) const {
    State<G> moved = s;
    for (const int k : model.frames())
      moved.H[std::size_t(k)] =
          s.H[std::size_t(k)] *
          G::exp(typename G::Tangent(p * h.template segment<G::dim>(G::dim * k)));
    for (const int k : model.amplitudes())
      moved.w.template segment<G::dim>(G::dim * k) += p * h.template segment<G::dim>(G::dim * k);
    for (const int k : model.positions()) {
      constexpr int sd = G::space_dim;
      G& H = moved.H[std::size_t(k)];
      H.x += p * H.R * h.template segment<sd>(G::dim * k);
      moved.v.template segment<sd>(G::dim * k) += p * v.template segment<sd>(G::dim * k);
    }
    for (const auto* nodes : {&model.frames(), &model.amplitudes()})
      for (const int k : *nodes) {
        constexpr int dim = G::dim;
        moved.v.template segment<dim>(dim * k) += p * v.template segment<dim>(dim * k);
        moved.vdot.template segment<dim>(dim * k) += p * vdot.template segment<dim>(dim * k);
      }
    moved.lambda += p * lambda;
    model.complete(moved);
    Equations<G>(model).observe(moved, s.rows, moved.rows);
    return moved;
  }
  double times(const ResponseGradient<G>& g) const {
    double sum = 0;
    for (const auto& node : g.nodes)
      sum += node.h.dot(h.template segment<G::dim>(G::dim * node.node)) +
             node.v.dot(v.template segment<G::dim>(G::dim * node.node)) +
             node.vdot.dot(vdot.template segment<G::dim>(G::dim * node.node));
    for (const auto& row : g.lambda) sum += row.value * lambda[row.row];
    return sum;
  }
};

/// Gradient of each component along some directions.
template <class G>
void expect_gradients(const Mechanism& m, const Model<G>& model, const State<G>& s,
                      const std::vector<ResponseSpec>& all) {
  test::Random random(11);
  std::vector<Direction<G>> directions;
  for (int i = 0; i < 5; ++i) directions.emplace_back(model, random);
  const ResponseValues<G> values(m, model);
  for (const ResponseSpec& r : all) {
    const auto gradient = values.gradient(r, s);
    const int count = int(directions.size()), c = int(gradient.size());
    ASSERT_EQ(c, components(r, G::space_dim == 2));
    VectorXd exact(count * c);
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < c; ++k)
        exact[c * i + k] = directions[std::size_t(i)].times(gradient[std::size_t(k)]);
    const auto at = [&](double p) {
      VectorXd y(count * c);
      for (int i = 0; i < count; ++i)
        y.segment(c * i, c) = values(r, directions[std::size_t(i)].from(model, s, p));
      return y;
    };
    const double size = exact.cwiseAbs().maxCoeff();
    const std::string what = r.name + " " + to_string(m.formalism);
    const auto difference = test::central_first(at, 0);
    if (size < 1e-10) {  // inside a rigid body
      EXPECT_LT(difference(1e-3).norm(), 1e-9) << what;
      continue;
    }
    // Steps below which the same node, element and point have the largest value; elasticity is
    // stiff, and its energy far from quadratic in steps that are not small.
    const bool largest = r.kind == ResponseKind::Stress || r.everywhere;
    const bool stiff = r.kind == ResponseKind::Energy || r.kind == ResponseKind::Compliance;
    const double start = largest ? 1e-6 : stiff ? 2e-5 : 1e-3;
    if (!largest)
      test::expect_second_order(difference, exact, VectorXd::Constant(exact.size(), size), start,
                                1e-7, what);
    double best = 1;
    for (double h = start; h > 1e-4 * start; h /= 4) {
      const VectorXd fourth_order = (4 * difference(h / 2) - difference(h)) / 3;
      best = std::min(best, (fourth_order - exact).cwiseAbs().maxCoeff() / size);
    }
    EXPECT_LT(best, 1e-7) << what;
  }
}

template <class G>
State<G> in_motion(const test::Run<G>& run) {
  State<G> s = run.model->initial_state();
  run.trajectory().read(run.last() - 7, s);
  return s;
}

class Responses : public ::testing::TestWithParam<Formalism> {};

TEST_P(Responses, HaveTheirGradientsInThePlane) {
  const Mechanism m = machine(GetParam());
  const auto run = test::run_planar(m, options(0.03, 5e-4));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  expect_gradients(m, *run.model, in_motion(run), responses(true));
}

bool accelerates(const ResponseSpec& r) {
  return r.kind == ResponseKind::Acceleration || r.kind == ResponseKind::AngularAcceleration;
}

/// Axes of its nodes follow their neighbours; those with accelerations are at its ends.
TEST(Responses, OfAChainOfSegmentsHaveTheirGradients) {
  const Mechanism m = machine(Formalism::Segments);
  const auto run = test::run_planar(m, options(0.03, 5e-4));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  const State<SE2> s = in_motion(run);
  auto all = responses(true);
  for (ResponseSpec& r : all) {
    if (!accelerates(r)) continue;
    EXPECT_THROW(ResponseValues<SE2>(m, *run.model)(r, s), std::invalid_argument) << r.name;
    r.at.node = 4;
  }
  expect_gradients(m, *run.model, s, all);
}

/// Largest distance of accelerations from the central differences of velocities over the second
/// half of a motion, of their largest value.
double gap_of_accelerations(const Mechanism& m, double step, ResponseKind rate,
                            ResponseKind acceleration) {
  const auto run = test::run_spatial(m, options(0.01, step, 0.8, 1e-10));
  EXPECT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  const ResponseValues<SE3> values(m, *run.model);
  ResponseSpec v, a;
  v.kind = rate;
  a.kind = acceleration;
  v.in = a.in = Axes::Inertial;
  v.at = a.at = {1, 2, SE3(Mat3::Identity(), {0.01, -0.02, 0})};
  State<SE3> s = run.model->initial_state();
  const auto at = [&](const ResponseSpec& r, int n) -> Vec3 {
    run.trajectory().read(n, s);
    return values(r, s);
  };
  double gap = 0, size = 0;
  for (int n = run.last() / 2; n < run.last(); ++n) {
    const Vec3 difference = (at(v, n + 1) - at(v, n - 1)) / (2 * step), exact = at(a, n);
    gap = std::max(gap, (difference - exact).norm());
    size = std::max(size, exact.norm());
  }
  return gap / size;
}

/// So soft that the steps resolve its highest frequency.
TEST_P(Responses, AccelerationsAreTheRatesOfVelocitiesToSecondOrder) {
  Mechanism m = machine(GetParam());
  for (BodySpec& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->material.E *= 1e-3;
  for (const auto& [rate, acceleration] :
       {std::pair{ResponseKind::Velocity, ResponseKind::Acceleration},
        {ResponseKind::AngularVelocity, ResponseKind::AngularAcceleration}}) {
    const double coarse = gap_of_accelerations(m, 1e-5, rate, acceleration),
                 fine = gap_of_accelerations(m, 5e-6, rate, acceleration);
    EXPECT_LT(fine, 0.02) << name_of(acceleration);
    if (coarse > 1e-5) {  // else what Newton's method leaves
      EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << name_of(acceleration) << " " << coarse;
    }
  }
}

TEST_P(Responses, HaveTheirGradientsInSpace) {
  const Mechanism m = machine(GetParam());
  const auto run = test::run_spatial(m, options(0.03, 5e-4));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  // Out of the plane, too.
  test::Random random(3);
  const State<SE3> s = Direction<SE3>(*run.model, random).from(*run.model, in_motion(run), 1e-3);
  expect_gradients(m, *run.model, s, responses(false));
}

INSTANTIATE_TEST_SUITE_P(EveryFormalism, Responses,
                         ::testing::Values(Formalism::SE3, Formalism::R3SO3, Formalism::Classical,
                                           Formalism::Floating, Formalism::Rigid),
                         [](const auto& of) { return std::string(to_string(of.param)); });

/// With a rigid interface "mid" at the nodes with x = 0.5, between its ends.
test::MeshModel with_middle(const SolidModel& part) {
  std::vector<Interface> interfaces = part.interfaces();
  const auto middle = [](const auto& x) { return std::abs(x[0] - 0.5) < 1e-9; };
  interfaces.insert(interfaces.begin() + 1,
                    {"mid", nodes_where(part.mesh(), middle), {0.5, 0.1, 0}, Tie::Rigid});
  return std::make_shared<const SolidModel>(part.mesh(), part.material(), interfaces,
                                            SolidModel::Options{part.thickness(), {}});
}

/// A meshed part that swings on a hinge.
template <class G>
Mechanism swinging_part() {
  SolidSpec s;
  s.model = test::mesh_with_ends(G::space_dim == 2 ? quad_grid({0, 0}, {1, 0.2}, 12, 4)
                                                   : hex_grid({0, 0, 0}, {1, 0.2, 0.1}, 8, 3, 2),
                                 {"soft", 1e7, 0.3, 1000}, {0, 0.1, 0}, {1, 0.1, 0}, {0.1, {}});
  s.model = with_middle(*s.model);
  s.modes = 4;
  Mechanism m;
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"part", s}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  return m;
}

template <class G>
void expect_gradients_of_a_part() {
  const Mechanism m = swinging_part<G>();
  const auto run = test::run<G>(m, {}, options(0.3, 2e-3));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  test::Random random(7);
  const State<G> s = Direction<G>(*run.model, random).from(*run.model, in_motion(run), 0.05);
  std::vector<ResponseSpec> all;
  for (const auto kind :
       {ResponseKind::Position, ResponseKind::Velocity, ResponseKind::Acceleration,
        ResponseKind::Displacement, ResponseKind::Deflection, ResponseKind::Elongation,
        ResponseKind::Energy, ResponseKind::Compliance, ResponseKind::Stress}) {
    ResponseSpec r;
    r.name = name_of(kind);
    r.kind = kind;
    r.body = 0;
    r.s = 0.5;
    r.at = {0, 2};
    r.to = {0, 0};
    all.push_back(r);
  }
  expect_gradients(m, *run.model, s, all);
}

TEST(Responses, OfAMeshedPartHaveTheirGradients) {
  expect_gradients_of_a_part<SE2>();
  expect_gradients_of_a_part<SE3>();
}

/// The same part with all nodes of its mesh.
template <class G>
void expect_gradients_of_a_continuum(SolidLaw law) {
  Mechanism m = swinging_part<G>();
  auto& part = std::get<SolidSpec>(m.bodies[0].kind);
  part.as = SolidMotion::Continuum;
  part.law = law;
  const auto run = test::run<G>(m, {}, options(0.1, 2e-3));
  ASSERT_EQ(run.report().status, SolveStatus::Converged) << run.report().reason;
  test::Random random(7);
  const State<G> s = Direction<G>(*run.model, random).from(*run.model, in_motion(run), 1e-3);
  std::vector<ResponseSpec> all;
  for (const auto kind : {ResponseKind::Stress, ResponseKind::Compliance, ResponseKind::Energy}) {
    all.emplace_back();
    all.back().kind = kind;
    all.back().name = name_of(kind);
    all.back().body = 0;
  }
  expect_gradients(m, *run.model, s, all);
}

TEST(Responses, OfAContinuumHaveTheirGradients) {
  for (const SolidLaw law : {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean}) {
    expect_gradients_of_a_continuum<SE2>(law);
    expect_gradients_of_a_continuum<SE3>(law);
  }
}

/// A rigid motion of the whole, h_k = Ad(H_k^-1) e, does not change what is measured inside.
TEST_P(Responses, InsideABodyDoNotSeeRigidMotions) {
  const Mechanism m = machine(GetParam());
  const auto run = test::run_spatial(m, options(0.03, 5e-4));
  const State<SE3> s = in_motion(run);
  const ResponseValues<SE3> values(m, *run.model);
  int compared = 0;
  for (const ResponseSpec& r : responses(false)) {
    const bool inside =
        (r.kind == ResponseKind::Displacement && r.in == Axes::Body) ||
        r.kind == ResponseKind::Deflection ||
        (r.kind == ResponseKind::Elongation && r.to.body >= 0) ||
        r.kind == ResponseKind::SectionForce || r.kind == ResponseKind::Stress ||
        r.kind == ResponseKind::Compliance ||
        (r.kind == ResponseKind::JointForce && r.joint == 1 && (!r.axis || r.in == Axes::Body));
    if (!inside) continue;
    for (const auto& gradient : values.gradient(r, s)) {
      SE3::Tangent sum = SE3::Tangent::Zero();
      double size = 0;
      for (const auto& node : gradient.nodes) {
        const auto& frames = run.model->frames();
        if (std::find(frames.begin(), frames.end(), node.node) == frames.end()) continue;
        const SE3::Tangent g = s.H[std::size_t(node.node)].AdInv().transpose() * node.h;
        sum += g;
        size += g.norm();
      }
      compared += size > 0;
      EXPECT_LE(sum.norm(), 1e-10 * size + 1e-12) << r.name << " " << to_string(m.formalism);
    }
  }
  EXPECT_GE(compared, 1);
}

/// dy/dp at constant state, of rebuilt models.
TEST_P(Responses, HaveTheirExplicitDerivativesByTheLaw) {
  const Mechanism m = machine(GetParam());
  if (GetParam() == Formalism::Floating) return;  // rebuilt modes are other coordinates
  const auto run = test::run_spatial(m, options(0.03, 5e-4));
  const State<SE3> s = in_motion(run);
  const ForceDerivative spring{1, 7, 0, -0.2, 0};
  const ForceDerivative inside{2, 5, 0.4, -0.1, 0};
  const Parameter both{"both", {by_dimension(m, 1, {1, 2}, "diameter"), spring, inside}};
  const ParameterResidual<SE3> parameter(m, *run.model, both);
  for (const ResponseSpec& r : responses(false)) {
    const VectorXd exact = ResponseValues<SE3>(m, *run.model).by_parameter(r, s, parameter);
    const auto at = [&](double p) -> VectorXd {
      Mechanism changed = m;
      for (std::size_t e : {1u, 2u})
        std::get<Circle>(std::get<BeamSpec>(changed.bodies[1].kind).sections[e].shape).diameter +=
            p;
      changed.forces[1].stiffness += 7 * p;
      changed.forces[1].rest -= 0.2 * p;
      changed.forces[2].stiffness += 5 * p;
      changed.forces[2].damping += 0.4 * p;
      changed.forces[2].rest -= 0.1 * p;
      const auto model = Model<SE3>::build(changed, {});
      return ResponseValues<SE3>(changed, model)(r, s);
    };
    const double size = exact.cwiseAbs().maxCoeff();
    if (size == 0) {
      EXPECT_EQ((at(1e-3) - at(-1e-3)).norm(), 0) << r.name;
      continue;
    }
    const auto difference = test::central_first(at, 0);
    test::expect_second_order(difference, exact, VectorXd::Constant(exact.size(), size), 5e-4, 1e-8,
                              r.name);
    const VectorXd fourth_order = (4 * difference(1e-5) - difference(2e-5)) / 3;
    EXPECT_LT((fourth_order - exact).norm(), 1e-7 * size) << r.name;
  }
}

}  // namespace
}  // namespace liesl::test::response_test
