#include "optim/cycle/static_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mbs/solids/connectivity.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Rows that have no load case: limits of the part itself, and walls.
ConstraintId own_id(std::size_t limit, int index) {
  return (ConstraintId{1} << 63) | (static_cast<ConstraintId>(limit) << 32) |
         static_cast<ConstraintId>(index);
}

bool by_case(SolidResponse r) {
  return r == SolidResponse::Output || r == SolidResponse::Compliance || r == SolidResponse::Stress;
}

}  // namespace

StaticShape::StaticShape(const SolidTask& task, const VectorXd& x0, double cells, double share)
    : task_(task), statics_(*task.model, task.support, task.outputs) {
  for (std::size_t i = 0; i < task_.limits.size(); ++i)
    if (by_case(task_.limits[i].response)) limit_of_.push_back(static_cast<int>(i));
  const auto needs_all = [](SolidResponse r) {
    return r == SolidResponse::Compliance || r == SolidResponse::Stress;
  };
  expanded_ = needs_all(task_.objective);
  for (const SolidLimit& l : task_.limits) expanded_ |= needs_all(l.response);
  if (task_.combination.size() == 0)
    task_.combination = MatrixXd::Identity(task_.loads.cols(), task_.loads.cols());
  variables_ = task_.design->variables();
  correction_ = MatrixXd::Zero(statics_.outputs(), task_.combination.cols());
  keep_all();
  const bool solved = solve(x0);
  narrow(x0, cells, share);
  if (!solved) return;
  if (task_.measured.size() > 0) correction_ = task_.measured - corrected();
  if (task_.objective != SolidResponse::Mass) return;
  at_start_ = all_values();
  keep(near_largest(at_start_, screened(), task_.cycle));
}

void StaticShape::narrow(const VectorXd& x0, double cells, double share) {
  VectorXd farthest = VectorXd::Constant(x0.size(), std::numeric_limits<double>::infinity());
  if (undefined_reason_.empty()) {
    const Fractions f = volume_fractions(task_.model->mesh(), *task_.shape);
    farthest = task_.design->step_bounds(f.derivative, cells);
  }
  for (int j = 0; j < x0.size(); ++j) {
    NlpVariable& v = variables_[j];
    const double most = std::min(farthest[j], share * (v.upper - v.lower));
    v.start = x0[j];
    v.lower = std::max(v.lower, x0[j] - most);
    v.upper = std::min(v.upper, x0[j] + most);
  }
}

/// Fractions and displacements at x; false: there are none, and `undefined_reason_` says why.
bool StaticShape::solve(const VectorXd& x) {
  stress_.reset();
  frequencies_.reset();
  const VectorXd p = task_.design->parameters(x);
  task_.shape->set(p);
  undefined_reason_ = task_.shape->error();
  if (!undefined_reason_.empty()) return false;
  fractions_ = volume_fractions(task_.model->mesh(), *task_.shape);
  fractions_.derivative = FractionGradient(fractions_.derivative * task_.design->jacobian());
  if (const auto cut = cut_interface(*task_.model, fractions_.value))
    undefined_reason_ = cut->text;
  else if (const SolidStatus status = statics_.solve(fractions_.value);
           status != SolidStatus::Solved)
    undefined_reason_ = reason(status);
  return undefined_reason_.empty();
}

std::vector<ScreenedLimit> StaticShape::screened() const {
  std::vector<ScreenedLimit> out;
  for (const int i : limit_of_) out.push_back({i, 0, false, task_.limits[i].limit});
  return out;
}

void StaticShape::keep_all() {
  std::vector<int> all(static_cast<std::size_t>(task_.combination.cols()));
  std::iota(all.begin(), all.end(), 0);
  keep(CasesByLimit(limit_of_.size(), all));
  if (limit_of_.empty()) {  // the objective asks for them
    retained_.kept[0] = all;
    take_loads();
  }
}

void StaticShape::take_loads() {
  combination_ = kept_columns(task_.combination, retained_.kept[0]);
  statics_.set_loads(expanded_ ? MatrixXd(task_.loads * combination_) : task_.loads);
  if (expanded_) combination_.setIdentity(combination_.cols(), combination_.cols());
}

void StaticShape::keep(const CasesByLimit& cases) {
  std::vector<std::string> names;
  for (const auto& l : task_.limits) names.push_back(l.name);
  retained_ = retain(cases, screened(), names, {task_.cases});
  take_loads();
  constraints_ = retained_.constraints;
  add_rows_without_cases();
}

