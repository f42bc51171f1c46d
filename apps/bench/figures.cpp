/// @file
/// The figures of docs/performance.md: time a step, iterations, cost against length, the closed
/// cycle, static sizing. Run with --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
/// and read the medians.

#include <benchmark/benchmark.h>

#include "apps/cli/command.hpp"
#include "apps/output/summary.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "mbs/model/curves.hpp"
#include "mbs/solvers/simulation.hpp"

#ifdef LIESL_OPTIM
#include "optim/cycle/motion_cycle.hpp"
#include "optim/nlp/ipopt_driver.hpp"
#include "optim/problems/beam_statics.hpp"
#include "optim/problems/esl_problem.hpp"
#endif

namespace liesl {
namespace {

std::string data(const std::string& file) { return std::string(LIESL_DATA_DIR) + "/" + file; }

/// One simulation an iteration; the time that counts is that of the stepping alone.
template <FrameGroup G>
void simulate_scene(benchmark::State& state, const Mechanism& mechanism, const Space<G>& space,
                    const SimulationOptions& options) {
  Report report;
  double stepping = 0;
  for (auto _ : state) {
    Model<G> model = Model<G>::build(mechanism, space);
    report = run_simulation(model, options).report;
    state.SetIterationTime(report.stepping_s);
    stepping += report.stepping_s;
    if (report.status != SolveStatus::Converged) state.SkipWithError(report.reason.c_str());
  }
  const double steps = static_cast<double>(report.steps);
  state.counters["us_per_step"] =
      1e6 * stepping / (steps * static_cast<double>(state.iterations()));
  state.counters["corrections_per_step"] = static_cast<double>(report.newton_iterations) / steps;
  state.counters["factorizations"] = report.factorizations.empty() ? 0 : report.factorizations[0];
}

void run_file(benchmark::State& state, const std::string& file, const std::vector<std::string>& set,
              bool planar) {
  const Scene scene = load_scene(data("scenes/" + file), set);
  if (planar)
    simulate_scene<SE2>(state, scene.mechanism, *find_plane(scene.mechanism).plane,
                        scene.simulation);
  else
    simulate_scene<SE3>(state, scene.mechanism, Space<SE3>(), scene.simulation);
}

void slider_crank(benchmark::State& state) {
  run_file(state, "slider_crank.toml", {"gravity=[0,0,0]"}, state.range(0) == 2);
}
void pendulum(benchmark::State& state) {
  run_file(state, "pendulum.toml", {}, state.range(0) == 2);
}
void bend45(benchmark::State& state) { run_file(state, "bend45.toml", {}, false); }

/// Pendulum of more and more elements: us per step and element must stay.
void length_of_chain(benchmark::State& state) {
  const auto n = std::to_string(state.range(1));
  run_file(state, "pendulum.toml", {"bodies.beam.beam.elements=" + n, "simulation.duration=0.05"},
           state.range(0) == 2);
}

BENCHMARK(slider_crank)
    ->ArgName("dimensions")
    ->Arg(3)
    ->Arg(2)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(pendulum)
    ->ArgName("dimensions")
    ->Arg(3)
    ->Arg(2)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(bend45)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(length_of_chain)
    ->ArgNames({"dimensions", "elements"})
    ->ArgsProduct({{3, 2}, {50, 1000}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

#ifdef LIESL_OPTIM

/// The main job without its files.
void slider_crank_rod(benchmark::State& state) {
  const Study study = load_study(data("studies/slider_crank_rod.toml"));
  const Space<SE2> plane = *find_plane(study.scene.mechanism).plane;
  size_t cycles = 0;
  for (auto _ : state) {
    const auto r = run_cycle<SE2>(study.scene.mechanism, plane, study.scene.simulation, study.spec);
    cycles = r.history.size();
    if (!closed(r.status)) state.SkipWithError(r.reason.c_str());
  }
  state.counters["cycles"] = static_cast<double>(cycles);
  state.counters["peak_memory_mb"] = output::peak_memory_mb();
}
BENCHMARK(slider_crank_rod)->Unit(benchmark::kMillisecond);

/// 2000 load cases, 40 diameters: one static optimisation from the start, screening included.
void static_sizing(benchmark::State& state) {
  Study study = load_study(data("studies/slider_crank_rod.toml"),
                           {"scene.bodies.rod.beam.elements=40", "design.rod_diameters.groups=40",
                            "scene.simulation.duration=0.2"});
  const Space<SE2> plane = *find_plane(study.scene.mechanism).plane;
  const DesignSimulator<SE2> simulator(study.scene.mechanism, plane, study.scene.simulation,
                                       study.spec);
  const Eigen::VectorXd x = simulator.design().start();
  const DesignRun<SE2> run = simulator.run(x);
  const Analysis<SE2> at{run.mechanism, run.model.get(), &run.simulation.trajectory, &run.loads};
  int iterations = 0, kept = 0;
  for (auto _ : state) {
    EslProblem problem(std::make_unique<BeamStatics<SE2>>(at, simulator.design().sizing(),
                                                          study.spec, study.spec.cycle.move_limit),
                       study.spec.cycle, x);
    for (int round = 0; round < 8; ++round) {
      const NlpResult answer = solve_ipopt(problem);
      iterations += answer.iterations;
      if (!answer.solved()) state.SkipWithError(answer.reason.c_str());
      if (problem.add_violated(answer.x, 1e-6) == 0) break;
    }
    kept = problem.load_cases();
  }
  state.counters["load_cases"] = static_cast<double>(run.simulation.trajectory.size());
  state.counters["kept"] = kept;
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(static_sizing)->Unit(benchmark::kMillisecond);

#endif

}  // namespace
}  // namespace liesl

BENCHMARK_MAIN();
