/// @file
/// Cells in large motion: forces are gradients, tangents their derivatives, axes do not matter, and
/// at rest they are the cells of reduced parts.

#include "mbs/solids/continuum_cell.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mbs/run.hpp"
#include "mbs/solids/cell.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl::test::continuum_cell_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr SolidLaw kLaws[] = {SolidLaw::StVenantKirchhoff, SolidLaw::NeoHookean};
const Material kRubber = {"rubber", 2e6, 0.4, 1000};
constexpr double kThick = 0.3;

/// A kind of cells.
template <int Dim, int Nodes>
struct Cells {
  static constexpr int value = Dim, nodes = Nodes;
};

/// A cell that is no parallelogram, with edges that are not straight.
template <class K>
Eigen::Matrix3Xd skewed() {
  const CellKind& kind = cell_kind(K::value, K::nodes);
  Eigen::Matrix3Xd x(3, K::nodes);
  const double half = kind.family == CellFamily::Cube ? 0.5 : 1;
  for (int i = 0; i < K::nodes; ++i)
    x.col(i) = half * Vec3(1, 0.6, 0.8).cwiseProduct(reference_node(kind, i));
  Random random(4);
  x.topRows<K::value>() += (kind.order == 1 ? 0.1 : 0.03) * random.matrix(K::value, K::nodes);
  if (K::value == 2) x.row(2).setZero();
  return x;
}

template <class Kind>
class ContinuumCellTest : public ::testing::Test {
 protected:
  static constexpr int kDim = Kind::value;
  using Cell = ContinuumCell<kDim>;
  using Positions = typename Cell::Positions;

