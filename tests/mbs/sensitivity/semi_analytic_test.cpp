/// @file
/// The semi-analytic form against the analytic one: first order in its perturbation, and solves
/// with the frozen factor that come nearer one by one; of chains of segments against differences,
/// too.

#include "mbs/sensitivity/semi_analytic.hpp"

#include <memory>

#include "mbs/sensitivity/inertial_axes.hpp"
#include "mbs/sensitivity/machine.hpp"

namespace liesl::test::semi_analytic_test {
namespace {

using Eigen::MatrixXd;
using test::Taped;

template <class G>
class SemiAnalytic : public ::testing::Test {
 protected:
  const Mechanism machine;
  const std::vector<test::Quantity> all;
  const SimulationOptions options;
  const Taped<G> run{machine, options};

  SemiAnalytic()
      : SemiAnalytic(test::sensitive_machine(), test::quantities(test::sensitive_machine()),
                     test::tight(0.0025, 5e-5)) {}
  SemiAnalytic(const Mechanism& m, const std::vector<test::Quantity>& by,
               const SimulationOptions& o)
      : machine(m), all(by), options(o) {}

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

/// A drive that begins with an acceleration, a share of the parameter: at the start, too.
TEST(SemiAnalyticStart, HasTheAccelerationsOfDrives) {
  const auto driven = [](double p) {
    Mechanism m = test::sensitive_machine();
    m.drives[0].motion = TimeFunction::expression(std::to_string(p) + "*t^2");
    return m;
  };
  const Mechanism m = driven(1000);
  const Taped<SE2> run(m, test::tight(4e-4, 4e-4));
  const auto starts = [](const auto& form) {
    MatrixXd at_start;
    const SensitivityEnd end = form([&](long step, const auto&, const StateSensitivity& ds) {
      if (step == 0) at_start = ds.w;
    });
    EXPECT_TRUE(end.complete()) << end.reason;
    return at_start;
  };
  const auto parameters = run.parameters({{1000, {}, {"drive", {DriveDerivative{0, 1e-3}}}}});
  const MatrixXd exact = starts([&](const SensitivityAt<SE2>& at) {
    return direct_sensitivity<SE2>(run.model, run.tape, parameters, at);
  });
  const Mechanism changed = driven(1001);
  const auto model = Model<SE2>::build(changed, test::space_of<SE2>(changed));
  const MatrixXd found = starts([&](const SensitivityAt<SE2>& at) {
    return semi_analytic_sensitivity<SE2>(run.model, run.tape, {{&model, 1.}}, {}, at);
  });
  EXPECT_GT(exact.norm(), 1);
  EXPECT_LT((found - exact).norm(), 1e-6 * exact.norm());
}

/// Of parameters that change by 1e-4, whose differences have no more round-off than 1e-10.
TYPED_TEST(SemiAnalytic, SolvesWithTheFrozenFactorComeNearer) {
  const MatrixXd exact_factor = this->semi_analytic(1e-4, {});
  double before = 1e300;
  for (const int corrections : {2, 4, 8}) {
    const double error = this->error(this->semi_analytic(1e-4, {true, corrections}), exact_factor);
    EXPECT_LT(error, 0.5 * before) << corrections << " solves";
    before = error;
  }
  EXPECT_LT(before, 1e-3) << "after 8 solves a step";
}

/// The machine without the disc, which is bolted to an inner node, its beams chains of segments.
class SegmentsSemiAnalytic : public SemiAnalytic<SE2> {
 protected:
  explicit SegmentsSemiAnalytic(const SimulationOptions& o = test::tight(0.02, 4e-4))
      : SemiAnalytic(segmented(), some(), o) {}
  static Mechanism segmented() {
    Mechanism m = test::sensitive_machine();
    m.formalism = Formalism::Segments;
    m.bodies.pop_back();
    m.joints.pop_back();
    return m;
  }
  static std::vector<test::Quantity> some() {
    const auto every = test::quantities(test::sensitive_machine());
    return {every[0], every[1], every[2], every[3], every[10], every[13]};
  }
  /// v at the end with a quantity changed, positions in inertial axes; the rates of these, which
  /// are no unknowns, left out.
  Eigen::VectorXd changed(const test::Quantity& q, double change) const {
    Mechanism m = machine;
    q.set(m, q.nominal * (1 + change));
    const Taped<SE2> at(m, options);
    State<SE2> s = at.model.initial_state();
    at.run.trajectory.read(at.run.trajectory.size() - 1, s);
    Eigen::VectorXd v = in_inertial_axes(at.model, s).v;
    for (const int k : at.model.positions()) v[SE2::dim * k + SE2::space_dim] = 0;
    return v;
  }
};

TEST_F(SegmentsSemiAnalytic, IsOfFirstOrderInThePerturbation) {
  const MatrixXd exact = analytic();
  const double coarse = error(semi_analytic(1e-5, {}), exact),
               fine = error(semi_analytic(1e-6, {}), exact);
  RecordProperty("fine", std::to_string(1e6 * fine));
  EXPECT_LT(fine, 1e-4);
  EXPECT_NEAR(std::log10(coarse / fine), 1, 0.1);
}

TEST_F(SegmentsSemiAnalytic, EqualsDifferencesOfSimulations) {
  const MatrixXd found = semi_analytic(1e-6, {});
  for (std::size_t p = 0; p < all.size(); ++p) {
    const test::Differences differences(
        [&](double change) -> MatrixXd { return changed(all[p], change); }, 0.01, 3);
    const Eigen::VectorXd off =
        differences.extrapolated.back() - found.col(static_cast<Eigen::Index>(p));
    const double share = off.norm() / found.col(static_cast<Eigen::Index>(p)).norm();
    RecordProperty("off_" + std::to_string(p), std::to_string(1e6 * share));
    EXPECT_LT(share, 1e-4) << all[p].parameter.name;
  }
}

class SegmentsFrozenFactor : public SegmentsSemiAnalytic {
 protected:
  SegmentsFrozenFactor() : SegmentsSemiAnalytic(test::tight(0.0025, 5e-5)) {}
};

/// The constant factor is that of the chain at rest, in the axes of its nodes. The perturbation is
/// large, as round-off of the forces is divided by it.
TEST_F(SegmentsFrozenFactor, SolvesWithTheFrozenFactorComeNearer) {
  constexpr double kLarge = 1e-4;
  const MatrixXd exact_factor = semi_analytic(kLarge, {});
  double before = 1e300;
  for (const int corrections : {2, 4, 8}) {
    const double off = error(semi_analytic(kLarge, {true, corrections}), exact_factor);
    RecordProperty("frozen_" + std::to_string(corrections), std::to_string(1e12 * off));
    EXPECT_LT(off, 0.5 * before) << corrections << " solves";
    if (corrections == 2) {
      EXPECT_LT(off, 1e-3) << "in inertial axes it is 4e-3";
    }
    before = off;
  }
  EXPECT_LT(before, 1e-3) << "after 8 solves a step";
}

}  // namespace
}  // namespace liesl::test::semi_analytic_test
