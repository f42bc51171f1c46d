/// @file
/// Derivatives of a motion by parameters: direct form, adjoint form and differences of simulations.

#include "mbs/sensitivity/motion_sensitivity.hpp"

#include "mbs/sensitivity/machine.hpp"

namespace liesl::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Quantity;
using test::Taped;

/// What is asked of a state: position, velocity and acceleration of a node in the rod, and all
/// multipliers; and the derivatives by the state.
template <FrameGroup G>
struct Outputs {
  static constexpr int sd = G::space_dim, dim = G::dim;
  std::size_t node;
  int at;
  std::vector<int> groups;

  explicit Outputs(const Model<G>& model)
      : node(std::size_t(model.first_node(1) + 1)),
        at(dim * int(node)),
        groups({sd, dim, dim, model.constraints()}) {}
  int size() const { return sd + 2 * dim + groups[3]; }
  VectorXd values(const State<G>& s) const {
    VectorXd y(size());
    y << s.H[node].x, s.v.segment(at, dim), s.vdot.segment(at, dim), s.lambda;
    return y;
  }
  MatrixXd derivatives(const State<G>& s, const StateSensitivity& ds) const {
    MatrixXd dy(size(), ds.v.cols());
    dy << s.H[node].R * ds.eta.middleRows(at, sd), ds.v.middleRows(at, dim),
        ds.w.middleRows(at, dim), ds.lambda;
    return dy;
  }
  /// Column `column` of the cotangents: that of output i with a weight.
  void add_cotangents(const State<G>& s, int i, double weight, int column,
                      StateSensitivity& bars) const {
    if (i < sd)
      bars.eta.col(column).segment(at, sd) += weight * s.H[node].R.row(i).transpose();
    else if (i < sd + dim)
      bars.v(at + i - sd, column) += weight;
    else if (i < sd + 2 * dim)
      bars.w(at + i - sd - dim, column) += weight;
    else
      bars.lambda(i - sd - 2 * dim, column) += weight;
  }
};

template <class G>
class MotionSensitivity : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(MotionSensitivity, Groups);

/// J_i = sum over all steps of (weight of the step) y_i, and y_i at the last step alone. An error
/// counts against the sum of |weight dy_i/dp|, and against the largest |dy_i/dp|.
template <class G>
void expect_direct_equals_adjoint(int steps, const Mechanism& machine,
                                  const std::vector<Quantity>& quantities) {
  const Taped<G> run(machine, test::tight(steps * 2e-4, 2e-4));
  const auto parameters = run.parameters(quantities);
  const Outputs<G> outputs(run.model);
  const int n = outputs.size(), n_p = int(parameters.size());
  const auto weight = [](long step) { return std::sin(0.3 + 0.1 * double(step)); };
  MatrixXd sum = MatrixXd::Zero(n, n_p), sum_size = sum, last, last_size = sum;
  auto end = direct_sensitivity<G>(run.model, run.tape, parameters,
                                   [&](long step, const State<G>& s, const auto& ds) {
                                     last = outputs.derivatives(s, ds);
                                     sum += weight(step) * last;
                                     sum_size += std::abs(weight(step)) * last.cwiseAbs();
                                     last_size = last_size.cwiseMax(last.cwiseAbs());
                                   });
  ASSERT_TRUE(end.complete()) << end.reason;
  MatrixXd gradient;
  end = adjoint_sensitivity<G>(
      run.model, run.tape, parameters, 2 * n,
      [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd&) {
        for (int i = 0; i < n; ++i) {
          outputs.add_cotangents(s, i, weight(step), i, bars);
          if (step == run.tape.steps()) outputs.add_cotangents(s, i, 1, n + i, bars);
        }
      },
      gradient);
  ASSERT_TRUE(end.complete()) << end.reason;
  double worst = 0;
  for (int p = 0; p < n_p; ++p) {
    const VectorXd size = test::sizes(sum_size.col(p), outputs.groups),
                   size_at_end = test::sizes(last_size.col(p), outputs.groups);
    for (int i = 0; i < n; ++i) {
      const double error = std::abs(sum(i, p) - gradient(p, i)) / size[i],
                   error_at_end = std::abs(last(i, p) - gradient(p, n + i)) / size_at_end[i];
      EXPECT_LT(error, 1e-10) << steps << " steps, sum of output " << i << ", parameter " << p;
      EXPECT_LT(error_at_end, 1e-10) << steps << " steps, output " << i << ", parameter " << p;
      worst = std::max({worst, error, error_at_end});
    }
  }
  ::testing::Test::RecordProperty("worst_" + std::to_string(steps), std::to_string(1e12 * worst));
}

