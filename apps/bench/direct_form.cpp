/// @file
/// build/bench/bin/bench_direct_form STUDY [RUNS]: time of the direct sensitivities of a study by
/// its variables, of the processor and by the clock, in forward runs of its scene, planar and
/// spatial: figures of docs/performance.md.

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "apps/bench/processor_time.hpp"
#include "apps/study/load_study.hpp"
#include "apps/tasks/run.hpp"
#include "mbs/solvers/dynamics.hpp"
#include "mbs/system/plane.hpp"
#include "optim/problems/motion_gradients.hpp"

namespace liesl {
namespace {

/// By turns: the scene as given, the motion converged as the study has it, its sensitivities.
template <FrameGroup G>
void measure(const Study& study, const Space<G>& space, const char* name, int runs, Clock clock,
             const char* of) {
  const DesignSimulator<G> simulator(study.scene.mechanism, space, study.scene.simulation,
                                     study.spec);
  const Eigen::VectorXd x = simulator.design().start();
  const DesignRun<G> run = simulator.run(x);
  Parameters<G> parameters;
  for (const Parameter& p : simulator.design().parameters(run.mechanism, x))
    parameters.emplace_back(run.mechanism, *run.model, p);
  std::vector<double> scene, motion, direct;
  for (int i = 0; i < runs; ++i) {
    scene.push_back(clock([&] { simulate(*run.model, study.scene.simulation); }));
    motion.push_back(clock([&] { simulate(*run.model, simulator.options()); }));
    direct.push_back(clock([&] {
      direct_sensitivity<G>(*run.model, run.tape, parameters,
                            [](long, const State<G>&, const StateSensitivity&) {});
    }));
  }
  fmt::print(
      "{:<8} {} variables, {}: scene {:.2f} ms, converged to {:g} {:.2f} ms, direct form {:.2f} "
      "ms, {:.2f} and {:.2f} forward runs (medians of {})\n",
      name, parameters.size(), of, 1e3 * median(scene), simulator.options().tolerance,
      1e3 * median(motion), 1e3 * median(direct), median(direct) / median(scene),
      median(direct) / median(motion), runs);
}

/// In a plane, if there is one, and in space.
void measure(const Study& study, int runs, Clock clock, const char* of) {
  if (const auto plane = find_plane(study.scene.mechanism).plane)
    measure<SE2>(study, *plane, "planar", runs, clock, of);
  measure<SE3>(study, {}, "spatial", runs, clock, of);
}

}  // namespace
}  // namespace liesl

int main(int argc, char** argv) {
  using namespace liesl;
  if (argc < 2) return 2;
  const Study study = load_study(argv[1]);
  const int runs = argc > 2 ? std::atoi(argv[2]) : 15;
  measure(study, runs, seconds, "processor");
  measure(study, runs, clock_seconds, "clock");
}
