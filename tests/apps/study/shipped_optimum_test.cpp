/// @file
/// That shipped studies end at the optimum of their motion: searches that know nothing of gradients
/// and static problems, and what variables gain together.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/scene/space.hpp"
#include "optim/cycle/motion_model.hpp"
#include "optim/cycle/trust_region_rule.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::shipped_optimum_test {
namespace {

using Eigen::VectorXd;

/// A study of one motion.
template <FrameGroup G>
class Planned {
 public:
  explicit Planned(const Study& study)
      : spec_(study.spec),
        motion_({{study.scene.mechanism, std::get<Space<G>>(choose_space(study.scene).space),
                  study.scene.simulation}}),
        model_(motion_, spec_) {}
  DesignModel& model() { return model_; }
  LoopResult optimise() {
    TrustRegionRule rule(spec_.cycle);
    return run_loop(model_, rule, spec_.cycle, {}, {});
  }

 private:
  const StudySpec spec_;
  const std::vector<Scenario<G>> motion_;
  MotionModel<G> model_;
};

/// The mass of beams of these relative dimensions, all scaled until the worst limit is met: by
/// false position, which few simulations end.
class MassOnTheLimit {
 public:
  explicit MassOnTheLimit(DesignModel& model) : model_(model) {}

  double operator()(const VectorXd& shape) {
    double low = 0.98, high = 1.02, at_low = worst(low * shape);
    while (at_low < 0) at_low = worst((low *= 0.96) * shape);
    double at_high = worst(high * shape);
    while (at_high > 0) at_high = worst((high *= 1.04) * shape);
    double mass = mass_, met = at_high;  // those of `high`, analysed last
    while (met < -1e-6 && high - low > 1e-8) {
      const double share = std::min(0.9, std::max(0.1, at_low / (at_low - at_high)));
      const double scale = low + share * (high - low), at = worst(scale * shape);
      if (at > 0) {
        low = scale;
        at_low = at;
      } else {
        high = scale;
        at_high = met = at;
        mass = mass_;
      }
    }
    return mass;
  }

 private:
  double worst(const VectorXd& x) {
    const auto at = model_.analyse(x, {});
    EXPECT_TRUE(at->good()) << at->reason;
    mass_ = at->mass;
    return at->worst;
  }