void StaticShape::add_rows_without_cases() {
  for (std::size_t i = 0; i < task_.limits.size(); ++i) {
    const SolidLimit& l = task_.limits[i];
    if (l.response == SolidResponse::Mass) constraints_.push_back({own_id(i, 0), l.name, 1});
    for (int k = 0; l.response == SolidResponse::Frequency && k < l.count; ++k)
      constraints_.push_back({own_id(i, k), fmt::format("{}[{}]", l.name, k), 1});
  }
  const auto& walls = task_.design->wall_names();
  for (std::size_t w = 0; w < walls.size(); ++w)
    constraints_.push_back({own_id(task_.limits.size(), static_cast<int>(w)), walls[w], 1});
}

std::vector<LimitedResponse> StaticShape::responses() const {
  std::vector<LimitedResponse> out;
  for (const int i : limit_of_)
    if (task_.limits[i].motion) out.push_back(*task_.limits[i].motion);
  return out;
}

std::vector<LimitedResponse> StaticShape::responses_with_slopes() {
  std::vector<LimitedResponse> out = responses();
  const bool any =
      std::any_of(out.begin(), out.end(), [](const auto& r) { return r.part_limit >= 0; });
  if (!any || !undefined_reason_.empty()) return out;
  VectorXd x0(static_cast<Eigen::Index>(variables_.size()));
  for (Eigen::Index j = 0; j < x0.size(); ++j)
    x0[j] = variables_[static_cast<std::size_t>(j)].start;
  if (!solve(x0)) return out;  // of the retained cases
  std::size_t number = 0;
  for (std::size_t l = 0; l < limit_of_.size(); ++l) {
    if (!task_.limits[static_cast<std::size_t>(limit_of_[l])].motion) continue;
    LimitedResponse& r = out[number++];
    if (r.part_limit >= 0) r.slopes = std::make_shared<PartSlopes>(slopes_of(l));
  }
  return out;
}

/// Loads follow the reduced forces g = K_e e of the motion, f = K Psi K_e^-1 g with the shapes as
/// they are at x0: dv = dv at constant loads + a^T (K_e^-1 dK_e e + de), a = Psi^T dv/dq.
PartSlopes StaticShape::slopes_of(std::size_t screened) {
  const SolidLimit& limit = task_.limits[static_cast<std::size_t>(limit_of_[screened])];
  const std::vector<int>& kept = retained_.kept[0];
  const MatrixXd K_e = task_.basis.transpose() * task_.loads;
  const MatrixXd e = kept_columns(task_.combination, kept);
  MatrixXd own = gradients_of(limit);
  const MatrixXd a = limit.response == SolidResponse::Stress
                         ? MatrixXd(task_.basis.transpose() * stress(true).by_displacement)
                         : MatrixXd(2 * K_e * e);
  const MatrixXd c = K_e.ldlt().solve(a), dv = fractions_.derivative;
  for (int j = 0; j < dv.cols(); ++j) {
    const auto& dK = task_.model->stiffness_derivative(fractions_.value, dv.col(j));
    const MatrixXd dK_e =
        task_.basis.transpose() * (dK.selfadjointView<Eigen::Lower>() * task_.basis);
    own.col(j) += c.cwiseProduct(dK_e * e).colwise().sum().transpose();
  }
  PartSlopes out;
  out.body = limit.motion->response.body;
  out.value = Eigen::Map<const VectorXd>(at_start_[screened].data(),
                                         static_cast<Eigen::Index>(at_start_[screened].size()));
  for (std::size_t k = 0; k < kept.size(); ++k) {
    out.own[kept[k]] = own.row(static_cast<Eigen::Index>(k));
    out.by_coordinates[kept[k]] = a.col(static_cast<Eigen::Index>(k));
  }
  return out;
}

std::vector<RowImage> StaticShape::images() const {
  std::vector<int> number(limit_of_.size(), -1);
  int count = 0;
  for (std::size_t l = 0; l < limit_of_.size(); ++l)
    if (task_.limits[limit_of_[l]].motion) number[l] = count++;
  std::vector<RowImage> out(constraints_.size());
  for (std::size_t r = 0; r < retained_.rows.size(); ++r)
    if (const int n = number[retained_.rows[r].limit]; n >= 0)
      out[r] = {n, retained_.kept[0][retained_.rows[r].kept]};
  return out;
}

std::vector<RowGoal> StaticShape::goals() const {
  if (!task_.weighted()) return {};
  std::vector<RowGoal> out(constraints_.size());
  const auto goal_of = [&](std::size_t limit) {
    const SolidLimit& l = task_.limits[limit];
    return l.weight > 0 ? RowGoal{static_cast<int>(limit), l.weight * l.limit} : RowGoal();
  };
  std::size_t row = 0;  // in the order of the constraints
  for (const auto& r : retained_.rows)
    out[row++] = goal_of(static_cast<std::size_t>(limit_of_[static_cast<std::size_t>(r.limit)]));
  for (std::size_t i = 0; i < task_.limits.size(); ++i) {
    const SolidLimit& l = task_.limits[i];
    const int rows = l.response == SolidResponse::Frequency ? l.count : 1;
    for (int k = 0; k < rows && !by_case(l.response); ++k) out[row++] = goal_of(i);
  }
  return out;
}

