#include "optim/cycle/restarts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace liesl {
namespace {

constexpr double kShares[kMostRestarts] = {0.9, 0.5, 0.1, 0.7, 0.3};
constexpr double kSlowest = 0.9;  // share of the speed that a continuation begins at

/// An entry starts at the next numbers of x.
void take_start(DesignSpec& d, const Eigen::VectorXd& x, Eigen::Index& j) {
  d.start.clear();
  for (int g = 0; g < d.groups; ++g) d.start.push_back(x[j++]);
}
template <class Entry>
void take_start(Entry& v, const Eigen::VectorXd& x, Eigen::Index& j) {
  v.start = x[j++];
}

bool of_the_motion(const ConstantSpec& c) { return sets_motion(c); }
template <class Entry>
bool of_the_motion(const Entry&) {
  return false;
}

}  // namespace

StudySpec starting_at(StudySpec study, const Eigen::VectorXd& x) {
  Eigen::Index j = 0;
  each_entry(study, [&](auto& entry) { take_start(entry, x, j); });
  return study;
}

std::optional<StudySpec> restarted(const StudySpec& study,
                                   const std::vector<NlpVariable>& variables, int number) {
  const auto n = static_cast<Eigen::Index>(variables.size());
  std::vector<bool> stays;
  each_entry(study, [&stays](const auto& entry) {
    stays.insert(stays.end(), static_cast<std::size_t>(variables_of(entry)), of_the_motion(entry));
  });
  Eigen::VectorXd x(n);
  bool elsewhere = false;
  for (Eigen::Index j = 0; j < n; ++j) {
    const NlpVariable& v = variables[static_cast<std::size_t>(j)];
    x[j] = v.start;
    if (stays[static_cast<std::size_t>(j)]) continue;
    x[j] = v.lower + kShares[number - 1] * (v.upper - v.lower);
    elsewhere = elsewhere || x[j] != v.start;
  }
  if (!elsewhere) return {};
  return starting_at(study, x);
}

double stage_speed(int stage, int stages) { return kSlowest + (1 - kSlowest) * stage / stages; }

namespace detail {

CycleHooks StartHistory::hooks(int start, const std::string& of) const {
  CycleHooks out = hooks_;
  out.of = of + out.of;
  if (!hooks_.on_cycle) return out;
  out.on_cycle = [this, start](const std::vector<Cycle>& cycles) {
    std::vector<Cycle> so_far = all_;
    for (Cycle c : cycles) {
      c.start = start;
      so_far.push_back(std::move(c));
    }
    std::copy_if(resume_.begin(), resume_.end(), std::back_inserter(so_far),
                 [start](const Cycle& c) { return c.start > start; });
    hooks_.on_cycle(so_far);
  };
  return out;
}

std::vector<Cycle> StartHistory::resume(int start) const {
  std::vector<Cycle> out;
  std::copy_if(resume_.begin(), resume_.end(), std::back_inserter(out),
               [start](const Cycle& c) { return c.start == start; });
  return out;
}

void StartHistory::add(int start, std::vector<Cycle> cycles) {
  for (Cycle& c : cycles) {
    c.start = start;
    all_.push_back(std::move(c));
  }
}

std::string restart_name(int number) { return fmt::format(" of restart {}", number); }

std::string stage_name(double speed) { return fmt::format(" at {:.3g} of the speed", speed); }

std::string restart_note(int number, const std::string& why) {
  return fmt::format(
      "the study began again with every variable at {:g} of its range, since it had ended "
      "infeasible: {}",
      kShares[number - 1], why);
}

std::string failed_restart_note(int number, const std::string& why) {
  return fmt::format("a start with every variable at {:g} of its range was left out: {}",
                     kShares[number - 1], why);
}

std::string continuation_note(int stages, const std::string& why) {
  return fmt::format(
      "the optimum of the motion at {:g} of its speed was followed to full speed in {} stage{}, "
      "since the study had ended infeasible: {}",
      kSlowest, stages, stages > 1 ? "s" : "", why);
}

std::string failed_stage_note(double speed, const std::string& why) {
  return fmt::format("the continuation ended at {:.3g} of the speed: {}", speed, why);
}

bool replaces(const LoopResult& next, const LoopResult& best) {
  return next.best && (!best.best || next.best->worst < best.best->worst);
}

std::string on_restarts(const CycleOptions& options, int tried, bool has_speed) {
  std::string text =
      tried > 0 ? fmt::format("; {} other start{} came no nearer", tried, tried > 1 ? "s" : "")
      : options.restarts > 0 ? "; there is no other start"
                             : "; cycle.restarts = 3 begins again from other designs";
  if (!has_speed) return text;
  return text + (options.continuation > 0
                     ? "; a continuation in the speed came no nearer"
                     : "; cycle.continuation = 8 follows the optimum of slower motions");
}

}  // namespace detail
}  // namespace liesl
