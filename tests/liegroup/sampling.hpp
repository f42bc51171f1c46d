#pragma once
/// @file
/// Random tangents with a chosen rotation angle and translation length, for any group of liesl.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "liegroup/numdiff.hpp"
#include "liegroup/product.hpp"
#include "liegroup/r3xso3.hpp"
#include "liegroup/rn.hpp"
#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"

namespace liesl::test {

using Rng = std::mt19937_64;

/// Unit vector, isotropic; +-1 for N = 1.
template <int N>
Eigen::Matrix<double, N, 1> direction(Rng& rng) {
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, N, 1> v;
  for (int i = 0; i < N; ++i) v[i] = normal(rng);
  return v / v.norm();
}

/// Sampler<G>::draw: a tangent of rotation angle `angle` and translation length `length`.
template <class G>
struct Sampler;

template <FrameGroup G>
struct Sampler<G> {
  static typename G::Tangent draw(Rng& rng, double angle, double length) {
    typename G::Tangent h;
    h << length * direction<G::space_dim>(rng), angle * direction<G::rotation_dim>(rng);
    return h;
  }
};

template <>
struct Sampler<SO3> {
  static Eigen::Vector3d draw(Rng& rng, double angle, double) { return angle * direction<3>(rng); }
};

template <int N>
struct Sampler<Rn<N>> {
  static typename Rn<N>::Tangent draw(Rng& rng, double, double length) {
    return length * direction<N>(rng);
  }
};

template <class... Gs>
struct Sampler<Product<Gs...>> {
  static typename Product<Gs...>::Tangent draw(Rng& rng, double angle, double length) {
    typename Product<Gs...>::Tangent h;
    int row = 0;
    ((h.template segment<Gs::dim>(row) = Sampler<Gs>::draw(rng, angle, length), row += Gs::dim),
     ...);
    return h;
  }
};

/// Angles of one sweep: 1e-12 ... 2.5 in quarter decades, then up to pi - 1e-6.
inline std::vector<double> angle_sweep() {
  std::vector<double> angles;
  for (double a = 1e-12; a < 2.5; a *= std::pow(10.0, 0.25)) angles.push_back(a);
  for (double a : {0.24, 0.26, 1.5, 2.0, 2.4, 2.5, 2.9}) angles.push_back(a);
  for (double gap = 0.1; gap > 0.9e-6; gap *= 0.1) angles.push_back(std::numbers::pi - gap);
  return angles;
}

/// max_norm for all expressions in one instantiation; NaN counts as infinite and fails every bound.
inline double size_of(const Eigen::Ref<const Eigen::MatrixXd>& A) { return max_norm(A); }

}  // namespace liesl::test
