#include "optim/problems/case_screen.hpp"

#include <algorithm>
#include <numeric>

namespace liesl {
namespace {

/// A number that stays the same from cycle to cycle.
ConstraintId row_id(std::size_t limit, int load_case) {
  return (static_cast<ConstraintId>(limit) << 32) | static_cast<ConstraintId>(load_case);
}

}  // namespace

CasesByLimit near_largest(const ValuesByLimit& value, const std::vector<ScreenedLimit>& limits,
                          const CycleOptions& o) {
  CasesByLimit cases(limits.size());
  int constraints = 0;
  for (const auto& l : limits) constraints = std::max(constraints, l.constraint + 1);
  std::vector<double> worst(static_cast<std::size_t>(constraints), 0);
  for (std::size_t l = 0; l < limits.size(); ++l)
    for (const double v : value[l])
      worst[limits[l].constraint] = std::max(worst[limits[l].constraint], v);
  for (std::size_t l = 0; l < limits.size(); ++l) {
    std::vector<int> order(value[l].size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return value[l][a] > value[l][b]; });
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool few = static_cast<int>(k) < o.min_cases;
      const bool large = value[l][order[k]] >= (1 - o.screening) * worst[limits[l].constraint];
      if (limits[l].many ? few && large : few || large) cases[l].push_back(order[k]);
    }
  }
  return cases;
}

int add_violated(const ValuesByLimit& value, const std::vector<ScreenedLimit>& limits,
                 double tolerance, CasesByLimit& cases) {
  int added = 0;
  for (std::size_t l = 0; l < limits.size(); ++l) {
    std::vector<int> had = cases[l];
    std::sort(had.begin(), had.end());
    for (std::size_t n = 0; n < value[l].size(); ++n) {
      const int number = static_cast<int>(n);
      if (value[l][n] <= limits[l].limit * (1 + tolerance) ||
          std::binary_search(had.begin(), had.end(), number))
        continue;
      cases[l].push_back(number);
      ++added;
    }
  }
  return added;
}

CasesByLimit RetainedCases::cases(const std::vector<ScreenedLimit>& limits) const {
  CasesByLimit out(limits.size());
  for (const auto& row : rows) out[row.limit].push_back(kept[limits[row.limit].part][row.kept]);
  return out;
}

RetainedCases retain(const CasesByLimit& cases, const std::vector<ScreenedLimit>& limits,
                     const std::vector<std::string>& names,
                     const std::vector<std::vector<std::string>>& labels) {
  RetainedCases out;
  out.kept.resize(labels.size());
  std::vector<std::vector<int>> slot(labels.size());
  for (std::size_t p = 0; p < labels.size(); ++p) slot[p].assign(labels[p].size(), -1);
  for (std::size_t l = 0; l < limits.size(); ++l)
    for (const int n : cases[l]) {
      std::vector<int>& kept = out.kept[limits[l].part];
      int& place = slot[limits[l].part][n];
      if (place < 0) {
        place = static_cast<int>(kept.size());
        kept.push_back(n);
      }
      out.rows.push_back({static_cast<int>(l), place});
      out.constraints.push_back({row_id(l, n), names[l] + " at " + labels[limits[l].part][n], 1.0});
    }
  return out;
}

Eigen::MatrixXd kept_columns(const Eigen::MatrixXd& f, const std::vector<int>& kept) {
  Eigen::MatrixXd out(f.rows(), static_cast<Eigen::Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) out.col(static_cast<int>(k)) = f.col(kept[k]);
  return out;
}

}  // namespace liesl
