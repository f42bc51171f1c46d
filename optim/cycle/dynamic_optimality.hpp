#pragma once
/// @file
/// Is a design optimal for the motion itself? The end of an ESL cycle satisfies the optimality
/// conditions of the static problem under its loads; it need not satisfy those of the dynamic one
/// (M. Stolpe, On the equivalent static loads approach for dynamic response structural
/// optimization, Struct. Multidisc. Optim. 50 (2014)).

#include <optional>
#include <string>

#include "optim/cycle/design_run.hpp"
#include "optim/nlp/kkt.hpp"

namespace liesl {

/// Largest residual that is called optimal. Unit: see KktResidual; 0.37 at the end of the cycle of
/// data/studies/slider_crank_rod.toml goes with a mass 1.1 % above that of the best rod.
constexpr double kOptimalResidual = 0.05;

struct DynamicOptimality {
  std::optional<KktResidual> residual;  ///< none if a neighbouring design gives no answer
  std::string reason;                   ///< why there is none
  int simulations = 0;

  bool holds() const { return residual && residual->stationarity <= kOptimalResidual; }
  /// "residual 0.71: 'x1' should shrink", or the reason.
  std::string brief() const;
};

/// First-order optimality conditions of the dynamic problem
///     minimise mass(x)  subject to  |r_c(t_n; x)| / limit_c - 1 <= 0  at every record n
/// at the design x, whose run is `at`. Each peak over time that is within `active` of its limit is
/// a constraint; at a peak the derivative of the largest value is that at its instant. Gradients
/// are central differences of whole simulations, 2 a variable with steps of 1e-3 of it, one-sided
/// at a bound. A response that is the largest over several points counts as one function.
template <FrameGroup G>
DynamicOptimality check_optimality(const DesignSimulator<G>& simulator, const DesignRun<G>& at,
                                   const Eigen::VectorXd& x, double active,
                                   const Progress& progress = {});

extern template DynamicOptimality check_optimality(const DesignSimulator<SE2>&,
                                                   const DesignRun<SE2>&, const Eigen::VectorXd&,
                                                   double, const Progress&);
extern template DynamicOptimality check_optimality(const DesignSimulator<SE3>&,
                                                   const DesignRun<SE3>&, const Eigen::VectorXd&,
                                                   double, const Progress&);

}  // namespace liesl