/// @pre all cases are retained and solved
ValuesByLimit StaticShape::all_values() {
  ValuesByLimit out;
  for (const int i : limit_of_) {
    const VectorXd v = values_of(task_.limits[i]);
    out.emplace_back(v.data(), v.data() + v.size());
  }
  return out;
}

int StaticShape::add_violated(const VectorXd& x, double tolerance) {
  if (task_.objective != SolidResponse::Mass || limit_of_.empty()) return 0;  // all are kept
  CasesByLimit cases = retained_.cases(screened());
  keep_all();
  const int added = solve(x) ? liesl::add_violated(all_values(), screened(), tolerance, cases) : 0;
  keep(cases);
  return added;
}

bool StaticShape::show_all(const VectorXd& x) {
  expanded_ = true;
  keep_all();
  return solve(x);
}

/// y of the retained cases.
MatrixXd StaticShape::corrected() const {
  return statics_.y() * combination_ + kept_columns(correction_, retained_.kept[0]);
}

const StressNorm& StaticShape::stress(bool with_gradient) {
  if (!stress_ || (with_gradient && !stress_gradient_))
    stress_ = stress_norm(
        statics_,
        with_gradient ? fractions_.derivative : FractionGradient(fractions_.value.size(), 0),
        task_.stress);
  stress_gradient_ = with_gradient;
  return *stress_;
}

/// As many as any limit asks for.
const FrequencyGradient& StaticShape::frequencies() {
  int count = 0;
  for (const SolidLimit& l : task_.limits)
    if (l.response == SolidResponse::Frequency) count = std::max(count, l.count);
  if (!frequencies_)
    frequencies_ =
        free_frequency_gradient(*task_.model, fractions_.value, fractions_.derivative, count);
  return *frequencies_;
}

VectorXd StaticShape::values_of(const SolidLimit& l) {
  switch (l.response) {
    case SolidResponse::Output:
      return corrected().middleRows(l.first, l.count).colwise().norm();
    case SolidResponse::Compliance:
      return statics_.compliance();
    case SolidResponse::Stress:
      return stress(false).value;
    case SolidResponse::Mass:
      return VectorXd::Constant(1, task_.model->total_mass(fractions_.value));
    case SolidResponse::Frequency:
      return frequencies().frequency.size() >= l.count
                 ? VectorXd(frequencies().frequency.head(l.count))
                 : VectorXd::Constant(l.count, kNone);
  }
  return {};
}

MatrixXd StaticShape::shares(const SolidLimit& l) const {
  MatrixXd share = corrected().middleRows(l.first, l.count).transpose();
  for (int n = 0; n < share.rows(); ++n)
    if (const double size = share.row(n).norm(); size > 0) share.row(n) /= size;
  return share;
}

MatrixXd StaticShape::gradients_of(const SolidLimit& l) {
  const FractionGradient& dv = fractions_.derivative;
  switch (l.response) {
    case SolidResponse::Output: {
      const MatrixXd share = shares(l);
      MatrixXd out = MatrixXd::Zero(share.rows(), dv.cols());
      for (int i = 0; i < l.count; ++i)
        out += share.col(i).asDiagonal() *
               (combination_.transpose() * statics_.output_gradient(l.first + i, dv));
      return out;
    }
    case SolidResponse::Compliance:
      return statics_.compliance_gradient(dv);
    case SolidResponse::Stress:
      return stress(true).gradient;
    case SolidResponse::Mass:
      return (dv.transpose() * task_.model->cell_masses()).transpose();
    case SolidResponse::Frequency:
      return frequencies().gradient.topRows(l.count);
  }
  return {};
}

/// What limits with a weight are at the analysed design; their rows tell the change.
double StaticShape::extremes() const {
  double sum = 0;
  for (const SolidLimit& l : task_.limits)
    sum += (l.response == SolidResponse::Frequency ? -l.weight : l.weight) * l.limit;
  return sum;
}

/// Without what is weighted.
double StaticShape::objective() {
  switch (task_.objective) {
    case SolidResponse::Compliance:
      return statics_.compliance().mean();
    case SolidResponse::Stress: {
      const VectorXd& s = stress(false).value;
      const double most = s.maxCoeff(), p = task_.stress.p;
      return most > 0 ? most * std::pow((s / most).array().pow(p).mean(), 1 / p) : 0;
    }
    default:
      return task_.mass_weight * task_.model->total_mass(fractions_.value);
  }
}

