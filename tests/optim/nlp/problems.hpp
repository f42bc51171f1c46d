#pragma once
/// @file
/// Small problems for the tests of the drivers, and the list of all drivers.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "optim/nlp/ipopt_driver.hpp"
#include "optim/nlp/nlopt_driver.hpp"
#include "optim/nlp/separable.hpp"

namespace liesl::test {

/// A problem from functions, for one-off cases: minimise f subject to g <= 0.
class Lambda : public Problem {
 public:
  std::vector<NlpVariable> v;
  std::vector<NlpConstraint> c;
  std::function<void(const Eigen::VectorXd&, double&, Eigen::VectorXd&)> value;
  std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&, RowMatrix&)> gradient;

  const std::vector<NlpVariable>& variables() const override { return v; }
  const std::vector<NlpConstraint>& constraints() const override { return c; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override { value(x, f, g); }
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    gradient(x, df, dg);
  }
};

/// min x1 + x2, x1 + x2 >= `low`, x1 <= `high`, in [0, 5]^2.
inline Lambda contradiction(double low, double high) {
  Lambda p;
  p.v = {{"x1", 0, 5, 1}, {"x2", 0, 5, 1}};
  p.c = {{11, "strong enough", 1}, {22, "slim enough", 1}};
  p.value = [=](const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
    f = x.sum();
    g << low - x.sum(), x[0] - high;
  };
  p.gradient = [](const Eigen::VectorXd&, Eigen::VectorXd& df, RowMatrix& dg) {
    df.setOnes();
    dg << -1, -1, 1, 0;
  };
  return p;
}

using Driver = std::pair<std::string, std::function<NlpResult(Problem&, const NlpOptions&)>>;

inline std::vector<Driver> all_drivers() {
  const auto nlopt = [](NloptMethod method) {
    return [method](Problem& p, const NlpOptions& o) { return solve_nlopt(p, method, o); };
  };
  const auto separable = [](bool conservative) {
    return [conservative](Problem& p, const NlpOptions& o) {
      SeparableOptions s;
      s.conservative = conservative;
      return solve_separable(p, o, s);
    };
  };
  return {{"Ipopt", [](Problem& p, const NlpOptions& o) { return solve_ipopt(p, o); }},
          {"Ipopt L-BFGS",
           [](Problem& p, NlpOptions o) {
             o.hessian = HessianUse::Quasi;
             return solve_ipopt(p, o);
           }},
          {"GCMMA", separable(true)},
          {"MMA", separable(false)},
          {"NLopt MMA", nlopt(NloptMethod::Mma)},
          {"NLopt CCSAQ", nlopt(NloptMethod::Ccsaq)},
          {"NLopt SLSQP", nlopt(NloptMethod::Slsqp)}};
}

inline NlpOptions moderate() {
  NlpOptions o;
  o.tolerance = 1e-6;
  o.max_iterations = 3000;
  return o;
}

}  // namespace liesl::test
