#include "optim/nlp/problem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace liesl {

void Problem::hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd&, Eigen::MatrixXd&) {
  throw std::logic_error("Problem::hessian: hessian_shape() announces one; override this, too");
}

namespace {

void check_variable(const NlpVariable& v, std::size_t index, std::vector<std::string>& errors) {
  const std::string who = fmt::format("variable {} ('{}')", index, v.name);
  if (v.name.empty()) errors.push_back(who + ": expected a name, got none");
  if (std::isnan(v.lower) || std::isnan(v.upper))
    errors.push_back(fmt::format("{}: expected bounds, got [{}, {}]", who, v.lower, v.upper));
  else if (v.lower > v.upper)
    errors.push_back(fmt::format("{}: expected lower <= upper, got [{}, {}]; swap them?", who,
                                 v.lower, v.upper));
  else if (v.lower == v.upper && !std::isfinite(v.lower))
    errors.push_back(fmt::format("{}: expected a finite value, got {}", who, v.lower));
  if (!std::isfinite(v.start))
    errors.push_back(fmt::format("{}: expected a finite start, got {}", who, v.start));
}

}  // namespace

std::vector<std::string> problem_errors(const Problem& problem) {
  std::vector<std::string> errors;
  const auto& variables = problem.variables();
  if (variables.empty()) errors.push_back("expected at least one variable, got none");
  std::set<std::string> names;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    check_variable(variables[i], i, errors);
    if (!names.insert(variables[i].name).second)
      errors.push_back(fmt::format("variable {}: the name '{}' is taken", i, variables[i].name));
  }
  std::set<ConstraintId> ids;
  for (const auto& c : problem.constraints()) {
    if (!ids.insert(c.id).second)
      errors.push_back(fmt::format("constraint '{}': the id {} is taken", c.name, c.id));
    if (!std::isfinite(c.scale) || c.scale < 0)
      errors.push_back(fmt::format(
          "constraint '{}': expected a scale > 0 (or 0 = automatic), got {}", c.name, c.scale));
  }
  return errors;
}

void refuse_if(const std::string& what, const std::vector<std::string>& errors) {
  if (errors.empty()) return;
  std::string text = what;
  for (const auto& e : errors) text += "\n  " + e;
  throw std::invalid_argument(text);
}

}  // namespace liesl
