#pragma once
/// @file
/// The property suite every group of liesl passes: identities of Sonneville,
/// Cardona, Brüls (2014). Instantiate with
///   INSTANTIATE_TYPED_TEST_SUITE_P(Name, GroupProperties, testing::Types<G...>);
///
/// Every identity is checked at every angle of one sweep, 1e-12 ... pi - 1e-6, and for translations
/// of length 1e-3, 1 and 1e3. Max norm, absolute tolerance 1e-13 (1 + |u|): all these identities
/// are at most linear in the translations, so their rounding error is too, and the operators of the
/// rotation part are of size one.

#include <gtest/gtest.h>

#include <string>

#include "liegroup/numdiff.hpp"
#include "sampling.hpp"

namespace liesl::test {

template <class G>
class GroupProperties : public testing::Test {
 public:
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;

  /// check(h, tolerance) over the sweep.
  template <class Check>
  void sweep(const Check& check) {
    for (double length : {1e-3, 1.0, 1e3}) {
      for (double angle : angle_sweep()) {
        SCOPED_TRACE("angle " + std::to_string(angle) + ", |u| " + std::to_string(length));
        check(Sampler<G>::draw(rng, angle, length), 1e-13 * (1 + length));
        if (this->HasFailure()) return;
      }
    }
  }

  Tangent other(double angle = 1.1) { return Sampler<G>::draw(rng, angle, 0.8); }

  static double distance(const G& A, const G& B) { return size_of(difference(A, B)); }

