/// Facts particular to rotations and frames, beyond the suite every group passes.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "liegroup/smallest_rotation.hpp"
#include "sampling.hpp"

namespace liesl::test::frames_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(SO3, HatAndVee) {
  const Eigen::Vector3d a(1, -2, 3), b(0.5, 4, -1);
  EXPECT_EQ(size_of(hat(a) * b - a.cross(b)), 0);
  EXPECT_EQ(size_of(vee(hat(a)) - a), 0);
  EXPECT_EQ(size_of(vee(Eigen::Matrix3d(hat(a) + b * b.transpose())) - a), 0);
}

/// Against a second algorithm, Eigen's by quaternions, of opposite and nearly opposite ones, too.
TEST(SO3, SmallestRotationTakesOneDirectionToTheOther) {
  Rng rng(3);
  for (const double off : {1., 1e-3, 1e-6, 0.}) {
    const Eigen::Vector3d a = direction<3>(rng), side = a.cross(direction<3>(rng)).normalized();
    for (const double along : {1., -1.}) {
      const Eigen::Vector3d b = (along * a + off * side).normalized();
      const Eigen::Matrix3d R = smallest_rotation(a, b);
      EXPECT_LE(size_of(R * a - b), 1e-9) << along << " " << off;
      EXPECT_LE(size_of(R.transpose() * R - Eigen::Matrix3d::Identity()), 1e-9);
      EXPECT_NEAR(R.determinant(), 1, 1e-9);
      if (along < 0 && off < 1e-2) continue;  // the axis of Eigen's is any one there
      EXPECT_LE(size_of(R - Eigen::Quaterniond::FromTwoVectors(a, b).toRotationMatrix()), 1e-14);
    }
  }
}

/// exp against a second formalism, Eigen's angle-axis rotation.
TEST(SO3, ExpIsTheRotationAboutTheAxis) {
  Rng rng(1);
  for (double angle : {1e-9, 0.3, 2.0, 3.1, 3.3, 5.0, 9.0}) {
    const Eigen::Vector3d n = direction<3>(rng);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, n).toRotationMatrix();
    EXPECT_LE(size_of(SO3::exp(angle * n).R - R), 3e-15) << angle;
  }
}

/// Every pivot of the quaternion branch: axes near each coordinate axis, both signs.
TEST(SO3, LogOfLargeRotationsAboutEveryAxis) {
  Rng rng(2);
  for (int axis = 0; axis < 3; ++axis) {
    for (double sign : {-1.0, 1.0}) {
      for (double gap : {1.5, 1.0, 0.5, 0.1, 1e-3, 1e-6, 1e-9}) {
        const Eigen::Vector3d n =
            (sign * Eigen::Vector3d::Unit(axis) + 0.3 * direction<3>(rng)).normalized();
        const Eigen::Vector3d w = (kPi - gap) * n;
        EXPECT_LE(size_of(SO3::log(SO3::exp(w)) - w), 5e-15) << axis << sign << gap;
      }
    }
  }
}

/// Rotations past pi come back as the shorter one, the other way round.
TEST(SO3, LogPastPi) {
  const Eigen::Vector3d n = Eigen::Vector3d(2, -1, 2) / 3;
  EXPECT_LE(size_of(SO3::log(SO3::exp((kPi + 0.2) * n)) + (kPi - 0.2) * n), 5e-15);
}

/// At pi one of the two logarithms is returned, never NaN.
TEST(SO3, LogAtPi) {
  const Eigen::Matrix3d turns[] = {
      Eigen::Vector3d(1, -1, -1).asDiagonal(), Eigen::Vector3d(-1, 1, -1).asDiagonal(),
      Eigen::Vector3d(-1, -1, 1).asDiagonal(), SO3::exp(kPi * Eigen::Vector3d(2, -1, 2) / 3).R};
  for (const Eigen::Matrix3d& R : turns) {
    const Eigen::Vector3d w = SO3::log(R);
    EXPECT_NEAR(w.norm(), kPi, 1e-15);
    EXPECT_LE(size_of(SO3::exp(w).R - R), 2e-15);
  }
}

