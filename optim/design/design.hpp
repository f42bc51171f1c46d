#pragma once
/// @file
/// All that a study may change: sections of beams, outlines of meshed parts, constants.

#include <memory>

#include "optim/design/constants.hpp"
#include "optim/design/part_shape.hpp"
#include "optim/design/sizing.hpp"

namespace liesl {

/// Groups of variables side by side in x: the sizing, then each part in the order of the bodies,
/// then the constants. Neither copied nor moved, as its parts.
class Design {
 public:
  /// Where a group lies in x.
  struct Share {
    std::unique_ptr<VariableGroup> group;
    int first = 0;

    Eigen::VectorXd of(const Eigen::VectorXd& x) const { return x.segment(first, group->size()); }
  };

  /// @throws std::invalid_argument for a study with errors (study_errors.hpp), and as Sizing and
  /// PartShape do
  Design(const StudySpec& study, const Mechanism& mechanism);
  Design(const Design&) = delete;
  Design& operator=(const Design&) = delete;

  /// All of them; and for those who need one kind, that.
  const std::vector<Share>& groups() const { return groups_; }
  const Sizing& sizing() const { return *sizing_; }
  int parts() const { return static_cast<int>(parts_.size()); }
  PartShape& part(int k) const { return *parts_[static_cast<std::size_t>(k)]; }
  /// First of the variables of a part.
  int first(int k) const { return first_[static_cast<std::size_t>(k)]; }
  /// Its share of x.
  Eigen::VectorXd of_part(int k, const Eigen::VectorXd& x) const {
    return x.segment(first(k), part(k).size());
  }
  /// Number of the variable that is the duration of the motion; -1: none is.
  int duration() const { return duration_; }

  const std::vector<NlpVariable>& variables() const { return variables_; }
  const std::vector<std::string>& units() const { return units_; }
  Eigen::VectorXd start() const;
  /// What a change of each variable is measured by: its range, or itself at x, as its group says.
  /// Empty if no group takes ranges: all by the size of x.
  Eigen::VectorXd unit(const Eigen::VectorXd& x) const;

  /// The variables as parameters of the mechanism with the design x.
  std::vector<Parameter> parameters(const Mechanism& designed, const Eigen::VectorXd& x) const;

  /// Writes this design into the mechanism, or into a copy; and how it is simulated.
  void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const;
  Mechanism apply(const Mechanism& mechanism, const Eigen::VectorXd& x) const {
    Mechanism designed = mechanism;
    apply(x, designed);
    return designed;
  }
  SimulationOptions simulation(SimulationOptions options, const Eigen::VectorXd& x) const;

 private:
  template <class Group, class... Arguments>
  Group& add(Arguments&&... arguments);

  std::vector<Share> groups_;
  std::vector<NlpVariable> variables_;
  std::vector<std::string> units_;
  const Sizing* sizing_ = nullptr;
  std::vector<PartShape*> parts_;
  std::vector<int> first_;
  int duration_ = -1;
};

}  // namespace liesl
