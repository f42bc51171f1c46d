#pragma once
/// @file
/// The slope of a function at a point by a polynomial fitted to many differences: what differences
/// tell at best where a function has round-off, which the fit averages.

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

namespace liesl {

struct FittedSlope {
  double slope = 0;
  double deviation = std::numeric_limits<double>::infinity();  ///< standard error of the slope
};

/// Fits of odd functions: (F(x) - F(-x)) / 2 = c_1 x + c_3 x^3 + ..., by least squares at the
/// positive Chebyshev points of a window (-H, H); the slope is c_1. Of all numbers of terms that
/// one is taken whose own standard error of c_1, from the residuals of its fit, is smallest; what
/// the slope is compared with has no part in the choice.
class OddFits {
 public:
  static constexpr int kPairs = 24;
  static constexpr int kMostTerms = 8;
  /// H, of the range of a variable: larger ones divide round-off, smaller ones meet fewer kinks.
  static constexpr std::array<double, 5> kWindows{1e-2, 3e-3, 1e-3, 3e-4, 1e-4};

  OddFits();
  /// x / H, kPairs numbers in (0, 1).
  const Eigen::VectorXd& points() const { return points_; }
  /// @param odd (F(x) - F(-x)) / 2 at x = window points()
  FittedSlope operator()(const Eigen::VectorXd& odd, double window) const;

 private:
  /// Of one number of terms: an orthonormal basis of the fits, and the row that gives c_1.
  struct Fit {
    Eigen::MatrixXd basis;
    Eigen::VectorXd slope;
  };
  Eigen::VectorXd points_;
  std::vector<Fit> fits_;
};

}  // namespace liesl
