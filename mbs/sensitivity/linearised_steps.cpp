#include "mbs/sensitivity/linearised_steps.hpp"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <atomic>

namespace liesl {
namespace {

constexpr size_t kLanes = 3;    // linearised, solved, and one that waits
constexpr int kLargeStep = 40;  // unknowns and multipliers; smaller ones one after the other

}  // namespace

template <FrameGroup G>
LinearisedSteps<G>::LinearisedSteps(const Model<G>& model, double rho_inf) {
  const size_t lanes = model.size() + model.constraints() < kLargeStep ? 1 : kLanes;
  while (lanes_.size() < lanes)
    lanes_.push_back(std::make_unique<StepSensitivity<G>>(model, rho_inf));
}

template <FrameGroup G>
SensitivityEnd LinearisedSteps<G>::linearise(const Steps<G>& steps, size_t k,
                                             StepSensitivity<G>& lane) const {
  const State<G>& after = steps.states[k + 1];
  if (lane.step(steps.states[k], after, steps.h[k])) return {};
  return {fmt::format("the equations of the step to t = {:.6g} s are singular", after.t)};
}

template <FrameGroup G>
SensitivityEnd LinearisedSteps<G>::solve(const Steps<G>& steps, size_t k, StepSensitivity<G>& lane,
                                         const Take& take) const {
  if (take(lane, k)) return {};
  return {fmt::format("the equations of the step to t = {:.6g} s have no finite solution",
                      steps.states[k + 1].t)};
}

namespace {

/// first(i) for i < count in parallel, `lanes` at a time, and then(i) one after the other.
template <class First, class Then>
void in_order(size_t count, size_t lanes, const First& first, const Then& then,
              const std::atomic<bool>& stop) {
  using tbb::filter_mode;
  size_t next = 0;
  const auto number = [&](tbb::flow_control& flow) {
    if (next == count || stop) flow.stop();
    return next == count ? next : next++;
  };
  const auto side_by_side = [&](size_t i) {
    first(i);
    return i;
  };
  tbb::parallel_pipeline(lanes,
                         tbb::make_filter<void, size_t>(filter_mode::serial_in_order, number) &
                             tbb::make_filter<size_t, size_t>(filter_mode::parallel, side_by_side) &
                             tbb::make_filter<size_t, void>(filter_mode::serial_in_order, then));
}

}  // namespace

template <FrameGroup G>
SensitivityEnd LinearisedSteps<G>::run(const Steps<G>& steps, bool backwards, const Take& take) {
  const size_t count = steps.h.size();
  const auto step_of = [&](size_t i) { return backwards ? count - 1 - i : i; };
  const auto lane_of = [&](size_t i) -> size_t { return (done_ + i) % lanes_.size(); };
  std::vector<SensitivityEnd> linearised(lanes_.size());
  SensitivityEnd end;
  std::atomic<bool> stop = false;
  const auto first = [&](size_t i) {
    linearised[lane_of(i)] = linearise(steps, step_of(i), *lanes_[lane_of(i)]);
  };
  const auto then = [&](size_t i) {
    if (stop) return;
    end = linearised[lane_of(i)];
    if (end.complete()) end = solve(steps, step_of(i), *lanes_[lane_of(i)], take);
    stop = !end.complete();
  };
  if (lanes_.size() == 1 || tbb::this_task_arena::max_concurrency() == 1) {
    for (size_t i = 0; i < count && !stop; ++i) first(i), then(i);
  } else {
    in_order(count, lanes_.size(), first, then, stop);
  }
  done_ += count;
  return end;
}

template class LinearisedSteps<SE2>;
template class LinearisedSteps<SE3>;

}  // namespace liesl
