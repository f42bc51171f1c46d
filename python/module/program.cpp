#ifdef LIESL_OPTIM

#include "python/module/program.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <cmath>
#include <mutex>

#include "apps/tasks/study_nlp.hpp"
#include "python/module/job.hpp"
#include "python/module/outcome.hpp"

namespace liesl::python {
namespace {

using Eigen::VectorXd;

/// Values and gradients at one design.
struct ProgramPoint {
  double f = 0;
  VectorXd g, df;
  RowMatrix dg;
};

/// A study as a nonlinear program. One call at a time: a problem keeps what it made of its latest
/// x.
class Program {
 public:
  explicit Program(std::shared_ptr<const Study> study)
      : study_(std::move(study)), problem_(study_nlp(*study_, choose_space(study_->scene))) {}

  const Problem& problem() const { return *problem_; }
  ProgramPoint at(const VectorXd& x) {
    const std::lock_guard<std::mutex> alone(alone_);
    const auto n = static_cast<Eigen::Index>(problem_->variables().size());
    const auto m = static_cast<Eigen::Index>(problem_->constraints().size());
    ProgramPoint p{0, VectorXd(m), VectorXd::Zero(n), RowMatrix::Zero(m, n)};
    problem_->values(x, p.f, p.g);
    if (std::isfinite(p.f)) problem_->gradients(x, p.df, p.dg);
    return p;
  }

 private:
  std::shared_ptr<const Study> study_;
  std::unique_ptr<Problem> problem_;
  std::mutex alone_;
};

std::vector<std::string> rows_of(const Program& program) {
  std::vector<std::string> rows;
  for (const NlpConstraint& row : program.problem().constraints()) rows.push_back(row.name);
  return rows;
}

py::tuple evaluated(const std::shared_ptr<Program>& program, const VectorXd& x) {
  const ProgramPoint p = run_job([program, x](const Stop&) { return program->at(x); });
  return py::make_tuple(p.f, p.g, p.df, p.dg);
}

}  // namespace

py::object program_of(const std::shared_ptr<const Study>& study) {
  return py::cast(run_job([study](const Stop&) { return std::make_shared<Program>(study); }));
}

void bind_programs(py::module_& module) {
  py::class_<Program, std::shared_ptr<Program>>(module, "Program")
      .def("rows", &rows_of)
      .def("evaluate", &evaluated);
}

}  // namespace liesl::python

#endif
