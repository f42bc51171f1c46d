/// @file
/// No heap allocation inside a step after the first: malloc itself is counted, so that Eigen's
/// matrices in the library are seen as well as operator new.

#include <cstdlib>

#include "mbs/run.hpp"
#include "reference/meshed_rod.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LIESL_COUNTS_MALLOC

namespace {
thread_local long mallocs = 0;
}
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* malloc(std::size_t size) {
  ++mallocs;
  return __libc_malloc(size);
}
void* realloc(void* p, std::size_t size) {
  ++mallocs;
  return __libc_realloc(p, size);
}
void* calloc(std::size_t n, std::size_t size) {
  ++mallocs;
  return __libc_calloc(n, size);
}
}
#endif

namespace liesl {
namespace {

#ifdef LIESL_COUNTS_MALLOC

/// A slider-crank with springs, a damper, an actuator, a rope and loads.
Mechanism busy() {
  auto m = reference::slider_crank();
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 1;
  spring.stiffness = 0.5;
  spring.damping = 1e-3;
  ForceSpec rope;
  rope.name = "rope";
  rope.a.offset = SE3(Mat3::Identity(), {0.5, 0, 0});
  rope.b = {2, 0};
  rope.stiffness = 100;
  ForceSpec motor;
  motor.name = "motor";
  motor.joint = 2;
  motor.force = TimeFunction::expression("0.01*sin(100*t)");
  m.forces = {spring, rope, motor};
  LoadSpec wind;
  wind.name = "wind";
  wind.port = {1, 0};
  wind.spread = true;
  wind.force = {0, 3, 0};
  LoadSpec push;
  push.name = "push";
  push.port = {1, 4};
  push.follower = true;
  push.force = {0, 1, 0};
  m.loads = {wind, push};
  m.gravity = {0, -9.81, 0};
  return m;
}

template <class G>
long mallocs_of_steps(const Mechanism& m, const Space<G>& space, const SimulationOptions& o,
                      int steps) {
  auto model = Model<G>::build(m, space);
  State<G> s = model.initial_state();
  EXPECT_EQ(make_consistent(model, o, s).status, SolveStatus::Converged);
  GeneralizedAlpha<G> integrator(model, o);
  EXPECT_TRUE(integrator.step(s, o.step).converged);
  const long before = mallocs;
  for (int i = 0; i < steps; ++i)
    if (!integrator.step(s, o.step).converged) return -1;
  return mallocs - before;
}

TEST(StepAllocations, CounterSeesEigen) {
  const long before = mallocs;
  Eigen::VectorXd v = Eigen::VectorXd::Zero(100);
  EXPECT_GT(v.size() + mallocs, before + 100);
}

TEST(StepAllocations, NoneInThePlane) {
  for (const auto& m : {reference::slider_crank(), busy(), reference::four_bar(4),
                        reference::slider_crank_with_mesh(20, 2, 4)}) {
    const auto search = find_plane(m);
    ASSERT_TRUE(search.plane) << search.reason;
    EXPECT_EQ(mallocs_of_steps<SE2>(m, *search.plane, testing::options(0.12, 1e-4), 50), 0);
  }
}

TEST(StepAllocations, NoneInSpace) {
  for (const auto& m : {reference::slider_crank(), busy(), reference::four_bar(4),
                        reference::heavy_top(), reference::flying_beam(8)})
    EXPECT_EQ(mallocs_of_steps<SE3>(m, {}, testing::options(0.12, 1e-4), 50), 0) << m.name;
}

TEST(StepAllocations, NoneWhenTheTangentIsRefreshed) {
  reference::SliderCrank p;
  p.crank = p.rod = 0.006;
  p.slider = 0.5;
  p.ramp = 0;
  const auto m = reference::slider_crank(p);
  const auto o = testing::options(0.12, 1e-4);
  auto model = Model<SE3>::build(m, {});
  State<SE3> s = model.initial_state();
  ASSERT_EQ(make_consistent(model, o, s).status, SolveStatus::Converged);
  GeneralizedAlpha<SE3> integrator(model, o);
  bool refreshed = false;
  long in_refreshed = -1;
  for (int i = 0; i < 600 && in_refreshed < 0; ++i) {
    const long before = mallocs;
    const auto step = integrator.step(s, o.step);
    if (!step.converged) break;
    if (refreshed && step.tangents > 0) in_refreshed = mallocs - before;
    refreshed = refreshed || step.tangents > 0;
  }
  EXPECT_EQ(in_refreshed, 0);
}

#endif

}  // namespace
}  // namespace liesl
