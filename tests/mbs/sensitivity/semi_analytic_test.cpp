/// @file
/// The semi-analytic form against the analytic one: first order in its perturbation, and solves
/// with the frozen factor that come nearer one by one.

#include "mbs/sensitivity/semi_analytic.hpp"

#include <memory>

#include "mbs/sensitivity/machine.hpp"

namespace liesl::test::semi_analytic_test {
namespace {

using Eigen::MatrixXd;
using test::Taped;

template <class G>
class SemiAnalytic : public ::testing::Test {
 protected:
  const Mechanism machine = test::sensitive_machine();
  const std::vector<test::Quantity> all = test::quantities(machine);
  const Taped<G> run{machine, test::tight(0.0025, 5e-5)};

  /// v' of all nodes at the last step, a column a parameter, in units of its nominal value.
  template <class Form>
  MatrixXd of(Form form) const {
    MatrixXd last;
    const SensitivityEnd end =
        form([&](long, const State<G>&, const StateSensitivity& ds) { last = ds.v; });
    EXPECT_TRUE(end.complete()) << end.reason;
    for (long p = 0; p < last.cols(); ++p) last.col(p) *= all[std::size_t(p)].nominal;
    return last;
  }
  MatrixXd analytic() const {
    const auto parameters = run.parameters(all);
    return of([&](const SensitivityAt<G>& at) {
      return direct_sensitivity<G>(run.model, run.tape, parameters, at);
    });
  }
  MatrixXd semi_analytic(double change, const StepFactor& factor) const {
    std::vector<std::unique_ptr<Model<G>>> models;
    std::vector<PerturbedModel<G>> perturbed;
    for (const auto& q : all) {
      Mechanism m = machine;
      q.set(m, q.nominal * (1 + change));
      models.push_back(std::make_unique<Model<G>>(Model<G>::build(m, test::space_of<G>(m))));
      perturbed.push_back({models.back().get(), q.nominal * change});
    }
    return of([&](const SensitivityAt<G>& at) {
      return semi_analytic_sensitivity<G>(run.model, run.tape, perturbed, factor, at);
    });
  }
  /// Largest relative error of a parameter.
  static double error(const MatrixXd& a, const MatrixXd& exact) {
    return (a - exact).colwise().norm().cwiseQuotient(exact.colwise().norm()).maxCoeff();
  }
};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(SemiAnalytic, Groups);

TYPED_TEST(SemiAnalytic, IsOfFirstOrderInThePerturbation) {
  const MatrixXd exact = this->analytic();
  const double coarse = this->error(this->semi_analytic(1e-5, {}), exact),
               fine = this->error(this->semi_analytic(1e-6, {}), exact);
  EXPECT_LT(fine, 1e-2);
  EXPECT_NEAR(std::log10(coarse / fine), 1, 0.1);
}

TYPED_TEST(SemiAnalytic, SolvesWithTheFrozenFactorComeNearer) {
  const MatrixXd exact_factor = this->semi_analytic(1e-6, {});
  double before = 1e300;
  for (const int corrections : {2, 4, 8}) {
    const double error = this->error(this->semi_analytic(1e-6, {true, corrections}), exact_factor);
    EXPECT_LT(error, 0.5 * before) << corrections << " solves";
    before = error;
  }
  EXPECT_LT(before, 1e-3) << "after 8 solves a step";
}

}  // namespace
}  // namespace liesl::test::semi_analytic_test
