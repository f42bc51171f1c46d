/// @file
/// No heap allocation inside a step after the first, nor in derivatives by parameters: malloc
/// itself is counted, so that Eigen's matrices in the library are seen as well as operator new.

#include <cstdlib>

#include "mbs/linalg/sanitized.hpp"
#include "mbs/run.hpp"
#include "mbs/system/parameter_residual.hpp"
#include "reference/meshed_rod.hpp"

#if defined(__GLIBC__) && !defined(LIESL_SANITIZED)
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

namespace liesl::test::step_allocation_test {
namespace {

#ifdef LIESL_COUNTS_MALLOC

/// A slider-crank with springs, a damper, an actuator, a rope and loads.
Mechanism busy() {
  auto m = test::slider_crank();
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
  for (const auto& m :
       {test::slider_crank(), busy(), test::four_bar(4), test::slider_crank_with_mesh(20, 2, 4)}) {
    EXPECT_EQ(mallocs_of_steps<SE2>(m, test::space_of<SE2>(m), test::options(0.12, 1e-4), 50), 0);
  }
}

TEST(StepAllocations, NoneInSpace) {
  for (const auto& m :
       {test::slider_crank(), busy(), test::four_bar(4), test::heavy_top(), test::flying_beam(8)})
    EXPECT_EQ(mallocs_of_steps<SE3>(m, {}, test::options(0.12, 1e-4), 50), 0) << m.name;
}

TEST(StepAllocations, NoneWhenTheTangentIsRefreshed) {
  test::SliderCrank p;
  p.crank = p.rod = 0.006;
  p.slider = 0.5;
  p.ramp = 0;
  const auto m = test::slider_crank(p);
  const auto o = test::options(0.12, 1e-4);
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

/// mallocs of dr/dp and dPhi/dp at a state, after the first.
template <class G>
long mallocs_of_derivative(const Mechanism& m, const Space<G>& space, const Parameter& parameter) {
  const auto model = Model<G>::build(m, space);
  const ParameterResidual<G> residual(m, model, parameter);
  State<G> s = model.initial_state();
  const auto o = test::options(0.12, 1e-4);
  EXPECT_EQ(make_consistent(model, o, s).status, SolveStatus::Converged);
  GeneralizedAlpha<G> integrator(model, o);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(integrator.step(s, o.step).converged);
  Eigen::VectorXd r_p = Eigen::VectorXd::Zero(model.size()),
                  phi_p = Eigen::VectorXd::Zero(model.constraints());
  residual.add(s, s.rows, {s.t, 1}, r_p, phi_p);
  EXPECT_GT(r_p.norm(), 0) << parameter.name;
  const long before = mallocs;
  for (int i = 0; i < 5; ++i) residual.add(s, s.rows, {s.t, 1}, r_p, phi_p);
  return mallocs - before;
}

/// Chains of elements, rigid and modal bodies, laws of forces, loads and drives.
template <class G>
void expect_no_mallocs_of_derivatives() {
  for (const auto f : {Formalism::SE3, Formalism::R3SO3, Formalism::Floating, Formalism::Rigid}) {
    Mechanism m = busy();
    m.formalism = f;
    const Parameter all{"all",
                        {by_density(m, 1), RigidDerivative{2, 1, {0.1, 0, 0}, Mat3::Identity()},
                         ForceDerivative{0, 1, 1, 1, 0}, ForceDerivative{2, 0, 0, 0, 1},
                         LoadDerivative{0, 1}, LoadDerivative{1, 1}, DriveDerivative{0, 1}}};
    EXPECT_EQ(mallocs_of_derivative<G>(m, test::space_of<G>(m), all), 0) << to_string(f);
  }
}

TEST(ParameterAllocations, NoneInThePlane) { expect_no_mallocs_of_derivatives<SE2>(); }
TEST(ParameterAllocations, NoneInSpace) { expect_no_mallocs_of_derivatives<SE3>(); }

TEST(ParameterAllocations, NoneOfAMeshedPart) {
  const Mechanism m = test::slider_crank_with_mesh(20, 2, 4);
  const auto cells = std::get<SolidSpec>(m.bodies[1].kind).mesh().cell_count();
  const Parameter fractions{"fractions", {SolidDerivative{1, Eigen::VectorXd::Ones(cells)}}};
  EXPECT_EQ(mallocs_of_derivative<SE2>(m, test::space_of<SE2>(m), fractions), 0);
}

#endif

}  // namespace
}  // namespace liesl::test::step_allocation_test
