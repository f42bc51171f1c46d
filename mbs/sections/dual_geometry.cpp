/// @file
/// A, I, J and Cowper's shear factors of each shape.
///
/// Shear factors: G. R. Cowper, The shear coefficient in Timoshenko's beam theory, J. Appl. Mech.
/// 33 (1966) 335-340, table 1. Torsion: S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd
/// ed., ch. 10 (art. 109 rectangle, art. 115 closed thin walls, art. 112 open thin walls).

#include "mbs/sections/dual_geometry.hpp"

#include <numbers>
#include <stdexcept>

#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {

namespace {

using std::numbers::pi;

/// J of a rectangle, exact: a b^3/3 [1 - (192 b)/(pi^5 a) sum_{n odd} tanh(n pi a/(2b))/n^5], a >=
/// b, with sum 1/n^5 = 31 zeta(5)/32 and 1 - tanh(x/2) = 2/(e^x + 1), whose terms fall as e^{-n
/// pi}: the five terms kept leave less than 1e-16.
Dual2 rectangle_torsion(Dual2 width, Dual2 height) {
  const bool wide = width.v >= height.v;
  const Dual2 a = wide ? width : height, b = wide ? height : width;
  constexpr double odd_zeta5 = 31.0 / 32 * 1.0369277551433699263;
  Dual2 sum = odd_zeta5;
  for (int n = 1; n <= 9; n += 2) {
    const Dual2 e = exp(-n * pi * a / b);
    sum = sum - 2 * e / (1 + e) / power(Dual2(n), 5);
  }
  return a * power(b, 3) / 3 * (1 - 192 / power(Dual2(pi), 5) * b / a * sum);
}

/// Cowper's factor of thin-walled I and box sections, shear along the webs: m = area of the flanges
/// / area of the webs, `flanges` = the term of the horizontal shear in the flanges.
Dual2 thin_walled_shear_factor(Dual2 m, Dual2 flanges, double nu) {
  const Dual2 m2 = m * m, m3 = m2 * m;
  return 10 * (1 + nu) * power(1 + 3 * m, 2) /
         (12 + 72 * m + 150 * m2 + 90 * m3 + nu * (11 + 66 * m + 135 * m2 + 90 * m3) + flanges);
}

/// One wall thickness: m = n = b/h, with b and h between the centre lines of the walls.
Dual2 box_shear_factor(Dual2 b, Dual2 h, double nu) {
  const Dual2 m = b / h;
  return thin_walled_shear_factor(m, 10 * m * m * ((3 + nu) * m + 3 * m * m), nu);
}

DualGeometry circle(Dual2 d, double nu) {
  const Dual2 I = pi / 64 * power(d, 4);
  const double k = 6 * (1 + nu) / (7 + 6 * nu);
  return {.A = pi / 4 * d * d, .Iy = I, .Iz = I, .J = 2 * I, .ky = k, .kz = k};
}

DualGeometry tube(Dual2 D, Dual2 t, double nu) {
  const Dual2 d = D - 2 * t;
  const Dual2 A = pi * t * (D - t);
  const Dual2 I = A * (D * D + d * d) / 16;
  const Dual2 m2 = d * d / (D * D), p = power(1 + m2, 2);
  const Dual2 k = 6 * (1 + nu) * p / ((7 + 6 * nu) * p + (20 + 12 * nu) * m2);
  return {.A = A, .Iy = I, .Iz = I, .J = 2 * I, .ky = k, .kz = k};
}

DualGeometry rectangle(Dual2 w, Dual2 h, double nu) {
  const double k = 10 * (1 + nu) / (12 + 11 * nu);
  return {.A = w * h,
          .Iy = w * power(h, 3) / 12,
          .Iz = h * power(w, 3) / 12,
          .J = rectangle_torsion(w, h),
          .ky = k,
          .kz = k};
}

/// J: Bredt, 4 A_m^2 / (perimeter/t) of the centre line. Against Prandtl's solution of a square box
/// it is low by 1.1, 2.4, 5.4 and 7.1 % at t/width = 1/40, 1/20, 1/10 and 1/8 (tests/mbs).
DualGeometry box(Dual2 W, Dual2 H, Dual2 t, double nu) {
  const Dual2 w = W - 2 * t, h = H - 2 * t, b = W - t, c = H - t;
  return {.A = 2 * t * (b + c),
          .Iy = (W * power(H, 3) - w * power(h, 3)) / 12,
          .Iz = (H * power(W, 3) - h * power(w, 3)) / 12,
          .J = 2 * t * b * b * c * c / (b + c),
          .ky = box_shear_factor(c, b, nu),
          .kz = box_shear_factor(b, c, nu)};
}

/// J: sum of s t^3/3 over the three plates (St. Venant, warping free). k_z: Cowper. k_y (shear
/// along the flanges), not in Cowper's table: the flanges carry the shear as two rectangles.
DualGeometry i_section(const std::array<Dual2, 4>& x, double nu) {
  const auto [b, H, tf, tw] = x;
  const Dual2 web = H - 2 * tf, h = H - tf;
  const Dual2 A = 2 * b * tf + web * tw;
  const Dual2 m = 2 * b * tf / (h * tw), n2 = b * b / (h * h);
  const Dual2 flanges = 30 * n2 * (m + m * m) + 5 * nu * n2 * (8 * m + 9 * m * m);
  return {.A = A,
          .Iy = (b * power(H, 3) - (b - tw) * power(web, 3)) / 12,
          .Iz = (2 * tf * power(b, 3) + web * power(tw, 3)) / 12,
          .J = (2 * b * power(tf, 3) + web * power(tw, 3)) / 3,
          .ky = 10 * (1 + nu) / (12 + 11 * nu) * 2 * b * tf / A,
          .kz = thin_walled_shear_factor(m, flanges, nu)};
}

DualGeometry of(const Circle&, const std::array<Dual2, 1>& x, double nu) {
  return circle(x[0], nu);
}
DualGeometry of(const Tube&, const std::array<Dual2, 2>& x, double nu) {
  return tube(x[0], x[1], nu);
}
DualGeometry of(const Rectangle&, const std::array<Dual2, 2>& x, double nu) {
  return rectangle(x[0], x[1], nu);
}
DualGeometry of(const Box&, const std::array<Dual2, 3>& x, double nu) {
  return box(x[0], x[1], x[2], nu);
}
DualGeometry of(const ISection&, const std::array<Dual2, 4>& x, double nu) {
  return i_section(x, nu);
}
DualGeometry of(const FullSection&, const std::array<Dual2, 0>&, double) {
  throw std::invalid_argument(
      "geometry of a section: expected a shape with dimensions, got given matrices (type full); "
      "use section_law");
}

}  // namespace

DualGeometry dual_geometry(const Shape& shape, double nu, int variable) {
  return std::visit([&](const auto& s) { return of(s, dual_dimensions(s, variable), nu); }, shape);
}

DualGeometry dual_geometry(const Section& section, double nu, int variable) {
  DualGeometry g = dual_geometry(section.shape, nu, variable);
  if (section.shear_factor[0] > 0) g.ky = section.shear_factor[0];
  if (section.shear_factor[1] > 0) g.kz = section.shear_factor[1];
  if (section.torsion_constant > 0) g.J = section.torsion_constant;
  return g;
}

}  // namespace liesl
