#include "optim/problems/motion_gradients.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/linalg/stop_request.hpp"

namespace liesl {

using Eigen::VectorXd;

namespace {

/// dv/dx of the stress or compliance of a meshed part at a record that has slopes.
template <FrameGroup G>
VectorXd part_gradient(const Model<G>& model, const PartSlopes& slopes, int record,
                       const State<G>& s, const StateSensitivity& ds) {
  const SolidBody<G>& body =
      *SolidBody<G>::of(*model.bodies[static_cast<std::size_t>(slopes.body)]);
  VectorXd h = VectorXd::Zero(body.size());
  body.add_coordinates_gradient(model.body_state(s, slopes.body), slopes.by_coordinates.at(record),
                                h.data());
  VectorXd dv =
      ds.eta.middleRows(G::dim * model.first_node(slopes.body), body.size()).transpose() * h;
  const VectorXd& own = slopes.own.at(record);
  dv.segment(slopes.first, own.size()) += own;
  return dv;
}

/// Below as many parameters the direct form is taken unasked.
constexpr std::size_t kFew = 6;

/// A value whose gradient is wanted: a functional of the adjoint form.
struct Wanted {
  int response = 0, record = 0;
  VectorXd weight;  ///< dv/dy = y/v
};

/// Local maxima of at least `least` with the records beside them, for the parabola through them.
std::set<int> about_maxima(const VectorXd& v, double least) {
  std::set<int> out;
  const int size = static_cast<int>(v.size());
  for (int n = 0; n < size; ++n) {
    if (v[n] < least || (n > 0 && v[n] < v[n - 1]) || (n + 1 < size && v[n] <= v[n + 1])) continue;
    for (int k = std::max(0, n - 1); k <= std::min(size - 1, n + 1); ++k) out.insert(k);
  }
  return out;
}

template <FrameGroup G>
Parameters<G> parameters_of(const Design& design, const DesignRun<G>& run, const VectorXd& x) {
  Parameters<G> parameters;
  for (const Parameter& p : design.parameters(run.mechanism, x))
    parameters.emplace_back(run.mechanism, *run.model, p);
  return parameters;
}

}  // namespace

template <FrameGroup G>
MotionGradients::MotionGradients(const Design& design, const DesignRun<G>& run, const VectorXd& x,
                                 const std::vector<LimitedResponse>& responses) {
  const auto times = std::make_shared<const std::vector<double>>(run.times());
  const Parameters<G> parameters = parameters_of(design, run, x);
  const ResponseValues<G> values(run.mechanism, *run.model);
  for (const auto& r : responses)
    series_.push_back({r, times, VectorXd::Zero(static_cast<Eigen::Index>(times->size())), {}});
  if (run.statics || parameters.size() < kFew || !differentiate_maxima(run, values, parameters))
    differentiate(run, values, parameters);
}

template <FrameGroup G>
void MotionGradients::require(const Design& design, const DesignRun<G>& run, const VectorXd& x,
                              const std::vector<LimitedResponse>& responses) {
  const Parameters<G> parameters = parameters_of(design, run, x);
  const ResponseValues<G> values(run.mechanism, *run.model);
  for (const auto& r : responses)
    ResponseSensitivity<G>(*run.model, values, r.response, parameters);
  require_sensitivities(*run.model, run.tape, parameters);
}

template <FrameGroup G>
double MotionGradients::least_kept(const DesignRun<G>& run, const LimitedResponse& of) const {
  return of.constraint < 0 ? 0 : of.kept * run.limits[std::size_t(of.constraint)].largest;
}

/// By the direct form, all values at once.
template <FrameGroup G>
void MotionGradients::differentiate(const DesignRun<G>& run, const ResponseValues<G>& values,
                                    const Parameters<G>& parameters) {
  const Model<G>& model = *run.model;
  const std::vector<double> times = run.times();
  std::vector<ResponseSensitivity<G>> sensitivities;
  for (Series& s : series_) {
    sensitivities.emplace_back(model, values, s.response.response, parameters);
    if (s.response.slopes) s.value = s.response.slopes->value;
  }
  State<G> completed;
  std::size_t record = run.statics ? 1 : 0;  // equilibria: not that without a load
  const auto take = [&](long, const State<G>& s, const StateSensitivity& ds) {
    look_for_stop();
    if (record == times.size() || s.t != times[record]) return;
    completed = s;
    model.complete(completed);
    for (std::size_t r = 0; r < series_.size(); ++r) {
      const LimitedResponse& of = series_[r].response;
      const int n = static_cast<int>(record);
      if (const PartSlopes* part = of.slopes.get()) {
        if (part->own.contains(n) && part->value[n] > 0)
          series_[r].gradient[n] = part_gradient(model, *part, n, s, ds);
        continue;
      }
      const VectorXd y = values(of.response, completed);
      const double v = y.norm();
      series_[r].value[n] = v;
      if (v > 0 && v >= least_kept(run, of))
        series_[r].gradient[n] = sensitivities[r](s, ds).transpose() * y / v;
    }
    ++record;
  };
  const SensitivityEnd end = run.statics ? static_sensitivity<G>(model, run.simulation.trajectory,
                                                                 run.pose_time, parameters, take)
                                         : direct_sensitivity<G>(model, run.tape, parameters, take);
  reason_ = end.reason;
}

/// By the adjoint form the maxima only, where that takes less time. @returns whether it does
template <FrameGroup G>
bool MotionGradients::differentiate_maxima(const DesignRun<G>& run, const ResponseValues<G>& values,
                                           const Parameters<G>& parameters) {
  for (const Series& of : series_)
    if (of.response.kept == 0 || of.response.slopes) return false;  // every record
  const Model<G>& model = *run.model;
  const auto& trajectory = run.simulation.trajectory;
  std::vector<std::vector<VectorXd>> y(series_.size());
  State<G> s = model.initial_state();
  for (int n = 0; n < trajectory.size(); ++n) {
    look_for_stop();
    trajectory.read(n, s);
    for (std::size_t r = 0; r < series_.size(); ++r) {
      y[r].push_back(values(series_[r].response.response, s));
      series_[r].value[n] = y[r].back().norm();
    }
  }
  std::vector<Wanted> wanted;
  std::multimap<double, int> at;  // numbers in `wanted`, by time
  for (std::size_t r = 0; r < series_.size(); ++r) {
    const LimitedResponse& of = series_[r].response;
    const VectorXd& v = series_[r].value;
    std::set<int> records = about_maxima(v, least_kept(run, of));
    if (of.treatment != Treatment::Auto)
      records.merge(treated_records(of.treatment, {v.data(), v.data() + v.size()}));
    for (const int n : records) {
      if (!(v[n] > 0)) continue;
      at.emplace(trajectory.time(n), static_cast<int>(wanted.size()));
      wanted.push_back({static_cast<int>(r), n, y[r][std::size_t(n)] / v[n]});
    }
  }
  const int functionals = static_cast<int>(wanted.size());
  if (!adjoint_is_faster(static_cast<int>(parameters.size()), functionals)) return false;
  by_adjoint_ = true;
  std::vector<ResponseSensitivity<G>> sensitivities;
  for (const Series& of : series_)
    sensitivities.emplace_back(model, values, of.response.response, parameters);
  Eigen::MatrixXd gradient;
  const SensitivityEnd end = adjoint_sensitivity<G>(
      model, run.tape, parameters, functionals,
      [&](long, const State<G>& now, StateSensitivity& bars, Eigen::MatrixXd& by_p) {
        look_for_stop();
        const auto [first, last] = at.equal_range(now.t);
        for (auto k = first; k != last; ++k) {
          const Wanted& w = wanted[static_cast<std::size_t>(k->second)];
          sensitivities[static_cast<std::size_t>(w.response)].add_cotangents(now, w.weight,
                                                                             k->second, bars, by_p);
        }
      },
      gradient);
  reason_ = end.reason;
  for (int k = 0; k < functionals; ++k) {
    const Wanted& w = wanted[static_cast<std::size_t>(k)];
    series_[static_cast<std::size_t>(w.response)].gradient[w.record] = gradient.col(k);
  }
  return true;
}

void MotionGradients::aggregate(int response, const std::vector<Aggregate>& by) {
  const Series of = at(response);
  auto times = std::make_shared<std::vector<double>>();
  Series& to = series_[static_cast<std::size_t>(response)];
  to.value.resize(static_cast<Eigen::Index>(by.size()));
  to.gradient.clear();
  to.by_limit.clear();
  for (std::size_t k = 0; k < by.size(); ++k) {
    times->push_back((*of.times)[static_cast<std::size_t>(by[k].record)]);
    to.value[static_cast<Eigen::Index>(k)] = by[k].value;
    to.by_limit.push_back(by[k].by_limit);
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
  out.by_adjoint_ = by_adjoint_;
  const auto at = series_.begin() + first;
  std::move(at, series_.end(), std::back_inserter(out.series_));
  series_.erase(at, series_.end());
  return out;
}

void MotionGradients::append(MotionGradients other) {
  if (reason_.empty()) reason_ = other.reason_;
  by_adjoint_ = by_adjoint_ || other.by_adjoint_;
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

template void MotionGradients::require(const Design&, const DesignRun<SE2>&, const VectorXd&,
                                       const std::vector<LimitedResponse>&);
template void MotionGradients::require(const Design&, const DesignRun<SE3>&, const VectorXd&,
                                       const std::vector<LimitedResponse>&);
template MotionGradients::MotionGradients(const Design&, const DesignRun<SE2>&, const VectorXd&,
                                          const std::vector<LimitedResponse>&);
template MotionGradients::MotionGradients(const Design&, const DesignRun<SE3>&, const VectorXd&,
                                          const std::vector<LimitedResponse>&);

}  // namespace liesl
