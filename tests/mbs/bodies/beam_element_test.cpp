/// @file
/// Identities of the beam element on SE(2) and SE(3).

#include "mbs/bodies/beam_element.hpp"

#include <Eigen/LU>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/bodies/linear_cantilever.hpp"
#include "mbs/run.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::beam_element_test {
namespace {

using test::Random;

template <class G>
using TangentOf = typename G::Tangent;
template <class G>
using PairOf = typename BeamElement<G>::Pair;
template <class G>
using PairMatrixOf = typename BeamElement<G>::PairMatrix;

template <class G>
class BeamElementTest : public ::testing::Test {
 protected:
  static constexpr int size = G::dim;

  BeamElementTest()
      : A_at_rest(G::exp(TangentOf<G>(random.vector(size)))),
        B_at_rest(A_at_rest * G::exp(curved_d0())),
        element(A_at_rest, B_at_rest, random.spd(size), random.spd(size)),
        A_now(A_at_rest * G::exp(TangentOf<G>(0.3 * random.vector(size)))),
        B_now(B_at_rest * G::exp(TangentOf<G>(0.3 * random.vector(size)))) {}

  TangentOf<G> curved_d0() {
    TangentOf<G> d = 0.4 * random.vector(size);
    d[0] = 1.2;
    return d;
  }
  static TangentOf<G> straight_d0(double L) { return L * TangentOf<G>::Unit(0); }
  static G moved(const G& H, const PairOf<G>& h, int node) {
    return H * G::exp(TangentOf<G>(h.template segment<size>(size * node)));
  }
  PairOf<G> force(const G& a, const G& b) const {
    PairOf<G> g;
    element.internal_force(a, b, nullptr, 0, g);
    return g;
  }
  TangentOf<G> stress(const G& a, const G& b) const {
    return element.section_stiffness() * element.strain(a, b);
  }
  double energy(const G& a, const G& b) const {
    const TangentOf<G> eps = element.strain(a, b);
    return 0.5 * element.length() * eps.dot(element.section_stiffness() * eps);
  }
  static PairMatrixOf<G> swapped(const PairMatrixOf<G>& m) {
    PairMatrixOf<G> s;
    s << m.template bottomRightCorner<size, size>(), m.template bottomLeftCorner<size, size>(),
        m.template topRightCorner<size, size>(), m.template topLeftCorner<size, size>();
    return s;
  }

  Random random{1};
  G A_at_rest, B_at_rest;
  BeamElement<G> element;
  G A_now, B_now;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(BeamElementTest, Groups);

TYPED_TEST(BeamElementTest, ForceIsTheGradientOfTheEnergy) {
  using Pair = PairOf<TypeParam>;
  const Pair g = this->force(this->A_now, this->B_now);
  const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
    Eigen::VectorXd d(g.size());
    for (int j = 0; j < g.size(); ++j) {
      const Pair e = h * Pair::Unit(j);
      const auto V = [&](const Pair& p) {
        return this->energy(this->moved(this->A_now, p, 0), this->moved(this->B_now, p, 1));
      };
      d[j] = (V(e) - V(-e)) / (2 * h);
    }
    return d;
  };
  test::expect_second_order(difference, g, Eigen::VectorXd::Constant(g.size(), g.norm()), 2e-3,
                            2e-9, "force");
  EXPECT_LT((difference(1e-5) - g).norm(), 2e-9 * g.norm());
}

TYPED_TEST(BeamElementTest, TangentIsTheDerivativeOfTheForce) {
  using Pair = PairOf<TypeParam>;
  const auto K =
      this->element.tangent(this->A_now, this->B_now, this->stress(this->A_now, this->B_now))
          .eval();
  const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
    Eigen::MatrixXd d(K.rows(), K.cols());
    for (int j = 0; j < K.cols(); ++j) {
      const Pair e = h * Pair::Unit(j);
      const auto g = [&](const Pair& p) {
        return this->force(this->moved(this->A_now, p, 0), this->moved(this->B_now, p, 1));
      };
      d.col(j) = (g(e) - g(-e)) / (2 * h);
    }
    return d.reshaped();
  };
  test::expect_second_order(difference, K.reshaped(), Eigen::VectorXd::Constant(K.size(), K.norm()),
                            2e-3, 1e-10, "tangent");
}

TYPED_TEST(BeamElementTest, ConstantTangentIsExactAtTheReference) {
  const auto K = this->element.constant_tangent();
  const auto exact =
      this->element.tangent(this->A_at_rest, this->B_at_rest, TypeParam::Tangent::Zero());
  EXPECT_LT((K - exact).norm(), 1e-13 * K.norm());
  EXPECT_LT((K - K.transpose()).norm(), 1e-14 * K.norm());
}

