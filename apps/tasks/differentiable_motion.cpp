#include "apps/tasks/differentiable_motion.hpp"

#include <csignal>

#include "apps/output/interrupt.hpp"
#include "apps/tasks/collect.hpp"
#include "apps/tasks/run_summary.hpp"
#include "apps/tasks/sensitivity.hpp"

namespace liesl {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What derivatives of the responses of a motion are made of.
template <FrameGroup G>
struct Derivatives {
  Parameters<G> parameters;
  ResponseValues<G> values;
  std::vector<ResponseSensitivity<G>> responses;

  Derivatives(const TapedMotion<G>& motion, const SensitivityProblem& problem)
      : values(motion.mechanism, motion.model) {
    for (const Parameter& p : problem.parameters)
      parameters.emplace_back(motion.mechanism, motion.model, p);
    for (const ResponseSpec& r : problem.scene.responses)
      responses.emplace_back(motion.model, values, r, parameters);
  }
};

void go_on(const Progress& progress, double t) {
  if (progress && !progress(t)) throw output::Interrupted(SIGINT);
}

void require(const SensitivityEnd& end) {
  if (!end.complete()) throw std::runtime_error("no derivatives: " + end.reason);
}

}  // namespace

DifferentiableMotion::DifferentiableMotion(SensitivityProblem problem, const ChosenSpace& space,
                                           const Progress& progress)
    : problem_(std::move(problem)) {
  SimulationOptions options = problem_.scene.simulation;
  options.tolerance = std::min(options.tolerance, kSensitivityTolerance);
  describe(outcome_.summary, problem_.scene, space);
  std::visit([&](const auto& s) { simulate(s, options, progress); }, space.space);
}

template <FrameGroup G>
void DifferentiableMotion::simulate(const Space<G>& space, const SimulationOptions& options,
                                    const Progress& progress) {
  auto motion = std::make_unique<TapedMotion<G>>(problem_.scene.mechanism, space, options,
                                                 problem_.scene.responses, progress);
  const Simulation<G>& simulation = motion->simulation;
  outcome_.status = simulation.report.status;
  describe(outcome_.summary, simulation.report, simulation.start, motion->mechanism, options.type);
  outcome_.summary.more["tolerance"] = options.tolerance;
  outcome_.results =
      collect(problem_.scene, motion->mechanism, motion->model, simulation.trajectory);
  describe_responses(outcome_.summary, outcome_.results);
  motion_ = std::move(motion);
}

void DifferentiableMotion::require_good() const {
  if (!good())
    throw std::runtime_error("no derivatives of a motion that did not converge: " +
                             outcome_.summary.reason);
}

std::vector<std::vector<double>> DifferentiableMotion::derivatives(const Progress& progress) const {
  require_good();
  return std::visit([&](const auto& m) { return derivatives_of(*m, progress); }, motion_);
}

VectorXd DifferentiableMotion::pull_back(const std::vector<std::vector<double>>& weights,
                                         const Progress& progress) const {
  require_good();
  return std::visit([&](const auto& m) { return pull_back_of(*m, weights, progress); }, motion_);
}

template <FrameGroup G>
std::vector<std::vector<double>> DifferentiableMotion::derivatives_of(
    const TapedMotion<G>& motion, const Progress& progress) const {
  const Derivatives<G> d(motion, problem_);
  std::vector<std::vector<double>> out(d.responses.size());
  std::size_t record = 0;
  const auto at = [&](long, const State<G>& s, const StateSensitivity& ds) {
    go_on(progress, s.t);
    if (record == motion.recorded.size() || s.t != motion.recorded[record]) return;
    ++record;
    for (std::size_t r = 0; r < out.size(); ++r) {
      const MatrixXd dy = d.responses[r](s, ds);
      for (Index c = 0; c < dy.rows(); ++c)
        for (Index p = 0; p < dy.cols(); ++p) out[r].push_back(dy(c, p));
    }
  };
  require(direct_sensitivity<G>(motion.model, motion.tape, d.parameters, at));
  return out;
}

template <FrameGroup G>
VectorXd DifferentiableMotion::pull_back_of(const TapedMotion<G>& motion,
                                            const std::vector<std::vector<double>>& weights,
                                            const Progress& progress) const {
  const Derivatives<G> d(motion, problem_);
  const std::size_t records = motion.recorded.size();
  std::vector<long> record_of(static_cast<std::size_t>(motion.times.size()), -1);
  for (std::size_t n = 0, step = 0; n < records && step < record_of.size(); ++step)
    if (motion.times[static_cast<Index>(step)] == motion.recorded[n])
      record_of[step] = static_cast<long>(n++);
  const auto at = [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd& gradient) {
    go_on(progress, s.t);
    const long n = record_of[static_cast<std::size_t>(step)];
    if (n < 0) return;
    for (std::size_t r = 0; r < d.responses.size(); ++r) {
      const auto count = static_cast<Index>(weights[r].size() / records);
      if (count == 0) continue;
      const MatrixXd w = Eigen::Map<const VectorXd>(weights[r].data() + n * count, count);
      if (!w.isZero(0)) d.responses[r].add_cotangents(s, w, 0, bars, gradient);
    }
  };
  MatrixXd gradient = MatrixXd::Zero(static_cast<Index>(d.parameters.size()), 1);
  require(adjoint_sensitivity<G>(motion.model, motion.tape, d.parameters, 1, at, gradient));
  return gradient.col(0);
}

}  // namespace liesl
