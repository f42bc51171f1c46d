/// @file
/// Branch and bound over sizes of catalogues against the enumeration of all designs, where the
/// continuous optimum of every box has a closed form.
#include "optim/cycle/catalogue_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace liesl::test::catalogue_tree_test {
namespace {

using Eigen::VectorXd;

/// minimise sum c_i x_i subject to prod x_i >= least, x > 0: the volume of members in series of
/// given strength.
struct Product {
  VectorXd c;
  double least;

  double objective(const VectorXd& x) const { return c.dot(x); }
  bool feasible(const VectorXd& x) const { return x.prod() >= least * (1 - 1e-12); }

  /// In a box: variables at bounds are taken out, the others have c_i x_i equal; by bisection on
  /// that value.
  BoxAnswer solve(const DesignBox& box) const {
    const auto at = [&](double t) {
      return VectorXd((t * c.cwiseInverse()).cwiseMax(box.lower).cwiseMin(box.upper));
    };
    if (!feasible(box.upper)) return {box.upper, objective(box.upper), false, true};
    if (feasible(box.lower)) return {box.lower, objective(box.lower), true, true};
    double low = 0, high = box.upper.cwiseProduct(c).maxCoeff();
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (feasible(at(middle)) ? high : low) = middle;
    }
    return {at(high), objective(at(high)), true, true};
  }
};

struct Case {
  Product problem;
  std::vector<CatalogueVariable> variables;
  DesignBox all;
};

Case random_case(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(0.5, 3);
  std::uniform_int_distribution<int> count(1, 5);
  const int n = 2 + static_cast<int>(seed % 3);
  Case out;
  out.problem.c = VectorXd::NullaryExpr(n, [&] { return number(generator); });
  out.all = {VectorXd::Constant(n, 0.1), VectorXd::Constant(n, 20), VectorXd::Ones(n), ""};
  for (int i = 0; i < n; ++i) {
    CatalogueVariable v{"x" + std::to_string(i), {}};
    double value = 0.3;
    for (int k = count(generator); k >= 0; --k) v.values.push_back(value += number(generator) / 2);
    out.variables.push_back(v);
  }
  out.problem.least = std::pow(number(generator), 3);
  return out;
}

/// Objective of the best of all designs of the catalogues; infinite: none is feasible.
double enumerated(const Case& c, VectorXd x, int i = 0) {
  if (i == x.size()) {
    const bool ok = c.problem.feasible(x);
    return ok ? c.problem.objective(x) : std::numeric_limits<double>::infinity();
  }
  double best = std::numeric_limits<double>::infinity();
  for (const double v : c.variables[std::size_t(i)].values) {
    x[i] = v;
    best = std::min(best, enumerated(c, x, i + 1));
  }
  return best;
}

int search(CatalogueTree& tree, const Product& problem) {
  int boxes = 0;
  while (const auto box = tree.next()) {
    tree.tell(problem.solve(*box));
    if (++boxes > 100000) break;
  }
  return boxes;
}

TEST(CatalogueTree, FindsTheBestOfAllDesigns) {
  int feasible = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Case c = random_case(seed);
    CatalogueTree tree(c.variables, c.all, 0);
    search(tree, c.problem);
    const double best = enumerated(c, c.all.start);
    EXPECT_EQ(tree.found(), std::isfinite(best)) << seed;
    if (!std::isfinite(best)) continue;
    ++feasible;
    EXPECT_DOUBLE_EQ(tree.best(), best) << seed;
    EXPECT_EQ(tree.gap(), 0) << seed;
  }
  EXPECT_GT(feasible, 100);
  EXPECT_LT(feasible, 300);
}

TEST(CatalogueTree, IsNoWorseThanTheGapAndSearchesLess) {
  long exact = 0, within = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Case c = random_case(seed);
    CatalogueTree all(c.variables, c.all, 0), rough(c.variables, c.all, 0.1);
    exact += search(all, c.problem);
    within += search(rough, c.problem);
    ASSERT_EQ(all.found(), rough.found());
    if (!all.found()) continue;
    EXPECT_LE(rough.best(), 1.1 * all.best() * (1 + 1e-12)) << seed;
    EXPECT_LE(rough.bound(), all.best() * (1 + 1e-12)) << seed;  // is a bound
    EXPECT_LE(rough.gap(), 0.1 + 1e-12) << seed;
  }
  EXPECT_LT(within, exact);
}

TEST(CatalogueTree, LeavesVariablesWithoutCatalogueBetweenTheirBounds) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Case c = random_case(seed);
    c.variables[0].values.clear();
    CatalogueTree tree(c.variables, c.all, 0);
    search(tree, c.problem);
    double best = std::numeric_limits<double>::infinity();  // by enumeration of the others
    std::function<void(VectorXd, int)> each = [&](VectorXd x, int i) {
      if (i == x.size()) {
        x[0] = std::max(c.all.lower[0], c.problem.least / x.tail(x.size() - 1).prod());
        if (x[0] <= c.all.upper[0]) best = std::min(best, c.problem.objective(x));
        return;
      }
      for (const double v : c.variables[std::size_t(i)].values) {
        x[i] = v;
        each(x, i + 1);
      }
    };
    each(c.all.start, 1);
    ASSERT_TRUE(tree.found()) << seed;
    EXPECT_NEAR(tree.best(), best, 1e-9 * best) << seed;
  }
}

TEST(CatalogueTree, TakesTheBoundAroundABoxThatDidNotClose) {
  const Case c = random_case(4);
  CatalogueTree tree(c.variables, c.all, 0);
  bool first = true;
  while (const auto box = tree.next()) {
    BoxAnswer answer = c.problem.solve(*box);
    if (!first && answer.feasible) answer.closed = false;
    first = false;
    tree.tell(answer);
  }
  EXPECT_GT(tree.undecided(), 0);
  EXPECT_DOUBLE_EQ(tree.best(), enumerated(c, c.all.start));  // found all the same
}

TEST(CatalogueTree, RefusesACatalogueWithoutAValue) {
  const DesignBox all{VectorXd::Ones(1), VectorXd::Constant(1, 2.), VectorXd::Ones(1), ""};
  EXPECT_THROW(CatalogueTree({{"d", {3, 4}}}, all, 0), std::invalid_argument);
}

TEST(BoxAnswer, IsTheBestCycleAndSaysWhetherItClosed) {
  const double feasibility = 1e-3;
  EXPECT_EQ(box_answer({}, feasibility).x.size(), 0);
  History history(3);
  const double objective[] = {3, 1, 2}, worst[] = {-0.1, 0.2, -0.05};
  for (int i = 0; i < 3; ++i) {
    history[std::size_t(i)].x = VectorXd::Constant(1, i);
    history[std::size_t(i)].objective = objective[i];
    history[std::size_t(i)].worst = worst[i];
  }
  EXPECT_EQ(box_answer(history, feasibility).x[0], 2);
  EXPECT_FALSE(box_answer(history, feasibility).closed);
  history.back().end = CycleStatus::Optimal;
  EXPECT_TRUE(box_answer(history, feasibility).closed);
  history.back().end = CycleStatus::CycleLimit;
  EXPECT_FALSE(box_answer(history, feasibility).closed);
  for (Cycle& cycle : history) cycle.worst = 0.3;
  history.back().end = CycleStatus::Infeasible;
  EXPECT_TRUE(box_answer(history, feasibility).closed);
  EXPECT_FALSE(box_answer(history, feasibility).feasible);
}

}  // namespace
}  // namespace liesl::test::catalogue_tree_test
