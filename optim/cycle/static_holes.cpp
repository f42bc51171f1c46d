// The Lagrangian of the static problem of a meshed part as holes see it.
#include "mbs/solids/topological_derivative.hpp"
#include "optim/cycle/static_shape.hpp"

namespace liesl {

using Eigen::VectorXd;

HoleDerivative StaticShape::hole_derivative(
    const std::map<ConstraintId, double>& multipliers) const {
  const double rho = task_.model->material().rho;
  HoleDerivative out{VectorXd::Zero(task_.model->mesh().cell_count()), {}};
  if (task_.objective == SolidResponse::Mass) out.value.setConstant(-rho * task_.mass_weight);
  if (task_.objective == SolidResponse::Stress) out.missing = "the stress that is minimised";
  if (task_.objective == SolidResponse::Compliance)
    out.value +=
        compliance_of_holes(statics_, VectorXd::Constant(statics_.cases(), 1.0 / statics_.cases()));

  std::size_t row = 0;  // in the order of the constraints
  const auto next_multiplier = [&] {
    const auto at = multipliers.find(constraints_[row++].id);
    return at == multipliers.end() ? 0.0 : at->second;
  };
  std::vector<VectorXd> weights(task_.limits.size(), VectorXd::Zero(combination_.cols()));
  for (const auto& r : retained_.rows)
    weights[static_cast<std::size_t>(limit_of_[r.limit])][r.kept] = next_multiplier();
  for (std::size_t i = 0; i < task_.limits.size(); ++i) {
    const SolidLimit& l = task_.limits[i];
    const VectorXd w = weights[i] / l.limit;
    switch (l.response) {
      case SolidResponse::Output:
        for (int k = 0; k < l.count && !w.isZero(0); ++k)
          out.value += output_of_holes(statics_, l.first + k,
                                       combination_ * shares(l).col(k).cwiseProduct(w));
        break;
      case SolidResponse::Compliance:
        if (!w.isZero(0)) out.value += compliance_of_holes(statics_, w);
        break;
      case SolidResponse::Stress:
        if (!w.isZero(0)) out.missing = "the stress limit '" + l.name + "'";
        break;
      case SolidResponse::Mass:
        out.value.array() -= rho * next_multiplier() / l.limit;
        break;
      case SolidResponse::Frequency:
        for (int k = 0; k < l.count; ++k)
          if (next_multiplier() > 0) out.missing = "the limit of frequencies '" + l.name + "'";
        break;
    }
  }
  return out;
}

}  // namespace liesl
