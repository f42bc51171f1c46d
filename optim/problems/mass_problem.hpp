#pragma once
/// @file
/// Limits on the mass of bodies in studies of motions.

#include "optim/design/design.hpp"
#include "optim/problems/static_problem.hpp"

namespace liesl {

/// d(mass of these bodies)/dx by the variables of a design as parameters of the mechanism with it,
/// kg per unit of each.
Eigen::VectorXd mass_gradient(const std::vector<Parameter>& parameters, const Mechanism& designed,
                              const std::vector<int>& bodies);

/// Rows mass/limit - 1 <= 0, exact at every x (without second derivatives). The objective is 0.
class MassProblem final : public CaselessProblem {
 public:
  MassProblem(const Mechanism& mechanism, const Design& design,
              const std::vector<MassLimitSpec>& limits, const Eigen::VectorXd& x);

  std::vector<RowImage> images() const override;
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

 private:
  const Design& design_;
  const std::vector<MassLimitSpec> limits_;
  Mechanism designed_;  ///< at the latest x
};

}  // namespace liesl
