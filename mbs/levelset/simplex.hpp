#pragma once
/// @file
/// A linear function on a triangle or tetrahedron: the share of it where the function is positive;
/// and how a square or cube is cut into simplices.

#include <array>
#include <utility>

namespace liesl::levelset {

/// Share of the simplex where the linear function with the corner values f is >= 0:
///   one positive:     f0^n / prod_j (f0 - f_j)
///   two of four:      [a^2 b^2 + a b (a + b)(c + d) + c d (a^2 + a b + b^2)]
///                     / [(a + c)(a + d)(b + c)(b + d)],  a, b >= 0, -c, -d < 0
/// and the complement for one negative. C1 in f for a change of its signs. T: double or Dual.
template <class T, std::size_t Corners>
T positive_share(std::array<T, Corners> f) {
  static_assert(Corners == 3 || Corners == 4);
  std::size_t positive = 0;  // sorted to the front
  for (std::size_t i = 0; i < Corners; ++i)
    if (!(f[i] < T(0.0))) std::swap(f[i], f[positive++]);
  if (positive == 0) return T(0.0);
  if (positive == Corners) return T(1.0);
  if (Corners == 4 && positive == 2) {
    const T a = f[0], b = f[1], c = -f[2], d = -f[Corners - 1];
    return (a * a * b * b + a * b * (a + b) * (c + d) + c * d * (a * a + a * b + b * b)) /
           ((a + c) * (a + d) * (b + c) * (b + d));
  }
  const std::size_t single = positive == 1 ? 0 : Corners - 1;
  T share(1.0);
  for (std::size_t j = 0; j < Corners; ++j)
    if (j != single) share = share * f[single] / (f[single] - f[j]);
  return positive == 1 ? share : T(1.0) - share;
}

/// Corners of a square, 0..3 counter-clockwise, in two triangles; of a cube, 0..3 below and 4..7
/// above, in five tetrahedra, all of positive volume. Two ways each, for squares and cubes of even
/// and odd place (i + j + k): then the cuts of neighbours meet.
inline constexpr std::array<std::array<std::array<int, 3>, 2>, 2> kTriangles = {
    {{{{0, 1, 2}, {0, 2, 3}}}, {{{0, 1, 3}, {1, 2, 3}}}}};
inline constexpr std::array<std::array<std::array<int, 4>, 5>, 2> kTetrahedra = {
    {{{{0, 1, 2, 5}, {0, 2, 3, 7}, {0, 5, 7, 4}, {2, 7, 5, 6}, {0, 2, 7, 5}}},
     {{{1, 3, 0, 4}, {1, 2, 3, 6}, {1, 6, 4, 5}, {3, 4, 6, 7}, {1, 3, 4, 6}}}}};

}  // namespace liesl::levelset
