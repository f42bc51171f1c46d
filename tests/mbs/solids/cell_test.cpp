#include "mbs/solids/cell.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cctype>

#include "mbs/solids/interface_map.hpp"
#include "mbs/solids/meshes.hpp"
#include "mbs/solids/reduction.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl::test::cell_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Material kMaterial{"test", 1000, 0.3, 2};

/// (dim, nodes) of each kind of cell.
class Kind : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  const CellKind& kind() const { return cell_kind(GetParam().first, GetParam().second); }
};

TEST_P(Kind, CellHasExactlyTheRigidMotionsAsZeroEnergyModes) {
  const int dim = kind().dim, rigid = dim == 2 ? 3 : 6;
  const SolidMesh mesh = distorted(kind());
  for (int e = 0; e < mesh.cell_count(); ++e) {
    const CellMatrices cell = cell_matrices(dim, mesh.nodes_of(e), kMaterial, 0.1);
    MatrixXd R(cell.K.rows(), rigid);
    for (int c = 0; c < mesh.nodes_per_cell(); ++c)
      R.middleRows(dim * c, dim) =
          rigid_displacement(dim, mesh.nodes_of(e).col(c), Vector3d(0.3, 0.1, 0));
    EXPECT_LT((cell.K * R).cwiseAbs().maxCoeff(), 1e-11 * cell.K.cwiseAbs().maxCoeff());
    const VectorXd lambda = Eigen::SelfAdjointEigenSolver<MatrixXd>(cell.K).eigenvalues();
    EXPECT_GT(lambda[rigid], 1e-4 * lambda[lambda.size() - 1]);
    EXPECT_NEAR(cell.M.sum(), 2 * cell.volume, 1e-14);
    EXPECT_NEAR(cell.volume, mesh.cell_size(e) * (dim == 2 ? 0.1 : 1), 1e-15);
  }
}

/// Patch test: a linear displacement on the boundary gives it inside, with constant stress.
TEST_P(Kind, PatchTest) {
  const int dim = kind().dim;
  const SolidMesh mesh = distorted(kind());
  SolidModel::Options options;
  options.thickness = 0.1;
  SolidModel model(mesh, kMaterial, {}, options);
  MatrixXd F = MatrixXd::Zero(3, 3);
  F.topLeftCorner(dim, dim) << (dim == 2 ? (MatrixXd(2, 2) << 1e-3, 2e-3, -5e-4, 3e-3).finished()
                                         : (MatrixXd(3, 3) << 1e-3, 2e-3, 1e-4, -5e-4, 3e-3, 7e-4,
                                            2e-4, 9e-4, -1e-3)
                                               .finished());
  VectorXd linear(model.size());
  SolidSupport boundary;
  for (int i = 0; i < mesh.node_count(); ++i) {
    const Vector3d x = mesh.nodes.col(i);
    linear.segment(dim * i, dim) = (F * x).head(dim);
    for (int a = 0; !inside(mesh, i) && a < dim; ++a) boundary.fixed.push_back(dim * i + a);
  }
  // u = linear + w with w = 0 on the boundary: K w = -K linear must give w = 0.
  const VectorXd v = VectorXd::Ones(mesh.cell_count());
  const MatrixXd f = -(model.stiffness(v).selfadjointView<Eigen::Lower>() * linear);
  SolidStatics statics(model, boundary, {});
  statics.set_loads(f);
  ASSERT_EQ(statics.solve(v), SolidStatus::Solved);
  EXPECT_LT(statics.q().cwiseAbs().maxCoeff(), 1e-13);
  const MatrixXd eps = 0.5 * (F + F.transpose());
  VectorXd first;
  for (int e = 0; e < mesh.cell_count(); ++e) {
    VectorXd u(dim * mesh.nodes_per_cell());
    for (int c = 0; c < mesh.nodes_per_cell(); ++c)
      u.segment(dim * c, dim) = linear.segment(model.freedom(e, c), dim);
    const VectorXd sigma = model.cell(e).stress * u;
    if (e == 0) first = sigma;
    EXPECT_LT((sigma - first).norm(), 1e-12 * first.norm());
  }
  const double shear = kMaterial.G() * 2 * eps(0, 1);
  EXPECT_NEAR(first[dim == 2 ? 2 : 3], shear, 1e-12);
}

