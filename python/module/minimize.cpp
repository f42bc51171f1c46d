#ifdef LIESL_OPTIM

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "optim/nlp/ipopt_driver.hpp"
#include "python/module/job.hpp"
#include "python/module/outcome.hpp"

namespace liesl::python {
namespace {

using Eigen::VectorXd;

/// A problem whose functions are methods of a Python object that has checked what they return
/// (liesl/nlp.py): objective, constraints, gradient, jacobian.
class PythonProblem final : public Problem {
 public:
  explicit PythonProblem(const py::object& functions) : functions_(hold(functions)) {
    for (const py::handle& v : functions.attr("variables")) {
      const auto [name, lower, upper, start] =
          v.cast<std::tuple<std::string, double, double, double>>();
      variables_.push_back({name, lower, upper, start});
    }
    for (const py::handle& name : functions.attr("rows"))
      constraints_.push_back({constraints_.size(), name.cast<std::string>(), 0});
  }

  /// While it is solved.
  void stop_with(const Stop& stop) { stop_ = &stop; }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const VectorXd& x, double& f, VectorXd& g) override {
    const py::gil_scoped_acquire locked;
    f = call<double>("objective", x);
    g = call<VectorXd>("constraints", x);
  }
  void gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) override {
    const py::gil_scoped_acquire locked;
    df = call<VectorXd>("gradient", x);
    dg = call<RowMatrix>("jacobian", x);
  }

 private:
  /// Of the functions, unless the job is to stop. @pre locked
  template <class T>
  T call(const char* name, const VectorXd& x) const {
    if (stop_->requested()) throw output::Interrupted(SIGINT);
    return functions_->attr(name)(x).cast<T>();
  }

  Held functions_;
  const Stop* stop_ = nullptr;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

py::dict dict_of(const NlpResult& r, const std::vector<NlpConstraint>& rows) {
  py::dict out;
  out["status"] = to_string(r.status);
  out["reason"] = r.reason;
  out["solved"] = r.solved();
  out["x"] = r.x;
  out["f"] = r.f;
  out["g"] = r.g;
  out["violation"] = r.violation;
  VectorXd multipliers = VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
  for (const NlpConstraint& row : rows)
    if (const auto found = r.multipliers.find(row.id); found != r.multipliers.end())
      multipliers[static_cast<Eigen::Index>(row.id)] = found->second;
  out["multipliers"] = multipliers;
  out["lower_multipliers"] = r.lower_multipliers;
  out["upper_multipliers"] = r.upper_multipliers;
  out["iterations"] = r.iterations;
  out["evaluations"] = r.evaluations;
  out["wall_s"] = r.time;
  return out;
}

py::dict minimize(const py::object& functions, double tolerance, double feasibility,
                  int max_iterations) {
  const auto problem = std::make_shared<PythonProblem>(functions);
  NlpOptions options;
  options.tolerance = tolerance;
  options.acceptable = std::max(options.acceptable, tolerance);
  options.feasibility = feasibility;
  options.max_iterations = max_iterations;
  const NlpResult result = run_job([problem, options](const Stop& stop) {
    NlpOptions stoppable = options;
    stoppable.progress = [&stop](const NlpProgress&) { return !stop.requested(); };
    problem->stop_with(stop);
    return solve_ipopt(*problem, stoppable);
  });
  return dict_of(result, problem->constraints());
}

}  // namespace

void bind_minimize(py::module_& module) { module.def("minimize", &minimize); }

}  // namespace liesl::python

#endif
