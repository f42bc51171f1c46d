#include "mbs/solids/cell_kind.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace liesl {
namespace {

using Eigen::Vector3d;

constexpr CellFamily kCube = CellFamily::Cube, kSimplex = CellFamily::Simplex;

// clang-format off
constexpr std::array<CellKind, 10> kKinds = {{
    // name, dim, family, order, nodes, corners, Gmsh, Abaqus, VTK, XDMF
    {"3-node triangle",      2, kSimplex, 1,  3, 3,  2, "CPS3",   5, "Triangle"},
    {"4-node quadrilateral", 2, kCube,    1,  4, 4,  3, "CPS4",   9, "Quadrilateral"},
    {"6-node triangle",      2, kSimplex, 2,  6, 3,  9, "CPS6",  22, "Tri_6"},
    {"8-node quadrilateral", 2, kCube,    2,  8, 4, 16, "CPS8",  23, "Quad_8"},
    {"4-node tetrahedron",   3, kSimplex, 1,  4, 4,  4, "C3D4",  10, "Tetrahedron"},
    {"8-node hexahedron",    3, kCube,    1,  8, 8,  5, "C3D8",  12, "Hexahedron"},
    {"10-node tetrahedron",  3, kSimplex, 2, 10, 4, 11, "C3D10", 24, "Tet_10"},
    {"20-node hexahedron",   3, kCube,    2, 20, 8, 17, "C3D20", 25, "Hex_20"},
    {"2-node line",          1, kCube,    1,  2, 2,  1, "",       3, "Polyline"},
    {"3-node line",          1, kCube,    2,  3, 2,  8, "",      21, "Edge_3"},
}};
// clang-format on

// Of two dimensions are the first of those of three.
constexpr std::array<std::array<int, 2>, 12> kCubeEdges = {{{0, 1},
                                                            {1, 2},
                                                            {2, 3},
                                                            {3, 0},
                                                            {4, 5},
                                                            {5, 6},
                                                            {6, 7},
                                                            {7, 4},
                                                            {0, 4},
                                                            {1, 5},
                                                            {2, 6},
                                                            {3, 7}}};
constexpr std::array<std::array<int, 2>, 6> kSimplexEdges = {
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<int, 4>, 6> kCubeFaces = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
constexpr std::array<std::array<int, 4>, 4> kTetrahedronFaces = {
    {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}}};

std::size_t row_of(const CellKind& kind) { return std::size_t(&kind - kKinds.data()); }

/// The node at the edge between two corners.
int node_between(const CellKind& kind, int a, int b) {
  const auto edges = cell_edges(kind);
  const auto at = std::find_if(edges.begin(), edges.end(), [&](const auto& edge) {
    return std::minmax(edge[0], edge[1]) == std::minmax(a, b);
  });
  return kind.corners + static_cast<int>(at - edges.begin());
}

/// Corners of a side, then its edges' nodes.
CellSide whole_side(const CellKind& kind, std::vector<int> corners) {
  CellSide side;
  side.fill(-1);
  std::copy(corners.begin(), corners.end(), side.begin());
  const std::size_t n = corners.size();
  for (std::size_t i = 0; kind.order == 2 && i < (n == 2 ? 1 : n); ++i)
    side[n + i] = node_between(kind, corners[i], corners[(i + 1) % n]);
  return side;
}

std::vector<CellSide> sides_of(const CellKind& kind) {
  std::vector<CellSide> out;
  if (kind.dim == 2)
    for (const auto& [a, b] : cell_edges(kind)) out.push_back(whole_side(kind, {a, b}));
  if (kind.dim < 3) return out;
  const bool cube = kind.family == kCube;
  for (std::size_t s = 0; s < (cube ? kCubeFaces.size() : kTetrahedronFaces.size()); ++s) {
    const auto& face = cube ? kCubeFaces[s] : kTetrahedronFaces[s];
    out.push_back(whole_side(kind, {face.begin(), face.begin() + (cube ? 4 : 3)}));
  }
  return out;
}

/// -1 or 1.
Vector3d cube_corner(int dim, int c) {
  return {(c + 1) / 2 % 2 ? 1.0 : -1.0, dim > 1 ? (c / 2 % 2 ? 1.0 : -1.0) : 0,
          dim > 2 ? (c / 4 ? 1.0 : -1.0) : 0};
}

/// Products of (1 + s_i xi_i)/2 (1 - xi_i^2 where s_i = 0); corners of order 2 times
/// sum s_i xi_i - (dim - 1).
CellFunctions cube_functions(const CellKind& kind, const Vector3d& xi) {
  CellFunctions f;
  f.N.resize(kind.nodes);
  f.dN.resize(kind.dim, kind.nodes);
  for (int n = 0; n < kind.nodes; ++n) {
    const Vector3d s = reference_node(kind, n);
    std::array<double, 3> factor = {1, 1, 1}, slope = {0, 0, 0};
    for (int a = 0; a < kind.dim; ++a) {
      factor[a] = s[a] == 0 ? 1 - xi[a] * xi[a] : (1 + s[a] * xi[a]) / 2;
      slope[a] = s[a] == 0 ? -2 * xi[a] : s[a] / 2;
    }
    f.N[n] = factor[0] * factor[1] * factor[2];
    for (int a = 0; a < kind.dim; ++a)
      f.dN(a, n) = slope[a] * factor[(a + 1) % 3] * factor[(a + 2) % 3];
    if (kind.order == 1 || n >= kind.corners) continue;
    const double bend = s.head(kind.dim).dot(xi.head(kind.dim)) - (kind.dim - 1);
    f.dN.col(n) = bend * f.dN.col(n) + f.N[n] * s.head(kind.dim);
    f.N[n] *= bend;
  }
  return f;
}

/// Barycentric coordinates L; of order 2 L (2 L - 1) and 4 L_i L_j.
CellFunctions simplex_functions(const CellKind& kind, const Vector3d& xi) {
  const int dim = kind.dim, corners = kind.corners;
  Eigen::VectorXd L(corners);
  Eigen::MatrixXd dL(dim, corners);
  L << 1 - xi.head(dim).sum(), xi.head(dim);
  dL << Eigen::VectorXd::Constant(dim, -1), Eigen::MatrixXd::Identity(dim, dim);
  CellFunctions f;
  f.N.resize(kind.nodes);
  f.dN.resize(dim, kind.nodes);
  if (kind.order == 1) {
    f.N = L;
    f.dN = dL;
    return f;
  }
  for (int c = 0; c < corners; ++c) {
    f.N[c] = L[c] * (2 * L[c] - 1);
    f.dN.col(c) = (4 * L[c] - 1) * dL.col(c);
  }
  for (int n = corners; n < kind.nodes; ++n) {
    const auto& [i, j] = cell_edges(kind)[std::size_t(n - corners)];
    f.N[n] = 4 * L[i] * L[j];
    f.dN.col(n) = 4 * (L[i] * dL.col(j) + L[j] * dL.col(i));
  }
  return f;
}

}  // namespace

