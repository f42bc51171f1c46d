#include "mbs/sections/shape_dimensions.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace liesl {

namespace {

template <class T>
using Of = ShapeDimensions<std::remove_cvref_t<T>>;

}  // namespace

std::vector<std::string_view> dimensions(const Shape& shape) {
  return std::visit(
      [](const auto& s) {
        const auto& names = Of<decltype(s)>::names;
        return std::vector<std::string_view>(names.begin(), names.end());
      },
      shape);
}

int dimension_index(const Shape& shape, std::string_view name) {
  const auto names = dimensions(shape);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return int(i);
  const auto kind = std::visit([](const auto& s) { return Of<decltype(s)>::shape; }, shape);
  std::string known;
  for (const auto& n : names) known += fmt::format("{}{}", known.empty() ? "" : ", ", n);
  throw std::invalid_argument(
      fmt::format("section of type {}: expected a dimension of [{}], got \"{}\"{}", kind, known,
                  name, names.empty() ? "; given matrices have no dimensions to change" : ""));
}

double dimension(const Shape& shape, std::string_view name) {
  const int i = dimension_index(shape, name);
  return std::visit([i](const auto& s) { return dual_dimensions(s, -1).data()[i].v; }, shape);
}

Shape with_dimension(Shape shape, std::string_view name, double value) {
  const int i = dimension_index(shape, name);
  std::visit(
      [&](auto& s) {
        std::apply(
            [&](auto&... x) {
              int k = 0;
              (void)k;  // a full section has no x
              ((k++ == i ? void(x = value) : void()), ...);
            },
            Of<decltype(s)>::of(s));
      },
      shape);
  return shape;
}

}  // namespace liesl
