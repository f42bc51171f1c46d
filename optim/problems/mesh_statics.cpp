#include "optim/problems/mesh_statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mbs/solids/connectivity.hpp"
#include "mbs/solids/mode_derivative.hpp"
#include "mbs/solids/topological_derivative.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows that have no load case: limits of the part itself, and walls.
ConstraintId own_id(std::size_t limit, int index) {
  return (ConstraintId{1} << 63) | (static_cast<ConstraintId>(limit) << 32) |
         static_cast<ConstraintId>(index);
}

bool needs_displacements(SolidResponse r) {
  return r == SolidResponse::Compliance || r == SolidResponse::Stress;
}

bool by_case(SolidResponse r) { return r == SolidResponse::Output || needs_displacements(r); }

}  // namespace

MeshStatics::MeshStatics(const SolidTask& task, double cells, double share)
    : task_(task),
      cells_(cells),
      share_(share),
      expanded_(needs_displacements(task.objective)),
      statics_(*task.model, task.support, task.outputs) {
  if (task_.combination.size() == 0)
    task_.combination = MatrixXd::Identity(task_.loads.cols(), task_.loads.cols());
  cases_ = {task_.cases};
  for (std::size_t i = 0; i < task_.limits.size(); ++i) {
    const SolidLimit& l = task_.limits[i];
    if (!by_case(l.response)) continue;
    CaseLimit limit{l.name,  {static_cast<int>(i), 0, false, l.limit}, l.first, l.count, l.motion,
                    l.weight};
    if (needs_displacements(l.response)) {
      expanded_ = true;
      limit.first = statics_.outputs() + static_cast<int>(extra_.size());
      limit.count = 1;
      extra_.push_back(&l);
    }
    limits_.push_back(std::move(limit));
  }
}

std::vector<NlpVariable> MeshStatics::variables(const VectorXd& x0) const {
  VectorXd farthest = VectorXd::Constant(x0.size(), std::numeric_limits<double>::infinity());
  if (solved_ && std::isfinite(cells_)) {
    const Fractions f = volume_fractions(task_.model->mesh(), *task_.shape);
    farthest = task_.design->step_bounds(f.derivative, cells_);
  }
  std::vector<NlpVariable> out = task_.design->variables();
  for (int j = 0; j < x0.size(); ++j) {
    NlpVariable& v = out[j];
    const double most = std::min(farthest[j], share_ * (v.upper - v.lower));
    v.start = x0[j];
    v.lower = std::max(v.lower, x0[j] - most);
    v.upper = std::min(v.upper, x0[j] + most);
  }
  return out;
}

void MeshStatics::retain(const std::vector<std::vector<int>>& kept) {
  combination_ = kept_columns(task_.combination, kept[0]);
  statics_.set_loads(expanded_ ? MatrixXd(task_.loads * combination_) : task_.loads);
  if (expanded_) combination_.setIdentity(combination_.cols(), combination_.cols());
}

std::string MeshStatics::solve(const VectorXd& x) {
  solved_ = false;
  stress_.reset();
  frequencies_.reset();
  task_.shape->set(task_.design->parameters(x));
  if (const std::string defect = task_.shape->error(); !defect.empty()) return defect;
  fractions_ = volume_fractions(task_.model->mesh(), *task_.shape);
  fractions_.derivative = FractionGradient(fractions_.derivative * task_.design->jacobian());
  if (const auto cut = cut_interface(*task_.model, fractions_.value)) return cut->text;
  const SolidStatus status = statics_.solve(fractions_.value);
  if (status != SolidStatus::Solved) return reason(status);
  for (const SolidLimit& l : task_.limits)
    if (l.response == SolidResponse::Frequency && frequencies().frequency.size() < l.count)
      return "the natural frequencies of the part, limited by '" + l.name + "', were not found";
  solved_ = true;
  const int m = statics_.outputs();
  y_.resize(m + static_cast<Eigen::Index>(extra_.size()), combination_.cols());
  y_.topRows(m) = statics_.y() * combination_;
  for (std::size_t k = 0; k < extra_.size(); ++k)
    y_.row(m + static_cast<int>(k)) =
        extra_[k]->response == SolidResponse::Stress ? stress(false).value : statics_.compliance();
  return {};
}

bool MeshStatics::show_all(const VectorXd& x) {
  expanded_ = true;
  std::vector<int> all(static_cast<std::size_t>(task_.combination.cols()));
  std::iota(all.begin(), all.end(), 0);
  retain({all});
  return solve(x).empty();
}

const StressNorm& MeshStatics::stress(bool with_gradient) {
  if (!stress_ || (with_gradient && !stress_gradient_))
    stress_ = stress_norm(
        statics_,
        with_gradient ? fractions_.derivative : FractionGradient(fractions_.value.size(), 0),
        task_.stress);
  stress_gradient_ = with_gradient;
  return *stress_;
}

