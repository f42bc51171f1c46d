#include "optim/problems/frequency_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace liesl {

Mechanism with_multipliers(Mechanism mechanism) {
  mechanism.penalty = {};
  return mechanism;
}

LimitedModes::Vibrating::Vibrating(const Mechanism& designed, int of_body)
    : body(of_body),
      alone(of_body < 0 ? std::nullopt : std::optional(body_alone(designed, of_body))),
      mechanism(alone ? alone->mechanism : designed),
      model(Model<SE3>::build(mechanism, {})) {}

const LimitedModes::Vibrating& LimitedModes::vibrating_of(int body) {
  const auto found = std::ranges::find(vibrating, body, [](const auto& v) { return v->body; });
  if (found != vibrating.end()) return **found;
  return *vibrating.emplace_back(std::make_unique<Vibrating>(mechanism, body));
}

LimitedModes::LimitedModes(const Mechanism& designed, const SimulationOptions& options,
                           const std::vector<FrequencyLimitSpec>& limits)
    : mechanism(designed) {
  for (const FrequencyLimitSpec& limit : limits) {
    const Vibrating& of = vibrating_of(limit.body);
    limited.push_back({&of, pose_modes(of.model, options, limit.at, limit.count)});
    const PoseModes& found = limited.back().modes;
    if (!reason.empty() || found.lambda.size() >= limit.count) continue;
    reason = fmt::format("frequency '{}': ", limit.name);
    if (found.reason.empty())
      reason += fmt::format("the {} has only {}", limit.body < 0 ? "mechanism" : "beam",
                            found.lambda.size());
    reason += found.reason;
  }
}

double LimitedModes::frequency(std::size_t l, int i) const {
  const Eigen::VectorXd& lambda = limited[l].modes.lambda;
  if (i >= lambda.size()) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(lambda[i]) / (2 * M_PI);
}

Eigen::VectorXd LimitedModes::lambda_by(std::size_t l, const Parameter& parameter) const {
  const Vibrating& v = *limited[l].of;
  return lambda_derivative(v.mechanism, v.model, limited[l].modes,
                           v.alone ? parameter_alone(parameter, *v.alone) : parameter);
}

FrequencyProblem::FrequencyProblem(const Mechanism& mechanism, const Design& design,
                                   const SimulationOptions& options,
                                   const std::vector<FrequencyLimitSpec>& limits,
                                   const Eigen::VectorXd& x, int first_term)
    : CaselessProblem(design.variables()),
      designed_(with_multipliers(mechanism)),
      design_(design),
      options_(options),
      limits_(limits) {
  for (Eigen::Index i = 0; i < x.size(); ++i) variables_[static_cast<std::size_t>(i)].start = x[i];
  bool any = false;
  for (std::size_t l = 0; l < limits_.size(); ++l)
    for (int i = 0; i < limits_[l].count; ++i) {
      const FrequencyLimitSpec& limit = limits_[l];
      constraints_.push_back(
          {static_cast<ConstraintId>(constraints_.size()),
           limit.count == 1 ? limit.name : fmt::format("{} {}", limit.name, i + 1), 1});
      images_.push_back({-1, -1, OwnLimits::Frequencies, static_cast<int>(l)});
      const bool is_term = limit.weight > 0;
      terms_.push_back(
          {is_term ? first_term + static_cast<int>(l) : -1, limit.weight * limit.least});
      any = any || is_term;
    }
  if (!any) terms_.clear();
}

void FrequencyProblem::values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
  latest_.reset();
  design_.apply(x, designed_);
  latest_ = std::make_unique<LimitedModes>(designed_, options_, limits_);
  f = 0;
  Eigen::Index row = 0;
  for (std::size_t l = 0; l < limits_.size(); ++l)
    for (int i = 0; i < limits_[l].count; ++i)
      g[row++] = 1 - latest_->frequency(l, i) / limits_[l].least;
}

/// df_i/dx = dlambda_i/dx / (8 pi^2 f_i).
void FrequencyProblem::gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) {
  df.setZero();
  dg.setZero();
  const auto parameters = design_.parameters(latest_->mechanism, x);
  Eigen::Index row = 0;
  for (std::size_t l = 0; l < limits_.size(); row += limits_[l].count, ++l)
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      const Eigen::VectorXd by_p = latest_->lambda_by(l, parameters[p]);
      for (int i = 0; i < by_p.size(); ++i)
        dg(row + i, static_cast<Eigen::Index>(p)) =
            -by_p[i] / (8 * M_PI * M_PI * latest_->frequency(l, i) * limits_[l].least);
    }
}

}  // namespace liesl
