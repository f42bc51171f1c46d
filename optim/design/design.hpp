#pragma once
/// @file
/// All that a study may change: sections of beams, outlines of meshed parts, constants.

#include <memory>

#include "optim/design/constants.hpp"
#include "optim/design/part_shape.hpp"
#include "optim/design/sizing.hpp"

namespace liesl {

/// Variables x: those of the sizing, then those of each part in the order of the bodies, then the
/// constants. Neither copied nor moved, as its parts.
class Design {
 public:
  /// @throws std::invalid_argument for a study with errors (study_errors.hpp), and as Sizing and
  /// PartShape do
  Design(const StudySpec& study, const Mechanism& mechanism);

  const Sizing& sizing() const { return sizing_; }
  int parts() const { return static_cast<int>(parts_.size()); }
  PartShape& part(int k) const { return *parts_[static_cast<std::size_t>(k)]; }
  /// First of the variables of a part.
  int first(int k) const { return first_[static_cast<std::size_t>(k)]; }
  /// Its share of x.
  Eigen::VectorXd of_part(int k, const Eigen::VectorXd& x) const {
    return x.segment(first(k), part(k).design.size());
  }

  const Constants& constants() const { return constants_; }
  int first_constant() const { return static_cast<int>(variables_.size()) - constants_.size(); }

  const std::vector<NlpVariable>& variables() const { return variables_; }
  const std::vector<std::string>& units() const { return units_; }
  Eigen::VectorXd start() const;
  /// What a change of each variable is measured by: sections by themselves at x, outlines and
  /// constants by the range of the variable. Empty if there are sections only: all by the size of
  /// x.
  Eigen::VectorXd unit(const Eigen::VectorXd& x) const;

  /// The variables as parameters of the mechanism with the design x. Outlines: by the fractions of
  /// their cells.
  std::vector<Parameter> parameters(const Mechanism& designed, const Eigen::VectorXd& x) const;

  /// Writes this design into the mechanism, or into a copy; and how it is simulated.
  void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const;
  Mechanism apply(const Mechanism& mechanism, const Eigen::VectorXd& x) const {
    Mechanism designed = mechanism;
    apply(x, designed);
    return designed;
  }
  SimulationOptions simulation(const SimulationOptions& options, const Eigen::VectorXd& x) const {
    return constants_.simulation(options, x.tail(constants_.size()));
  }

 private:
  Sizing sizing_;
  std::vector<std::unique_ptr<PartShape>> parts_;
  Constants constants_;
  std::vector<int> first_;
  std::vector<NlpVariable> variables_;
  std::vector<std::string> units_;
};

}  // namespace liesl
