/// @file
/// What static problems of the whole mechanism (thesis section 5.2) add to those of single parts:
/// the figures of docs/methods.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "apps/input/problem.hpp"
#include "apps/scene/load_scene.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "optim/cycle/motion_model.hpp"
#include "optim/cycle/trust_region_rule.hpp"
#include "optim/problems/mechanism_rows.hpp"
#include "reference/places.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::mechanism_statics_test {
namespace {

using Eigen::VectorXd;

/// A study of a planar motion.
struct Simulated {
  explicit Simulated(Study s) : study(std::move(s)) {
    study.spec.cycle.max = 60;
    motion = {
        {study.scene.mechanism, space_of<SE2>(study.scene.mechanism), study.scene.simulation}};
  }
  LoopResult optimise(CycleMethod method, SurrogateKind surrogate = SurrogateKind::Auto) const {
    Simulated all = *this;
    for (ConstraintSpec& c : all.study.spec.constraints) c.surrogate = surrogate;
    return all.optimise_as_read(method);
  }
  LoopResult optimise_as_read(CycleMethod method) const {
    StudySpec spec = study.spec;
    spec.cycle.method = method;
    MotionModel<SE2> model(motion, spec);
    TrustRegionRule rule(spec.cycle);
    return run_loop(model, rule, spec.cycle, {}, {});
  }
  Study study;
  std::vector<Scenario<SE2>> motion;
};

/// robot_arms with a single limit that the static problem of no part tells.
Simulated arms_with(Study study, ResponseSpec response, double limit) {
  study.spec.constraints = {{std::move(response), limit}};
  study.spec.constraints[0].has_image = false;
  return Simulated(std::move(study));
}

/// How far the tip swings beyond the end of the motion, which both arms do: a vibration.
Simulated tip_of_arms(double limit) {
  Study study = shipped_study("robot_arms");
  ResponseSpec tip;
  tip.name = "tip";
  tip.at = *study.scene.mechanism.port("payload.origin");
  tip.axis = Vec3::UnitX();
  tip.side = Side::Down;
  return arms_with(std::move(study), tip, limit);
}

/// Arms at a right angle that turn as one, with a limit on the change of the distance from the
/// shoulder to the payload: both bend as the inertia of the payload asks for.
Simulated bent_arms(double limit) {
  Study study = shipped_study("robot_arms");
  Mechanism& m = study.scene.mechanism;
  const int arm2 = m.body("arm2"), payload = m.body("payload");
  auto& beam = std::get<BeamSpec>(m.bodies[std::size_t(arm2)].kind);
  beam.nodes = straight({0.6, 0, 0}, {0.6, 0.6, 0}, static_cast<int>(beam.sections.size()));
  std::get<RigidSpec>(m.bodies[std::size_t(payload)].kind).frame.x = Vec3(0.6, 0.6, 0);
  m.joints[2].type = JointType::Fixed;
  m.drives.resize(1);
  ResponseSpec extension;
  extension.name = "reach";
  extension.kind = ResponseKind::Elongation;
  extension.at = *m.port("arm1.start");
  extension.to = *m.port("payload.origin");
  return arms_with(std::move(study), extension, limit);
}

/// d ln v / d ln x_i of a limit where it is largest, in the motion and by the whole mechanism.
struct Slopes {
  VectorXd motion, statics;
};
Slopes relative_slopes(const Simulated& s, int constraint) {
  StudySpec spec = s.study.spec;
  spec.cycle.method = CycleMethod::Full;
  MotionModel<SE2> model(s.motion, spec);
  const VectorXd x = model.start();
  const auto at = model.analyse(x, {});
  const auto& run = dynamic_cast<const MotionAnalysis<SE2>&>(*at).runs.front();
  const ResponseSpec& response = s.study.spec.constraints[std::size_t(constraint)].response;
  const MotionGradients motion(model.design(), run, x, {{constraint, response}});
  int peak = 0;
  for (int n = 0; n < motion.records(0); ++n)
    if (motion.value(0, n) > motion.value(0, peak)) peak = n;
  Slopes out;
  const double v =
      MechanismStatics<SE2>(model.simulator(0), run, {peak}).value(response, peak, x, &out.statics);
  EXPECT_NEAR(v, motion.value(0, peak), 1e-12 * v);
  out.statics = out.statics.cwiseProduct(x) / v;
  out.motion = motion.gradient(0, peak)->cwiseProduct(x) / v;
  return out;
}

void record(const std::string& name, double figure) {
  testing::Test::RecordProperty(name, std::to_string(figure));
}

/// d|y|/dx is that of differences, on groups and with beams of order 4; |y| at x_k that of the
/// motion.
TEST(MechanismStatics, HaveTheSlopesOfDifferences) {
  for (const Formalism formalism : {Formalism::SE3, Formalism::R3SO3})
    for (const int order : {2, 4}) {
      if (formalism != Formalism::SE3 && order == 4) continue;
      Simulated s = tip_of_arms(3e-3);
      for (BodySpec& body : s.motion[0].mechanism.bodies)
        if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->order = order;
      s.motion[0].mechanism.formalism = formalism;
      MotionModel<SE2> model(s.motion, s.study.spec);
      const VectorXd x = model.start();
      const auto at = model.analyse(x, {});
      ASSERT_TRUE(at->good()) << at->reason;
      const auto& run = dynamic_cast<const MotionAnalysis<SE2>&>(*at).runs.front();
      const ResponseSpec& tip = s.study.spec.constraints[0].response;
      const int last = static_cast<int>(run.times().size()) - 1;
      int peak = last;
      for (int n = 0; n < last; ++n)
        if (run.limits[0].values[std::size_t(n)] > run.limits[0].values[std::size_t(peak)])
          peak = n;
      MechanismStatics<SE2> statics(model.simulator(0), run, {peak});
      VectorXd slope;
      const double largest = run.limits[0].values[std::size_t(peak)];
      EXPECT_GT(largest, 0);
      EXPECT_NEAR(statics.value(tip, peak, x, &slope), largest, 1e-12 * largest);
      for (int i = 0; i < x.size(); ++i) {
        const VectorXd h = 1e-4 * x[i] * VectorXd::Unit(x.size(), i);
        const double d =
            (statics.value(tip, peak, x + h, nullptr) - statics.value(tip, peak, x - h, nullptr)) /
            (2 * h[i]);
        EXPECT_NEAR(d, slope[i], 1e-6 * slope.norm()) << i << ", order " << order;
      }
    }
}

/// A pendulum swings with nothing held: it has no static problem.
TEST(MechanismStatics, AreRefusedOfAMechanismThatMoves) {
  Simulated s = tip_of_arms(3e-3);
  s.motion[0].mechanism.drives.clear();
  ConstraintSpec& limit = s.study.spec.constraints[0];
  limit.response.side = Side::Both;
  limit.surrogate = SurrogateKind::Mechanism;
  s.study.spec.cycle.method = CycleMethod::Esl1;
  const StudySpec& spec = s.study.spec;
  try {
    run_cycle<SE2>(s.motion, spec, {}, {});
    FAIL() << "not refused";
  } catch (const NoStaticsOfMechanism& error) {
    EXPECT_NE(std::string(error.what()).find("can move at t = "), std::string::npos)
        << error.what();
  }
}

/// So does one whose factor does not look singular.
TEST(MechanismStatics, AreRefusedOfABeamThatSwings) {
  Study study = shipped_study("slider_crank_rod");
  study.scene = load_scene(std::filesystem::path(kDataDir) / "scenes" / "pendulum.toml");
  study.scene.simulation.duration = 0.1;
  const StudySpec spec;
  const Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  const DesignSimulator<SE2> simulator(study.scene.mechanism, space, study.scene.simulation, spec);
  const DesignRun<SE2> run = simulator.run(VectorXd());
  try {
    const MechanismStatics<SE2> statics(simulator, run, {50});
    FAIL() << "not refused";
  } catch (const MechanismMoves& error) {
    EXPECT_NE(std::string(error.what()).find("body 'beam' can rotate"), std::string::npos)
        << error.what();
  }
}

/// All limits by the motion alone: the steps of the fully coupled method.
TEST(SurrogateOfALimit, ByTheMotionAloneIsTheFullyCoupledMethod) {
  const Simulated rod(shipped_study("slider_crank_rod"));
  const LoopResult esl1 = rod.optimise(CycleMethod::Esl1, SurrogateKind::Motion),
                   full = rod.optimise(CycleMethod::Full);
  EXPECT_EQ(esl1.status, CycleStatus::Optimal) << esl1.reason;
  EXPECT_EQ(esl1.history.size(), full.history.size());
  EXPECT_EQ(esl1.best->mass, full.best->mass);
}

/// One limit by its static problem, the other by the motion: the same optimum.
TEST(SurrogateOfALimit, IsAChoiceOfEachLimit) {
  const auto mass = [](const Changes& changes) {
    const LoopResult end =
        Simulated(shipped_study("robot_arms", changes)).optimise_as_read(CycleMethod::Esl1);
    EXPECT_EQ(end.status, CycleStatus::Optimal) << end.reason;
    return end.best->mass;
  };
  const double statics = mass({}),
               mixed = mass({"constraints.arm1_deflection.surrogate=\"motion\""});
  EXPECT_NE(mixed, statics);  // other steps
  EXPECT_NEAR(mixed, statics, 1e-4 * statics);
}

/// The plain cycle has static problems alone.
TEST(SurrogateOfALimit, ByTheMotionIsRefusedOfThePlainCycle) {
  try {
    shipped_study("slider_crank_rod",
                  {"constraints.bending.surrogate=\"motion\"", "cycle.method=\"esl\""});
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is told by the motion's own gradients"),
              std::string::npos)
        << error.what();
  }
}

