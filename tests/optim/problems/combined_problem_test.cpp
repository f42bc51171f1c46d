/// @file
/// Several static problems as one: the sums and blocks of its members.
#include "optim/problems/combined_problem.hpp"

#include <gtest/gtest.h>

#include <set>

#include "optim/nlp/check_derivatives.hpp"
#include "optim/nlp/ipopt_driver.hpp"

namespace liesl::test::combined_problem_test {
namespace {

/// minimise c |x|^2 subject to 1/x_j <= 1: x = (1, 1, ...). One more constraint after a look.
class Wells final : public StaticProblem {
 public:
  Wells(const std::string& name, int n, double c) : c_(c) {
    for (int j = 0; j < n; ++j) variables_.push_back({name + std::to_string(j), 0.1, 4, 2});
    add();
  }
  int add_violated(const Eigen::VectorXd&, double) override {
    if (constraints_.size() == variables_.size()) return 0;
    add();
    return 1;
  }
  int load_cases() const override { return static_cast<int>(constraints_.size()); }
  std::string undefined_reason() const override { return undefined_reason_; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    f = c_ * x.squaredNorm();
    for (int i = 0; i < g.size(); ++i) g[i] = 1 / x[i] - 1;
  }
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    df = 2 * c_ * x;
    dg.setZero();
    for (int i = 0; i < dg.rows(); ++i) dg(i, i) = -1 / (x[i] * x[i]);
  }
  std::string undefined_reason_;

 private:
  void add() { constraints_.push_back({constraints_.size(), "limit", 1}); }
  double c_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

struct Joined {
  Wells* first;
  Wells* second;
  CombinedProblem problem;

  static Joined make() {
    auto a = std::make_unique<Wells>("a", 2, 1.0), b = std::make_unique<Wells>("b", 3, 5.0);
    Wells *first = a.get(), *second = b.get();
    std::vector<CombinedProblem::Member> members;
    members.push_back({std::move(a), 1, 0});
    members.push_back({std::move(b), 0.5, 2});
    return {first, second, CombinedProblem(std::move(members))};
  }
};

TEST(CombinedProblem, AddsObjectivesAndStacksLimits) {
  Joined j = Joined::make();
  EXPECT_EQ(j.problem.variables().size(), 5u);
  EXPECT_EQ(j.problem.add_violated(Eigen::VectorXd::Constant(5, 2), 0), 2);
  ASSERT_EQ(j.problem.constraints().size(), 4u);
  EXPECT_EQ(j.problem.load_cases(), 4);
  const Eigen::VectorXd x = (Eigen::VectorXd(5) << 1, 2, 3, 0.5, 2).finished();
  double f = 0;
  Eigen::VectorXd g(4);
  j.problem.values(x, f, g);
  EXPECT_DOUBLE_EQ(f, (1 + 4) + 0.5 * 5 * (9 + 0.25 + 4));
  EXPECT_LE((g - Eigen::Vector4d(0, -0.5, 1 / 3. - 1, 1)).norm(), 1e-15);
}

TEST(CombinedProblem, HasUniqueIdsAndRightDerivatives) {
  Joined j = Joined::make();
  j.problem.add_violated(Eigen::VectorXd::Constant(5, 2), 0);
  std::set<ConstraintId> ids;
  for (const auto& c : j.problem.constraints()) ids.insert(c.id);
  EXPECT_EQ(ids.size(), j.problem.constraints().size());
  const DerivativeReport report =
      check_derivatives(j.problem, Eigen::VectorXd::Constant(5, 1.3), {});
  EXPECT_TRUE(report.right) << report.text();
}

TEST(CombinedProblem, TellsWhichMemberHasNoValue) {
  Joined j = Joined::make();
  EXPECT_EQ(j.problem.undefined_reason(), "");
  j.second->undefined_reason_ = "cut";
  EXPECT_EQ(j.problem.undefined_reason(), "cut");
}

/// Nothing couples the members: the joint optimum is theirs.
TEST(CombinedProblem, HasTheOptimaOfItsMembers) {
  Joined j = Joined::make();
  for (int round = 0; round < 3; ++round)
    j.problem.add_violated(Eigen::VectorXd::Constant(5, 2), 0);
  const NlpResult r = solve_ipopt(j.problem);
  ASSERT_TRUE(r.solved()) << r.reason;
  EXPECT_LE((r.x - Eigen::VectorXd::Ones(5)).cwiseAbs().maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace liesl::test::combined_problem_test
