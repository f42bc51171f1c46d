/// @file
/// Sensitivities of motions whose joints are penalties: equations (4) to (6) of Garcia Orden,
/// Arribas, Dopico and Gabaldon 2024 in the discrete motion.

#include "mbs/sensitivity/machine.hpp"

namespace liesl::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

template <class G>
class PenaltySensitivity : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(PenaltySensitivity, Groups);

Mechanism machine(ConstraintForm form) {
  Mechanism m = sensitive_machine();
  m.penalty = {form, 1e8, 1e6, 0, 4e-4};
  return m;
}

/// Position of a node in the rod, and all multipliers.
template <class G>
VectorXd outputs(const Model<G>& model, const State<G>& s) {
  VectorXd y(G::space_dim + model.constraints());
  y << s.H[std::size_t(model.first_node(1) + 1)].x, s.lambda;
  return y;
}

template <class G>
MatrixXd derivatives(const Model<G>& model, const State<G>& s, const StateSensitivity& ds) {
  const int node = model.first_node(1) + 1;
  MatrixXd dy(G::space_dim + model.constraints(), ds.eta.cols());
  dy << s.H[std::size_t(node)].R * ds.eta.middleRows(G::dim * node, G::space_dim), ds.lambda;
  return dy;
}

/// At the end of a motion: direct against adjoint, and against differences of simulations.
template <class G>
void expect_gradients(ConstraintForm form, const std::vector<Quantity>& all) {
  const Mechanism m = machine(form);
  const auto o = tight(0.02, 4e-4);
  const Taped<G> run(m, o);
  const auto parameters = run.parameters(all);
  const int n = G::space_dim + run.model.constraints();
  MatrixXd direct;
  auto end = direct_sensitivity<G>(
      run.model, run.tape, parameters,
      [&](long, const State<G>& s, const auto& ds) { direct = derivatives(run.model, s, ds); });
  ASSERT_TRUE(end.complete()) << end.reason;
  MatrixXd gradient;
  end = adjoint_sensitivity<G>(
      run.model, run.tape, parameters, n,
      [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd&) {
        if (step != run.tape.steps()) return;
        const int node = run.model.first_node(1) + 1;
        for (int i = 0; i < n; ++i)
          if (i < G::space_dim)
            bars.eta.col(i).segment(G::dim * node, G::space_dim) =
                s.H[std::size_t(node)].R.row(i).transpose();
          else
            bars.lambda(i - G::space_dim, i) = 1;
      },
      gradient);
  ASSERT_TRUE(end.complete()) << end.reason;
  for (Eigen::Index p = 0; p < direct.cols(); ++p)
    EXPECT_LT((direct.col(p) - gradient.row(p).transpose()).norm(), 1e-9 * direct.col(p).norm())
        << all[std::size_t(p)].parameter.name;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const VectorXd exact = all[p].nominal * direct.col(Eigen::Index(p));
    const Differences found(
        [&](double change) -> MatrixXd {
          Mechanism changed = m;
          all[p].set(changed, all[p].nominal * (1 + change));
          const Taped<G> at(changed, o);
          State<G> s = at.model.initial_state();
          at.run.trajectory.read(at.run.trajectory.size() - 1, s);
          return outputs(at.model, s);
        },
        0.04, 4);
    const auto error = [&](const MatrixXd& y, int first, int count) {
      return (y.col(0) - exact).segment(first, count).norm() / exact.segment(first, count).norm();
    };
    for (const auto& [first, count] :
         {std::pair{0, int(G::space_dim)}, std::pair{int(G::space_dim), n - G::space_dim}}) {
      double best = 1;
      for (const auto& y : found.extrapolated) best = std::min(best, error(y, first, count));
      EXPECT_LT(best, 1e-7) << all[p].parameter.name << ", " << first;
      const double coarse = error(found.central[0], first, count),
                   fine = error(found.central[1], first, count);
      if (fine > 1e-6) {
        EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << all[p].parameter.name << ", " << first;
      }
    }
  }
}

TYPED_TEST(PenaltySensitivity, EqualsDifferencesOfSimulations) {
  const auto all = quantities(sensitive_machine());
  expect_gradients<TypeParam>(ConstraintForm::Penalty, {all[0], all[2], all[3], all[13]});
}

TYPED_TEST(PenaltySensitivity, OfAugmentedOnesAreThoseOfMultipliers) {
  const auto all = quantities(sensitive_machine());
  expect_gradients<TypeParam>(ConstraintForm::Augmented, {all[0], all[3]});
}

/// Named, not computed wrongly.
TEST(PenaltySensitivities, WithDampingOrSharedRowsAreRefused) {
  Mechanism damped = machine(ConstraintForm::Penalty);
  damped.penalty.damping = 1e-4;
  EXPECT_THROW(StepSensitivity<SE2>(Model<SE2>::build(damped, space_of<SE2>(damped)), 0.8),
               std::invalid_argument);
  Mechanism shared = four_bar(2);
  shared.formalism = Formalism::Rigid;
  shared.penalty.form = ConstraintForm::Penalty;
  EXPECT_THROW(StepSensitivity<SE3>(Model<SE3>::build(shared, {}), 0.8), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test
