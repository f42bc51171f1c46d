#include "mbs/solvers/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace liesl {
namespace {

constexpr long kMost = 1L << 40;   // ticks of a whole step
constexpr int kGrowAfter = 4;      // good steps before a halved one grows
constexpr double kOrder = 3;       // of the local error
constexpr double kSafety = 0.9;    // of the size that the error allows
constexpr double kShrink = 0.2;    // of the size, at most
constexpr double kGrow = 5;        // times the size, at most
constexpr double kKeep = 0.95;     // the size stays, if more of it than this is wanted
constexpr double kIntegral = 0.7;  // exponents of e_n, e_(n-1), over the order
constexpr double kProportional = 0.4;
constexpr double kLeastError = 1e-4;  // of the limit, that counts

}  // namespace

StepControl::StepControl(const SimulationOptions& o, double error_limit)
    : adaptive_(o.adaptive), step_(o.step), limit_(error_limit) {
  const double least = (o.step_min > 0 ? o.step_min : o.step / 1024) * (1 - 1e-12);
  if (adaptive_ && step_ / 3 >= least) all_ = 3;
  while (all_ < kMost && step_ / static_cast<double>(2 * all_) >= least) all_ *= 2;
  ticks_ = all_;
  wanted_ = static_cast<double>(all_);
}

double StepControl::size(long ticks) const {
  return step_ * (static_cast<double>(ticks) / static_cast<double>(all_));
}

double StepControl::time() const {
  const double part = static_cast<double>(done_) / static_cast<double>(all_);
  return step_ * (static_cast<double>(whole_) + part);
}

double StepControl::error_limit() const {
  return adaptive_ && ticks_ > 1 ? limit_ : std::numeric_limits<double>::infinity();
}

/// The largest size of at most so many ticks of which the rest is a multiple.
long StepControl::largest(double ticks) const {
  const long rest = all_ - done_;
  long found = 1;
  for (const long base : {1L, 3L}) {
    if (base > 1 && !adaptive_) break;
    for (long n = base; n <= rest && static_cast<double>(n) <= ticks; n *= 2)
      if (rest % n == 0) found = std::max(found, n);
  }
  return found;
}

bool StepControl::retry(const StepResult& attempt) {
  if (ticks_ == 1) return false;
  const double fits =
      attempt.converged ? kSafety * std::pow(attempt.error / limit_, -1 / kOrder) : 0.5;
  wanted_ = std::max(kShrink, fits) * static_cast<double>(ticks_);
  ticks_ = largest(wanted_);
  wait_ = attempt.converged ? std::max(wait_, 1) : kGrowAfter;
  before_ = 1;
  return true;
}

/// What the controller wants next, after a step of `ticks_` with that error.
void StepControl::want(double error) {
  const double now = static_cast<double>(ticks_);
  const double e = std::max(error / limit_, kLeastError) * std::pow(wanted_ / (kSafety * now), 3);
  wanted_ *= std::pow(e, -kIntegral / kOrder) * std::pow(before_, kProportional / kOrder);
  wanted_ = std::clamp(wanted_, kShrink * now, kGrow * now);
  wanted_ = std::min(wanted_, static_cast<double>(all_));
  before_ = e;
}

void StepControl::advance(double error) {
  done_ += ticks_;
  if (done_ == all_) {
    ++whole_;
    done_ = 0;
  }
  if (wait_ > 0) --wait_;
  const long last = ticks_;
  const double now = static_cast<double>(last);
  if (adaptive_)
    want(error);
  else
    wanted_ = 2 * now;
  if (wait_ > 0) wanted_ = std::min(wanted_, now);
  ticks_ = largest(wanted_ > kKeep * now ? std::max(wanted_, now) : wanted_);
  if (!adaptive_ && ticks_ > last) wait_ = kGrowAfter;
}

}  // namespace liesl
