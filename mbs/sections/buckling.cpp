#include "mbs/sections/buckling.hpp"

#include <cmath>
#include <numbers>

#include "mbs/sections/dual2.hpp"

namespace liesl {

namespace {

/// EI of the weak axis; of an oblique section the smaller eigenvalue of the bending stiffness.
WithDerivative weak_bending(const SectionLaw& law, const SectionLaw& by) {
  const double a = law.K(4, 4), b = law.K(5, 5), c = law.K(4, 5);
  const double half = 0.5 * (a - b), root = std::hypot(half, c);
  const double sum = 0.5 * (by.K(4, 4) + by.K(5, 5));
  if (root == 0) return {0.5 * (a + b), std::min(by.K(4, 4), by.K(5, 5))};
  const double half_by = 0.5 * (by.K(4, 4) - by.K(5, 5));
  return {0.5 * (a + b) - root, sum - (half * half_by + c * by.K(4, 5)) / root};
}

/// Dimensions of a section and their derivatives, from its law and its stress rows.
struct Lines {
  const WalledSection& s;
  double E;

  Dual2 A() const { return over_E(0); }
  Dual2 Iy() const { return over_E(4); }
  /// |y| and |z| of a stress point, from -y/I_z and z/I_y.
  Dual2 y(std::size_t point) const { return magnitude(entry(point, 5) * over_E(5)); }
  Dual2 z(std::size_t point) const { return magnitude(entry(point, 4) * over_E(4)); }

 private:
  Dual2 over_E(int i) const { return {s.law.K(i, i) / E, s.by.K(i, i) / E}; }
  Dual2 entry(std::size_t point, int column) const {
    return {s.points[point].S(0, column), s.by_points.empty() ? 0 : s.by_points[point](0, column)};
  }
  static Dual2 magnitude(Dual2 a) { return a.v < 0 ? -a : a; }
};

/// m = A^2/(4 pi I): t/R = 2 (1 - sqrt(1 - m^2))/m.
Dual2 tube(const Lines& lines, double E, double nu) {
  const Dual2 A = lines.A(), m = A * A / (4 * std::numbers::pi * lines.Iy());
  return E / std::sqrt(3 * (1 - nu * nu)) * (2 * m / (1 + sqrt(1 - m * m)));
}

Dual2 plate(double k, Dual2 t, Dual2 b, double E, double nu) {
  const double pi = std::numbers::pi;
  return k * pi * pi * E / (12 * (1 - nu * nu)) * power(t / b, 2);
}

/// Corners of the walls along y (even points) and along z (odd); A = 2 t (W + H) - 4 t^2.
Dual2 box(const Lines& lines, std::size_t point, double E, double nu) {
  const Dual2 W = 2 * lines.y(point), H = 2 * lines.z(point), sum = W + H;
  const Dual2 t = lines.A() / (sum + sqrt(sum * sum - 4 * lines.A()));
  return plate(4, t, (point % 2 == 0 ? W : H) - t, E, nu);
}

/// By three: outer and inner face of a flange's tip, end of the web.
Dual2 i_section(const Lines& lines, std::size_t point, double E, double nu) {
  const std::size_t tip = point - point % 3;
  const Dual2 half = lines.z(tip), inner = lines.z(tip + 1), t_f = half - inner;
  if (point % 3 == 2) return plate(4, 2 * lines.y(point), half + inner, E, nu);
  const double pi = std::numbers::pi;
  return plate(6 * (1 - nu) / (pi * pi), t_f, lines.y(tip), E, nu);
}

}  // namespace

WithDerivative euler_load(const SectionLaw& law, const SectionLaw& by, double length) {
  const WithDerivative EI = weak_bending(law, by);
  const double factor = std::numbers::pi * std::numbers::pi / (length * length);
  return {factor * EI.value, factor * EI.derivative};
}

bool has_walls(const Shape& shape) {
  return std::holds_alternative<Tube>(shape) || std::holds_alternative<Box>(shape) ||
         std::holds_alternative<ISection>(shape);
}

WithDerivative wall_buckling_stress(const WalledSection& s, std::size_t point,
                                    const Material& material, double knock_down) {
  const double E = material.E, nu = material.nu;
  const Lines lines{s, E};
  const Dual2 stress = std::holds_alternative<Tube>(s.section.shape) ? tube(lines, E, nu)
                       : std::holds_alternative<Box>(s.section.shape)
                           ? box(lines, point, E, nu)
                           : i_section(lines, point, E, nu);
  return {knock_down * stress.v, knock_down * stress.d};
}

}  // namespace liesl
