#pragma once
/// @file
/// A simulation that can be run again, bit for bit, from any of its checkpoints.

#include <functional>

#include "mbs/solvers/generalized_alpha.hpp"
#include "mbs/solvers/initial_state.hpp"

namespace liesl {

/// One attempt at a step. Failed and refused ones belong to the history: they may leave another
/// tangent.
struct Attempt {
  double h;            ///< s
  double t;            ///< time reached, s
  double error_limit;  ///< largest error with which it would have been accepted, m
  bool accepted;
};

/// Between two steps: all that the next ones depend on.
template <FrameGroup G>
struct Checkpoint {
  size_t attempt;  ///< index of the next one
  State<G> s;
  StepMemory<G> memory;
};

/// What simulate() writes down for a replay. Memory: a state a checkpoint, 32 bytes an attempt.
template <FrameGroup G>
struct Tape {
  /// Accepted steps between two checkpoints; 0 = 1 where all states take no more than 64 MB, and a
  /// replay has nothing to solve then; else the square root of their number.
  int every = 0;
  SimulationOptions options;  ///< as they were used
  InitialState start;
  std::vector<Attempt> attempts;
  std::vector<Checkpoint<G>> checkpoints;  ///< the first at the start
  State<G> end;                            ///< the last state

  long steps() const {
    long n = 0;
    for (const auto& a : attempts) n += a.accepted;
    return n;
  }
};

/// Runs stretches of a tape again. @pre the model is that of the tape, with the same parameters
template <FrameGroup G>
class Replay {
 public:
  /// The states before and after an accepted step, and its size.
  using Step = std::function<void(const State<G>& before, const State<G>& after, double h)>;

  Replay(const Model<G>& model, const Tape<G>& tape);

  int stretches() const { return static_cast<int>(tape_.checkpoints.size()); }
  /// All accepted steps from checkpoint i to the next one, or to the end.
  void run(int i, const Step& step);

 private:
  const Tape<G>& tape_;
  GeneralizedAlpha<G> integrator_;
};

extern template class Replay<SE2>;
extern template class Replay<SE3>;

}  // namespace liesl
