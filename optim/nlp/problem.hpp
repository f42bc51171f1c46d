#pragma once
/// @file
/// The neutral nonlinear program that every optimiser of liesl consumes:
///
///     minimise f(x)   subject to   g(x) <= 0,   lower <= x <= upper,   x in R^n, g in R^m.
///
/// Made for few variables (n up to about 100) and many constraints (m up to about 5000): dense.

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace liesl {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Name of a constraint for the machine. The same physical requirement (this limit, this load
/// case) keeps its id from one problem to the next, which is what a warm start goes by.
using ConstraintId = std::uint64_t;

struct NlpVariable {
  std::string name;
  double lower = 0, upper = 0;  ///< same unit as start; may be infinite; equal = fixed
  double start = 0;             ///< finite; moved to the nearest bound if outside
};

struct NlpConstraint {
  ConstraintId id = 0;  ///< unique within the problem
  std::string name;     ///< for reports
  /// Amount of g that counts as one, unit of g. Feasibility tolerances refer to it. 0: taken from
  /// the start, max(|g|, largest |dg/dx_j| (upper_j - lower_j)).
  double scale = 0;
};

enum class HessianShape {
  None,      ///< not available: optimisers fall back to quasi-Newton updates
  Diagonal,  ///< separable functions: only the diagonal of `h` is written and read
  Dense      ///< the lower triangle of `h` is written and read
};

/// Contract of the calls. Drivers reach a problem only through Evaluator, which guarantees:
///   - `values(x)` comes first at every new x, and x lies within the bounds;
///   - `gradients(x)` and `hessian(x)` are called only at the x of the latest `values(x)`, so that
///     a factorisation made there can be kept; `gradients` precedes `hessian`;
///   - neither is called twice at the same x as long as x is among the last few points.
/// Outputs arrive with their final size (g: m, df: n, dg: m x n, h: n x n) and arbitrary content;
/// h arrives zero. A point where the problem has no value (a simulation that fails) is reported by
/// NaN: optimisers that can shorten their step do so, the others stop with a reason. Exceptions
/// are for errors; they reach the caller of the driver unchanged.
class Problem {
 public:
  virtual ~Problem() = default;
  Problem() = default;
  Problem(const Problem&) = default;
  Problem& operator=(const Problem&) = default;

  virtual const std::vector<NlpVariable>& variables() const = 0;      ///< n, constant
  virtual const std::vector<NlpConstraint>& constraints() const = 0;  ///< m, constant

  virtual void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) = 0;
  /// df_j = df/dx_j, dg_ij = dg_i/dx_j.
  virtual void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) = 0;

  virtual HessianShape hessian_shape() const { return HessianShape::None; }
  bool has_hessian() const { return hessian_shape() != HessianShape::None; }
  /// Hessian of the Lagrangian, h = sigma d2f/dx2 + sum_i lambda_i d2g_i/dx2.
  virtual void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
                       Eigen::MatrixXd& h);
};

/// What is wrong with the data of a problem (bounds, start, names, ids, scales); empty = sound.
std::vector<std::string> problem_errors(const Problem& problem);

/// Throws std::invalid_argument that lists all `errors` after `what`, if there are any.
void refuse_if(const std::string& what, const std::vector<std::string>& errors);

}  // namespace liesl
