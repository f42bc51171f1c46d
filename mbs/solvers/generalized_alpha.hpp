#pragma once
/// @file
/// One step of the Lie-group generalized-alpha method, index 3 (Brüls, Cardona, Arnold 2012,
/// "Lie group generalized-alpha time integration of constrained flexible multibody systems",
/// Mech. Mach. Theory 48).

#include <limits>
#include <string>

#include "mbs/solvers/joint_system.hpp"
#include "mbs/solvers/node_coordinates.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

/// Coefficients from the spectral radius at infinity (thesis eq. 2.15).
struct AlphaWeights {
  double alpha_m, alpha_f, gamma, beta;
  explicit AlphaWeights(double rho)
      : alpha_m((2 * rho - 1) / (rho + 1)),
        alpha_f(rho / (rho + 1)),
        gamma(0.5 + alpha_f - alpha_m),
        beta(0.25 * (gamma + 0.5) * (gamma + 0.5)) {}
  /// beta' = (1 - alpha_m)/(beta h^2 (1 - alpha_f)), gamma' = gamma/(beta h).
  TangentWeights at(double h) const {
    return {(1 - alpha_m) / (beta * h * h * (1 - alpha_f)), gamma / (beta * h)};
  }
};

/// What became of one attempt at a step.
struct StepResult {
  bool converged = false;
  bool accepted = false;  ///< it converged, and its error is not too large
  int tangents = 0;       ///< how often the tangent was taken at the current state
  bool renewed = false;   ///< one of them only saves corrections
  int iterations = 0;     ///< corrections
  int augmentations = 0;  ///< of the multipliers
  double opening = std::numeric_limits<double>::infinity();  ///< at the last of them, m or rad
  double residual = 0;                                       ///< relative, at the last iterate
  double error = 0;     ///< estimate of the local error of the positions, m
  std::string failure;  ///< why not
};

/// Where the tangent in use for a step size was taken, if it is not the constant one.
template <FrameGroup G>
struct TangentPoint {
  double h = 0;
  State<G> s;  ///< the trial state; q: the rows at the state before
  Eigen::VectorXd dq, u, udot;
};

/// What the next steps depend on besides the state.
template <FrameGroup G>
struct StepMemory {
  Eigen::VectorXd older_udot;  ///< rates of the coordinates before the last step
  double previous_h = 0;       ///< 0: the coordinates were changed since
  std::vector<double> scales;  ///< by body: largest forces so far
  int excess = 0;              ///< corrections beyond a few a step since the last tangent
  std::vector<TangentPoint<G>> tangents;
};

/// What `Auto` means to a formalism: the strategy it is known for. Others as chosen.
TangentStrategy tangent_strategy(TangentStrategy chosen, Formalism formalism);

template <FrameGroup G>
class GeneralizedAlpha {
 public:
  GeneralizedAlpha(const Model<G>& model, const SimulationOptions& options);

  /// Sets up what the formalism integrates besides frames (before the first step), and turns
  /// s.a into its coordinates.
  void start(State<G>& s);
  /// The strategy in use (never Auto).
  TangentStrategy tangent() const { return tangent_; }

  /// Advances s by h, if the step converges with an error of at most that; else s is left as it was
  /// (positions perhaps in other axes). Nothing is allocated once each step size has been used.
  StepResult step(State<G>& s, double h,
                  double error_limit = std::numeric_limits<double>::infinity());

  /// Between two steps: restore() makes the next ones those, bit for bit, that followed memory().
  StepMemory<G> memory() const;
  void restore(const StepMemory<G>& memory);

  const std::vector<int>& factorizations() const { return factorizations_; }
  const Equations<G>& equations() const { return equations_; }

 private:
  struct Factored {
    bool exact;
    TangentPoint<G> at;
    JointSystem<G> system;
  };

  Factored& factors_for(double h);
  void predict(const State<G>& old, double h);
  void turn_axes(State<G>& old);
  void correct(const State<G>& old, TangentWeights w);
  bool refresh(Factored& factors);
  bool augment(StepResult& result);
  bool wants_tangent(StepResult& result, double residual, double before) const;
  void extrapolate(Eigen::VectorXd& delta) const;
  double imbalance(bool of_all_nodes) const;
  double local_error(const State<G>& s, double h) const;
  void accept(State<G>& s, double h);

  const Model<G>& model_;
  const SimulationOptions options_;
  const AlphaWeights weights_;
  const TangentStrategy tangent_;
  bool turns_are_observed_ = false;  ///< a coupling is at a position, whose axes it may observe
  NodeCoordinates<G> coordinates_;
  Equations<G> equations_;
  IterationMatrix<G> tangent_at_;  ///< at the trial state, where the constant one does not do
  RateTangents<G> rate_tangents_;
  std::vector<Factored> factored_;
  std::vector<int> factorizations_;
  State<G> trial_;
  Eigen::VectorXd dq_, u_, udot_;                  ///< coordinates of the trial state
  Eigen::VectorXd old_u_, old_udot_, older_udot_;  ///< one and two steps before
  Eigen::VectorXd delta_, increment_, dlambda_, step_before_;
  double previous_h_ = 0;
  std::vector<double> scales_;  ///< by body: largest force scale so far
  int excess_ = 0;              ///< corrections beyond a few a step since the last tangent
};

extern template class GeneralizedAlpha<SE2>;
extern template class GeneralizedAlpha<SE3>;

}  // namespace liesl
