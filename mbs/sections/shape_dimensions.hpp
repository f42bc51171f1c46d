#pragma once
/// @file
/// The dimensions of each shape by name and as a list: the only place that enumerates them.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "mbs/sections/dual2.hpp"
#include "mbs/sections/section.hpp"

namespace liesl {

/// ShapeDimensions<T>::names, and ShapeDimensions<T>::of(shape): references in the same order.
template <class T>
struct ShapeDimensions;

template <>
struct ShapeDimensions<Circle> {
  static constexpr std::string_view shape = "circle";
  static constexpr std::array<std::string_view, 1> names = {"diameter"};
  static auto of(auto& s) { return std::tie(s.diameter); }
};
template <>
struct ShapeDimensions<Tube> {
  static constexpr std::string_view shape = "tube";
  static constexpr std::array<std::string_view, 2> names = {"diameter", "thickness"};
  static auto of(auto& s) { return std::tie(s.diameter, s.thickness); }
};
template <>
struct ShapeDimensions<Rectangle> {
  static constexpr std::string_view shape = "rectangle";
  static constexpr std::array<std::string_view, 2> names = {"width", "height"};
  static auto of(auto& s) { return std::tie(s.width, s.height); }
};
template <>
struct ShapeDimensions<Box> {
  static constexpr std::string_view shape = "box";
  static constexpr std::array<std::string_view, 3> names = {"width", "height", "thickness"};
  static auto of(auto& s) { return std::tie(s.width, s.height, s.thickness); }
};
template <>
struct ShapeDimensions<ISection> {
  static constexpr std::string_view shape = "I";
  static constexpr std::array<std::string_view, 4> names = {"width", "height", "flange_thickness",
                                                            "web_thickness"};
  static auto of(auto& s) {
    return std::tie(s.width, s.height, s.flange_thickness, s.web_thickness);
  }
};
template <>
struct ShapeDimensions<FullSection> {
  static constexpr std::string_view shape = "full";
  static constexpr std::array<std::string_view, 0> names = {};
  static auto of(auto&) { return std::tuple<>(); }
};

/// The dimensions as dual numbers; number `variable` is the one to differentiate by (-1: none).
template <class T>
auto dual_dimensions(const T& shape, int variable) {
  std::array<Dual2, ShapeDimensions<T>::names.size()> x;
  std::apply(
      [&](const auto&... value) {
        std::size_t i = 0;
        ((x[i] = Dual2(value, int(i) == variable ? 1 : 0), ++i), ...);
      },
      ShapeDimensions<T>::of(shape));
  return x;
}

/// Names of the dimensions of a shape ("diameter", "thickness", ...); empty for FullSection.
std::vector<std::string_view> dimensions(const Shape& shape);

/// Value of a named dimension. @throws std::invalid_argument for an unknown name.
double dimension(const Shape& shape, std::string_view name);

/// The same shape with one dimension changed. @throws std::invalid_argument for an unknown name.
Shape with_dimension(Shape shape, std::string_view name, double value);

/// Place of a dimension in `names`. @throws std::invalid_argument with the names there are.
int dimension_index(const Shape& shape, std::string_view name);

}  // namespace liesl
