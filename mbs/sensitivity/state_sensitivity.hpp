#pragma once
/// @file
/// What is known of a state's dependence on parameters.

#include <Eigen/Core>

namespace liesl {

/// Derivatives of a state by n_p parameters, a column each; of functionals by a state as well.
struct StateSensitivity {
  Eigen::MatrixXd eta;     ///< n x n_p, left-invariant increments of frames; amplitudes as they are
  Eigen::MatrixXd v;       ///< n x n_p
  Eigen::MatrixXd a;       ///< n x n_p, of the acceleration-like variable in local frames
  Eigen::MatrixXd w;       ///< n x n_p, of vdot
  Eigen::MatrixXd lambda;  ///< m x n_p

  static StateSensitivity zero(int n, int m, int columns);
  StateSensitivity& operator+=(const StateSensitivity& other);
  /// Of derivatives with cotangents of the same state: n_p x functionals.
  Eigen::MatrixXd transposed_product(const StateSensitivity& cotangents) const;
};

}  // namespace liesl
