#include "mbs/levelset/zero_level.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>

#include "mbs/levelset/simplex.hpp"

namespace liesl::levelset {
namespace {

using Eigen::Vector3d;

/// Values of min(phi, distance to the box) on a grid with one square of margin all round, so that
/// the outline closes along the box.
class Grid {
 public:
  Grid(const LevelSet& shape, const Box& box, std::array<int, 3> cells, int dim)
      : shape_(shape), box_(box), dim_(dim) {
    step_.setZero();
    for (int i = 0; i < 3; ++i) {
      count_[i] = i < dim ? cells[i] + 3 : 1;
      if (i < dim) step_[i] = (box.to[i] - box.from[i]) / cells[i];
    }
    values_.resize(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2]);
    for (std::size_t n = 0; n < values_.size(); ++n) values_[n] = clipped(node(n));
  }

  int cells(int i) const { return std::max(count_[i] - 1, 1); }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * count_[1] + j) * count_[0] + i;
  }
  double value(std::size_t n) const { return values_[n]; }

  /// The zero of phi next to the zero of its linear interpolation between two nodes.
  Vector3d crossing(std::size_t a, std::size_t b) const {
    const double t = values_[a] / (values_[a] - values_[b]);
    return onto_zero(node(a) + t * (node(b) - node(a)));
  }

 private:
  Vector3d node(std::size_t n) const {
    const auto nx = static_cast<std::size_t>(count_[0]), ny = static_cast<std::size_t>(count_[1]);
    Vector3d x = box_.from;
    const std::array<std::size_t, 3> ijk = {n % nx, n / nx % ny, n / nx / ny};
    for (int i = 0; i < dim_; ++i) x[i] += (static_cast<double>(ijk[i]) - 1) * step_[i];
    if (dim_ == 2) x[2] = 0;
    return x;
  }

  double to_box(const Vector3d& x, Vector3d& dx) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < dim_; ++i) {
      if (x[i] - box_.from[i] < least) least = x[i] - box_.from[i], dx = Vector3d::Unit(i);
      if (box_.to[i] - x[i] < least) least = box_.to[i] - x[i], dx = -Vector3d::Unit(i);
    }
    return least;
  }

  double clipped(const Vector3d& x) const {
    Vector3d dx;
    return std::min(shape_.value(x), to_box(x, dx));
  }

  Vector3d onto_zero(const Vector3d& start) const {
    Vector3d x = start;
    const double radius = step_.norm();
    for (int k = 0; k < 20; ++k) {
      Vector3d g, gb;
      double phi = shape_.evaluate(x, g, nullptr);
      const double b = to_box(x, gb);
      if (b < phi) phi = b, g = gb;
      if (dim_ == 2) g[2] = 0;
      const double slope = g.squaredNorm();
      if (!(slope > 0)) return start;
      const Vector3d move = phi / slope * g;
      x -= move;
      if ((x - start).norm() > radius) return start;  // no zero near: a kink between the nodes
      if (move.norm() < 1e-15 * (x.norm() + radius)) break;
    }
    return x;
  }

  const LevelSet& shape_;
  Box box_;
  int dim_;
  Vector3d step_;
  std::array<int, 3> count_;
  std::vector<double> values_;
};

/// Points on grid edges, each made once.
class EdgePoints {
 public:
  explicit EdgePoints(const Grid& grid) : grid_(grid) {}
  int at(std::size_t a, std::size_t b) {
    const auto [it, fresh] =
        number_.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
    if (fresh) points.push_back(grid_.crossing(a, b));
    return it->second;
  }
  std::vector<Vector3d> points;

 private:
  const Grid& grid_;
  std::map<std::pair<std::size_t, std::size_t>, int> number_;
};

/// One segment a triangle, material on its left: from the edge where the boundary of the positive
/// part leaves to the edge where it comes back.
void cut_triangle(const Grid& grid, const std::array<std::size_t, 3>& n, EdgePoints& edges,
                  std::unordered_map<int, int>& next) {
  int out = -1, in = -1;
  for (int i = 0; i < 3; ++i) {
    const std::size_t a = n[i], b = n[(i + 1) % 3];
    const bool pa = grid.value(a) >= 0, pb = grid.value(b) >= 0;
    if (pa && !pb) out = edges.at(a, b);
    if (!pa && pb) in = edges.at(a, b);
  }
  if (out >= 0) next[out] = in;
}

