// Supports and linear outputs of a meshed part, as coordinates and vectors in q.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <stdexcept>

#include "mbs/solids/interface_map.hpp"
#include "mbs/solids/mesh_surface.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl {

using Eigen::VectorXd;

namespace {

/// int N dA of the nodes of a side, m^2; plane: length times thickness.
Eigen::Vector4d side_shares(const SolidModel& model, const std::array<int, 4>& side) {
  const Eigen::Matrix3Xd& x = model.mesh().nodes;
  if (model.mesh().dim == 2) {
    const double half = (x.col(side[1]) - x.col(side[0])).norm() * model.thickness() / 2;
    return {half, half, 0, 0};
  }
  Eigen::Matrix<double, 3, 4> corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = x.col(side[i]);
  Eigen::Vector4d shares = Eigen::Vector4d::Zero();
  for (int point = 0; point < 4; ++point) {
    const double g = 1 / std::sqrt(3.0);
    const CornerFunctions f = corner_functions(2, {point & 1 ? g : -g, point & 2 ? g : -g, 0});
    const Eigen::Matrix<double, 3, 2> J = corners * f.dN.transpose();
    shares += J.col(0).cross(J.col(1)).norm() * f.N;
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
  freedom[model.mesh().dim * node + component] = 1;
  return model.T().transpose() * freedom;
}

VectorXd traction_load(const SolidModel& model, const std::vector<int>& nodes,
                       const Eigen::Vector3d& traction) {
  const SolidMesh& mesh = model.mesh();
  std::vector<char> in_set(mesh.node_count(), 0);
  for (const int node : nodes) in_set[node] = 1;
  std::vector<std::array<int, 4>> sides = outer_sides(mesh);
  std::erase_if(sides, [&](const auto& side) {
    return !std::all_of(side.begin(), side.end(), [&](int n) { return n < 0 || in_set[n]; });
  });
  if (sides.empty())
    throw std::invalid_argument("traction: no side of a cell has all its nodes in the set");
  VectorXd f = VectorXd::Zero(model.node_freedoms());
  for (const auto& side : sides) {
    const Eigen::Vector4d shares = side_shares(model, side);
    for (int i = 0; i < 4 && side[i] >= 0; ++i)
      f.segment(mesh.dim * side[i], mesh.dim) += shares[i] * traction.head(mesh.dim);
  }
  return model.T().transpose() * f;
}

}  // namespace liesl
