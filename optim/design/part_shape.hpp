#pragma once
/// @file
/// A meshed part of a study: its mesh, its outline and what may change of it.

#include "mbs/model/mechanism.hpp"
#include "optim/design/shape.hpp"
#include "optim/design/variable_group.hpp"

namespace liesl {

/// Neither copied nor moved: the design refers to the shape and the model.
struct PartShape final : VariableGroup {
  int body = 0;
  levelset::LevelSetPtr shape;
  std::shared_ptr<const SolidModel> mesh;  ///< that of the mechanism
  const SolidModel& model;
  ShapeDesign design;

  /// @throws std::invalid_argument for a body that is no meshed part with an outline, and as
  /// ShapeDesign does
  PartShape(const Mechanism& mechanism, int body_index, const ShapeDesignSpec& spec);
  PartShape(const PartShape&) = delete;
  PartShape& operator=(const PartShape&) = delete;

  const std::vector<NlpVariable>& variables() const override { return design.variables(); }
  const std::vector<std::string>& units() const override { return design.units(); }

  /// Derivative of the fractions of the cells at x [cells x variables].
  Eigen::MatrixXd fraction_gradient(const Eigen::VectorXd& x) const;

  /// Writes the parameters of the outline at x into the part of the mechanism.
  void apply(const Eigen::VectorXd& x, Mechanism& mechanism) const override;
  /// By the fractions of the cells.
  std::vector<Parameter> parameters(const Mechanism& designed,
                                    const Eigen::VectorXd& x) const override;
  bool has_statics() const override { return true; }
};

}  // namespace liesl