/// One or two triangles a tetrahedron, normals towards negative values.
void cut_tetrahedron(const Grid& grid, const std::array<std::size_t, 4>& n, EdgePoints& edges,
                     std::vector<std::array<int, 3>>& triangles) {
  std::array<int, 4> order = {0, 1, 2, 3};
  std::stable_partition(order.begin(), order.end(), [&](int i) { return grid.value(n[i]) >= 0; });
  const auto positive =
      std::count_if(n.begin(), n.end(), [&](std::size_t i) { return grid.value(i) >= 0; });
  if (positive == 0 || positive == 4) return;
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
  const bool even = inversions % 2 == 0;
  const auto e = [&](int i, int j) { return edges.at(n[order[i]], n[order[j]]); };
  const auto emit = [&](int a, int b, int c) {
    triangles.push_back(even ? std::array{a, b, c} : std::array{a, c, b});
  };
  // Order (0 1 2 3) of positive volume: 1 -> 2 -> 3 runs counter-clockwise seen from 0's far side.
  if (positive == 1) {
    emit(e(0, 1), e(0, 2), e(0, 3));
  } else if (positive == 3) {
    emit(e(3, 0), e(3, 1), e(3, 2));
  } else {
    const int ac = e(0, 2), ad = e(0, 3), bc = e(1, 2), bd = e(1, 3);
    emit(ac, ad, bd);
    emit(ac, bd, bc);
  }
}

std::vector<Polyline> chain(const std::vector<Vector3d>& points,
                            const std::unordered_map<int, int>& next) {
  std::vector<Polyline> lines;
  std::vector<bool> seen(points.size(), false);
  for (int first = 0; first < static_cast<int>(points.size()); ++first) {
    if (seen[first]) continue;
    Polyline line;
    for (int i = first; !seen[i];) {
      seen[i] = true;
      const Eigen::Vector2d x = points[i].head<2>();
      if (line.points.empty() || (line.points.back() - x).norm() > 0) line.points.push_back(x);
      const auto it = next.find(i);
      if (it == next.end()) {
        line.closed = false;
        break;
      }
      i = it->second;
    }
    if (line.points.size() > 2) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::vector<Polyline> outline(const LevelSet& shape, const Box& box, int nx, int ny) {
  const Grid grid(shape, box, {nx, ny, 0}, 2);
  EdgePoints edges(grid);
  std::unordered_map<int, int> next;
  for (int j = 0; j < grid.cells(1); ++j) {
    for (int i = 0; i < grid.cells(0); ++i) {
      const std::array<std::size_t, 4> square = {grid.index(i, j, 0), grid.index(i + 1, j, 0),
                                                 grid.index(i + 1, j + 1, 0),
                                                 grid.index(i, j + 1, 0)};
      for (const auto& t : kTriangles[(i + j) % 2])
        cut_triangle(grid, {square[t[0]], square[t[1]], square[t[2]]}, edges, next);
    }
  }
  return chain(edges.points, next);
}

Surface surface(const LevelSet& shape, const Box& box, int nx, int ny, int nz) {
  const Grid grid(shape, box, {nx, ny, nz}, 3);
  EdgePoints edges(grid);
  Surface s;
  for (int k = 0; k < grid.cells(2); ++k) {
    for (int j = 0; j < grid.cells(1); ++j) {
      for (int i = 0; i < grid.cells(0); ++i) {
        std::array<std::size_t, 8> cube;
        for (int c = 0; c < 8; ++c)
          cube[c] = grid.index(i + ((c + 1) / 2 % 2), j + (c / 2 % 2), k + c / 4);
        for (const auto& t : kTetrahedra[(i + j + k) % 2])
          cut_tetrahedron(grid, {cube[t[0]], cube[t[1]], cube[t[2]], cube[t[3]]}, edges,
                          s.triangles);
      }
    }
  }
  s.points.resize(3, static_cast<Eigen::Index>(edges.points.size()));
  for (std::size_t i = 0; i < edges.points.size(); ++i)
    s.points.col(static_cast<Eigen::Index>(i)) = edges.points[i];
  return s;
}

double enclosed_area(const Polyline& line) {
  double area = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const auto& a = line.points[i];
    const auto& b = line.points[(i + 1) % line.points.size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return area;
}

double enclosed_volume(const Surface& surface) {
  double volume = 0;
  for (const auto& t : surface.triangles) {
    const Vector3d a = surface.points.col(t[0]), b = surface.points.col(t[1]);
    volume += a.dot(b.cross(Vector3d(surface.points.col(t[2])))) / 6;
  }
  return volume;
}

}  // namespace liesl::levelset
