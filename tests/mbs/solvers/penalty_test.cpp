/// @file
/// Constraints by penalties and by augmented Lagrangians, against those by multipliers.

#include "mbs/system/penalty.hpp"

#include "mbs/every_joint.hpp"
#include "mbs/run.hpp"
#include "mbs/step_tangent.hpp"
#include "mbs/system/response_value.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::penalty_test {
namespace {

Mechanism penalised(Mechanism m, ConstraintForm form, double weight = 0, double damping = 0) {
  m.penalty = {form, weight, 0.01 * weight, damping, 2e-4};
  return m;
}

/// Of plastic, so that the round-off of EA/L is small.
Mechanism crank() {
  Mechanism m = slider_crank({.elements = 3, .crank = 0.02, .rod = 0.016, .ramp = 0.02});
  for (std::size_t b : {0, 1})
    std::get<BeamSpec>(m.bodies[b].kind).material = {"plastic", 7e9, 0.3, 1200};
  m.gravity = {0, -9.81, 0};
  return m;
}

/// Largest difference of the positions of all records, m.
template <class G>
double distance(const Run<G>& a, const Run<G>& b) {
  double largest = 0;
  for (int i = 0; i < a.trajectory().size(); ++i)
    for (int k = 0; k < a.model->nodes(); ++k)
      largest =
          std::max(largest, (a.trajectory().frames(i)[k].x - b.trajectory().frames(i)[k].x).norm());
  return largest;
}

template <class G>
class PenaltyIn : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(PenaltyIn, Groups);

/// Positions and joint forces come near those of multipliers with 1/weight.
TYPED_TEST(PenaltyIn, ConvergesToMultipliersWithOrderOne) {
  using G = TypeParam;
  const Mechanism m = crank();
  const auto space = space_of<G>(m);
  const auto o = options(0.02, 2e-4, 0.8, 1e-9);
  const auto exact = run<G>(m, space, o);
  double before = 0, force_before = 0;
  for (const double weight : {1e8, 1e9, 1e10}) {
    const auto soft = run<G>(penalised(m, ConstraintForm::Penalty, weight), space, o);
    ASSERT_EQ(soft.report().status, SolveStatus::Converged) << soft.report().reason;
    const double error = distance(soft, exact);
    const Eigen::VectorXd force = exact.trajectory().lambda(exact.last());
    const double force_error =
        (soft.trajectory().lambda(soft.last()) - force).norm() / force.norm();
    if (before > 0) {
      EXPECT_NEAR(std::log10(before / error), 1, 0.05) << weight;
      EXPECT_NEAR(std::log10(force_before / force_error), 1, 0.1) << weight;
    }
    before = error;
    force_before = force_error;
  }
  EXPECT_LT(force_before, 1e-3);
}

/// Formalisms, and weights chosen from the stiffness: the joints stay closed beside the
/// deformation.
TYPED_TEST(PenaltyIn, ChosenWeightsLeaveNextToNothingOpenInEveryFormalism) {
  using G = TypeParam;
  for (const auto formalism : {Formalism::SE3, Formalism::R3SO3, Formalism::Classical,
                               Formalism::Floating, Formalism::Rigid}) {
    SCOPED_TRACE(to_string(formalism));
    Mechanism m = crank();
    m.formalism = formalism;
    const auto space = space_of<G>(m);
    const auto o = options(0.02, 2e-4);
    const auto exact = run<G>(m, space, o);
    const auto soft = run<G>(penalised(m, ConstraintForm::Penalty), space, o);
    ASSERT_EQ(soft.report().status, SolveStatus::Converged) << soft.report().reason;
    const PenaltyReport& p = soft.report().penalty;
    EXPECT_TRUE(p.used);
    EXPECT_EQ(p.rigid, formalism == Formalism::Rigid);
    EXPECT_GT(p.opening, 0);
    EXPECT_LT(p.share, p.rigid ? 1e-5 : 1e-3);
    EXPECT_NEAR(std::log10(p.displacement), std::round(std::log10(p.displacement)), 1e-9);
    EXPECT_LT(distance(soft, exact), p.rigid ? 1e-6 : 0.01 * p.deformation);
  }
}

/// At most three augmentations a step close every joint to 1e-9 m; the motion is that of
/// multipliers.
TYPED_TEST(PenaltyIn, AugmentedIsTheMotionOfMultipliers) {
  using G = TypeParam;
  const Mechanism m = crank();
  const auto space = space_of<G>(m);
  const auto o = options(0.02, 2e-4, 0.8, 1e-8);
  const auto exact = run<G>(m, space, o);
  const auto closed = run<G>(penalised(m, ConstraintForm::Augmented), space, o);
  ASSERT_EQ(closed.report().status, SolveStatus::Converged) << closed.report().reason;
  EXPECT_LE(closed.report().max_constraint_residual, 1e-9);
  EXPECT_LE(closed.report().penalty.most_augmentations, 3);
  EXPECT_GT(closed.report().penalty.augmentations, 0);
  EXPECT_LT(distance(closed, exact), 1e-8);
  EXPECT_EQ(closed.report().rejected_steps, 0);
}

/// What is too soft is told, and is not called converged where it is off by a tenth.
TYPED_TEST(PenaltyIn, SoftJointsAreTold) {
  using G = TypeParam;
  const Mechanism m = crank();
  const auto r =
      run<G>(penalised(m, ConstraintForm::Penalty, 1e5), space_of<G>(m), options(0.02, 2e-4));
  EXPECT_EQ(r.report().status, SolveStatus::Inaccurate);
  EXPECT_NE(r.report().reason.find("joints open by up to"), std::string::npos) << r.report().reason;
  EXPECT_GT(r.report().penalty.share, 0.1);
}

/// Joints are judged by the bodies of their loop: another that bends far, on the ground or on the
/// slider, hides nothing.
TYPED_TEST(PenaltyIn, AFloppyBodyBesideHidesNothing) {
  using G = TypeParam;
  const Mechanism m = crank();
  const auto penalty = [](const Mechanism& of) {
    const auto r =
        run<G>(penalised(of, ConstraintForm::Penalty, 1e7), space_of<G>(of), options(0.02, 2e-4));
    return r.report().penalty;
  };
  const auto with_wire = [&m](double from, double to, JointType type, const Port& on) {
    Mechanism beside = m;
    beside.bodies.push_back(
        {"wire", straight_beam({from, 0, 0}, {to, 0, 0}, 4, round_section(0.004, 0.9),
                               {"foam", 5e5, 0.3, 10})});
    beside.joints.push_back({"hang", type, on, {3, 0}});
    return beside;
  };
  const auto alone = penalty(m), beside = penalty(with_wire(0.05, 0.4, JointType::Revolute, {})),
             on_it = penalty(with_wire(0.45, 0.1, JointType::Fixed, {2, 0}));
  EXPECT_GT(alone.share, 1e-3);
  EXPECT_EQ(beside.joint, alone.joint);
  EXPECT_NEAR(beside.share, alone.share, 1e-3 * alone.share);
  EXPECT_EQ(on_it.joint, alone.joint);
  EXPECT_NEAR(on_it.share, alone.share, 0.1 * alone.share);
}

/// An open chain has no loop: its hinge on the ground is judged by the arm next to it, not by a
/// tool that bends far.
TYPED_TEST(PenaltyIn, AFloppyToolHidesNothingOfAChain) {
  using G = TypeParam;
  const auto penalty = [](const Material& of_the_tool) {
    Mechanism m;
    const Material steel{"steel", 210e9, 0.3, 7850};
    for (int i = 0; i < 3; ++i) {
      const Vec3 from(0.3 * i, 0, 0);
      m.bodies.push_back({"arm" + std::to_string(i),
                          straight_beam(from, from + Vec3(0.3, 0, 0), 4, round_section(0.01, 0.9),
                                        i < 2 ? steel : of_the_tool)});
      const Port on = i == 0 ? Port{} : Port{i - 1, 4};
      m.joints.push_back({"hinge" + std::to_string(i), JointType::Revolute, on, {i, 0}});
    }
    m.gravity = {0, -9.81, 0};
    const auto r =
        run<G>(penalised(m, ConstraintForm::Penalty, 1e5), space_of<G>(m), options(0.1, 1e-3));
    return r.report().penalty;
  };
  const auto stiff = penalty({"light", 210e9, 0.3, 1000}),
             soft = penalty({"rubber", 5e6, 0.3, 1000});
  EXPECT_GT(stiff.share, 0.01);
  EXPECT_EQ(soft.joint, stiff.joint);
  EXPECT_NEAR(soft.share, stiff.share, 0.1 * stiff.share);
}

/// Kinetic, elastic and potential energy and that of the penalties change by what dampers of the
/// penalties take and drives give, to second order in the step.
TYPED_TEST(PenaltyIn, EnergyIsBalanced) {
  using G = TypeParam;
  Mechanism m = crank();
  const auto unbalanced = [&](double damping, double step) {
    const auto r = run<G>(penalised(m, ConstraintForm::Penalty, 2e5, damping), space_of<G>(m),
                          options(0.01, step, 1, 1e-10));
    EXPECT_EQ(r.report().status, SolveStatus::Inaccurate) << "joints this soft are told";
    Equations<G> equations(*r.model);
    return largest_energy_imbalance(r, step,
                                    [&](State<G>& s) { return power(*r.model, equations, s); });
  };
  for (const double damping : {0., 2e-4}) {
    const double coarse = unbalanced(damping, 2e-5), fine = unbalanced(damping, 1e-5);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05) << damping << ": " << coarse << ", " << fine;
  }
}

