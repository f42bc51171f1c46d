#pragma once
/// @file
/// From solver to writers: the states of a simulation as plain numbers in space.

#include "apps/output/results.hpp"
#include "apps/scene/scene.hpp"
#include "mbs/solvers/simulation.hpp"
#include "mbs/system/penalty.hpp"
#include "mbs/system/response_value.hpp"
#include "mbs/system/vertex.hpp"

namespace liesl {

/// Responses and energies of the states of a simulation, one after another: series over the
/// records, what is largest and the work of all forces over every step shown (Observer). What it is
/// made of outlives it.
template <FrameGroup G>
class StepRecorder {
 public:
  StepRecorder(const Scene& scene, const Mechanism& mechanism, const Model<G>& model);
  /// @param s completed
  void operator()(const State<G>& s, bool recorded);
  bool empty() const { return states_ == 0; }
  const std::vector<output::ResponseResult>& responses() const { return responses_; }
  const output::Energies& energies() const { return energies_; }

 private:
  /// Sizes of a response at the last two steps, and the highest vertex of the peaks so far.
  struct Peaks {
    Sample before, last;
    double vertex = 0;
  };
  void add_responses(const State<G>& s, bool recorded);
  /// @returns whether it is the largest so far
  bool add_to_peak(output::ResponseResult& out, Peaks& peaks, const Sample& now) const;
  void add_work_of_gravity(const State<G>& s);
  void add_energies(const State<G>& s, bool recorded);

  const Model<G>& model_;
  const std::vector<ResponseSpec>& specs_;
  const bool dynamic_;
  ResponseValues<G> values_;
  Equations<G> equations_;
  PenaltyWork<G> of_penalties_;
  long states_ = 0;
  double start_ = 0, work_ = 0, t_before_ = 0, power_before_ = 0;
  double scale_before_ = 1, weight_before_ = 0;
  std::vector<output::ResponseResult> responses_;
  std::vector<Peaks> peaks_;  ///< by response
  const double crossing_;     ///< m size^2/2 of all of it, kg m^2
  output::Energies energies_;
};

/// Everything that results.h5 and the tables hold of a simulation.
/// @param seen what an observer saw of every step; null or empty: the records are all there is
/// @param sink takes the series of bodies, of which the results keep few records; null: they keep
/// all
template <FrameGroup G>
output::Results collect(const Scene& scene, const Mechanism& mechanism, const Model<G>& model,
                        const Trajectory<G>& trajectory, const StepRecorder<G>* seen = nullptr,
                        output::BodySink* sink = nullptr);

/// Only the named responses, over the records.
template <FrameGroup G>
std::vector<output::ResponseResult> collect_responses(const std::vector<ResponseSpec>& responses,
                                                      const Mechanism& mechanism,
                                                      const Model<G>& model,
                                                      const Trajectory<G>& trajectory);

extern template class StepRecorder<SE2>;
extern template class StepRecorder<SE3>;
extern template output::Results collect(const Scene&, const Mechanism&, const Model<SE2>&,
                                        const Trajectory<SE2>&, const StepRecorder<SE2>*,
                                        output::BodySink*);
extern template output::Results collect(const Scene&, const Mechanism&, const Model<SE3>&,
                                        const Trajectory<SE3>&, const StepRecorder<SE3>*,
                                        output::BodySink*);
extern template std::vector<output::ResponseResult> collect_responses(
    const std::vector<ResponseSpec>&, const Mechanism&, const Model<SE2>&, const Trajectory<SE2>&);
extern template std::vector<output::ResponseResult> collect_responses(
    const std::vector<ResponseSpec>&, const Mechanism&, const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
