#pragma once
/// @file
/// Variables that are constants of a mechanism and its motion: of springs and dampers, masses of
/// rigid bodies, values of the tables of drives, the duration.

#include "mbs/model/mechanism.hpp"
#include "mbs/model/parameter.hpp"
#include "mbs/solvers/options.hpp"
#include "optim/nlp/problem.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// As Sizing: variables, what they change, and as parameters of a motion.
class Constants {
 public:
  /// @throws std::invalid_argument: a force, rigid body or table that is not there
  Constants(const StudySpec& study, const Mechanism& mechanism);

  const std::vector<NlpVariable>& variables() const { return variables_; }
  int size() const { return static_cast<int>(variables_.size()); }
  std::string unit(int i) const;
  /// Number of the variable that is the duration; -1: none is.
  int duration() const;

  void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const;
  /// Duration and step of the motion at x: as many steps, whatever the duration.
  SimulationOptions simulation(SimulationOptions options, const Eigen::VectorXd& x) const;
  Parameter parameter(int i, const Eigen::VectorXd& x) const;
  /// d(mass of these bodies)/dx.
  Eigen::VectorXd mass_gradient(const std::vector<int>& counted) const;

 private:
  TimeFunction motion(int table, const Eigen::VectorXd& x) const;
  DriveDerivative by_value(int i, const Eigen::VectorXd& x) const;

  std::vector<ConstantSpec> constants_;
  std::vector<DriveTable> drives_;
  double duration_;
  std::vector<NlpVariable> variables_;
};

}  // namespace liesl