/// Both sides of the switch between arcsine series and quaternion.
TEST(SO3, LogIsContinuousAtItsSwitch) {
  const double angle = std::asin(std::sqrt(trig::kArcsineSwitch));
  const Eigen::Vector3d n = Eigen::Vector3d(1, 2, -2) / 3;
  for (double f = 0.999; f <= 1.001; f += 1e-5)
    EXPECT_LE(size_of(SO3::log(SO3::exp(f * angle * n)) - f * angle * n), 2e-16) << f;
}

template <class G>
class Frames : public testing::Test {};
using FrameGroups = testing::Types<SE2, SE3, R3xSO3>;
TYPED_TEST_SUITE(Frames, FrameGroups);

TYPED_TEST(Frames, ConstructionAndAction) {
  using G = TypeParam;
  Rng rng(3);
  EXPECT_EQ(size_of(G{}.R - G::identity().R) + size_of(G{}.x), 0);
  const G A = G::exp(Sampler<G>::draw(rng, 1.2, 2.0)), copy{A.R, A.x};
  EXPECT_EQ(size_of(copy.R - A.R) + size_of(copy.x - A.x), 0);
  const auto p = direction<G::space_dim>(rng);
  // The same sums in another order: a few units of rounding.
  EXPECT_LE(size_of(A * p - (A.R * p + A.x)), 4 * 2.3e-16 * (1 + size_of(A.x)));
}

/// The Newton step is quadratic: an error of 1e-4 leaves about 1e-8, two steps leave rounding.
TYPED_TEST(Frames, Orthonormalize) {
  using G = TypeParam;
  Rng rng(4);
  const G A = G::exp(Sampler<G>::draw(rng, 1.2, 2.0));
  G B = A;
  B.R += 1e-4 * (A.R + A.R * A.R.transpose() + B.R.row(0).transpose() * B.R.row(0)).eval();
  const auto defect = [](const G& H) {
    return size_of(H.R.transpose() * H.R - decltype(H.R)::Identity());
  };
  EXPECT_GT(defect(B), 1e-4);
  B.orthonormalize();
  EXPECT_LT(defect(B), 2e-7);
  B.orthonormalize();
  EXPECT_LT(defect(B), 1e-13);
  B.orthonormalize();
  EXPECT_LT(defect(B), 1e-15);
  EXPECT_EQ(size_of(B.x - A.x), 0);
  G C = A;
  C.orthonormalize();
  EXPECT_LE(size_of(C.R - A.R), 1e-15);
}

/// Selection [u_x, u_y, w] of the 6 components of SE(3).
Eigen::Matrix<double, 6, 3> plane() {
  Eigen::Matrix<double, 6, 3> S = Eigen::Matrix<double, 6, 3>::Zero();
  S(0, 0) = S(1, 1) = S(5, 2) = 1;
  return S;
}

SE3 embed(const SE2& H) {
  SE3 K;
  K.R.topLeftCorner<2, 2>() = H.R;
  K.x.head<2>() = H.x;
  return K;
}

