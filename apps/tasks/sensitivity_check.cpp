#include "apps/tasks/motion_gradient.hpp"
#include "apps/tasks/sensitivity.hpp"

#ifndef LIESL_OPTIM

#include <stdexcept>

namespace liesl {

SensitivityCheck sensitivity_check(const SensitivityProblem&, const ChosenSpace&,
                                   const SensitivityRequest&, const SensitivityCheckOptions&) {
  throw std::runtime_error("--check needs a build with optimisation (-DLIESL_OPTIM=ON)");
}

}  // namespace liesl

#else

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "optim/nlp/check_derivatives.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr double kTolerance = 1e-10;  // of the states
constexpr double kRight = 1e-5;       // best relative error of a gradient
constexpr double kLargestStep = 0.03;
constexpr int kSteps = 8;
constexpr int kMostCorrections = 40;

/// Simulations that end at round-off: with the exact tangent.
SimulationOptions tight(SimulationOptions options) {
  options.tolerance = std::min(options.tolerance, kTolerance);
  options.tangent = TangentStrategy::Exact;
  options.max_iterations = std::max(options.max_iterations, kMostCorrections);
  return options;
}

/// The functionals of the motion as functions of the parameters, in the place of constraints.
template <FrameGroup G>
class FunctionalsOfParameters : public Problem {
 public:
  FunctionalsOfParameters(const SensitivityProblem& problem, const Space<G>& space,
                          const SensitivityRequest& request, SensitivityMethod method)
      : problem_(problem),
        space_(space),
        request_(request),
        motion_(problem.scene.mechanism, space, tight(problem.scene.simulation),
                problem.scene.responses) {
    if (!motion_.good()) throw std::runtime_error(motion_.simulation.report.reason);
    const SensitivityEnd end = differentiate(motion_, problem, request, method, result_);
    if (!end.complete()) throw std::runtime_error(end.reason);
    for (const auto& p : problem.names) {
      const double range = p.value == 0 ? 1 : std::abs(p.value);
      variables_.push_back({p.name, p.value - range / 2, p.value + range / 2, p.value});
    }
    for (const auto& g : result_.gradients)
      constraints_.push_back({constraints_.size() + 1, g.response + ", " + g.functional, 0});
    for (std::size_t r = 0; r < problem.scene.responses.size(); ++r)
      peaks_.push_back(functional_value(motion_, r, {FunctionalKind::Peak, 0}).step);
  }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }

  void values(const VectorXd& x, double& f, VectorXd& g) override {
    f = 0;
    g.setConstant(std::numeric_limits<double>::quiet_NaN());
    const TapedMotion<G> motion(problem_.mechanism_at(x), space_, tight(problem_.options_at(x)),
                                problem_.scene.responses);
    if (!motion.good() || motion.times.size() != motion_.times.size()) return;
    Eigen::Index i = 0;
    for (std::size_t r = 0; r < peaks_.size(); ++r)
      for (const FunctionalSpec& functional : request_.functionals)
        g[i++] = functional_value(motion, r, functional, peaks_[r]).value;
  }
  void gradients(const VectorXd&, VectorXd& df, RowMatrix& dg) override {
    df.setZero();
    for (Eigen::Index i = 0; i < dg.rows(); ++i)
      dg.row(i) = Eigen::Map<const VectorXd>(
          result_.gradients[static_cast<std::size_t>(i)].by_parameter.data(), dg.cols());
  }

 private:
  const SensitivityProblem& problem_;
  const Space<G>& space_;
  const SensitivityRequest& request_;
  const TapedMotion<G> motion_;
  output::Sensitivities result_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
  std::vector<int> peaks_;  ///< by response: the step
};

template <FrameGroup G>
SensitivityCheck check_on(const SensitivityProblem& problem, const Space<G>& space,
                          const SensitivityRequest& request, SensitivityMethod method,
                          const SensitivityCheckOptions& check) {
  FunctionalsOfParameters<G> functionals(problem, space, request, method);
  DerivativeCheckOptions options;
  options.every_variable = true;
  options.largest_step = kLargestStep;
  options.steps = kSteps;
  options.tolerance = kRight;
  options.avoid_kinks = false;  // the gradients are of one point
  options.fits = check.fits;
  const double all = static_cast<double>(problem.parameters.size()) * options.pairs();
  if (check.progress) options.progress = [&](int pairs) { check.progress(pairs / all); };
  DerivativeReport report = check_derivatives(functionals, problem.values(), options);
  std::erase_if(report.checks, [](const auto& c) { return c.function == "objective"; });
  return {report.right, report.text(static_cast<int>(report.checks.size()))};
}

}  // namespace

SensitivityCheck sensitivity_check(const SensitivityProblem& problem, const ChosenSpace& space,
                                   const SensitivityRequest& request,
                                   const SensitivityCheckOptions& options) {
  SensitivityMethod method = request.method;
  if (method == SensitivityMethod::Auto)
    method = faster_method(problem.parameters.size(),
                           problem.scene.responses.size() * request.functionals.size());
  return std::visit([&](const auto& s) { return check_on(problem, s, request, method, options); },
                    space.space);
}

}  // namespace liesl

#endif