/// Of a box, whatever its cells: mass, first and second moments; and the loads of a traction.
TEST_P(Kind, InertiaAndTractionOfABoxAreExact) {
  const int dim = kind().dim;
  const Vector3d size(2, 1, dim == 2 ? 0 : 1);
  const double depth = dim == 2 ? 0.1 : 1, area = dim == 2 ? 0.1 : 1;
  SolidModel::Options options;
  options.thickness = 0.1;
  const SolidModel model(distorted(kind()), kMaterial, {}, options);
  const VectorXd v = VectorXd::Ones(model.mesh().cell_count());
  const InertiaIntegrals I = inertia_integrals(model, v, MatrixXd::Zero(model.size(), 0));
  const double mass = kMaterial.rho * 2 * depth;
  EXPECT_NEAR(I.mass, mass, 1e-13);
  EXPECT_NEAR((I.first - mass / 2 * size).norm(), 0, 1e-13);
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      EXPECT_NEAR(I.second(a, b), mass * size[a] * size[b] / (a == b ? 3 : 4), 1e-13);
  const VectorXd f = traction_load(model, model.mesh().sets.at("x_max"), {3, 5, 0});
  const VectorXd wrench = model.rigid_motions().transpose() * f;
  EXPECT_NEAR(wrench[0], 3 * area, 1e-13);
  EXPECT_NEAR(wrench[1], 5 * area, 1e-13);
  EXPECT_NEAR(wrench[wrench.size() - 1], area * (5 * 2 - 3 * 0.5), 1e-13);  // about z
}

/// Elastic energy of a unit square (thickness 1) or cube whose boundary is displaced by the
/// gradient of a harmonic function, which is in equilibrium: e^x sin y, and e^(sqrt(2) x) sin y
/// sin z. Over the exact one, mu int |grad grad phi|^2.
double energy_of_harmonic(const CellKind& kind, int n) {
  const int dim = kind.dim;
  const SolidMesh mesh = in_cells(
      dim == 2 ? quad_grid({0, 0}, {1, 1}, n, n) : hex_grid({0, 0, 0}, {1, 1, 1}, n, n, n), kind);
  const SolidModel model(mesh, kMaterial, {}, {});
  const double k = dim == 2 ? 1 : std::sqrt(2.0);
  VectorXd u(model.size());
  SolidSupport boundary;
  for (int i = 0; i < mesh.node_count(); ++i) {
    const Vector3d x = mesh.nodes.col(i);
    const double e = std::exp(k * x[0]), sy = std::sin(x[1]), cy = std::cos(x[1]),
                 sz = dim == 2 ? 1 : std::sin(x[2]), cz = dim == 2 ? 0 : std::cos(x[2]);
    u.segment(dim * i, dim) = Vector3d(k * e * sy * sz, e * cy * sz, e * sy * cz).head(dim);
    bool inner = true;
    for (int a = 0; a < dim; ++a) inner = inner && x[a] > 1e-9 && x[a] < 1 - 1e-9;
    for (int a = 0; !inner && a < dim; ++a) boundary.fixed.push_back(dim * i + a);
  }
  const VectorXd v = VectorXd::Ones(mesh.cell_count());
  const auto K = model.stiffness(v);
  SolidStatics statics(model, boundary, {});
  statics.set_loads(-(K.selfadjointView<Eigen::Lower>() * u));
  EXPECT_EQ(statics.solve(v), SolidStatus::Solved);
  u += statics.q().col(0);
  const double S = 0.5 - std::sin(2.0) / 4, C = 0.5 + std::sin(2.0) / 4;
  const double X = (std::exp(2 * k) - 1) / (2 * k);
  const double exact = kMaterial.G() * (dim == 2 ? 2 * X : X * (6 * S * S + 8 * S * C + 2 * C * C));
  return 0.5 * u.dot(K.selfadjointView<Eigen::Lower>() * u) / exact;
}

/// The energy converges with twice the order of the displacement's gradient.
TEST_P(Kind, EnergyConvergesWithTwiceTheOrderOfTheCells) {
  const int n = kind().dim == 2 ? 4 : 2;
  const double coarse = energy_of_harmonic(kind(), n) - 1,
               fine = energy_of_harmonic(kind(), 2 * n) - 1;
  EXPECT_NEAR(std::log2(coarse / fine), 2 * kind().order, 0.15) << coarse << " " << fine;
}

std::string name_of_kind(const ::testing::TestParamInfo<std::pair<int, int>>& info) {
  std::string name(cell_kind(info.param.first, info.param.second).name);
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
}
INSTANTIATE_TEST_SUITE_P(Cell, Kind,
                         ::testing::Values(std::pair{2, 3}, std::pair{2, 4}, std::pair{2, 6},
                                           std::pair{2, 8}, std::pair{3, 4}, std::pair{3, 8},
                                           std::pair{3, 10}, std::pair{3, 20}),
                         name_of_kind);

/// A node off the middle of its edge: the cell is curved, its area that of its parabolic sides.
TEST(Cell, NodesOffTheirEdgeMakeItCurved) {
  SolidMesh mesh = in_cells(quad_grid({0, 0}, {1, 1}, 1, 1), cell_kind(2, 8));
  mesh.nodes(1, mesh.cells(4, 0)) = -0.3;  // of the lower side: 2/3 of its depth below
  EXPECT_NEAR(mesh.cell_size(0), 1.2, 1e-15);
  EXPECT_GT(smallest_jacobian(2, mesh.nodes_of(0)), 0);
  EXPECT_NEAR(SolidModel(mesh, kMaterial, {}, {}).total_mass(VectorXd::Ones(1)), 2.4, 1e-15);
  mesh.nodes(1, mesh.cells(4, 0)) = 1.1;  // through the upper side
  EXPECT_LT(smallest_jacobian(2, mesh.nodes_of(0)), 0);
}

