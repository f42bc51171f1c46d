#pragma once
/// @file
/// Newton's method for equilibrium at one load, and along the path of equilibria.

#include <string>
#include <vector>

#include "mbs/solvers/iteration_matrix.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

/// What became of one attempt.
struct NewtonResult {
  bool converged = false;
  bool singular = false;          ///< the tangent at the first iterate has no inverse
  bool misshapen = false;         ///< it failed since an element turns by pi, or is at fault else
  int iterations = 0;             ///< corrections
  std::vector<double> residuals;  ///< relative, one an evaluation
  std::string failure;            ///< why not
};

/// Converged: the residual is below tolerance * (size of the forces in it) + round-off, and the
/// last correction below sqrt(tolerance)/10, since where EA >> EI/L^2 round-off of the normal
/// forces may be more than what still bends. The tangent is exact with extrapolated prestress
/// (iteration_matrix.hpp); where that does not converge the attempt fails and the caller takes a
/// smaller step.
template <FrameGroup G>
class StaticNewton {
 public:
  static constexpr int dim = G::dim;

  StaticNewton(const Model<G>& model, const SimulationOptions& options);

  /// Equilibrium at load factor `load`, from s; on failure s is left as it was.
  NewtonResult solve(State<G>& s, double load);

  /// Equilibrium at distance `ds` from s on the side of `direction` (increments of the nodes, in
  /// local frames, as `last_direction` gives them; zero: growing load), by linearised arc length:
  /// delta = predictor + corrections normal to it, |delta|^2 = sum |u|^2 + (length |w|)^2 over
  /// the frames.
  NewtonResult follow(State<G>& s, double ds, const Eigen::VectorXd& direction);

  /// Size of d(state)/d(load factor) at the equilibrium s, in the norm of `follow`; 0 if singular.
  double speed(const State<G>& s);

  /// Unit predictor of the last converged `follow`.
  const Eigen::VectorXd& last_direction() const { return predictor_; }

  /// Tangent at the equilibrium s with its own prestress.
  const typename IterationMatrix<G>::Matrix& tangent(const State<G>& s);
  IterationMatrix<G>& system() { return system_; }
  const Equations<G>& equations() const { return equations_; }

  /// Is s in equilibrium at `load` to the tolerance?
  bool in_equilibrium(const State<G>& s, double load);

 private:
  LoadLevel level(double load) const { return {options_.at, load}; }
  void evaluate(const State<G>& s, double load);
  /// The same linearised about the extrapolated prestress where laws are not linear in it: what
  /// the tangent belongs to. Equal to the exact residual at equilibrium.
  void evaluate_about_prestress(const State<G>& s, double load);
  bool small_enough() const;
  void load_column(const State<G>& s, double load, Eigen::Ref<Eigen::VectorXd> column);
  bool solve_both(const State<G>& s, double load);
  double product(const Eigen::VectorXd& a, Eigen::Ref<const Eigen::VectorXd> b) const;
  void correct(Eigen::Ref<const Eigen::VectorXd> step);
  void move();
  bool check(NewtonResult& result);
  void finish(State<G>& s, double load, NewtonResult& result);
  bool turns_by(double angle, const State<G>& s) const;

  const Model<G>& model_;
  const SimulationOptions options_;
  Equations<G> equations_;
  IterationMatrix<G> system_;
  State<G> trial_;
  std::vector<int> straight_;  ///< frames of bodies with nodes that are positions
  Eigen::MatrixXd rhs_;        ///< columns: correction at constant load, d(state)/d(load)
  Eigen::VectorXd predictor_, delta_;
  double moved_ = 0;  ///< root mean square of the last correction, of the model's length
};

extern template class StaticNewton<SE2>;
extern template class StaticNewton<SE3>;

}  // namespace liesl
