#include "apps/output/cut_mesh.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

namespace liesl::output {
namespace {

using Polygon = std::vector<std::uint32_t>;

class Cutter {
 public:
  Cutter(const std::vector<double>& nodes, const std::vector<double>& level)
      : nodes_(nodes), level_(level) {}

  bool inside(int node) const { return level_.empty() || level_[std::size_t(node)] > 0; }
  Eigen::Vector3d at(int node) const {
    return Eigen::Vector3d::Map(&nodes_[3 * std::size_t(node)]);
  }
  Eigen::Vector3d place(std::uint32_t vertex) const {
    const auto& v = mesh.vertices[vertex];
    return (1 - v.t) * at(v.i) + v.t * at(v.j);
  }

  std::uint32_t node(int i) { return vertex(i, i); }
  /// Where the outline crosses the line between two nodes.
  std::uint32_t crossing(int i, int j) { return i < j ? vertex(i, j) : vertex(j, i); }

  /// The part of a polygon of nodes that is material.
  template <class Nodes>
  Polygon clip(const Nodes& polygon) {
    Polygon out;
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; k < n; ++k) {
      const int i = polygon[k], j = polygon[(k + 1) % n];
      if (inside(i)) out.push_back(node(i));
      if (inside(i) != inside(j)) out.push_back(crossing(i, j));
    }
    return out;
  }

  void fan(const Polygon& p) {
    for (std::size_t k = 2; k < p.size(); ++k) mesh.triangles.push_back({p[0], p[k - 1], p[k]});
  }

  CutMesh mesh;

 private:
  std::uint32_t vertex(int i, int j) {
    const auto key = static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint32_t>(j);
    const auto [at, fresh] = known_.try_emplace(key, static_cast<std::uint32_t>(known_.size()));
    if (fresh) {
      const double a = i == j ? 0 : level_[std::size_t(i)], b = i == j ? 1 : level_[std::size_t(j)];
      mesh.vertices.push_back({i, j, i == j ? 0 : a / (a - b)});
    }
    return at->second;
  }

  const std::vector<double>&nodes_, &level_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

/// The area, and as its outline the sides of polygons that no other polygon has.
void cut_plane(Cutter& cutter, const std::vector<int>& cells) {
  std::set<std::array<std::uint32_t, 2>> sides;
  for (std::size_t c = 0; c < cells.size(); c += 4) {
    const Polygon p = cutter.clip(std::array{cells[c], cells[c + 1], cells[c + 2], cells[c + 3]});
    cutter.fan(p);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const auto a = p[k], b = p[(k + 1) % p.size()];
      if (!sides.erase({b, a})) sides.insert({a, b});
    }
  }
  cutter.mesh.sides.assign(sides.begin(), sides.end());
}

/// The side of material of a tetrahedron: its faces but those between two of them, and the cut.
class SurfaceOfTetrahedra {
 public:
  explicit SurfaceOfTetrahedra(Cutter& cutter) : cutter_(cutter) {}

  void add(const std::array<int, 4>& t) {
    const auto in = std::count_if(t.begin(), t.end(), [&](int i) { return cutter_.inside(i); });
    if (in == 0) return;
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<int, 3> face = {t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]};
      orient(face, t[k]);
      std::array<int, 3> key = face;
      std::sort(key.begin(), key.end());
      if (!faces_.erase(key)) faces_.emplace(key, face);
    }
    if (in < 4) add_cut(t);
  }

  void finish() {
    for (const auto& [key, face] : faces_) cutter_.fan(cutter_.clip(face));
  }

 private:
  /// Turned so that its normal points away from the fourth corner.
  void orient(std::array<int, 3>& face, int other) const {
    const Eigen::Vector3d a = cutter_.at(face[0]);
    const Eigen::Vector3d n = (cutter_.at(face[1]) - a).cross(cutter_.at(face[2]) - a);
    if (n.dot(cutter_.at(other) - a) > 0) std::swap(face[1], face[2]);
  }

  void add_cut(const std::array<int, 4>& t) {
    std::vector<int> in, out;
    for (const int i : t) (cutter_.inside(i) ? in : out).push_back(i);
    Polygon p;
    if (in.size() == 2) {
      p = {cutter_.crossing(in[0], out[0]), cutter_.crossing(in[0], out[1]),
           cutter_.crossing(in[1], out[1]), cutter_.crossing(in[1], out[0])};
    } else {
      for (const int i : in)
        for (const int o : out) p.push_back(cutter_.crossing(i, o));
    }
    const Eigen::Vector3d a = cutter_.place(p[0]);
    const Eigen::Vector3d n = (cutter_.place(p[1]) - a).cross(cutter_.place(p[2]) - a);
    if (n.dot(cutter_.at(in[0]) - a) > 0) std::reverse(p.begin(), p.end());
    cutter_.fan(p);
  }

  Cutter& cutter_;
  std::map<std::array<int, 3>, std::array<int, 3>> faces_;
};