  DesignModel& model_;
  double mass_ = 0;
};

/// Steepest descent of ln(mass) over the logarithms of the dimensions by central differences.
VectorXd descend(MassOnTheLimit& mass, VectorXd x) {
  constexpr double kDifference = 2e-3;
  double best = mass(x), step = 0.2;
  while (step > 1e-3) {
    VectorXd slope(x.size());
    for (int i = 0; i < x.size(); ++i) {
      VectorXd more = x, less = x;
      more[i] *= std::exp(kDifference);
      less[i] *= std::exp(-kDifference);
      slope[i] = mass(more) - mass(less);
    }
    const VectorXd direction = -slope / slope.norm();
    bool moved = false;
    for (; !moved && step > 1e-3; step /= 2) {
      const VectorXd y = x.array() * (step * direction.array()).exp();
      const double there = mass(y);
      if (there >= best * (1 - 1e-6)) continue;
      x = y;
      best = there;
      moved = true;
    }
    if (moved) step *= 3;
  }
  return x;
}

/// What exchanges between two dimensions leave of it: descent stops at kinks, where peaks change.
double after_exchanges(MassOnTheLimit& mass, VectorXd x) {
  double best = mass(x);
  for (double step = 0.02; step > 4e-4; step /= 2)
    for (bool moved = true; moved;) {
      moved = false;
      for (int i = 0; i < x.size(); ++i)
        for (const double factor : {1 + step, 1 - step}) {
          VectorXd y = x;
          y[i] *= factor;
          const double there = mass(y);
          if (there >= best * (1 - 1e-7)) continue;
          best = there;
          x = y;
          moved = true;
        }
    }
  return best;
}

/// The study as it is shipped, from its uniform rod.
TEST(ShippedOptimumSlow, ADescentByDifferencesFindsNoLighterRod) {
  Planned<SE2> rod(shipped_study("slider_crank_rod"));
  const LoopResult end = rod.optimise();
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_LE(end.best->worst, 1e-4);
  MassOnTheLimit mass(rod.model());
  const double searched = after_exchanges(mass, descend(mass, rod.model().start()));
  RecordProperty("searched_kg", std::to_string(searched));
  RecordProperty("optimised_kg", std::to_string(end.best->mass));
  EXPECT_LE(end.best->mass, searched * (1 + 5e-4));
  EXPECT_GE(end.best->mass, searched * (1 - 5e-4));
}

/// What the default mesh hides of the final rod.
TEST(ShippedOptimumSlow, TheFinalRodBendsAsOnSixtyFourElements) {
  Planned<SE2> rod(shipped_study("slider_crank_rod"));
  const LoopResult end = rod.optimise();
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  Planned<SE2> fine(shipped_study("slider_crank_rod", {"scene.bodies.rod.beam.elements=64",
                                                       "scene.bodies.crank.beam.elements=64"}));
  const auto on_fine = fine.model().analyse(end.x, {});
  ASSERT_TRUE(on_fine->good()) << on_fine->reason;
  EXPECT_LE(std::abs(on_fine->worst - end.best->worst), 2e-4);
}

/// Loads that follow the design strongly: a rod of 0.2846 kg is where the plain cycle ends.
TEST(ShippedOptimumSlow, ARodOfAHeavySliderIsAsLightFromThreeStarts) {
  for (const char* start : {"0.008", "0.01146", "0.012"}) {
    Planned<SE2> rod(shipped_study("slider_crank_rod",
                                   {"scene.gravity=[0,0,0]", "scene.bodies.slider.rigid.mass=0.4",
                                    std::string("design.rod_diameters.start=") + start}));
    const LoopResult end = rod.optimise();
    EXPECT_EQ(end.status, CycleStatus::Optimal) << start << ": " << end.reason;
    EXPECT_NEAR(end.best->mass, 0.23, 1e-4) << start;
  }
}

/// Walls, values of the drives' tables and duration of the two-link robot, some of them held.
struct RobotEnd {
  double mass, duration, objective;
};
RobotEnd robot(const Changes& held) {
  Planned<SE2> of(shipped_study("robot_codesign", held));
  const LoopResult end = of.optimise();
  EXPECT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  return {end.best->mass, end.x[end.x.size() - 1], end.best->objective};
}

void expect_better(const RobotEnd& both, const RobotEnd& one) {
  EXPECT_LT(both.mass, one.mass);
  EXPECT_LT(both.duration, one.duration);
  EXPECT_LT(both.objective, one.objective);
}

TEST(ShippedOptimumSlow, WallsAndMotionTogetherAreLighterAndFasterThanEither) {
  const std::string wall = ".bounds=[0.0019999, 0.0020001]";
  Changes path;  // the cycloid of the scene
  for (const char* drive : {"shoulder_", "elbow_"})
    for (const auto& [i, at] : {std::pair{"1", 0.051}, {"2", 0.3209}, {"3", 0.7263}, {"4", 0.9962}})
      path.push_back(std::string("design.") + drive + i + ".bounds=[" + std::to_string(at - 1e-6) +
                     ", " + std::to_string(at + 1e-6) + "]");
  const RobotEnd both = robot({});
  expect_better(both, robot({"design.arm1_walls" + wall, "design.arm2_walls" + wall}));
  expect_better(both, robot(path));
}

TEST(ShippedOptimumSlow, AHundredSectionsInSpaceEndOptimal) {
  Planned<SE3> rod(shipped_study("slider_crank_rod",
                                 {"simulation.space=spatial", "scene.bodies.rod.beam.elements=100",
                                  "design.rod_diameters.groups=100"}));
  ASSERT_EQ(rod.model().variables().size(), 100u);
  const LoopResult end = rod.optimise();
  EXPECT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_LE(end.best->worst, 1e-3);
  EXPECT_LT(end.best->mass, 0.2152) << "kg, of four sections";
}

}  // namespace
}  // namespace liesl::test::shipped_optimum_test