/// As many as any limit asks for.
const FrequencyGradient& MeshStatics::frequencies() {
  int count = 0;
  for (const SolidLimit& l : task_.limits)
    if (l.response == SolidResponse::Frequency) count = std::max(count, l.count);
  if (!frequencies_)
    frequencies_ =
        free_frequency_gradient(*task_.model, fractions_.value, fractions_.derivative, count);
  return *frequencies_;
}

std::vector<MatrixXd> MeshStatics::output_gradients(int) {
  const FractionGradient& dv = fractions_.derivative;
  std::vector<MatrixXd> out(static_cast<std::size_t>(dv.cols()), MatrixXd(y_.rows(), y_.cols()));
  const auto take = [&out](int row, const MatrixXd& by_case) {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i].row(row) = by_case.col(static_cast<int>(i)).transpose();
  };
  const int m = statics_.outputs();
  for (int o = 0; o < m; ++o) take(o, combination_.transpose() * statics_.output_gradient(o, dv));
  for (std::size_t k = 0; k < extra_.size(); ++k)
    take(m + static_cast<int>(k), extra_gradient(*extra_[k]));
  return out;
}

/// Of a stress or compliance, retained cases x variables.
MatrixXd MeshStatics::extra_gradient(const SolidLimit& limit) {
  return limit.response == SolidResponse::Stress
             ? stress(true).gradient
             : statics_.compliance_gradient(fractions_.derivative);
}

/// v(fractions, q) with the displacements q = Psi e of the motion:
/// dv = dv at constant q + dv/dq^T (Psi' e + Psi de). The gradient at constant loads f holds
/// -dv/dq^T K^-1 K' q, which is taken out again.
PartSlopes MeshStatics::slopes(int number, const std::vector<int>& kept) {
  const CaseLimit& row = limits_[static_cast<std::size_t>(number)];
  const SolidLimit& limit = *extra_[static_cast<std::size_t>(row.first - statics_.outputs())];
  const MatrixXd e = kept_columns(task_.combination, kept);
  const MatrixXd by_q = limit.response == SolidResponse::Stress ? stress(true).by_displacement
                                                                : MatrixXd(2 * task_.loads * e);
  const MatrixXd a = task_.basis.transpose() * by_q, dv = fractions_.derivative;
  MatrixXd own = extra_gradient(limit), by_loads = MatrixXd::Zero(own.rows(), own.cols());
  statics_.add_adjoint_gradient(by_q, fractions_.derivative, by_loads);
  own -= by_loads;
  const ModeDerivative modes(*task_.model, fractions_.value, task_.basis);
  for (int j = 0; j < dv.cols(); ++j)
    own.col(j) += by_q.cwiseProduct(modes(*task_.model, dv.col(j)) * e).colwise().sum().transpose();
  PartSlopes out;
  out.body = row.motion->response.body;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    out.own[kept[k]] = own.row(static_cast<Eigen::Index>(k));
    out.by_coordinates[kept[k]] = a.col(static_cast<Eigen::Index>(k));
  }
  return out;
}

double MeshStatics::objective() {
  switch (task_.objective) {
    case SolidResponse::Compliance:
      return statics_.compliance().mean();
    case SolidResponse::Stress: {
      const VectorXd& s = stress(false).value;
      const double most = s.maxCoeff(), p = task_.stress.p;
      return most > 0 ? most * std::pow((s / most).array().pow(p).mean(), 1 / p) : 0;
    }
    default:
      return task_.mass_weight * mass();
  }
}

void MeshStatics::objective_gradient(VectorXd& df) {
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
}

/// Those on mass and frequencies.
std::vector<const SolidLimit*> MeshStatics::own_limits() const {
  std::vector<const SolidLimit*> out;
  for (const SolidLimit& l : task_.limits)
    if (!by_case(l.response)) out.push_back(&l);
  return out;
}

std::vector<NlpConstraint> MeshStatics::own_rows() const {
  std::vector<NlpConstraint> out;
  for (const SolidLimit* l : own_limits()) {
    const auto i = static_cast<std::size_t>(l - task_.limits.data());
    if (l->response == SolidResponse::Mass) out.push_back({own_id(i, 0), l->name, 1});
    for (int k = 0; l->response == SolidResponse::Frequency && k < l->count; ++k)
      out.push_back({own_id(i, k), fmt::format("{}[{}]", l->name, k), 1});
  }
  const auto& walls = task_.design->wall_names();
  for (std::size_t w = 0; w < walls.size(); ++w)
    out.push_back({own_id(task_.limits.size(), static_cast<int>(w)), walls[w], 1});
  return out;
}

std::vector<RowImage> MeshStatics::own_images() const {
  std::vector<RowImage> out;
  for (const SolidLimit* l : own_limits())
    out.insert(out.end(), l->response == SolidResponse::Frequency ? l->count : 1,
               {-1, -1, OwnLimits::Parts, l->part_limit});
  out.resize(out.size() + task_.design->wall_names().size());
  return out;
}