std::span<const CellKind> cell_kinds() { return kKinds; }

const CellKind& cell_kind(int dim, int nodes) {
  for (const CellKind& kind : kKinds)
    if (kind.dim == dim && kind.nodes == nodes) return kind;
  throw std::invalid_argument("there are no cells of " + std::to_string(nodes) + " nodes in " +
                              std::to_string(dim) + " dimensions");
}

const CellKind& side_kind(const CellKind& kind) {
  return *std::find_if(kKinds.begin(), kKinds.end(), [&](const CellKind& side) {
    return side.dim == kind.dim - 1 && side.order == kind.order &&
           (side.dim == 1 || side.family == kind.family);
  });
}

std::span<const std::array<int, 2>> cell_edges(const CellKind& kind) {
  constexpr std::array<std::size_t, 3> of_cubes = {1, 4, 12}, of_simplices = {1, 3, 6};
  const auto d = static_cast<std::size_t>(kind.dim - 1);
  if (kind.family == kCube) return std::span(kCubeEdges).first(of_cubes[d]);
  return std::span(kSimplexEdges).first(of_simplices[d]);
}

std::span<const CellSide> cell_sides(const CellKind& kind) {
  static const auto all = [] {
    std::array<std::vector<CellSide>, kKinds.size()> out;
    for (const CellKind& k : kKinds) out[row_of(k)] = sides_of(k);
    return out;
  }();
  return all[row_of(kind)];
}

std::span<const int> gmsh_order(const CellKind& kind) {
  static constexpr std::array<int, 20> same = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                               10, 11, 12, 13, 14, 15, 16, 17, 18, 19};
  static constexpr std::array<int, 10> tetrahedron = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  static constexpr std::array<int, 20> hexahedron = {0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                                     13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
  if (kind.nodes == 10) return tetrahedron;
  if (kind.nodes == 20) return hexahedron;
  return std::span(same).first(static_cast<std::size_t>(kind.nodes));
}

CellFunctions cell_functions(const CellKind& kind, const Vector3d& xi) {
  return kind.family == kCube ? cube_functions(kind, xi) : simplex_functions(kind, xi);
}

Vector3d reference_node(const CellKind& kind, int node) {
  if (node >= kind.corners) {
    const auto& [a, b] = cell_edges(kind)[std::size_t(node - kind.corners)];
    return (reference_node(kind, a) + reference_node(kind, b)) / 2;
  }
  if (kind.family == kCube) return cube_corner(kind.dim, node);
  return node == 0 ? Vector3d(0, 0, 0) : Vector3d(Vector3d::Unit(node - 1));
}

Vector3d reference_centre(const CellKind& kind) {
  if (kind.family == kCube) return Vector3d::Zero();
  Vector3d xi = Vector3d::Zero();
  xi.head(kind.dim).setConstant(1.0 / (kind.dim + 1));
  return xi;
}

}  // namespace liesl
