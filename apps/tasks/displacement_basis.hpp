#pragma once
/// @file
/// Displacements of a mesh over a motion, of a continuum with its stresses, as amplitudes of few
/// shapes.

#include <Eigen/Core>

namespace liesl {

/// Orthonormal shapes that grow as displacements come: one is added where those before leave more
/// than `tolerance` of it somewhere, so that basis() times the amplitudes is every displacement
/// within it.
class DisplacementBasis {
 public:
  /// @param size of a displacement  @param tolerance m
  DisplacementBasis(Eigen::Index size, double tolerance);

  /// Amplitudes of a displacement: as many as there are shapes now; those of shapes that come later
  /// are zero.
  Eigen::VectorXd amplitudes(const Eigen::VectorXd& u);
  /// Shapes, a column each.
  auto basis() const { return shapes_.leftCols(count_); }

 private:
  double tolerance_;
  Eigen::Index count_ = 0;
  Eigen::MatrixXd shapes_;  ///< columns beyond `count_`: room
};

}  // namespace liesl