TYPED_TEST(MotionSensitivity, DirectEqualsAdjoint) {
  const Mechanism machine = test::sensitive_machine();
  for (const int steps : {10, 100, 1000})
    expect_direct_equals_adjoint<TypeParam>(steps, machine, test::quantities(machine));
}

/// Every step stretches, and with it what the drive does in it.
TYPED_TEST(MotionSensitivity, DirectEqualsAdjointByTheDuration) {
  Mechanism machine = test::sensitive_machine();
  machine.loads.pop_back();  // follows time, not the duration
  const int steps = 100;
  const Parameter duration{"duration", {StepDerivative{1 / (steps * 2e-4)}}};
  expect_direct_equals_adjoint<TypeParam>(steps, machine, {{steps * 2e-4, {}, duration}});
}

/// At every step of the motion, relative to the largest value over it.
template <class G>
void expect_differences(const Mechanism& machine, const std::vector<Quantity>& all) {
  const auto o = test::tight(0.02, 4e-4);
  const Taped<G> run(machine, o);
  const auto parameters = run.parameters(all);
  const Outputs<G> outputs(run.model);
  const long records = run.tape.steps() + 1;
  std::vector<MatrixXd> exact(all.size(), MatrixXd(outputs.size(), records));
  const auto end = direct_sensitivity<G>(run.model, run.tape, parameters,
                                         [&](long step, const State<G>& s, const auto& ds) {
                                           const MatrixXd dy = outputs.derivatives(s, ds);
                                           for (std::size_t p = 0; p < all.size(); ++p)
                                             exact[p].col(step) = all[p].nominal * dy.col(long(p));
                                         });
  ASSERT_TRUE(end.complete()) << end.reason;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const auto motion = [&](double change) {
      Mechanism changed = machine;
      all[p].set(changed, all[p].nominal * (1 + change));
      const Taped<G> at(changed, o);
      EXPECT_EQ(at.run.report.rejected_steps, 0);
      State<G> s = at.model.initial_state();
      MatrixXd y(outputs.size(), records);
      for (int n = 0; n < int(records); ++n) {
        at.run.trajectory.read(n, s);
        y.col(n) = outputs.values(s);
      }
      return y;
    };
    const VectorXd size = test::sizes(exact[p].cwiseAbs().rowwise().maxCoeff(), outputs.groups);
    const auto error = [&](const MatrixXd& y) {
      return (y - exact[p]).cwiseAbs().rowwise().maxCoeff().cwiseQuotient(size).maxCoeff();
    };
    const test::Differences differences(motion, 0.16, 6);
    const double best = differences.least(error);
    EXPECT_LT(best, 1e-7) << all[p].parameter.name;
    ::testing::Test::RecordProperty("best_" + std::to_string(p), std::to_string(1e9 * best));
    const double coarse = error(differences.central[3]), fine = error(differences.central[4]);
    if (coarse > 1e-5) {  // else linear in p
      EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << all[p].parameter.name;
    }
  }
}

TYPED_TEST(MotionSensitivity, EqualsDifferencesOfSimulations) {
  const Mechanism machine = test::sensitive_machine();
  expect_differences<TypeParam>(machine, test::quantities(machine));
}

/// Beams of fourth order, which have no damping: the first quantities, those of sections, among
/// them.
TYPED_TEST(MotionSensitivity, OfFourthOrderEqualsDifferencesAndTheAdjointForm) {
  Mechanism machine = test::sensitive_machine();
  for (const std::size_t b : {0, 1}) {
    auto& beam = std::get<BeamSpec>(machine.bodies[b].kind);
    beam.order = 4;
    beam.damping = 0;
  }
  std::vector<Quantity> all = test::quantities(machine);
  all.resize(5);
  expect_direct_equals_adjoint<TypeParam>(100, machine, all);
  expect_differences<TypeParam>(machine, all);
}

