#include "apps/tasks/motion_recorder.hpp"

#include <utility>

#include "apps/output/memory_limit.hpp"

namespace liesl {

template <FrameGroup G>
MotionRecorder<G>::MotionRecorder(const Scene& scene, const Model<G>& model, output::BodySink* sink)
    : scene_(scene), model_(model), sink_(sink), steps_(scene, scene.mechanism, model) {
  if (sink && scene.simulation.type == SimulationType::Dynamic && !output::memory_is_limited())
    begin(recorded_states(scene.simulation));
}

template <FrameGroup G>
void MotionRecorder<G>::begin(int records) {
  results_ = empty_results<G>(scene_, scene_.mechanism);
  series_.emplace(scene_.mechanism, model_, static_cast<std::size_t>(records), sink_, results_);
}

template <FrameGroup G>
void MotionRecorder<G>::operator()(const State<G>& s, bool recorded) {
  steps_(s, recorded);
  if (recorded && series_) series_->add_beside(s);
}

template <FrameGroup G>
output::Results MotionRecorder<G>::results(const Trajectory<G>& trajectory) {
  const bool added = series_ && series_->whole();
  if (!added) {
    if (series_) {
      series_.reset();
      sink_->restart();
    }
    begin(trajectory.size());
  }
  collect_records(scene_, scene_.mechanism, model_, trajectory, &steps_, *series_, added, results_);
  return std::move(results_);
}

template class MotionRecorder<SE2>;
template class MotionRecorder<SE3>;

}  // namespace liesl
