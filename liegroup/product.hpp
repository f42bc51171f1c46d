#pragma once
/// @file
/// Direct product of groups, for bodies whose coordinates are a frame and more, e.g. SE(3) x R^m.

#include <Eigen/Core>
#include <tuple>
#include <type_traits>
#include <utility>

#include "liegroup/concepts.hpp"

namespace liesl {

/// (G1, G2, ...), composed factor by factor. The tangents are stacked in the order of the factors,
/// every operator is block diagonal. Product<SE3, Rn<2>> H(frame, modes); H.get<0>() is the frame.
template <LieGroup... Gs>
struct Product {
  static constexpr int dim = (Gs::dim + ...);
  using Tangent = Eigen::Matrix<double, dim, 1>;
  using Matrix = Eigen::Matrix<double, dim, dim>;
  template <std::size_t I>
  using Part = std::tuple_element_t<I, std::tuple<Gs...>>;

  std::tuple<Gs...> parts;

  Product() = default;
  explicit Product(const Gs&... factors) : parts(factors...) {}

  template <std::size_t I>
  Part<I>& get() {
    return std::get<I>(parts);
  }
  template <std::size_t I>
  const Part<I>& get() const {
    return std::get<I>(parts);
  }
  /// First row of factor I in the tangent.
  template <std::size_t I>
  static constexpr int offset() {
    constexpr int dims[] = {Gs::dim...};
    int sum = 0;
    for (std::size_t i = 0; i < I; ++i) sum += dims[i];
    return sum;
  }
  /// Rows of factor I.
  template <std::size_t I>
  static typename Part<I>::Tangent segment(const Tangent& h) {
    return h.template segment<Part<I>::dim>(offset<I>());
  }

  static Product identity() { return {}; }
  Product operator*(const Product& other) const {
    Product H;
    for_each([&](auto i) { H.template get<i>() = get<i>() * other.template get<i>(); });
    return H;
  }
  Product inverse() const {
    Product H;
    for_each([&](auto i) { H.template get<i>() = get<i>().inverse(); });
    return H;
  }

  static Product exp(const Tangent& h) {
    Product H;
    for_each([&](auto i) { H.template get<i>() = Part<i>::exp(segment<i>(h)); });
    return H;
  }
  static Tangent log(const Product& H) {
    Tangent h;
    for_each([&](auto i) {
      h.template segment<Part<i>::dim>(offset<i>()) = Part<i>::log(H.template get<i>());
    });
    return h;
  }
  static void log_and_Tinv(const Product& H, Tangent& d, Matrix& Tinv_d) {
    d = log(H);
    Tinv_d = Tinv(d);
  }

  Matrix Ad() const {
    return blocks([&](auto i) { return get<i>().Ad(); });
  }
  Matrix AdInv() const {
    return blocks([&](auto i) { return get<i>().AdInv(); });
  }
  static Matrix ad(const Tangent& h) {
    return blocks([&](auto i) { return Part<i>::ad(segment<i>(h)); });
  }

  static Matrix T(const Tangent& h) {
    return blocks([&](auto i) { return Part<i>::T(segment<i>(h)); });
  }
  static Matrix Tinv(const Tangent& h) {
    return blocks([&](auto i) { return Part<i>::Tinv(segment<i>(h)); });
  }
  static Matrix dT(const Tangent& h, const Tangent& a) {
    return blocks([&](auto i) { return Part<i>::dT(segment<i>(h), segment<i>(a)); });
  }
  static Matrix dTinv(const Tangent& h, const Tangent& a) {
    return blocks([&](auto i) { return Part<i>::dTinv(segment<i>(h), segment<i>(a)); });
  }
  static Matrix dTinvT(const Tangent& h, const Tangent& n) {
    return blocks([&](auto i) { return Part<i>::dTinvT(segment<i>(h), segment<i>(n)); });
  }

 private:
  /// f(index) for every factor, the index a compile-time constant.
  template <class F>
  static void for_each(const F& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (f(std::integral_constant<std::size_t, I>{}), ...);
    }
    (std::index_sequence_for<Gs...>{});
  }

  /// diag(f(0), f(1), ...)
  template <class F>
  static Matrix blocks(const F& f) {
    Matrix M = Matrix::Zero();
    for_each([&](auto i) {
      M.template block<Part<i>::dim, Part<i>::dim>(offset<i>(), offset<i>()) = f(i);
    });
    return M;
  }
};

}  // namespace liesl
