#pragma once
/// @file
/// Sizing variables: dimensions of beam sections, grouped along a beam, linked between beams.

#include "mbs/model/mechanism.hpp"
#include "mbs/sections/section_law.hpp"
#include "optim/design/variable_group.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// One place where a variable acts: an element of a body.
struct SizedElement {
  int body = 0, element = 0;
};

class Sizing final : public VariableGroup {
 public:
  /// @throws std::invalid_argument: a body that is no beam, a shape without that dimension, more
  ///         groups than elements
  Sizing(const std::vector<DesignSpec>& design, const Mechanism& mechanism);

  /// Names "rod_diameters[0]" (no index for one group), bounds, start [m].
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<std::string>& units() const override { return units_; }
  /// Where variable i acts, and on which dimensions of the section.
  const std::vector<SizedElement>& elements(int i) const { return elements_[i]; }
  const std::vector<std::string>& dimensions(int i) const { return dimensions_[i]; }

  /// Writes these dimensions into the sections of the mechanism; of a taper the others stay linear.
  void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const override;
  std::vector<Parameter> parameters(const Mechanism& designed,
                                    const Eigen::VectorXd& x) const override;
  bool measured_by_range() const override { return false; }
  bool has_statics() const override { return true; }

  /// d(section law)/dx_i of an element at the dimensions that `mechanism` has.
  SectionLaw derivative(const Mechanism& mechanism, int i, SizedElement at) const;
  /// d2(section law)/dx_i dx_j, central differences of the exact first derivative.
  SectionLaw second_derivative(const Mechanism& mechanism, int i, int j, SizedElement at) const;

 private:
  Parameter parameter(const Mechanism& mechanism, int i) const;

  std::vector<NlpVariable> variables_;
  std::vector<std::string> units_;
  std::vector<std::vector<SizedElement>> elements_;
  std::vector<std::vector<std::string>> dimensions_;
};

/// Mass of some bodies, kg.
double mass_of(const Mechanism& mechanism, const std::vector<int>& bodies);

/// Arc length of a beam element at reference, m.
double element_length(const BeamSpec& beam, int element);

}  // namespace liesl
