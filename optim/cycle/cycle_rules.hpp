#pragma once
/// @file
/// By which rules a cycle continues or ends, from its history alone.

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "optim/nlp/problem.hpp"
#include "optim/nlp/result.hpp"
#include "optim/problems/cycle_loads.hpp"
#include "optim/problems/limit_excess.hpp"
#include "optim/problems/simulation_effort.hpp"
#include "optim/study/study.hpp"

namespace liesl {

enum class CycleStatus {
  Optimal,           ///< the KKT conditions of the motion hold, limits are met
  Converged,         ///< loads, mass and limits agree with the design; not known to be optimal
  CycleLimit,        ///< as many cycles as allowed
  Oscillating,       ///< the designs go to and fro; the best one is returned
  Infeasible,        ///< a limit cannot be met within the bounds; the reason says which
  SimulationFailed,  ///< no simulation of a design succeeded
  Inaccurate,        ///< Optimal or Converged, but for a motion that cannot be relied on
  Interrupted        ///< the caller asked to stop
};
const char* to_string(CycleStatus status);
/// The status of this word; none: there is none.
std::optional<CycleStatus> cycle_status(const std::string& word);
/// The cycle ended by its own rules, with a design that meets the limits.
inline bool closed(CycleStatus s) {
  return s == CycleStatus::Optimal || s == CycleStatus::Converged;
}

/// One cycle: the design that was simulated and what followed.
struct Cycle : LimitExcesses {
  int number = 0;  ///< from 1 at each start
  int start = 0;   ///< 0: from the start of the study; else that of a restart; above kMostRestarts:
                   ///< a stage of a continuation, of a slower motion but the last (restarts.hpp)
  Eigen::VectorXd x;     ///< simulated design
  double mass = 0;       ///< kg
  double objective = 0;  ///< what is minimised; often the mass
  std::optional<double>
      load_change;                ///< against the cycle before, if its records have the same times
  int load_cases = 0;             ///< retained by the screening
  std::vector<CycleLoads> loads;  ///< of the simulated design, the few that tell most
  int iterations = 0;             ///< of the optimiser
  double move = 0;                ///< move limit of the answer
  Eigen::VectorXd lower, upper;   ///< bounds of the answer, from the move limit and the study
  /// What a change of each variable is measured by; empty: all by the size of the design.
  Eigen::VectorXd unit;
  double seconds = 0;
  Eigen::VectorXd answer;  ///< optimum of the static problem; empty in the last cycle
  Eigen::VectorXd next;    ///< what is simulated next: the answer, accelerated
  bool taken = true;       ///< trust region: the next cycle starts from here
  double penalty = 0;      ///< trust region: of the merit function
  /// Trust region: records of the maxima of all designs taken before, by response.
  std::vector<std::set<int>> maxima;
  /// Trust region: the design before, whose values the surrogate has, too; empty: none.
  Eigen::VectorXd before;
  /// Multipliers that the optimiser starts from: trust region: in this cycle; else in the next one.
  NlpWarmStart warm;
  SimulationEffort effort;  ///< of all simulations so far
  /// How the loop ended here by its own rules; none: it went on, or was stopped.
  std::optional<CycleStatus> end;
};
/// Size of the step from the simulated design to y: |y - x| / |x|, or |(y - x) / unit|.
double step_size(const Cycle& cycle, const Eigen::VectorXd& y);
using History = std::vector<Cycle>;

struct CycleEnd {
  CycleStatus status = CycleStatus::Converged;
  std::string reason;
};

// Ends that the latest simulation shows:

/// Loads and mass changed little since the cycle before, and the limits are met.
std::optional<CycleEnd> agreement(const History& history, const CycleOptions& options);
/// More cycles than `options.max`.
std::optional<CycleEnd> used_up(const History& history, const CycleOptions& options);
/// The last three changes of mass alternate and do not shrink; below the tolerance they may.
bool oscillates(const History& history, const CycleOptions& options);

// Ends that the latest answer shows:

/// The static optimum under the loads of a design is that design: nothing is left to agree on.
std::optional<CycleEnd> fixed_point(const Cycle& cycle, const CycleOptions& options);
/// Nothing moves any more and a limit is still violated.
std::optional<CycleEnd> stuck(const Cycle& cycle, const CycleOptions& options);

/// A variable went as far as it may in one cycle, and not to its own bound.
bool on_move_limit(const Cycle& cycle, const std::vector<NlpVariable>& variables);

/// The design to simulate next: a secant step on x -> G(x), the answer of the static problem
/// (Anderson 1965, depth one), because loads that follow the mass make the plain cycle halve its
/// error only. The plain answer where a move limit cut one off: it says nothing of G.
Eigen::VectorXd next_design(const History& history, const std::vector<NlpVariable>& variables);

}  // namespace liesl
