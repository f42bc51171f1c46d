#include "mbs/levelset/features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mbs/levelset/dual.hpp"

namespace liesl::levelset {
namespace {

using std::abs, std::atan2, std::cos, std::pow, std::sin, std::sqrt;

/// x^e for x >= 0, as pow to round-off: whole exponents up to 8 by products, their inverses 1/2,
/// 1/4 and 1/8 by roots, both several times as fast.
double power(double x, double e) {
  if (e == 0.5) return sqrt(x);
  if (e == 0.25) return sqrt(sqrt(x));
  if (e == 0.125) return sqrt(sqrt(sqrt(x)));
  if (!(e >= 1 && e <= 8 && e == std::floor(e))) return pow(x, e);
  double product = 1;
  for (int n = static_cast<int>(e); n > 0; n /= 2, x *= x)
    if (n % 2 == 1) product *= x;
  return product;
}
template <int N>
Dual<N> power(const Dual<N>& x, const Dual<N>& e) {
  return pow(x, e, power(x.v, e.v));
}

template <class T>
T positive_part(const T& x) {
  return x > T(0.0) ? x : T(0.0);
}

template <class T, int D>
T norm(const std::array<T, D>& x) {
  T sum(0.0);
  for (const T& xi : x) sum = sum + xi * xi;
  return sqrt(sum);
}

/// Distance to a box of half-sides `half` with rounded edges, positive inside.
template <class T, int D>
T rounded_box(const T* X, const std::array<T, D>& half, const T& fillet) {
  std::array<T, D> outside;
  T inside = abs(X[0]) - half[0] + fillet;
  for (int i = 0; i < D; ++i) {
    const T q = abs(X[i]) - half[i] + fillet;
    if (q > inside) inside = q;
    outside[i] = positive_part(q);
  }
  // Inside the inner box the distance is to the nearest side, outside it to the nearest point.
  return inside > T(0.0) ? T(fillet - norm<T, D>(outside)) : T(fillet - inside);
}

/// k0/k1 of the ellipse: the length that makes 1 - k0 a distance to first order.
template <class T, int D>
T ellipse_length(const T* X, const std::array<T, D>& half, T& k0) {
  std::array<T, D> u, w;
  for (int i = 0; i < D; ++i) {
    u[i] = X[i] / half[i];
    w[i] = u[i] / half[i];
  }
  k0 = norm<T, D>(u);
  const T k1 = norm<T, D>(w);
  if (value_of(k1) > 0) return k0 / k1;
  return *std::min_element(half.begin(), half.end());  // the limit along the shortest axis
}

template <class T, int D>
T ellipse_value(const T* X, const std::array<T, D>& half) {
  T k0(0.0);
  const T length = ellipse_length<T, D>(X, half, k0);
  return (T(1.0) - k0) * length;
}

// Shapes: parameters p as a table, phi as a formula of the local point X and p.

struct HalfSpace {
  static std::vector<Parameter> table() { return {}; }
  template <class T>
  static T phi(const T* X, const T*) {
    return -X[0];
  }
};

struct Circle {
  static std::vector<Parameter> table() { return {{"radius", 0, "m", 0}}; }
  template <class T>
  static T phi(const T* X, const T* p) {
    return p[0] - norm<T, 2>({X[0], X[1]});
  }
};

struct Sphere {
  static std::vector<Parameter> table() { return {{"radius", 0, "m", 0}}; }
  template <class T>
  static T phi(const T* X, const T* p) {
    return p[0] - norm<T, 3>({X[0], X[1], X[2]});
  }
};

struct Rectangle {
  static std::vector<Parameter> table() {
    return {{"width", 0, "m", 0}, {"height", 0, "m", 0}, {"fillet", 0, "m", -1e-300}};
  }
  template <class T>
  static T phi(const T* X, const T* p) {
    return rounded_box<T, 2>(X, {p[0] * T(0.5), p[1] * T(0.5)}, p[2]);
  }
  static std::string error(const double* p) {
    return 2 * p[2] > std::min(p[0], p[1]) ? "fillet is larger than half the shorter side" : "";
  }
};

struct RoundedBox {
  static std::vector<Parameter> table() {
    return {{"width", 0, "m", 0},
            {"height", 0, "m", 0},
            {"depth", 0, "m", 0},
            {"fillet", 0, "m", -1e-300}};
  }
  template <class T>
  static T phi(const T* X, const T* p) {
    return rounded_box<T, 3>(X, {p[0] * T(0.5), p[1] * T(0.5), p[2] * T(0.5)}, p[3]);
  }
  static std::string error(const double* p) {
    return 2 * p[3] > std::min({p[0], p[1], p[2]}) ? "fillet is larger than half the shortest side"
                                                   : "";
  }
};

struct Ellipse {
  static std::vector<Parameter> table() { return {{"a", 0, "m", 0}, {"b", 0, "m", 0}}; }
  template <class T>
  static T phi(const T* X, const T* p) {
    return ellipse_value<T, 2>(X, {p[0], p[1]});
  }
};

struct Ellipsoid {
  static std::vector<Parameter> table() {
    return {{"a", 0, "m", 0}, {"b", 0, "m", 0}, {"c", 0, "m", 0}};
  }
  template <class T>
  static T phi(const T* X, const T* p) {
    return ellipse_value<T, 3>(X, {p[0], p[1], p[2]});
  }
};

struct SuperEllipse {
  static std::vector<Parameter> table() {
    return {{"a", 0, "m", 0}, {"b", 0, "m", 0}, {"xi", 0, "-", 1}, {"eta", 0, "-", 1}};
  }
  template <class T>
  static T phi(const T* X, const T* p) {
    T k0(0.0);
    const T length = ellipse_length<T, 2>(X, {p[0], p[1]}, k0);
    const T f = power(T(abs(X[0]) / p[0]), p[2]) + power(T(abs(X[1]) / p[1]), p[3]);
    return (T(1.0) - power(f, T(T(2.0) / (p[2] + p[3])))) * length;
  }
};

struct SuperformulaShape {
  static std::vector<Parameter> table() {
    return {{"size", 0, "m", 0}, {"a", 0, "-", 0},  {"b", 0, "-", 0}, {"m", 0, "-", -1e-300},
            {"n1", 0, "-", 0},   {"n2", 0, "-", 0}, {"n3", 0, "-", 0}};
  }
  template <class T>
  static T phi(const T* X, const T* p) {
    T theta = atan2(X[1], X[0]);
    if (value_of(theta) < 0) theta = theta + T(2 * std::numbers::pi);
    const T quarter = theta * p[3] / T(4.0);
    const T f = pow(T(abs(cos(quarter)) / p[1]), p[5]) + pow(T(abs(sin(quarter)) / p[2]), p[6]);
    return p[0] / pow(f, T(T(1.0) / p[4])) - norm<T, 2>({X[0], X[1]});
  }
};

struct Slab {
  static std::vector<Parameter> table() { return {{"height", 0, "m", 0}}; }
  template <class T>
  static T phi(const T* X, const T* p) {
    return p[0] * T(0.5) - abs(X[2]);
  }
};

template <class S>
concept HasError = requires(const double* p) {
  S::error(p);
};

/// Shape S with its parameters; gradients by dual numbers. K: number of parameters.
template <class S, int K>
class Feature final : public LevelSet {
 public:
  explicit Feature(const std::array<double, K>& values) : p_(values) {
    parameters_ = S::table();
    for (int i = 0; i < K; ++i) parameters_[i].value = values[i];
  }

