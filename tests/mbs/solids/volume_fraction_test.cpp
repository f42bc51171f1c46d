#include "mbs/solids/volume_fraction.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "mbs/levelset/shapes.hpp"
#include "mbs/solids/meshes.hpp"

namespace liesl::test::volume_fraction_test {
namespace {

using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

double volume(const SolidMesh& mesh, const VectorXd& v) {
  double sum = 0;
  for (int e = 0; e < mesh.cell_count(); ++e) sum += v[e] * mesh.cell_size(e);
  return sum;
}

/// Mean relative errors of the volume and of its derivatives over places.
struct DiscError {
  double volume = 0, derivative = 0, worst_derivative = 0;
};

DiscError disc_error(int n, int subdivisions) {
  const SolidMesh mesh = quad_grid({0, 0}, {1, 1}, n, n);
  DiscError error;
  for (int place = 0; place < 20; ++place) {
    const double r = 0.3 + 0.0031 * place;
    const LevelSetPtr disc =
        placed_in_plane(0.5 + 0.0023 * place, 0.5 - 0.0011 * place, 0, circle(r));
    const Fractions f = volume_fractions(mesh, *disc, subdivisions);
    const VectorXd dV = f.derivative.transpose() * VectorXd::Constant(n * n, 1.0 / (n * n));
    error.volume += std::abs(volume(mesh, f.value) / (kPi * r * r) - 1) / 20;
    const double derivative =
        std::max({std::abs(dV[3] / (2 * kPi * r) - 1), std::abs(dV[0]), std::abs(dV[1])});
    error.derivative += derivative / 20;
    error.worst_derivative = std::max(error.worst_derivative, derivative);
  }
  return error;
}

TEST(VolumeFraction, DiscOnFortyByFortyCells) {
  const DiscError e = disc_error(40, 0);
  EXPECT_LT(e.volume, 1e-4);            // asked for: 1e-3
  EXPECT_LT(e.worst_derivative, 1e-3);  // asked for: 1e-2
}

TEST(VolumeFraction, ErrorFallsWithTheSquareOfTheSubCellThatOfTheDerivativeNearlyAsFast) {
  const DiscError a = disc_error(20, 2), b = disc_error(20, 4), c = disc_error(20, 16);
  EXPECT_NEAR(std::log2(a.volume / b.volume), 2, 0.1);
  EXPECT_NEAR(std::log2(b.volume / c.volume) / 2, 2, 0.1);
  EXPECT_GT(std::log2(a.derivative / c.derivative) / 3, 1.35);
}

TEST(VolumeFraction, HalfSpaceIsExactOnSkewCells) {
  SolidMesh mesh = quad_grid({0, 0}, {1, 1}, 1, 1);
  mesh.nodes.col(3) << 1.3, 1.2, 0;  // one quadrilateral without symmetry
  const LevelSetPtr left = placed_in_plane(0.4, 0, 0, half_space());
  const Fractions f = volume_fractions(mesh, *left);
  // Area left of x = 0.4 under the upper edge y = 1 + 0.2 x / 1.3.
  EXPECT_NEAR(f.value[0] * mesh.cell_size(0), 0.4 + 0.1 * 0.16 / 1.3, 1e-14);
  EXPECT_NEAR(f.derivative.coeff(0, 0) * mesh.cell_size(0), 1 + 0.2 * 0.4 / 1.3, 1e-13);

  SolidMesh cube = hex_grid({0, 0, 0}, {1, 1, 1}, 1, 1, 1);
  const LevelSetPtr corner = placed({{0.5, 0, 0}, {0, 0, kPi / 4}}, half_space());
  const Fractions g = volume_fractions(cube, *corner);  // x + y < 1/2
  EXPECT_NEAR(g.value[0], 0.125, 1e-14);
}

TEST(VolumeFraction, BallInHexahedraConvergesWithOrderTwo) {
  double previous = 0;
  for (int n : {8, 16, 32}) {
    const SolidMesh mesh = hex_grid({0, 0, 0}, {1, 1, 1}, n, n, n);
    double error = 0;
    for (int place = 0; place < 4; ++place) {
      const LevelSetPtr ball =
          placed(Pose{{0.5 + 0.0023 * place, 0.5, 0.49}, Eigen::Vector3d::Zero()},
                 sphere(0.33 + 0.003 * place));
      const double V = volume(mesh, volume_fractions(mesh, *ball).value);
      error += std::abs(V / (4 * kPi / 3 * std::pow(0.33 + 0.003 * place, 3)) - 1) / 4;
    }
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 2, 0.01);
    }
    previous = error;
  }
  EXPECT_LT(previous, 1e-3);
}

