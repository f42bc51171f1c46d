#include "optim/cycle/frequency_problem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace liesl {

std::vector<double> lowest_frequencies(const Mechanism& designed, const SimulationOptions& options,
                                       const FrequencyLimitSpec& limit, std::string& reason) {
  const auto model = Model<SE3>::build(designed, {});
  const PoseModes modes = pose_modes(model, options, limit.at, limit.count);
  reason = modes.reason;
  std::vector<double> out;
  for (const double lambda : modes.lambda) out.push_back(std::sqrt(lambda) / (2 * M_PI));
  return out;
}

FrequencyProblem::FrequencyProblem(const Mechanism& mechanism, const Design& design,
                                   const SimulationOptions& options,
                                   const std::vector<FrequencyLimitSpec>& limits,
                                   const Eigen::VectorXd& x, int first_goal)
    : mechanism_(mechanism),
      design_(design),
      options_(options),
      limits_(limits),
      variables_(design.variables()) {
  for (Eigen::Index i = 0; i < x.size(); ++i) variables_[static_cast<std::size_t>(i)].start = x[i];
  bool any = false;
  for (std::size_t l = 0; l < limits_.size(); ++l)
    for (int i = 0; i < limits_[l].count; ++i) {
      const FrequencyLimitSpec& limit = limits_[l];
      constraints_.push_back(
          {static_cast<ConstraintId>(constraints_.size()),
           limit.count == 1 ? limit.name : fmt::format("{} {}", limit.name, i + 1), 1});
      const bool goal = limit.weight > 0;
      goals_.push_back({goal ? first_goal + static_cast<int>(l) : -1, limit.weight * limit.least});
      any = any || goal;
    }
  if (!any) goals_.clear();
}

void FrequencyProblem::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* g, RowMatrix* dg) {
  const Mechanism designed = design_.apply(mechanism_, x);
  const auto model = Model<SE3>::build(designed, {});
  const auto parameters = dg ? design_.parameters(designed, x) : std::vector<Parameter>();
  Eigen::Index row = 0;
  reason_.clear();
  for (const FrequencyLimitSpec& limit : limits_) {
    const PoseModes modes = pose_modes(model, options_, limit.at, limit.count);
    if (!modes.reason.empty()) reason_ = "frequency '" + limit.name + "': " + modes.reason;
    Eigen::MatrixXd by_x(modes.lambda.size(), static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t p = 0; p < parameters.size(); ++p)
      by_x.col(static_cast<Eigen::Index>(p)) =
          lambda_derivative(designed, model, modes, parameters[p]);
    for (Eigen::Index i = 0; i < limit.count; ++i, ++row) {
      const bool found = i < modes.lambda.size();
      if (!found && reason_.empty())
        reason_ = fmt::format("frequency '{}': the mechanism has only {}", limit.name,
                              modes.lambda.size());
      const double omega = found ? std::sqrt(modes.lambda[i])
                                 : std::numeric_limits<double>::quiet_NaN();  // the reason says why
      if (g) (*g)[row] = 1 - omega / (2 * M_PI) / limit.least;
      if (!dg) continue;
      dg->row(row).setZero();
      if (found) dg->row(row) = -by_x.row(i) / (4 * M_PI * omega * limit.least);
    }
  }
}

void FrequencyProblem::values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
  f = 0;
  evaluate(x, &g, nullptr);
}

void FrequencyProblem::gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) {
  df.setZero();
  evaluate(x, nullptr, &dg);
}

}  // namespace liesl