  static Cell make(SolidLaw law) {
    return {Positions(skewed<Kind>().template topRows<kDim>()), kRubber, kThick, law};
  }
  /// Turned and deformed by up to a fifth.
  static Positions moved() {
    Random random(7);
    const Positions rest = skewed<Kind>().template topRows<kDim>();
    return turn(1.2) *
           (rest +
            (Kind::nodes > 8 || Kind::nodes == 6 || (kDim == 2 && Kind::nodes == 8) ? 0.02 : 0.06) *
                random.matrix(kDim, static_cast<int>(rest.cols())));
  }
  static Eigen::Matrix<double, kDim, kDim> turn(double angle) {
    if constexpr (kDim == 2)
      return Eigen::Rotation2Dd(angle).toRotationMatrix();
    else
      return Eigen::AngleAxisd(angle, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  }
  static typename Cell::Response response(const Cell& cell, const Positions& x) {
    VectorXd E;
    cell.strain(x, E);
    typename Cell::Response out;
    cell.respond(E, true, out);
    EXPECT_TRUE(out.converged);
    return out;
  }
  static Positions force(const Cell& cell, const Positions& x) {
    Positions f = Positions::Zero(kDim, cell.nodes());
    cell.add_force(x, response(cell, x).stress, f);
    return f;
  }
  static MatrixXd tangent(const Cell& cell, const Positions& x) {
    const auto at = response(cell, x);
    MatrixXd B;
    cell.strain_matrix(x, B);
    MatrixXd K = B.transpose() * at.tangent * B;
    cell.add_geometric(at.stress, K);
    return K;
  }
};

using Kinds = ::testing::Types<Cells<2, 3>, Cells<2, 4>, Cells<2, 6>, Cells<2, 8>, Cells<3, 4>,
                               Cells<3, 8>, Cells<3, 10>, Cells<3, 20>>;
TYPED_TEST_SUITE(ContinuumCellTest, Kinds);

TYPED_TEST(ContinuumCellTest, AtRestItIsTheCellOfReducedParts) {
  constexpr int D = TypeParam::value;
  const MatrixXd K = cell_matrices(D, skewed<TypeParam>(), kRubber, kThick).K;
  for (const SolidLaw law : kLaws) {
    const auto cell = this->make(law);
    const typename TestFixture::Positions rest = skewed<TypeParam>().template topRows<D>();
    EXPECT_LT((this->tangent(cell, rest) - K).norm(), 1e-12 * K.norm());
    EXPECT_LT(this->force(cell, rest).norm(), 1e-13 * K.norm());
  }
}

TYPED_TEST(ContinuumCellTest, ForcesAndTangentsAreDerivatives) {
  constexpr int D = TypeParam::value;
  for (const SolidLaw law : kLaws) {
    const auto cell = this->make(law);
    const auto x = this->moved();
    const auto f = this->force(cell, x);
    const MatrixXd K = this->tangent(cell, x);
    const double h = 1e-5;
    for (int a = 0; a < cell.nodes(); ++a)
      for (int i = 0; i < D; ++i) {
        auto up = x, down = x;
        up(i, a) += h;
        down(i, a) -= h;
        const double slope =
            (this->response(cell, up).energy - this->response(cell, down).energy) / (2 * h);
        EXPECT_NEAR(f(i, a), slope, 1e-7 * f.norm());
        const typename TestFixture::Positions change =
            (this->force(cell, up) - this->force(cell, down)) / (2 * h);
        EXPECT_LT(
            (Eigen::Map<const VectorXd>(change.data(), change.size()) - K.col(D * a + i)).norm(),
            1e-7 * K.norm());
      }
    EXPECT_LT((K - K.transpose()).norm(), 1e-12 * K.norm());
  }
}

TYPED_TEST(ContinuumCellTest, StressAtItsCentreHasItsGradient) {
  constexpr int D = TypeParam::value;
  using Stress = Eigen::Matrix<double, (D == 2 ? 3 : 6), 1>;
  for (const SolidLaw law : kLaws) {
    const auto cell = this->make(law);
    const auto x = this->moved();
    const Stress f = Random(9).vector(D == 2 ? 3 : 6);
    typename TestFixture::Positions g = TestFixture::Positions::Zero(D, cell.nodes());
    cell.add_central_stress_gradient(x, f, g);
    const double h = 1e-5;
    for (int a = 0; a < cell.nodes(); ++a)
      for (int i = 0; i < D; ++i) {
        auto up = x, down = x;
        up(i, a) += h;
        down(i, a) -= h;
        const Stress change = (cell.central_stress(up) - cell.central_stress(down)) / (2 * h);
        EXPECT_NEAR(g(i, a), f.dot(change), 1e-7 * g.norm()) << to_string(law);
      }
  }
}

/// Forces turn with the cell, energy and stress do not change.
TYPED_TEST(ContinuumCellTest, DoesNotDependOnAxes) {
  for (const SolidLaw law : kLaws) {
    const auto cell = this->make(law);
    const auto x = this->moved();
    const auto Q = this->turn(2.1);
    const auto before = this->response(cell, x), after = this->response(cell, Q * x);
    EXPECT_NEAR(after.energy, before.energy, 1e-12 * before.energy);
    EXPECT_LT((after.stress - before.stress).norm(), 1e-12 * before.stress.norm());
    const auto f = this->force(cell, x);
    EXPECT_LT((this->force(cell, Q * x) - Q * f).norm(), 1e-12 * f.norm());
  }
}

/// Rates of strain are the change of strain.
TYPED_TEST(ContinuumCellTest, RatesAreThoseOfTheStrain) {
  const auto cell = this->make(SolidLaw::StVenantKirchhoff);
  const auto x = this->moved();
  Random random(3);
  const typename TestFixture::Positions v = random.matrix(TypeParam::value, cell.nodes());
  VectorXd rate, up, down;
  cell.strain_rate(x, v, rate);
  const double h = 1e-4;
  cell.strain(x + h * v, up);
  cell.strain(x - h * v, down);
  EXPECT_LT((rate - (up - down) / (2 * h)).norm(), 1e-9 * rate.norm());
  MatrixXd B;
  cell.strain_matrix(x, B);
  EXPECT_LT((B * Eigen::Map<const VectorXd>(v.data(), v.size()) - rate).norm(),
            1e-12 * rate.norm());
}

/// Of nodes at rest that move while the cell does: against differences of fourth order.
TYPED_TEST(ContinuumCellTest, ByItsReferenceIsThatOfDifferences) {
  constexpr int D = TypeParam::value;
  using Cell = typename TestFixture::Cell;
  using Positions = typename TestFixture::Positions;
  Random random(5);
  const Positions rest = skewed<TypeParam>().template topRows<D>(), x = this->moved();
  const int n = static_cast<int>(rest.cols());
  const Positions dX = random.matrix(D, n), dx = random.matrix(D, n), v = random.matrix(D, n),
                  dv = random.matrix(D, n);
  for (const SolidLaw law : kLaws) {
    // force, viscous force without its factor
    const auto forces = [&](double p) {
      const Positions at = x + p * dx, rates = v + p * dv;
      const Cell cell(rest + p * dX, kRubber, kThick, law);
      std::array<Positions, 2> f = {this->force(cell, at), Positions::Zero(D, n)};
      VectorXd rate;
      cell.strain_rate(at, rates, rate);
      cell.add_force(at, cell.stiffness() * rate, f[1]);
      return f;
    };
    const Cell cell(rest, kRubber, kThick, law);
    const auto by = cell.variation(rest, dX);
    VectorXd E, rate;
    cell.strain(x, E);
    cell.strain_rate(x, v, rate);
    const VectorXd dE = 0.5 * cell.rate_variation(x, x, dx, dx, by);
    std::array<Positions, 2> exact = {Positions::Zero(D, n), Positions::Zero(D, n)};
    cell.add_force_variation(x, this->response(cell, x).stress, dx,
                             cell.stress_variation(E, dE, by), by, exact[0]);
    cell.add_force_variation(x, cell.stiffness() * rate, dx,
                             cell.linear_variation(rate, cell.rate_variation(x, v, dx, dv, by), by),
                             by, exact[1]);
    std::array<double, 2> coarse{}, fine{};
    for (auto [off, h] : {std::pair{&coarse, 1e-3}, {&fine, 2.5e-4}}) {
      const auto a = forces(-2 * h), b = forces(-h), c = forces(h), d = forces(2 * h);
      for (std::size_t i = 0; i < 2; ++i)
        (*off)[i] =
            ((a[i] - 8 * b[i] + 8 * c[i] - d[i]) / (12 * h) - exact[i]).norm() / exact[i].norm();
    }
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LT(fine[i], 1e-8) << to_string(law) << " " << i;
      EXPECT_LT(fine[i], std::max(coarse[i] / 100, 1e-11)) << to_string(law) << " " << i;
    }
  }
}

