#include "optim/cycle/motion_gradients.hpp"

#include <algorithm>
#include <iterator>

#include "mbs/sensitivity/response_sensitivity.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

template <FrameGroup G>
MotionGradients<G>::MotionGradients(const Design& design, const DesignRun<G>& run,
                                    const VectorXd& x, std::vector<LimitedResponse> responses)
    : responses_(std::move(responses)), times_(run.times()), gradient_(responses_.size()) {
  value_.setZero(static_cast<Eigen::Index>(responses_.size()), records());
  const Model<G>& model = *run.model;
  Parameters<G> parameters;
  for (const Parameter& p : design.parameters(run.mechanism, x))
    parameters.emplace_back(run.mechanism, model, p);
  const ResponseValues<G> values(run.mechanism, model);
  std::vector<ResponseSensitivity<G>> sensitivities;
  for (const auto& r : responses_)
    sensitivities.emplace_back(model, values, r.response, parameters);
  State<G> completed;
  int record = 0;
  const auto take = [&](long, const State<G>& s, const StateSensitivity& ds) {
    if (record == records() || s.t != times_[static_cast<std::size_t>(record)]) return;
    completed = s;
    model.complete(completed);
    for (std::size_t r = 0; r < responses_.size(); ++r) {
      const VectorXd y = values(responses_[r].response, completed);
      const double v = y.norm();
      value_(static_cast<int>(r), record) = v;
      if (v > 0 && v >= kKept * run.limits[responses_[r].constraint].largest)
        gradient_[r][record] = sensitivities[r](s, ds).transpose() * y / v;
    }
    ++record;
  };
  reason_ = direct_sensitivity<G>(model, run.tape, parameters, take).reason;
}

template <FrameGroup G>
const VectorXd* MotionGradients<G>::gradient(int response, int record) const {
  const auto& kept = gradient_[static_cast<std::size_t>(response)];
  const auto found = kept.find(record);
  return found == kept.end() ? nullptr : &found->second;
}

template <FrameGroup G>
const VectorXd* MotionGradients<G>::nearest_gradient(int response, int record, int* at) const {
  const auto& kept = gradient_[static_cast<std::size_t>(response)];
  if (kept.empty()) return nullptr;
  auto next = kept.lower_bound(record);
  if (next == kept.end() ||
      (next != kept.begin() && next->first - record > record - std::prev(next)->first))
    --next;
  *at = next->first;
  return &next->second;
}

template class MotionGradients<SE2>;
template class MotionGradients<SE3>;

}  // namespace liesl
