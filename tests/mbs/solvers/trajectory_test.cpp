/// @file
/// Records of states come back as they were, however many there are.
#include "mbs/solvers/trajectory.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "mbs/run.hpp"

namespace liesl::test::trajectory_test {
namespace {

template <FrameGroup G>
State<G> state(int n, int nodes, int rows) {
  State<G> s;
  s.t = 0.1 * n;
  const auto x = [&](int size, double shift) {
    return Eigen::VectorXd(Eigen::VectorXd::LinSpaced(size, shift + n, 2 * shift + 3 * n));
  };
  for (int k = 0; k < nodes; ++k)
    s.H.push_back(G::exp(typename G::Tangent(x(G::dim, 0.01 * (k + 1)) / 100)));
  s.v = x(G::dim * nodes, 1);
  s.vdot = x(G::dim * nodes, 2);
  s.w = x(G::dim * nodes, 3);
  s.lambda = x(rows, 4);
  s.rows = x(rows + 1, 5);
  return s;
}

template <FrameGroup G>
void expect_records(const Trajectory<G>& trajectory, int count, int nodes, int rows) {
  ASSERT_EQ(trajectory.size(), count);
  State<G> found;
  for (int n = 0; n < count; ++n) {
    const State<G> s = state<G>(n, nodes, rows);
    trajectory.read(n, found);
    ASSERT_EQ(found.H.size(), s.H.size());
    for (std::size_t k = 0; k < s.H.size(); ++k) {
      EXPECT_EQ(found.H[k].R, s.H[k].R);
      EXPECT_EQ(trajectory.frames(n)[k].x, s.H[k].x);
    }
    EXPECT_EQ(trajectory.time(n), s.t);
    EXPECT_EQ(found.v, s.v);
    EXPECT_EQ(found.vdot, s.vdot);
    EXPECT_EQ(found.w, s.w);
    EXPECT_EQ(found.lambda, s.lambda);
    EXPECT_EQ(found.rows, s.rows);
    EXPECT_EQ(trajectory.rows(n), s.rows);
  }
}

template <class G>
class TrajectoryRecords : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(TrajectoryRecords, Groups);

TYPED_TEST(TrajectoryRecords, ComeBackWithAndWithoutRoom) {
  using G = TypeParam;
  constexpr int kCount = 300;
  for (const auto& [nodes, rows] : {std::pair(1, 0), std::pair(5, 3), std::pair(40, 7)})
    for (const int reserved : {0, 10, kCount}) {
      Trajectory<G> trajectory;
      if (reserved > 0) trajectory.reserve(state<G>(0, nodes, rows), reserved);
      for (int n = 0; n < kCount; ++n) trajectory.record(state<G>(n, nodes, rows));
      expect_records(trajectory, kCount, nodes, rows);
      const Trajectory<G> moved = std::move(trajectory);
      expect_records(moved, kCount, nodes, rows);
    }
}

/// More records than memory holds.
TEST(TrajectoryRecordsInAFile, ComeBackToo) {
  constexpr int kCount = 400, kNodes = 2000;
  for (const bool reserved : {true, false}) {
    Trajectory<SE3> trajectory;
    if (reserved) trajectory.reserve(state<SE3>(0, kNodes, 5), kCount);
    for (int n = 0; n < kCount; ++n) trajectory.record(state<SE3>(n, kNodes, 5));
    State<SE3> found;
    for (const int n : {0, 17, 200, kCount - 1}) {
      trajectory.read(n, found);
      EXPECT_EQ(found.v, state<SE3>(n, kNodes, 5).v);
      EXPECT_EQ(trajectory.time(n), found.t);
    }
  }
}

}  // namespace
}  // namespace liesl::test::trajectory_test