/// Rows as stiff as by default, whose rates are errors of the velocities: no energy is made of
/// their squares.
TYPED_TEST(PenaltyIn, EnergyIsBalancedWhereDampedRowsAreStiff) {
  using G = TypeParam;
  const Mechanism m = crank();
  const auto share = [&](double damping) {
    const auto r = run<G>(penalised(m, ConstraintForm::Penalty, 0, damping), space_of<G>(m),
                          options(0.02, 1e-4));
    EXPECT_EQ(r.report().status, SolveStatus::Converged);
    Equations<G> equations(*r.model);
    double turned_over = 0;
    for (int i = 0; i < r.trajectory().size(); ++i)
      turned_over = std::max(turned_over, std::abs(total_energy(r, i) - total_energy(r, 0)));
    return largest_energy_imbalance(r, 1e-4,
                                    [&](State<G>& s) { return power(*r.model, equations, s); }) /
           turned_over;
  };
  const double undamped = share(0);
  for (const double damping : {1e-5, 1e-3}) EXPECT_LT(share(damping), 2 * undamped + 1e-4);
}

/// Augmented joints are closed: there is no rate that damping could act on.
TYPED_TEST(PenaltyIn, DampingHasNoEffectOnAugmentedJoints) {
  using G = TypeParam;
  const Mechanism m = crank();
  const auto end = [&](double damping) {
    const auto r = run<G>(penalised(m, ConstraintForm::Augmented, 0, damping), space_of<G>(m),
                          options(0.02, 2e-4));
    EXPECT_EQ(r.report().rejected_steps, 0);
    State<G> s = r.model->initial_state();
    r.trajectory().read(r.trajectory().size() - 1, s);
    return Eigen::VectorXd(s.v);
  };
  EXPECT_EQ(end(1e-3), end(0));
}

