#pragma once
/// @file
/// Variables that are constants of a mechanism: of springs and dampers, masses of rigid bodies.

#include "mbs/model/mechanism.hpp"
#include "mbs/model/parameter.hpp"
#include "optim/nlp/problem.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// As Sizing: variables, what they change, and as parameters of a motion.
class Constants {
 public:
  /// @throws std::invalid_argument: a force or rigid body that is not there
  Constants(const std::vector<ConstantSpec>& constants, const Mechanism& mechanism);

  const std::vector<NlpVariable>& variables() const { return variables_; }
  int size() const { return static_cast<int>(variables_.size()); }
  std::string unit(int i) const;

  void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const;
  Parameter parameter(int i) const;
  /// d(mass of these bodies)/dx.
  Eigen::VectorXd mass_gradient(const std::vector<int>& counted) const;

 private:
  std::vector<ConstantSpec> constants_;
  std::vector<NlpVariable> variables_;
};

}  // namespace liesl
