/// @file
/// What a torque of 1 N m gives at the stress points.
///
/// The torsion stress follows from equilibrium with M_x for the shape itself; a prescribed
/// `torsion_constant` changes the stiffness only. Rectangle: Timoshenko & Goodier, art. 109.

#include "mbs/sections/stress.hpp"

#include <cmath>
#include <numbers>

#include "mbs/sections/dual_geometry.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {

namespace {

using std::numbers::pi;
using Points = std::vector<DualStressPoint>;
using Rows = Eigen::Matrix<double, 3, 6>;

/// 16 points of the outer rim, the first on +y; tau = M_x r/J, tangential.
Points rim(Dual2 diameter, Dual2 J) {
  constexpr int count = 16;
  Points points(count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    const Dual2 y = diameter / 2 * std::cos(angle), z = diameter / 2 * std::sin(angle);
    points[i] = {y, z, -z / J, y / J};
  }
  return points;
}

/// Torsion stress on the long side (length a, distance b/2 from the axis) at x = fraction a/2, per
/// G theta' b: 1 - 8/pi^2 sum_{n odd} cosh(n pi x/b)/(n^2 cosh(n pi a/(2b))).
Dual2 long_side(Dual2 a, Dual2 b, double fraction) {
  const Dual2 rising = -pi * a / b * (1 - fraction) / 2, falling = -pi * a / b * (1 + fraction) / 2;
  Dual2 sum = 0;
  for (int n = 1; n * rising.v > -40; n += 2) {
    const Dual2 ratio = (exp(n * rising) + exp(n * falling)) / (1 + exp(-n * pi * a / b));
    sum = sum + ratio / (n * n);
  }
  return 1 - 8 / (pi * pi) * sum;
}

/// The same on the short side, at y = fraction b/2:
/// 8/pi^2 sum_k (-1)^k cos((2k+1) pi y/b) tanh((2k+1) pi a/(2b))/(2k+1)^2.
/// `limit` is the sum without the tanh (a/b -> infinity), the rest falls as e^{-(2k+1) pi}.
Dual2 short_side(Dual2 a, Dual2 b, double fraction, double limit) {
  Dual2 sum = limit;
  for (int k = 0; k < 6; ++k) {
    const int n = 2 * k + 1;
    const Dual2 e = exp(-n * pi * a / b);
    const double weight = (k % 2 ? -1 : 1) * std::cos(n * pi * fraction / 2) / (n * n);
    sum = sum - weight * 2 * e / (1 + e);
  }
  return 8 / (pi * pi) * sum;
}

/// Places on a side, as fractions of half of it, and the limit of short_side there.
struct SidePlace {
  double fraction, limit;
};
constexpr std::array<SidePlace, 5> side_places = {{{-0.8, 0.4474022700859631973},
                                                   {-0.5, 0.7528807525058986030},
                                                   {0, 0.9159655941772190151},
                                                   {0.5, 0.7528807525058986030},
                                                   {0.8, 0.4474022700859631973}}};

/// Corners, where torsion gives no stress, and five places on each side.
Points rectangle(Dual2 w, Dual2 h, Dual2 J) {
  const bool wide = w.v >= h.v;
  const Dual2 a = wide ? w : h, b = wide ? h : w;
  Points points;
  for (double side : {-1.0, 1.0}) {
    for (double end : {-1.0, 1.0}) points.push_back({end * w / 2, side * h / 2, 0, 0});
    for (const auto& [f, limit] : side_places) {
      const Dual2 on_long = b / J * long_side(a, b, std::abs(f));
      const Dual2 on_short = b / J * short_side(a, b, f, limit);
      points.push_back({f * w / 2, side * h / 2, -side * (wide ? on_long : on_short), 0});
      points.push_back({side * w / 2, f * h / 2, 0, side * (wide ? on_short : on_long)});
    }
  }
  return points;
}

/// Outer corners, each once for either wall that meets there; tau = M_x/(2 A_m t) (Bredt).
Points box(Dual2 W, Dual2 H, Dual2 t) {
  const Dual2 tau = 1 / (2 * (W - t) * (H - t) * t);
  Points points;
  for (double i : {-1.0, 1.0})
    for (double j : {-1.0, 1.0}) {
      points.push_back({i * W / 2, j * H / 2, -j * tau, 0});
      points.push_back({i * W / 2, j * H / 2, 0, i * tau});
    }
  return points;
}

/// Both faces of the four flange tips and the four corners web-flange; tau = M_x t/J on the faces
/// of a plate of thickness t.
Points i_section(const std::array<Dual2, 4>& x, Dual2 J) {
  const auto [b, H, tf, tw] = x;
  Points points;
  for (double i : {-1.0, 1.0})
    for (double j : {-1.0, 1.0}) {
      points.push_back({i * b / 2, j * H / 2, -j * tf / J, 0});
      points.push_back({i * b / 2, j * (H / 2 - tf), j * tf / J, 0});
      points.push_back({i * tw / 2, j * (H / 2 - tf), 0, i * tw / J});
    }
  return points;
}

Points of(const Circle&, const std::array<Dual2, 1>& x, Dual2 J) { return rim(x[0], J); }
Points of(const Tube&, const std::array<Dual2, 2>& x, Dual2 J) { return rim(x[0], J); }
Points of(const Rectangle&, const std::array<Dual2, 2>& x, Dual2 J) {
  return rectangle(x[0], x[1], J);
}
Points of(const Box&, const std::array<Dual2, 3>& x, Dual2) { return box(x[0], x[1], x[2]); }
Points of(const ISection&, const std::array<Dual2, 4>& x, Dual2 J) { return i_section(x, J); }

/// [1/A 0 0 0 z/Iy -y/Iz; 0 1/(ky A) 0 torsion_y 0 0; 0 0 1/(kz A) torsion_z 0 0], one part of it.
Rows rows(const DualStressPoint& p, const DualGeometry& g, double Dual2::*part) {
  Rows S = Rows::Zero();
  S(0, 0) = (1 / g.A).*part;
  S(0, 4) = (p.z / g.Iy).*part;
  S(0, 5) = -(p.y / g.Iz).*part;
  S(1, 1) = (1 / (g.ky * g.A)).*part;
  S(1, 3) = p.torsion_y.*part;
  S(2, 2) = (1 / (g.kz * g.A)).*part;
  S(2, 3) = p.torsion_z.*part;
  return S;
}

}  // namespace

std::vector<DualStressPoint> dual_stress_points(const Shape& shape, int variable) {
  return std::visit(
      [&](const auto& s) -> Points {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(s)>, FullSection>)
          return {};
        else
          return of(s, dual_dimensions(s, variable), dual_geometry(shape, 0, variable).J);
      },
      shape);
}

std::vector<StressPoint> stress_points(const Section& section, double nu) {
  const auto duals = dual_stress_points(section.shape, -1);
  if (duals.empty()) return {};
  const DualGeometry g = dual_geometry(section, nu, -1);
  std::vector<StressPoint> points;
  for (const auto& p : duals) points.push_back({p.y.v, p.z.v, rows(p, g, &Dual2::v)});
  return points;
}

std::vector<Rows> stress_points_derivative(const Section& section, double nu,
                                           std::string_view dimension) {
  const int variable = dimension_index(section.shape, dimension);
  const DualGeometry g = dual_geometry(section, nu, variable);
  std::vector<Rows> derivatives;
  for (const auto& p : dual_stress_points(section.shape, variable))
    derivatives.push_back(rows(p, g, &Dual2::d));
  return derivatives;
}

}  // namespace liesl