/// From static equilibrium under its weight, its loads and its spring: every parameter moves the
/// start.
TYPED_TEST(MotionSensitivity, FromEquilibrium) {
  using G = TypeParam;
  const Mechanism machine = test::sensitive_machine();
  auto o = test::tight(0.02, 4e-4);
  o.start = StartChoice::Equilibrium;
  const auto all = test::quantities(machine);
  const Taped<G> run(machine, o);
  const auto parameters = run.parameters(all);
  const Outputs<G> outputs(run.model);
  const int n = outputs.size(), steps = int(run.tape.steps());
  std::vector<MatrixXd> exact(all.size(), MatrixXd(n, steps + 1));
  const auto end = direct_sensitivity<G>(run.model, run.tape, parameters,
                                         [&](long step, const State<G>& s, const auto& ds) {
                                           const MatrixXd dy = outputs.derivatives(s, ds);
                                           for (std::size_t p = 0; p < all.size(); ++p)
                                             exact[p].col(step) = dy.col(long(p));
                                         });
  ASSERT_TRUE(end.complete()) << end.reason;
  MatrixXd gradient;
  const auto back = adjoint_sensitivity<G>(
      run.model, run.tape, parameters, n,
      [&](long, const State<G>& s, StateSensitivity& bars, MatrixXd&) {
        for (int i = 0; i < n; ++i) outputs.add_cotangents(s, i, 1, i, bars);
      },
      gradient);
  ASSERT_TRUE(back.complete()) << back.reason;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const VectorXd sum_size = test::sizes(exact[p].cwiseAbs().rowwise().sum(), outputs.groups),
                   size = test::sizes(exact[p].cwiseAbs().rowwise().maxCoeff(), outputs.groups);
    const VectorXd gap = exact[p].rowwise().sum() - gradient.row(long(p)).transpose();
    EXPECT_LT(gap.cwiseAbs().cwiseQuotient(sum_size).maxCoeff(), 1e-10) << all[p].parameter.name;
    const auto motion = [&](double change) {
      Mechanism changed = machine;
      all[p].set(changed, all[p].nominal * (1 + change));
      const Taped<G> at(changed, o);
      EXPECT_EQ(at.run.report.rejected_steps, 0);
      State<G> s = at.model.initial_state();
      MatrixXd y(n, steps + 1);
      for (int i = 0; i <= steps; ++i) {
        at.run.trajectory.read(i, s);
        y.col(i) = outputs.values(s);
      }
      return y;
    };
    const test::Differences differences(motion, 0.16, 6);
    // Accelerations and multipliers: the round-off of the equilibrium, divided by the square of
    // the step, ends the fall of the error of differences below 1e-6.
    const int smooth = Outputs<G>::sd + Outputs<G>::dim;
    const auto least = [&](int first, int count) {
      return differences.least([&](const MatrixXd& y) {
        const MatrixXd error = (y / all[p].nominal - exact[p]).cwiseAbs();
        const VectorXd worst = error.rowwise().maxCoeff().cwiseQuotient(size);
        return worst.segment(first, count).maxCoeff();
      });
    };
    const double best = least(0, smooth);
    EXPECT_LT(best, 1e-7) << all[p].parameter.name;
    EXPECT_LT(least(smooth, n - smooth), 2e-6) << all[p].parameter.name;
    ::testing::Test::RecordProperty("best_" + std::to_string(p), std::to_string(1e9 * best));
  }
}

TYPED_TEST(MotionSensitivity, RefusesAStartThatDependsOnParameters) {
  using G = TypeParam;
  const auto direct = [&](const Mechanism& m) {
    const Taped<G> run(m, test::options(1e-3, 1e-4));
    direct_sensitivity<G>(run.model, run.tape, run.parameters(test::quantities(m)),
                          [](long, const State<G>&, const StateSensitivity&) {});
  };
  Mechanism jerked = test::sensitive_machine();
  jerked.drives = {{0, 0, TimeFunction::rate(150, 0)}};
  EXPECT_THROW(direct(jerked), std::invalid_argument);
  jerked.bodies[0].angular_velocity = {0, 0, 150};
  jerked.bodies[1].velocity = {0, 0.15 * 150, 0};
  jerked.bodies[1].angular_velocity = {0, 0, -75};
  try {
    direct(jerked);
    ADD_FAILURE() << "the velocities at the start depend on the drive";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("a drive with a factor"), std::string::npos) << e.what();
  }
  Mechanism classical = test::sensitive_machine();
  classical.formalism = Formalism::Classical;
  EXPECT_THROW(direct(classical), std::invalid_argument);
  EXPECT_NO_THROW(direct(test::sensitive_machine()));
}

}  // namespace
}  // namespace liesl::test