/// Of a step, with and without damping; and statics.
TYPED_TEST(PenaltyIn, TangentIsExact) {
  using G = TypeParam;
  for (const double damping : {0., 1e-4}) {
    const Mechanism m = penalised(crank(), ConstraintForm::Penalty, 1e6, damping);
    const auto model = Model<G>::build(m, space_of<G>(m));
    StepTangent<G> tangent(model, options(0.02, 2e-4, 0.8, 1e-9), 30, damping);
    tangent.expect_exact("damping " + std::to_string(damping), 60);
    tangent.expect_transposed("damping " + std::to_string(damping));
  }
  const Mechanism m = penalised(crank(), ConstraintForm::Penalty, 1e6);
  const auto model = Model<G>::build(m, space_of<G>(m));
  State<G> s = model.initial_state();
  Random random(3);
  model.retract(s, 1e-3 * random.vector(model.size()));
  s.lambda = 100 * random.vector(model.constraints());
  expect_exact_statics(model, s, {0, 1}, "penalty", 60);
}

/// Three rows too many are shared: the motion is that of the plane, and no force is left out.
TEST(Penalty, SharesRedundantRows) {
  const Mechanism m = four_bar(3);
  const auto o = options(0.1, 1e-3);
  const auto plane = run_planar(m, o);
  Mechanism rigid = m;
  rigid.formalism = Formalism::Rigid;
  for (const auto form : {ConstraintForm::Penalty, ConstraintForm::Augmented}) {
    const auto exact = run_spatial(rigid, o), shared = run_spatial(penalised(rigid, form), o);
    ASSERT_EQ(exact.report().status, SolveStatus::Converged) << exact.report().reason;
    ASSERT_EQ(shared.report().status, SolveStatus::Converged) << shared.report().reason;
    EXPECT_LT(distance(shared, exact), 1e-6) << to_string(form);
    EXPECT_GT(shared.model->constraints(), exact.model->constraints());
    bool told = false;
    for (const auto& w : shared.report().warnings)
      told = told || w.find("shared by their penalties") != std::string::npos;
    EXPECT_TRUE(told) << to_string(form);
  }
}

