/// @file
/// Equivalent static loads: they give the deformation back, they balance each other, they do not
/// know where in space the mechanism runs.
#include "esl/load_set.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "esl/static_part.hpp"
#include "mbs/motion.hpp"

namespace liesl::test::load_set_test {
namespace {

using test::Motion;

constexpr int kCrank = 0, kRod = 1;

Mechanism slider_crank(double E = 210e9) {
  Mechanism m = test::slider_crank();
  m.gravity = {0, -9.81, 0};
  for (const int body : {kCrank, kRod}) std::get<BeamSpec>(m.bodies[body].kind).material.E = E;
  return m;
}

template <FrameGroup G>
Motion<G> run(const Mechanism& m, double step = 1e-4) {
  return Motion<G>(m, test::options(0.06, step));
}

template <class G>
class Loads : public testing::Test {};
using Groups = testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(Loads, Groups);

/// The identity is that of the law, not of the element: of both orders.
TYPED_TEST(Loads, GiveTheDeformationBackInTheNonlinearProblem) {
  for (const int order : {2, 4}) {
    Mechanism m = slider_crank();
    for (const int body : {kCrank, kRod}) std::get<BeamSpec>(m.bodies[body].kind).order = order;
    const auto motion = run<TypeParam>(m);
    ASSERT_TRUE(motion.good());
    for (const int body : {kCrank, kRod}) {
      const LoadSet loads = extract_loads(motion.model, motion.trajectory(), body);
      const Identity identity = check_identity(motion.model, motion.trajectory(), loads, 20);
      EXPECT_GE(identity.cases, 18);
      EXPECT_LT(identity.nonlinear, order == 2 ? 1e-10 : 1e-9) << body;
      EXPECT_GT(identity.linear, 1e-7) << "the linear problem is another one";
    }
  }
}

/// Of crank and rod by the nonlinear problem to 1e-9, by the linear one not.
template <FrameGroup G>
void expect_identity_of_chains(const Mechanism& m) {
  const auto motion = run<G>(m);
  ASSERT_TRUE(motion.good());
  for (const int body : {kCrank, kRod}) {
    const LoadSet loads = extract_loads(motion.model, motion.trajectory(), body);
    const Identity identity = check_identity(motion.model, motion.trajectory(), loads, 20);
    EXPECT_GE(identity.cases, 18);
    EXPECT_LT(identity.nonlinear, 1e-9) << body;
    EXPECT_GT(identity.linear, 1e-7) << "the linear problem is another one";
    EXPECT_LT(identity.linear, 0.3) << "0.24 for the same rod of beam elements, in the plane";
  }
}

/// A chain of segments: loads in the axes of points, which turn with it.
TEST(SegmentLoads, GiveTheDeformationBackInTheNonlinearProblem) {
  Mechanism m = slider_crank();
  m.formalism = Formalism::Segments;
  expect_identity_of_chains<SE2>(m);
}

/// Bends chains out of the plane, too.
Mechanism spatial_chains(Mechanism m) {
  m.formalism = Formalism::Segments;
  m.gravity = {0, -9.81, 30};
  return m;
}

/// A heavy pendulum on a spherical joint, thrown sideways: its chain bends both ways.
Mechanism spherical_pendulum() {
  Mechanism m = spatial_chains(test::pendulum(8));
  m.joints[0].type = JointType::Spherical;
  m.bodies[0].angular_velocity = {0, 3, 0};
  std::get<BeamSpec>(m.bodies[0].kind).material.E *= 100;
  return m;
}

/// In space a chain has stresses at its nodes, and its ends spin freely: the joints of the motion
/// turn them against each other, which no load of the static problem does.
TEST(SegmentLoads, GiveTheDeformationBackInSpace) {
  expect_identity_of_chains<SE3>(spatial_chains(slider_crank()));
}

template <FrameGroup G>
void expect_identity_of_a_pendulum(const Mechanism& m) {
  const Motion<G> motion(m, test::options(1, 1e-3));
  ASSERT_TRUE(motion.good());
  const LoadSet loads = extract_loads(motion.model, motion.trajectory(), 0);
  const Identity identity = check_identity(motion.model, motion.trajectory(), loads, 20);
  EXPECT_GE(identity.cases, 18);
  EXPECT_LT(identity.nonlinear, 1e-9);
  EXPECT_GT(identity.linear, 1e-3) << "the linear problem is another one";
}

TEST(SegmentLoads, GiveTheDeformationOfASphericalPendulumBack) {
  expect_identity_of_a_pendulum<SE3>(spherical_pendulum());
}

/// It bends by a tenth of its length, of segments as of elements.
TEST(SegmentLoads, GiveTheDeformationOfAPendulumThatBendsFarBack) {
  Mechanism m = test::pendulum(16);
  expect_identity_of_a_pendulum<SE2>(m);
  m.formalism = Formalism::Segments;
  expect_identity_of_a_pendulum<SE2>(m);
  expect_identity_of_a_pendulum<SE3>(m);
}

/// Largest sum of the forces and moments about the first node of a body, over the largest load.
template <FrameGroup G>
double unbalanced(const Motion<G>& motion, int body) {
  const LoadSet loads = extract_loads(motion.model, motion.trajectory(), body);
  double largest = 0;
  for (int n = 0; n < loads.f.cols(); ++n) {
    const G* at = motion.trajectory().frames(n) + motion.model.first_node(body);
    const Body<G>& part = *motion.model.bodies[std::size_t(body)];
    Frames<G> H(at, at + part.nodes());
    part.settle_spin(H.data());
    typename G::Tangent sum = G::Tangent::Zero();
    for (int k = 0; k < part.nodes(); ++k)
      sum += (H[k].inverse() * H[0]).Ad().transpose() *
             loads.f.col(n).template segment<G::dim>(G::dim * k);
    largest = std::max(largest, sum.norm());
  }
  return largest / loads.f.cwiseAbs().maxCoeff();
}

TYPED_TEST(Loads, BalanceEachOtherInTheDeformedShape) {
  EXPECT_LT(unbalanced(run<TypeParam>(slider_crank()), kRod), 1e-11);
}

TEST(SegmentLoads, BalanceEachOtherInTheDeformedShape) {
  EXPECT_LT(unbalanced(run<SE3>(spatial_chains(slider_crank())), kRod), 1e-11);
  const Motion<SE3> bent(spherical_pendulum(), test::options(0.5, 1e-3));
  EXPECT_LT(unbalanced(bent, 0), 1e-11);
}

/// Largest error of the strains of K_t u = f over the motion, relative to the largest strain of the
/// motion. Not to the strain of the same instant: an axial force N on a rod with almost no bending
/// adds N L^2/(pi^2 EI) of that little bending in the deformed shape, which no linear problem
/// knows.
struct LinearError {
  double strain = 0, error = 0;
};

template <FrameGroup G>
LinearError linear_error(const Mechanism& m) {
  const auto motion = run<G>(m);
  const LoadSet loads = extract_loads(motion.model, motion.trajectory(), kRod);
  const auto& beam = dynamic_cast<const Beam<G>&>(*motion.model.bodies[kRod]);
  Eigen::MatrixXd C(beam.size(), 0);
  typename StaticPart<G>::Law K;
  for (int e = 0; e < beam.elements(); ++e) {
    const Eigen::MatrixXd c = StaticPart<G>::strain_output(beam, e);
    C.conservativeResize(beam.size(), C.cols() + G::dim);
    C.rightCols(G::dim) = c;
    K.push_back(beam.element(e).section_stiffness());
  }
  StaticPart<G> part(beam, read_support({}, motion.mechanism, motion.model, kRod), C);
  part.set_loads(loads.f);
  EXPECT_TRUE(part.solve(K));
  LinearError result;
  State<G> s = motion.model.initial_state();
  for (int n = 0; n < motion.trajectory().size(); ++n) {
    motion.trajectory().read(n, s);
    for (int e = 0; e < beam.elements(); ++e) {
      const auto eps = beam.strain(motion.model.body_state(s, kRod), e);
      const auto linear = part.y().col(n).template segment<G::dim>(G::dim * e);
      result.strain = std::max(result.strain, eps.cwiseAbs().maxCoeff());
      result.error = std::max(result.error, (linear - eps).cwiseAbs().maxCoeff());
    }
  }
  result.error /= result.strain;
  return result;
}

TYPED_TEST(Loads, GiveTheDeformationBackToFirstOrderInStrainInTheLinearProblem) {
  // The stiffer, the smaller the strain; the motion stays about the same.
  const LinearError soft = linear_error<TypeParam>(slider_crank(8.4e11));
  const LinearError stiff = linear_error<TypeParam>(slider_crank(8.4e13));
  const double slope = std::log(soft.error / stiff.error) / std::log(soft.strain / stiff.strain);
  EXPECT_GT(soft.strain / stiff.strain, 10);
  EXPECT_NEAR(slope, 1, 0.15) << soft.strain << " " << soft.error << ", " << stiff.strain << " "
                              << stiff.error;
}

TYPED_TEST(Loads, DoNotChangeWhenTheSceneIsMoved) {
  const SE3 g = SE3::exp((SE3::Tangent() << 0.1, -0.2, 0.15, 0.9, -0.4, 1.3).finished());
  const auto here = run<TypeParam>(slider_crank());
  const auto there = run<TypeParam>(test::moved(slider_crank(), g));
  ASSERT_TRUE(here.good() && there.good());
  for (const int body : {kCrank, kRod}) {
    const LoadSet a = extract_loads(here.model, here.trajectory(), body);
    const LoadSet b = extract_loads(there.model, there.trajectory(), body);
    EXPECT_LT((a.f - b.f).norm(), 1e-9 * a.f.norm()) << body;
  }
}

TEST(LoadSets, ArePlanarAsInSpace) {
  const Mechanism m = slider_crank();
  const auto plane = run<SE2>(m);
  const auto space = run<SE3>(m);
  const LoadSet flat = extract_loads(plane.model, plane.trajectory(), kRod);
  const LoadSet full = extract_loads(space.model, space.trajectory(), kRod);
  const auto& beam = std::get<BeamSpec>(m.bodies[kRod].kind);
  Eigen::MatrixXd lifted(full.f.rows(), full.f.cols());
  for (int k = 0; k < static_cast<int>(beam.nodes.size()); ++k)
    for (int n = 0; n < full.f.cols(); ++n)
      lifted.col(n).segment<6>(6 * k) = plane.model.space.embed_local(
          flat.f.col(n).segment<3>(3 * k), plane.model.space.alignment(beam.nodes[k]));
  EXPECT_LT((lifted - full.f).norm(), 1e-9 * full.f.norm());
}

TEST(LoadSets, ChangeIsRelativeWithMomentsOverLength) {
  LoadSet before{0, {0, 1}, Eigen::MatrixXd::Zero(3, 2)}, after = before;
  before.f << 3, 0, 4, 0, 0, 10;  // sizes 5 and 10/2 = 5
  after.f = before.f;
  after.f(0, 0) += 1;
  after.f(2, 1) += 2;  // 2 N m over 2 m
  EXPECT_DOUBLE_EQ(load_change({after}, {before}, 3, 2, 2.0), 0.2);
  EXPECT_EQ(load_change({before}, {before}, 3, 2, 2.0), 0);
  LoadSet shorter{0, {0}, Eigen::MatrixXd::Zero(3, 1)};
  EXPECT_THROW(load_change({shorter}, {before}, 3, 2, 2.0), std::invalid_argument);
  EXPECT_THROW(load_change({}, {before}, 3, 2, 2.0), std::invalid_argument);
}

TEST(LoadSets, RigidBodiesHaveNone) {
  const auto motion = run<SE2>(slider_crank(), 1e-3);
  EXPECT_THROW(extract_loads(motion.model, motion.trajectory(), 2), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::load_set_test