LimitCheck StaticShape::check_limit(const SolidLimit& l) {
  const VectorXd v = values_of(l);
  LimitCheck c{l.name, l.limit, 0, 0, {}, l.weight};
  if (l.response == SolidResponse::Frequency) {
    c.value = v.minCoeff();
    c.excess = 1 - c.value / l.limit;
    return c;
  }
  Eigen::Index n = 0;
  c.value = v.size() > 0 ? v.maxCoeff(&n) : 0;
  c.excess = c.value / l.limit - 1;
  if (by_case(l.response) && v.size() > 0) c.at = task_.cases[static_cast<std::size_t>(n)];
  return c;
}

std::optional<LimitCheck> StaticShape::check_walls() const {
  const VectorXd g = task_.design->walls();  // 1 - thickness/least
  if (g.size() == 0) return std::nullopt;
  Eigen::Index w = 0;
  const double worst = g.maxCoeff(&w);
  return LimitCheck{
      task_.design->wall_names()[static_cast<std::size_t>(w)], 1, 1 + worst, worst, {}};
}

std::optional<SolidCheck> StaticShape::check(const VectorXd& x) {
  const CasesByLimit cases = retained_.cases(screened());
  keep_all();
  std::optional<SolidCheck> out;
  if (solve(x)) {
    out.emplace();
    out->objective = objective();
    out->mass = task_.model->total_mass(fractions_.value);
    for (const SolidLimit& l : task_.limits) {
      out->limits.push_back(check_limit(l));
      const double value = out->limits.back().value;
      out->objective +=
          l.response == SolidResponse::Frequency ? -l.weight * value : l.weight * value;
    }
    if (auto walls = check_walls()) out->limits.push_back(*walls);
    for (const LimitCheck& l : out->limits) {
      if (l.weight > 0 || !(l.excess > out->worst)) continue;
      out->worst = l.excess;
      out->worst_limit = l.name;
    }
  }
  if (task_.objective == SolidResponse::Mass && !limit_of_.empty()) keep(cases);
  return out;
}

void StaticShape::values(const VectorXd& x, double& f, VectorXd& g) {
  if (!solve(x)) {
    f = kNone;
    g.setConstant(kNone);
    return;
  }
  f = objective() + extremes();
  std::vector<VectorXd> by_limit;
  for (const int i : limit_of_) by_limit.push_back(values_of(task_.limits[i]));
  int row = 0;
  for (const auto& r : retained_.rows)
    g[row++] = by_limit[r.limit][r.kept] / task_.limits[limit_of_[r.limit]].limit - 1;
  for (const SolidLimit& l : task_.limits) {
    if (by_case(l.response)) continue;
    const VectorXd v = values_of(l);
    for (int k = 0; k < v.size(); ++k)
      g[row++] = l.response == SolidResponse::Mass ? v[k] / l.limit - 1 : 1 - v[k] / l.limit;
  }
  wall_gradient_.resize(static_cast<Eigen::Index>(task_.design->wall_names().size()), x.size());
  g.tail(wall_gradient_.rows()) = task_.design->walls(&wall_gradient_);
}

void StaticShape::gradients(const VectorXd&, VectorXd& df, RowMatrix& dg) {
  switch (task_.objective) {
    case SolidResponse::Compliance:
      df = statics_.compliance_gradient(fractions_.derivative).colwise().mean();
      break;
    case SolidResponse::Stress: {
      const double f = objective(), p = task_.stress.p;
      const StressNorm& s = stress(true);
      df.setZero();
      if (f > 0)
        df = s.gradient.transpose() *
             ((s.value / f).array().pow(p - 1) / static_cast<double>(s.value.size())).matrix();
      break;
    }
    default:
      df = task_.mass_weight * (fractions_.derivative.transpose() * task_.model->cell_masses());
  }
  std::vector<MatrixXd> by_limit;
  for (const int i : limit_of_) by_limit.push_back(gradients_of(task_.limits[i]));
  int row = 0;
  for (const auto& r : retained_.rows)
    dg.row(row++) = by_limit[r.limit].row(r.kept) / task_.limits[limit_of_[r.limit]].limit;
  for (const SolidLimit& l : task_.limits) {
    if (by_case(l.response)) continue;
    const MatrixXd d = gradients_of(l);
    const double sign = l.response == SolidResponse::Mass ? 1 : -1;
    for (int k = 0; k < d.rows(); ++k) dg.row(row++) = sign * d.row(k) / l.limit;
  }
  dg.bottomRows(wall_gradient_.rows()) = wall_gradient_;
}

}  // namespace liesl