  Rng rng{20140607};
};

TYPED_TEST_SUITE_P(GroupProperties);

/// Power series sum_i c_i ad(h)^i in long double, c_i = 1/i! (Ad) or (-1)^i/(i+1)! (T).
template <class G>
typename G::Matrix series_of_ad(const typename G::Tangent& h, bool tangent_operator) {
  using Long = Eigen::Matrix<long double, G::dim, G::dim>;
  const Long step = G::ad(h).template cast<long double>() * (tangent_operator ? -1 : 1);
  Long sum = Long::Identity(), term = Long::Identity();
  for (int i = 1; i < 50; ++i) {
    term = (term * step).eval() / (tangent_operator ? i + 1 : i);
    sum += term;
  }
  return sum.template cast<double>();
}

TYPED_TEST_P(GroupProperties, IsAGroup) {
  using G = TypeParam;
  EXPECT_EQ(size_of(G::log(G::identity())), 0);
  EXPECT_EQ(size_of(G::log(G())), 0);
  this->sweep([&](const auto& h, double tol) {
    const G A = G::exp(h), B = G::exp(this->other()), C = G::exp(this->other());
    EXPECT_LE(this->distance(A * G::identity(), A), tol);
    EXPECT_LE(this->distance(G::identity() * A, A), tol);
    EXPECT_LE(this->distance(A * A.inverse(), G::identity()), tol);
    EXPECT_LE(this->distance(A.inverse() * A, G::identity()), tol);
    EXPECT_LE(this->distance((A * B) * C, A * (B * C)), tol);
    EXPECT_LE(this->distance((A * B).inverse(), B.inverse() * A.inverse()), tol);
  });
}

TYPED_TEST_P(GroupProperties, ExpAndLog) {
  using G = TypeParam;
  using V = typename TestFixture::Tangent;
  this->sweep([&](const V& h, double tol) {
    EXPECT_LE(this->distance(G::exp(h) * G::exp(-h), G::identity()), tol);
    // log(exp(h)) is well conditioned up to pi: near it log reads the half-angle quaternion, whose
    // small component is the difference of entries of R with absolute errors of 1e-16. Hence one
    // tolerance for the whole sweep.
    EXPECT_LE(size_of(G::log(G::exp(h)) - h), tol);
    EXPECT_LE(this->distance(G::exp(0.3 * h) * G::exp(0.7 * h), G::exp(h)), tol);
  });
}

/// Small tangents keep their relative precision: no noise of 1e-16 on a rotation of 1e-12.
TYPED_TEST_P(GroupProperties, SmallTangentsAreRelativelyExact) {
  using G = TypeParam;
  using V = typename TestFixture::Tangent;
  for (double angle : angle_sweep()) {
    const V h = Sampler<G>::draw(this->rng, angle, angle);
    EXPECT_LE(size_of(G::log(G::exp(h)) - h), 1e-14 * size_of(h)) << angle;
  }
}

TYPED_TEST_P(GroupProperties, Adjoint) {
  using G = TypeParam;
  using V = typename TestFixture::Tangent;
  using M = typename TestFixture::Matrix;
  this->sweep([&](const V& h, double tol) {
    const G A = G::exp(h), B = G::exp(this->other());
    const V a = this->other(), b = this->other(), c = this->other();
    EXPECT_LE(size_of(A.Ad() - series_of_ad<G>(h, false)), tol);
    EXPECT_LE(size_of((A * B).Ad() - A.Ad() * B.Ad()), tol);
    EXPECT_LE(size_of(A.AdInv() - A.inverse().Ad()), tol);
    EXPECT_LE(size_of(A.Ad() * A.AdInv() - M::Identity()), tol);
    EXPECT_LE(this->distance(A * G::exp(a) * A.inverse(), G::exp(A.Ad() * a)), tol);
    EXPECT_LE(size_of(G::ad(h) * h), tol);
    EXPECT_LE(size_of(G::ad(h) * a + G::ad(a) * h), tol);
    EXPECT_LE(
        size_of(G::ad(h) * (G::ad(a) * b) + G::ad(a) * (G::ad(b) * h) + G::ad(b) * (G::ad(h) * a)),
        tol);  // Jacobi
    EXPECT_LE(size_of(A.Ad() * (G::ad(b) * c) - G::ad(A.Ad() * b) * (A.Ad() * c)), tol);
  });
}

TYPED_TEST_P(GroupProperties, TangentOperator) {
  using G = TypeParam;
  using V = typename TestFixture::Tangent;
  using M = typename TestFixture::Matrix;
  EXPECT_EQ(size_of(G::T(V::Zero()) - M::Identity()), 0);
  this->sweep([&](const V& h, double tol) {
    const M T = G::T(h), Tinv = G::Tinv(h), Ad = G::exp(h).Ad();
    EXPECT_LE(size_of(T - series_of_ad<G>(h, true)), tol);
    EXPECT_LE(size_of(T * Tinv - M::Identity()), tol);
    EXPECT_LE(size_of(Tinv * T - M::Identity()), tol);
    EXPECT_LE(size_of(G::T(-h) - Ad * T), tol);
    EXPECT_LE(size_of(Tinv * G::exp(-h).Ad() - G::Tinv(-h)), tol);
    EXPECT_LE(size_of(Tinv - G::Tinv(-h) - G::ad(h)), tol);
    EXPECT_LE(size_of(T * h - h), tol);
    EXPECT_LE(size_of(Tinv * h - h), tol);
    V d;
    M shared;
    G::log_and_Tinv(G::exp(h), d, shared);
    EXPECT_LE(size_of(d - h), tol);
    EXPECT_LE(size_of(shared - Tinv), tol);
  });
}

/// Exact relations of the directional derivatives, free of difference quotients.
TYPED_TEST_P(GroupProperties, DerivativeIdentities) {
  using G = TypeParam;
  using V = typename TestFixture::Tangent;
  using M = typename TestFixture::Matrix;
  this->sweep([&](const V& h, double tol) {
    const M T = G::T(h), Tinv = G::Tinv(h);
    const V a = this->other(), b = this->other(), n = this->other();
    // derivative of T(h) h = h and of T^-1(h) h = h
    EXPECT_LE(size_of(G::dT(h, h) + T - M::Identity()), tol);
    EXPECT_LE(size_of(G::dTinv(h, h) + Tinv - M::Identity()), tol);
    // derivative of T(h) T^-1(h) a = a
    EXPECT_LE(size_of(G::dT(h, Tinv * a) + T * G::dTinv(h, a)), tol);
    // Maurer-Cartan: D_a (T b) - D_b (T a) + [T a, T b] = 0
    EXPECT_LE(size_of(G::dT(h, b) * a - G::dT(h, a) * b + G::ad(T * a) * (T * b)), tol);
    // a . T^-T(h) n = n . T^-1(h) a
    EXPECT_LE(size_of(G::dTinvT(h, n).transpose() * a - G::dTinv(h, a).transpose() * n), tol);
    // T(-h) a = Ad(exp h) T(h) a
    EXPECT_LE(size_of(G::dT(-h, a) + G::exp(h).Ad() * (G::dT(h, a) - G::ad(T * a) * T)), tol);
  });
}

/// Analytic derivatives against central differences: slope 2 over a sweep of steps, at small,
/// moderate and large angles.
TYPED_TEST_P(GroupProperties, DerivativesAgainstDifferences) {
  using G = TypeParam;
  using V = typename TestFixture::Tangent;
  for (double angle : {1e-12, 1e-7, 1e-3, 0.1, 0.25, 0.7, 1.6, 2.5, 3.0, std::numbers::pi - 1e-6}) {
    SCOPED_TRACE(angle);
    const V h = Sampler<G>::draw(this->rng, angle, 1.0), a = this->other(), n = this->other();
    const StepSweep sweeps[] = {
        step_sweep([](const V& k) { return G::exp(k); }, h, G::T(h)),
        step_sweep([&](const G& H) { return G::log(G::exp(-0.5 * h) * H); }, G::exp(h),
                   G::Tinv(0.5 * h)),
        step_sweep([&](const V& k) { return V(G::T(k) * a); }, h, G::dT(h, a)),
        step_sweep([&](const V& k) { return V(G::Tinv(k) * a); }, h, G::dTinv(h, a)),
        step_sweep([&](const V& k) { return V(G::Tinv(k).transpose() * n); }, h, G::dTinvT(h, n))};
    for (const StepSweep& s : sweeps)
      EXPECT_TRUE(s.confirms(1e-9)) << &s - sweeps << ": best " << s.best_error << " at "
                                    << s.best_step << ", slope " << s.slope;
  }
}

REGISTER_TYPED_TEST_SUITE_P(GroupProperties, IsAGroup, ExpAndLog, SmallTangentsAreRelativelyExact,
                            Adjoint, TangentOperator, DerivativeIdentities,
                            DerivativesAgainstDifferences);

}  // namespace liesl::test
