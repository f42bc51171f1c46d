#pragma once
/// @file
/// How a simulation ended: a status with a reason, and what it took.

#include <string>
#include <vector>

namespace liesl {

enum class SolveStatus {
  Converged,
  NotConverged,  ///< Newton's method failed at the smallest step; results until there are kept
  Inconsistent,  ///< the scene cannot be assembled or its start contradicts itself
  Singular,      ///< the equations have no unique solution
  Inaccurate,    ///< the end was reached, but the result cannot be relied on
  Interrupted    ///< the caller asked to stop
};

inline const char* to_string(SolveStatus s) {
  switch (s) {
    case SolveStatus::Converged:
      return "converged";
    case SolveStatus::NotConverged:
      return "not_converged";
    case SolveStatus::Inconsistent:
      return "inconsistent";
    case SolveStatus::Singular:
      return "singular";
    case SolveStatus::Inaccurate:
      return "inaccurate";
    case SolveStatus::Interrupted:
      return "interrupted";
  }
  return "";
}

/// What penalties leave open, of the accepted steps.
struct PenaltyReport {
  bool used = false;
  double displacement = 0, rotation = 0;  ///< weights, N/m and N m
  std::string joint;                      ///< that opens by the largest share
  double opening = 0;          ///< its largest |Phi|, m; angles times the length of the mechanism
  double deformation = 0;      ///< farthest of a node beside the middle one of its body, m
  bool rigid = false;          ///< nothing can deform: `share` is that of the mechanism's length
  double share = 0;            ///< opening / deformation
  long augmentations = 0;      ///< of all steps
  int most_augmentations = 0;  ///< of a step
};

struct Report {
  SolveStatus status = SolveStatus::Converged;
  std::string reason;          ///< one sentence, with time and place
  long steps = 0;              ///< accepted steps, load steps
  long newton_iterations = 0;  ///< corrections
  long tangent_refreshes = 0;
  long tangent_renewals = 0;  ///< of these, what only saved corrections
  long rejected_steps = 0;    ///< attempts that did not converge
  long refused_steps = 0;     ///< attempts that adaptive steps took again because of their error
  long inexact_steps = 0;    ///< adaptive ones that kept a larger error, for want of a smaller step
  double smallest_step = 0;  ///< that was tried, s
  std::vector<int> factorizations;  ///< one a body
  double stepping_s = 0;            ///< wall time of the stepping alone
  /// The same of all processors of this process; dynamics without an observer, else 0.
  double stepping_cpu_s = 0;
  double max_constraint_residual = 0;  ///< largest |Phi| at an accepted step, m or rad
  PenaltyReport penalty;
  std::vector<std::string> warnings;
};

}  // namespace liesl
