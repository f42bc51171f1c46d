#pragma once
/// @file
/// Eigenpairs of K phi = lambda M phi nearest a shift, by Lanczos on (K - sigma M)^-1 (Spectra).

#include <Eigen/Core>

namespace liesl {

/// y = M x. The names of the functions are those that Spectra asks for.
class LinearOperator {
 public:
  using Scalar = double;
  virtual ~LinearOperator() = default;
  virtual Eigen::Index rows() const = 0;
  Eigen::Index cols() const { return rows(); }
  virtual void perform_op(const double* x, double* y) const = 0;
};

/// y = (K - sigma M)^-1 x.
class ShiftedInverse : public LinearOperator {
 public:
  virtual void set_shift(double sigma) = 0;
  virtual bool regular() const = 0;  ///< the matrix of the last shift
};

/// @param most dimension of the space of the solution  @param lambda growing  @param phi M-normal
/// @returns false if the operator is singular or the iteration does not end
bool shift_invert_lanczos(ShiftedInverse& inverse, const LinearOperator& mass, int count, int most,
                          double sigma, double tolerance, Eigen::VectorXd& lambda,
                          Eigen::MatrixXd& phi);

}  // namespace liesl
