/// @file
/// Sizes of catalogues in whole studies: the best of all designs, each of them simulated; the same
/// after an interruption.
#include "optim/cycle/catalogue.hpp"

#include <gtest/gtest.h>

#include "apps/scene/space.hpp"
#include "apps/study/load_study.hpp"
#include "reference/places.hpp"

namespace liesl::test::catalogue_test {
namespace {

using Eigen::VectorXd;

class RodOfCatalogue : public testing::Test {
 protected:
  static std::vector<std::string> changes() {
    return {"simulation.duration=0.02", "design.rod_diameters.groups=2",
            "design.rod_diameters.values=[0.0105,0.0112,0.0119,0.0126,0.0133,0.014,0.0155]",
            "constraints.bending.limit=1.5e-4", "cycle.gap=0"};
  }
  const Study study_ =
      load_study(std::string(kDataDir) + "/studies/slider_crank_rod.toml", changes());
  const ChosenSpace space_ = choose_space(study_.scene);
  const Space<SE2>& plane_ = std::get<Space<SE2>>(space_.space);

  Topology<CycleResult<SE2>> search(const TopologyHooks& hooks, const RoundHistory& resume) const {
    const OptimiseRound<CycleResult<SE2>> optimise =
        [&](const StudySpec& study, const Mechanism& mechanism, const CycleHooks& cycle,
            const std::vector<Cycle>& cycles) {
          return run_cycle<SE2>(mechanism, plane_, study_.scene.simulation, study, cycle, cycles);
        };
    return search_catalogue<CycleResult<SE2>>(study_.spec, study_.scene.mechanism, optimise, hooks,
                                              resume);
  }
};

TEST_F(RodOfCatalogue, IsTheBestOfAllDesigns) {
  const auto found = search({}, {});
  const DesignSimulator<SE2> simulator(study_.scene.mechanism, plane_, study_.scene.simulation,
                                       study_.spec);
  double best = std::numeric_limits<double>::infinity();
  VectorXd x(2), at;
  for (const double a : study_.spec.design[0].values)
    for (const double b : study_.spec.design[0].values) {
      x << a, b;
      const auto run = simulator.run(x);
      if (!run.good() || run.worst > 1e-6 || run.mass >= best) continue;
      best = run.mass;
      at = x;
    }
  const CycleResult<SE2>& end = found.last.end;
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_DOUBLE_EQ(end.mass, best) << end.x.transpose() << " for " << at.transpose();
  EXPECT_EQ(end.x, at);
  ASSERT_TRUE(found.catalogue);
  EXPECT_TRUE(found.catalogue->found);
  EXPECT_EQ(found.catalogue->gap, 0);
  EXPECT_LE(found.catalogue->continuous, best);
  EXPECT_NEAR(found.catalogue->above_continuous, best / found.catalogue->continuous - 1, 1e-12);
  EXPECT_FALSE(end.optimality->residual);  // of sizes that may not move there is none
  EXPECT_LT(*found.catalogue->kkt_residual, kOptimalResidual);
  EXPECT_NE(end.reason.find("designs in"), std::string::npos) << end.reason;
}

TEST_F(RodOfCatalogue, AnInterruptedSearchGoesOnAsIfItHadNotBeen) {
  std::vector<RoundHistory> states;
  TopologyHooks hooks;
  hooks.on_round_cycle = [&](const RoundHistory& rounds) { states.push_back(rounds); };
  const auto whole = search(hooks, {});
  ASSERT_GT(states.size(), 8u);
  for (std::size_t k = 0; k + 1 < states.size(); k += states.size() / 4) {
    RoundHistory last;
    TopologyHooks again;
    again.on_round_cycle = [&](const RoundHistory& rounds) { last = rounds; };
    const auto resumed = search(again, states[k]);
    EXPECT_EQ(resumed.last.end.status, whole.last.end.status) << k;
    EXPECT_EQ(resumed.last.end.reason, whole.last.end.reason) << k;
    EXPECT_EQ(resumed.last.end.x, whole.last.end.x) << k;
    EXPECT_EQ(resumed.catalogue->designs, whole.catalogue->designs) << k;
    EXPECT_EQ(resumed.catalogue->effort.newton_iterations,
              whole.catalogue->effort.newton_iterations);
    EXPECT_EQ(last.size(), states.back().size());
  }
}

/// As after a run with fewer cycles a box: the boxes behind one that goes on are searched anew.
TEST_F(RodOfCatalogue, ABoxAtItsCycleLimitGoesOn) {
  RoundHistory rounds;
  TopologyHooks hooks;
  hooks.on_round_cycle = [&](const RoundHistory& so_far) { rounds = so_far; };
  const auto whole = search(hooks, {});
  std::size_t longest = 1;
  for (std::size_t n = 1; n < rounds.size(); ++n)
    if (rounds[n].size() > rounds[longest].size()) longest = n;
  ASSERT_GE(rounds[longest].size(), 2u);
  rounds[longest].resize(1);
  rounds[longest].back().end = CycleStatus::CycleLimit;
  std::vector<std::size_t> sizes;
  hooks.on_round_cycle = [&](const RoundHistory& so_far) { sizes.push_back(so_far.size()); };
  const auto resumed = search(hooks, rounds);
  EXPECT_EQ(resumed.last.end.reason, whole.last.end.reason);
  EXPECT_EQ(resumed.last.end.x, whole.last.end.x);
  EXPECT_EQ(resumed.catalogue->designs, whole.catalogue->designs);
  ASSERT_FALSE(sizes.empty());
  EXPECT_GT(sizes.front(), longest) << "the boxes before it are kept";
}

/// Stopped between the end of its first start and the next one.
TEST_F(RodOfCatalogue, AnInfeasibleBoxBeginsAgainWhenItIsResumed) {
  StudySpec study = study_.spec;
  study.cycle.restarts = 1;
  const OptimiseRound<CycleResult<SE2>> optimise =
      [&](const StudySpec& box, const Mechanism& mechanism, const CycleHooks& cycle,
          const std::vector<Cycle>& cycles) {
        return run_cycle<SE2>(mechanism, plane_, study_.scene.simulation, box, cycle, cycles);
      };
  RoundHistory rounds;
  TopologyHooks hooks;
  hooks.on_round_cycle = [&](const RoundHistory& so_far) { rounds = so_far; };
  const auto whole =
      search_catalogue<CycleResult<SE2>>(study, study_.scene.mechanism, optimise, hooks);
  const auto again = std::find_if(rounds.begin(), rounds.end(), [](const History& round) {
    return !round.empty() && round.back().start == 1;
  });
  ASSERT_NE(again, rounds.end()) << "no box was infeasible from its start";
  std::erase_if(*again, [](const Cycle& c) { return c.start == 1; });
  ASSERT_EQ(again->back().end, CycleStatus::Infeasible);
  rounds.erase(again + 1, rounds.end());
  const auto resumed =
      search_catalogue<CycleResult<SE2>>(study, study_.scene.mechanism, optimise, {}, rounds);
  EXPECT_EQ(resumed.last.end.reason, whole.last.end.reason);
  EXPECT_EQ(resumed.last.end.x, whole.last.end.x);
  EXPECT_EQ(resumed.catalogue->designs, whole.catalogue->designs);
  EXPECT_EQ(resumed.catalogue->effort.newton_iterations, whole.catalogue->effort.newton_iterations);
}

/// Stopped within any cycle, that in which a box would have ended among them.
TEST_F(RodOfCatalogue, StopsOnRequestAndGoesOn) {
  const auto whole = search({}, {});
  for (int most = 1; most < whole.catalogue->designs; most += 6) {
    int cycles = 0;
    RoundHistory so_far;
    TopologyHooks hooks;
    hooks.on_round_cycle = [&](const RoundHistory& rounds) {
      ++cycles;
      so_far = rounds;
    };
    hooks.keep_going = [&] { return cycles < most; };
    const auto stopped = search(hooks, {});
    EXPECT_EQ(stopped.last.end.status, CycleStatus::Interrupted) << stopped.last.end.reason;
    const auto resumed = search({}, so_far);
    EXPECT_EQ(resumed.last.end.status, whole.last.end.status) << most;
    EXPECT_EQ(resumed.last.end.reason, whole.last.end.reason) << most;
    EXPECT_EQ(resumed.last.end.x, whole.last.end.x) << most;
    EXPECT_EQ(resumed.catalogue->undecided, whole.catalogue->undecided) << most;
  }
}

TEST_F(RodOfCatalogue, SaysTheGapWhenTheDesignsAreUsedUp) {
  Study few = study_;
  few.spec.cycle.max_designs = 8;
  const OptimiseRound<CycleResult<SE2>> optimise =
      [&](const StudySpec& study, const Mechanism& mechanism, const CycleHooks& cycle,
          const std::vector<Cycle>& cycles) {
        return run_cycle<SE2>(mechanism, plane_, few.scene.simulation, study, cycle, cycles);
      };
  const auto end = search_catalogue<CycleResult<SE2>>(few.spec, few.scene.mechanism, optimise, {});
  EXPECT_EQ(end.last.end.status, CycleStatus::CycleLimit);
  EXPECT_GT(end.catalogue->gap, 0);
  EXPECT_NE(end.last.end.reason.find("8 designs are used up"), std::string::npos)
      << end.last.end.reason;
}

/// The shipped rod: of all 14641 designs those that are lighter than the answer, and not below the
/// continuous optimum, exceed the limit; each is simulated.
TEST(RodOfCatalogueSlow, NoLighterDesignMeetsTheLimit) {
  const Study study = load_study(std::string(kDataDir) + "/studies/rod_catalogue.toml");
  const ChosenSpace space = choose_space(study.scene);
  const DesignSimulator<SE2> simulator(study.scene.mechanism, std::get<Space<SE2>>(space.space),
                                       study.scene.simulation, study.spec);
  const auto& values = study.spec.design[0].values;
  VectorXd x(4);
  x << 0.009, 0.012, 0.012, 0.010;
  const auto answer = simulator.run(x);
  ASSERT_LE(answer.worst, 1e-6);
  const double square = x.squaredNorm(), least = square * 0.2102 / answer.mass;
  int simulated = 0;
  for (const double a : values)
    for (const double b : values)
      for (const double c : values)
        for (const double d : values) {
          x << a, b, c, d;
          if (x.squaredNorm() >= square * (1 - 1e-12) || x.squaredNorm() < least) continue;
          const auto run = simulator.run(x);
          EXPECT_TRUE(!run.good() || run.worst > 1e-6) << x.transpose() << ": " << run.mass;
          ++simulated;
        }
  EXPECT_EQ(simulated, 468);
}

/// Under fixed loads: the half-axes of a hole of drills and mills.
TEST(PartOfCatalogue, IsTheBestOfAllDesigns) {
  const Study study =
      load_study(std::string(kDataDir) + "/studies/plate_with_hole.toml",
                 {"bodies.plate.solid.mesh.cells=[20,20]", "design.a.values=[0.12,0.13,0.14]",
                  "design.b.values=[0.06,0.07,0.08]", "design.b.start=0.08", "cycle.gap=0"});
  const Mechanism& mechanism = study.scene.mechanism;
  const int body = study.spec.shapes.begin()->first;
  const OptimiseRound<PartEnd> optimise = [&](const StudySpec& spec, const Mechanism& m,
                                              const CycleHooks& cycle,
                                              const std::vector<Cycle>& cycles) {
    return optimise_outline(spec, m, body, cycle, cycles);
  };
  const auto found = search_catalogue<PartEnd>(study.spec, mechanism, optimise, {});
  PartShape part(mechanism, body, study.spec.shapes.at(body));
  const SolidTask task = solid_task(study.spec, part);
  PartModel model(task);
  double best = std::numeric_limits<double>::infinity();
  VectorXd x(2), at;
  for (const double a : {0.12, 0.13, 0.14})
    for (const double b : {0.06, 0.07, 0.08}) {
      x << a, b;
      const auto end = model.analyse(x, {});
      if (!end->good() || end->worst > 1e-6 || end->objective >= best) continue;
      best = end->objective;
      at = x;
    }
  ASSERT_TRUE(closed(found.last.end.status)) << found.last.end.reason;
  EXPECT_EQ(found.last.end.x, at);
  EXPECT_DOUBLE_EQ(found.last.end.best->objective, best);
  EXPECT_EQ(found.catalogue->gap, 0);
}

/// A hole is inserted as if the height were free; then the height is of the catalogue, and the hole
/// has moved with it. The same after an interruption before, in and after the search.
TEST(PartOfCatalogueSlow, HolesComeBeforeCatalogues) {
  const std::vector<double> values = {0.09, 0.093, 0.096, 0.0975, 0.099};
  Study study = load_study(std::string(kDataDir) + "/studies/cantilever.toml",
                           {"bodies.plate.solid.mesh.cells=[60,30]"});
  const int body = study.spec.shapes.begin()->first;
  auto& variables = study.spec.shapes.at(body).variables;
  ASSERT_EQ(variables.size(), 1u);
  variables[0].values = values;
  variables[0].lower = values.front();
  variables[0].upper = values.back();
  int solved = 0;
  const OptimiseRound<PartEnd> optimise = [&](const StudySpec& spec, const Mechanism& m,
                                              const CycleHooks& cycle,
                                              const std::vector<Cycle>& cycles) {
    if (cycles.empty()) ++solved;
    return optimise_outline(spec, m, body, cycle, cycles);
  };
  RoundHistory rounds;
  TopologyHooks hooks;
  hooks.on_round_cycle = [&](const RoundHistory& so_far) { rounds = so_far; };
  const Mechanism& mechanism = study.scene.mechanism;
  const auto whole = optimise_study<PartEnd>(study.spec, mechanism, 1, optimise, hooks);
  ASSERT_TRUE(closed(whole.last.end.status)) << whole.last.end.reason;
  ASSERT_EQ(whole.holes.size(), 1u);
  EXPECT_TRUE(whole.holes[0].kept);
  ASSERT_TRUE(whole.catalogue);
  ASSERT_EQ(whole.last.end.x.size(), 5) << "height, and of the hole two places and two half-axes";
  EXPECT_EQ(std::count(values.begin(), values.end(), whole.last.end.x[0]), 1);
  EXPECT_EQ(whole.first.history.front().x.size(), 1);
  EXPECT_GE(whole.last.end.best->objective, whole.holes[0].after * (1 - 1e-6))
      << "no better than with any height";
  const int all = solved;
  ASSERT_EQ(rounds.size(), static_cast<std::size_t>(all));
  for (const std::size_t known : {std::size_t{1}, std::size_t{2}, rounds.size() - 1}) {
    solved = 0;
    const RoundHistory before(rounds.begin(), rounds.begin() + static_cast<long>(known));
    const auto resumed = optimise_study<PartEnd>(study.spec, mechanism, 1, optimise, {}, before);
    EXPECT_EQ(resumed.last.end.x, whole.last.end.x) << known;
    EXPECT_EQ(resumed.catalogue->designs, whole.catalogue->designs) << known;
    EXPECT_EQ(resumed.holes.size(), 1u) << known;
    EXPECT_EQ(solved, all - static_cast<int>(known));
  }
}

}  // namespace
}  // namespace liesl::test::catalogue_test
