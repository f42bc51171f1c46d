/// @file
/// Which load cases the static problem keeps.
#include <fmt/format.h>

#include <numeric>

#include "optim/cycle/static_sizing.hpp"

namespace liesl {

template <FrameGroup G>
void StaticSizing<G>::retain_all(Part& part) const {
  part.kept.resize(part.loads->t.size());
  std::iota(part.kept.begin(), part.kept.end(), 0);
  part.problem.set_loads(part.loads->f);
}

template <FrameGroup G>
std::vector<ScreenedLimit> StaticSizing<G>::screened() const {
  std::vector<ScreenedLimit> out;
  for (const Limit& l : limits_) out.push_back({l.constraint, l.part, l.element >= 0, limit_of(l)});
  return out;
}

/// @pre all cases are retained and solved
template <FrameGroup G>
ValuesByLimit StaticSizing<G>::all_values() const {
  ValuesByLimit value(limits_.size());
  for (size_t l = 0; l < limits_.size(); ++l)
    for (size_t n = 0; n < parts_[limits_[l].part].loads->t.size(); ++n)
      value[l].push_back(
          limit_value(limits_[l], outputs_of(limits_[l], static_cast<int>(n)), nullptr));
  return value;
}

/// Makes the rows of these cases (by limit) the constraints, and their loads those of the parts.
template <FrameGroup G>
void StaticSizing<G>::keep(const CasesByLimit& cases) {
  std::vector<std::string> names;
  for (const auto& c : study_.constraints) names.push_back(c.response.name);
  std::vector<std::vector<std::string>> labels(parts_.size());
  for (size_t p = 0; p < parts_.size(); ++p)
    for (const double t : parts_[p].loads->t) labels[p].push_back(fmt::format("t = {:.6g} s", t));
  retained_ = retain(cases, screened(), names, labels);
  for (size_t p = 0; p < parts_.size(); ++p) {
    parts_[p].kept = retained_.kept[p];
    parts_[p].problem.set_loads(kept_columns(parts_[p].loads->f, parts_[p].kept));
  }
}

template <FrameGroup G>
int StaticSizing<G>::load_cases() const {
  int n = 0;
  for (const auto& part : parts_) n += static_cast<int>(part.kept.size());
  return n;
}

template <FrameGroup G>
std::vector<LimitedResponse> StaticSizing<G>::responses() const {
  std::vector<LimitedResponse> out;
  for (const Limit& l : limits_) {
    const int elements = model_.bodies[parts_[l.part].body]->elements();
    out.push_back(
        {l.constraint, response_of(l, study_.constraints[l.constraint].response, elements)});
  }
  return out;
}

template <FrameGroup G>
std::vector<RowImage> StaticSizing<G>::images() const {
  std::vector<RowImage> out;
  for (const auto& row : retained_.rows)
    out.push_back({row.limit, parts_[limits_[row.limit].part].kept[row.kept]});
  return out;
}

template <FrameGroup G>
int StaticSizing<G>::add_violated(const Eigen::VectorXd& x, double tolerance) {
  CasesByLimit cases = retained_.cases(screened());
  for (auto& part : parts_) retain_all(part);
  const int added = solve(x) ? liesl::add_violated(all_values(), screened(), tolerance, cases) : 0;
  keep(cases);
  return added;
}

template void StaticSizing<SE2>::retain_all(Part&) const;
template std::vector<ScreenedLimit> StaticSizing<SE2>::screened() const;
template ValuesByLimit StaticSizing<SE2>::all_values() const;
template void StaticSizing<SE2>::keep(const CasesByLimit&);
template int StaticSizing<SE2>::load_cases() const;
template std::vector<LimitedResponse> StaticSizing<SE2>::responses() const;
template std::vector<RowImage> StaticSizing<SE2>::images() const;
template int StaticSizing<SE2>::add_violated(const Eigen::VectorXd&, double);
template void StaticSizing<SE3>::retain_all(Part&) const;
template std::vector<ScreenedLimit> StaticSizing<SE3>::screened() const;
template ValuesByLimit StaticSizing<SE3>::all_values() const;
template void StaticSizing<SE3>::keep(const CasesByLimit&);
template int StaticSizing<SE3>::load_cases() const;
template std::vector<LimitedResponse> StaticSizing<SE3>::responses() const;
template std::vector<RowImage> StaticSizing<SE3>::images() const;
template int StaticSizing<SE3>::add_violated(const Eigen::VectorXd&, double);

}  // namespace liesl
