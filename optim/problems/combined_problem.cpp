#include "optim/problems/combined_problem.hpp"

#include <algorithm>

namespace liesl {
namespace {

using Eigen::VectorXd;

/// Ids of members leave these bits free: none has millions of limits.
constexpr int kMemberBit = 56;

}  // namespace

CombinedProblem::CombinedProblem(std::vector<Member> members) : members_(std::move(members)) {
  take_variables();
  take_constraints();
}

void CombinedProblem::take_variables() {
  for (const Member& m : members_) {
    const auto& own = m.problem->variables();
    places_.push_back({m.first, static_cast<int>(own.size()), 0, 0});
    const auto end = static_cast<std::size_t>(m.first) + own.size();
    if (variables_.size() < end) variables_.resize(end);
    for (std::size_t i = 0; i < own.size(); ++i) {
      NlpVariable& v = variables_[static_cast<std::size_t>(m.first) + i];
      if (v.name.empty()) v = own[i];
      v.lower = std::max(v.lower, own[i].lower);
      v.upper = std::min(v.upper, own[i].upper);
    }
  }
}

void CombinedProblem::take_constraints() {
  constraints_.clear();
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const auto& own = members_[k].problem->constraints();
    places_[k].row = static_cast<int>(constraints_.size());
    places_[k].constraints = static_cast<int>(own.size());
    for (NlpConstraint c : own) {
      c.id ^= static_cast<ConstraintId>(k) << kMemberBit;
      constraints_.push_back(std::move(c));
    }
  }
}

std::unique_ptr<StaticProblem> combined(std::vector<CombinedProblem::Member> members) {
  if (members.size() == 1 && members.front().weight == 1) return std::move(members.front().problem);
  return std::make_unique<CombinedProblem>(std::move(members));
}

int CombinedProblem::add_violated(const VectorXd& x, double tolerance) {
  int added = 0;
  for (std::size_t k = 0; k < members_.size(); ++k)
    added +=
        members_[k].problem->add_violated(x.segment(places_[k].x, places_[k].variables), tolerance);
  take_constraints();
  return added;
}

int CombinedProblem::add_records(const std::vector<std::set<int>>& records) {
  int added = 0;
  auto next = records.begin();
  for (const Member& m : members_) {
    const auto end = next + static_cast<std::ptrdiff_t>(m.problem->responses().size());
    added += m.problem->add_records({next, end});
    next = end;
  }
  take_constraints();
  return added;
}

int CombinedProblem::load_cases() const {
  int cases = 0;
  for (const Member& m : members_) cases += m.problem->load_cases();
  return cases;
}

std::vector<LimitedResponse> CombinedProblem::responses() const {
  std::vector<LimitedResponse> all;
  for (const Member& m : members_)
    for (LimitedResponse& r : m.problem->responses()) all.push_back(std::move(r));
  return all;
}

std::vector<RowImage> CombinedProblem::images() const {
  std::vector<RowImage> all;
  int first = 0;
  for (const Member& m : members_) {
    for (RowImage image : m.problem->images()) {
      if (image.response >= 0) image.response += first;
      all.push_back(image);
    }
    first += static_cast<int>(m.problem->responses().size());
  }
  return all;
}

std::vector<ObjectiveTerm> CombinedProblem::objective_terms() const {
  std::vector<ObjectiveTerm> all(constraints_.size());
  bool any = false;
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const std::vector<ObjectiveTerm> own = members_[k].problem->objective_terms();
    std::copy(own.begin(), own.end(), all.begin() + places_[k].row);
    any = any || !own.empty();
  }
  return any ? all : std::vector<ObjectiveTerm>();
}

std::string CombinedProblem::undefined_reason() const {
  for (const Member& m : members_)
    if (std::string text = m.problem->undefined_reason(); !text.empty()) return text;
  return {};
}

void CombinedProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  f = 0;
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const Place& at = places_[k];
    double own = 0;
    VectorXd rows(at.constraints);
    members_[k].problem->values(x.segment(at.x, at.variables), own, rows);
    f += members_[k].weight * own;
    g.segment(at.row, at.constraints) = rows;
  }
}

void CombinedProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  df.setZero();
  dg.setZero();
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const Place& at = places_[k];
    VectorXd own(at.variables);
    RowMatrix rows(at.constraints, at.variables);
    members_[k].problem->gradients(x.segment(at.x, at.variables), own, rows);
    df.segment(at.x, at.variables) += members_[k].weight * own;
    dg.block(at.row, at.x, at.constraints, at.variables) = rows;
  }
}

HessianShape CombinedProblem::hessian_shape() const {
  const bool all = std::all_of(members_.begin(), members_.end(),
                               [](const Member& m) { return m.problem->has_hessian(); });
  return all ? HessianShape::Dense : HessianShape::None;
}

void CombinedProblem::hessian(const VectorXd& x, double sigma, const VectorXd& lambda,
                              Eigen::MatrixXd& h) {
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const Place& at = places_[k];
    Eigen::MatrixXd own = Eigen::MatrixXd::Zero(at.variables, at.variables);
    members_[k].problem->hessian(x.segment(at.x, at.variables), sigma * members_[k].weight,
                                 lambda.segment(at.row, at.constraints), own);
    h.block(at.x, at.x, at.variables, at.variables) += own;
  }
}

}  // namespace liesl