/// S_22 = S_33 = 0 in tension: for St. Venant-Kirchhoff S_11 = E E_11; neo-Hookean has the axial
/// force of a plate and of a bar in space alike.
TEST(SolidLaw, PlaneStressIsSpaceWithoutStressAcross) {
  for (const SolidLaw law : kLaws) {
    Eigen::Vector3d plane(0.2, -0.05, 0.1);
    const auto in_plane = solid_law<2>(law, kRubber, plane);
    Eigen::Matrix<double, 6, 1> space;
    space << 0.2, -0.05, 0, 0.1, 0, 0;
    for (int i = 0; i < 50; ++i) {
      const auto at = solid_law<3>(law, kRubber, space);
      space[2] -= at.stress[2] / at.tangent(2, 2);
    }
    const auto in_space = solid_law<3>(law, kRubber, space);
    const double scale = in_plane.stress.norm();
    EXPECT_NEAR(in_plane.stress[0], in_space.stress[0], 1e-12 * scale);
    EXPECT_NEAR(in_plane.stress[1], in_space.stress[1], 1e-12 * scale);
    EXPECT_NEAR(in_plane.stress[2], in_space.stress[3], 1e-12 * scale);
    EXPECT_NEAR(in_plane.energy, in_space.energy, 1e-12 * in_space.energy);
  }
}

