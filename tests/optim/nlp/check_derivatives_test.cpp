#include "optim/nlp/check_derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "optim/nlp/elastic.hpp"
#include "optim/nlp/evaluator.hpp"
#include "optim/nlp/fitted_slope.hpp"
#include "optim/nlp/separable.hpp"
#include "reference/many_load_cases.hpp"
#include "reference/svanberg_beam.hpp"
#include "reference/ten_bar_truss.hpp"

namespace liesl::test::check_derivatives_test {
namespace {

void expect_right(Problem& p, const Eigen::VectorXd& x) {
  const DerivativeReport report = check_derivatives(p, x);
  EXPECT_TRUE(report.right) << report.text();
  int slopes = 0;
  for (const auto& c : report.checks)
    if (c.slope) {
      EXPECT_NEAR(*c.slope, 2, 0.1) << c.function;
      ++slopes;
    }
  EXPECT_GE(slopes, 1) << report.text();
}

TEST(CheckDerivatives, SlopeTwoForRightOnes) {
  SvanbergBeam beam;
  TenBarTruss truss;
  ManyLoadCases cases(6, 40);
  expect_right(beam, start_of(beam));
  expect_right(truss, start_of(truss));
  expect_right(cases, start_of(cases));
}

TEST(CheckDerivatives, LinearFunctionsHaveNoSlope) {
  SvanbergBeam beam;
  const DerivativeReport report = check_derivatives(beam, start_of(beam));
  EXPECT_EQ(report.checks[0].function, "objective");
  EXPECT_FALSE(report.checks[0].slope.has_value());
  EXPECT_TRUE(report.checks[0].right);
}

TEST(CheckDerivatives, FindsAWrongGradientAndHessian) {
  class Wrong : public SvanbergBeam {
   public:
    void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
      SvanbergBeam::gradients(x, df, dg);
      dg(0, 3) *= 1.001;
    }
  } wrong;
  DerivativeCheckOptions each;
  each.every_variable = true;
  each.hessian = false;
  const DerivativeReport report = check_derivatives(wrong, start_of(wrong), each);
  EXPECT_FALSE(report.right);
  for (const auto& c : report.checks)
    EXPECT_EQ(c.right, !(c.direction == "x4" && c.function == "tip displacement")) << c.direction;
  ASSERT_NE(report.worst(), nullptr);
  EXPECT_EQ(report.worst()->direction, "x4");
  EXPECT_NEAR(report.worst()->slope.value_or(9), 0, 0.5);
  EXPECT_NE(report.text().find("WRONG"), std::string::npos);

  class WrongHessian : public SvanbergBeam {
   public:
    void hessian(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& l,
                 Eigen::MatrixXd& h) override {
      SvanbergBeam::hessian(x, s, l, h);
      h *= 1.01;
    }
  } curved;
  const DerivativeReport second = check_derivatives(curved, start_of(curved));
  EXPECT_FALSE(second.right);
  EXPECT_EQ(second.worst()->function, "Hessian of the Lagrangian");
}

/// A displacement with a kink at x1 = 5: the derivative given is that of one side.
class Kinked : public SvanbergBeam {
 public:
  bool wrong = false;
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    SvanbergBeam::values(x, f, g);
    g[0] += 0.1 * std::abs(x[0] - 5);
  }
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    SvanbergBeam::gradients(x, df, dg);
    dg(0, 0) += x[0] < 5 ? -0.1 : 0.1;
    if (wrong) dg(0, 3) *= 1.001;
  }
};

/// A function that changes by round-off alone has the derivative zero; one that changes has not.
TEST(CheckDerivatives, OfAFunctionThatDoesNotChangeIsZero) {
  struct Prescribed : SvanbergBeam {
    double changes = 0, derivative = 0;
    void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
      SvanbergBeam::values(x, f, g);
      g[0] = 3 + 1e-13 * std::sin(1e5 * x.sum()) + changes * x.sum();
    }
    void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
      SvanbergBeam::gradients(x, df, dg);
      dg.row(0).setConstant(derivative);
    }
    HessianShape hessian_shape() const override { return HessianShape::None; }
  } problem;
  problem.derivative = 1e-16;
  const Eigen::VectorXd x = start_of(problem);
  EXPECT_TRUE(check_derivatives(problem, x).right) << check_derivatives(problem, x).text();
  problem.changes = 1e-6;
  EXPECT_FALSE(check_derivatives(problem, x).right) << "a derivative that is left out";
}

