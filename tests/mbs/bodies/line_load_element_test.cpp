/// @file
/// Identities of loads per length over an element of fourth order on SE(2) and SE(3).
#include "mbs/bodies/body.hpp"
#include "mbs/bodies/fourth_order_element.hpp"
#include "mbs/run.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::line_load_element_test {
namespace {

template <class G>
class LineLoadTest : public ::testing::Test {
 protected:
  static constexpr int size = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Element = FourthOrderElement<G>;
  using Pair = typename Element::Pair;

  /// An axis whose curvature varies, and nodes that are off it.
  LineLoadTest() : section(random.spd(size)) {
    Tangent d = 0.2 * random.vector(size);
    d[0] = 1.2;
    A_at_rest = G::exp(Tangent(random.vector(size)));
    B_at_rest = A_at_rest * G::exp(d);
    A = A_at_rest * G::exp(Tangent(0.15 * random.vector(size)));
    B = B_at_rest * G::exp(Tangent(0.15 * random.vector(size)));
    for (const bool follower : {true, false}) {
      loads.push_back({Tangent(2 * random.vector(size)), follower});
      loads.push_back(loads.back());
      loads.back().wrench.template head<sd>().setZero();
    }
  }
  Element of(double p = 0) const {
    Matrix mass = Matrix::Identity();
    return {A_at_rest, B_at_rest, section + p * by, mass};
  }
  static G moved(const G& H, const Pair& h, int node) {
    return H * G::exp(Tangent(h.template segment<size>(size * node)));
  }
  void expect_derivative(const std::function<Eigen::VectorXd(double, int)>& f,
                         const Eigen::MatrixXd& exact, const char* what) {
    const test::VectorOf differences = [&](double h) -> Eigen::VectorXd {
      Eigen::MatrixXd d(exact.rows(), exact.cols());
      for (int j = 0; j < exact.cols(); ++j) d.col(j) = (f(h, j) - f(-h, j)) / (2 * h);
      return d.reshaped();
    };
    const Eigen::VectorXd scale =
        Eigen::VectorXd::Constant(exact.size(), std::max(exact.norm(), 1e-3));
    test::expect_second_order(differences, exact.reshaped(), scale, 1e-3, 5e-9, what);
  }

  Random random{7};
  Matrix section, by = Random(9).spd(size);
  G A_at_rest, B_at_rest, A, B;
  std::vector<SpreadLoad<G>> loads;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(LineLoadTest, Groups);

TYPED_TEST(LineLoadTest, TangentsAreThoseOfTheForce) {
  using Pair = typename TestFixture::Pair;
  const auto element = this->of();
  for (const auto& load : this->loads)
    this->expect_derivative(
        [&, this](double h, int j) -> Eigen::VectorXd {
          const Pair e = h * Pair::Unit(j);
          return element.spread_curvature(this->moved(this->A, e, 0), this->moved(this->B, e, 1),
                                          load);
        },
        element.spread_curvature_tangent(this->A, this->B, load),
        load.follower ? "follows" : "dead");
}

TYPED_TEST(LineLoadTest, DerivativeByTheSection) {
  using Element = typename TestFixture::Element;
  const Element derivative(this->of(), this->by, TestFixture::Matrix::Zero());
  for (const auto& load : this->loads)
    this->expect_derivative(
        [&, this](double h, int) -> Eigen::VectorXd {
          return this->of(h).spread_curvature(this->A, this->B, load);
        },
        derivative.spread_derivative(this->A, this->B, load), load.follower ? "follows" : "dead");
}

/// Half the difference to either side is the derivative by the load (ParameterResidual).
TYPED_TEST(LineLoadTest, IsQuadraticInTheLoad) {
  using Pair = typename TestFixture::Pair;
  const auto element = this->of();
  for (const auto& load : this->loads) {
    const auto at = [&, this](double factor) -> Pair {
      return element.spread_curvature(this->A, this->B, {factor * load.wrench, load.follower});
    };
    const Pair third = at(3) - 3 * at(2) + 3 * at(1) - at(0);
    EXPECT_LT(third.norm(), 1e-12 * at(3).norm());
    EXPECT_EQ(at(0).norm(), 0);
  }
}

TYPED_TEST(LineLoadTest, FrameIndifference) {
  using G = TypeParam;
  const auto element = this->of();
  for (const auto& load : this->loads) {
    const G H = G::exp(typename G::Tangent(3 * this->random.vector(G::dim)));
    auto turned = load;
    if (!load.follower) {
      turned.wrench.template head<G::space_dim>() = H.R * load.wrench.template head<G::space_dim>();
      if constexpr (G::rotation_dim == 3)
        turned.wrench.template tail<3>() = H.R * load.wrench.template tail<3>();
    }
    const auto before = element.spread_curvature(this->A, this->B, load),
               after = element.spread_curvature(H * this->A, H * this->B, turned);
    EXPECT_LT((before - after).norm(), 1e-12 * before.norm());
  }
}

/// Damping takes power out, whatever the strains and velocities are, and none by rigid motions.
TYPED_TEST(LineLoadTest, DampingNeverBringsEnergyIn) {
  using G = TypeParam;
  using Pair = typename TestFixture::Pair;
  const auto element = this->of();
  for (int i = 0; i < 200; ++i) {
    const Pair h = 0.02 * i * this->random.vector(2 * G::dim);
    const G A = this->moved(this->A, h, 0), B = this->moved(this->B, h, 1);
    Pair v = this->random.vector(2 * G::dim), damped, elastic;
    element.internal_force(A, B, v.data(), 0.3, damped);
    element.internal_force(A, B, v.data(), 0, elastic);
    const double power = element.dissipation(A, B, v.data(), 0.3);
    EXPECT_GE(power, 0);
    EXPECT_NEAR(v.dot(damped - elastic), power, 1e-10 * power);
    const typename G::Tangent w = this->random.vector(G::dim);
    v << A.AdInv() * w, B.AdInv() * w;
    EXPECT_LT(element.dissipation(A, B, v.data(), 0.3), 1e-20 * (1 + damped.squaredNorm()));
  }
}

}  // namespace
}  // namespace liesl::test::line_load_element_test
