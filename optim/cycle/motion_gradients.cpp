#include "optim/cycle/motion_gradients.hpp"

#include <algorithm>
#include <iterator>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"

namespace liesl {

using Eigen::VectorXd;

namespace {

/// dv/dx of the stress or compliance of a meshed part at a record that has slopes.
template <FrameGroup G>
VectorXd part_gradient(const Model<G>& model, const PartSlopes& slopes, int record,
                       const State<G>& s, const StateSensitivity& ds) {
  const auto& body =
      dynamic_cast<const SolidBody<G>&>(*model.bodies[static_cast<std::size_t>(slopes.body)]);
  VectorXd h = VectorXd::Zero(body.size());
  body.add_coordinates_gradient(model.body_state(s, slopes.body), slopes.by_coordinates.at(record),
                                h.data());
  VectorXd dv =
      ds.eta.middleRows(G::dim * model.first_node(slopes.body), body.size()).transpose() * h;
  const VectorXd& own = slopes.own.at(record);
  dv.segment(slopes.first, own.size()) += own;
  return dv;
}

}  // namespace

template <FrameGroup G>
MotionGradients::MotionGradients(const Design& design, const DesignRun<G>& run, const VectorXd& x,
                                 const std::vector<LimitedResponse>& responses) {
  const auto times = std::make_shared<const std::vector<double>>(run.times());
  const auto records = times->size();
  const Model<G>& model = *run.model;
  Parameters<G> parameters;
  for (const Parameter& p : design.parameters(run.mechanism, x))
    parameters.emplace_back(run.mechanism, model, p);
  const ResponseValues<G> values(run.mechanism, model);
  std::vector<ResponseSensitivity<G>> sensitivities;
  for (const auto& r : responses) {
    sensitivities.emplace_back(model, values, r.response, parameters);
    series_.push_back({r, times, VectorXd::Zero(static_cast<Eigen::Index>(records)), {}});
    if (r.slopes) series_.back().value = r.slopes->value;
  }
  State<G> completed;
  std::size_t record = run.statics ? 1 : 0;  // equilibria: not that without a load
  const auto take = [&](long, const State<G>& s, const StateSensitivity& ds) {
    if (record == records || s.t != (*times)[record]) return;
    completed = s;
    model.complete(completed);
    for (std::size_t r = 0; r < series_.size(); ++r) {
      const int n = static_cast<int>(record);
      if (const PartSlopes* part = responses[r].slopes.get()) {
        if (part->own.contains(n) && part->value[n] > 0)
          series_[r].gradient[n] = part_gradient(model, *part, n, s, ds);
        continue;
      }
      const VectorXd y = values(responses[r].response, completed);
      const double v = y.norm();
      series_[r].value[static_cast<Eigen::Index>(record)] = v;
      const int c = responses[r].constraint;
      if (v > 0 && (c < 0 || v >= responses[r].kept * run.limits[std::size_t(c)].largest))
        series_[r].gradient[n] = sensitivities[r](s, ds).transpose() * y / v;
    }
    ++record;
  };
  const SensitivityEnd end = run.statics ? static_sensitivity<G>(model, run.simulation.trajectory,
                                                                 run.pose_time, parameters, take)
                                         : direct_sensitivity<G>(model, run.tape, parameters, take);
  reason_ = end.reason;
}

void MotionGradients::aggregate(int response, const std::vector<Aggregate>& by) {
  const Series of = at(response);
  auto times = std::make_shared<std::vector<double>>();
  Series& to = series_[static_cast<std::size_t>(response)];
  to.value.resize(static_cast<Eigen::Index>(by.size()));
  to.gradient.clear();
  for (std::size_t k = 0; k < by.size(); ++k) {
    times->push_back((*of.times)[static_cast<std::size_t>(by[k].record)]);
    to.value[static_cast<Eigen::Index>(k)] = by[k].value;
    for (const auto& [record, weight] : by[k].weight) {
      const auto dv = of.gradient.find(record);
      if (dv == of.gradient.end()) continue;
      VectorXd& sum =
          to.gradient.emplace(static_cast<int>(k), VectorXd::Zero(dv->second.size())).first->second;
      sum += weight * dv->second;
    }
  }
  to.times = std::move(times);
}

MotionGradients MotionGradients::split(int first) {
  MotionGradients out;
  out.reason_ = reason_;
  const auto at = series_.begin() + first;
  std::move(at, series_.end(), std::back_inserter(out.series_));
  series_.erase(at, series_.end());
  return out;
}

void MotionGradients::append(MotionGradients other) {
  if (reason_.empty()) reason_ = other.reason_;
  std::move(other.series_.begin(), other.series_.end(), std::back_inserter(series_));
}

const VectorXd* MotionGradients::gradient(int response, int record) const {
  const auto& kept = at(response).gradient;
  const auto found = kept.find(record);
  return found == kept.end() ? nullptr : &found->second;
}

const VectorXd* MotionGradients::nearest_gradient(int response, int record, int* found) const {
  const auto& kept = at(response).gradient;
  if (kept.empty()) return nullptr;
  auto next = kept.lower_bound(record);
  if (next == kept.end() ||
      (next != kept.begin() && next->first - record > record - std::prev(next)->first))
    --next;
  *found = next->first;
  return &next->second;
}

template MotionGradients::MotionGradients(const Design&, const DesignRun<SE2>&, const VectorXd&,
                                          const std::vector<LimitedResponse>&);
template MotionGradients::MotionGradients(const Design&, const DesignRun<SE3>&, const VectorXd&,
                                          const std::vector<LimitedResponse>&);

}  // namespace liesl
