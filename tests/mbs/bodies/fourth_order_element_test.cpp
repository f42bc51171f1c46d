/// @file
/// Identities of the beam element of fourth order on SE(2) and SE(3).

#include "mbs/bodies/fourth_order_element.hpp"

#include "mbs/bodies/body.hpp"
#include "mbs/bodies/linear_cantilever.hpp"
#include "mbs/run.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::fourth_order_element_test {
namespace {

using test::Random;

template <class G>
using PairOf = typename FourthOrderElement<G>::Pair;
template <class G>
using VectorOfSpace = typename FourthOrderElement<G>::Vector;

template <class G>
class FourthOrderElementTest : public ::testing::Test {
 protected:
  static constexpr int size = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;

  Matrix inertia() {
    Matrix law = Matrix::Zero();
    law.template topLeftCorner<sd, sd>().diagonal().setConstant(1.7);
    law.template bottomRightCorner<rd, rd>() = random.spd(rd);
    return law;
  }
  Tangent curved_d0() {
    Tangent d = 0.2 * random.vector(size);
    d[0] = 1.2;
    return d;
  }

  FourthOrderElementTest()
      : A_at_rest(G::exp(Tangent(random.vector(size)))),
        B_at_rest(A_at_rest * G::exp(curved_d0())),
        section(random.spd(size)),
        mass(inertia()),
        element(A_at_rest, B_at_rest, section, mass),
        A_now(A_at_rest * G::exp(Tangent(0.15 * random.vector(size)))),
        B_now(B_at_rest * G::exp(Tangent(0.15 * random.vector(size)))),
        v(random.vector(2 * size)),
        a(random.vector(2 * size)) {}

  static G moved(const G& H, const PairOf<G>& h, int node) {
    return H * G::exp(Tangent(h.template segment<size>(size * node)));
  }
  PairOf<G> force(const FourthOrderElement<G>& e, const PairOf<G>& h, const PairOf<G>& rate,
                  double damping) const {
    PairOf<G> g;
    e.internal_force(moved(A_now, h, 0), moved(B_now, h, 1), rate.data(), damping, g);
    return g;
  }
  PairOf<G> inertia_force(const PairOf<G>& h, const PairOf<G>& rate,
                          const PairOf<G>& gravity_free) const {
    PairOf<G> g;
    element.inertia_force(moved(A_now, h, 0), moved(B_now, h, 1), rate.data(), gravity_free, g);
    return g;
  }
  /// Columns of the derivative of f at 0 by central differences.
  template <class F>
  static test::VectorOf differences(const F& f) {
    return [=](double h) -> Eigen::VectorXd {
      Eigen::MatrixXd d(f(PairOf<G>(PairOf<G>::Zero())).size(), 2 * size);
      for (int j = 0; j < 2 * size; ++j) {
        const PairOf<G> e = h * PairOf<G>::Unit(j);
        d.col(j) = (f(e) - f(PairOf<G>(-e))) / (2 * h);
      }
      return d.reshaped();
    };
  }
  template <class F>
  static void expect_derivative(const F& f, const Eigen::MatrixXd& exact, const char* what) {
    test::expect_second_order(differences(f), exact.reshaped(),
                              Eigen::VectorXd::Constant(exact.size(), exact.norm()), 1e-3, 5e-9,
                              what);
  }

  Random random{3};
  G A_at_rest, B_at_rest;
  Matrix section, mass;
  FourthOrderElement<G> element;
  G A_now, B_now;
  PairOf<G> v, a;
};

using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(FourthOrderElementTest, Groups);

TYPED_TEST(FourthOrderElementTest, ForceIsTheGradientOfTheEnergy) {
  using Pair = PairOf<TypeParam>;
  const auto energy = [this](const Pair& h) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1,
                                     this->element.elastic_energy(this->moved(this->A_now, h, 0),
                                                                  this->moved(this->B_now, h, 1)));
  };
  const Pair g = this->force(this->element, Pair::Zero(), this->v, 0);
  this->expect_derivative(energy, g.transpose(), "force");
}

TYPED_TEST(FourthOrderElementTest, TangentsAreThoseOfTheForce) {
  using Pair = PairOf<TypeParam>;
  for (const double damping : {0.0, 0.3}) {
    const auto by_h = [=, this](const Pair& h) {
      return this->force(this->element, h, this->v, damping);
    };
    const auto by_v = [=, this](const Pair& h) {
      return this->force(this->element, Pair::Zero(), this->v + h, damping);
    };
    const auto n = this->element.stress(this->A_now, this->B_now);
    this->expect_derivative(
        by_h, this->element.damped_tangent(this->A_now, this->B_now, n, this->v.data(), damping),
        "by frames");
    if (damping > 0)
      this->expect_derivative(
          by_v, this->element.damping_tangent(this->A_now, this->B_now, this->v.data(), damping),
          "by velocities");
  }
}

