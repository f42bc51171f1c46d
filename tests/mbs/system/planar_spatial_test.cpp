/// @file
/// Planar scenes on SE(2) give what they give on SE(3); a turned scene gives the same in local
/// frames.

#include "mbs/run.hpp"

namespace liesl::test::planar_spatial_test {
namespace {

using test::moved;

/// Velocities compare in m/s with rotations times the size of the scene.
struct Difference {
  double position = 0, rotation = 0, velocity = 0, largest_velocity = 0, force = 0,
         largest_force = 0;
};

Vec3 lifted(const Eigen::Vector2d& v) { return {v.x(), v.y(), 0}; }

Difference compare(const test::Run<SE2>& a, const test::Run<SE3>& b) {
  Difference d;
  const Space<SE2>& plane = a.model->space;
  const auto reference = b.model->initial_state().H;
  for (int i = 0; i < b.trajectory().size(); ++i) {
    const SE2* Ha = a.trajectory().frames(i);
    const SE3* Hb = b.trajectory().frames(i);
    for (int k = 0; k < b.model->nodes(); ++k) {
      const SE3 align = plane.alignment(reference[std::size_t(k)]);
      const SE3 H = plane.embed(Ha[k], align);
      const SE3::Tangent va =
          plane.embed_local(SE2::Tangent(a.trajectory().v(i).segment<3>(3 * k)), align);
      const SE3::Tangent vb = b.trajectory().v(i).segment<6>(6 * k);
      d.position = std::max(d.position, (H.x - Hb[k].x).norm());
      d.rotation = std::max(d.rotation, (H.R - Hb[k].R).norm());
      d.velocity = std::max(d.velocity, (va - vb).head<3>().norm());
      d.largest_velocity = std::max(d.largest_velocity, vb.head<3>().norm());
    }
    for (std::size_t c = 0; c < b.model->couplings.size(); ++c) {
      const auto& ca = a.model->couplings[c];
      const Frames<SE2> fa(Ha, Ha + a.model->nodes());
      const Frames<SE3> fb(Hb, Hb + b.model->nodes());
      const auto wa = test::joint_wrench(*a.model, Ha, a.trajectory().lambda(i), int(c));
      const auto wb = test::joint_wrench(*b.model, Hb, b.trajectory().lambda(i), int(c));
      const Vec3 force_a = plane.frame.R * lifted(ca.b.frame(fa).R * wa.head<2>());
      const Vec3 force_b = b.model->couplings[c].b.frame(fb).R * wb.head<3>();
      d.force = std::max(d.force, (force_a - force_b).norm());
      d.largest_force = std::max(d.largest_force, force_b.norm());
    }
  }
  return d;
}

void expect_same(const Mechanism& m, const SimulationOptions& o) {
  const auto planar = test::run_planar(m, o);
  const auto spatial = test::run_spatial(m, o);
  ASSERT_EQ(planar.report().status, SolveStatus::Converged) << planar.report().reason;
  ASSERT_EQ(spatial.report().status, SolveStatus::Converged) << spatial.report().reason;
  // Only runs over the same steps compare this closely: none may be halved.
  ASSERT_EQ(planar.report().rejected_steps, 0);
  ASSERT_EQ(spatial.report().rejected_steps, 0);
  ASSERT_EQ(planar.trajectory().size(), spatial.trajectory().size());
  const Difference d = compare(planar, spatial);
  // Velocities are differences of positions, which round off with the distance from the origin.
  const double far = spatial.model->extent / spatial.model->length;
  EXPECT_LT(d.position, 1e-9 * spatial.model->length) << m.name;
  EXPECT_LT(d.rotation, 1e-9) << m.name;
  EXPECT_LT(d.velocity, 1e-9 * far * d.largest_velocity) << m.name;
  const double round_off = Equations<SE3>(*spatial.model).round_off();  // of positions times EA/L
  EXPECT_LT(d.force, 1e-9 * d.largest_force + 4 * round_off) << m.name;
}

TEST(PlanarSpatial, SliderCrank) {
  expect_same(test::slider_crank(), test::options(0.12, 1e-4, 0.8, 1e-10));
}
TEST(PlanarSpatial, Pendulum) {
  expect_same(test::pendulum(16), test::options(1, 5e-4, 0.8, 1e-10));
}
TEST(PlanarSpatial, FourBar) {
  expect_same(test::four_bar(4), test::options(0.3, 2e-4, 0.8, 1e-10));
}
TEST(PlanarSpatial, TiltedPlanes) {
  const SE3 H = test::oblique();
  expect_same(moved(test::slider_crank(), H), test::options(0.06, 1e-4, 0.8, 1e-10));
  expect_same(moved(test::pendulum(8), H), test::options(0.5, 5e-4, 0.8, 1e-10));
  expect_same(moved(test::four_bar(4), H), test::options(0.1, 2e-4, 0.8, 1e-10));
}

/// Chains of segments: two kinds of body, one chain.
Mechanism of_segments(Mechanism m, SegmentSpec spec = {}) {
  m.formalism = Formalism::Segments;
  for (auto& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->segment = spec;
  return m;
}

TEST(PlanarSpatial, ChainsOfSegments) {
  const SegmentSpec kinds[] = {{AxialPotential::Linear, false},
                               {AxialPotential::Linear, true},
                               {AxialPotential::NeoHookean, false}};
  for (const SegmentSpec& spec : kinds) {
    expect_same(of_segments(test::pendulum(8), spec), test::options(0.5, 5e-4, 0.8, 1e-10));
    expect_same(of_segments(test::slider_crank(), spec), test::options(0.06, 1e-4, 0.8, 1e-10));
  }
  expect_same(moved(of_segments(test::pendulum(8)), test::oblique()),
              test::options(0.5, 5e-4, 0.8, 1e-10));
  expect_same(of_segments(test::four_bar(4)), test::options(0.1, 2e-4, 0.8, 1e-10));
}

/// Thrown out of its plane.
Mechanism thrown_chain() {
  Mechanism m = of_segments(test::pendulum(8));
  m.joints[0].type = JointType::Spherical;
  m.bodies[0].angular_velocity = {0, 3, 0};
  return m;
}

void expect_invariant(const Mechanism& m, const SimulationOptions& o) {
  const auto a = test::run_spatial(m, o);
  const auto b = test::run_spatial(moved(m, test::oblique()), o);
  ASSERT_EQ(a.report().status, SolveStatus::Converged) << a.report().reason;
  ASSERT_EQ(a.trajectory().size(), b.trajectory().size());
  double largest = 0, difference = 0, place = 0;
  for (int i = 0; i < a.trajectory().size(); ++i) {
    largest = std::max(largest, a.trajectory().v(i).norm());
    difference = std::max(difference, (a.trajectory().v(i) - b.trajectory().v(i)).norm());
    for (int k = 0; k < a.model->nodes(); ++k)
      place = std::max(
          place,
          (test::oblique() * a.trajectory().frames(i)[k].x - b.trajectory().frames(i)[k].x).norm());
  }
  EXPECT_LT(difference, 1e-9 * b.model->extent / b.model->length * largest) << m.name;
  EXPECT_LT(place, 1e-9 * a.model->length) << m.name;
}

TEST(FrameInvariance, TurnedScenesMoveTheSame) {
  expect_invariant(test::slider_crank(), test::options(0.06, 1e-4, 0.8, 1e-9));
  expect_invariant(test::heavy_top(), test::options(0.2, 1e-3, 0.9, 1e-9));
  expect_invariant(test::flying_beam(6), test::options(4, 2e-2, 0.9, 1e-9));
  expect_invariant(thrown_chain(), test::options(0.5, 5e-4, 0.8, 1e-10));
  expect_invariant(of_segments(test::slider_crank()), test::options(0.06, 1e-4, 0.8, 1e-10));
}

TEST(FrameInvariance, ScenesFarFromTheOriginRun) {
  const auto at_origin = test::slider_crank();
  const SE3 H(Mat3::Identity(), {1000, -2000, 500});
  const auto o = test::options(0.06, 1e-4);
  const auto a = test::run_planar(at_origin, o), b = test::run_planar(moved(at_origin, H), o);
  const auto c = test::run_spatial(moved(at_origin, H), o);
  ASSERT_EQ(b.report().status, SolveStatus::Converged) << b.report().reason;
  ASSERT_EQ(c.report().status, SolveStatus::Converged) << c.report().reason;
  EXPECT_EQ(b.report().rejected_steps, 0);
  const auto offset = [](const auto& r) {
    return test::largest_chord_offset(r.trajectory(), 9, 8);
  };
  EXPECT_NEAR(offset(b), offset(a), 1e-5 * offset(a));
  EXPECT_NEAR(offset(c), offset(a), 1e-5 * offset(a));
}

}  // namespace
}  // namespace liesl::test::planar_spatial_test
