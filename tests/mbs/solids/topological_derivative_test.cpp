/// @file
/// Topological derivatives against finite holes in body-fitted meshes, and against closed forms.
#include "mbs/solids/topological_derivative.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "mbs/solids/holes.hpp"

namespace liesl::test::topological_derivative_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Material kSteel{"steel", 210e9, 0.3, 7850};

VectorXd stress(std::initializer_list<double> s) {
  return Eigen::Map<const VectorXd>(s.begin(), static_cast<Eigen::Index>(s.size()));
}

/// The compliance grows by the strain energy that the edge of the hole sweeps over, twice: the mean
/// of hoop stress squared over E on a hole in an infinite plate. Kirsch (1898): s = 1 - 2 cos 2a
/// under tension along x, and with the axes turned for the others.
TEST(TopologicalDerivative, IsTheMeanOfKirschsHoopStresses) {
  const auto hoop = [](const VectorXd& s, double a) {
    return s[0] * (1 - 2 * std::cos(2 * a)) + s[1] * (1 + 2 * std::cos(2 * a)) -
           4 * s[2] * std::sin(2 * a);
  };
  const VectorXd load = stress({3, -1, 0.7}), output = stress({0.4, 2, -1.3});
  constexpr int n = 16;
  double mean = 0;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    mean += hoop(load, a) * hoop(output, a) / n;
  }
  EXPECT_NEAR(hole_effect(2, kSteel, load, output) * kSteel.E, mean, 1e-12);
  EXPECT_NEAR(hole_effect(2, kSteel, stress({1, 0, 0}), stress({1, 0, 0})) * kSteel.E, 3, 1e-12);
  EXPECT_NEAR(hole_effect(2, kSteel, stress({1, 1, 0}), stress({1, 1, 0})) * kSteel.E, 4, 1e-12);
}

/// Spheres: a thick sphere under tension outside (Lame), and the modulus of a body with few round
/// pores, E (1 - 3 (1 - nu)(9 + 5 nu)/(2 (7 - 5 nu)) c) (J. K. Mackenzie 1950, Proc. Phys. Soc. B
/// 63), whose compliance density is s^2/E.
TEST(TopologicalDerivative, OfSpheresHasTheClosedFormsOfPorousBodies) {
  for (const double nu : {0.0, 0.2, 0.3, 0.45}) {
    const Material m{"m", 2.0, nu, 1};
    const VectorXd all = stress({1, 1, 1, 0, 0, 0}), one = stress({0, 1, 0, 0, 0, 0});
    const double K = m.E / (3 * (1 - 2 * nu));
    EXPECT_NEAR(hole_effect(3, m, all, all), (1 + 3 * K / (4 * m.G())) / K, 1e-12) << nu;
    EXPECT_NEAR(hole_effect(3, m, one, one), 3 * (1 - nu) * (9 + 5 * nu) / (2 * (7 - 5 * nu)) / m.E,
                1e-12)
        << nu;
  }
}

TEST(TopologicalDerivative, DoesNotDependOnTheAxes) {
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.7, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const auto turned = [&](const VectorXd& s, const Eigen::Matrix3d& Q) {
    Eigen::Matrix3d S;
    S << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    S = Q * S * Q.transpose();
    return stress({S(0, 0), S(1, 1), S(2, 2), S(0, 1), S(1, 2), S(2, 0)});
  };
  const auto planar = [](const VectorXd& s) { return stress({s[0], s[1], s[3]}); };
  const VectorXd a = stress({3, -1, 0.7, 0.3, -0.9, 1.1}), b = stress({1, 2, -3, 0.1, 0.2, 0.5});
  EXPECT_NEAR(hole_effect(3, kSteel, turned(a, R), turned(b, R)) / hole_effect(3, kSteel, a, b), 1,
              1e-12);
  const Eigen::Matrix3d Z = Eigen::AngleAxisd(0.4, Vector3d::UnitZ()).toRotationMatrix();
  const VectorXd c = stress({3, -1, 0, 0.3, 0, 0}), d = stress({1, 2, 0, 0.1, 0, 0});
  EXPECT_NEAR(hole_effect(2, kSteel, planar(turned(c, Z)), planar(turned(d, Z))) /
                  hole_effect(2, kSteel, planar(c), planar(d)),
              1, 1e-12);
}

