/// @file
/// Beams of fourth order under loads per length that follow them or are moments.
#include <gtest/gtest.h>

#include <cmath>

#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"
#include "reference/mechanisms.hpp"

namespace liesl::test::line_load_test {
namespace {

Mechanism with_load(std::vector<SE3> nodes, const SE3::Tangent& stiffness,
                    const SE3::Tangent& wrench, bool follower) {
  Mechanism m = test::cantilever(test::beam(std::move(nodes), test::section(stiffness)));
  std::get<BeamSpec>(m.bodies[0].kind).order = 4;
  LoadSpec load = test::tip_load(m, wrench.head<3>(), wrench.tail<3>());
  load.spread = true;
  load.follower = follower;
  m.loads.push_back(load);
  return m;
}

SE3::Tangent wrench(double fx, double fy, double fz, double mx, double my, double mz) {
  return (SE3::Tangent() << fx, fy, fz, mx, my, mz).finished();
}

std::vector<SE3> straight_axis(int n) { return straight({0, 0, 0}, {1, 0, 0}, n); }

/// A parabola: its curvature varies.
std::vector<SE3> curved_axis(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 16; ++i) points.push_back({i / 16.0, 0.5 * i * i / 256.0, 0});
  return spline(points, n);
}

const SE3::Tangent kSlender = test::diagonal(1e5, 4e4, 2, 1), kThick = test::diagonal(40, 20, 2, 1);

struct Case {
  const char* name;
  std::vector<SE3> (*axis)(int);
  SE3::Tangent stiffness, load;
  bool follower;
};

const Case kCases[] = {
    {"pressure", straight_axis, kSlender, wrench(0, 12, 0, 0, 0, 0), true},
    {"pressure on a thick beam", straight_axis, kThick, wrench(2, 8, 0, 0, 0, 0), true},
    {"moment that follows", straight_axis, kThick, wrench(0, 3, 0, 0, 0, 3), true},
    {"pressure in space", curved_axis, kSlender, wrench(2, 3, -5, 0.5, 1, 0.5), true},
    {"pressure in space, thick", curved_axis, kThick, wrench(2, 3, -5, 0.5, 1, 0.5), true},
    {"dead moment", straight_axis, kSlender, wrench(0, 0, 0, 0, 0, 3), false},
    {"dead moment in space", curved_axis, kSlender, wrench(0, 1, 3, 1, 2, 1), false},
    {"dead moment in space, thick", curved_axis, kThick, wrench(0, 0, 0, 1, 2, 1), false},
};

TEST(LineLoad, StaticsConvergeWithTheFourthPower) {
  for (const Case& c : kCases) {
    const auto tip = [&](int n) {
      return test::tip_displacement(with_load(c.axis(n), c.stiffness, c.load, c.follower));
    };
    const Vec3 limit = tip(128);
    EXPECT_GT(limit.norm(), 0.2) << c.name << ": it bends";
    double before = (tip(8) - limit).norm();
    for (const int n : {16, 32}) {
      const double after = (tip(n) - limit).norm();
      EXPECT_GE(std::log2(before / after), 3.8) << c.name << ": " << before << " -> " << after;
      before = after;
    }
  }
}

/// The limit is that of elements of order 2.
TEST(LineLoad, ConvergesToWhatOrder2ConvergesTo) {
  for (const Case& c : kCases) {
    const auto tip = [&](int n, int order) {
      Mechanism m = with_load(c.axis(n), c.stiffness, c.load, c.follower);
      std::get<BeamSpec>(m.bodies[0].kind).order = order;
      return test::tip_displacement(m);
    };
    const Vec3 limit = test::richardson(tip(128, 2), tip(256, 2));
    EXPECT_LT((tip(64, 4) - limit).norm(), 1e-6) << c.name;
  }
}

/// Under a moment m per length alone EI kappa = m (L - s) and nothing else strains the beam:
/// theta = m (L s - s^2/2)/EI, and the tip is the integral of its direction.
TEST(LineLoad, SpreadMomentHasItsClosedForm) {
  constexpr int kIntervals = 2000;
  const double m = 6;
  Vec3 exact = Vec3::Zero();  // Simpson's rule
  for (int i = 0; i <= 2 * kIntervals; ++i) {
    const double s = i / (2.0 * kIntervals), theta = m * (s - s * s / 2);
    const double weight = (i == 0 || i == 2 * kIntervals ? 1 : i % 2 == 1 ? 4 : 2);
    exact += weight / (6 * kIntervals) * Vec3(std::cos(theta), std::sin(theta), 0);
  }
  for (const SE3::Tangent& stiffness : {kSlender, kThick})
    for (const bool follower : {true, false}) {
      const auto error = [&](int n, bool planar) {
        const Mechanism at =
            with_load(straight_axis(n), stiffness, wrench(0, 0, 0, 0, 0, m), follower);
        const Vec3 u = planar ? test::tip_displacement<SE2>(at, test::tight(), Space<SE2>())
                              : test::tip_displacement(at);
        return (u + Vec3::UnitX() - exact).norm();
      };
      for (const bool planar : {true, false}) {
        EXPECT_LT(error(8, planar), 1e-3);
        EXPECT_GE(std::log2(error(8, planar) / error(16, planar)), 3.8) << error(8, planar);
        EXPECT_GE(std::log2(error(16, planar) / error(32, planar)), 3.8) << error(16, planar);
      }
    }
}

}  // namespace
}  // namespace liesl::test::line_load_test