/// Where nothing beside the point has values, a derivative is neither right nor called wrong.
TEST(CheckDerivatives, WithoutValuesBesideThePointNothingIsCompared) {
  struct Alone : SvanbergBeam {
    Eigen::VectorXd at;
    void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
      SvanbergBeam::values(x, f, g);
      if ((x - at).norm() > 0) g.setConstant(NAN);
    }
    HessianShape hessian_shape() const override { return HessianShape::None; }
  } problem;
  problem.at = start_of(problem);
  const DerivativeReport report = check_derivatives(problem, problem.at);
  EXPECT_FALSE(report.right);
  EXPECT_GT(report.failed_evaluations, 0);
  EXPECT_NE(report.text().find(", 0 wrong"), std::string::npos) << report.text();
  EXPECT_NE(report.text().find("could not be compared"), std::string::npos) << report.text();
}

/// No difference at a kink tells whether a derivative is right: it is named, and the derivatives
/// are checked beside it. One that is wrong stays so.
TEST(CheckDerivatives, MovesOffKinksAndNamesThem) {
  DerivativeCheckOptions each;
  each.every_variable = true;
  each.hessian = false;
  Kinked kinked;
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(5, 5);
  const DerivativeReport report = check_derivatives(kinked, x, each);
  EXPECT_TRUE(report.right) << report.text();
  ASSERT_EQ(report.kinks.size(), 1u) << report.text();
  EXPECT_EQ(report.kinks[0].direction, "x1");
  EXPECT_EQ(report.kinks[0].functions, 1);
  EXPECT_GT(report.kinks[0].jump, 0.1);
  EXPECT_GT((report.x - x).cwiseAbs().minCoeff(), 0.01);
  EXPECT_NE(report.text().find("along x1: 1 functions, left and right derivative differ"),
            std::string::npos);
  kinked.wrong = true;
  const DerivativeReport second = check_derivatives(kinked, x, each);
  EXPECT_FALSE(second.right);
  EXPECT_EQ(second.worst()->direction, "x4");
  const Eigen::VectorXd off = Eigen::VectorXd::Constant(5, 5.5);
  kinked.wrong = false;
  EXPECT_TRUE(check_derivatives(kinked, off, each).kinks.empty());
}

/// The differences of a derivative that bends fall with h: it is not judged. Those of one that
/// bends and is off by 1e-3 settle on another value: it is wrong.
TEST(CheckDerivatives, ABendDoesNotExcuseAWrongDerivative) {
  struct Bent : SvanbergBeam {
    double range = NlpScaling::of_variables(*this)[0], error = 0;
    void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
      SvanbergBeam::values(x, f, g);
      const double v = x[0] - 5;
      g[0] = 1 + v + v * std::abs(v) / range;
    }
    void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
      SvanbergBeam::gradients(x, df, dg);
      dg.row(0).setZero();
      dg(0, 0) = 1 + 2 * std::abs(x[0] - 5) / range - error;
    }
  } bent;
  DerivativeCheckOptions there;
  there.every_variable = true;
  there.hessian = false;
  there.avoid_kinks = false;
  there.largest_step = 0.03;
  there.steps = 8;
  const auto judged = [&] {
    const DerivativeReport report = check_derivatives(bent, Eigen::VectorXd::Constant(5, 5), there);
    for (const DerivativeCheck& c : report.checks)
      if (c.direction == "x1" && c.function != "objective") return c;
    return DerivativeCheck();
  };
  there.tolerance = 1e-6;
  EXPECT_TRUE(judged().kink);
  bent.error = 1e-3;
  const DerivativeCheck wrong = judged();
  EXPECT_FALSE(wrong.right);
  EXPECT_FALSE(wrong.kink);
  ASSERT_TRUE(wrong.slope);
  EXPECT_GT(*wrong.slope, 0.3) << "what a bend alone has, too";
}

/// base + size (sin x_1 + round-off), with a derivative that is off by `error`.
struct Noisy : SvanbergBeam {
  double base = 0, size = 1, noise = 0, error = 0;
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    SvanbergBeam::values(x, f, g);
    g[0] = base + size * (std::sin(x[0]) + noise * std::sin(1e13 * x[0]));
  }
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    SvanbergBeam::gradients(x, df, dg);
    dg.row(0).setZero();
    dg(0, 0) = size * std::cos(x[0]) * (1 + error);
  }
};