/// A machine with a joint of the kind moves as with multipliers, off by the compliance 1/weight of
/// its joints: by less than twice |lambda|/weight, and with order one, the joint forces, too.
template <FrameGroup G>
void expect_order_one(const JointKind& kind, const Vec3& axis, const Vec3& axis2,
                      double& most_openings) {
  SCOPED_TRACE(kind.name);
  const Mechanism m = jointed(kind, axis, axis2);
  auto o = options(0.3, 5e-3, 0.5, 1e-11);  // at the end no force of the start is left
  o.max_iterations = 40;
  o.tangent = TangentStrategy::Exact;
  const auto exact = run<G>(m, Space<G>(), o);
  ASSERT_EQ(exact.report().status, SolveStatus::Converged) << exact.report().reason;
  double largest = 0;
  for (int i = 0; i <= exact.last(); ++i)
    largest = std::max(largest, exact.trajectory().lambda(i).cwiseAbs().maxCoeff());
  double before = 0, force_before = 0;
  for (const double weight : {1e6, 1e7, 1e8}) {
    Mechanism held = m;
    held.penalty = {ConstraintForm::Penalty, weight, weight, 0, o.step};
    const auto soft = run<G>(held, Space<G>(), o);
    ASSERT_EQ(soft.report().status, SolveStatus::Converged) << soft.report().reason;
    ASSERT_EQ(soft.trajectory().size(), exact.trajectory().size());
    const double error = distance(soft, exact);
    const Eigen::VectorXd force = exact.trajectory().lambda(exact.last());
    const double force_error = (soft.trajectory().lambda(soft.last()) - force).norm();
    most_openings = std::max(most_openings, error * weight / largest);
    if (before > 0) {
      EXPECT_NEAR(std::log10(before / error), 1, 0.02) << weight;
      EXPECT_NEAR(std::log10(force_before / force_error), 1, 0.05) << weight;
    }
    before = error;
    force_before = force_error;
  }
}

TEST(EveryJointByPenalty, MovesAsByMultipliersInSpace) {
  double most_openings = 0;
  for (const JointKind& kind : joint_kinds())
    expect_order_one<SE3>(kind, Vec3(1, 2, 2) / 3, Vec3(2, 1, -2) / 3, most_openings);
  RecordProperty("most_openings", std::to_string(most_openings));
  EXPECT_LT(most_openings, 2);
}

/// The axis normal to the plane, and in it; a screw leaves the plane.
TEST(EveryJointByPenalty, MovesAsByMultipliersInThePlane) {
  double most_openings = 0;
  for (const JointKind& kind : joint_kinds()) {
    if (kind.pitch) continue;
    expect_order_one<SE2>(kind, Vec3::UnitZ(), Vec3(0.6, 0.8, 0), most_openings);
    expect_order_one<SE2>(kind, Vec3(0.6, 0.8, 0), Vec3::UnitZ(), most_openings);
  }
  RecordProperty("most_openings", std::to_string(most_openings));
  EXPECT_LT(most_openings, 2);
}

/// A slider-crank whose rod is a mesh of plastic under its weight, reduced or all of its nodes
/// moving.
template <FrameGroup G>
Mechanism meshed_crank(SolidMotion as) {
  SolidSpec rod = meshed_rod({0.15, 0, 0}, 12, 2, 4, G::space_dim == 3 ? 1 : 0);
  rod.model = of_material(*rod.model, {"plastic", 7e9, 0.3, 1200});
  rod.as = as;
  Mechanism m = slider_crank_with(rod, 1);
  m.drives[0].motion = TimeFunction::rate(150, 0.02);
  m.gravity = {0, -9.81, 0};
  return m;
}

/// What the rod bends by in all records, m.
template <FrameGroup G>
Eigen::VectorXd bend_of(const Mechanism& m, const Run<G>& r) {
  const ResponseSpec bend = bend_of_the_rod(m);
  const ResponseValues<G> values(m, *r.model);
  State<G> s = r.model->initial_state();
  Eigen::VectorXd out(r.trajectory().size());
  for (int i = 0; i < out.size(); ++i) {
    r.trajectory().read(i, s);
    out[i] = values(bend, s)[0];
  }
  return out;
}

