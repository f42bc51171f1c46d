/// @file
/// What a parabola is higher than three samples of it.
#include "mbs/system/vertex.hpp"

#include <gtest/gtest.h>

namespace liesl::test::vertex_test {
namespace {

/// 5 - 2 (x - 0.3)^2
Sample of_parabola(double at) { return {at, 5 - 2 * (at - 0.3) * (at - 0.3)}; }

TEST(Vertex, OfAParabolaIsItsOwnWhereverTheSamplesAre) {
  for (const double middle : {0.2, 0.3, 0.35}) {
    const Sample a = of_parabola(-0.1), b = of_parabola(middle), c = of_parabola(1.2);
    EXPECT_NEAR(b.value + vertex_above(a, b, c), 5, 1e-14) << middle;
  }
}

TEST(Vertex, OfEqualDistancesIsTheKnownFormula) {
  const double before = 1.5, middle = 2, after = 1.9;
  EXPECT_NEAR(vertex_above({-1, before}, {0, middle}, {1, after}),
              -(after - before) * (after - before) / (8 * (before - 2 * middle + after)), 1e-15);
}

TEST(Vertex, OfALineIsNone) { EXPECT_EQ(vertex_above({0, 2}, {1, 2}, {3, 2}), 0); }

}  // namespace
}  // namespace liesl::test::vertex_test
