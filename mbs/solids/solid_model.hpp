#pragma once
/// @file
/// A meshed part with interfaces: stiffness and mass from the fractions of its cells.

#include <Eigen/SparseCore>
#include <optional>
#include <string>
#include <vector>

#include "mbs/linalg/sparse_assembly.hpp"
#include "mbs/sections/section.hpp"
#include "mbs/solids/cell.hpp"
#include "mbs/solids/ersatz.hpp"
#include "mbs/solids/interface.hpp"
#include "mbs/solids/mesh.hpp"
#include "mbs/solids/nodal_matrices.hpp"

namespace liesl {

/// Mesh, material and interfaces in coordinates q: the displacements of the free nodes, then for
/// each interface the motion of its port, [u; w] (2 + 1 numbers in the plane, 3 + 3 in space).
/// Displacements of all nodes are T q: a rigid interface moves with its port; of an averaged one
/// three (six) nodal displacements are expressed by the port and the other nodes. Forces are f =
/// T^T f_nodes. It is const once built, so that a mechanism, its copies and what is made of them
/// share one, also among threads.
class SolidModel {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  struct Options {
    double thickness = 1;  ///< m, of planar meshes
    ErsatzLaw law;
  };

  /// @throws std::invalid_argument that names the interface: too few nodes, nodes in a line, nodes
  /// shared with another interface, unknown nodes; or a cell that is inverted
  SolidModel(SolidMesh mesh, Material material, std::vector<Interface> interfaces,
             const Options& options);
  /// A part whose matrices come from elsewhere: `nodes` is a mesh without cells.
  /// @throws std::invalid_argument, also as `require_free_part`
  SolidModel(SolidMesh nodes, const NodalMatrices& matrices, std::vector<Interface> interfaces);

  const SolidMesh& mesh() const { return mesh_; }
  const std::vector<Interface>& interfaces() const { return interfaces_; }
  const ErsatzLaw& law() const { return options_.law; }
  const Material& material() const { return material_; }
  double thickness() const { return options_.thickness; }  ///< m, of planar meshes

  int size() const { return static_cast<int>(T_.cols()); }           ///< of q
  int node_freedoms() const { return static_cast<int>(T_.rows()); }  ///< of all nodes
  /// Of one: dim; of a part without cells dim or, with its rotation, 3 or 6.
  int freedoms_of_a_node() const { return freedoms_; }
  int rigid_count() const { return mesh_.dim == 2 ? 3 : 6; }  ///< also numbers of a port
  const Sparse& T() const { return T_; }                      ///< node freedoms x q
  /// Displacements of the nodes by q, a column each: (dim * nodes) x columns.
  Eigen::MatrixXd displacements(const Eigen::MatrixXd& q) const;
  /// First coordinate of a port; they are in the order of the interfaces, at the end of q.
  int port(int interface) const { return size() - rigid_count() * (ports() - interface); }
  int ports() const { return static_cast<int>(interfaces_.size()); }
  /// @throws std::invalid_argument with the known names
  int interface_named(const std::string& name) const;
  /// Coordinate of a node's displacement, nothing if the interface took it.
  std::optional<int> coordinate(int node, int component) const;

  /// Lower triangles of the stiffness and mass matrices in q for fractions v [cells], all with the
  /// same pattern.
  Sparse stiffness(const Eigen::VectorXd& v) const;
  Sparse mass(const Eigen::VectorXd& v) const;
  /// Lower triangle of dK/dp for fractions v with dv/dp = dv.
  Sparse stiffness_derivative(const Eigen::VectorXd& v, const Eigen::VectorXd& dv) const;
  /// kg; and its gradient with respect to the fractions.
  double total_mass(const Eigen::VectorXd& v) const {
    return given_.empty() ? full_mass_.dot(v) : given_mass_;
  }
  const Eigen::VectorXd& cell_masses() const { return full_mass_; }

  /// Motions of the undeformed part, q x rigid_count(): translations, then rotations about the
  /// origin of the mesh.
  const Eigen::MatrixXd& rigid_motions() const { return rigid_; }

  /// Of a part without cells: the mass between the nodes of one component, or, where components are
  /// coupled, that of all freedoms of the nodes; null otherwise.
  const Sparse* nodal_mass() const { return component_mass_ ? &*component_mass_ : nullptr; }
  const Sparse* coupled_mass() const { return coupled_mass_ ? &*coupled_mass_ : nullptr; }

  /// Matrices of a full cell; cells of equal shape share them.
  const CellMatrices& cell(int e) const { return shapes_[shape_of_[e]]; }
  /// Its mass matrix for all freedoms, kg: that of one component for each.
  const Eigen::MatrixXd& cell_mass(int e) const { return M_of_shape_[shape_of_[e]]; }
  /// First freedom of a cell's local node: freedoms of meshes are dim * node + component.
  int freedom(int cell, int local) const { return mesh_.dim * mesh_.cells(local, cell); }
  /// What u [node freedoms x columns] is at the nodes of a cell: dim * its nodes x columns.
  Eigen::MatrixXd at_cell(int cell, const Eigen::Ref<const Eigen::MatrixXd>& u) const;
  /// The same of coordinates q [size() x columns]: rows of T q.
  Eigen::MatrixXd q_at_cell(int cell, const Eigen::Ref<const Eigen::MatrixXd>& q) const;

 private:
  void find_shapes();
  void number_freedoms();
  /// @param matrix of a cell, for all of its freedoms
  template <class Matrix>
  SparseAssembly add_cells(SparseAssembly assembly, const Matrix& matrix,
                           const Eigen::VectorXd& factor) const;

  SolidMesh mesh_;
  Material material_;
  std::vector<Interface> interfaces_;
  Options options_;
  std::vector<CellMatrices> shapes_;
  /// Of a part without cells: K and M in q with the same pattern, lower triangles; else empty.
  std::vector<Sparse> given_;
  std::optional<Sparse> component_mass_, coupled_mass_;
  double given_mass_ = 0;
  int freedoms_ = 0;                         ///< of a node
  std::vector<Eigen::MatrixXd> M_of_shape_;  ///< for all components
  std::vector<int> shape_of_;
  Eigen::VectorXd full_mass_;
  std::vector<int> coordinate_;  ///< by freedom, -1: taken by an interface
  Sparse T_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> T_rows_;
  Eigen::MatrixXd rigid_;
  SparseAssembly assembly_{0};  ///< with the pattern
};

}  // namespace liesl
