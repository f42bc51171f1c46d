#pragma once
/// @file
/// What a run records of its simulation, most of it while that goes on.

#include <optional>

#include "apps/tasks/collect.hpp"

namespace liesl {

/// Observes a simulation and gives its results. The series of the bodies of a motion are made
/// beside its steps; after it, of the records that there are, if it does not reach its end, or
/// where memory is limited. What it is made of outlives it.
template <FrameGroup G>
class MotionRecorder {
 public:
  /// @param sink takes the series, of which the results keep few records; null: they keep all
  MotionRecorder(const Scene& scene, const Model<G>& model, output::BodySink* sink);
  /// The next state. @param s completed  @throws what the sink throws
  void operator()(const State<G>& s, bool recorded);
  /// Once, after the last. @throws what the sink throws
  output::Results results(const Trajectory<G>& trajectory);

 private:
  void begin(int records);

  const Scene& scene_;
  const Model<G>& model_;
  output::BodySink* const sink_;
  StepRecorder<G> steps_;
  output::Results results_;
  std::optional<BodySeries<G>> series_;  ///< of results_
};

extern template class MotionRecorder<SE2>;
extern template class MotionRecorder<SE3>;

}  // namespace liesl
