#include "mbs/solids/nodal_matrices.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "mbs/linalg/sparse_cholesky.hpp"
#include "mbs/solids/interface_map.hpp"

namespace liesl {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kSymmetry = 1e-9, kRigid = 1e-8, kShift = 1e-8;

std::string text(double x) {
  char out[32];
  std::snprintf(out, sizeof out, "%.3g", x);
  return out;
}

double largest(const Sparse& A) {
  double out = 0;
  for (Eigen::Index k = 0; k < A.outerSize(); ++k)
    for (Sparse::InnerIterator it(A, k); it; ++it) out = std::max(out, std::abs(it.value()));
  return out;
}

void check_entries(const std::string& name, const Sparse& A, Eigen::Index size) {
  if (A.rows() != size || A.cols() != size)
    throw std::invalid_argument("the " + name + " is " + std::to_string(A.rows()) + " x " +
                                std::to_string(A.cols()) + ", the nodes have " +
                                std::to_string(size) + " displacements");
  for (int j = 0; j < A.outerSize(); ++j)
    for (Sparse::InnerIterator a(A, j); a; ++a)
      if (!std::isfinite(a.value()))
        throw std::invalid_argument("the " + name + " has an entry that is not finite at (" +
                                    std::to_string(a.row() + 1) + ", " +
                                    std::to_string(a.col() + 1) + ")");
  const double off = largest(A - Sparse(A.transpose()));
  if (!(off <= kSymmetry * largest(A)))
    throw std::invalid_argument("the " + name + " is not symmetric: entries differ by " +
                                text(off / largest(A)) + " of the largest");
}

/// Forces of K on rigid motions, against the sum of the sizes of their terms.
void check_rigid_motions(const SolidMesh& nodes, const Sparse& K) {
  const int dim = nodes.dim, rigid = dim == 2 ? 3 : 6;
  const Eigen::Vector3d centre = nodes.nodes.rowwise().mean();
  Eigen::MatrixXd R(dim * nodes.node_count(), rigid);
  for (int i = 0; i < nodes.node_count(); ++i)
    R.middleRows(dim * i, dim) = rigid_displacement(dim, nodes.nodes.col(i), centre);
  const Eigen::MatrixXd forces = (K * R).cwiseAbs(), terms = K.cwiseAbs() * R.cwiseAbs();
  for (int k = 0; k < rigid; ++k)
    if (!(forces.col(k).maxCoeff() <= kRigid * terms.col(k).maxCoeff()))
      throw std::invalid_argument(
          std::string("a rigid ") + (k < dim ? "displacement" : "rotation") +
          " is none of the stiffness matrix: its forces are " +
          text(forces.col(k).maxCoeff() / terms.col(k).maxCoeff()) + " of the terms they sum");
}

}  // namespace

Sparse component_mass(const SolidMesh& nodes, const NodalMatrices& matrices) {
  const int dim = nodes.dim;
  const Eigen::Index size = static_cast<Eigen::Index>(dim) * nodes.node_count();
  check_entries("stiffness matrix", matrices.K, size);
  check_entries("mass matrix", matrices.M, size);
  check_rigid_motions(nodes, matrices.K);
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < matrices.M.outerSize(); j += dim)
    for (Sparse::InnerIterator a(matrices.M, j); a; ++a)
      if (a.row() % dim == 0)
        entries.emplace_back(static_cast<int>(a.row() / dim), j / dim, a.value());
  Sparse m(nodes.node_count(), nodes.node_count());
  m.setFromTriplets(entries.begin(), entries.end());
  std::vector<Eigen::Triplet<double>> all;
  for (const auto& e : entries)
    for (int a = 0; a < dim; ++a) all.emplace_back(dim * e.row() + a, dim * e.col() + a, e.value());
  Sparse M(size, size);
  M.setFromTriplets(all.begin(), all.end());
  if (!(largest(matrices.M - M) <= kSymmetry * largest(M)))
    throw std::invalid_argument(
        "the mass matrix is not that of a solid: components of a displacement must not be coupled, "
        "and have the same masses");
  if (!(m.sum() > 0 && m.diagonal().minCoeff() >= 0))
    throw std::invalid_argument("the mass matrix has no positive mass");
  return m;
}

void require_positive_stiffness(const NodalMatrices& matrices) {
  const Eigen::VectorXd K = matrices.K.diagonal(), M = matrices.M.diagonal();
  Eigen::Index j = 0;
  if (!(K.minCoeff(&j) > 0))
    throw std::invalid_argument("the stiffness matrix has " + text(K[j]) + " N/m at (" +
                                std::to_string(j + 1) + ", " + std::to_string(j + 1) +
                                "); a diagonal of positive numbers is expected");
  Sparse shifted = matrices.K + kShift * K.maxCoeff() / M.maxCoeff() * matrices.M;
  shifted.makeCompressed();
  if (!SparseCholesky().factor(shifted))
    throw std::invalid_argument(
        "the stiffness matrix is not positive semidefinite: there is a displacement of negative "
        "energy");
}

}  // namespace liesl
