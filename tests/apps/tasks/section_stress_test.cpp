/// The largest stress of a section, four points at once, against its points one by one.

#include "apps/tasks/section_stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl::test::section_stress_test {
namespace {

/// Two elements of a shape; the first grows by 1.3 in one dimension, the second has it.
BeamSpec beam_of(const Shape& shape) {
  const auto name = dimensions(shape).front();
  const Section thin{"thin", shape},
      thick{"thick", with_dimension(shape, name, 1.3 * dimension(shape, name))};
  BeamSpec beam;
  beam.material.nu = 0.3;
  beam.sections = {thin, thick};
  beam.ends = {{thin, thick}, {thick, thick}};
  return beam;
}

/// Of the points of one end.
double largest(const BeamSpec& beam, std::size_t e, ElementPlace end, const SE3::Tangent& force) {
  const auto points = element_stress_points(beam, e);
  const std::size_t half = points.size() / 2, first = end == ElementPlace::First ? 0 : half;
  double square = 0;
  for (std::size_t i = first; i < first + half; ++i) {
    const Eigen::Vector3d s = points[i].S * force;
    square = std::max(square, s[0] * s[0] + 3 * s.tail<2>().squaredNorm());
  }
  return std::sqrt(square);
}

TEST(SectionStress, IsTheLargestOfThePointsOfAnEnd) {
  const SE3::Tangent force{300, 20, -10, 0.3, -2, 3};
  for (const Shape& shape :
       {Shape(Circle{0.02}), Shape(Tube{0.02, 0.002}), Shape(Rectangle{0.02, 0.005}),
        Shape(Box{0.02, 0.03, 0.002}), Shape(ISection{0.02, 0.03, 0.003, 0.002})}) {
    BodySpec body;
    body.kind = beam_of(shape);
    const auto& beam = std::get<BeamSpec>(body.kind);
    const SectionStress stress(body);
    ASSERT_FALSE(stress.empty());
    for (int k = 0; k < 6; ++k)
      for (std::size_t e = 0; e < 2; ++e)
        for (const auto end : {ElementPlace::First, ElementPlace::Last}) {
          SE3::Tangent turned = force;
          turned[k] *= -2.5;
          const double expected = largest(beam, e, end, turned);
          EXPECT_NEAR(stress(e, end, turned), expected, 1e-14 * expected);
        }
    EXPECT_LT(stress(0, ElementPlace::Last, force),
              (1 - 1e-3) * stress(0, ElementPlace::First, force));
  }
}

TEST(SectionStress, IsNoneOfBodiesWithoutAShape) {
  EXPECT_TRUE(SectionStress({"rigid", RigidSpec{}}).empty());
  BeamSpec beam;
  beam.sections = {Section{"full", FullSection{}}};
  EXPECT_TRUE(SectionStress({"full", beam}).empty());
}

}  // namespace
}  // namespace liesl::test::section_stress_test
