#pragma once
/// @file
/// Variables that are constants of a mechanism and its motion: of springs and dampers, masses of
/// rigid bodies, values of the tables of drives, the duration.

#include "optim/design/variable_group.hpp"
#include "optim/study/study.hpp"

namespace liesl {

class Constants final : public VariableGroup {
 public:
  /// @throws std::invalid_argument: a force, rigid body or table that is not there
  Constants(const StudySpec& study, const Mechanism& mechanism);

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<std::string>& units() const override { return units_; }
  /// Number of the variable that is the duration; -1: none is.
  int duration() const;
  /// Without any, other variables alone say what a change is measured by.
  bool measured_by_range() const override { return size() > 0; }

  void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const override;
  /// Duration and step of the motion at x: as many steps, whatever the duration.
  SimulationOptions simulation(SimulationOptions options, const Eigen::VectorXd& x) const override;
  std::vector<Parameter> parameters(const Mechanism& designed,
                                    const Eigen::VectorXd& x) const override;
  Parameter parameter(int i, const Eigen::VectorXd& x) const;

 private:
  TimeFunction motion(int table, const Eigen::VectorXd& x) const;
  DriveDerivative by_value(int i, const Eigen::VectorXd& x) const;

  std::vector<ConstantSpec> constants_;
  std::vector<DriveTable> drives_;
  double duration_;
  std::vector<NlpVariable> variables_;
  std::vector<std::string> units_;
};

}  // namespace liesl
