#include "mbs/solids/reduction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numbers>

#include "liegroup/numdiff.hpp"
#include "mbs/linalg/stop_after.hpp"
#include "mbs/linalg/symmetric_modes.hpp"
#include "mbs/solids/plate.hpp"

namespace liesl::test::reduction_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(SymmetricModes, AgreeWithTheDenseSolver) {
  Plate plate({2, false, Tie::Rigid});
  const VectorXd v = plate.fractions().value.cwiseMax(0.1);
  const auto K = plate.model.stiffness(v);
  const auto M = plate.model.mass(v);
  const SymmetricModes modes = symmetric_modes(K, M, 8);
  ASSERT_TRUE(modes.converged);
  const MatrixXd Kd = MatrixXd(K).selfadjointView<Eigen::Lower>();
  const MatrixXd Md = MatrixXd(M).selfadjointView<Eigen::Lower>();
  const VectorXd dense =
      Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(Kd, Md).eigenvalues().head(8);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(modes.lambda[i], dense[i], 1e-7 * dense[7]);
  EXPECT_LT((modes.phi.transpose() * Md * modes.phi - MatrixXd::Identity(8, 8)).norm(), 1e-8);
}

/// Eigenvalues that occur several times: the six free motions, and the tones of a square bar.
TEST(SymmetricModes, FreeMotionsAreTakenOutAndEqualTonesAreBothFound) {
  const SolidMesh mesh = hex_grid({0, 0, 0}, {1, 0.1, 0.1}, 12, 2, 2);
  SolidModel model(mesh, {"steel", 210e9, 0.3, 7850}, {}, {});
  const VectorXd v = VectorXd::Ones(mesh.cell_count());
  const auto K = model.stiffness(v);
  const auto M = model.mass(v);
  const MatrixXd Kd = MatrixXd(K).selfadjointView<Eigen::Lower>();
  const MatrixXd Md = MatrixXd(M).selfadjointView<Eigen::Lower>();
  const VectorXd dense =
      Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(Kd, Md).eigenvalues().segment(6, 12);
  for (const int count : {1, 2, 4, 12}) {
    const SymmetricModes modes = symmetric_modes(K, M, count, model.rigid_motions());
    ASSERT_TRUE(modes.converged) << count;
    ASSERT_EQ(modes.lambda.size(), count);
    for (int i = 0; i < count; ++i) EXPECT_NEAR(modes.lambda[i] / dense[i], 1, 1e-7) << count;
    EXPECT_LT((modes.phi.transpose() * Md * model.rigid_motions()).norm(),
              1e-8 * (Md * model.rigid_motions()).norm());
  }
}

/// A part is given up between two looks, wherever that is; they are as many as there are solutions.
TEST(Reduction, LooksWhetherItIsStillWanted) {
  Plate plate({2, false, Tie::Rigid});
  const VectorXd v = plate.fractions().value.cwiseMax(0.1);
  const auto work = [&] { return reduce(plate.model, v, ReductionKind::CraigBampton, 6); };
  constexpr int kMany = 1 << 20;
  int looks = 0;
  {
    const StopAfter never(kMany);
    EXPECT_TRUE(work().converged);
    looks = kMany - never.unused();
  }
  EXPECT_GT(looks, 50);
  for (const int n : {0, 1, 2, looks / 2, looks - 1}) {
    const StopAfter stop(n);
    EXPECT_THROW(work(), Stopped) << n;
  }
}

/// Euler-Bernoulli free-free bar: f_1 = 4.73004^2/(2 pi L^2) sqrt(EI/(rho A)).
TEST(FreeFrequencies, OfASlenderBarAreThoseOfABeam) {
  const double L = 1, h = 0.01;
  const SolidMesh mesh = quad_grid({0, -h / 2}, {L, h / 2}, 100, 1);
  SolidModel::Options options;
  options.thickness = h;
  SolidModel model(mesh, {"steel", 210e9, 0.3, 7850}, {}, options);
  const VectorXd f = free_frequencies(model, VectorXd::Ones(100), 2);
  ASSERT_EQ(f.size(), 2);
  const double c = std::sqrt(210e9 * h * h / 12 / 7850) / (2 * std::numbers::pi * L * L);
  EXPECT_NEAR(f[0] / (4.730040744862704 * 4.730040744862704 * c), 1, 2e-3);
  EXPECT_NEAR(f[1] / (7.853204624095838 * 7.853204624095838 * c), 1, 4e-3);
}

class PlateReduction : public ::testing::TestWithParam<PlateCase> {};

