/// @file
/// The slider-crank against independently computed values (published.hpp).

#include "mbs/run.hpp"
#include "reference/published.hpp"

namespace liesl::test::slider_crank_test {
namespace {

using test::SliderCrankRow;

void expect_row(const SliderCrankRow& row) {
  test::SliderCrank p;
  p.elements = row.elements;
  p.rod = row.rod;
  const auto r = test::run_planar(test::slider_crank(p), test::options(0.12, row.step));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  const int n = row.elements;
  EXPECT_NEAR(test::largest_chord_offset(r.trajectory(), n + 1, n), row.offset,
              row.offset_tolerance);
  if (row.slider > 0) {
    EXPECT_NEAR(r.trajectory().frames(r.last())[2 * (n + 1)].x.x(), row.slider,
                row.slider_tolerance);
  }
  if (row.rod == 0.010 && row.step == 1e-4) {
    EXPECT_EQ(r.report().factorizations, std::vector<int>({1, 1, 1}));
    EXPECT_LE(double(r.report().newton_iterations), 3.5 * double(r.report().steps));
  }
}

TEST(SliderCrank, EightElements) {
  expect_row({8, 1e-4, 0.010, 1.2576e-3, 0.00006e-3, 0.169652, 0.6e-6});
}
TEST(SliderCrank, EightElementsFineStep) {
  expect_row({8, 2.5e-5, 0.010, 1.25659e-3, 0.00001e-3, 0.1696538, 0.6e-7});
}
TEST(SliderCrank, SixteenElements) {
  expect_row({16, 2.5e-5, 0.010, 1.27081e-3, 0.00002e-3, 0, 0});
}
TEST(SliderCrank, ThirtyTwoElements) {
  expect_row({32, 2.5e-5, 0.010, 1.27637e-3, 0.000025e-3, 0, 0});
}
TEST(SliderCrank, UniformDiameters) {
  expect_row({8, 1e-4, 0.006, 3.908e-3, 0.0006e-3, 0, 0});
  expect_row({8, 1e-4, 0.008, 1.927e-3, 0.0006e-3, 0, 0});
  expect_row({8, 1e-4, 0.012, 0.900e-3, 0.0006e-3, 0, 0});
  expect_row({8, 1e-4, 0.016, 0.514e-3, 0.0006e-3, 0, 0});
}

}  // namespace
}  // namespace liesl::test::slider_crank_test