VectorXd MeshStatics::own_values() {
  VectorXd g(static_cast<Eigen::Index>(own_rows().size()));
  int row = 0;
  for (const SolidLimit* l : own_limits()) {
    if (l->response == SolidResponse::Mass) {
      g[row++] = mass() / l->limit - 1;
      continue;
    }
    const VectorXd& f = frequencies().frequency;
    for (int k = 0; k < l->count; ++k) g[row++] = 1 - f[k] / l->limit;
  }
  wall_gradient_.resize(static_cast<Eigen::Index>(task_.design->wall_names().size()),
                        fractions_.derivative.cols());
  g.tail(wall_gradient_.rows()) = task_.design->walls(&wall_gradient_);
  return g;
}

RowMatrix MeshStatics::own_gradients() {
  const FractionGradient& dv = fractions_.derivative;
  RowMatrix dg(static_cast<Eigen::Index>(own_rows().size()), dv.cols());
  int row = 0;
  for (const SolidLimit* l : own_limits()) {
    if (l->response == SolidResponse::Mass)
      dg.row(row++) = (dv.transpose() * task_.model->cell_masses()).transpose() / l->limit;
    else
      for (int k = 0; k < l->count; ++k) dg.row(row++) = -frequencies().gradient.row(k) / l->limit;
  }
  dg.bottomRows(wall_gradient_.rows()) = wall_gradient_;
  return dg;
}

ObjectiveTerm MeshStatics::term_of(const SolidLimit& l) const {
  const int number = static_cast<int>(&l - task_.limits.data());
  return l.weight > 0 ? ObjectiveTerm{number, l.weight * l.limit} : ObjectiveTerm();
}

std::vector<ObjectiveTerm> MeshStatics::own_terms() const {
  if (!task_.weighted()) return {};
  std::vector<ObjectiveTerm> out;
  for (const SolidLimit* l : own_limits())
    out.insert(out.end(), l->response == SolidResponse::Frequency ? l->count : 1, term_of(*l));
  out.resize(out.size() + task_.design->wall_names().size());
  return out;
}

double MeshStatics::terms_at_start() const {
  double sum = 0;
  for (const SolidLimit& l : task_.limits)
    sum += (l.response == SolidResponse::Frequency ? -l.weight : l.weight) * l.limit;
  return sum;
}

double MeshStatics::add_checks(std::vector<LimitCheck>& checks) {
  double weighted = 0;
  for (const SolidLimit* l : own_limits()) {
    LimitCheck c{l->name, l->limit, mass(), mass() / l->limit - 1, {}, l->weight};
    if (l->response == SolidResponse::Frequency) {
      c.value = frequencies().frequency.head(l->count).minCoeff();
      c.excess = 1 - c.value / l->limit;
    }
    if (l->weight > 0)
      weighted += (l->response == SolidResponse::Frequency ? -l->weight : l->weight) * c.value;
    checks.insert(checks.begin() + (l - task_.limits.data()), std::move(c));
  }
  const VectorXd g = task_.design->walls();  // 1 - thickness/least
  if (g.size() == 0) return weighted;
  Eigen::Index w = 0;
  const double worst = g.maxCoeff(&w);
  checks.push_back(
      {task_.design->wall_names()[static_cast<std::size_t>(w)], 1, 1 + worst, worst, {}});
  return weighted;
}

HoleDerivative MeshStatics::hole_derivative(const MatrixXd& weights, const VectorXd& own) const {
  const double rho = task_.model->material().rho;
  HoleDerivative out{VectorXd::Zero(task_.model->mesh().cell_count()), {}};
  if (task_.objective == SolidResponse::Mass) out.value.setConstant(-rho * task_.mass_weight);
  if (task_.objective == SolidResponse::Stress) out.missing = "the stress that is minimised";
  if (task_.objective == SolidResponse::Compliance)
    out.value +=
        compliance_of_holes(statics_, VectorXd::Constant(statics_.cases(), 1.0 / statics_.cases()));
  const int m = statics_.outputs();
  for (int o = 0; o < m; ++o)
    if (const VectorXd w = weights.row(o); !w.isZero(0))
      out.value += output_of_holes(statics_, o, combination_ * w);
  for (std::size_t k = 0; k < extra_.size(); ++k) {
    const VectorXd w = weights.row(m + static_cast<int>(k));
    if (w.isZero(0)) continue;
    if (extra_[k]->response == SolidResponse::Compliance)
      out.value += compliance_of_holes(statics_, w);
    else
      out.missing = "the stress limit '" + extra_[k]->name + "'";
  }
  int row = 0;
  for (const SolidLimit* l : own_limits()) {
    if (l->response == SolidResponse::Mass) out.value.array() -= rho * own[row++] / l->limit;
    for (int k = 0; l->response == SolidResponse::Frequency && k < l->count; ++k)
      if (own[row++] > 0) out.missing = "the limit of frequencies '" + l->name + "'";
  }
  return out;
}

}  // namespace liesl
