#pragma once
/// @file
/// Equilibrium of a meshed part whose nodes all move, under forces on its nodes: Newton's method
/// about its forces and tangent alone.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "mbs/bodies/continuum.hpp"
#include "mbs/linalg/sparse_lu.hpp"
#include "mbs/solids/solid_model.hpp"

namespace liesl::test {

/// Its one interface, which a part must have, is the average of its side "x_min" and carries
/// nothing.
template <FrameGroup G>
struct NodalStatics {
  static constexpr int sd = G::space_dim, dim = G::dim;
  using Points = typename ContinuumBody<G>::Points;

  ContinuumBody<G> body;
  std::vector<G> H;  ///< of the nodes of the body
  Points force;      ///< on the nodes of the mesh, inertial, N

  /// @param free nodes of the mesh that may move
  NodalStatics(const SolidMesh& mesh, const Material& material, SolidLaw law, double thickness,
               const std::vector<int>& free)
      : body("part", part(mesh, material, law, thickness), {port(mesh)}, Mat3::Identity()),
        H(body.reference),
        force(Points::Zero(sd, mesh.node_count())),
        row_(std::size_t(body.size()), -1) {
    const auto add = [this](int first, int count) {
      for (int a = 0; a < count; ++a) {
        row_[std::size_t(first + a)] = int(columns_.size());
        columns_.push_back(first + a);
      }
    };
    add(0, dim);
    for (const int i : free) add(dim * body.node_of(i), sd);
  }
  auto& place(int mesh_node) { return H[std::size_t(body.node_of(mesh_node))].x; }
  Points places() const {
    Points x;
    body.positions(H.data(), x);
    return x;
  }
  /// Until a correction is at round-off. @param size of the part, m
  void solve(double size) {
    constexpr int kMost = 40;
    constexpr double kRoundOff = 1e-13;
    double step = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMost && step > kRoundOff * size; ++i) step = correct();
    EXPECT_LE(step, kRoundOff * size);
  }

 private:
  static G port(const SolidMesh& mesh) {
    G H = G::identity();
    H.x = mesh.nodes.col(0).template head<sd>();
    return H;
  }
  static SolidSpec part(const SolidMesh& mesh, const Material& material, SolidLaw law,
                        double thickness) {
    SolidSpec s;
    s.model = std::make_shared<const SolidModel>(
        mesh, material,
        std::vector<Interface>{{"side", mesh.sets.at("x_min"), mesh.nodes.col(0), Tie::Averaged}},
        SolidModel::Options{thickness, {}});
    s.as = SolidMotion::Continuum;
    s.law = law;
    return s;
  }
  /// Largest displacement of one correction, m.
  double correct() {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(body.size());
    const BodyState<G> s{H.data(), still.data(), still.data(), still.data()};
    Eigen::VectorXd r = still;
    ForceScale scale;
    body.add_internal(s, r.data(), scale);
    for (int i = 0; i < force.cols(); ++i) r.segment<sd>(dim * body.node_of(i)) -= force.col(i);
    auto K = body.stiffness();
    body.exact_tangent(s, Body<G>::Vector::Zero(), {}, nullptr, K);
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < K.sparse.outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(K.sparse, j); it; ++it)
        if (const int row = row_[std::size_t(it.row())], column = row_[std::size_t(it.col())];
            row >= 0 && column >= 0)
          entries.emplace_back(row, column, it.value());
    const auto n = Eigen::Index(columns_.size());
    Eigen::SparseMatrix<double> of_free(n, n);
    of_free.setFromTriplets(entries.begin(), entries.end());
    SparseLu lu;
    if (!lu.factor(of_free)) return std::numeric_limits<double>::infinity();
    Eigen::VectorXd step = -r(columns_);
    lu.solve(step);
    H[0] = H[0] * G::exp(step.head<dim>());
    for (std::size_t i = dim; i < columns_.size(); i += sd)
      H[std::size_t(columns_[i] / dim)].x += step.segment<sd>(Eigen::Index(i));
    return step.lpNorm<Eigen::Infinity>();
  }

  std::vector<int> row_, columns_;  ///< of unknowns of the body: number among the free ones, back
};

}  // namespace liesl::test