TYPED_TEST(BeamElementTest, StraightElementHasTheClosedForm) {
  using Matrix = typename TypeParam::Matrix;
  const auto d0 = this->straight_d0(1.7);
  const Matrix D = TypeParam::ad(d0), I = Matrix::Identity();
  EXPECT_EQ((D * D).norm(), 0);
  const auto P = BeamElement<TypeParam>::P(d0);
  EXPECT_LT((P.template leftCols<TypeParam::dim>() + (I - D / 2)).norm(), 1e-15);
  EXPECT_LT((P.template rightCols<TypeParam::dim>() - (I + D / 2)).norm(), 1e-15);
}

TYPED_TEST(BeamElementTest, InterpolatesTheVelocity) {
  using G = TypeParam;
  using Tangent = typename G::Tangent;
  const auto v = PairOf<TypeParam>(this->random.vector(2 * G::dim));
  const auto at = [&](double s, double t) {
    const G a = this->moved(this->A_now, t * v, 0), b = this->moved(this->B_now, t * v, 1);
    return a * G::exp(s * G::log(a.inverse() * b));
  };
  const Tangent d = G::log(this->A_now.inverse() * this->B_now);
  for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const Tangent exact = BeamElement<TypeParam>::Q(d, s) * v;
    const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
      const G H = at(s, 0).inverse();
      return (G::log(H * at(s, h)) - G::log(H * at(s, -h))) / (2 * h);
    };
    test::expect_second_order(difference, exact,
                              Eigen::VectorXd::Constant(exact.size(), exact.norm()), 1e-2, 1e-9,
                              "velocity");
  }
}

TYPED_TEST(BeamElementTest, FrameIndifference) {
  using G = TypeParam;
  for (int i = 0; i < 20; ++i) {
    const G H = G::exp(typename G::Tangent(3 * this->random.vector(G::dim)));
    const auto n = this->stress(this->A_now, this->B_now);
    const auto K = this->element.tangent(this->A_now, this->B_now, n);
    EXPECT_LT((this->element.strain(H * this->A_now, H * this->B_now) -
               this->element.strain(this->A_now, this->B_now))
                  .norm(),
              1e-12);
    EXPECT_LT(
        (this->force(H * this->A_now, H * this->B_now) - this->force(this->A_now, this->B_now))
            .norm(),
        1e-12 * n.norm());
    EXPECT_LT((this->element.tangent(H * this->A_now, H * this->B_now, n) - K).norm(),
              1e-12 * K.norm());
  }
}

TYPED_TEST(BeamElementTest, RigidMotionHasNoStrain) {
  using G = TypeParam;
  for (int i = 0; i < 20; ++i) {
    const G H = G::exp(typename G::Tangent(3 * this->random.vector(G::dim)));
    EXPECT_LT(this->element.strain(H * this->A_at_rest, H * this->B_at_rest).norm(), 5e-15);
  }
}

TYPED_TEST(BeamElementTest, GyroscopicForceDoesNoWorkAndHasItsTangent) {
  using Pair = PairOf<TypeParam>;
  const auto gyroscopic = [&](const Pair& v) {
    Pair g;
    this->element.inertia_force(this->A_now, this->B_now, v.data(), Pair::Zero(), g);
    return g;
  };
  const Pair v = this->random.vector(2 * TypeParam::dim);
  EXPECT_LT(std::abs(v.dot(gyroscopic(v))), 1e-14 * v.norm() * gyroscopic(v).norm());
  const auto C = this->element.gyroscopic_tangent(this->A_now, this->B_now, v.data());
  for (int j = 0; j < C.cols(); ++j) {  // quadratic in v: central differences are exact
    const Pair e = Pair::Unit(j), d = (gyroscopic(v + e) - gyroscopic(v - e)) / 2;
    EXPECT_LT((C.col(j) - d).norm(), 1e-13 * C.norm());
  }
}

TYPED_TEST(BeamElementTest, PowerOfInertiaIsTheRateOfKineticEnergy) {
  using Pair = PairOf<TypeParam>;
  const Pair v = this->random.vector(2 * TypeParam::dim),
             a = this->random.vector(2 * TypeParam::dim);
  const auto M = this->element.mass();
  Pair g;
  this->element.inertia_force(this->A_now, this->B_now, v.data(), a, g);
  const auto kinetic = [&](double t) {
    const Pair w = v + t * a;
    return 0.5 * w.dot(M * w);
  };
  const double rate = (kinetic(0.5) - kinetic(-0.5));  // quadratic in t: the difference is exact
  EXPECT_NEAR(v.dot(g), rate, 1e-13 * v.norm() * g.norm());
}

