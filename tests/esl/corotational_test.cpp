/// @file
/// Internal forces by a reference stiffness in the frames of the elements.
#include "esl/corotational.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mbs/system/state.hpp"

namespace liesl::test::corotational_test {
namespace {

template <FrameGroup G>
struct Bent {
  ReissnerBeam<G> beam;
  Frames<G> H;
};

/// A straight beam of 1 m along x, bent (and in space twisted and bent both ways) by `size`, moved
/// as a whole by `motion`.
template <FrameGroup G>
Bent<G> bent(int elements, double size, const G& motion) {
  using Tangent = typename G::Tangent;
  std::vector<G> rest;
  for (int k = 0; k <= elements; ++k) {
    G X = G::identity();
    X.x[0] = static_cast<double>(k) / elements;
    rest.push_back(X);
  }
  ElementSection<G> section{G::Matrix::Identity(), G::Matrix::Identity()};
  for (int i = 0; i < G::dim; ++i) section.K(i, i) = i < G::space_dim ? 1e4 : 10.0 + i;
  Bent<G> out{ReissnerBeam<G>("bent", rest, std::vector(std::size_t(elements), section), 0), {}};
  constexpr int fine = 64;  // steps an element: the same curve for every mesh
  G H = motion;
  out.H.push_back(H);
  for (int i = 0; i < elements * fine; ++i) {
    const double s = (i + 0.5) / (elements * fine);
    Tangent d = Tangent::Zero();
    d[0] = 1 + 1e-3 * size * std::cos(2 * s);
    for (int r = G::space_dim; r < G::dim; ++r) d[r] = size * std::sin(3 * s + r);
    H = H * G::exp(Tangent(d / (elements * fine)));
    if ((i + 1) % fine == 0) out.H.push_back(H);
  }
  return out;
}

template <FrameGroup G>
Eigen::VectorXd corotational(const Bent<G>& b) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(b.beam.size());
  add_corotational_force(b.beam, b.H.data(), f.data());
  return f;
}

template <FrameGroup G>
Eigen::VectorXd internal(const Bent<G>& b) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(b.beam.size());
  Eigen::VectorXd f = rest;
  ForceScale scale;
  b.beam.add_internal({b.H.data(), rest.data(), rest.data()}, f.data(), scale);
  return f;
}

template <class G>
struct CorotationalForces : ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(CorotationalForces, Groups);

template <FrameGroup G>
G motion() {
  typename G::Tangent h;
  for (int i = 0; i < G::dim; ++i) h[i] = std::cos(1.0 + i);
  return G::exp(h);
}

TYPED_TEST(CorotationalForces, DoNotSeeRigidMotions) {
  using G = TypeParam;
  const auto here = corotational(bent<G>(6, 0.8, G::identity()));
  const auto there = corotational(bent<G>(6, 0.8, motion<G>()));
  EXPECT_GT(here.norm(), 1);
  EXPECT_LT((here - there).norm(), 1e-10 * here.norm());
  EXPECT_LT(corotational(bent<G>(6, 0.0, motion<G>())).norm(), 1e-10 * here.norm());
}

template <FrameGroup G>
double off_internal(int elements) {
  const auto b = bent<G>(elements, 1.5, motion<G>());
  const Eigen::VectorXd exact = internal(b);
  return (corotational(b) - exact).norm() / exact.norm();
}

/// In the plane rotations commute: half of the bending before or after is the same.
TEST(CorotationalForce, IsTheInternalForceInThePlane) { EXPECT_LT(off_internal<SE2>(4), 1e-10); }

TEST(CorotationalForce, IsTheInternalForceInSpaceAsTheMeshRefines) {
  EXPECT_LT(off_internal<SE3>(32), 2.5e-5);
  EXPECT_NEAR(std::log2(off_internal<SE3>(16) / off_internal<SE3>(32)), 4, 0.1);
}

}  // namespace
}  // namespace liesl::test::corotational_test
