/// @file
/// A model is const in a run: two threads simulate one model at once and both get, bit for bit,
/// what one thread gets alone. Compiled with ThreadSanitizer as well (preset tsan).

#include <gtest/gtest.h>

#include <thread>

#include "mbs/run.hpp"
#include "mbs/solvers/simulation.hpp"
#include "reference/mechanisms.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::threads_test {
namespace {

/// All numbers of a trajectory, one after the other.
template <FrameGroup G>
std::vector<double> numbers(const Trajectory<G>& t) {
  std::vector<double> out;
  State<G> s;
  const auto add = [&](const auto& x) { out.insert(out.end(), x.data(), x.data() + x.size()); };
  for (int n = 0; n < t.size(); ++n) {
    t.read(n, s);
    for (const auto& H : s.H) {
      add(H.R);
      add(H.x);
    }
    for (const auto* x : {&s.v, &s.vdot, &s.w, &s.lambda, &s.rows}) add(*x);
  }
  return out;
}

template <FrameGroup G>
void expect_independent_runs(const Mechanism& m, const Space<G>& space, SimulationOptions o) {
  const auto model = Model<G>::build(m, space);
  const auto alone = run_simulation(Model<G>::build(m, space), o);
  ASSERT_EQ(alone.report.status, SolveStatus::Converged) << alone.report.reason;
  Simulation<G> both[2];
  {
    std::jthread first([&] { both[0] = run_simulation(model, o); });
    std::jthread second([&] { both[1] = run_simulation(model, o); });
  }
  const auto expected = numbers(alone.trajectory);
  for (const auto& run : both) {
    EXPECT_EQ(run.report.warnings, alone.report.warnings);
    EXPECT_EQ(numbers(run.trajectory), expected) << m.name;
  }
}

/// The same hinge twice: all rows of the second repeat those of the first.
TEST(Threads, RedundantRows) {
  Mechanism m = test::pendulum(2);
  m.joints.push_back(m.joints[0]);
  m.joints[1].name = "again";
  ASSERT_FALSE(Model<SE3>::build(m, {}).redundant.empty());
  expect_independent_runs<SE3>(m, {}, test::options(0.005, 1e-4));
}

TEST(Threads, ModalBodies) {
  Mechanism m = test::slider_crank({.elements = 4});
  m.formalism = Formalism::Floating;
  expect_independent_runs<SE3>(m, {}, test::options(0.005, 1e-4));
}

/// A mesh reduced to modes, which are made when they are first asked for.
TEST(Threads, MeshedParts) {
  const Mechanism m = test::slider_crank_with_mesh(30, 2, 3);
  expect_independent_runs<SE2>(m, *find_plane(m).plane, test::options(0.005, 1e-4));
}

/// A drive given as an expression of t has a pool of evaluators.
TEST(Threads, Expressions) {
  Mechanism m = test::slider_crank({.elements = 2});
  m.drives = {{0, 0, TimeFunction::expression("1000*t^2")}};
  expect_independent_runs<SE3>(m, {}, test::options(0.005, 1e-4));
}

TEST(Threads, Statics) {
  SimulationOptions o;
  o.type = SimulationType::Static;
  Mechanism m = test::pendulum(4);
  m.joints[0].type = JointType::Fixed;
  m.gravity *= 0.01;
  expect_independent_runs<SE3>(m, {}, o);
}

}  // namespace
}  // namespace liesl::test::threads_test
