#include "mbs/solids/nodal_matrices.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>
#include <stdexcept>

#include "mbs/solids/meshes.hpp"
#include "mbs/solids/reduction.hpp"

namespace liesl::test::nodal_matrices_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

const Material kSteel{"steel", 210e9, 0.3, 7850};

Sparse both_triangles(const Sparse& lower) { return lower.selfadjointView<Eigen::Lower>(); }

struct Part {
  SolidMesh mesh;
  NodalMatrices matrices;
  std::vector<Interface> interfaces;
};

Part part(int dim, Tie tie) {
  Part p;
  p.mesh = in_cells(dim == 2 ? quad_grid({0, 0}, {0.3, 0.05}, 12, 3)
                             : hex_grid({0, 0, 0}, {0.3, 0.05, 0.04}, 6, 2, 2),
                    cell_kind(dim, dim == 2 ? 4 : 10));
  const SolidModel free(p.mesh, kSteel, {}, {});
  const VectorXd v = VectorXd::Ones(p.mesh.cell_count());
  p.matrices = {both_triangles(free.stiffness(v)), both_triangles(free.mass(v))};
  p.interfaces = {{"left", p.mesh.sets.at("x_min"), {0, 0.02, 0}, tie},
                  {"right", p.mesh.sets.at("x_max"), {0.3, 0.03, 0}, tie}};
  return p;
}

/// A part of the matrices of a mesh is reduced to the same matrices and integrals as the mesh.
TEST(NodalMatrices, OfAMeshAreReducedAsTheMeshIs) {
  for (const int dim : {2, 3})
    for (const Tie tie : {Tie::Rigid, Tie::Averaged}) {
      const Part p = part(dim, tie);
      const SolidModel mesh(p.mesh, kSteel, p.interfaces, {}),
          given(p.mesh, p.matrices, p.interfaces);
      const VectorXd v = VectorXd::Ones(p.mesh.cell_count()), none;
      EXPECT_EQ(given.mesh().cell_count(), 0);
      EXPECT_NEAR(given.total_mass(none) / mesh.total_mass(v), 1, 1e-13);
      const ReducedSolid a = reduce(mesh, v, ReductionKind::CraigBampton, 6),
                         b = reduce(given, none, ReductionKind::CraigBampton, 6);
      ASSERT_TRUE(a.converged && b.converged);
      EXPECT_LT((a.K.diagonal() - b.K.diagonal()).norm(), 1e-11 * a.K.norm());
      EXPECT_LT((a.M.diagonal() - b.M.diagonal()).norm(), 1e-10 * a.M.norm());
      EXPECT_LT((a.frequencies - b.frequencies).norm(), 1e-11 * a.frequencies.norm());
      EXPECT_NEAR(a.inertia.mass, b.inertia.mass, 1e-13 * a.inertia.mass);
      EXPECT_LT((a.inertia.first - b.inertia.first).norm(), 1e-13 * a.inertia.first.norm());
      EXPECT_LT((a.inertia.second - b.inertia.second).norm(), 1e-13 * a.inertia.second.norm());
      EXPECT_LT((a.inertia.mode.leftCols(6) - b.inertia.mode.leftCols(6)).norm(),
                1e-11 * a.inertia.mode.norm());
    }
}

TEST(NodalMatrices, WhatIsNoFreeSolidIsRefusedWithItsReason) {
  const auto reason = [](const auto& change) {
    Part p = part(3, Tie::Rigid);
    change(p.matrices);
    try {
      require_free_part(p.mesh, p.matrices);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto has = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  EXPECT_EQ(reason([](NodalMatrices&) {}), "");
  EXPECT_TRUE(
      has(reason([](auto& m) { m.K.coeffRef(0, 7) += 1e6; }), "stiffness matrix is not symmetric"));
  EXPECT_TRUE(
      has(reason([](auto& m) { m.M.coeffRef(0, 3) += 1e-3; }), "mass matrix is not symmetric"));
  EXPECT_TRUE(
      has(reason([](auto& m) { m.K.conservativeResize(9, 9); }), "stiffness matrix is 9 x 9"));
  EXPECT_TRUE(has(reason([](auto& m) { m.M.conservativeResize(9, 9); }), "mass matrix is 9 x 9"));
  EXPECT_TRUE(
      has(reason([](auto& m) { m.K.coeffRef(4, 4) = std::numeric_limits<double>::quiet_NaN(); }),
          "not finite at (5, 5)"));
  EXPECT_TRUE(has(reason([](auto& m) { m.K.coeffRef(4, 4) *= 1.01; }), "a rigid displacement"));
  // Springs between x alone, so that displacements take no forces but rotations do.
  EXPECT_TRUE(has(reason([](auto& m) {
                    for (const auto& [i, j, k] :
                         {std::tuple(0, 30, -1e9), {30, 0, -1e9}, {0, 0, 1e9}, {30, 30, 1e9}})
                      m.K.coeffRef(i, j) += k;
                  }),
                  "a rigid rotation"));
  EXPECT_TRUE(has(reason([](auto& m) { m.M.coeffRef(4, 4) *= 1.01; }), "not that of a rigid body"));
  EXPECT_TRUE(has(reason([](auto& m) {
                    m.M.coeffRef(4, 5) += 1e-3;
                    m.M.coeffRef(5, 4) += 1e-3;
                  }),
                  "not that of a rigid body"));
  EXPECT_TRUE(has(reason([](auto& m) { m.M *= -1; }), "no positive mass"));
}

TEST(NodalMatrices, AStiffnessOfNegativeEnergyIsRefused) {
  const auto reason = [](const auto& change) {
    Part p = part(3, Tie::Rigid);
    change(p.matrices.K);
    require_free_part(p.mesh, p.matrices);  // rigid motions take no forces
    try {
      require_positive_stiffness(p.matrices);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(reason([](auto&) {}), "");
  EXPECT_NE(reason([](auto& K) { K *= -1; }).find("diagonal of positive numbers"),
            std::string::npos);
  // Less than K by more than its softest displacement takes, on the diagonal still positive.
  EXPECT_NE(reason([](auto& K) {
              Eigen::MatrixXd full = K;
              const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(full);
              const Eigen::VectorXd soft = modes.eigenvectors().col(6);
              full -= 2 * modes.eigenvalues()[6] * soft * soft.transpose();
              K = full.sparseView();
            }).find("not positive semidefinite"),
            std::string::npos);
}

}  // namespace
}  // namespace liesl::test::nodal_matrices_test
