#pragma once
/// @file
/// Strains of functions in a cell, and those of the incompatible modes of the 4-node quadrilateral
/// and the 8-node hexahedron (R. L. Taylor, P. J. Beresford, E. L. Wilson, A non-conforming element
/// for stress analysis, Int. J. Numer. Meth. Engng 10 (1976) 1211-1219).

#include <Eigen/Core>

namespace liesl {

/// 3 in the plane, 6 in space: [xx, yy, (zz,) xy(, yz, zx)], shear twice.
constexpr int strain_count(int dim) { return dim == 2 ? 3 : 6; }

/// Strain-displacement matrix of functions with gradients dN (dim x functions): function c moves
/// along i at column dim * c + i.
Eigen::MatrixXd strain_matrix(int dim, const Eigen::MatrixXd& dN);

/// dx/dxi transposed: rows xi, columns x. @param nodes of the cell, its first dim rows count
Eigen::MatrixXd cell_jacobian(int dim, const Eigen::Ref<const Eigen::MatrixXd>& nodes,
                              const Eigen::MatrixXd& dN);

/// Functions 1 - xi_i^2 with d/dxi_i = -2 xi_i, mapped with the Jacobian J0 of the centre and
/// det J0 / det J, so that the cell passes the patch test.
class IncompatibleModes {
 public:
  explicit IncompatibleModes(const Eigen::MatrixXd& J0);
  /// Their strains at xi, where det J = det: strain_count x dim^2.
  Eigen::MatrixXd strains(const Eigen::Vector3d& xi, double det) const;
  /// Their derivative where J0 changes by dJ0 and det J by det times `relative`.
  Eigen::MatrixXd strains_variation(const Eigen::Vector3d& xi, double det,
                                    const Eigen::MatrixXd& dJ0, double relative) const;
  const Eigen::MatrixXd& inverse() const { return J0inverse_; }  ///< J0^-1

 private:
  Eigen::MatrixXd J0inverse_;
  double det0_;
};

}  // namespace liesl
