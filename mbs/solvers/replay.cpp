#include "mbs/solvers/replay.hpp"

#include <stdexcept>

namespace liesl {

template <FrameGroup G>
Replay<G>::Replay(const Model<G>& model, const Tape<G>& tape)
    : tape_(tape), integrator_(model, tape.options) {}

template <FrameGroup G>
void Replay<G>::run(int i, const Step& step) {
  const Checkpoint<G>& from = tape_.checkpoints[static_cast<size_t>(i)];
  const size_t end = i + 1 < stretches() ? tape_.checkpoints[static_cast<size_t>(i) + 1].attempt
                                         : tape_.attempts.size();
  integrator_.restore(from.memory);
  State<G> before = from.s, after = from.s;
  for (size_t k = from.attempt; k < end; ++k) {
    const Attempt& attempt = tape_.attempts[k];
    const bool converged = integrator_.step(after, attempt.h).converged;
    if (converged != attempt.accepted)
      throw std::logic_error("a replay left its tape: the model has changed since");
    if (!converged) continue;
    after.t = attempt.t;
    step(before, after, attempt.h);
    before = after;
  }
}

template class Replay<SE2>;
template class Replay<SE3>;

}  // namespace liesl
