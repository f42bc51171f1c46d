#include "optim/problems/esl_problem.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "optim/problems/treatment.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

EslProblem::EslProblem(std::unique_ptr<PartStatics> parts, const CycleOptions& options,
                       const VectorXd& x0)
    : parts_(std::move(parts)), correction_(parts_->cases().size()) {
  for (const CaseLimit& l : parts_->limits()) screened_.push_back(l.screened);
  retain_all();
  const bool solved = solve(x0);
  variables_ = parts_->variables(x0);
  for (std::size_t p = 0; p < correction_.size() && solved; ++p) {
    const MatrixXd& measured = parts_->measured(static_cast<int>(p));
    if (measured.rows() == 0) continue;
    correction_[p] = measured - parts_->y(static_cast<int>(p)).topRows(measured.rows());
  }
  const bool every = !solved || parts_->needs_every_case();
  if (!every) at_start_ = all_values();
  keep(every ? CasesByLimit() : first_cases(options));
}

/// What the treatment of a limit names; of one of many points, of all records as an active set and
/// under fixed loads the cases near the largest value.
CasesByLimit EslProblem::first_cases(const CycleOptions& options) const {
  CasesByLimit out = near_largest(at_start_, screened_, options);
  for (std::size_t l = 0; l < out.size(); ++l) {
    const auto& motion = parts_->limits()[l].motion;
    if (!motion || screened_[l].many || at_start_[l].empty()) continue;
    if (motion->treatment == Treatment::Auto || motion->treatment == Treatment::All) continue;
    const std::set<int> records = treated_records(motion->treatment, at_start_[l]);
    out[l].assign(records.begin(), records.end());
  }
  return out;
}

void EslProblem::retain_all() {
  kept_ = all_cases();
  parts_->retain(kept_);
}

std::vector<std::vector<int>> EslProblem::all_cases() const {
  std::vector<std::vector<int>> out;
  for (const auto& labels : parts_->cases()) {
    auto& all = out.emplace_back(labels.size());
    std::iota(all.begin(), all.end(), 0);
  }
  return out;
}

/// Makes the rows of these cases (by limit; none: all of them) the constraints.
void EslProblem::keep(const CasesByLimit& cases) {
  kept_ = all_cases();
  CasesByLimit all;
  std::vector<std::string> names;
  for (const CaseLimit& l : parts_->limits()) {
    names.push_back(l.name);
    if (cases.empty()) all.push_back(kept_[l.screened.part]);
  }
  retained_ = retain(cases.empty() ? all : cases, screened_, names, parts_->cases());
  if (!parts_->needs_every_case()) kept_ = retained_.kept;
  parts_->retain(kept_);
  constraints_ = retained_.constraints;
  for (NlpConstraint& row : parts_->own_rows()) constraints_.push_back(std::move(row));
}

bool EslProblem::solve(const VectorXd& x) {
  undefined_reason_ = parts_->solve(x);
  return undefined_reason_.empty();
}

/// @pre all cases are retained and solved
ValuesByLimit EslProblem::all_values() const {
  ValuesByLimit out;
  for (std::size_t l = 0; l < screened_.size(); ++l) {
    const CaseLimit& limit = parts_->limits()[l];
    auto& v = out.emplace_back();
    const auto count = parts_->cases()[static_cast<std::size_t>(limit.screened.part)].size();
    for (int n = 0; n < static_cast<int>(count); ++n)
      v.push_back(parts_->value(static_cast<int>(l), outputs_of(limit, n), nullptr));
  }
  return out;
}

VectorXd EslProblem::outputs_of(const CaseLimit& limit, int kept) const {
  const auto p = static_cast<std::size_t>(limit.screened.part);
  VectorXd y = parts_->y(limit.screened.part).col(kept).segment(limit.first, limit.count);
  if (limit.first + limit.count <= correction_[p].rows())
    y += correction_[p]
             .col(kept_[p][static_cast<std::size_t>(kept)])
             .segment(limit.first, limit.count);
  return y;
}

int EslProblem::load_cases() const {
  std::size_t n = 0;
  for (const auto& kept : kept_) n += kept.size();
  return static_cast<int>(n);
}

