#include "optim/cycle/dynamic_optimality.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace liesl {
namespace {

constexpr double kStep = 1e-3;         // of a variable: round-off and truncation below 1e-3
constexpr double kActiveBound = 1e-4;  // of a variable's range: optimisers stop that close

/// A peak of a limited response that is near its limit.
struct Peak {
  int limit = 0, record = 0;
};

std::vector<Peak> near_active_peaks(const std::vector<LimitSeries>& limits, double active) {
  std::vector<Peak> peaks;
  for (size_t c = 0; c < limits.size(); ++c) {
    const auto& v = limits[c].values;
    for (size_t n = 0; n < v.size(); ++n) {
      const bool top = (n == 0 || v[n] >= v[n - 1]) && (n + 1 == v.size() || v[n] > v[n + 1]);
      if (top && v[n] >= (1 - active) * limits[c].limit)
        peaks.push_back({static_cast<int>(c), static_cast<int>(n)});
    }
  }
  return peaks;
}

/// The variables and peaks under their names, for kkt_residual: values and gradients come with it.
class PeakProblem final : public Problem {
 public:
  PeakProblem(std::vector<NlpVariable> variables, const std::vector<Peak>& peaks,
              const std::vector<LimitSeries>& limits, const std::vector<double>& times)
      : variables_(std::move(variables)) {
    for (size_t i = 0; i < peaks.size(); ++i)
      constraints_.push_back(
          {i,
           fmt::format("{} at t = {:.6g} s", limits[peaks[i].limit].name, times[peaks[i].record]),
           1});
  }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd&, double&, Eigen::VectorXd&) override { refuse(); }
  void gradients(const Eigen::VectorXd&, Eigen::VectorXd&, RowMatrix&) override { refuse(); }

 private:
  [[noreturn]] static void refuse() { throw std::logic_error("PeakProblem is not evaluated"); }
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

template <FrameGroup G>
Eigen::VectorXd peak_values(const DesignRun<G>& run, const std::vector<Peak>& peaks) {
  Eigen::VectorXd g(static_cast<int>(peaks.size()));
  for (size_t i = 0; i < peaks.size(); ++i) {
    const LimitSeries& series = run.limits[peaks[i].limit];
    g[static_cast<int>(i)] = series.values[peaks[i].record] / series.limit - 1;
  }
  return g;
}

/// What is wrong with a neighbouring run; empty: it can be compared with the design's.
template <FrameGroup G>
std::string not_comparable(const DesignRun<G>& run, const std::vector<double>& times) {
  if (!run.good())
    return "the simulation of a neighbouring design failed: " + run.simulation.report.reason;
  if (run.times() != times)
    return "the simulations of neighbouring designs have other time steps; use a fixed step that "
           "is not halved";
  return "";
}

}  // namespace

std::string DynamicOptimality::brief() const {
  if (!residual) return reason;
  if (holds()) return fmt::format("residual {:.2g}", residual->stationarity);
  return fmt::format("residual {:.2g}, '{}' should {}", residual->stationarity,
                     residual->worst_variable, residual->worst_slope < 0 ? "grow" : "shrink");
}

template <FrameGroup G>
DynamicOptimality check_optimality(const DesignSimulator<G>& simulator, const DesignRun<G>& at,
                                   const Eigen::VectorXd& x, double active,
                                   const Progress& progress) {
  DynamicOptimality out;
  const std::vector<double> times = at.times();
  const std::vector<Peak> peaks = near_active_peaks(at.limits, active);
  const std::vector<NlpVariable>& variables = simulator.design().variables();
  const auto n = static_cast<int>(x.size()), m = static_cast<int>(peaks.size());
  NlpPoint point{
      x, at.mass, peak_values(at, peaks), true, Eigen::VectorXd::Zero(n), RowMatrix::Zero(m, n)};
  const Eigen::VectorXd unit = simulator.design().unit(x);
  for (int j = 0; j < n; ++j) {
    const double step = kStep * (unit.size() > 0 ? unit[j] : x[j]);
    double mass[2] = {at.mass, at.mass}, place[2] = {x[j], x[j]};  // below, above
    Eigen::VectorXd g[2] = {point.g, point.g};
    for (const int side : {0, 1}) {
      Eigen::VectorXd moved = x;
      moved[j] += side ? step : -step;
      if (moved[j] < variables[j].lower || moved[j] > variables[j].upper) continue;
      const DesignRun<G> run = simulator.run(moved, progress);
      ++out.simulations;
      out.reason = not_comparable(run, times);
      if (!out.reason.empty()) return out;
      mass[side] = run.mass;
      g[side] = peak_values(run, peaks);
      place[side] = moved[j];
    }
    if (place[1] == place[0]) continue;  // a variable without room has no say
    point.df[j] = (mass[1] - mass[0]) / (place[1] - place[0]);
    point.dg.col(j) = (g[1] - g[0]) / (place[1] - place[0]);
  }
  KktOptions options;
  options.active = active;
  options.active_bound = kActiveBound;
  const PeakProblem problem(variables, peaks, at.limits, times);
  out.residual = kkt_residual(problem, point, options);
  return out;
}

template DynamicOptimality check_optimality(const DesignSimulator<SE2>&, const DesignRun<SE2>&,
                                            const Eigen::VectorXd&, double, const Progress&);
template DynamicOptimality check_optimality(const DesignSimulator<SE3>&, const DesignRun<SE3>&,
                                            const Eigen::VectorXd&, double, const Progress&);

}  // namespace liesl