void cut_space(Cutter& cutter, const std::vector<int>& cells) {
  // Six tetrahedra about the diagonal 0-6 of a hexahedron.
  static constexpr int kSplit[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                       {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  SurfaceOfTetrahedra surface(cutter);
  for (std::size_t c = 0; c < cells.size(); c += 8)
    for (const auto& t : kSplit)
      surface.add({cells[c + std::size_t(t[0])], cells[c + std::size_t(t[1])],
                   cells[c + std::size_t(t[2])], cells[c + std::size_t(t[3])]});
  surface.finish();
}

/// The triangles that a planar cell, or a side in space, is drawn as: local nodes.
std::vector<std::array<int, 3>> flat_pieces(const CellKind& kind) {
  switch (kind.nodes) {
    case 3:
      return {{0, 1, 2}};
    case 4:
      return {{0, 1, 2}, {0, 2, 3}};
    case 6:
      return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    default:
      return {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}};
  }
}

/// Sides of cells that no other cell has.
std::vector<CellSide> outer_sides(const CellKind& kind, const std::vector<int>& cells) {
  std::map<CellSide, CellSide> open;  // by sorted nodes
  for (std::size_t c = 0; c < cells.size(); c += std::size_t(kind.nodes))
    for (CellSide side : cell_sides(kind)) {
      for (int& node : side)
        if (node >= 0) node = cells[c + std::size_t(node)];
      CellSide key = side;
      std::sort(key.begin(), key.end());
      if (!open.erase(key)) open.emplace(key, side);
    }
  std::vector<CellSide> out;
  for (const auto& [key, side] : open) out.push_back(side);
  return out;
}

/// Without a level set.
void draw_whole(Cutter& cutter, const CellKind& kind, const std::vector<int>& cells) {
  const auto draw = [&cutter](const CellKind& flat, const int* nodes) {
    for (const auto& piece : flat_pieces(flat))
      cutter.fan({cutter.node(nodes[piece[0]]), cutter.node(nodes[piece[1]]),
                  cutter.node(nodes[piece[2]])});
  };
  for (std::size_t c = 0; kind.dim == 2 && c < cells.size(); c += std::size_t(kind.nodes))
    draw(kind, &cells[c]);
  for (const CellSide& side : outer_sides(kind, cells)) {
    if (kind.dim == 3) {
      draw(side_kind(kind), side.data());
      continue;
    }
    const bool bent = kind.order == 2;
    const auto a = cutter.node(side[0]), b = cutter.node(side[1]);
    const auto middle = bent ? cutter.node(side[2]) : b;
    cutter.mesh.sides.push_back({a, middle});
    if (bent) cutter.mesh.sides.push_back({middle, b});
  }
}

}  // namespace

CutMesh cut_mesh(const CellKind& kind, const std::vector<int>& cells,
                 const std::vector<double>& nodes, const std::vector<double>& level) {
  Cutter cutter(nodes, level);
  if (kind.family == CellFamily::Cube && kind.order == 1)
    kind.dim == 2 ? cut_plane(cutter, cells) : cut_space(cutter, cells);
  else
    draw_whole(cutter, kind, cells);
  return std::move(cutter.mesh);
}

const CellKind& stored_cells(std::string_view name, int nodes) {
  for (const CellKind& kind : cell_kinds())
    if (kind.name == name) return kind;
  return cell_kind(nodes == 4 ? 2 : 3, nodes);
}

}  // namespace liesl::output
