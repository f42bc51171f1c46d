#pragma once
/// @file
/// What `liesl sensitivity` differentiates, as data.

#include <functional>

#include "apps/output/sensitivity_writer.hpp"
#include "apps/scene/scene.hpp"
#include "mbs/model/parameter.hpp"
#include "mbs/sensitivity/functional.hpp"

namespace liesl {

enum class SensitivityMethod { Auto, Direct, Adjoint };

/// A scene at the values p, and its parameters there.
struct SensitivityProblem {
  Scene scene;  ///< with the mechanism at p, and all responses that are asked for
  std::vector<output::Sensitivities::Parameter> names;  ///< name, unit, value
  std::vector<Parameter> parameters;
  std::function<Mechanism(const Eigen::VectorXd& p)> mechanism_at;  ///< for differences
  std::function<SimulationOptions(const Eigen::VectorXd& p)> options_at;

  Eigen::VectorXd values() const;
};

struct SensitivityRequest {
  std::vector<FunctionalSpec> functionals;
  SensitivityMethod method = SensitivityMethod::Auto;
};

}  // namespace liesl