/// About any stress the force is that of the exact law to second order in what it is off by.
TYPED_TEST(FourthOrderElementTest, IsExactToSecondOrderInTheStressItIsLinearisedAbout) {
  using Pair = PairOf<TypeParam>;
  const typename TypeParam::Tangent n = this->element.stress(this->A_now, this->B_now),
                                    off = this->random.vector(TypeParam::dim);
  const Pair exact = this->force(this->element, Pair::Zero(), this->v, 0);
  double before = 0;
  for (const double part : {0.1, 0.05, 0.025}) {
    const typename TypeParam::Tangent about = n + part * off;
    Pair g;
    this->element.internal_force(this->A_now, this->B_now, nullptr, 0, g, about.data());
    const double error = (g - exact).norm();
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 1e-3);
    }
    before = error;
  }
  const Pair h = 1e-5 * this->random.vector(2 * TypeParam::dim);
  const auto moved =
      this->element.stress(this->moved(this->A_now, h, 0), this->moved(this->B_now, h, 1));
  EXPECT_LT((this->element.extrapolated(this->A_now, this->B_now, n, h) - moved).norm(),
            1e-8 * n.norm());
}

TYPED_TEST(FourthOrderElementTest, ConstantTangentAndMassAreExactAtRest) {
  const auto K = this->element.constant_tangent();
  const auto zero = TypeParam::Tangent::Zero().eval();
  const auto exact = this->element.tangent(this->A_at_rest, this->B_at_rest, zero);
  EXPECT_LT((K - exact).norm(), 1e-12 * K.norm());
  EXPECT_LT((K - K.transpose()).norm(), 1e-13 * K.norm());
  const auto M = this->element.mass();
  EXPECT_LT((M - this->element.mass(this->A_at_rest, this->B_at_rest)).norm(), 1e-13 * M.norm());
  EXPECT_LT((M - M.transpose()).norm(), 1e-14 * M.norm());
}

TYPED_TEST(FourthOrderElementTest, FrameIndifference) {
  using G = TypeParam;
  using Pair = PairOf<TypeParam>;
  Pair g, moved;
  for (int i = 0; i < 20; ++i) {
    const G H = G::exp(typename G::Tangent(3 * this->random.vector(G::dim)));
    this->element.internal_force(this->A_now, this->B_now, this->v.data(), 0.1, g);
    this->element.internal_force(H * this->A_now, H * this->B_now, this->v.data(), 0.1, moved);
    EXPECT_LT((g - moved).norm(), 1e-12 * g.norm());
    this->element.inertia_force(this->A_now, this->B_now, this->v.data(), this->a, g);
    this->element.inertia_force(H * this->A_now, H * this->B_now, this->v.data(), this->a, moved);
    EXPECT_LT((g - moved).norm(), 1e-12 * g.norm());
    EXPECT_LT(this->element.strain(H * this->A_at_rest, H * this->B_at_rest).norm(), 1e-14);
  }
}

TYPED_TEST(FourthOrderElementTest, InertiaHasItsTangents) {
  using Pair = PairOf<TypeParam>;
  using Vector = VectorOfSpace<TypeParam>;
  const Vector gravity = this->random.vector(TypeParam::space_dim);
  const auto apparent = [&, this](const Pair& h) {
    Pair out = this->a;
    out.template head<TypeParam::space_dim>() -=
        this->moved(this->A_now, h, 0).R.transpose() * gravity;
    out.template segment<TypeParam::space_dim>(TypeParam::dim) -=
        this->moved(this->B_now, h, 1).R.transpose() * gravity;
    return out;
  };
  const auto by_h = [&, this](const Pair& h) {
    return this->inertia_force(h, this->v, apparent(h));
  };
  const auto by_v = [&, this](const Pair& h) {
    return this->inertia_force(Pair::Zero(), this->v + h, this->a);
  };
  const auto by_a = [&, this](const Pair& h) {
    return this->inertia_force(Pair::Zero(), this->v, this->a + h);
  };
  this->expect_derivative(by_h,
                          this->element.inertia_stiffness(this->A_now, this->B_now, this->v.data(),
                                                          apparent(Pair::Zero()), gravity),
                          "by frames");
  this->expect_derivative(
      by_v, this->element.gyroscopic_tangent(this->A_now, this->B_now, this->v.data()),
      "by velocities");
  this->expect_derivative(by_a, this->element.mass(this->A_now, this->B_now), "by accelerations");
}

