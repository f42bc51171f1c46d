#include "mbs/solids/motion_mass.hpp"

#include <Eigen/Geometry>
#include <cassert>

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Axes of rotations: z alone in the plane.
int first_axis(int dim) { return dim == 2 ? 2 : 0; }

Vector3d displacement(const MatrixXd& u, Eigen::Index row, int dim, Eigen::Index column) {
  Vector3d out = Vector3d::Zero();
  out.head(dim) = u.col(column).segment(row, dim);
  return out;
}

/// W, a row a freedom of the nodes. @param axes of the frame, columns in those of the mesh
MatrixXd motions(const SolidModel& model, const MatrixXd& basis, const Vector3d& origin,
                 const Matrix3d& axes) {
  const SolidMesh& mesh = model.mesh();
  const int dim = mesh.dim, freedoms = model.freedoms_of_a_node(), first = first_axis(dim),
            turns = 3 - first;
  const MatrixXd u = model.T() * basis;
  const Eigen::Index n = u.cols(), rigid = dim + turns;
  MatrixXd W = MatrixXd::Zero(u.rows(), rigid + (1 + turns) * n);
  W.middleCols(rigid, n) = u;
  for (int i = 0; i < mesh.node_count(); ++i) {
    const int row = freedoms * i;
    for (int a = 0; a < dim; ++a) W.block(row, a, dim, 1) = axes.col(a).head(dim);
    for (int b = 0; b < turns; ++b) {
      const Vector3d axis = axes.col(first + b);
      W.block(row, dim + b, dim, 1) = axis.cross(mesh.nodes.col(i) - origin).head(dim);
      if (freedoms > dim) W.block(row + dim, dim + b, turns, 1) = axis.tail(turns);
      for (Eigen::Index k = 0; k < n; ++k)
        W.block(row, rigid + (1 + b) * n + k, dim, 1) =
            axis.cross(displacement(u, row, dim, k)).head(dim);
    }
  }
  return W;
}

}  // namespace

MatrixXd motion_mass(const SolidModel& model, const MatrixXd& basis, const Vector3d& origin,
                     const Matrix3d& turn) {
  assert(model.coupled_mass());
  const MatrixXd W = motions(model, basis, origin, turn.transpose());
  MatrixXd mass = linalg::transposed_product(W, MatrixXd(*model.coupled_mass() * W));
  const int dim = model.mesh().dim, first = first_axis(dim), turns = 3 - first;
  const Eigen::Index n = basis.cols(), rigid = dim + turns;
  for (int b = 0; b < turns; ++b)
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index column = rigid + (1 + b) * n + k;
      const Vector3d carried =
          Vector3d::Unit(first + b).cross(displacement(mass, 0, dim, rigid + k));
      mass.col(column).head(dim) = carried.head(dim);
      mass.row(column).head(dim) = carried.head(dim).transpose();
    }
  return 0.5 * (mass + mass.transpose());
}

}  // namespace liesl
