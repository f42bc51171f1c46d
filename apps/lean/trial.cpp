#include "apps/lean/trial.hpp"

#include <algorithm>
#include <ctime>
#include <numeric>

#include "apps/input/problem.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/scene/space.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

namespace {

constexpr int kTimedRuns = 7;

template <FrameGroup G>
void simulate_on(const Space<G>& space, const Scene& scene, const ResponseSpec& response,
                 const Progress& progress, Trial& trial) {
  Model<G> model = Model<G>::build(scene.mechanism, space);
  const std::clock_t start = std::clock();
  const Simulation<G> run = run_simulation(model, scene.simulation, progress);
  trial.cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  trial.rejected = run.report.rejected_steps;
  trial.corrections = run.report.newton_iterations;
  trial.factorizations =
      std::accumulate(run.report.factorizations.begin(), run.report.factorizations.end(), 0L);
  trial.ok = run.report.status == SolveStatus::Converged;
  trial.reason = run.report.reason;
  if (run.report.status == SolveStatus::Interrupted)
    throw output::Interrupted(output::interrupted());
  trial.series = output::record(response, scene.mechanism, model, run.trajectory);
}

}  // namespace

Trials::Trials(std::string text, std::string file, std::vector<std::string> overrides,
               std::string response, Progress progress, Fault fault)
    : text_(std::move(text)),
      file_(std::move(file)),
      response_(std::move(response)),
      overrides_(std::move(overrides)),
      progress_(std::move(progress)),
      fault_(std::move(fault)) {}

std::string Trials::fault(const std::vector<std::string>& changes) {
  if (!fault_) return {};
  ++runs_;
  return fault_(scene(changes));
}

Scene Trials::scene(const std::vector<std::string>& changes) const {
  auto all = overrides_;
  all.insert(all.end(), changes.begin(), changes.end());
  return read_scene(text_, file_, all);
}

Trial Trials::simulate(const std::vector<std::string>& changes) {
  ++runs_;
  Trial trial;
  try {
    const Scene changed = scene(changes);
    const ChosenSpace space = choose_space(changed);
    trial.space = space.name;
    trial.space_reason = space.reason;
    const auto response =
        std::find_if(changed.responses.begin(), changed.responses.end(),
                     [this](const ResponseSpec& r) { return r.name == response_; });
    std::visit([&](const auto& s) { simulate_on(s, changed, *response, progress_, trial); },
               space.space);
  } catch (const InputError& refused) {
    trial.reason = refused.problems.front().what;
  } catch (const std::invalid_argument& refused) {  // of the model
    trial.reason = refused.what();
  }
  return trial;
}

const Trial& Trials::run(const std::vector<std::string>& changes) {
  const auto found = known_.find(changes);
  return found != known_.end() ? found->second
                               : known_.emplace(changes, simulate(changes)).first->second;
}

Trials::Times Trials::times(const std::vector<std::string>& first,
                            const std::vector<std::string>& second) {
  std::vector<double> a, b;
  for (int i = 0; i < kTimedRuns; ++i) {
    a.push_back(simulate(first).cpu_s);
    b.push_back(simulate(second).cpu_s);
  }
  for (auto* list : {&a, &b})
    std::nth_element(list->begin(), list->begin() + kTimedRuns / 2, list->end());
  return {a[kTimedRuns / 2], b[kTimedRuns / 2]};
}

}  // namespace liesl