/// Of the function with the round-off.
DerivativeCheck judged(Noisy& noisy, bool fits = false) {
  DerivativeCheckOptions o;
  o.fits = fits;
  o.every_variable = true;
  o.hessian = false;
  const DerivativeReport report = check_derivatives(noisy, Eigen::VectorXd::Constant(5, 4.2), o);
  EXPECT_TRUE(report.kinks.empty()) << report.text();
  EXPECT_EQ(report.right, report.text().find("WRONG") == std::string::npos);
  EXPECT_NE(report.text().find("extrapolated"), std::string::npos);
  for (const DerivativeCheck& c : report.checks)
    if (c.direction == "x1" && c.function != "objective") return c;
  ADD_FAILURE() << report.text();
  return {};
}

/// A function that hardly changes, with round-off that its differences do not get below: no kink,
/// and not judged. A derivative that is off by more than this round-off hides is wrong.
TEST(CheckDerivatives, RoundOffIsNoKinkAndExcusesNoWrongDerivative) {
  Noisy noisy;
  noisy.base = 1;
  noisy.size = 1e-3;
  EXPECT_TRUE(judged(noisy).right);
  for (const double noise : {1e-7, 1e-6, 1e-5}) {
    noisy.noise = noise;
    noisy.error = 0;
    EXPECT_FALSE(judged(noisy).right) << noise;
    EXPECT_TRUE(judged(noisy).round_off) << noise;
    noisy.error = 3e3 * noise;
    EXPECT_FALSE(judged(noisy).right) << noise;
    EXPECT_FALSE(judged(noisy).round_off) << noise;
  }
}

/// Of a function with round-off extrapolated differences come nearer, and no nearer to a derivative
/// that is wrong.
TEST(CheckDerivatives, ExtrapolatedDifferencesAreFartherFromRoundOff) {
  Noisy noisy;
  noisy.noise = 1e-10;
  const DerivativeCheck right = judged(noisy);
  ASSERT_TRUE(right.slope);
  EXPECT_NEAR(*right.slope, 2, 0.1);
  EXPECT_LT(right.best_error, 1e-6);
  EXPECT_LT(right.extrapolated_error, right.best_error / 5);
  noisy.error = 1e-4;
  EXPECT_NEAR(judged(noisy).extrapolated_error, 1e-4, 1e-6);
}

/// A fit to many differences is nearer than the best of them, by what its own standard error says,
/// and finds what a derivative is off by.
TEST(CheckDerivatives, FitsAverageRoundOff) {
  Noisy noisy;
  for (const double noise : {1e-12, 1e-10, 1e-8}) {
    noisy.noise = noise;
    noisy.error = 0;
    const DerivativeCheck right = judged(noisy, true);
    ASSERT_TRUE(right.fitted_error && right.fitted_deviation) << noise;
    EXPECT_LT(*right.fitted_error, right.best_error / 5) << noise;
    EXPECT_LT(*right.fitted_error, 5 * *right.fitted_deviation) << noise;
    EXPECT_LT(*right.fitted_deviation, 1e3 * noise) << noise;
    noisy.error = 1e-4;
    EXPECT_NEAR(*judged(noisy, true).fitted_error, 1e-4, 1e-6) << noise;
  }
  EXPECT_FALSE(judged(noisy).fitted_error);
}

/// Of sin x over every window, to round-off; of white noise the standard error is what slopes
/// scatter by.
TEST(OddFits, SlopesAndTheirStandardErrors) {
  const OddFits fits;
  for (const double window : OddFits::kWindows) {
    const FittedSlope fit = fits((window * fits.points()).array().sin(), window);
    EXPECT_NEAR(fit.slope, 1, 1e-12 + 1e-15 / window) << window;
  }
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1e-3);
  constexpr int kTimes = 400;
  double scatter = 0, deviation = 0;
  for (int k = 0; k < kTimes; ++k) {
    Eigen::VectorXd odd = 3 * fits.points();
    for (double& value : odd) value += normal(random);
    const FittedSlope fit = fits(odd, 1);
    scatter += std::pow(fit.slope - 3, 2) / kTimes;
    deviation += std::pow(fit.deviation, 2) / kTimes;
  }
  EXPECT_GT(std::sqrt(deviation), 0.5 * std::sqrt(scatter));
  EXPECT_LT(std::sqrt(deviation), 1.5 * std::sqrt(scatter));
}

