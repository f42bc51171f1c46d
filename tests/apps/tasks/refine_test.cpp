/// @file
/// What a study goes on with where its limits are not certain, and that it ends where they are.

#include "apps/tasks/refine.hpp"

#include <gtest/gtest.h>

#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "apps/tasks/final_scene.hpp"
#include "apps/tasks/optimize_verified.hpp"
#include "apps/tasks/run.hpp"

namespace liesl::test::refine_test {
namespace {

using Changes = std::vector<std::string>;

ReadStudy reader(const char* name, const Changes& given = {}) {
  return [name, given](const Changes& more) {
    Changes all = given;
    all.insert(all.end(), more.begin(), more.end());
    return load_study(study(name), all);
  };
}

FinerModel finer(const Changes& given, const VerifiedLimit& limit) {
  const ReadStudy read = reader("slider_crank_rod", given);
  return finer_model(read({}), {limit}, 1e-3, {}, read);
}

const Changes kOrder2 = {"bodies.crank.beam.order=2", "bodies.rod.beam.order=2"};
const Changes kOrder4 = {"bodies.crank.beam.order=4", "bodies.rod.beam.order=4"};

TEST(FinerModel, BeamsTakeOrderFourFirst) {
  const FinerModel m = finer(kOrder2, {"bending", 0, 2e-2, 1e-5});
  EXPECT_EQ(m.changes, kOrder4);
  EXPECT_FALSE(m.mesh || m.step) << "an order is no finer mesh";
  EXPECT_TRUE(finer({}, {"bending", 0, 2e-2, 1e-5}).mesh) << "they are of order 4 by themselves";
}

/// Of meshed parts a study keeps the cells.
TEST(FinerModel, BeamsBesidePartsTakeOrderFour) {
  const Changes order4 = {"bodies.crank.beam.order=4"};
  const auto refined = [](const Changes& given) {
    const ReadStudy read = reader("four_bar_mixed", given);
    return finer_model(read({}), {{"crank_bend", 0, 2e-2, 1e-5}}, 1e-3, {}, read);
  };
  EXPECT_EQ(refined({}).changes, order4);
  EXPECT_EQ(refined({}).exhausted, "");
  EXPECT_EQ(refined(order4).changes, Changes());
  EXPECT_NE(refined(order4).exhausted.find("does not refine the cells of parts coupler, rocker"),
            std::string::npos);
}

/// 16 times too large is a factor of two of order 4; of what is observed as order 2, of four.
TEST(FinerModel, ElementsAndStepsFollowErrorAndOrder) {
  const FinerModel fourth = finer(kOrder4, {"bending", 0, 15.9 * 2.5e-4, 0, 4});
  EXPECT_EQ(fourth.changes,
            (Changes{"bodies.crank.beam.elements=16", "bodies.rod.beam.elements=16"}));
  EXPECT_TRUE(fourth.mesh);
  const FinerModel second = finer(kOrder4, {"bending", 0, 15.9 * 2.5e-4, 0, 2});
  EXPECT_EQ(second.changes,
            (Changes{"bodies.crank.beam.elements=32", "bodies.rod.beam.elements=32"}));
  const FinerModel step = finer(kOrder4, {"bending", 5e-4, 0, 3.9 * 2.5e-4});
  EXPECT_EQ(step.changes, (Changes{"simulation.step=5e-05", "simulation.output_every=2"}))
      << "as many records";
  EXPECT_TRUE(step.step);
  const FinerModel stalled = finer(kOrder4, {"bending", 0, 0, 15.9 * 2.5e-4, {}, -1.8});
  EXPECT_EQ(stalled.changes, (Changes{"simulation.step=2.5e-05", "simulation.output_every=4"}))
      << "as if none were observed";
}

TEST(FinerModel, LimitsThatAreCertainAskForNothing) {
  EXPECT_TRUE(finer({}, {"bending", -0.1, 2e-2, 1e-2}).changes.empty());
}

TEST(FinerModel, WithoutRoomItIsSaid) {
  Changes full = kOrder4;
  for (const char* beam : {"crank", "rod"})
    full.push_back(std::string("bodies.") + beam + ".beam.elements=6000");
  const FinerModel m = finer(full, {"bending", 0, 1e-2, 0});
  EXPECT_TRUE(m.changes.empty());
  EXPECT_NE(m.exhausted.find("no room for twice its 6000 elements, 10000 is the most"),
            std::string::npos)
      << m.exhausted;
}

/// Rounding, and a quarter of an error that falls by steps squared from 1200 to 1e5.
TEST(FinerModel, WhatNoRefinementReachesIsSaid) {
  const ReadStudy read = reader("slider_crank_rod", kOrder4);
  const auto exhausted = [&](const VerifiedLimit& limit, double feasibility) {
    return finer_model(read({}), {limit}, feasibility, {}, read).exhausted;
  };
  const VerifiedLimit coarse = {"bending", 0, 1e-5, 7.4e-4};
  const std::string rounding = exhausted(coarse, 1e-9), steps = exhausted(coarse, 1e-8),
                    elements = exhausted({"bending", 0, 1e9, 0}, 1e-3);
  EXPECT_NE(rounding.find("are rounding; cycle.feasibility = 5e-07 is within reach"), rounding.npos)
      << rounding;
  EXPECT_NE(steps.find("5.4e+02 times as many steps, of which 100000 are the most; "
                       "cycle.feasibility = 5e-07 is within reach"),
            steps.npos)
      << steps;
  EXPECT_EQ(exhausted(coarse, 5e-7), "");
  EXPECT_NE(exhausted({"bending", 0, 0, 1e-8}, 1e-9).find("feasibility = 4e-09"), steps.npos);
  EXPECT_NE(elements.find("elements, of which 10000 are the most"), elements.npos) << elements;
}

/// A limit stays where it is, named by the numbers of the mesh of the scene.
TEST(FinerModel, NodesNamedByNumberStay) {
  Changes given = kOrder4;
  given.push_back("constraints.bending.at=node3");
  const VerifiedLimit limit = {"bending", 0, 15.9 * 2.5e-4, 0, 4};
  const FinerModel m = finer(given, limit);
  EXPECT_EQ(m.changes, (Changes{"bodies.crank.beam.elements=16", "bodies.rod.beam.elements=16",
                                "bodies.rod.beam.numbering=8"}));
  const auto place = [](const Study& s) { return s.spec.constraints.front().response.s; };
  const ReadStudy read = reader("slider_crank_rod", given);
  EXPECT_EQ(place(read(m.changes)), place(read({})));
  const FinerModel next = finer_model(read(m.changes), {limit}, 1e-3, m.changes, read);
  EXPECT_EQ(next.changes,
            (Changes{"bodies.crank.beam.elements=32", "bodies.rod.beam.elements=32"}));
}

/// A support, too.
TEST(FinerModel, SupportsNamedByNumberStay) {
  Changes given = kOrder4;
  given.push_back("supports.rod=[\"node1:xyz,rx\",\"end:yz\"]");
  const VerifiedLimit limit = {"bending", 0, 15.9 * 2.5e-4, 0, 4};
  const FinerModel m = finer(given, limit);
  const ReadStudy read = reader("slider_crank_rod", given);
  const Study finer_study = read(m.changes);
  const auto& held = finer_study.spec.supports.at(finer_study.scene.mechanism.body("rod"));
  EXPECT_EQ(held, (std::vector<std::string>{"node2:xyz,rx", "end:yz"}));
}

/// What is certain already asks for no room; and order 4 is tried before elements are counted.
TEST(FinerModel, WithMoreStepsThanThereIsRoomForTheMeshIsRefined) {
  Changes given = kOrder4;
  given.push_back("simulation.step=1e-6");
  const VerifiedLimit limit = {"bending", 0, 8.7e-5, 1.3e-8, 4};
  EXPECT_EQ(finer_model(reader("slider_crank_rod", given)({}), {limit}, 6.4e-8, given,
                        reader("slider_crank_rod", given))
                .exhausted,
            "");
  const FinerModel by_order =
      finer_model(reader("slider_crank_rod", kOrder2)({}), {{"bending", 0, 1e9, 0}}, 1e-3, kOrder2,
                  reader("slider_crank_rod", kOrder2));
  EXPECT_EQ(by_order.exhausted, "");
}

TEST(FinerModel, AScenarioWithAStepOfItsOwnIsNamed) {
  const ReadStudy read =
      reader("rod_three_speeds", {"scenarios.rated.set={\"simulation.step\"=1e-4}"});
  const FinerModel m = finer_model(read({}), {{"bending (rated)", 0, 0, 1e-2}}, 1e-3, {}, read);
  EXPECT_NE(m.exhausted.find("sets simulation.step itself"), std::string::npos) << m.exhausted;
}

/// Of what the mechanism has, and once: a note that has the same figures is enough.
TEST(WarnOfErrors, AdviceFitsTheBodiesAndIsGivenOnce) {
  const std::vector<VerifiedLimit> limits = {{"sag", 0, 2e-2, 0}};
  const auto warned = [&](const char* name, const Changes& given,
                          std::vector<std::string> notes = {}) {
    warn_of_errors(limits, 1e-3, reader(name, given)({}).scene.mechanism, "", notes);
    return notes;
  };
  const std::string text = limits[0].text();
  EXPECT_EQ(warned("cantilever", {}), Changes{text + "; more cells make it certain"});
  EXPECT_EQ(warned("slider_crank_rod", kOrder2),
            Changes{text + "; beams of order = 4, or more elements, make it certain"});
  EXPECT_EQ(warned("slider_crank_rod", kOrder4), Changes{text + "; more elements make it certain"});
  const Changes told = {"not certain on the converged model: " + text + ", and more"};
  EXPECT_EQ(warned("cantilever", {}, told), told);
}

TEST(NotConverging, IsSaidWithTheOrderObserved) {
  FinerModel refined;
  refined.mesh = true;
  const std::vector<VerifiedLimit> before = {{"stress", 0, 2e-2, 0}};
  const std::string text = not_converging(before, {{"stress", 0, 1.9e-2, 0, 0.1}}, refined, 1e-3);
  EXPECT_NE(text.find("limit stress does not converge: its error by the mesh is 1.9 %"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("order 0.1 observed; cycle.feasibility = 0.08 is within reach"),
            std::string::npos)
      << text;
  EXPECT_EQ(not_converging(before, {{"stress", 0, 5e-3, 0}}, refined, 1e-3), "");
  EXPECT_EQ(not_converging(before, {{"stress", 0, 1.9e-2, 0}}, {}, 1e-3), "")
      << "the mesh was not refined";
}

/// The rod on finer models until it is certain.
class RefinedRod : public testing::Test {
 protected:
  const ReadStudy read_ = reader("slider_crank_rod", {"cycle.refine=auto", kOrder2[0], kOrder2[1]});
  const Study study_ = read_({});
  const ChosenSpace space_ = choose_space(study_.scene);
  ModelHistory cycles_ = {{}};
  bool stop_ = false;

  VerifiedOptimum run(const ModelHistory& resume = {}, int cycles_of_second_model = 1000) {
    std::size_t model = 0;
    OptimizeHooks hooks;
    hooks.keep_going = [this] { return !stop_; };
    hooks.on_cycle = [&](const output::OptimizeSummary&, const RoundHistory& rounds) {
      cycles_.resize(std::max(cycles_.size(), model + 1));
      cycles_[model] = rounds;
      stop_ = model > 0 && static_cast<int>(rounds.back().size()) >= cycles_of_second_model;
    };
    VerifiedOptions options;
    options.read = read_;
    options.on_refinement = [&](const std::string&) { ++model; };
    return optimize_verified(study_, space_, {}, hooks, options, resume);
  }
};

/// With 32 elements of order 4 and a quarter of the step the limit holds; on the mesh of the scene
/// alone the rod bends 1.8 % more than it allows.
TEST_F(RefinedRod, HoldsOnTheConvergedModel) {
  const VerifiedOptimum end = run();
  const auto& more = end.out.summary.more;
  ASSERT_TRUE(more.contains("refinement"));
  EXPECT_TRUE(more["refinement"]["holds"].get<bool>()) << more["refinement"].dump(1);
  EXPECT_LE(end.out.summary.worst_constraint + more["worst_constraint_error"].get<double>(), 1e-3);
  EXPECT_EQ(more["refinement"]["steps"][0]["changes"], kOrder4);
  EXPECT_EQ(end.out.summary.constraints.front().max_abs_initial,
            optimize_task(study_, space_, {}, 0, {}).summary.constraints.front().max_abs_initial);

  Scene fine = read_scene(
      final_scene(end.out, end.study), "design.toml",
      {"bodies.crank.beam.elements=32", "bodies.rod.beam.elements=32", "simulation.step=2.5e-5"});
  fine.responses = {study_.spec.constraints.front().response};
  const RunOutcome converged = run_task(fine, choose_space(fine));
  ASSERT_EQ(converged.status, SolveStatus::Converged);
  EXPECT_LE(converged.summary.responses.front().max_abs,
            study_.spec.constraints.front().limit * (1 + 1e-3));
}

/// Stopped on the second model and resumed, it ends with the same digits.
TEST_F(RefinedRod, ResumesOnTheModelWhereItWasStopped) {
  const VerifiedOptimum whole = run();
  ASSERT_GE(cycles_.size(), 2u);
  cycles_ = {{}};
  const VerifiedOptimum stopped = run({}, 1);
  EXPECT_EQ(stopped.out.status, CycleStatus::Interrupted);
  const ModelHistory so_far = cycles_;
  ASSERT_EQ(so_far.size(), 2u);
  stop_ = false;
  const VerifiedOptimum resumed = run(so_far);
  ASSERT_EQ(resumed.out.summary.design.size(), whole.out.summary.design.size());
  for (std::size_t j = 0; j < whole.out.summary.design.size(); ++j)
    EXPECT_EQ(resumed.out.summary.design[j].final, whole.out.summary.design[j].final);
  EXPECT_EQ(resumed.out.summary.history.size(), whole.out.summary.history.size());
}

}  // namespace
}  // namespace liesl::test::refine_test