TYPED_TEST(BeamElementTest, InternalForcesAreInEquilibrium) {
  constexpr int dim = TypeParam::dim;
  const auto g = this->force(this->A_now, this->B_now);
  const auto sum = (this->A_now.AdInv().transpose() * g.template head<dim>() +
                    this->B_now.AdInv().transpose() * g.template tail<dim>())
                       .eval();
  EXPECT_LT(sum.norm(), 1e-14 * g.norm() * 10);
}

TYPED_TEST(BeamElementTest, ReversedElementIsTheSame) {
  constexpr int dim = TypeParam::dim;
  const BeamElement<TypeParam> reversed(this->B_at_rest, this->A_at_rest,
                                        this->element.section_stiffness(),
                                        this->element.section_inertia());
  PairOf<TypeParam> g, r;
  const auto v = this->random.vector(2 * dim).eval();
  const auto w = (Eigen::VectorXd(2 * dim) << v.tail(dim), v.head(dim)).finished();
  this->element.internal_force(this->A_now, this->B_now, v.data(), 0.3, g);
  reversed.internal_force(this->B_now, this->A_now, w.data(), 0.3, r);
  EXPECT_NEAR(this->element.length(), reversed.length(), 1e-14);
  EXPECT_LT((g.template head<dim>() - r.template tail<dim>()).norm(), 1e-13 * g.norm());
  EXPECT_LT((g.template tail<dim>() - r.template head<dim>()).norm(), 1e-13 * g.norm());
  const auto M = this->element.mass();
  EXPECT_LT((M - this->swapped(reversed.mass())).norm(), 1e-13 * M.norm());
}

TYPED_TEST(BeamElementTest, DampingTakesThePowerOfTheStrainRate) {
  using Pair = PairOf<TypeParam>;
  const double damping = 0.02, h = 1e-5;
  const Pair v = this->random.vector(2 * TypeParam::dim);
  Pair damped;
  this->element.internal_force(this->A_now, this->B_now, v.data(), damping, damped);
  const auto strain = [&](double t) {
    return this->element.strain(this->moved(this->A_now, t * v, 0),
                                this->moved(this->B_now, t * v, 1));
  };
  const auto rate = ((strain(h) - strain(-h)) / (2 * h)).eval();
  const double power =
      damping * this->element.length() * rate.dot(this->element.section_stiffness() * rate);
  EXPECT_NEAR(v.dot(damped - this->force(this->A_now, this->B_now)), power, 1e-8 * power);
}

/// K_el of the linear Timoshenko element with one integration point, from its strains
/// eps = du/L, gamma_y = dv/L - mean(theta_z), gamma_z = dw/L + mean(theta_y), kappa = dtheta/L.
template <class G>
Eigen::MatrixXd timoshenko(const typename G::Matrix& K, double L) {
  constexpr int dim = G::dim;
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(dim, 2 * dim);
  B.leftCols(dim) = -Eigen::MatrixXd::Identity(dim, dim) / L;
  B.rightCols(dim) = Eigen::MatrixXd::Identity(dim, dim) / L;
  const int theta_z = dim - 1;
  B(1, theta_z) = B(1, dim + theta_z) = -0.5;
  if (dim == 6) B(2, 4) = B(2, 10) = 0.5;
  return L * B.transpose() * K * B;
}

TYPED_TEST(BeamElementTest, StraightStiffnessIsOnePointTimoshenko) {
  using G = TypeParam;
  const double L = 0.37;
  const G end = G::exp(this->straight_d0(L));
  const typename G::Matrix K = this->random.spd(G::dim), M = G::Matrix::Identity();
  const BeamElement<G> straight(G::identity(), end, K, M);
  const auto expected = timoshenko<G>(K, L);
  EXPECT_LT((straight.constant_tangent() - expected).norm(), 1e-14 * expected.norm());
}

/// Bending is that of one-point quadrature, (1 - 1/(4 n^2)) of Timoshenko's.
TYPED_TEST(BeamElementTest, LinearCantileverHasTheExactTip) {
  for (const int n : {1, 2, 5, 16}) {
    const double tip = kTimoshenkoBending * (1 - 1 / (4.0 * n * n)) + kTimoshenkoShear;
    EXPECT_NEAR((tip_deflection<TypeParam, BeamElement<TypeParam>>(n)), tip, 1e-11 * tip) << n;
  }
}

}  // namespace
}  // namespace liesl::test::beam_element_test
