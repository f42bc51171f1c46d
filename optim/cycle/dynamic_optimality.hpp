#pragma once
/// @file
/// Is a design optimal for the motion itself? The end of an ESL cycle satisfies the optimality
/// conditions of the static problem under its loads; it need not satisfy those of the dynamic one
/// (M. Stolpe, On the equivalent static loads approach for dynamic response structural
/// optimization, Struct. Multidisc. Optim. 50 (2014)).

#include <optional>
#include <string>

#include "optim/nlp/kkt.hpp"
#include "optim/problems/motion_gradients.hpp"

namespace liesl {

/// Largest residual that is called optimal. Unit: see KktResidual.
constexpr double kOptimalResidual = 1e-2;

/// A limit that carries a multiplier: what it costs.
struct LimitPrice {
  std::string name;
  /// -d(objective)/d(limit) limit, unit of the objective: the objective falls by a hundredth of it
  /// if the limit is 1 % wider.
  double price = 0;
};

/// Of a design that exceeds limits: is it a stationary point of the largest violation
/// t = max_i g_i, which no small change reduces? With D the ranges of the variables, over the
/// limits that are exceeded by t, and bounds,
///     r = min |D (sum lambda_i dg_i - zl + zu)|_inf / max_i |D dg_i|_inf,  lambda, zl, zu >= 0,
///     sum lambda_i = 1  (the conditions of: minimise t, g_i <= t).
struct ViolationCertificate {
  double violation = 0;             ///< t
  double residual = 1;              ///< r; 0 = stationary
  std::string worst_variable;       ///< which one should move where it is not
  double worst_slope = 0;           ///< < 0 = it should grow
  std::vector<LimitPrice> held_by;  ///< limits with their lambda_i as prices, largest first

  bool stationary() const;
  std::string brief()
      const;  ///< "a stationary point of the violation (residual 1e-4), held by 'a'"
};

struct DynamicOptimality {
  std::optional<KktResidual> residual;  ///< none if there are no gradients
  std::string reason;                   ///< why there is none
  std::vector<LimitPrice> prices;       ///< of limits, walls and bounds of the part, largest first
  int simulations = 0;                  ///< for differences; 0: by sensitivities
  std::optional<ViolationCertificate> violation;  ///< of a design that exceeds limits

  bool holds() const { return residual && residual->stationarity <= kOptimalResidual; }
  /// "residual 0.71: 'x1' should shrink", or the reason.
  std::string brief() const;
};

inline constexpr double kNearActive = 1e-2;  ///< limits that may carry a multiplier at the end

/// First-order optimality conditions of the dynamic problem
///     minimise mass(x)  subject to  |r_c(t_n; x)| / limit_c - 1 <= 0  at every record n,
///     walls, limits of the parts and bounds
/// at the design x. Each peak over time that is within `active` of its limit is
/// a constraint, with the derivative at its instant between the records; where two records share a
/// peak at a design that is optimal for the records, these are the constraints instead. A response
/// that is the largest over several points is a constraint at each of them.
///
/// @param variables of the design, with the bounds of the study
/// @param motion gradients at x; empty under fixed loads
/// @param statics the static problem at x, for what is not of the motion: the objective, walls,
/// limits of the parts
DynamicOptimality check_optimality(const StudySpec& study,
                                   const std::vector<NlpVariable>& variables,
                                   const Eigen::VectorXd& x, const MotionGradients& motion,
                                   StaticProblem& statics, double active);

/// Whether the design x, whose worst limit is exceeded by `violation`, can be brought nearer.
ViolationCertificate check_violation(const StudySpec& study,
                                     const std::vector<NlpVariable>& variables,
                                     const Eigen::VectorXd& x, const MotionGradients& motion,
                                     StaticProblem& statics, double violation, double active);

/// The conditions of optimality by central differences of whole simulations of one motion, 2 a
/// variable with steps of 1e-3 of it, one-sided at a bound: for motions without sensitivities. Here
/// a response that is the largest over several points counts as one function.
template <FrameGroup G>
DynamicOptimality check_optimality_by_differences(const DesignSimulator<G>& simulator,
                                                  const DesignRun<G>& at, const Eigen::VectorXd& x,
                                                  StaticProblem& statics, double active,
                                                  const Progress& progress = {});

extern template DynamicOptimality check_optimality_by_differences(const DesignSimulator<SE2>&,
                                                                  const DesignRun<SE2>&,
                                                                  const Eigen::VectorXd&,
                                                                  StaticProblem&, double,
                                                                  const Progress&);
extern template DynamicOptimality check_optimality_by_differences(const DesignSimulator<SE3>&,
                                                                  const DesignRun<SE3>&,
                                                                  const Eigen::VectorXd&,
                                                                  StaticProblem&, double,
                                                                  const Progress&);

}  // namespace liesl
