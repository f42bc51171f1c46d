#include "mbs/solids/volume_fraction.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "mbs/levelset/dual.hpp"
#include "mbs/levelset/simplex.hpp"

namespace liesl {
namespace {

using Eigen::Vector3d;
using levelset::Dual;

constexpr double kDistanceFactor = 2;  // half diagonals that phi may be wrong by

/// One simplex of the sub-grid of the reference cell.
struct Piece {
  std::array<int, 4> node;
};

/// The sub-grid of a reference cell: its nodes as weights of the corners, its simplices.
struct SubGrid {
  Eigen::MatrixXd weights;  ///< corners x nodes
  std::vector<Piece> pieces;

  SubGrid(int dim, int s) {
    const int m = s + 1, layers = dim == 2 ? 1 : m;
    weights.resize(dim == 2 ? 4 : 8, static_cast<Eigen::Index>(m) * m * layers);
    for (int k = 0, n = 0; k < layers; ++k)
      for (int j = 0; j < m; ++j)
        for (int i = 0; i < m; ++i, ++n)
          weights.col(n) =
              corner_functions(dim, Vector3d(2.0 * i / s - 1, 2.0 * j / s - 1, 2.0 * k / s - 1)).N;
    for (int k = 0; k < (dim == 2 ? 1 : s); ++k)
      for (int j = 0; j < s; ++j)
        for (int i = 0; i < s; ++i) add_pieces(dim, m, i, j, k);
  }

 private:
  void add_pieces(int dim, int m, int i, int j, int k) {
    const auto node = [&](int c) {
      return ((k + c / 4) * m + j + c / 2 % 2) * m + i + (c + 1) / 2 % 2;
    };
    if (dim == 2)
      for (const auto& t : levelset::kTriangles[(i + j) % 2])
        pieces.push_back({{node(t[0]), node(t[1]), node(t[2]), 0}});
    else
      for (const auto& t : levelset::kTetrahedra[(i + j + k) % 2])
        pieces.push_back({{node(t[0]), node(t[1]), node(t[2]), node(t[3])}});
  }
};

struct CellShare {
  double value = 0;
  Eigen::VectorXd derivative;  ///< empty: zero
};

class Mapping {
 public:
  Mapping(const SolidMesh& mesh, const levelset::LevelSet& shape, int subdivisions)
      : mesh_(mesh), shape_(shape), grid_(mesh.dim, subdivisions), at_node_(mesh.node_count()) {
    tbb::parallel_for(0, mesh.node_count(),
                      [&](int i) { at_node_[i] = shape.value(mesh.nodes.col(i)); });
  }

  CellShare share(int cell) const {
    const Eigen::Matrix3Xd x = mesh_.corners_of(cell);
    const Vector3d centre = x.rowwise().mean();
    Vector3d slope;
    const double phi = shape_.evaluate(centre, slope, nullptr);
    const double half = std::sqrt((x.colwise() - centre).colwise().squaredNorm().maxCoeff());
    bool agree = std::abs(phi) > kDistanceFactor * half * slope.norm();
    for (int c = 0; agree && c < mesh_.corners(); ++c)
      agree = (at_node_[mesh_.cells(c, cell)] >= 0) == (phi >= 0);
    if (agree) return {phi >= 0 ? 1.0 : 0.0, {}};
    return mesh_.dim == 2 ? cut<3>(x) : cut<4>(x);
  }

 private:
  template <int Corners>
  static double volume(const Eigen::Matrix3Xd& x, const Piece& p) {
    const Vector3d o = x.col(p.node[0]), a = x.col(p.node[1]) - o, b = x.col(p.node[2]) - o;
    if constexpr (Corners == 3)
      return (a[0] * b[1] - a[1] * b[0]) / 2;
    else
      return a.dot(b.cross(Vector3d(x.col(p.node[3]) - o))) / 6;
  }

  template <int Corners>
  CellShare cut(const Eigen::Matrix3Xd& corners) const {
    const Eigen::Matrix3Xd x = corners * grid_.weights;
    Eigen::VectorXd phi(x.cols()), weight = Eigen::VectorXd::Zero(x.cols());
    for (Eigen::Index i = 0; i < x.cols(); ++i) phi[i] = shape_.value(x.col(i));
    double filled = 0, whole = 0;
    for (const Piece& p : grid_.pieces) {
      std::array<Dual<Corners>, Corners> f;
      for (int i = 0; i < Corners; ++i) f[i] = Dual<Corners>::variable(phi[p.node[i]], i);
      const Dual<Corners> s = levelset::positive_share<Dual<Corners>, Corners>(f);
      const double v = volume<Corners>(x, p);
      whole += v;
      filled += s.v * v;
      for (int i = 0; i < Corners; ++i) weight[p.node[i]] += s.d[i] * v;
    }
    return {filled / whole, chain(x, weight / whole)};
  }

  /// sum_nodes d share/d phi * d phi/dp; only nodes next to the outline have a weight.
  Eigen::VectorXd chain(const Eigen::Matrix3Xd& x, const Eigen::VectorXd& weight) const {
    Eigen::VectorXd total, dp(shape_.size());
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      if (weight[i] == 0) continue;
      Vector3d dx;
      shape_.evaluate(x.col(i), dx, dp.data());
      if (total.size() == 0) total = Eigen::VectorXd::Zero(shape_.size());
      total += weight[i] * dp;
    }
    return total;
  }

  const SolidMesh& mesh_;
  const levelset::LevelSet& shape_;
  SubGrid grid_;
  std::vector<double> at_node_;
};

}  // namespace

bool takes_outline(const SolidMesh& mesh) {
  return mesh.kind().family == CellFamily::Cube && mesh.kind().order == 1;
}

Fractions volume_fractions(const SolidMesh& mesh, const levelset::LevelSet& shape,
                           int subdivisions) {
  if (!takes_outline(mesh))
    throw std::invalid_argument("cells of kind '" + std::string(mesh.kind().name) +
                                "' cannot be cut by an outline");
  const Mapping mapping(mesh, shape, subdivisions > 0 ? subdivisions : (mesh.dim == 2 ? 4 : 3));
  std::vector<CellShare> shares(mesh.cell_count());
  tbb::parallel_for(0, mesh.cell_count(), [&](int cell) { shares[cell] = mapping.share(cell); });
  Fractions f{Eigen::VectorXd(mesh.cell_count()),
              FractionGradient(mesh.cell_count(), shape.size())};
  std::vector<Eigen::Triplet<double>> entries;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    f.value[cell] = shares[cell].value;
    const Eigen::VectorXd& d = shares[cell].derivative;
    for (Eigen::Index j = 0; j < d.size(); ++j)
      if (d[j] != 0) entries.emplace_back(cell, static_cast<int>(j), d[j]);
  }
  f.derivative.setFromTriplets(entries.begin(), entries.end());
  return f;
}

}  // namespace liesl
