/// @file
/// Which load cases the static problem keeps.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "optim/cycle/static_sizing.hpp"

namespace liesl {
namespace {

/// A number that stays the same from cycle to cycle.
ConstraintId row_id(int limit, int load_case) {
  return (static_cast<ConstraintId>(limit) << 32) | static_cast<ConstraintId>(load_case);
}

}  // namespace

template <FrameGroup G>
void StaticSizing<G>::retain_all(Part& part) const {
  part.kept.resize(part.loads->t.size());
  std::iota(part.kept.begin(), part.kept.end(), 0);
  part.problem.set_loads(part.loads->f);
}

/// Keeps, for each limit, the cases near its largest value and some more.
template <FrameGroup G>
void StaticSizing<G>::screen() {
  std::vector<std::vector<int>> cases(limits_.size());
  const auto& o = study_.cycle;
  std::vector<double> worst(study_.constraints.size(), 0);
  std::vector<std::vector<double>> value(limits_.size());
  for (size_t l = 0; l < limits_.size(); ++l) {
    const auto& limit = limits_[l];
    for (size_t n = 0; n < parts_[limit.part].loads->t.size(); ++n) {
      value[l].push_back(limit_value(limit, outputs_of(limit, static_cast<int>(n)), nullptr));
      worst[limit.constraint] = std::max(worst[limit.constraint], value[l].back());
    }
  }
  for (size_t l = 0; l < limits_.size(); ++l) {
    std::vector<int> order(value[l].size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return value[l][a] > value[l][b]; });
    const bool many = limits_[l].element >= 0;  // stress: hundreds of points share one constraint
    for (size_t k = 0; k < order.size(); ++k)
      if ((!many && static_cast<int>(k) < o.min_cases) ||
          value[l][order[k]] >= (1 - o.screening) * worst[limits_[l].constraint])
        if (!many || static_cast<int>(k) < o.min_cases) cases[l].push_back(order[k]);
  }
  retain(cases);
}

/// Makes the rows of these cases (by limit) the constraints, and their loads those of the parts.
template <FrameGroup G>
void StaticSizing<G>::retain(const std::vector<std::vector<int>>& cases) {
  rows_.clear();
  constraints_.clear();
  std::vector<std::vector<int>> slot(parts_.size());
  for (size_t p = 0; p < parts_.size(); ++p) {
    slot[p].assign(parts_[p].loads->t.size(), -1);
    parts_[p].kept.clear();
  }
  for (size_t l = 0; l < limits_.size(); ++l)
    for (const int n : cases[l]) {
      Part& part = parts_[limits_[l].part];
      int& place = slot[limits_[l].part][n];
      if (place < 0) {
        place = static_cast<int>(part.kept.size());
        part.kept.push_back(n);
      }
      rows_.push_back({static_cast<int>(l), place});
      constraints_.push_back(
          {row_id(static_cast<int>(l), n),
           fmt::format("{} at t = {:.6g} s",
                       study_.constraints[limits_[l].constraint].response.name, part.loads->t[n]),
           1.0});
    }
  for (auto& part : parts_) {
    Eigen::MatrixXd f(part.loads->f.rows(), part.kept.size());
    for (size_t k = 0; k < part.kept.size(); ++k)
      f.col(static_cast<int>(k)) = part.loads->f.col(part.kept[k]);
    part.problem.set_loads(f);
  }
}

template <FrameGroup G>
int StaticSizing<G>::load_cases() const {
  int n = 0;
  for (const auto& part : parts_) n += static_cast<int>(part.kept.size());
  return n;
}

template <FrameGroup G>
int StaticSizing<G>::add_violated(const Eigen::VectorXd& x, double tolerance) {
  std::vector<std::vector<int>> cases(limits_.size());
  for (const auto& row : rows_)
    cases[row.limit].push_back(parts_[limits_[row.limit].part].kept[row.kept]);
  for (auto& part : parts_) {
    retain_all(part);
  }
  int added = 0;
  if (solve(x))
    for (size_t l = 0; l < limits_.size(); ++l) {
      const auto& limit = limits_[l];
      const double allowed = limit_of(limit) * (1 + tolerance);
      std::sort(cases[l].begin(), cases[l].end());
      const size_t had = cases[l].size();
      for (int n = 0; n < parts_[limit.part].problem.cases(); ++n)
        if (limit_value(limit, outputs_of(limit, n), nullptr) > allowed &&
            !std::binary_search(cases[l].begin(), cases[l].begin() + static_cast<long>(had), n)) {
          cases[l].push_back(n);
          ++added;
        }
    }
  retain(cases);
  return added;
}

template void StaticSizing<SE2>::retain_all(Part&) const;
template void StaticSizing<SE2>::screen();
template void StaticSizing<SE2>::retain(const std::vector<std::vector<int>>&);
template int StaticSizing<SE2>::load_cases() const;
template int StaticSizing<SE2>::add_violated(const Eigen::VectorXd&, double);
template void StaticSizing<SE3>::retain_all(Part&) const;
template void StaticSizing<SE3>::screen();
template void StaticSizing<SE3>::retain(const std::vector<std::vector<int>>&);
template int StaticSizing<SE3>::load_cases() const;
template int StaticSizing<SE3>::add_violated(const Eigen::VectorXd&, double);

}  // namespace liesl
