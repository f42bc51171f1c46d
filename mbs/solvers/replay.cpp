#include "mbs/solvers/replay.hpp"

#include <stdexcept>

namespace liesl {

namespace {

/// The accepted one of attempts if it is the only one, and the last: the state after it is on the
/// tape.
const Attempt* only_accepted(const std::vector<Attempt>& attempts, size_t first, size_t end) {
  if (first == end || !attempts[end - 1].accepted) return nullptr;
  for (size_t k = first; k + 1 < end; ++k)
    if (attempts[k].accepted) return nullptr;
  return &attempts[end - 1];
}

}  // namespace

template <FrameGroup G>
Replay<G>::Replay(const Model<G>& model, const Tape<G>& tape)
    : tape_(tape), integrator_(model, tape.options) {}

template <FrameGroup G>
void Replay<G>::run(int i, const Step& step) {
  const Checkpoint<G>& from = tape_.checkpoints[static_cast<size_t>(i)];
  const bool last = i + 1 == stretches();
  const size_t end =
      last ? tape_.attempts.size() : tape_.checkpoints[static_cast<size_t>(i) + 1].attempt;
  if (const Attempt* only = only_accepted(tape_.attempts, from.attempt, end)) {
    step(from.s, last ? tape_.end : tape_.checkpoints[static_cast<size_t>(i) + 1].s, only->h);
    return;
  }
  integrator_.restore(from.memory);
  State<G> before = from.s, after = from.s;
  for (size_t k = from.attempt; k < end; ++k) {
    const Attempt& attempt = tape_.attempts[k];
    const bool accepted = integrator_.step(after, attempt.h, attempt.error_limit).accepted;
    if (accepted != attempt.accepted)
      throw std::logic_error("a replay left its tape: the model has changed since");
    if (!accepted) continue;
    after.t = attempt.t;
    step(before, after, attempt.h);
    before = after;
  }
}

template class Replay<SE2>;
template class Replay<SE3>;

}  // namespace liesl
