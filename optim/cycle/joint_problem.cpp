#include "optim/cycle/joint_problem.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

/// Ids of members leave these bits free: none has millions of limits.
constexpr int kMemberBit = 56;

}  // namespace

JointProblem::JointProblem(std::vector<Member> members) : members_(std::move(members)) {
  for (const Member& m : members_) {
    const auto& own = m.problem->variables();
    places_.push_back({static_cast<int>(variables_.size()), static_cast<int>(own.size()), 0, 0});
    variables_.insert(variables_.end(), own.begin(), own.end());
  }
  take_constraints();
}

void JointProblem::take_constraints() {
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

int JointProblem::add_violated(const VectorXd& x, double tolerance) {
  int added = 0;
  for (std::size_t k = 0; k < members_.size(); ++k)
    added +=
        members_[k].problem->add_violated(x.segment(places_[k].x, places_[k].variables), tolerance);
  take_constraints();
  return added;
}

int JointProblem::load_cases() const {
  int cases = 0;
  for (const Member& m : members_) cases += m.problem->load_cases();
  return cases;
}

std::vector<LimitedResponse> JointProblem::responses() const {
  std::vector<LimitedResponse> all;
  for (const Member& m : members_)
    for (LimitedResponse& r : m.problem->responses()) all.push_back(std::move(r));
  return all;
}

std::vector<RowImage> JointProblem::images() const {
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

std::string JointProblem::obstacle() const {
  for (const Member& m : members_)
    if (std::string text = m.problem->obstacle(); !text.empty()) return text;
  return {};
}

void JointProblem::values(const VectorXd& x, double& f, VectorXd& g) {
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

void JointProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  dg.setZero();
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const Place& at = places_[k];
    VectorXd own(at.variables);
    RowMatrix rows(at.constraints, at.variables);
    members_[k].problem->gradients(x.segment(at.x, at.variables), own, rows);
    df.segment(at.x, at.variables) = members_[k].weight * own;
    dg.block(at.row, at.x, at.constraints, at.variables) = rows;
  }
}

}  // namespace liesl