  using LevelSet::set;
  void set(const double* p) override { std::copy_n(p, K, p_.begin()); }

  double value(const Eigen::Vector3d& x) const override {
    return S::template phi<double>(x.data(), p_.data());
  }

  double evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& dx, double* dp) const override {
    return dp ? differentiate<3 + K>(x, dx, dp) : differentiate<3>(x, dx, dp);
  }

  std::string error() const override {
    for (int i = 0; i < K; ++i)
      if (!(p_[i] > parameters_[i].above))
        return parameters_[i].name + " is " + std::to_string(p_[i]) + ", too small";
    if constexpr (HasError<S>)
      return S::error(p_.data());
    else
      return {};
  }

 private:
  template <int N>
  double differentiate(const Eigen::Vector3d& x, Eigen::Vector3d& dx, double* dp) const {
    using T = Dual<N>;
    std::array<T, 3> X;
    std::array<T, K + 1> p;  // one more, since K may be 0
    for (int i = 0; i < 3; ++i) X[i] = T::variable(x[i], i);
    for (int i = 0; i < K; ++i) p[i] = N > 3 ? T::variable(p_[i], (3 + i) % N) : T(p_[i]);
    const T phi = S::template phi<T>(X.data(), p.data());
    dx = phi.d.template head<3>();
    if constexpr (N > 3) std::copy_n(phi.d.data() + 3, K, dp);
    return phi.v;
  }

  std::array<double, K> p_;
};

template <class S, class... Values>
LevelSetPtr feature(Values... values) {
  return std::make_unique<Feature<S, sizeof...(Values)>>(
      std::array<double, sizeof...(Values)>{values...});
}

}  // namespace

LevelSetPtr half_space() { return feature<HalfSpace>(); }
LevelSetPtr circle(double radius) { return feature<Circle>(radius); }
LevelSetPtr sphere(double radius) { return feature<Sphere>(radius); }
LevelSetPtr rectangle(double width, double height, double fillet) {
  return feature<Rectangle>(width, height, fillet);
}
LevelSetPtr box(double width, double height, double depth, double fillet) {
  return feature<RoundedBox>(width, height, depth, fillet);
}
LevelSetPtr ellipse(double a, double b) { return feature<Ellipse>(a, b); }
LevelSetPtr ellipsoid(double a, double b, double c) { return feature<Ellipsoid>(a, b, c); }
LevelSetPtr super_ellipse(double a, double b, double xi, double eta) {
  return feature<SuperEllipse>(a, b, xi, eta);
}
LevelSetPtr superformula(const Superformula& s) {
  return feature<SuperformulaShape>(s.size, s.a, s.b, s.m, s.n1, s.n2, s.n3);
}
LevelSetPtr slab(double height) { return feature<Slab>(height); }

}  // namespace liesl::levelset