TYPED_TEST(FourthOrderElementTest, EnergyOfInertiaAndWeight) {
  using Pair = PairOf<TypeParam>;
  using Vector = VectorOfSpace<TypeParam>;
  const Vector gravity = this->random.vector(TypeParam::space_dim);
  const auto kinetic = [this](const Pair& h, const Pair& rate) {
    return 0.5 * rate.dot(this->element.mass(this->moved(this->A_now, h, 0),
                                             this->moved(this->B_now, h, 1)) *
                          rate);
  };
  const double T_now = kinetic(Pair::Zero(), this->v);
  EXPECT_NEAR(this->element.kinetic_energy(this->A_now, this->B_now, this->v.data()), T_now,
              1e-13 * T_now);
  const auto T = [&, this](const Pair& h) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, kinetic(h, this->v));
  };
  const auto U = [&, this](const Pair& h) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(
        1, this->element.weight_potential(this->moved(this->A_now, h, 0),
                                          this->moved(this->B_now, h, 1), gravity));
  };
  this->expect_derivative(
      T, this->element.kinetic_gradient(this->A_now, this->B_now, this->v.data()).transpose(),
      "kinetic energy");
  const Pair weight = this->element.weight_gradient(this->A_now, this->B_now, gravity);
  this->expect_derivative(U, weight.transpose(), "potential");
  Pair g = Pair::Zero(), still = Pair::Zero();
  still.template head<TypeParam::space_dim>() = -this->A_now.R.transpose() * gravity;
  still.template segment<TypeParam::space_dim>(TypeParam::dim) =
      -this->B_now.R.transpose() * gravity;
  EXPECT_LT((this->inertia_force(Pair::Zero(), g, still) - weight).norm(), 1e-13 * weight.norm());
  const double power = this->v.dot(this->inertia_force(Pair::Zero(), this->v, this->a));
  const test::VectorOf rate = [&, this](double h) -> Eigen::VectorXd {
    const auto at = [&](double t) {
      return kinetic(t * this->v + 0.5 * t * t * this->a, this->v + t * this->a);
    };
    return Eigen::VectorXd::Constant(1, (at(h) - at(-h)) / (2 * h));
  };
  test::expect_second_order(rate, Eigen::VectorXd::Constant(1, power),
                            Eigen::VectorXd::Constant(1, std::abs(power)), 1e-2, 1e-10, "power");
}

/// The derivative by a parameter of the section against differences of elements; with little rotary
/// inertia, where s^2 m L^2/24 is at its bound, and with much, too.
TYPED_TEST(FourthOrderElementTest, DerivativeByTheSection) {
  using Pair = PairOf<TypeParam>;
  using Element = FourthOrderElement<TypeParam>;
  constexpr int rd = TypeParam::rotation_dim;
  for (const double rotary : {1e-3, 1.0, 100.0}) {
    auto mass = this->mass;
    mass.template bottomRightCorner<rd, rd>() *= rotary;
    typename TypeParam::Matrix dM = 0.3 * mass;
    dM.template bottomRightCorner<rd, rd>() *= 1.7;
    const auto dK = this->random.spd(TypeParam::dim);
    const Element derivative(Element(this->A_at_rest, this->B_at_rest, this->section, mass), dK,
                             dM);
    const auto of = [&, this](double p) {
      return Element(this->A_at_rest, this->B_at_rest, this->section + p * dK, mass + p * dM);
    };
    const auto all = [&, this](const Element& e) {
      Eigen::VectorXd out(4 * Pair::RowsAtCompileTime + 2 + TypeParam::dim);
      Pair g;
      e.inertia_force(this->A_now, this->B_now, this->v.data(), this->a, g);
      const Pair constant = e.constant_tangent() * this->a, inertia = e.mass() * this->a;
      out << this->force(e, Pair::Zero(), this->v, 0.2), g, constant, inertia,
          e.elastic_energy(this->A_now, this->B_now),
          e.dissipation(this->A_now, this->B_now, this->v.data(), 0.2),
          e.stress(this->A_now, this->B_now);
      return out;
    };
    const Eigen::VectorXd exact = all(derivative);
    const test::VectorOf difference = [&](double h) -> Eigen::VectorXd {
      return (all(of(h)) - all(of(-h))) / (2 * h);
    };
    test::expect_second_order(difference, exact,
                              Eigen::VectorXd::Constant(exact.size(), exact.norm()), 1e-3, 1e-9,
                              "by the section");
  }
}

/// Whatever the rotary inertia is, the kinetic energy is positive.
TYPED_TEST(FourthOrderElementTest, MassIsPositiveForAnyRotaryInertia) {
  for (const double rotary : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    auto mass = this->mass;
    constexpr int rd = TypeParam::rotation_dim;
    mass.template bottomRightCorner<rd, rd>() *= rotary;
    const FourthOrderElement<TypeParam> e(this->A_at_rest, this->B_at_rest, this->section, mass);
    for (const auto& M : {e.mass(), e.mass(this->A_now, this->B_now)})
      EXPECT_TRUE(Eigen::MatrixXd(M).llt().info() == Eigen::Success) << rotary;
  }
}

/// Exact for Timoshenko's cantilever under a force at its tip, whatever the mesh.
TYPED_TEST(FourthOrderElementTest, LinearCantileverHasTheExactTip) {
  const double tip = kTimoshenkoBending + kTimoshenkoShear;
  for (const int n : {1, 2, 5})
    EXPECT_NEAR((tip_deflection<TypeParam, FourthOrderElement<TypeParam>>(n)), tip, 1e-11 * tip)
        << n;
}

}  // namespace
}  // namespace liesl::test::fourth_order_element_test
