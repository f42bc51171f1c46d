#include <gtest/gtest.h>

#include "liegroup/numdiff.hpp"
#include "mbs/solids/connectivity.hpp"
#include "mbs/solids/plate.hpp"
#include "mbs/solids/stress_norm.hpp"

namespace liesl::test::stress_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(VonMises, BarUnderTensionAndUnderShear) {
  for (int dim : {2, 3}) {
    const SolidMesh mesh = dim == 2 ? quad_grid({0, 0}, {1, 0.1}, 20, 2)
                                    : hex_grid({0, 0, 0}, {1, 0.1, 0.1}, 20, 2, 2);
    SolidModel::Options options;
    options.thickness = 0.1;
    SolidModel model(mesh, {"m", 1e6, 0, 1},
                     {{"a", mesh.sets.at("x_min"), {0, 0.05, 0}, Tie::Rigid},
                      {"b", mesh.sets.at("x_max"), {1, 0.05, 0}, Tie::Rigid}},
                     options);
    SolidStatics statics(model, SolidSupport::relief(), {});
    MatrixXd f = MatrixXd::Zero(model.size(), 1);
    f(model.port(0), 0) = -5;
    f(model.port(1), 0) = 5;
    if (dim == 3) f(model.port(0) + 4, 0) = -5 * 0.05, f(model.port(1) + 4, 0) = 5 * 0.05;
    statics.set_loads(f);
    const VectorXd v = VectorXd::Ones(mesh.cell_count());
    ASSERT_EQ(statics.solve(v), SolidStatus::Solved);
    EXPECT_NEAR(von_mises(statics)(mesh.cell_count() / 2, 0), 500, 1e-4);
    FractionGradient none(mesh.cell_count(), 1);
    EXPECT_NEAR(stress_norm(statics, none).value[0], 500, 1e-3);  // uniform: the norm is the stress
  }
}

/// Of stresses in the plane and in space, and of the shares of cells that are not void.
TEST(VonMises, ItsPartsHaveTheirDerivatives) {
  const double h = 1e-6;
  for (const int components : {3, 6}) {
    VectorXd s(components);
    for (int i = 0; i < components; ++i) s[i] = std::sin(1 + 2.0 * i);
    const VectorXd gradient = von_mises_gradient(s);
    for (int i = 0; i < components; ++i) {
      const VectorXd step = h * VectorXd::Unit(components, i);
      EXPECT_NEAR(gradient[i], (von_mises(s + step)[0] - von_mises(s - step)[0]) / (2 * h), 1e-9);
    }
    EXPECT_TRUE(von_mises_gradient(VectorXd::Zero(components)).isZero(0));
  }
  VectorXd v(4), dv(4);
  v << 0, 0.1, 0.7, 1;
  dv << 2, -1, 0.5, 3;
  const VectorXd by = relaxed_shares_derivative(v, dv),
                 slope = (relaxed_shares(v + h * dv) - relaxed_shares(v - h * dv)) / (2 * h);
  EXPECT_EQ(by[0], 0);
  EXPECT_LT((by - slope).tail(3).norm(), 1e-8);
  EXPECT_TRUE(relaxed_shares(v, 0).isOnes(0));
}

TEST(SolidModelAtACell, CoordinatesAreThoseOfItsNodes) {
  const Plate plate({2, false, Tie::Averaged});
  const SolidModel& model = plate.model;
  MatrixXd q(model.size(), 2);
  for (int i = 0; i < model.size(); ++i) q.row(i) << std::cos(3.0 * i), std::sin(2.0 * i);
  const MatrixXd u = model.T() * q;
  for (int e = 0; e < model.mesh().cell_count(); ++e)
    EXPECT_LT((model.q_at_cell(e, q) - model.at_cell(e, u)).norm(), 1e-14) << e;
}

class PlateStress : public ::testing::TestWithParam<PlateCase> {};

TEST_P(PlateStress, NormLiesBelowTheLargestAndItsGradientPassesTheStepSweep) {
  Plate plate(GetParam());
  SolidStatics statics = plate.statics();
  const VectorXd p0 = plate.shape->start();
  const auto norm = [&](const VectorXd& p) {
    plate.shape->set(p);
    const Fractions f = plate.fractions();
    EXPECT_EQ(statics.solve(f.value), SolidStatus::Solved);
    return stress_norm(statics, f.derivative);
  };
  const StressNorm S = norm(p0);
  const VectorXd largest = von_mises(statics, 0.5).colwise().maxCoeff();
  for (int n = 0; n < statics.cases(); ++n) {
    EXPECT_LE(S.value[n], largest[n]);
    EXPECT_GT(S.value[n], 0.3 * largest[n]);
  }
  VectorXd d(p0.size());
  for (Eigen::Index i = 0; i < d.size(); ++i) d[i] = kScale * std::sin(1.0 + 2.7 * i);
  const VectorXd unit = (S.gradient.cwiseAbs() * d.cwiseAbs()).cwiseInverse();
  const auto along = [&](const VectorXd& t) -> VectorXd {
    return norm(p0 + t[0] * d).value.cwiseProduct(unit);
  };
  const StepSweep sweep =
      step_sweep(along, VectorXd::Zero(1).eval(), MatrixXd((S.gradient * d).cwiseProduct(unit)));
  EXPECT_LE(sweep.best_error, 1e-6);
  EXPECT_GE(sweep.slope_points, 3);
  EXPECT_NEAR(sweep.slope, 2, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Solids, PlateStress, ::testing::ValuesIn(plate_cases()),
                         [](const auto& c) { return c.param.name(); });

TEST(Connectivity, NamesTheInterfaceThatIsCutOff) {
  const Plate plate({2, false, Tie::Rigid});
  EXPECT_FALSE(cut_interface(plate.model, plate.fractions().value));
  VectorXd v = plate.fractions().value;
  const SolidMesh& mesh = plate.model.mesh();
  for (int e = 0; e < mesh.cell_count(); ++e)
    if (mesh.corners_of(e).row(0).minCoeff() > 0.15 && mesh.corners_of(e).row(0).minCoeff() < 0.16)
      v[e] = 0.01;
  const auto cut = cut_interface(plate.model, v);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->interface, "right");
  const auto bare = cut_interface(plate.model, VectorXd::Zero(mesh.cell_count()));
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->interface, "left");
}

TEST(Connectivity, CellsThatTouchInACornerAreNotJoined) {
  for (int dim : {2, 3}) {
    const SolidMesh mesh =
        dim == 2 ? quad_grid({0, 0}, {2, 2}, 2, 2) : hex_grid({0, 0, 0}, {2, 2, 1}, 2, 2, 1);
    const SolidModel model(mesh, {"m", 1, 0.3, 1},
                           {{"a", mesh.sets.at("x_min"), {0, 0, 0}, Tie::Rigid},
                            {"b", mesh.sets.at("x_max"), {0, 0, 0}, Tie::Rigid}},
                           {});
    VectorXd v(4);
    v << 1, 0, 0, 1;
    EXPECT_TRUE(cut_interface(model, v)) << dim;
    v << 1, 1, 0, 0;
    EXPECT_FALSE(cut_interface(model, v)) << dim;
  }
}

}  // namespace
}  // namespace liesl::test::stress_test
