/// @file
/// Chains of segments against beams on the group in a slider-crank: what sets them apart falls with
/// the square of the slenderness.

#include "mbs/run.hpp"

namespace liesl::test::segment_slenderness_test {
namespace {

/// The slider-crank with all diameters times `scale` and EI and the mass per length as before, so
/// that it bends and moves the same but for shear, stretch and rotary inertia.
Mechanism of_diameters(double scale, int elements, Formalism formalism) {
  Mechanism m = slider_crank({.elements = elements, .ramp = 0.02});
  m.formalism = formalism;
  for (std::size_t b : {0, 1}) {
    auto& beam = std::get<BeamSpec>(m.bodies[b].kind);
    for (Section& s : beam.sections) std::get<Circle>(s.shape).diameter *= scale;
    beam.material.E /= std::pow(scale, 4);
    beam.material.rho /= scale * scale;
  }
  return m;
}

/// Of the middle of the rod from that of its ends, in all records, m.
Eigen::Matrix2Xd bend(double scale, int elements, Formalism formalism) {
  const auto r =
      run_planar(of_diameters(scale, elements, formalism), options(0.04, 1e-4, 0.8, 1e-9));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  Eigen::Matrix2Xd out(2, r.trajectory().size());
  for (int i = 0; i < out.cols(); ++i) {
    const SE2* H = r.trajectory().frames(i) + elements + 1;
    out.col(i) = H[elements / 2].x - (H[0].x + H[elements].x) / 2;
  }
  return out;
}

/// Largest difference of the two in the limit of fine meshes, over the largest bend.
double difference(double scale) {
  const auto limit = [scale](Formalism formalism) -> Eigen::Matrix2Xd {
    return (4 * bend(scale, 32, formalism) - bend(scale, 16, formalism)) / 3;
  };
  const Eigen::Matrix2Xd chain = limit(Formalism::Segments);
  return (chain - limit(Formalism::SE3)).colwise().norm().maxCoeff() /
         chain.colwise().norm().maxCoeff();
}

/// From radius/length of 0.13 of the crank and 0.033 of the rod down to an eighth of that.
TEST(SegmentSlenderness, SetsItApartBySquaresInASliderCrank) {
  double before = 0;
  for (const double scale : {2., 1., 0.5, 0.25}) {
    const double now = difference(scale);
    RecordProperty("off_at_" + std::to_string(scale), std::to_string(now));
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / now), 2, 0.15) << scale << ": " << before << ", " << now;
    }
    before = now;
  }
  EXPECT_LT(before, 1e-3);
}

}  // namespace
}  // namespace liesl::test::segment_slenderness_test
