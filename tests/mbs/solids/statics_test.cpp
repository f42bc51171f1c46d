#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "liegroup/numdiff.hpp"
#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"
#include "mbs/solids/plate.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl::test::statics_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

class SolidPlate : public ::testing::TestWithParam<PlateCase> {};

TEST_P(SolidPlate, SolvesTheEquationsAndLeavesNoRigidMotion) {
  Plate plate(GetParam());
  SolidStatics statics = plate.statics();
  ASSERT_EQ(statics.solve(plate.fractions().value), SolidStatus::Solved);
  MatrixXd r =
      plate.model.stiffness(plate.fractions().value).selfadjointView<Eigen::Lower>() * statics.q();
  r -= plate.loads;
  if (GetParam().relief) {
    const MatrixXd MR = plate.model.mass(plate.fractions().value).selfadjointView<Eigen::Lower>() *
                        plate.model.rigid_motions();
    EXPECT_LT((MR.transpose() * statics.q()).norm(), 1e-9 * MR.norm() * statics.q().norm());
    r += MR * (plate.model.rigid_motions().transpose() * MR)
                  .ldlt()
                  .solve(plate.model.rigid_motions().transpose() * plate.loads);
  } else {
    for (int c : plate.support.fixed) r.row(c).setZero();
  }
  EXPECT_LT(r.norm(), 1e-8 * plate.loads.norm());
}

/// All outputs and compliances of all cases, one after the other, as a function of the parameters.
TEST_P(SolidPlate, AdjointGradientsPassTheStepSweep) {
  Plate plate(GetParam());
  SolidStatics statics = plate.statics();
  const auto values = [&](const VectorXd& p) {
    plate.shape->set(p);
    EXPECT_EQ(statics.solve(plate.fractions().value), SolidStatus::Solved);
    VectorXd all(statics.y().size() + statics.cases());
    all << Eigen::Map<const VectorXd>(statics.y().data(), statics.y().size()), statics.compliance();
    return all;
  };
  const VectorXd p0 = plate.shape->start();
  const Eigen::Index rows = values(p0).size();
  const Fractions f = plate.fractions();
  MatrixXd J(rows, p0.size());
  for (int o = 0; o < statics.outputs(); ++o) {
    const MatrixXd g = statics.output_gradient(o, f.derivative);
    for (int n = 0; n < statics.cases(); ++n) J.row(n * statics.outputs() + o) = g.row(n);
  }
  J.bottomRows(statics.cases()) = statics.compliance_gradient(f.derivative);
  for (int k = 0; k < 3; ++k) {  // along directions that change every parameter
    VectorXd d(p0.size());
    for (Eigen::Index i = 0; i < d.size(); ++i) d[i] = kScale * std::sin(1.0 + 2.7 * i + 3.1 * k);
    const VectorXd exact = J * d;
    const VectorXd unit = (J.cwiseAbs() * d.cwiseAbs()).cwiseInverse();
    const auto along = [&](const VectorXd& t) -> VectorXd {
      return values(p0 + t[0] * d).cwiseProduct(unit);
    };
    const StepSweep sweep =
        step_sweep(along, VectorXd::Zero(1).eval(), MatrixXd(exact.cwiseProduct(unit)));
    EXPECT_LE(sweep.best_error, 1e-6) << k;
    EXPECT_GE(sweep.slope_points, 3) << k;
    EXPECT_NEAR(sweep.slope, 2, 0.3) << k;
  }
}

/// The same by the direct method: dq/dv = -K^-1 dK u, cell by cell, for a few cells.
TEST_P(SolidPlate, GradientsAgreeWithDifferencesInSingleFractions) {
  Plate plate(GetParam());
  SolidStatics statics = plate.statics();
  VectorXd v = plate.fractions().value.cwiseMax(0.3).cwiseMin(0.9);
  ASSERT_EQ(statics.solve(v), SolidStatus::Solved);
  FractionGradient identity(v.size(), v.size());
  identity.setIdentity();
  const MatrixXd g = statics.output_gradient(0, identity);
  for (int e = 3; e < v.size(); e += static_cast<int>(v.size()) / 5) {
    const double h = 1e-5, keep = v[e];
    v[e] = keep + h;
    ASSERT_EQ(statics.solve(v), SolidStatus::Solved);
    const MatrixXd plus = statics.y();
    v[e] = keep - h;
    ASSERT_EQ(statics.solve(v), SolidStatus::Solved);
    const MatrixXd difference = (plus - statics.y()) / (2 * h);
    v[e] = keep;
    EXPECT_LT((difference.row(0).transpose() - g.col(e)).norm(),
              1e-6 * g.cwiseAbs().maxCoeff() + 1e-6 * g.col(e).norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, SolidPlate, ::testing::ValuesIn(plate_cases()),
                         [](const auto& c) { return c.param.name(); });

TEST(SolidStatics, AnUnsupportedPartIsAStatusAndNotANaN) {
  Plate plate({2, false, Tie::Rigid});
  plate.support = {};
  SolidStatics statics = plate.statics();
  EXPECT_EQ(statics.solve(plate.fractions().value), SolidStatus::Unsupported);
  VectorXd v = plate.fractions().value;
  v[0] = std::nan("");
  EXPECT_EQ(statics.solve(v), SolidStatus::NotFinite);
}

TEST(SolidModel, RefusesInterfacesThatHoldNothing) {
  const SolidMesh mesh = quad_grid({0, 0}, {1, 1}, 2, 2);
  const Material m{"m", 1, 0.3, 1};
  const auto refused = [&](std::vector<Interface> interfaces, const std::string& words) {
    try {
      SolidModel model(mesh, m, std::move(interfaces), {});
      ADD_FAILURE() << words;
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  };
  refused({{"pin", {3}, {0, 0, 0}, Tie::Rigid}}, "interface 'pin': has 1 nodes");
  refused({{"pin", {3, 99}, {0, 0, 0}, Tie::Rigid}}, "node 99 is not in the mesh");
  refused({{"pin", {3, 4, 3}, {0, 0, 0}, Tie::Rigid}}, "the node at (0, 0.5) is listed twice");
  refused({{"pin", {3, 4}, {0, 0, 0}, Tie::Rigid}, {"eye", {4, 5}, {0, 0, 0}, Tie::Averaged}},
          "interface 'eye': the node at (0.5, 0.5) belongs to interface 'pin', too");
  const SolidMesh cube = hex_grid({0, 0, 0}, {1, 1, 1}, 2, 2, 2);
  EXPECT_THROW(SolidModel(cube, m, {{"line", {0, 1, 2}, {0, 0, 0}, Tie::Rigid}}, {}),
               std::invalid_argument);
  SolidMesh folded = mesh;
  folded.nodes.col(4) << 1.5, 1.5, 0;
  EXPECT_THROW(SolidModel(folded, m, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::statics_test
