#pragma once
/// @file
/// From what a mesh file lists to a mesh: what all formats have in common.

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "apps/input/problem.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl {

/// Gathers nodes, cells and sets under the numbers of the file, and makes a mesh of them. Problems
/// name their line, the first twenty of them: a mesh that is wrong is often wrong everywhere.
class MeshBuilder {
 public:
  /// Hints that differ between formats.
  struct Hints {
    std::string twice_node, twice_cell, inverted, folded, no_cells, several_kinds;
  };
  MeshBuilder(Problems& problems, Hints hints) : problems_(problems), hints_(std::move(hints)) {}

  void problem(int line, std::string what, std::string expected = "", std::string hint = "");
  void add_node(std::size_t tag, const Eigen::Vector3d& x, int line);
  /// Nodes in the order of SolidMesh.
  void add_cell(const CellKind& kind, std::vector<std::size_t> nodes, int line);
  /// Nodes without a cell are left out.
  void add_to_set(const std::string& name, std::size_t tag) { sets_[name].insert(tag); }
  bool has_node(std::size_t tag) const { return positions_.contains(tag); }

  /// In space if there are cells in space; planar cells are their sides then.
  /// @throws InputError: no cells, cells of several kinds, cells that are there twice, inverted or
  /// flat, folded by nodes at their edges or over each other, nodes that do not exist, planar cells
  /// that do not lie in z = 0
  SolidMesh build();

 private:
  struct Cell {
    const CellKind* kind;
    std::vector<std::size_t> nodes;
    int line;
  };
  void choose_kind(SolidMesh& mesh);
  void number_nodes(SolidMesh& mesh);
  void add_cells(SolidMesh& mesh);
  void require_shape(const Cell& cell, const Eigen::Matrix3Xd& x);
  void find_folds(const SolidMesh& mesh);

  Problems& problems_;
  Hints hints_;
  int reported_ = 0;
  std::unordered_map<std::size_t, Eigen::Vector3d> positions_;
  std::unordered_map<std::size_t, int> number_;
  std::vector<Cell> cells_;
  std::map<std::string, std::set<std::size_t>> sets_;
};

}  // namespace liesl