std::vector<LimitedResponse> EslProblem::responses() const {
  std::vector<LimitedResponse> out;
  for (const CaseLimit& l : parts_->limits())
    if (l.motion) out.push_back(*l.motion);
  return out;
}

std::vector<LimitedResponse> EslProblem::responses_with_slopes() {
  std::vector<LimitedResponse> out = responses();
  const bool any =
      std::any_of(out.begin(), out.end(), [](const auto& r) { return r.part_limit >= 0; });
  if (!any || at_start_.empty()) return out;
  VectorXd x0(static_cast<Eigen::Index>(variables_.size()));
  for (Eigen::Index j = 0; j < x0.size(); ++j)
    x0[j] = variables_[static_cast<std::size_t>(j)].start;
  if (!solve(x0)) return out;  // of the retained cases
  std::size_t number = 0;
  for (std::size_t l = 0; l < at_start_.size(); ++l) {
    if (!parts_->limits()[l].motion) continue;
    LimitedResponse& r = out[number++];
    if (r.part_limit < 0) continue;
    PartSlopes slopes = parts_->slopes(static_cast<int>(l), kept_[screened_[l].part]);
    slopes.value = Eigen::Map<const VectorXd>(at_start_[l].data(),
                                              static_cast<Eigen::Index>(at_start_[l].size()));
    r.slopes = std::make_shared<PartSlopes>(std::move(slopes));
  }
  return out;
}

std::vector<ObjectiveTerm> EslProblem::objective_terms() const {
  std::vector<ObjectiveTerm> out;
  for (const auto& r : retained_.rows) {
    const CaseLimit& l = parts_->limits()[r.limit];
    out.push_back(l.weight > 0 ? ObjectiveTerm{l.screened.constraint, l.weight * l.screened.limit}
                               : ObjectiveTerm());
  }
  const std::vector<ObjectiveTerm> own = parts_->own_terms();
  out.insert(out.end(), own.begin(), own.end());
  out.resize(constraints_.size());
  const bool any =
      std::any_of(out.begin(), out.end(), [](const ObjectiveTerm& g) { return g.number >= 0; });
  return any ? out : std::vector<ObjectiveTerm>();
}

std::vector<RowImage> EslProblem::images() const {
  std::vector<int> number;
  int count = 0;
  for (const CaseLimit& l : parts_->limits()) number.push_back(l.motion ? count++ : -1);
  std::vector<RowImage> out(constraints_.size());
  for (std::size_t r = 0; r < retained_.rows.size(); ++r) {
    const auto [limit, kept] = retained_.rows[r];
    if (number[limit] >= 0) out[r] = {number[limit], kept_[screened_[limit].part][kept]};
  }
  std::ranges::copy(parts_->own_images(), out.begin() + static_cast<long>(retained_.rows.size()));
  return out;
}

int EslProblem::add_violated(const VectorXd& x, double tolerance) {
  if (parts_->needs_every_case() || screened_.empty()) return 0;  // all are kept
  CasesByLimit cases = retained_.cases(screened_);
  retain_all();
  int added = 0;
  if (solve(x)) {
    const ValuesByLimit values = all_values();
    std::vector<ScreenedLimit> limits = screened_;
    for (std::size_t l = 0; l < limits.size(); ++l) {
      if (!(parts_->limits()[l].weight > 0)) continue;
      limits[l].limit = 0;  // of a term of the objective: the largest that is retained
      for (const int n : cases[l]) limits[l].limit = std::max(limits[l].limit, values[l][n]);
    }
    added = liesl::add_violated(values, limits, tolerance, cases);
  }
  keep(cases);
  return added;
}

std::optional<StaticCheck> EslProblem::check(const VectorXd& x) {
  const CasesByLimit cases = retained_.cases(screened_);
  retain_all();
  std::optional<StaticCheck> out;
  if (solve(x)) {
    out.emplace(StaticCheck{parts_->objective(), parts_->mass(), {}, -1, {}});
    const ValuesByLimit values = all_values();
    for (std::size_t l = 0; l < values.size(); ++l) {
      const CaseLimit& limit = parts_->limits()[l];
      LimitCheck& c = out->limits.emplace_back(
          LimitCheck{limit.name, limit.screened.limit, 0, -1, {}, limit.weight});
      if (values[l].empty()) continue;
      const auto worst = std::max_element(values[l].begin(), values[l].end());
      c.value = *worst;
      c.excess = c.value / c.limit - 1;
      c.at = parts_->cases()[limit.screened.part][worst - values[l].begin()];
      out->objective += c.weight * c.value;
    }
    out->objective += parts_->add_checks(out->limits);
    for (const LimitCheck& l : out->limits) {
      if (l.weight > 0 || !(l.excess > out->worst)) continue;
      out->worst = l.excess;
      out->worst_limit = l.name;
    }
  }
  keep(cases);
  return out;
}

void EslProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const bool solved = solve(x);
  f = solved ? parts_->objective() + parts_->terms_at_start() : kNone;
  g.setConstant(kNone);
  if (!solved) return;
  for (std::size_t r = 0; r < retained_.rows.size(); ++r) {
    const auto [l, kept] = retained_.rows[r];
    const CaseLimit& limit = parts_->limits()[l];
    const double v = parts_->value(l, outputs_of(limit, kept), nullptr);
    g[static_cast<int>(r)] = v / limit.screened.limit - 1;
  }
  const VectorXd own = parts_->own_values();
  g.tail(own.size()) = own;
}

void EslProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  df.setZero();
  parts_->objective_gradient(df);
  dy_.clear();
  for (std::size_t p = 0; p < kept_.size(); ++p)
    dy_.push_back(parts_->output_gradients(static_cast<int>(p)));
  VectorXd slope;
  for (std::size_t r = 0; r < retained_.rows.size(); ++r) {
    const auto [l, kept] = retained_.rows[r];
    const CaseLimit& limit = parts_->limits()[l];
    const VectorXd y = outputs_of(limit, kept);
    parts_->value(l, y, &slope);
    for (int i = 0; i < x.size(); ++i) {
      const auto dy = dy_[limit.screened.part][i].col(kept).segment(limit.first, limit.count);
      dg(static_cast<int>(r), i) =
          (slope.dot(dy) + parts_->explicit_slope(l, y, i)) / limit.screened.limit;
    }
  }
  const RowMatrix own = parts_->own_gradients();
  if (own.rows() > 0) dg.bottomRows(own.rows()) = own;
}

MatrixXd EslProblem::output_weights(int part, const VectorXd& lambda) const {
  const MatrixXd& y = parts_->y(part);
  MatrixXd w = MatrixXd::Zero(y.rows(), y.cols());
  VectorXd slope;
  for (std::size_t r = 0; r < retained_.rows.size(); ++r) {
    const auto [l, kept] = retained_.rows[r];
    const CaseLimit& limit = parts_->limits()[l];
    const double weight = lambda[static_cast<int>(r)] / limit.screened.limit;
    if (limit.screened.part != part || weight == 0) continue;
    parts_->value(l, outputs_of(limit, kept), &slope);
    w.col(kept).segment(limit.first, limit.count) += weight * slope;
  }
  return w;
}

/// Of the norms of several outputs: (I - y y^T/v^2)/v.
void EslProblem::add_curvature(const VectorXd& lambda, MatrixXd& h) const {
  for (std::size_t r = 0; r < retained_.rows.size(); ++r) {
    const auto [l, kept] = retained_.rows[r];
    const CaseLimit& limit = parts_->limits()[l];
    const double weight = lambda[static_cast<int>(r)] / limit.screened.limit;
    if (limit.count < 2 || weight == 0) continue;
    const VectorXd y = outputs_of(limit, kept);
    const double v = y.norm();
    if (v == 0) continue;
    MatrixXd dy(limit.count, h.cols());
    for (int i = 0; i < dy.cols(); ++i)
      dy.col(i) = dy_[limit.screened.part][i].col(kept).segment(limit.first, limit.count);
    const VectorXd along = dy.transpose() * y / v;
    h += weight / v * (dy.transpose() * dy - along * along.transpose());
  }
}

void EslProblem::hessian(const VectorXd&, double sigma, const VectorXd& lambda, MatrixXd& h) {
  std::vector<MatrixXd> weights;
  for (std::size_t p = 0; p < kept_.size(); ++p)
    weights.push_back(output_weights(static_cast<int>(p), lambda));
  add_curvature(lambda, h);
  parts_->add_second(sigma, weights, h);
}

}  // namespace liesl
