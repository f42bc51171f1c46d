/// @file
/// Treatments of limits over time: what they are, their derivatives, and where they lead.
#include "optim/problems/treatment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "optim/cycle/motion_cycle.hpp"
#include "optim/problems/motion_problem.hpp"
#include "reference/studies.hpp"

namespace liesl::test::treatment_test {
namespace {

constexpr Treatment kAggregating[] = {Treatment::Functional, Treatment::PNorm, Treatment::Ks};

ConstraintSpec limited(Treatment treatment, double limit = 1, double p = 2) {
  ConstraintSpec out;
  out.limit = limit;
  out.treatment = treatment;
  out.p = p;
  return out;
}

/// |sin| over whole periods, on steps of two sizes.
struct Wave {
  std::vector<double> t, v;
  explicit Wave(int steps) {
    for (int n = 0; n <= steps; ++n) {
      const double s = static_cast<double>(n) / steps;
      t.push_back(s < 0.5 ? s * s * 2 : s);
      v.push_back(std::abs(std::sin(4 * std::numbers::pi * t.back())));
    }
  }
};

TEST(Treatment, PNormOfASineIsItsMeanInClosedFormWithOrderTwo) {
  double error[2];
  for (const int k : {0, 1}) {
    const Wave w(k == 0 ? 401 : 802);
    error[k] = std::abs(treated_value(limited(Treatment::PNorm), w.t, w.v) - std::sqrt(0.5));
  }
  EXPECT_LT(error[0], 1e-3);
  EXPECT_LT(error[1], error[0] / 3);
  const Wave w(2000);
  EXPECT_NEAR(treated_value(limited(Treatment::PNorm, 1, 1), w.t, w.v), 2 / std::numbers::pi, 1e-4);
  for (const double p : {4., 8., 100.})  // mean of |sin|^p
    EXPECT_NEAR(
        treated_value(limited(Treatment::PNorm, 1, p), w.t, w.v),
        std::pow(std::tgamma((p + 1) / 2) / (std::sqrt(std::numbers::pi) * std::tgamma(p / 2 + 1)),
                 1 / p),
        1e-4)
        << p;
}

TEST(Treatment, FunctionalIsTheMeanExcessAndZeroWhereTheLimitHolds) {
  const Wave w(4000);
  const double c = 0.5;  // mean of <sin - 1/2>: (2 cos(pi/6) - (pi - 2 pi/6)/2) / pi
  const double mean =
      (2 * std::cos(std::numbers::pi / 6) - std::numbers::pi / 3) / std::numbers::pi;
  EXPECT_NEAR(treated_value(limited(Treatment::Functional, c), w.t, w.v),
              c * (1 + std::pow(mean / c, 2.0 / 3)), 1e-5);
  const auto held = aggregates_of(limited(Treatment::Functional, 1.1), w.t, w.v);
  EXPECT_EQ(held[0].value, 1.1);
  EXPECT_TRUE(held[0].weight.empty());
}

/// Where the mean excess is of the order d^(3/2), and would be within any tolerance of the limit.
TEST(Treatment, FunctionalExceedsTheLimitInProportionToTheMaximum) {
  const Wave w(40000);
  const auto excess = [&](double d) {
    const double c = 1 / (1 + d);
    return treated_value(limited(Treatment::Functional, c), w.t, w.v) / c - 1;
  };
  EXPECT_NEAR(std::log2(excess(2e-3) / excess(1e-3)), 1, 0.01);
  EXPECT_GT(excess(1e-3), 2e-4);
}

TEST(Treatment, KsWeightsAboutEachMaximumSumToOne) {
  const Wave w(400);
  const auto all = aggregates_of(limited(Treatment::Ks), w.t, w.v);
  EXPECT_EQ(all.size(), 4u);
  for (const auto& a : all) {
    double sum = 0;
    for (const auto& [record, weight] : a.weight) sum += weight;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(a.value, w.v[static_cast<std::size_t>(a.record)]);
    EXPECT_LE(a.weight.size(), 7u);
  }
}

/// d(value)/dv of one record by differences; a maximum that keeps its place for KS.
TEST(Treatment, DerivativesAreThoseOfDifferences) {
  const Wave w(60);
  for (const Treatment t : {Treatment::Functional, Treatment::PNorm}) {
    const ConstraintSpec limit = limited(t, 0.5, 6);
    const auto at = aggregates_of(limit, w.t, w.v).front();
    for (std::size_t n = 3; n < w.v.size(); n += 7) {
      const double h = 1e-6;
      auto up = w.v, down = w.v;
      up[n] += h;
      down[n] -= h;
      const double d = (treated_value(limit, w.t, up) - treated_value(limit, w.t, down)) / (2 * h);
      const auto found = at.weight.find(static_cast<int>(n));
      EXPECT_NEAR(found == at.weight.end() ? 0 : found->second, d, 1e-8) << int(t) << " " << n;
    }
  }
}

TEST(Treatment, RecordsOfEachKind) {
  const std::vector<double> v{0, 1, 3, 2, 1, 0, 0, 1, 2, 1, 0, 0, 0, 1.4, 0};
  using Set = std::set<int>;
  EXPECT_EQ(treated_records(Treatment::Worst, v), Set{2});
  EXPECT_EQ(treated_records(Treatment::Maxima, v), (Set{2, 8})) << "below half does not count";
  EXPECT_EQ(treated_records(Treatment::All, v), (Set{2, 3, 8}));
  EXPECT_EQ(treated_records(Treatment::Neighbours, v), (Set{2, 8})) << "near_maxima joins others";
  for (const Treatment t : kAggregating) EXPECT_EQ(treated_records(t, v).size(), v.size());
}

TEST(Treatment, RecordsNearAMaximumAreAtMostTenFromIt) {
  Eigen::VectorXd v = Eigen::VectorXd::Zero(100);
  v[20] = 2, v[35] = 0.9, v[60] = 1.5, v[99] = 2;  // 35: below half of the largest
  using Sets = std::vector<std::set<int>>;
  EXPECT_EQ(near_maxima({{9, 10, 20, 30, 31, 40, 49, 50, 70, 71, 88, 89, 99, 100}}, {v}),
            (Sets{{10, 20, 30, 50, 70, 89, 99}}));
  EXPECT_EQ(near_maxima({{5}, {0, 1}}, {v, Eigen::VectorXd()}), (Sets{{}, {}}));
}

/// A static problem begins with the load cases that the treatment names, and takes those that turn
/// out to violate the limit: the cycles are as few as with any other.
TEST(Treatment, ChoosesTheLoadCasesOfStaticProblems) {
  StudyCase study = slider_crank_rod();
  study.spec.cycle.method = CycleMethod::Esl1;
  const Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  const DesignSimulator<SE2> simulator(study.scene.mechanism, space, study.scene.simulation,
                                       study.spec);
  const Eigen::VectorXd x = simulator.design().start();
  const DesignRun<SE2> run = simulator.run(x);
  ASSERT_TRUE(run.good()) << run.reason();
  for (const Treatment treatment : {Treatment::Worst, Treatment::Maxima, Treatment::Neighbours}) {
    SCOPED_TRACE(static_cast<int>(treatment));
    study.spec.constraints[0].treatment = treatment;
    const auto problem = motion_problem(study.spec, simulator, run, x, 0.3);
    const auto named = treated_records(treatment, run.limits[0].values);
    ASSERT_EQ(problem->load_cases(), static_cast<int>(named.size()));
    for (const RowImage& image : problem->images()) EXPECT_TRUE(named.contains(image.record));
    const auto r = run_cycle<SE2>(study.scene.mechanism, space, study.scene.simulation, study.spec);
    EXPECT_EQ(r.status, CycleStatus::Optimal) << r.reason;
    EXPECT_LE(r.history.size(), 8u) << "those of static problems, not of full";
  }
}

/// Whatever becomes of the limit, the lightest rod that meets it is one.
TEST(Treatment, AllOfTheLargestValueEndAtOneDesign) {
  double mass = 0;
  for (const Treatment treatment :
       {Treatment::Auto, Treatment::All, Treatment::Maxima, Treatment::Neighbours, Treatment::Ks}) {
    SCOPED_TRACE(static_cast<int>(treatment));
    StudyCase study = slider_crank_rod();
    study.spec.constraints[0].treatment = treatment;
    const auto r = run_cycle<SE2>(study.scene.mechanism, space_of<SE2>(study.scene.mechanism),
                                  study.scene.simulation, study.spec);
    EXPECT_EQ(r.status, CycleStatus::Optimal) << r.reason;
    EXPECT_LE(r.worst, 1e-3);
    if (mass == 0) mass = r.mass;
    EXPECT_NEAR(r.mass, mass, 2e-4 * mass);
  }
}

}  // namespace
}  // namespace liesl::test::treatment_test
