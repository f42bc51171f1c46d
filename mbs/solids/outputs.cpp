// Supports and linear outputs of a meshed part, as coordinates and vectors in q.
#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "mbs/solids/interface_map.hpp"
#include "mbs/solids/mesh_surface.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl {

using Eigen::VectorXd;

namespace {

/// int N dA of the nodes of a side, m^2; plane: length times thickness.
Eigen::VectorXd side_shares(const SolidModel& model, const CellSide& side) {
  const SolidMesh& mesh = model.mesh();
  const CellKind& kind = side_kind(mesh.kind());
  Eigen::Matrix3Xd nodes(3, kind.nodes);
  for (int i = 0; i < kind.nodes; ++i) nodes.col(i) = mesh.nodes.col(side[std::size_t(i)]);
  VectorXd shares = VectorXd::Zero(kind.nodes);
  for (const QuadraturePoint& p : cell_quadrature(kind, QuadratureUse::Mass)) {
    const CellFunctions f = cell_functions(kind, p.xi);
    const Eigen::Matrix3Xd J = nodes * f.dN.transpose();
    const double area = mesh.dim == 2
                            ? J.col(0).norm() * model.thickness()
                            : Eigen::Vector3d(J.col(0)).cross(Eigen::Vector3d(J.col(1))).norm();
    shares += p.weight * area * f.N;
  }
  return shares;
}

}  // namespace

void fix_port(SolidSupport& support, const SolidModel& model, int interface,
              const std::string& letters) {
  const int dim = model.mesh().dim;
  for (char c : letters) {
    const int i = c - 'x';
    if (c == 'r')
      for (int k = dim; k < model.rigid_count(); ++k)
        support.fixed.push_back(model.port(interface) + k);
    else if (i >= 0 && i < dim)
      support.fixed.push_back(model.port(interface) + i);
    else
      throw std::invalid_argument(std::string("support of a port: '") + c + "' is not one of " +
                                  (dim == 2 ? "x, y, r" : "x, y, z, r"));
  }
}

void fix_nodes(SolidSupport& support, const SolidModel& model, const std::vector<int>& nodes,
               const std::string& letters) {
  for (char c : letters) {
    const int i = c - 'x';
    if (i < 0 || i >= model.mesh().dim)
      throw std::invalid_argument(std::string("support of nodes: '") + c + "' is not one of " +
                                  (model.mesh().dim == 2 ? "x, y" : "x, y, z"));
    for (int node : nodes) {
      const auto at = model.coordinate(node, i);
      if (!at)
        throw std::invalid_argument("support: node " + std::to_string(node) +
                                    " belongs to an interface; fix its port instead");
      support.fixed.push_back(*at);
    }
  }
}

VectorXd elongation_output(const SolidModel& model, int interface_a, int interface_b) {
  const Eigen::Vector3d line =
      model.interfaces()[interface_b].point - model.interfaces()[interface_a].point;
  if (!(line.norm() > 0))
    throw std::invalid_argument("elongation: both interfaces have the same point");
  VectorXd c = VectorXd::Zero(model.size());
  for (int i = 0; i < model.mesh().dim; ++i) {
    c[model.port(interface_b) + i] = line[i] / line.norm();
    c[model.port(interface_a) + i] = -line[i] / line.norm();
  }
  return c;
}

VectorXd relative_output(const SolidModel& model, int interface_a, int interface_b, int component) {
  const int dim = model.mesh().dim, r = model.rigid_count();
  Eigen::MatrixXd carried = Eigen::MatrixXd::Identity(r, r);  // b's port if it moved with a's
  carried.topRows(dim) = rigid_displacement(dim, model.interfaces()[interface_b].point,
                                            model.interfaces()[interface_a].point);
  VectorXd c = VectorXd::Zero(model.size());
  c[model.port(interface_b) + component] = 1;
  c.segment(model.port(interface_a), r) -= carried.row(component).transpose();
  return c;
}

VectorXd node_output(const SolidModel& model, int node, int component) {
  VectorXd freedom = VectorXd::Zero(model.node_freedoms());
  freedom[model.freedoms_of_a_node() * node + component] = 1;
  return model.T().transpose() * freedom;
}

VectorXd traction_load(const SolidModel& model, const std::vector<int>& nodes,
                       const Eigen::Vector3d& traction) {
  const SolidMesh& mesh = model.mesh();
  std::vector<char> in_set(mesh.node_count(), 0);
  for (const int node : nodes) in_set[node] = 1;
  std::vector<CellSide> sides = outer_sides(mesh);
  std::erase_if(sides, [&](const auto& side) {
    return !std::all_of(side.begin(), side.end(), [&](int n) { return n < 0 || in_set[n]; });
  });
  if (sides.empty())
    throw std::invalid_argument("traction: no side of a cell has all its nodes in the set");
  VectorXd f = VectorXd::Zero(model.node_freedoms());
  for (const auto& side : sides) {
    const VectorXd shares = side_shares(model, side);
    for (Eigen::Index i = 0; i < shares.size(); ++i)
      f.segment(mesh.dim * side[std::size_t(i)], mesh.dim) += shares[i] * traction.head(mesh.dim);
  }
  return model.T().transpose() * f;
}

}  // namespace liesl