TEST(VolumeFraction, SmallAndVanishingHolesAreSeen) {
  const SolidMesh mesh = quad_grid({0, 0}, {1, 1}, 10, 10);
  for (double r : {0.02, 0.04}) {  // within one cell of 0.1
    const LevelSetPtr hole = placed_in_plane(0.55, 0.55, 0, circle(r));
    const auto error = [&](int n) {
      return std::abs(volume(mesh, volume_fractions(mesh, *hole, n).value) / (kPi * r * r) - 1);
    };
    EXPECT_LT(error(8), 0.1) << r;
    EXPECT_NEAR(std::log2(error(8) / error(64)) / 3, 2, 0.15) << r;  // order
  }
  const Fractions none = volume_fractions(mesh, *placed_in_plane(0.55, 0.55, 0, circle(-0.1)));
  EXPECT_EQ(none.value.sum(), 0);
  EXPECT_EQ(none.derivative.nonZeros(), 0);
}

TEST(VolumeFraction, OnlyCutCellsHaveDerivatives) {
  const SolidMesh mesh = quad_grid({0, 0}, {1, 1}, 40, 40);
  const Fractions f = volume_fractions(mesh, *placed_in_plane(0.5, 0.5, 0, circle(0.3)));
  for (int e = 0; e < mesh.cell_count(); ++e) {
    const bool cut = f.value[e] > 0 && f.value[e] < 1;
    const bool entries = f.derivative.row(e).nonZeros() > 0;
    EXPECT_EQ(cut, entries) << e;
  }
}

class EveryShapeOnAMesh : public ::testing::TestWithParam<NamedShape> {};

/// The fractions, weighted by a smooth function, against central differences along directions that
/// change every parameter. Fractions are C1: where the outline passes a node of the sub-grid the
/// second derivative jumps, and a step across such places has an error of first order. Hence the
/// slope is that of the median over many places, at steps that are small against a sub-cell.
TEST_P(EveryShapeOnAMesh, FractionGradientsPassTheStepSweep) {
  const LevelSetPtr shape = GetParam().make();
  const VectorXd p0 = shape->start();
  for (int dim : {2, 3}) {
    const SolidMesh mesh =
        dim == 2 ? quad_grid({-1, -1}, {1, 1}, 19, 19) : hex_grid({-1, -1, -1}, {1, 1, 1}, 6, 6, 6);
    VectorXd weight(mesh.cell_count());
    for (int e = 0; e < weight.size(); ++e) {
      const Eigen::Vector3d x = mesh.corners_of(e).rowwise().mean();
      weight[e] = mesh.cell_size(e) * (1 + 0.5 * x[0] - 0.3 * x[1] * x[1] + 0.2 * x[2]);
    }
    const std::vector<double> steps = {8e-4, 4e-4, 2e-4, 1e-4, 1e-5};
    Eigen::MatrixXd error(16, 5);
    for (int k = 0; k < 16; ++k) {
      VectorXd p = p0, d(p0.size());
      for (Eigen::Index i = 0; i < d.size(); ++i) {
        d[i] = 0.3 * std::sin(1.0 + 2.7 * i + 3.1 * k);
        p[i] += 0.01 * std::sin(2.0 + 1.3 * i + 1.7 * k);
      }
      shape->set(p);
      const VectorXd gradient = volume_fractions(mesh, *shape).derivative.transpose() * weight;
      const double size = gradient.cwiseAbs().dot(d.cwiseAbs());
      const auto total = [&](double t) {
        shape->set(p + t * d);
        return weight.dot(volume_fractions(mesh, *shape).value);
      };
      for (std::size_t s = 0; s < steps.size(); ++s) {
        const double h = steps[s];
        error(k, static_cast<Eigen::Index>(s)) =
            std::abs((total(h) - total(-h)) / (2 * h) - gradient.dot(d)) / size;
      }
    }
    EXPECT_LE(error.rowwise().minCoeff().maxCoeff(), 1e-6) << dim;
    const auto median = [&](Eigen::Index s) {
      VectorXd e = error.col(s);
      std::nth_element(e.data(), e.data() + 8, e.data() + 16);
      return e[8];
    };
    if (median(0) > 1e-9) {  // else it is round-off
      EXPECT_GT(std::log2(median(0) / median(3)) / 3, 1.9) << dim;
    }
    shape->set(p0);
  }
}

INSTANTIATE_TEST_SUITE_P(VolumeFraction, EveryShapeOnAMesh, ::testing::ValuesIn(all_shapes()),
                         [](const auto& shape) {
                           std::string name = shape.param.name;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

TEST(VolumeFraction, TrianglesAndTetrahedraAreNotCut) {
  EXPECT_THROW(volume_fractions(split(quad_grid({0, 0}, {1, 1}, 2, 2)), *circle(0.5)),
               std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::volume_fraction_test
