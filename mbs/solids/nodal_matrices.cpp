#include "mbs/solids/nodal_matrices.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "mbs/linalg/sparse_cholesky.hpp"
#include "mbs/solids/interface_map.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kSymmetry = 1e-9, kRigid = 1e-8, kRigidMass = 1e-6, kShift = 1e-8;

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

void check_entries(const std::string& name, const Sparse& A) {
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

int rigid_count(const SolidMesh& nodes) { return nodes.dim == 2 ? 3 : 6; }

void check_size(const std::string& name, const Sparse& A, const SolidMesh& nodes, int freedoms) {
  const int count = nodes.node_count(), size = freedoms * count;
  if (A.rows() == size && A.cols() == size) return;
  const bool any = freedoms == nodes.dim;  // what neither size fits
  throw std::invalid_argument(
      "the " + name + " is " + std::to_string(A.rows()) + " x " + std::to_string(A.cols()) +
      ", the nodes have " + std::to_string(size) + (any ? " displacements" : " freedoms") +
      (any ? ", " + std::to_string(rigid_count(nodes) * count) + " with rotations" : ""));
}

/// Rigid motions about the mean of the nodes, a column each.
MatrixXd rigid_motions(const SolidMesh& nodes, int freedoms) {
  const Eigen::Vector3d centre = nodes.nodes.rowwise().mean();
  MatrixXd R(freedoms * nodes.node_count(), rigid_count(nodes));
  for (int i = 0; i < nodes.node_count(); ++i)
    R.middleRows(freedoms * i, freedoms) =
        rigid_motion(nodes.dim, freedoms, nodes.nodes.col(i), centre);
  return R;
}

/// Forces of K on rigid motions, against the sum of the sizes of their terms.
void check_rigid_stiffness(int dim, const Sparse& K, const MatrixXd& R) {
  const MatrixXd forces = (K * R).cwiseAbs(), terms = K.cwiseAbs() * R.cwiseAbs();
  for (int k = 0; k < R.cols(); ++k)
    if (!(forces.col(k).maxCoeff() <= kRigid * terms.col(k).maxCoeff()))
      throw std::invalid_argument(
          std::string("a rigid ") + (k < dim ? "displacement" : "rotation") +
          " is none of the stiffness matrix: its forces are " +
          text(forces.col(k).maxCoeff() / terms.col(k).maxCoeff()) + " of the terms they sum");
}

/// [m I, m (w x c); ..., J] with one mass m and one centre c.
void check_rigid_mass(int dim, const Sparse& M, const MatrixXd& R) {
  const MatrixXd mass = R.transpose() * (M * R);
  const double m = mass.topLeftCorner(dim, dim).trace() / dim;
  if (!(m > 0 && mass.diagonal().minCoeff() > 0 && M.diagonal().minCoeff() >= 0))
    throw std::invalid_argument("the mass matrix has no positive mass");
  MatrixXd off = mass.topLeftCorner(dim, dim) - m * MatrixXd::Identity(dim, dim);
  const double reach = std::sqrt(mass.diagonal().maxCoeff() / m);
  MatrixXd coupling = mass.topRightCorner(dim, R.cols() - dim);  // m (w x c), a column a rotation
  if (dim == 3)
    coupling = (0.5 * (coupling + coupling.transpose())).eval();  // what is not m (w x c)
  else
    coupling.setZero();
  if (!(off.cwiseAbs().maxCoeff() <= kRigidMass * m &&
        coupling.cwiseAbs().maxCoeff() <= kRigidMass * m * reach))
    throw std::invalid_argument(
        "the mass of rigid motions is not that of a rigid body: it differs between directions by " +
        text(
            std::max(off.cwiseAbs().maxCoeff() / m, coupling.cwiseAbs().maxCoeff() / (m * reach))) +
        " of it");
}

}  // namespace

int freedoms_of_a_node(const SolidMesh& nodes, const NodalMatrices& matrices) {
  const int turning = rigid_count(nodes);
  return matrices.K.rows() == turning * nodes.node_count() ? turning : nodes.dim;
}

void require_free_part(const SolidMesh& nodes, const NodalMatrices& matrices) {
  const int freedoms = freedoms_of_a_node(nodes, matrices);
  const std::pair<const char*, const Sparse&> both[] = {{"stiffness matrix", matrices.K},
                                                        {"mass matrix", matrices.M}};
  for (const auto& [name, A] : both) {
    check_size(name, A, nodes, freedoms);
    check_entries(name, A);
  }
  const MatrixXd R = rigid_motions(nodes, freedoms);
  check_rigid_stiffness(nodes.dim, matrices.K, R);
  check_rigid_mass(nodes.dim, matrices.M, R);
}

std::optional<Sparse> component_mass(const SolidMesh& nodes, const NodalMatrices& matrices) {
  const int dim = nodes.dim;
  if (freedoms_of_a_node(nodes, matrices) > dim) return {};
  std::vector<Eigen::Triplet<double>> entries, all;
  for (int j = 0; j < matrices.M.outerSize(); j += dim)
    for (Sparse::InnerIterator a(matrices.M, j); a; ++a)
      if (a.row() % dim == 0)
        entries.emplace_back(static_cast<int>(a.row() / dim), j / dim, a.value());
  for (const auto& e : entries)
    for (int a = 0; a < dim; ++a) all.emplace_back(dim * e.row() + a, dim * e.col() + a, e.value());
  Sparse M(matrices.M.rows(), matrices.M.cols());
  M.setFromTriplets(all.begin(), all.end());
  if (!(largest(matrices.M - M) <= kSymmetry * largest(M))) return {};
  Sparse m(nodes.node_count(), nodes.node_count());
  m.setFromTriplets(entries.begin(), entries.end());
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
