#include "optim/problems/variables_without_statics.hpp"

#include <algorithm>
#include <utility>

namespace liesl {

VariablesWithoutStatics::VariablesWithoutStatics(const std::vector<NlpVariable>& variables,
                                                 Eigen::VectorXd by, const Eigen::VectorXd& x,
                                                 double move)
    : CaselessProblem(variables), df_(std::move(by)) {
  for (int i = 0; i < x.size(); ++i) {
    NlpVariable& v = variables_[static_cast<std::size_t>(i)];
    const double most = move * (v.upper - v.lower);
    v.start = x[i];
    v.lower = std::max(v.lower, x[i] - most);
    v.upper = std::min(v.upper, x[i] + most);
  }
}

}  // namespace liesl
