/// First look at SE(2), SE(3), SO(3): inverses of each other and derivatives. The full suite is
/// group_properties_test.cpp.

#include <gtest/gtest.h>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "liegroup/so3.hpp"

namespace {

template <class G>
class Basic : public testing::Test {};
using Groups = testing::Types<liesl::SO3, liesl::SE2, liesl::SE3>;
TYPED_TEST_SUITE(Basic, Groups);

template <class G>
typename G::Tangent tangent(double first, double scale) {
  typename G::Tangent h;
  for (int i = 0; i < G::dim; ++i) h[i] = scale * std::sin(first + 1.7 * i);
  return h;
}

template <class G, class F>
typename G::Matrix jacobian(const F& f, const typename G::Tangent& h) {
  typename G::Matrix J;
  const double eps = 1e-5;
  for (int i = 0; i < G::dim; ++i) {
    const typename G::Tangent d = eps * G::Tangent::Unit(i);
    J.col(i) = (f(typename G::Tangent(h + d)) - f(typename G::Tangent(h - d))) / (2 * eps);
  }
  return J;
}

TYPED_TEST(Basic, MapsAndTangents) {
  using G = TypeParam;
  using M = typename G::Matrix;
  using V = typename G::Tangent;
  for (double scale : {1e-9, 1e-3, 0.1, 0.5, 1.0, 1.5}) {
    const V h = tangent<G>(0.3, scale);
    const G H = G::exp(h);
    EXPECT_LT((G::log(H) - h).norm(), 1e-14);
    EXPECT_LT((G::T(h) * G::Tinv(h) - M::Identity()).norm(), 2e-14);
    EXPECT_LT((H.Ad() * H.AdInv() - M::Identity()).norm(), 1e-14);
    EXPECT_LT((G::T(V(-h)) - H.Ad() * G::T(h)).norm(), 1e-14);
    EXPECT_LT((G::Tinv(h) - G::Tinv(V(-h)) - G::ad(h)).norm(), 1e-14);
    V d;
    M P;
    G::log_and_Tinv(H, d, P);
    EXPECT_LT((d - h).norm(), 1e-14);
    EXPECT_LT((P - G::Tinv(h)).norm(), 1e-14);
  }
}

TYPED_TEST(Basic, Derivatives) {
  using G = TypeParam;
  using V = typename G::Tangent;
  const V h = tangent<G>(0.3, 0.9), a = tangent<G>(2.0, 1.3);
  const G inverse = G::exp(h).inverse();
  EXPECT_LT(
      (jacobian<G>([&](const V& k) { return G::log(inverse * G::exp(k)); }, h) - G::T(h)).norm(),
      1e-9);
  EXPECT_LT((jacobian<G>([&](const V& k) { return V(G::T(k) * a); }, h) - G::dT(h, a)).norm(),
            1e-9);
  EXPECT_LT((jacobian<G>([&](const V& k) { return V(G::Tinv(k) * a); }, h) - G::dTinv(h, a)).norm(),
            1e-9);
  EXPECT_LT(
      (jacobian<G>([&](const V& k) { return V(G::Tinv(k).transpose() * a); }, h) - G::dTinvT(h, a))
          .norm(),
      1e-9);
}

TYPED_TEST(Basic, LogarithmUpToPi) {
  using G = TypeParam;
  using V = typename G::Tangent;
  for (double w : {2.0, 2.8, 3.1, 3.14159}) {
    V h = tangent<G>(0.4, 1.0);
    h *= w / h.tail(G::rotation_dim).norm();
    EXPECT_LT((G::log(G::exp(h)) - h).norm(), 2e-14) << w;
  }
}

}  // namespace