template <class G>
class PenaltyOfMeshes : public ::testing::Test {
 protected:
  static SimulationOptions options() { return test::options(0.02, 2e-4, 0.8, 1e-9); }
};
TYPED_TEST_SUITE(PenaltyOfMeshes, Groups);

/// Positions, what the rod bends by and joint forces come near those of multipliers with 1/weight.
TYPED_TEST(PenaltyOfMeshes, ConvergesToMultipliersWithOrderOne) {
  using G = TypeParam;
  for (const auto as : {SolidMotion::Reduced, SolidMotion::Continuum}) {
    SCOPED_TRACE(as == SolidMotion::Reduced ? "reduced" : "continuum");
    const Mechanism m = meshed_crank<G>(as);
    const auto space = space_of<G>(m);
    const auto exact = run<G>(m, space, this->options());
    ASSERT_EQ(exact.report().status, SolveStatus::Converged) << exact.report().reason;
    const Eigen::VectorXd bend = bend_of(m, exact);
    EXPECT_GT(bend.norm(), 1e-4);
    Vec3 before = Vec3::Zero();
    for (const double weight : {1e9, 1e10, 1e11}) {
      const Mechanism held = penalised(m, ConstraintForm::Penalty, weight);
      const auto soft = run<G>(held, space, this->options());
      ASSERT_EQ(soft.report().status, SolveStatus::Converged) << soft.report().reason;
      const Eigen::VectorXd force = exact.trajectory().lambda(exact.last());
      const Vec3 error(distance(soft, exact), (bend_of(held, soft) - bend).norm() / bend.norm(),
                       (soft.trajectory().lambda(soft.last()) - force).norm() / force.norm());
      if (before[0] > 0) {
        EXPECT_NEAR(std::log10(before[0] / error[0]), 1, 0.05) << weight;
        EXPECT_NEAR(std::log10(before[1] / error[1]), 1, 0.05) << weight;
        EXPECT_NEAR(std::log10(before[2] / error[2]), 1, 0.05) << weight;
      }
      before = error;
    }
    EXPECT_LT(before[1], 1e-5);
  }
}

/// At most three augmentations a step close every joint to 1e-9 m. (With a tangent that is held and
/// a residual of 1e-8 the corrections of a step are too few for them, and steps are halved.)
TYPED_TEST(PenaltyOfMeshes, AugmentedIsTheMotionOfMultipliers) {
  using G = TypeParam;
  for (const auto as : {SolidMotion::Reduced, SolidMotion::Continuum})
    for (const auto tangent : {TangentStrategy::Auto, TangentStrategy::Exact}) {
      SCOPED_TRACE(as == SolidMotion::Reduced ? "reduced" : "continuum");
      const Mechanism m = meshed_crank<G>(as), held = penalised(m, ConstraintForm::Augmented);
      const auto space = space_of<G>(m);
      SimulationOptions o = this->options();
      o.tangent = tangent;
      if (tangent == TangentStrategy::Auto) o.tolerance = 1e-7;
      const auto exact = run<G>(m, space, o), closed = run<G>(held, space, o);
      ASSERT_EQ(closed.report().status, SolveStatus::Converged) << closed.report().reason;
      EXPECT_LE(closed.report().max_constraint_residual, 1e-9);
      EXPECT_LE(closed.report().penalty.most_augmentations, 3);
      EXPECT_GT(closed.report().penalty.augmentations, 0);
      EXPECT_EQ(closed.report().rejected_steps, 0);
      EXPECT_LT(distance(closed, exact), 0.1 * o.tolerance);
      const Eigen::VectorXd bend = bend_of(m, exact);
      EXPECT_LT((bend_of(held, closed) - bend).norm(), 100 * o.tolerance * bend.norm());
    }
}

TEST(Penalty, BadWeightsAreRefused) {
  const Mechanism m = crank();
  for (const double bad : {-1., std::nan(""), 1 / 0.}) {
    Mechanism at = m;
    at.penalty.form = ConstraintForm::Penalty;
    at.penalty.displacement = bad;
    EXPECT_THROW(Model<SE2>::build(at, space_of<SE2>(at)), std::invalid_argument);
    at.penalty.displacement = 0;
    at.penalty.damping = bad;
    EXPECT_THROW(Model<SE2>::build(at, space_of<SE2>(at)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace liesl::test::penalty_test