TEST_P(PlateReduction, FreeFrequenciesAreThoseOfTheMesh) {
  Plate plate(GetParam());
  const VectorXd v = plate.fractions().value;
  const int rigid = plate.model.rigid_count();
  const VectorXd full = free_frequencies(plate.model, v, 6);
  ASSERT_EQ(full.size(), 6);
  for (ReductionKind kind : {ReductionKind::CraigBampton, ReductionKind::FreeInterface}) {
    const ReducedSolid r = reduce(plate.model, v, kind, 20);
    ASSERT_TRUE(r.converged);
    const VectorXd f = free_frequencies(r, rigid, 6);
    for (int i = 0; i < 6; ++i) {
      EXPECT_GE(f[i], full[i] * (1 - 1e-7));  // Ritz: from above
      EXPECT_LE(f[i], full[i] * 1.01) << i;
    }
    const VectorXd fewer = free_frequencies(reduce(plate.model, v, kind, 5), rigid, 2);
    EXPECT_GE(fewer[0], f[0] * (1 - 1e-9));
    EXPECT_GE(fewer[1], f[1] * (1 - 1e-9));
  }
}

TEST_P(PlateReduction, StaticsUnderPortLoadsAreExact) {
  Plate plate(GetParam());
  if (GetParam().relief) return;
  const VectorXd v = plate.fractions().value;
  SolidStatics statics = plate.statics();
  ASSERT_EQ(statics.solve(v), SolidStatus::Solved);
  const ReducedSolid r = reduce(plate.model, v, ReductionKind::CraigBampton, 3);
  const int n = plate.model.rigid_count();  // the first port is held
  const auto tail = r.K.cols() - n;
  const MatrixXd eta = r.K.bottomRightCorner(tail, tail)
                           .ldlt()
                           .solve((r.basis.transpose() * plate.loads).bottomRows(tail));
  const MatrixXd q = r.basis.rightCols(tail) * eta;
  EXPECT_LT((q - statics.q()).norm(), 1e-7 * q.norm());
}

TEST_P(PlateReduction, RigidMotionsCostNothingAndHaveTheMassOfTheCells) {
  Plate plate(GetParam());
  const VectorXd v = plate.fractions().value;
  const int dim = GetParam().dim;
  const MatrixXd& R = plate.model.rigid_motions();
  const MatrixXd KR = plate.model.stiffness(v).selfadjointView<Eigen::Lower>() * R;
  EXPECT_LT(KR.norm(), 1e-9 * plate.model.stiffness(v).norm() * R.norm());
  const InertiaIntegrals I = inertia_integrals(plate.model, v, R);
  EXPECT_NEAR(I.mass, plate.model.total_mass(v), 1e-12 * I.mass);
  const MatrixXd MR = plate.model.mass(v).selfadjointView<Eigen::Lower>() * R;
  const MatrixXd M = R.transpose() * MR;
  // Translations move all of the mass; rotation about z has int rho (x^2 + y^2).
  EXPECT_LT((I.mode.leftCols(dim) - I.mass * MatrixXd::Identity(3, dim)).norm(), 1e-12 * I.mass);
  const int z = plate.model.rigid_count() - 1;
  EXPECT_NEAR(M(z, z), I.second(0, 0) + I.second(1, 1), 1e-12 * M(z, z));
  EXPECT_NEAR(I.cross[z](0, 1), I.second(0, 0), 1e-12);  // phi_y = x
  EXPECT_NEAR(I.mode(1, z), I.first[0], 1e-12);
  for (int k = 0; k <= z; ++k)
    for (int l = 0; l <= z; ++l)
      EXPECT_NEAR(I.product[k * (z + 1) + l].trace(), M(k, l), 1e-12 * I.mass);
}

TEST_P(PlateReduction, FrequencyGradientsPassTheStepSweep) {
  Plate plate(GetParam());
  const VectorXd p0 = plate.shape->start();
  const int count = 3;
  const Fractions f0 = plate.fractions();
  const FrequencyGradient g = free_frequency_gradient(plate.model, f0.value, f0.derivative, count);
  VectorXd d(p0.size());
  for (Eigen::Index i = 0; i < d.size(); ++i) d[i] = kScale * std::sin(1.0 + 2.7 * i);
  const VectorXd unit = (g.gradient.cwiseAbs() * d.cwiseAbs()).cwiseInverse();
  const auto along = [&](const VectorXd& t) -> VectorXd {
    plate.shape->set(p0 + t[0] * d);
    return free_frequencies(plate.model, plate.fractions().value, count).cwiseProduct(unit);
  };
  const StepSweep sweep =
      step_sweep(along, VectorXd::Zero(1).eval(), MatrixXd((g.gradient * d).cwiseProduct(unit)));
  EXPECT_LE(sweep.best_error, 1e-6);
  EXPECT_NEAR(sweep.slope, 2, 0.6);  // 1 would be one-sided, 0 wrong
}

INSTANTIATE_TEST_SUITE_P(Solids, PlateReduction, ::testing::ValuesIn(plate_cases()),
                         [](const auto& c) { return c.param.name(); });

}  // namespace
}  // namespace liesl::test::reduction_test