/// A pair of points of each step, and those of the fits: none of them is left out of progress.
TEST(CheckDerivatives, TellsHowFarItIs) {
  Noisy noisy;
  DerivativeCheckOptions o;
  o.fits = true;
  int last = 0;
  o.progress = [&](int pairs) { EXPECT_EQ(pairs, ++last); };
  check_derivatives(noisy, Eigen::VectorXd::Constant(5, 4.2), o);
  EXPECT_EQ(last, o.pairs());
  o.fits = false;
  last = 0;
  check_derivatives(noisy, Eigen::VectorXd::Constant(5, 4.2), o);
  EXPECT_EQ(last, o.pairs());
}

TEST(CheckDerivatives, StaysWithinTheBounds) {
  class Guarded : public SvanbergBeam {
   public:
    void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
      EXPECT_GE(x.minCoeff(), 1 - 1e-12);
      EXPECT_LE(x.maxCoeff(), 10 + 1e-12);
      SvanbergBeam::values(x, f, g);
    }
  } beam;
  EXPECT_TRUE(check_derivatives(beam, Eigen::VectorXd::Ones(5)).right);
}

TEST(CheckDerivatives, RefusesInvalidInput) {
  SvanbergBeam beam;
  EXPECT_THROW(check_derivatives(beam, Eigen::VectorXd::Ones(4)), std::invalid_argument);
  DerivativeCheckOptions o;
  o.largest_step = 2;
  EXPECT_THROW(check_derivatives(beam, start_of(beam), o), std::invalid_argument);
}

TEST(SeparableModel, FirstOrderAtItsPointAndRightDerivatives) {
  TenBarTruss truss(HessianShape::None, 3);
  NlpOptions o;
  Evaluator e(truss, o);
  SeparableModel::Expansion at;
  at.y = e.start();
  ASSERT_TRUE(e.gradients(at.y));
  at.l = at.y.array() - 0.3, at.u = at.y.array() + 0.3;
  at.alpha = (at.y.array() - 0.05).matrix(), at.beta = (at.y.array() + 0.2).matrix();
  at.f = e.F(), at.df = e.dF(), at.g = e.G(), at.dg = e.dG();
  at.f_rho = 0.1;
  at.g_rho.setConstant(e.m(), 0.1);
  SeparableModel model(truss, at);
  ASSERT_GT(model.kept().size(), 0u);
  const int m = static_cast<int>(model.kept().size());
  double f = 0;
  Eigen::VectorXd g(m), df(e.n());
  RowMatrix dg(m, e.n());
  model.values(at.y, f, g);
  model.gradients(at.y, df, dg);
  EXPECT_NEAR(f, at.f, 1e-12);
  EXPECT_LE((df - at.df).cwiseAbs().maxCoeff(), 1e-12);
  for (int k = 0; k < m; ++k) {
    EXPECT_NEAR(g[k], at.g[model.kept()[k]], 1e-10);
    EXPECT_LE((dg.row(k) - at.dg.row(model.kept()[k])).cwiseAbs().maxCoeff(), 1e-10);
  }
  expect_right(model, at.y);
}

TEST(ElasticProblem, RightDerivatives) {
  TenBarTruss truss;
  const Eigen::VectorXd x = start_of(truss);
  ElasticProblem p(truss, {0.8, 30}, Eigen::VectorXd::Constant(36, 0.7), x, 0.5);
  expect_right(p, start_of(p));
}

/// What is looked for where no point of an elastic problem was found: its least violation.
TEST(ElasticProblem, MayBeElasticOnceMore) {
  TenBarTruss truss;
  const Eigen::VectorXd x = start_of(truss), scale = Eigen::VectorXd::Ones(36);
  ElasticProblem once(truss, {1, 30}, scale, x, 0.5);
  ElasticProblem twice(once, {0, 1}, scale, start_of(once), 0.5);
  EXPECT_TRUE(problem_errors(twice).empty()) << problem_errors(twice).front();
}

}  // namespace
}  // namespace liesl::test::check_derivatives_test