TEST(Cell, InvertedTetrahedraAreRefused) {
  for (const int nodes : {4, 10}) {
    SolidMesh mesh = in_cells(hex_grid({0, 0, 0}, {1, 1, 1}, 1, 1, 1), cell_kind(3, nodes));
    EXPECT_NO_THROW(SolidModel(mesh, kMaterial, {}, {}));
    std::swap(mesh.cells(0, 2), mesh.cells(1, 2));
    EXPECT_THROW(SolidModel(mesh, kMaterial, {}, {}), std::invalid_argument);
  }
}

/// Tip deflection of a clamped beam under an end force, over Timoshenko's with shear.
double cantilever(int dim, double length, double height, int nx, int ny) {
  const SolidMesh mesh = dim == 2 ? quad_grid({0, -height / 2}, {length, height / 2}, nx, ny)
                                  : hex_grid({0, -height / 2, -height / 2},
                                             {length, height / 2, height / 2}, nx, ny, ny);
  SolidModel::Options options;
  options.thickness = height;
  Material material = kMaterial;
  material.nu = 0;  // so that a clamped end does not stiffen the beam
  SolidModel model(mesh, material,
                   {{"root", mesh.sets.at("x_min"), {0, 0, 0}, Tie::Rigid},
                    {"tip", mesh.sets.at("x_max"), {length, 0, 0}, Tie::Averaged}},
                   options);
  SolidSupport support;
  fix_port(support, model, 0, dim == 2 ? "xyr" : "xyzr");
  SolidStatics statics(model, support, {});
  MatrixXd f = MatrixXd::Zero(model.size(), 1);
  f(model.port(1) + 1, 0) = 1;
  statics.set_loads(f);
  EXPECT_EQ(statics.solve(VectorXd::Ones(mesh.cell_count())), SolidStatus::Solved);
  const double EI = material.E * std::pow(height, 4) / 12;
  const double GA = 5.0 / 6 * material.G() * height * height;
  const double exact = std::pow(length, 3) / (3 * EI) + length / GA;
  return statics.q()(model.port(1) + 1, 0) / exact;
}

TEST(Cantilever, OneElementThickDoesNotLock) {
  for (int dim : {2, 3}) {
    EXPECT_NEAR(cantilever(dim, 100, 1, 100, 1), 1, 1e-3) << dim;
    EXPECT_NEAR(cantilever(dim, 100, 1, 10, 1), 1, 0.01) << dim;  // cells ten times as long as high
  }
}

TEST(Cantilever, BendsAsAThinBeamWithOrderTwo) {
  double previous = 0;
  for (int n : {4, 8, 16}) {
    const double error = std::abs(cantilever(2, 100, 1, n, 1) - 1);
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 2, 0.02);
    }
    previous = error;
  }
}

/// Cook's membrane: E = 1, nu = 1/3, F = 1, vertical displacement at the middle of the loaded edge;
/// converged value 23.96 (e.g. Pian, Sumihara 1984: 23.91; refined 23.965).
double cooks_deflection(int n) {
  const SolidMesh mesh = cooks_membrane(cell_kind(2, 4), n);
  SolidModel model(mesh, {"unit", 1, 1.0 / 3, 1}, {}, {});
  SolidSupport support;
  fix_nodes(support, model, mesh.sets.at("x_min"), "xy");
  MatrixXd f = MatrixXd::Zero(model.size(), 1);
  const auto& edge = mesh.sets.at("x_max");
  for (std::size_t i = 0; i < edge.size(); ++i)
    f(2 * edge[i] + 1, 0) = (i == 0 || i + 1 == edge.size() ? 0.5 : 1.0) / n;
  SolidStatics statics(model, support, {});
  statics.set_loads(f);
  EXPECT_EQ(statics.solve(VectorXd::Ones(mesh.cell_count())), SolidStatus::Solved);
  return statics.q()(2 * middle_of_its_side(mesh) + 1, 0);
}

TEST(CooksMembrane, ConvergesToTheKnownValue) {
  EXPECT_GT(cooks_deflection(2), 0.85 * 23.96);  // a plain bilinear element: 11.8
  EXPECT_NEAR(cooks_deflection(4), 23.0, 0.35);
  EXPECT_NEAR(cooks_deflection(64), 23.96, 0.02);
  // Order below 2: the corner at the clamp is singular.
  const double a = cooks_deflection(8), b = cooks_deflection(16), c = cooks_deflection(32);
  const double order = std::log2((b - a) / (c - b));
  EXPECT_GT(order, 1.7);
  EXPECT_LT(order, 1.9);
}

}  // namespace
}  // namespace liesl::test::cell_test
