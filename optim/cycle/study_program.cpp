#include "optim/cycle/study_program.hpp"

#include <fmt/format.h>

#include <limits>

#include "mbs/linalg/stop_request.hpp"

namespace liesl {

using Eigen::VectorXd;

namespace {

constexpr double kNearLimit = 2e-3;  // limits that may carry a multiplier

}  // namespace

bool StudyProgram::begin(const VectorXd& start) {
  if (!evaluate(start)) return false;
  constraints_ = surrogate_.problem->constraints();
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    constraints_[i].id = i;
    constraints_[i].name = fmt::format("{}: {}", i, constraints_[i].name);
  }
  begun_ = true;
  return true;
}

bool StudyProgram::evaluate(const VectorXd& x) {
  if (x_.size() == x.size() && x_ == x) return good();
  x_ = x;
  surrogate_ = {};
  try {
    analysis_ = analyse(x);
    if (analysis_->good())
      look_at(x);
    else
      failure_ = analysis_->reason;
  } catch (const Stopped& stopped) {
    surrogate_ = {};
    failure_ = stopped.what();
    stopped_ = true;
  }
  return good();
}

void StudyProgram::differentiate(const VectorXd& x) {
  try {
    surrogate_ = model_.surrogate(*analysis_, x, move_, kNearLimit);
  } catch (const NoSensitivities& why) {
    if (!begun_) throw;
    surrogate_.optimality.reason = why.what();
  }
  if (!surrogate_.problem) {
    failure_ = "there are no sensitivities: " + surrogate_.optimality.reason;
    return;
  }
  const std::size_t rows = surrogate_.problem->constraints().size();
  if (constraints_.empty() || rows == constraints_.size()) return;
  failure_ = fmt::format("there are {} constraints instead of {}: other steps or load cases", rows,
                         constraints_.size());
  surrogate_.problem.reset();
}

void StudyProgram::values(const VectorXd& x, double& f, VectorXd& g) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  f = kNone;
  g.setConstant(kNone);
  if (evaluate(x)) surrogate_.problem->values(x, f, g);
}

void StudyProgram::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  surrogate_.problem->gradients(x, df, dg);
}

}  // namespace liesl
