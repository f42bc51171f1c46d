#include "mbs/sections/section_errors.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {

namespace {

template <class T>
using Of = ShapeDimensions<std::remove_cvref_t<T>>;

/// "" or the first dimension that is not a positive length.
template <class T>
std::string not_positive(const T& shape) {
  const auto x = dual_dimensions(shape, -1);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!(x[i].v > 0 && std::isfinite(x[i].v)))
      return fmt::format("{}: expected {} > 0 (m), got {}", Of<T>::shape, Of<T>::names[i], x[i].v);
  return {};
}

/// "" or the complaint that the wall is too thick: `name` must stay below `limit`.
std::string too_thick(std::string_view shape, std::string_view name, double value, double limit,
                      std::string_view limit_name, std::string_view hint) {
  if (value < limit) return {};
  return fmt::format("{}: expected {} < {} = {} m, got {} m; {}", shape, name, limit_name, limit,
                     value, hint);
}

std::string walls(const Circle&) { return {}; }
std::string walls(const Rectangle&) { return {}; }

std::string walls(const Tube& s) {
  return too_thick("tube", "thickness", s.thickness, s.diameter / 2, "diameter/2",
                   "a tube without a bore is a circle");
}

std::string walls(const Box& s) {
  const bool narrow = s.width < s.height;
  return too_thick("box", "thickness", s.thickness, std::min(s.width, s.height) / 2,
                   narrow ? "width/2" : "height/2", "a box without a hollow is a rectangle");
}

std::string walls(const ISection& s) {
  auto wrong = too_thick("I", "flange_thickness", s.flange_thickness, s.height / 2, "height/2",
                         "flanges that meet make a rectangle");
  if (!wrong.empty()) return wrong;
  return too_thick("I", "web_thickness", s.web_thickness, s.width, "width",
                   "a web as wide as the flanges makes a rectangle");
}

std::string wrong_matrix(const Eigen::Matrix<double, 6, 6>& m, std::string_view name) {
  if (!m.allFinite()) return fmt::format("full: expected a finite {} matrix", name);
  for (int i = 0; i < 6; ++i)
    if (!(m(i, i) > 0))
      return fmt::format("full: expected a positive definite {} matrix, got {} at ({}, {})", name,
                         m(i, i), i + 1, i + 1);
  // Units differ by row: judge the matrix scaled to a unit diagonal.
  const Eigen::Matrix<double, 6, 1> d = m.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::Matrix<double, 6, 6> scaled = d.asDiagonal() * m * d.asDiagonal();
  int i, j;
  if ((scaled - scaled.transpose()).cwiseAbs().maxCoeff(&i, &j) > 1e-9)
    return fmt::format(
        "full: expected a symmetric {} matrix, got {} at ({}, {}) but {} at ({}, {})", name,
        m(i, j), i + 1, j + 1, m(j, i), j + 1, i + 1);
  if (Eigen::LLT<Eigen::Matrix<double, 6, 6>>(scaled).info() != Eigen::Success)
    return fmt::format(
        "full: expected a positive definite {} matrix, got a negative or zero "
        "eigenvalue; an off-diagonal term is too large",
        name);
  return {};
}

}  // namespace

std::string what_is_wrong(const Shape& shape) {
  if (const auto* full = std::get_if<FullSection>(&shape)) {
    const auto wrong = wrong_matrix(full->stiffness, "stiffness");
    return wrong.empty() ? wrong_matrix(full->inertia, "inertia") : wrong;
  }
  return std::visit(
      [](const auto& s) -> std::string {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, FullSection>) {
          return {};
        } else {
          const auto wrong = not_positive(s);
          return wrong.empty() ? walls(s) : wrong;
        }
      },
      shape);
}

std::string what_is_wrong(const Section& section) {
  for (double k : section.shear_factor)
    if (!(k >= 0 && k <= 2))
      return fmt::format(
          "section \"{}\": expected shear factors between 0 (Cowper's value) and 2, got {}",
          section.name, k);
  if (!(section.torsion_constant >= 0 && std::isfinite(section.torsion_constant)))
    return fmt::format(
        "section \"{}\": expected torsion_constant >= 0 (m^4; 0 = the value of "
        "the shape), got {}",
        section.name, section.torsion_constant);
  const auto wrong = what_is_wrong(section.shape);
  return wrong.empty() ? wrong : fmt::format("section \"{}\": {}", section.name, wrong);
}

std::string what_is_wrong(const Material& m) {
  const auto say = [&](std::string_view expected, double got) {
    return fmt::format("material \"{}\": expected {}, got {}", m.name, expected, got);
  };
  if (!(m.E > 0 && std::isfinite(m.E))) return say("E > 0 (Pa; steel has 210e9)", m.E);
  if (!(m.nu > -1 && m.nu <= 0.5)) return say("-1 < nu <= 0.5 (steel has 0.3)", m.nu);
  if (!(m.rho > 0 && std::isfinite(m.rho))) return say("rho > 0 (kg/m^3; steel has 7850)", m.rho);
  return {};
}

}  // namespace liesl
