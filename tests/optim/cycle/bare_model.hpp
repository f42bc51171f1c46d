#pragma once
/// @file
/// A study of one variable, minimise x in [0, 1], whose subproblems tests give.

#include "optim/cycle/design_model.hpp"

namespace liesl::test {

class BareModel : public DesignModel {
 public:
  explicit BareModel(double start) : variables_{{"x", 0, 1, start}} {}
  struct Known final : DesignAnalysis {
    std::shared_ptr<DesignAnalysis> figures() const override {
      return std::make_shared<Known>(*this);
    }
  };
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  Eigen::VectorXd unit(const Eigen::VectorXd&) const override { return {}; }
  std::shared_ptr<DesignAnalysis> analyse(const Eigen::VectorXd& x, const Progress&) override {
    auto out = std::make_shared<Known>();
    out->objective = x[0];
    return out;
  }
  std::unique_ptr<StaticProblem> static_problem(const DesignAnalysis&, const Eigen::VectorXd&,
                                                double) const override {
    return {};
  }
  DynamicOptimality optimality(const DesignAnalysis&, const Eigen::VectorXd&,
                               const Progress&) const override {
    return {};
  }
  std::optional<double> load_change(const DesignAnalysis&, const DesignAnalysis&) const override {
    return {};
  }

 private:
  std::vector<NlpVariable> variables_;
};

}  // namespace liesl::test
