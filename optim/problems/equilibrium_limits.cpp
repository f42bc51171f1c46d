#include "optim/problems/equilibrium_limits.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "optim/problems/motion_gradients.hpp"

namespace liesl {

using Eigen::VectorXd;

template <FrameGroup G>
EquilibriumLimits<G>::EquilibriumLimits(const DesignSimulator<G>& simulator, const StudySpec& study)
    : simulator_(simulator), study_(study), variables_(simulator.design().variables()) {
  run_ = simulator.run(simulator.design().start());
  if (!run_.good())
    throw std::runtime_error("the start design has no equilibria: " + run_.reason());
  for (const LimitSeries& limit : run_.limits) {
    constraints_.push_back({static_cast<ConstraintId>(constraints_.size()), limit.name, 1});
    record_.push_back(static_cast<int>(std::max_element(limit.values.begin(), limit.values.end()) -
                                       limit.values.begin()));
  }
}

template <FrameGroup G>
void EquilibriumLimits<G>::values(const VectorXd& x, double& f, VectorXd& g) {
  run_ = simulator_.run(x);
  f = 0;
  for (std::size_t r = 0; r < record_.size(); ++r) {
    const bool known =
        run_.good() && static_cast<std::size_t>(record_[r]) < run_.limits[r].values.size();
    g[static_cast<Eigen::Index>(r)] =
        known
            ? run_.limits[r].values[static_cast<std::size_t>(record_[r])] / run_.limits[r].limit - 1
            : std::numeric_limits<double>::quiet_NaN();
  }
}

template <FrameGroup G>
void EquilibriumLimits<G>::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  df.setZero();
  dg.setZero();
  std::vector<LimitedResponse> responses;
  for (std::size_t c = 0; c < record_.size(); ++c)
    responses.push_back({static_cast<int>(c), study_.constraints[c].response, 0, 0});
  const MotionGradients gradients(simulator_.design(), run_, x, responses);
  for (std::size_t r = 0; r < record_.size(); ++r)
    if (const VectorXd* dv = gradients.gradient(static_cast<int>(r), record_[r]))
      dg.row(static_cast<Eigen::Index>(r)) = dv->transpose() / run_.limits[r].limit;
}

template class EquilibriumLimits<SE2>;
template class EquilibriumLimits<SE3>;

}  // namespace liesl
