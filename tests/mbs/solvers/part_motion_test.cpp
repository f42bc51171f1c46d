/// @file
/// The highest harmonic of signals: tones give their frequency, whatever the record.
#include "mbs/solvers/part_motion.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "mbs/run.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::part_motion_test {
namespace {

using Eigen::MatrixXd;

constexpr double kShare = 1e-3;

/// Sums of tones over a record: amplitude and frequency [Hz] of each.
struct Record {
  std::vector<double> t;
  MatrixXd signals;
  Record(int records, double duration, const std::vector<std::array<double, 2>>& tones) {
    signals.setZero(1, records);
    for (int n = 0; n < records; ++n) {
      t.push_back(duration * n / (records - 1));
      for (const auto& [amplitude, f] : tones)
        signals(0, n) += amplitude * std::sin(2 * std::numbers::pi * f * t.back() + 0.4);
    }
  }
};

class Tone : public ::testing::TestWithParam<double> {};

/// Whole periods in the record or not: within the resolution 2/duration.
TEST_P(Tone, GivesItsFrequency) {
  const double f = GetParam(), duration = 0.3;
  for (const int records : {601, 1024, 2000}) {
    const Record r(records, duration, {{3, f}});
    EXPECT_NEAR(bandwidth(r.t, r.signals, kShare), f, 2 / duration) << records;
  }
}

INSTANTIATE_TEST_SUITE_P(Frequencies, Tone, ::testing::Values(10., 33.3, 71.7, 200., 431.));

/// The second tone has (a_2/a_1)^2 of the energy: 4e-4, or 1.1e-3 and more than the share.
TEST(Bandwidth, LeavesOutTheShareAndNoMore) {
  const Record weak(2000, 1, {{1, 20}, {0.02, 200}}), strong(2000, 1, {{1, 20}, {0.033, 200}});
  EXPECT_NEAR(bandwidth(weak.t, weak.signals, kShare), 20, 2);
  EXPECT_NEAR(bandwidth(strong.t, strong.signals, kShare), 200, 2);
}

TEST(Bandwidth, CountsAllSignalsTogether) {
  const Record low(2000, 1, {{1, 20}}), high(2000, 1, {{1, 300}});
  MatrixXd both(2, 2000);
  both << low.signals, high.signals;
  EXPECT_NEAR(bandwidth(low.t, both, kShare), 300, 2);
  both.row(1) *= 1e-3;
  EXPECT_NEAR(bandwidth(low.t, both, kShare), 20, 2);
}

TEST(Bandwidth, OfUnequalStepsIsThatOfEqualOnes) {
  Record even(4000, 1, {{1, 40}}), uneven = even;
  for (std::size_t n = 0; n < uneven.t.size(); ++n) {
    uneven.t[n] += 0.1 * std::sin(3 * uneven.t[n]) / 3;
    uneven.signals(0, static_cast<int>(n)) =
        std::sin(2 * std::numbers::pi * 40 * uneven.t[n] + 0.4);
  }
  EXPECT_NEAR(bandwidth(uneven.t, uneven.signals, kShare), 40, 2);
}

TEST(Bandwidth, OfWhatDoesNotChangeIsNothing) {
  std::vector<double> t;
  for (int n = 0; n <= 100; ++n) t.push_back(0.02 * n);  // sees up to 25 Hz
  EXPECT_LE(bandwidth(t, MatrixXd::Ones(2, 101), kShare), 2 / t.back());
  EXPECT_EQ(bandwidth(t, MatrixXd::Zero(2, 101), kShare), 0);
  EXPECT_EQ(bandwidth({0, 1}, MatrixXd::Ones(1, 2), kShare), 0);
  EXPECT_EQ(bandwidth({}, MatrixXd(3, 0), kShare), 0);
}

/// A planar and a spatial rod: the squares of the signals are twice the elastic energy.
template <class G>
class RodSignals : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(RodSignals, Groups);

TYPED_TEST(RodSignals, AreTheElasticEnergy) {
  using G = TypeParam;
  const SolidSpec spec = test::meshed_rod({0, 0, 0}, 12, 2, 3, G::space_dim == 3 ? 1 : 0);
  std::vector<G> ports;
  for (const Interface& f : spec.interfaces()) {
    ports.push_back(G::exp(G::Tangent::Zero()));
    ports.back().x = f.point.template head<G::space_dim>();
  }
  const SolidBody<G> body("rod", spec, ports, Eigen::Matrix3d::Identity());
  const MatrixXd e = 1e-4 * test::Random(3).vector(static_cast<int>(body.basis().cols()));
  const MatrixXd K = body.basis().transpose() * body.loads();
  const double twice = e.col(0).dot(K * e.col(0));
  EXPECT_NEAR(energy_signals(body, e).squaredNorm(), twice, 1e-10 * twice);
}

}  // namespace
}  // namespace liesl::test::part_motion_test