/// The neo-Hookean material does not fall flat: its energy grows without bound, the linear law lets
/// the cell be pushed through itself.
TEST(SolidLaw, NeoHookeanResistsCompression) {
  Eigen::Matrix<double, 6, 1> strain = Eigen::Matrix<double, 6, 1>::Zero();
  strain[0] = -0.5 + 5e-9;  // stretch 1e-4
  const auto neo = solid_law<3>(SolidLaw::NeoHookean, kRubber, strain),
             linear = solid_law<3>(SolidLaw::StVenantKirchhoff, kRubber, strain);
  EXPECT_GT(-1e-4 * neo.stress[0], 1e3 * kRubber.E);
  EXPECT_LT(-1e-4 * linear.stress[0], 1e-3 * kRubber.E);
}

TEST(SolidLaw, RefusesAnIncompressibleMaterial) {
  const Eigen::Matrix2Xd x = quad_grid({0, 0}, {1, 1}, 1, 1).corners_of(0).topRows<2>();
  EXPECT_THROW(ContinuumCell<2>(x, {"water", 1e6, 0.5, 1000}, 1, SolidLaw::NeoHookean),
               std::invalid_argument);
}

/// Of the same deformation everywhere, turned: closed forms of a bar that does not contract, and of
/// the neo-Hookean law in space, sigma = (mu (b - 1) + lambda ln J 1)/J.
TEST(ContinuumCellStress, IsThatOfCauchy) {
  const Material plain = {"plain", 2e6, 0, 1000};
  const double l = 1.3, angle = 0.7;
  const Eigen::Matrix3Xd rest = skewed<Cells<2, 4>>();
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).matrix(),
                        F = R * Eigen::Vector2d(l, 1).asDiagonal();
  const ContinuumCell<2> flat(rest.topRows<2>(), plain, kThick, SolidLaw::StVenantKirchhoff);
  const Eigen::Vector3d in_plane = flat.central_stress(F * rest.topRows<2>());
  const double pull = plain.E * l * (l * l - 1) / 2;
  const Eigen::Vector2d along = R.col(0);
  EXPECT_NEAR(in_plane[0], pull * along[0] * along[0], 1e-9 * pull);
  EXPECT_NEAR(in_plane[1], pull * along[1] * along[1], 1e-9 * pull);
  EXPECT_NEAR(in_plane[2], pull * along[0] * along[1], 1e-9 * pull);

  const Eigen::Matrix3Xd block = skewed<Cells<3, 8>>();
  Mat3 G;
  G << 1.1, 0.2, -0.1, 0.05, 0.9, 0.1, 0, -0.15, 1.2;
  const ContinuumCell<3> cell(block, kRubber, 1, SolidLaw::NeoHookean);
  const Eigen::Matrix<double, 6, 1> stress = cell.central_stress(G * block);
  const double J = G.determinant(), mu = kRubber.G(),
               lambda = 2 * mu * kRubber.nu / (1 - 2 * kRubber.nu);
  const Mat3 one = Mat3::Identity(),
             exact = (mu * (G * G.transpose() - one) + lambda * std::log(J) * one) / J;
  const double sizes = exact.norm();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(stress[i], exact(i, i), 1e-9 * sizes) << i;
    EXPECT_NEAR(stress[3 + i], exact(i, (i + 1) % 3), 1e-9 * sizes) << i;
  }
  EXPECT_TRUE(cell.central_stress(-block).isZero(0)) << "inverted";
}

/// A plate that is pulled gets thinner by Poisson's ratio, small strains.
TEST(ContinuumCellStress, KnowsHowThinAPlateGets) {
  for (const SolidLaw law : kLaws) {
    const Eigen::Matrix<double, 3, 1> strain(1e-4, 0, 0);
    const auto at = solid_law<2>(law, kRubber, strain);
    EXPECT_NEAR(at.across, 1 - kRubber.nu / (1 - kRubber.nu) * 1e-4, 1e-8);
  }
}

}  // namespace
}  // namespace liesl::test::continuum_cell_test
