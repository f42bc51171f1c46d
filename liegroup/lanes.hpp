#pragma once
/// @file
/// Four numbers that go through the same formulas at once, a lane of the processor's vectors each.
/// A group over them, SE3Of<Lanes>, is four frames; what is written for frames then computes four
/// elements at once.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <functional>
#include <type_traits>

namespace liesl {

// Products and sums become one instruction, as GCC does by itself.
#ifdef __clang__
#pragma clang fp contract(fast)
#endif

struct Lanes {
  static constexpr int size = 4;
  /// Of less alignment, where Eigen's arrays have less.
  static constexpr int alignment =
      EIGEN_MAX_STATIC_ALIGN_BYTES > 0 ? EIGEN_MAX_STATIC_ALIGN_BYTES : 16;
  typedef double Vector __attribute__((vector_size(size * sizeof(double)), aligned(alignment)));

  Vector v;

  Lanes() = default;
  Lanes(double all) : v{all, all, all, all} {}
  explicit Lanes(const Vector& lanes) : v(lanes) {}
  Lanes(double a, double b, double c, double d) : v{a, b, c, d} {}
  double operator[](int lane) const { return v[lane]; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v * b.v); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.v / b.v); }
  friend Lanes operator-(const Lanes& a) { return Lanes(-a.v); }
  Lanes& operator+=(const Lanes& a) { return v += a.v, *this; }
  Lanes& operator-=(const Lanes& a) { return v -= a.v, *this; }
  Lanes& operator*=(const Lanes& a) { return v *= a.v, *this; }
  Lanes& operator/=(const Lanes& a) { return v /= a.v, *this; }
};

#ifdef __clang__
#pragma clang fp contract(on)
#endif

/// Whether that holds of a number, or of those of all lanes.
inline bool all_at_most(double a, double bound) { return a <= bound; }
inline bool all_above(double a, double bound) { return a > bound; }
inline bool all_at_most(const Lanes& a, double bound) {
  return a[0] <= bound && a[1] <= bound && a[2] <= bound && a[3] <= bound;
}
inline bool all_above(const Lanes& a, double bound) {
  return a[0] > bound && a[1] > bound && a[2] > bound && a[3] > bound;
}

inline Lanes atan2(const Lanes& y, const Lanes& x) {
  return {std::atan2(y[0], x[0]), std::atan2(y[1], x[1]), std::atan2(y[2], x[2]),
          std::atan2(y[3], x[3])};
}

/// Four of a kind, one for each lane.
template <class T>
using Four = std::array<const T*, Lanes::size>;

/// A number, or a matrix, of each of four: of(x) is a double or a matrix of them.
template <class T, class Of>
auto gather(const Four<T>& four, const Of& of) {
  using Part = std::remove_cvref_t<std::invoke_result_t<const Of&, const T&>>;
  const auto part = [&](int lane) -> const Part& { return std::invoke(of, *four[lane]); };
  if constexpr (std::is_same_v<Part, double>) {
    return Lanes(part(0), part(1), part(2), part(3));
  } else {
    Eigen::Matrix<Lanes, Part::RowsAtCompileTime, Part::ColsAtCompileTime> all;
    for (int j = 0; j < all.cols(); ++j)
      for (int i = 0; i < all.rows(); ++i)
        all(i, j) = {part(0)(i, j), part(1)(i, j), part(2)(i, j), part(3)(i, j)};
    return all;
  }
}

}  // namespace liesl

namespace Eigen {

template <>
struct NumTraits<liesl::Lanes> : GenericNumTraits<liesl::Lanes> {
  using Real = liesl::Lanes;
  using NonInteger = liesl::Lanes;
  using Nested = liesl::Lanes;
  using Literal = double;
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0 };
};

template <class Op>
struct ScalarBinaryOpTraits<liesl::Lanes, double, Op> {
  using ReturnType = liesl::Lanes;
};
template <class Op>
struct ScalarBinaryOpTraits<double, liesl::Lanes, Op> {
  using ReturnType = liesl::Lanes;
};

}  // namespace Eigen
