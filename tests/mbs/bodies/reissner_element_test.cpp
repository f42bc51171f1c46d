/// @file
/// Identities of the element of the classical formalisms on SE(2) and SE(3).

#include "mbs/bodies/reissner_element.hpp"

#include "mbs/bodies/beam_element.hpp"
#include "mbs/run.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::reissner_element_test {
namespace {

template <class G>
class ReissnerElementTest : public ::testing::Test {
 protected:
  static constexpr int size = G::dim;
  using Tangent = typename G::Tangent;
  using Element = ReissnerElement<G>;
  using Pair = typename Element::Pair;

  ReissnerElementTest()
      : A_at_rest(G::exp(Tangent(random.vector(size)))),
        B_at_rest(A_at_rest * G::exp(curved())),
        element(A_at_rest, B_at_rest, random.spd(size), inertia()),
        A_now(A_at_rest * G::exp(Tangent(0.3 * random.vector(size)))),
        B_now(B_at_rest * G::exp(Tangent(0.3 * random.vector(size)))) {}

  Tangent curved() {
    Tangent d = 0.4 * random.vector(size);
    d[0] = 1.2;
    return d;
  }
  typename G::Matrix inertia() {
    typename G::Matrix M = G::Matrix::Zero();
    M.diagonal().template head<G::space_dim>().setConstant(1.7);
    M.template bottomRightCorner<G::rotation_dim, G::rotation_dim>() = random.spd(G::rotation_dim);
    return M;
  }
  static G moved(const G& H, const Pair& h, int node) {
    return H * G::exp(Tangent(h.template segment<size>(size * node)));
  }
  Pair force(const G& a, const G& b) const {
    Pair g;
    element.internal_force(a, b, nullptr, 0, g);
    return g;
  }
  double energy(const G& a, const G& b) const {
    const Tangent eps = element.strain(a, b);
    return 0.5 * element.length() * eps.dot(element.section_stiffness() * eps);
  }

  test::Random random{1};
  G A_at_rest, B_at_rest;
  Element element;
  G A_now, B_now;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ReissnerElementTest, Groups);

TYPED_TEST(ReissnerElementTest, ForceIsTheGradientOfTheEnergy) {
  using Vector = typename TestFixture::Pair;
  const Vector g = this->force(this->A_now, this->B_now);
  const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
    Eigen::VectorXd d(g.size());
    for (int j = 0; j < g.size(); ++j) {
      const Vector e = h * Vector::Unit(j);
      const auto V = [&](const Vector& p) {
        return this->energy(this->moved(this->A_now, p, 0), this->moved(this->B_now, p, 1));
      };
      d[j] = (V(e) - V(-e)) / (2 * h);
    }
    return d;
  };
  test::expect_second_order(difference, g, Eigen::VectorXd::Constant(g.size(), g.norm()), 2e-3,
                            2e-9, "force");
}

TYPED_TEST(ReissnerElementTest, TangentIsTheDerivativeOfTheForce) {
  using Vector = typename TestFixture::Pair;
  const typename TypeParam::Tangent n =
      this->element.section_stiffness() * this->element.strain(this->A_now, this->B_now);
  const Eigen::MatrixXd K = this->element.tangent(this->A_now, this->B_now, n);
  const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
    Eigen::MatrixXd d(K.rows(), K.cols());
    for (int j = 0; j < K.cols(); ++j) {
      const Vector e = h * Vector::Unit(j);
      const auto g = [&](const Vector& p) {
        return this->force(this->moved(this->A_now, p, 0), this->moved(this->B_now, p, 1));
      };
      d.col(j) = (g(e) - g(-e)) / (2 * h);
    }
    return d.reshaped();
  };
  test::expect_second_order(difference, K.reshaped(), Eigen::VectorXd::Constant(K.size(), K.norm()),
                            2e-3, 1e-9, "tangent");
}

TYPED_TEST(ReissnerElementTest, IsIndifferentToTheFrame) {
  for (int i = 0; i < 10; ++i) {
    const TypeParam H =
        TypeParam::exp(typename TypeParam::Tangent(3 * this->random.vector(TypeParam::dim)));
    const auto g = this->force(this->A_now, this->B_now);
    EXPECT_LT((this->force(H * this->A_now, H * this->B_now) - g).norm(), 1e-12 * g.norm());
    EXPECT_LT(this->element.strain(H * this->A_at_rest, H * this->B_at_rest).norm(), 1e-14);
  }
}

TYPED_TEST(ReissnerElementTest, StraightStiffnessIsThatOfTheLieElement) {
  using G = TypeParam;
  const G end = G::exp(typename G::Tangent(0.37 * G::Tangent::Unit(0)));
  const typename G::Matrix K = this->random.spd(G::dim), M = this->inertia();
  const ReissnerElement<G> one(G::identity(), end, K, M);
  const BeamElement<G> other(G::identity(), end, K, M);
  EXPECT_LT((one.constant_tangent() - other.constant_tangent()).norm(),
            1e-13 * other.constant_tangent().norm());
}

TYPED_TEST(ReissnerElementTest, PowerOfInertiaIsTheRateOfKineticEnergy) {
  using Vector = typename TestFixture::Pair;
  const Vector v = this->random.vector(2 * TypeParam::dim),
               a = this->random.vector(2 * TypeParam::dim);
  Vector g;
  this->element.inertia_force(this->A_now, this->B_now, v.data(), a, g);
  const auto kinetic = [&](double t) {
    const Vector d = t * v + 0.5 * t * t * a, w = v + t * a;
    const auto M =
        this->element.mass(this->moved(this->A_now, d, 0), this->moved(this->B_now, d, 1));
    return 0.5 * w.dot(M * w);
  };
  const double h = 1e-5, rate = (kinetic(h) - kinetic(-h)) / (2 * h);
  EXPECT_NEAR(v.dot(g), rate, 1e-8 * v.norm() * g.norm());
}

TYPED_TEST(ReissnerElementTest, GyroscopicTangentIsTheDerivativeOfTheInertiaForce) {
  using Vector = typename TestFixture::Pair;
  const Vector v = this->random.vector(2 * TypeParam::dim);
  const auto C = this->element.gyroscopic_tangent(this->A_now, this->B_now, v.data());
  for (int j = 0; j < C.cols(); ++j) {  // quadratic in v: central differences are exact
    const auto force = [&](double t) {
      const Vector w = v + t * Vector::Unit(j);
      Vector g;
      this->element.inertia_force(this->A_now, this->B_now, w.data(), Vector::Zero(), g);
      return g;
    };
    EXPECT_LT((C.col(j) - (force(1) - force(-1)) / 2).norm(), 1e-12 * C.norm());
  }
}

}  // namespace
}  // namespace liesl::test::reissner_element_test