/// In a study file: what has no such static problem is refused at its key.
TEST(MechanismStatics, WhatHasNoneIsRefusedAtItsPlace) {
  const std::string surrogate = "constraints.bending.surrogate=\"mechanism\"";
  EXPECT_EQ(shipped_study("slider_crank_rod", {surrogate}).spec.constraints[0].surrogate,
            SurrogateKind::Mechanism);
  for (const auto& [change, words] :
       {std::pair{"cycle.method=\"full\"", "takes no static problem of the mechanism"},
        std::pair{"constraints.bending.treatment=\"ks\"", "motion's own gradients"}})
    try {
      shipped_study("slider_crank_rod", {surrogate, change});
      FAIL() << change;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

/// What the scene or the response rules out.
TEST(MechanismStatics, AreNotOfModesNorOfForcesInJoints) {
  const Study study = shipped_study("slider_crank_rod");
  const ConstraintSpec& bending = study.spec.constraints[0];
  Mechanism m = study.scene.mechanism;
  EXPECT_FALSE(without_mechanism_statics(study.spec, bending, m));
  ConstraintSpec force = bending;
  force.response.kind = ResponseKind::JointForce;
  EXPECT_TRUE(without_mechanism_statics(study.spec, force, m));
  m.formalism = Formalism::Floating;
  EXPECT_TRUE(without_mechanism_statics(study.spec, bending, m));
}

/// A crank that is thicker bends the rod less in motion, by its inertia; that is not static: drives
/// held, the mechanism is determinate, and its joints carry the same forces whatever bends.
TEST(MechanismStatics, TellOfAPartWhatItsOwnStaticsTell) {
  const Slopes rod = relative_slopes(Simulated(shipped_study("slider_crank_both")), 0);
  const auto crank = rod.motion.size() - 2;
  record("rod_by_crank_motion", rod.motion.tail(2).sum());
  record("rod_by_crank_statics", rod.statics.tail(2).sum());
  EXPECT_NEAR(rod.motion.tail(2).sum(), -0.8, 0.1);
  EXPECT_LT(rod.statics.tail(2).norm(), 0.01 * rod.motion.tail(2).norm());
  EXPECT_NEAR(rod.statics.head(crank).sum(), -4, 0.1);  // 1/EI
}

/// The first cycle whose design meets its limits to 1e-3 and has 2e-3 more mass than the end at
/// most: the rest are steps that the optimality conditions ask for.
int near_the_end(const LoopResult& run) {
  const auto near = [&](const Cycle& c) {
    return c.worst <= 1e-3 && c.mass <= (1 + 2e-3) * run.best->mass;
  };
  const auto first = std::find_if(run.history.begin(), run.history.end(), near);
  return 1 + static_cast<int>(first - run.history.begin());
}

int to_the_end(const LoopResult& run) { return static_cast<int>(run.history.size()); }

/// Cycles of the same study with other rows, which all end at the same mass.
struct Cycles {
  int powers, parts, mechanism;  ///< 0: no part tells it
};
Cycles cycles_of(const std::string& name, const Simulated& s, bool parts,
                 int (*counted)(const LoopResult&)) {
  const auto count = [&](const char* rows, const LoopResult& run) {
    EXPECT_EQ(run.status, CycleStatus::Optimal) << name << ", " << rows << ": " << run.reason;
    record(name + "_" + rows, to_the_end(run));
    record(name + "_" + rows + "_near", near_the_end(run));
    record(name + "_" + rows + "_kg", run.best->mass);
    return counted(run);
  };
  Simulated continued = s;
  continued.study.spec.cycle.approximation = Approximation::Power;
  const LoopResult powers = continued.optimise(CycleMethod::Full),
                   mechanism = s.optimise(CycleMethod::Esl1, SurrogateKind::Mechanism);
  EXPECT_NEAR(mechanism.best->mass, powers.best->mass, 1e-3 * powers.best->mass) << name;
  Cycles out{count("powers", powers), 0, count("mechanism", mechanism)};
  if (parts) out.parts = count("parts", s.optimise(CycleMethod::Esl1));
  return out;
}

/// Limits on single parts: static problems of the parts save cycles, on the rod half of them, and
/// those of the whole mechanism hardly any beyond.
TEST(MechanismStaticsSlow, SaveNoMoreThanStaticsOfPartsWhereALimitIsOnAPart) {
  const Changes from_16_mm = {"design.rod_diameters.start=0.016"};
  for (const auto& [name, s] :
       {std::pair{"rod", Simulated(shipped_study("slider_crank_rod", from_16_mm))},
        std::pair{"arms", Simulated(shipped_study("robot_arms"))}}) {
    const Cycles n = cycles_of(name, s, true, to_the_end);
    EXPECT_LT(n.parts, n.powers) << name;
    if (std::string(name) == "rod") EXPECT_LE(2 * n.parts, n.powers);
    EXPECT_LE(std::abs(n.mechanism - n.parts), 2) << name;
  }
}

/// Limits on several bodies: they save a third of the cycles where the bodies bend as the loads ask
/// for, fewer where they vibrate.
TEST(MechanismStaticsSlow, SaveCyclesWhereSeveralBodiesBendTogether) {
  const Cycles bent = cycles_of("bent", bent_arms(1.5e-3), false, near_the_end);
  EXPECT_LE(3 * bent.mechanism, 2 * bent.powers);
  const Cycles tip = cycles_of("tip", tip_of_arms(3e-3), false, near_the_end);
  EXPECT_LT(tip.mechanism, tip.powers);
}

}  // namespace
}  // namespace liesl::test::mechanism_statics_test
