/// @file
/// Sensitivities of motions whose joints are penalties: equations (4) to (6) of Garcia Orden,
/// Arribas, Dopico and Gabaldon 2024 in the discrete motion.

#include "mbs/sensitivity/forms.hpp"

namespace liesl::test::penalty_sensitivity_test {
namespace {

template <class G>
class PenaltySensitivity : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(PenaltySensitivity, Groups);

Mechanism machine(ConstraintForm form, double E = 7e9) {
  Mechanism m = sensitive_machine(E);
  m.penalty = {form, 1e8, 1e6, 0, 4e-4};
  return m;
}

/// Position of a node of the second body, and all multipliers.
template <class G>
VectorXd outputs(const Model<G>& model, int node, const State<G>& s) {
  VectorXd y(G::space_dim + model.constraints());
  y << s.H[std::size_t(model.first_node(1) + node)].x, s.lambda;
  return y;
}

template <class G>
MatrixXd derivatives(const Model<G>& model, int of, const State<G>& s, const StateSensitivity& ds) {
  const int node = model.first_node(1) + of;
  MatrixXd dy(G::space_dim + model.constraints(), ds.eta.cols());
  dy << s.H[std::size_t(node)].R * ds.eta.middleRows(G::dim * node, G::space_dim), ds.lambda;
  return dy;
}

/// At the end of a motion: direct against adjoint, and against differences of simulations.
template <class G>
void expect_gradients(const Mechanism& m, const std::vector<Quantity>& all, int node = 1,
                      double allowed = 1e-7, double largest = 0.04) {
  const auto o = tight(0.02, 4e-4);
  const Taped<G> run(m, o);
  const auto parameters = run.parameters(all);
  const int n = G::space_dim + run.model.constraints();
  MatrixXd direct;
  auto end = direct_sensitivity<G>(run.model, run.tape, parameters,
                                   [&](long, const State<G>& s, const auto& ds) {
                                     direct = derivatives(run.model, node, s, ds);
                                   });
  ASSERT_TRUE(end.complete()) << end.reason;
  MatrixXd gradient;
  end = adjoint_sensitivity<G>(
      run.model, run.tape, parameters, n,
      [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd&) {
        if (step != run.tape.steps()) return;
        const int at = run.model.first_node(1) + node;
        for (int i = 0; i < n; ++i)
          if (i < G::space_dim)
            bars.eta.col(i).segment(G::dim * at, G::space_dim) =
                s.H[std::size_t(at)].R.row(i).transpose();
          else
            bars.lambda(i - G::space_dim, i) = 1;
      },
      gradient);
  ASSERT_TRUE(end.complete()) << end.reason;
  for (Eigen::Index p = 0; p < direct.cols(); ++p)
    EXPECT_LT((direct.col(p) - gradient.row(p).transpose()).norm(), 1e-10 * direct.col(p).norm())
        << all[std::size_t(p)].parameter.name;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const VectorXd exact = all[p].nominal * direct.col(Eigen::Index(p));
    const Differences found(
        [&](double change) -> MatrixXd {
          Mechanism changed = m;
          all[p].set(changed, all[p].nominal * (1 + change));
          const Taped<G> at(changed, o);
          EXPECT_EQ(at.run.report.rejected_steps, 0);
          State<G> s = at.model.initial_state();
          at.run.trajectory.read(at.run.trajectory.size() - 1, s);
          return outputs(at.model, node, s);
        },
        largest, 4);
    const auto error = [&](const MatrixXd& y, int first, int count) {
      return (y.col(0) - exact).segment(first, count).norm() / exact.segment(first, count).norm();
    };
    for (const auto& [first, count] :
         {std::pair{0, int(G::space_dim)}, std::pair{int(G::space_dim), n - G::space_dim}}) {
      double best = 1;
      for (const auto& y : found.extrapolated) best = std::min(best, error(y, first, count));
      EXPECT_LT(best, allowed) << all[p].parameter.name << ", " << first;
      const double coarse = error(found.central[0], first, count),
                   fine = error(found.central[1], first, count);
      EXPECT_GT(coarse, 1e-7) << all[p].parameter.name << ", " << first;
      EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << all[p].parameter.name << ", " << first;
    }
  }
}

TYPED_TEST(PenaltySensitivity, DirectEqualsAdjoint) {
  Mechanism damped = machine(ConstraintForm::Penalty);
  damped.penalty.damping = 1e-4;
  for (const Mechanism& m : {machine(ConstraintForm::Penalty), damped}) {
    auto all = quantities(m);
    all.push_back({1, {}, {"weights", {PenaltyDerivative{1e8, 1e6}}}});
    for (const int steps : {10, 100, 1000}) expect_direct_equals_adjoint<TypeParam>(steps, m, all);
  }
}

TYPED_TEST(PenaltySensitivity, OfAugmentedOnesDirectEqualsAdjoint) {
  const Mechanism augmented = machine(ConstraintForm::Augmented);
  for (const int steps : {10, 100, 1000})
    expect_direct_equals_adjoint<TypeParam>(steps, augmented, quantities(augmented));
}

TYPED_TEST(PenaltySensitivity, EqualsDifferencesOfSimulations) {
  const auto all = quantities(sensitive_machine());
  expect_gradients<TypeParam>(machine(ConstraintForm::Penalty), {all[0], all[2], all[3], all[13]});
}

/// By the weights of lengths and of angles, as a check of both: what joints leave open falls with
/// them. Soft joints, of which there is something to see.
TYPED_TEST(PenaltySensitivity, ByTheWeightsEqualsDifferencesOfSimulations) {
  Mechanism soft = machine(ConstraintForm::Penalty);
  soft.penalty.displacement = 1e7;
  soft.penalty.rotation = 1e5;
  const Quantity lengths{1e7,
                         [](Mechanism&c, double p) { c.penalty.displacement = p; },
                         {"weight of lengths", {PenaltyDerivative{1, 0}}}},
      angles{1e5,
             [](Mechanism&c, double p) { c.penalty.rotation = p; },
             {"weight of angles", {PenaltyDerivative{0, 1}}}};
  expect_gradients<TypeParam>(soft, {lengths, angles});
}

TYPED_TEST(PenaltySensitivity, OfAugmentedOnesAreThoseOfMultipliers) {
  const auto all = quantities(sensitive_machine());
  expect_gradients<TypeParam>(machine(ConstraintForm::Augmented), {all[0], all[3]});
}

/// The drive among them, whose rate is in the damping.
TYPED_TEST(PenaltySensitivity, WithDampingEqualsDifferencesOfSimulations) {
  const auto all = quantities(sensitive_machine());
  Mechanism damped = machine(ConstraintForm::Penalty);
  damped.penalty.damping = 1e-4;
  expect_gradients<TypeParam>(damped, {all[0], all[3], all[8], all[13]});
}

/// By a length the rows that are damped change, too. With ten times the E round-off leaves 3e-7 of
/// the differences.
TYPED_TEST(PenaltySensitivity, WithDampingByALengthEqualsDifferencesOfSimulations) {
  Mechanism damped = machine(ConstraintForm::Penalty, 7e8);
  damped.penalty.damping = 1e-4;
  const auto length = by_nearby("length of the rod", damped, 0.3, [](Mechanism& c, double p) {
    std::get<BeamSpec>(c.bodies[1].kind).nodes = straight({0.15, 0, 0}, {0.15 + p, 0, 0}, 3);
    std::get<RigidSpec>(c.bodies[2].kind).frame.x = {0.15 + p, 0, 0};
  });
  expect_gradients<TypeParam>(damped, {length}, 3);
}

/// A four-bar in space, of rigid links under their weight: three rows repeat others.
Mechanism shared_machine() {
  Mechanism m = four_bar(2);
  m.formalism = Formalism::Rigid;
  m.penalty = {ConstraintForm::Penalty, 1e6, 1e4, 0, 4e-4};
  return m;
}

std::vector<Quantity> quantities_of_links(const Mechanism& m) {
  return {{steel().rho,
           [](Mechanism& c, double p) { std::get<BeamSpec>(c.bodies[1].kind).material.rho = p; },
           {"rho", {by_density(m, 1)}}},
          {20,
           [](Mechanism& c, double p) { c.drives[0].motion = TimeFunction::rate(p, 0.05); },
           {"drive", {DriveDerivative{0, 1. / 20}}}}};
}

/// The links vibrate on their penalties, through many periods: by rho small steps of differences.
TEST(PenaltySensitivities, OfRowsThatShareForcesEqualDifferences) {
  Mechanism m = shared_machine();
  ASSERT_FALSE(Model<SE3>::build(m, {}).redundant.empty());
  for (const double damping : {0., 1e-4}) {
    m.penalty.damping = damping;
    const auto all = quantities_of_links(m);
    expect_gradients<SE3>(m, {all[0]}, 0, 1e-7, 4e-3);
    expect_gradients<SE3>(m, {all[1]}, 0);
  }
}

/// At the start forces are shared so that they are least: the refinement of the accelerations ends
/// at 1e-12, and what rows share is known to 1e-6 of it.
TEST(PenaltySensitivities, OfRowsThatShareForcesAtTheStart) {
  const Mechanism m = shared_machine();
  const auto rho = quantities_of_links(m)[0];
  const auto o = tight(4e-4, 4e-4);
  const Taped<SE3> run(m, o);
  VectorXd exact;
  direct_sensitivity<SE3>(run.model, run.tape, run.parameters({rho}),
                          [&](long step, const State<SE3>&, const auto& ds) {
                            if (step == 0) exact = rho.nominal * ds.lambda.col(0);
                          });
  const auto at = [&](double change) {
    Mechanism changed = m;
    rho.set(changed, rho.nominal * (1 + change));
    const Taped<SE3> of(changed, o);
    State<SE3> s = of.model.initial_state();
    of.run.trajectory.read(0, s);
    return VectorXd(s.lambda);
  };
  const VectorXd difference = (at(0.05) - at(-0.05)) / 0.1;
  EXPECT_GT(exact.norm(), 0.1);
  EXPECT_LT((difference - exact).norm(), 1e-5 * exact.norm());
}

/// Named, not computed wrongly.
TEST(PenaltySensitivities, AugmentedWithSharedRowsAreRefused) {
  const auto refusal = [](const Mechanism& m) -> std::string {
    try {
      StepSensitivity<SE3>(Model<SE3>::build(m, {}), 0.8);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  Mechanism shared = shared_machine();
  shared.penalty.form = ConstraintForm::Augmented;
  EXPECT_NE(refusal(shared).find("augmented penalties share"), std::string::npos);
  shared.penalty.form = ConstraintForm::Penalty;
  EXPECT_EQ(refusal(shared), "");
}

}  // namespace
}  // namespace liesl::test::penalty_sensitivity_test
