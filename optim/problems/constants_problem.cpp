#include "optim/problems/constants_problem.hpp"

#include <algorithm>

namespace liesl {

ConstantsProblem::ConstantsProblem(const Constants& constants, const std::vector<int>& counted,
                                   const Eigen::VectorXd& x, double move)
    : CaselessProblem(constants.variables()), df_(constants.mass_gradient(counted)) {
  for (int i = 0; i < x.size(); ++i) {
    NlpVariable& v = variables_[static_cast<std::size_t>(i)];
    const double most = move * (v.upper - v.lower);
    v.start = x[i];
    v.lower = std::max(v.lower, x[i] - most);
    v.upper = std::min(v.upper, x[i] + most);
  }
}

}  // namespace liesl
