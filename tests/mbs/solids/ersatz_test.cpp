/// The measurement behind the defaults of ErsatzLaw: elongation and deflection of a plate with a
/// round hole on coarse meshes, against the same plate on a mesh four times as fine, over places
/// of the hole.
#include "mbs/solids/ersatz.hpp"

#include <gtest/gtest.h>

#include "liegroup/numdiff.hpp"
#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl::test::ersatz_test {
namespace {

Eigen::Vector2d displacement(int ny, double x, double radius, ErsatzLaw law) {
  using namespace levelset;
  std::vector<Operand> operands;
  operands.push_back({"plate", placed_in_plane(0.05, 0, 0, rectangle(0.3, 0.1))});
  operands.push_back({"hole", placed_in_plane(x, 0.0013, 0, levelset::circle(radius))});
  const LevelSetPtr shape = subtract(std::move(operands));
  const SolidMesh mesh = quad_grid({0, -0.02}, {0.1, 0.02}, 5 * ny / 2, ny);
  SolidModel::Options options;
  options.thickness = 0.01;
  options.law = law;
  SolidModel model(mesh, {"steel", 210e9, 0.3, 7850},
                   {{"a", mesh.sets.at("x_min"), {0, 0, 0}, Tie::Rigid},
                    {"b", mesh.sets.at("x_max"), {0.1, 0, 0}, Tie::Rigid}},
                   options);
  Eigen::MatrixXd f = Eigen::MatrixXd::Zero(model.size(), 2);
  f(model.port(1), 0) = f(model.port(1) + 1, 1) = 1e4;
  SolidSupport support;
  fix_port(support, model, 0, "xyr");
  SolidStatics statics(model, support, {});
  statics.set_loads(f);
  EXPECT_EQ(statics.solve(volume_fractions(mesh, *shape, 8).value), SolidStatus::Solved);
  return {statics.q()(model.port(1), 0), statics.q()(model.port(1) + 1, 1)};
}

/// Mean relative error over eight holes and both displacements.
double mean_error(int ny, ErsatzLaw law) {
  static std::vector<Eigen::Vector2d> reference;
  const auto hole = [](int k) { return std::pair(0.045 + 0.0009 * k, 0.009 + 0.00041 * k); };
  if (reference.empty())
    for (int k = 0; k < 8; ++k)
      reference.push_back(displacement(64, hole(k).first, hole(k).second, {}));
  double error = 0;
  for (int k = 0; k < 8; ++k)
    error +=
        (displacement(ny, hole(k).first, hole(k).second, law).cwiseQuotient(reference[k]).array() -
         1)
            .abs()
            .sum() /
        16;
  return error;
}

TEST(Ersatz, DefaultExponentIsTheMostAccurateOfThoseTried) {
  const double own = mean_error(16, {});
  RecordProperty("default", std::to_string(own));
  for (double exponent : {1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 2.0, 3.0}) {
    ErsatzLaw law;
    law.exponent = exponent;
    const double error = mean_error(16, law);
    RecordProperty("exponent_" + std::to_string(exponent), std::to_string(error));
    EXPECT_LE(own, error * (1 + 1e-12)) << exponent;
  }
}

TEST(Ersatz, DefaultRatioCostsNoAccuracyThatShows) {
  const auto with = [](double ratio) {
    ErsatzLaw law;
    law.ratio = ratio;
    return mean_error(16, law);
  };
  EXPECT_NEAR(with(ErsatzLaw().ratio), with(1e-9), 2e-5);
  EXPECT_GT(std::abs(with(1e-3) - with(1e-9)), 2e-4);  // a larger one does
}

TEST(Ersatz, SlopeIsTheDerivative) {
  for (double exponent : {1.0, 1.5, 3.0}) {
    ErsatzLaw law{exponent, 1e-3};
    for (double v : {0.2, 0.7}) {
      const auto s = [&](double x) { return law.stiffness(x); };
      const Eigen::Matrix<double, 1, 1> J(law.slope(v));
      EXPECT_LE(step_sweep(s, v, J).best_error, 1e-9);
    }
    EXPECT_EQ(law.stiffness(0), 1e-3);
    EXPECT_EQ(law.stiffness(1), 1);
  }
}

}  // namespace
}  // namespace liesl::test::ersatz_test
