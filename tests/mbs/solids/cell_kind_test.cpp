#include "mbs/solids/cell_kind.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <set>
#include <stdexcept>

namespace liesl::test::cell_kind_test {
namespace {

using Eigen::Vector3d;

/// Points of the reference cell, some of them inside.
std::vector<Vector3d> places(const CellKind& kind) {
  std::vector<Vector3d> out = {reference_centre(kind)};
  for (int n = 0; n < kind.nodes; ++n) out.push_back(0.3 * out[0] + 0.7 * reference_node(kind, n));
  return out;
}

TEST(CellKind, FunctionsAreOneAtTheirNodeAndZeroAtTheOthers) {
  for (const CellKind& kind : cell_kinds())
    for (int n = 0; n < kind.nodes; ++n) {
      const CellFunctions f = cell_functions(kind, reference_node(kind, n));
      EXPECT_LT((f.N - Eigen::VectorXd::Unit(kind.nodes, n)).cwiseAbs().maxCoeff(), 1e-15)
          << kind.name << " " << n;
    }
}

/// Linear fields are met exactly, of order 2 quadratic ones; gradients are those of the values.
TEST(CellKind, FunctionsGiveBackPolynomialsOfTheirOrder) {
  for (const CellKind& kind : cell_kinds()) {
    const auto field = [&](const Vector3d& x) {
      const Vector3d b(0.3, -0.7, 1.1);
      const double linear = 0.2 + b.head(kind.dim).dot(x.head(kind.dim));
      return kind.order == 1 ? linear : linear * linear;
    };
    for (const Vector3d& xi : places(kind)) {
      const CellFunctions f = cell_functions(kind, xi);
      double value = 0;
      for (int n = 0; n < kind.nodes; ++n) value += f.N[n] * field(reference_node(kind, n));
      EXPECT_NEAR(value, field(xi), 1e-14) << kind.name;
      for (int a = 0; a < kind.dim; ++a) {
        const Vector3d h = 1e-6 * Vector3d::Unit(a);
        const auto up = cell_functions(kind, xi + h).N, down = cell_functions(kind, xi - h).N;
        EXPECT_LT((f.dN.row(a).transpose() - (up - down) / 2e-6).cwiseAbs().maxCoeff(), 1e-9)
            << kind.name;
      }
    }
  }
}

double factorial(int n) { return std::tgamma(n + 1.0); }

/// int x^i y^j z^k over the reference cell.
double exact(const CellKind& kind, const std::array<int, 3>& power) {
  if (kind.family == CellFamily::Simplex)
    return factorial(power[0]) * factorial(power[1]) * factorial(power[2]) /
           factorial(power[0] + power[1] + power[2] + kind.dim);
  double product = 1;
  for (int a = 0; a < kind.dim; ++a) product *= power[a] % 2 ? 0 : 2.0 / (power[a] + 1);
  return product;
}

TEST(CellKind, QuadratureIsExactToTheDegreeThatItIsFor) {
  for (const CellKind& kind : cell_kinds())
    for (const QuadratureUse use : {QuadratureUse::Stiffness, QuadratureUse::Mass}) {
      const bool mass = use == QuadratureUse::Mass;
      const int degree = mass ? 2 * kind.order : 2 * (kind.order - 1);
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree && (j == 0 || kind.dim > 1); ++j)
          for (int k = 0; i + j + k <= degree && (k == 0 || kind.dim > 2); ++k) {
            double sum = 0;
            for (const QuadraturePoint& p : cell_quadrature(kind, use))
              sum += p.weight * std::pow(p.xi[0], i) * std::pow(p.xi[1], j) * std::pow(p.xi[2], k);
            EXPECT_NEAR(sum, exact(kind, {i, j, k}), 4e-15)
                << kind.name << " " << i << j << k << (mass ? " mass" : " stiffness");
          }
    }
}

/// Nodes of a side lie in a plane that all others are below of.
TEST(CellKind, SidesHoldTheNodesOfOneFace) {
  for (const CellKind& kind : cell_kinds()) {
    if (kind.dim == 1) continue;
    const CellKind& of_side = side_kind(kind);
    EXPECT_EQ(of_side.dim, kind.dim - 1);
    for (const CellSide& side : cell_sides(kind)) {
      std::vector<Vector3d> x;
      for (const int n : side)
        if (n >= 0) x.push_back(reference_node(kind, n));
      ASSERT_EQ(static_cast<int>(x.size()), of_side.nodes) << kind.name;
      const Vector3d along = x[1] - x[0];
      const Vector3d normal =
          kind.dim == 2 ? Vector3d(along[1], -along[0], 0) : Vector3d(along.cross(x[2] - x[0]));
      const std::set<int> own(side.begin(), side.end());
      int below = 0;
      for (int n = 0; n < kind.nodes; ++n) {
        const double distance = normal.dot(reference_node(kind, n) - x[0]);
        EXPECT_EQ(std::abs(distance) < 1e-14, own.contains(n)) << kind.name << " " << n;
        below += distance < -1e-14;
      }
      EXPECT_EQ(below, kind.nodes - of_side.nodes) << kind.name << ": its normal points inwards";
      // The functions of the side are those of the cell there.
      const Vector3d xi = places(of_side).back();
      const CellFunctions f = cell_functions(of_side, xi);
      Vector3d at = Vector3d::Zero();
      for (int i = 0; i < of_side.nodes; ++i) at += f.N[i] * x[std::size_t(i)];
      const CellFunctions g = cell_functions(kind, at);
      for (int i = 0; i < of_side.nodes; ++i)
        EXPECT_NEAR(f.N[i], g.N[side[std::size_t(i)]], 1e-14) << kind.name;
    }
  }
}

/// Edges as Gmsh's manual draws them (node ordering): of Tetrahedron10 and Hexahedron20.
TEST(CellKind, NodesAtEdgesAreWhereGmshHasThem) {
  const std::vector<std::array<int, 2>> tetrahedron = {{0, 1}, {1, 2}, {0, 2},
                                                       {0, 3}, {2, 3}, {1, 3}};
  const std::vector<std::array<int, 2>> hexahedron = {{0, 1}, {0, 3}, {0, 4}, {1, 2},
                                                      {1, 5}, {2, 3}, {2, 6}, {3, 7},
                                                      {4, 5}, {4, 7}, {5, 6}, {6, 7}};
  for (const int nodes : {10, 20}) {
    const CellKind& kind = cell_kind(3, nodes);
    const auto& edges = nodes == 10 ? tetrahedron : hexahedron;
    for (int n = 0; n < kind.nodes; ++n) {
      const int at = gmsh_order(kind)[std::size_t(n)];
      const Vector3d there =
          at < kind.corners
              ? reference_node(kind, at)
              : Vector3d((reference_node(kind, edges[std::size_t(at - kind.corners)][0]) +
                          reference_node(kind, edges[std::size_t(at - kind.corners)][1])) /
                         2);
      EXPECT_EQ(there, reference_node(kind, n)) << kind.name << " " << n;
    }
  }
}

TEST(CellKind, NumbersOfNodesThatNoKindHasAreRefused) {
  EXPECT_THROW(cell_kind(3, 6), std::invalid_argument);
  EXPECT_THROW(cell_kind(2, 10), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::cell_kind_test
