#ifdef LIESL_OPTIM

#include "apps/tasks/outline_kinks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <random>

namespace liesl {

std::vector<std::string> outline_kinks(const PartShape& part, const Eigen::VectorXd& x,
                                       double within) {
  constexpr double kJump = 0.1;  // of the derivative; a smooth one changes by about `within`
  const auto& variables = part.design.variables();
  // Different shares, so that a position and a width do not leave an edge where it is.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.5, 1.5);
  Eigen::VectorXd above = x, below = x;  // within the bounds: beyond them a shape need not exist
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const auto& v = variables[static_cast<std::size_t>(j)];
    const double step = within * share(random) * (v.upper - v.lower);
    above[j] = std::min(x[j] + step, v.upper);
    below[j] = std::max(x[j] - step, v.lower);
  }
  const Eigen::MatrixXd after = part.fraction_gradient(above),
                        before = part.fraction_gradient(below);
  part.shape->set(part.design.parameters(x));
  std::vector<std::string> names;
  for (Eigen::Index j = 0; j < x.size(); ++j)
    if ((after.col(j) - before.col(j)).lpNorm<1>() > kJump * after.col(j).lpNorm<1>())
      names.push_back(variables[static_cast<std::size_t>(j)].name);
  return names;
}

std::vector<std::string> start_warnings(const std::string& name, const PartShape& part) {
  const auto kinks = outline_kinks(part, part.design.start(), 1e-6);
  if (kinks.empty()) return {};
  return {fmt::format(
      "edges of the part '{}' that {} move{} lie on grid lines at the start, where the fractions "
      "of cells have a kink and gradients hold to one side only: shift the start or the grid by a "
      "part of a cell",
      name, fmt::join(kinks, ", "), kinks.size() == 1 ? "s" : "")};
}

std::vector<std::string> end_warnings(const std::string& name, const PartShape& part,
                                      const Eigen::VectorXd& x) {
  const auto kinks = outline_kinks(part, x, 1e-3);
  if (kinks.empty()) return {};
  return {fmt::format(
      "edges of the part '{}' that {} move{} end on grid lines, where the fractions of cells have "
      "a kink: the optimum may lie there, and no gradient can say so; another grid has its kinks "
      "elsewhere",
      name, fmt::join(kinks, ", "), kinks.size() == 1 ? "s" : "")};
}

}  // namespace liesl

#endif