/// SE(2) is SE(3) restricted to the plane, operator by operator.
TEST(SE2, IsThePlaneOfSE3) {
  Rng rng(5);
  const auto S = plane();
  const auto in_plane = [&](const SE3::Matrix& M) {
    return Eigen::Matrix3d(S.transpose() * M * S);
  };
  for (double angle : angle_sweep()) {
    const Eigen::Vector3d h = Sampler<SE2>::draw(rng, angle, 1.0), a = direction<3>(rng);
    const SE3::Tangent hs = S * h, as = S * a;
    const SE2 H = SE2::exp(h);
    const SE3 K = SE3::exp(hs);
    EXPECT_LE(size_of(embed(H).R - K.R) + size_of(embed(H).x - K.x), 2e-15);
    EXPECT_LE(size_of(S * SE2::log(H) - SE3::log(K)), 5e-15);
    EXPECT_LE(size_of(H.Ad() - in_plane(K.Ad())), 3e-15);
    EXPECT_LE(size_of(H.AdInv() - in_plane(K.AdInv())), 3e-15);
    EXPECT_LE(size_of(SE2::ad(h) - in_plane(SE3::ad(hs))), 0);
    EXPECT_LE(size_of(SE2::T(h) - in_plane(SE3::T(hs))), 2e-15);
    EXPECT_LE(size_of(SE2::Tinv(h) - in_plane(SE3::Tinv(hs))), 2e-15);
    EXPECT_LE(size_of(SE2::dT(h, a) - in_plane(SE3::dT(hs, as))), 2e-15);
    EXPECT_LE(size_of(SE2::dTinv(h, a) - in_plane(SE3::dTinv(hs, as))), 2e-15);
    EXPECT_LE(size_of(SE2::dTinvT(h, a) - in_plane(SE3::dTinvT(hs, as))), 2e-15);
  }
}

/// Straight element: D = ad([L, 0...]) with D^2 = 0 gives T^-1 = I + D/2 exactly.
TEST(SE3, StraightElement) {
  const SE3::Tangent d = 0.7 * SE3::Tangent::Unit(0);
  const SE3::Matrix D = SE3::ad(d);
  EXPECT_EQ(size_of(D * D), 0);
  EXPECT_EQ(size_of(SE3::Tinv(d) - SE3::Matrix::Identity() - 0.5 * D), 0);
}

/// Translations of SE(3) are local, those of R^3 x SO(3) inertial.
TEST(R3xSO3, TranslationIsInertial) {
  const Eigen::Matrix3d quarter = SO3::exp(Eigen::Vector3d(0, 0, kPi / 2)).R;
  SE3::Tangent along_x = SE3::Tangent::Unit(0);
  const SE3 A = SE3(quarter, Eigen::Vector3d::Zero()) * SE3::exp(along_x);
  const R3xSO3 B = R3xSO3(quarter, Eigen::Vector3d::Zero()) * R3xSO3::exp(along_x);
  EXPECT_LE(size_of(A.x - Eigen::Vector3d(0, 1, 0)), 1e-15);
  EXPECT_LE(size_of(B.x - Eigen::Vector3d(1, 0, 0)), 1e-15);
}

/// Half a turn on a circle of radius r: the frame ends at (0, 2r), turned by w.
TEST(SE3, ScrewMotionIsAnArc) {
  const double r = 3, angle = 3.0;
  SE3::Tangent h = SE3::Tangent::Zero();
  h[0] = r * angle;
  h[5] = angle;
  const SE3 H = SE3::exp(h);
  EXPECT_LE(size_of(H.x - r * Eigen::Vector3d(std::sin(angle), 1 - std::cos(angle), 0)), 5e-15);
}

TEST(ProductGroup, StacksItsFactors) {
  using P = Product<SE2, Rn<2>>;
  static_assert(LieGroup<P> && P::dim == 5 && P::offset<1>() == 3);
  P::Tangent h;
  h << 0.1, 0.2, 0.3, 4, 5;
  const P H = P::exp(h);
  EXPECT_EQ(size_of(H.get<1>().x - Eigen::Vector2d(4, 5)), 0);
  EXPECT_EQ(size_of(H.get<0>().R - SE2::exp({0.1, 0.2, 0.3}).R), 0);
  EXPECT_EQ(size_of(P::T(h).topLeftCorner<3, 3>() - SE2::T({0.1, 0.2, 0.3})), 0);
  EXPECT_EQ(size_of(P(SE2(), Rn<2>({1, 2})).get<1>().x - Eigen::Vector2d(1, 2)), 0);
}

}  // namespace
}  // namespace liesl::test::frames_test
