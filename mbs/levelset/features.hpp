#pragma once
/// @file
/// CAD features at the origin, to be moved with `placed_in_plane` or `placed`. Lengths in m.

#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {

/// Material where x < 0: phi = -x. In the plane a half-plane, in space a half-space.
LevelSetPtr half_space();
/// phi = radius - |(x, y)|, the exact distance.
LevelSetPtr circle(double radius);
LevelSetPtr sphere(double radius);
/// Sides `width` along x, `height` along y (and `depth` along z), edges rounded with `fillet`; the
/// exact distance.
LevelSetPtr rectangle(double width, double height, double fillet = 0);
LevelSetPtr box(double width, double height, double depth, double fillet = 0);
/// Half-axes a, b(, c). phi = (1 - k0) k0/k1 with k0 = |x/a|, k1 = |x/a^2| (componentwise): slope
/// one on the outline.
LevelSetPtr ellipse(double a, double b);
LevelSetPtr ellipsoid(double a, double b, double c);
/// Thesis eq. 3.4, |x/a|^xi + |y/b|^eta = 1 on the outline, exponents > 1. With g the left side to
/// the power 2/(xi + eta), phi = (1 - g) k0/k1, k0 and k1 those of the ellipse.
LevelSetPtr super_ellipse(double a, double b, double xi, double eta);

/// Thesis eq. 3.5 (Gielis 2003): r(theta) = size (|cos(m theta/4)/a|^n2 + |sin(m
/// theta/4)/b|^n3)^(-1/n1), theta in [0, 2 pi); phi = r(theta) - |(x, y)|. The outline is closed
/// for whole m (with a = b and n2 = n3) or even m; it is smooth where n2 and n3 exceed 1.
struct Superformula {
  double size = 1, a = 1, b = 1, m = 4, n1 = 2, n2 = 2, n3 = 2;
};
LevelSetPtr superformula(const Superformula& s);

/// Material where |z| < height/2.
LevelSetPtr slab(double height);

}  // namespace liesl::levelset