/// Compliances and an output of a part, and what holes do to them.
VectorXd values(const SolidStatics& s) {
  VectorXd out(s.cases() + s.cases());
  out << s.compliance(), s.y().row(0).transpose();
  return out;
}
VectorXd derivatives(const SolidStatics& s, const std::vector<int>& cells) {
  VectorXd out(2 * s.cases());
  for (int n = 0; n < s.cases(); ++n) {
    const VectorXd w = VectorXd::Unit(s.cases(), n);
    out[n] = compliance_of_holes(s, w)(cells).mean();
    out[s.cases() + n] = output_of_holes(s, 0, w)(cells).mean();
  }
  return out;
}

/// What taking out the cells inside `radius` does, per volume.
VectorXd change(HoledDisc& disc, SolidStatics& s, double radius) {
  const SolidMesh& mesh = disc.model.mesh();
  VectorXd v = VectorXd::Ones(mesh.cell_count());
  EXPECT_EQ(s.solve(v), SolidStatus::Solved);
  const VectorXd before = values(s);
  double volume = 0;
  for (int e = 0; e < mesh.cell_count(); ++e)
    if (mesh.corners_of(e).rowwise().mean().norm() < radius) {
      v[e] = 0;
      volume += disc.model.cell(e).volume;
    }
  EXPECT_EQ(s.solve(v), SolidStatus::Solved);
  return (values(s) - before) / volume;
}

/// Held or free-floating (inertia relief), a disc under loads that are not alike anywhere: the
/// change by holes of falling radius tends to the derivative with the square of the radius.
TEST(TopologicalDerivative, IsTheLimitOfFiniteHoles) {
  for (const bool relief : {false, true}) {
    HoledDisc fine(96, 0.004, kSteel);
    SolidStatics at_point = fine.statics(relief);
    ASSERT_EQ(at_point.solve(VectorXd::Ones(fine.model.mesh().cell_count())), SolidStatus::Solved);
    const VectorXd exact = derivatives(at_point, fine.cells_at(0.01));
    VectorXd error[3];
    for (int i = 0; i < 3; ++i) {
      const double radius = 0.16 / std::pow(2, i);
      HoledDisc disc(96, radius, kSteel);
      SolidStatics s = disc.statics(relief);
      error[i] = (change(disc, s, radius) - exact).cwiseQuotient(exact);
    }
    for (int k = 0; k < exact.size(); ++k) {  // the mesh's own error is common to the three
      const double first = error[0][k] - error[1][k], second = error[1][k] - error[2][k];
      EXPECT_NEAR(std::log2(first / second), 2, 0.14) << "relief " << relief << ", quantity " << k;
      EXPECT_NEAR(error[2][k] - second / 3, 0, 4e-3) << "relief " << relief << ", quantity " << k;
    }
  }
}

TEST(TopologicalDerivative, OfABlockInTensionIsTheClosedForm) {
  const SolidMesh mesh = hex_grid({0, 0, 0}, {2, 1, 1}, 4, 2, 3);
  SolidModel model(mesh, kSteel, {}, {});
  SolidSupport support;
  fix_nodes(support, model, mesh.sets.at("x_min"), "x");
  fix_nodes(support, model, mesh.sets.at("y_min"), "y");
  fix_nodes(support, model, mesh.sets.at("z_min"), "z");
  SolidStatics s(model, support, {});
  s.set_loads(traction_load(model, mesh.sets.at("x_max"), {5e6, 0, 0}));
  ASSERT_EQ(s.solve(VectorXd::Ones(mesh.cell_count())), SolidStatus::Solved);
  const double nu = kSteel.nu;
  const double factor = 3 * (1 - nu) * (9 + 5 * nu) / (2 * (7 - 5 * nu));
  const VectorXd effect = compliance_of_holes(s, VectorXd::Constant(1, 2));
  for (int e = 0; e < effect.size(); ++e)
    EXPECT_NEAR(effect[e] / (2 * factor * 25e12 / kSteel.E), 1, 1e-9);
}

}  // namespace
}  // namespace liesl::test::topological_derivative_test
