#include "mbs/solids/interface_map.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Triplets = std::vector<Eigen::Triplet<double>>;

[[noreturn]] void refuse(const Interface& f, const std::string& what) {
  throw std::invalid_argument("interface '" + f.name + "': " + what);
}

/// Rigid motions at all nodes of an interface: (freedoms * nodes) x (3 or 6).
MatrixXd rigid_at(const SolidMesh& mesh, int freedoms, const Interface& f) {
  MatrixXd R(freedoms * f.nodes.size(), mesh.dim == 2 ? 3 : 6);
  for (std::size_t i = 0; i < f.nodes.size(); ++i)
    R.middleRows(freedoms * i, freedoms) =
        rigid_motion(mesh.dim, freedoms, mesh.nodes.col(f.nodes[i]), f.point);
  return R;
}

/// Rows C of q_P = C u: least squares min |u - R q_P|.
MatrixXd averaging_rows(const SolidMesh& mesh, const Interface& f) {
  const MatrixXd R = rigid_at(mesh, mesh.dim, f);
  return linalg::LDLT(R.transpose() * R).solve(R.transpose());
}

/// Where a node is: numbers of readers are not those of their files.
std::string place(const SolidMesh& mesh, int node) {
  const Vector3d x = mesh.nodes.col(node);
  return mesh.dim == 2 ? fmt::format("the node at ({:.6g}, {:.6g})", x[0], x[1])
                       : fmt::format("the node at ({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

void check(const SolidMesh& mesh, int freedoms, const std::vector<Interface>& interfaces,
           std::vector<int>& owner, int number) {
  const Interface& f = interfaces[static_cast<std::size_t>(number)];
  const bool turns = freedoms > mesh.dim && f.tie == Tie::Rigid;  // a node holds a rotation itself
  const std::size_t least = turns ? 1 : static_cast<std::size_t>(mesh.dim);
  if (f.nodes.size() < least)
    refuse(f, "has " + std::to_string(f.nodes.size()) + " nodes, needs at least " +
                  std::to_string(least));
  for (int node : f.nodes) {
    if (node < 0 || node >= mesh.node_count())
      refuse(f, "node " + std::to_string(node) + " is not in the mesh");
    if (owner[node] >= 0)
      refuse(f, place(mesh, node) +
                    (owner[node] == number
                         ? " is listed twice"
                         : " belongs to interface '" +
                               interfaces[static_cast<std::size_t>(owner[node])].name + "', too"));
    owner[node] = number;
  }
  if (!turns && linalg::pivoted_columns(rigid_at(mesh, mesh.dim, f)).rank < (mesh.dim == 2 ? 3 : 6))
    refuse(f, "its nodes coincide or lie in a line, so that they do not hold a rotation");
}

/// The freedoms of an interface that an averaged port takes the place of.
Eigen::VectorXi eliminated(const MatrixXd& C) {
  return linalg::pivoted_columns(C).order.head(C.rows());
}

void tie_rigid(const SolidMesh& mesh, int freedoms, const Interface& f, int port, Triplets& T) {
  const MatrixXd R = rigid_at(mesh, freedoms, f);
  for (std::size_t i = 0; i < f.nodes.size(); ++i)
    for (int a = 0; a < freedoms; ++a)
      for (Eigen::Index j = 0; j < R.cols(); ++j)
        if (const double r = R(freedoms * i + a, j); r != 0)
          T.emplace_back(freedoms * f.nodes[i] + a, port + j, r);
}

/// Which freedoms of an averaged interface depend on others, and how.
struct Averaged {
  MatrixXd C, inverse;  ///< rows, and C_d^-1
  Eigen::VectorXi dependent;
};

void tie_averaged(const SolidMesh& mesh, int freedoms, const Interface& f, const Averaged& a,
                  int port, const std::vector<int>& coordinate, Triplets& T) {
  const MatrixXd weights = a.inverse * a.C;
  for (Eigen::Index d = 0; d < a.dependent.size(); ++d) {
    const auto freedom = [&](Eigen::Index local) {
      return freedoms * f.nodes[local / mesh.dim] + static_cast<int>(local % mesh.dim);
    };
    const int row = freedom(a.dependent[d]);
    for (Eigen::Index j = 0; j < a.inverse.cols(); ++j)
      if (a.inverse(d, j) != 0) T.emplace_back(row, port + j, a.inverse(d, j));
    for (Eigen::Index j = 0; j < a.C.cols(); ++j)
      if (coordinate[freedom(j)] >= 0 && weights(d, j) != 0)
        T.emplace_back(row, coordinate[freedom(j)], -weights(d, j));
  }
}

}  // namespace

MatrixXd rigid_displacement(int dim, const Vector3d& x, const Vector3d& centre) {
  const Vector3d r = x - centre;
  MatrixXd D(dim, dim == 2 ? 3 : 6);
  if (dim == 2)
    D << 1, 0, -r[1], 0, 1, r[0];
  else
    D << 1, 0, 0, 0, r[2], -r[1], 0, 1, 0, -r[2], 0, r[0], 0, 0, 1, r[1], -r[0], 0;
  return D;
}

MatrixXd rigid_motion(int dim, int freedoms, const Vector3d& x, const Vector3d& centre) {
  MatrixXd D = MatrixXd::Zero(freedoms, dim == 2 ? 3 : 6);
  D.topRows(dim) = rigid_displacement(dim, x, centre);
  D.bottomRightCorner(freedoms - dim, freedoms - dim).setIdentity();
  return D;
}

InterfaceMap interface_map(const SolidMesh& mesh, int freedoms,
                           const std::vector<Interface>& interfaces) {
  const int dim = mesh.dim, all = freedoms * mesh.node_count();
  std::vector<int> owner(mesh.node_count(), -1);
  for (std::size_t k = 0; k < interfaces.size(); ++k)
    check(mesh, freedoms, interfaces, owner, static_cast<int>(k));

  InterfaceMap map;
  map.coordinate.assign(all, 0);
  std::vector<Averaged> averaged(interfaces.size());
  for (std::size_t k = 0; k < interfaces.size(); ++k) {
    const Interface& f = interfaces[k];
    if (f.tie == Tie::Rigid) {
      for (int node : f.nodes)
        for (int a = 0; a < freedoms; ++a) map.coordinate[freedoms * node + a] = -1;
      continue;
    }
    Averaged& a = averaged[k];
    a.C = averaging_rows(mesh, f);
    a.dependent = eliminated(a.C);
    MatrixXd C_d(a.C.rows(), a.C.rows());
    for (Eigen::Index d = 0; d < a.dependent.size(); ++d) C_d.col(d) = a.C.col(a.dependent[d]);
    a.inverse = linalg::inverse(C_d);
    for (const int d : a.dependent) map.coordinate[freedoms * f.nodes[d / dim] + d % dim] = -1;
  }
  int size = 0;
  Triplets T;
  for (int i = 0; i < all; ++i) {
    if (map.coordinate[i] < 0) continue;
    map.coordinate[i] = size;
    T.emplace_back(i, size++, 1.0);
  }
  for (std::size_t k = 0; k < interfaces.size(); ++k, size += dim == 2 ? 3 : 6) {
    if (interfaces[k].tie == Tie::Rigid)
      tie_rigid(mesh, freedoms, interfaces[k], size, T);
    else
      tie_averaged(mesh, freedoms, interfaces[k], averaged[k], size, map.coordinate, T);
  }
  map.T.resize(all, size);
  map.T.setFromTriplets(T.begin(), T.end());
  return map;
}

}  // namespace liesl
