#include "apps/lean/trial.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numeric>

#include "apps/output/interrupt.hpp"
#include "apps/scene/space.hpp"
#include "mbs/solvers/simulation.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kTimedRuns = 7;

/// Value at t: the record there, or Lagrange's cubic through the two records on either side.
Eigen::VectorXd value_at(const Series& s, double t, double same) {
  const int n = static_cast<int>(s.t.size());
  const auto next = std::lower_bound(s.t.begin(), s.t.end(), t - same);
  const int i = std::min(static_cast<int>(next - s.t.begin()), n - 1);
  if (std::abs(s.t[static_cast<std::size_t>(i)] - t) <= same) return s.values.col(i);
  const int first = std::clamp(i - 2, 0, std::max(0, n - 4)), last = std::min(first + 4, n);
  Eigen::VectorXd value = Eigen::VectorXd::Zero(s.values.rows());
  for (int a = first; a < last; ++a) {
    double weight = 1;
    for (int b = first; b < last; ++b)
      if (b != a)
        weight *= (t - s.t[static_cast<std::size_t>(b)]) /
                  (s.t[static_cast<std::size_t>(a)] - s.t[static_cast<std::size_t>(b)]);
    value += weight * s.values.col(a);
  }
  return value;
}

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
  const ResponseValues<G> values(scene.mechanism, model);
  State<G> s = model.initial_state();
  trial.series.values.resize(components(response, G::space_dim == 2), run.trajectory.size());
  for (int n = 0; n < run.trajectory.size(); ++n) {
    run.trajectory.read(n, s);
    trial.series.t.push_back(s.t);
    trial.series.values.col(n) = values(response, s);
  }
}

}  // namespace

double size_of(const Series& series) {
  return series.t.empty() ? 0 : series.values.colwise().norm().maxCoeff();
}

Series thinned(const Series& series, long k) {
  Series thin;
  const auto n = static_cast<long>(series.t.size());
  thin.values.resize(series.values.rows(), (n - 1 + k - 1) / k + 1);
  for (long i = 0; i < thin.values.cols(); ++i) {
    const long from = std::min(i * k, n - 1);
    thin.t.push_back(series.t[static_cast<std::size_t>(from)]);
    thin.values.col(i) = series.values.col(from);
  }
  return thin;
}

double distance(const Series& series, const Series& reference) {
  if (series.t.empty() || reference.t.empty()) return kInfinity;
  const double same = 1e-9 * (reference.t.back() - reference.t.front());
  if (series.t.back() < reference.t.back() - same) return kInfinity;
  const auto rows = std::max(series.values.rows(), reference.values.rows());
  double largest = 0;
  for (std::size_t i = 0; i < reference.t.size(); ++i) {
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(rows);
    difference.head(series.values.rows()) = value_at(series, reference.t[i], same);
    difference.head(reference.values.rows()) -= reference.values.col(static_cast<long>(i));
    largest = std::max(largest, difference.norm());
  }
  return largest / size_of(reference);
}

Trials::Trials(std::string text, std::string file, std::vector<std::string> overrides,
               std::string response, Progress progress)
    : text_(std::move(text)),
      file_(std::move(file)),
      response_(std::move(response)),
      overrides_(std::move(overrides)),
      progress_(std::move(progress)) {}

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
