/// @file
/// The static problem of a cycle: its derivatives, its values at the analysed design, its
/// screening.
#include "optim/problems/beam_statics.hpp"

#include <gtest/gtest.h>

#include <map>

#include "apps/study/load_study.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/cycle/derivative_check.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "optim/nlp/ipopt_driver.hpp"
#include "optim/problems/esl_problem.hpp"
#include "reference/places.hpp"
#include "reference/shipped.hpp"
#include "reference/svanberg_beam.hpp"

namespace liesl::test::beam_statics_test {
namespace {

/// The scene with the design that the study starts from.
Study started(Study study) {
  const Sizing sizing(study.spec.design, study.scene.mechanism);
  Eigen::VectorXd x(sizing.size());
  for (int i = 0; i < x.size(); ++i) x[i] = sizing.variables()[i].start;
  sizing.apply(x, study.scene.mechanism);
  return study;
}

/// The first static problem of a study.
template <FrameGroup G>
struct First {
  Study study;
  Sizing sizing;
  Motion<G> motion;
  std::vector<LoadSet> loads;
  Analysis<G> analysis;
  Eigen::VectorXd x;

  explicit First(const std::string& name, const Changes& changes = {})
      : First(shipped_study(name, changes)) {}
  explicit First(const Study& s)
      : study(started(s)),
        sizing(study.spec.design, study.scene.mechanism),
        motion(study.scene.mechanism, study.scene.simulation),
        analysis{study.scene.mechanism, &motion.model, &motion.trajectory(), &loads},
        x(sizing.size()) {
    for (const int body : limited_bodies(study.spec))
      loads.push_back(extract_loads(motion.model, motion.trajectory(), body));
    for (int i = 0; i < x.size(); ++i) x[i] = sizing.variables()[i].start;
  }
  EslProblem problem(double move = 0.5) const {
    return EslProblem(std::make_unique<BeamStatics<G>>(analysis, sizing, study.spec, move),
                      study.spec.cycle, x);
  }
};

struct Case {
  const char* name;
  const char* study;
  bool spatial;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Derivatives : public testing::TestWithParam<Case> {};

TEST_P(Derivatives, AreRight) {
  const Study study = shipped_study(GetParam().study);
  const Mechanism& mechanism = study.scene.mechanism;
  const SimulationOptions& simulation = study.scene.simulation;
  const DerivativeReport report =
      GetParam().spatial ? check_study_derivatives<SE3>(mechanism, {}, simulation, study.spec)
                         : check_study_derivatives<SE2>(mechanism, space_of<SE2>(mechanism),
                                                        simulation, study.spec);
  EXPECT_GT(report.checks.size(), 10u);
  EXPECT_TRUE(report.right) << report.text(5);
}

/// Beams of fourth order: condensed stiffnesses with their first and second derivatives.
TEST(DerivativesOfFourthOrder, AreRight) {
  Study study = shipped_study("slider_crank_rod");
  for (BodySpec& body : study.scene.mechanism.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->order = 4;
  const Mechanism& mechanism = study.scene.mechanism;
  const DerivativeReport report = check_study_derivatives<SE2>(mechanism, space_of<SE2>(mechanism),
                                                               study.scene.simulation, study.spec);
  EXPECT_GT(report.checks.size(), 10u);
  EXPECT_TRUE(report.right) << report.text(5);
}

/// Crank and rod as tubes whose diameters are sized and whose walls get thinner.
Study with_tapers(Study study) {
  for (BodySpec& body : study.scene.mechanism.bodies) {
    auto* beam = std::get_if<BeamSpec>(&body.kind);
    if (!beam) continue;
    const auto n = static_cast<double>(beam->sections.size());
    for (std::size_t e = 0; e < beam->sections.size(); ++e) {
      const double d = dimension(beam->sections[e].shape, "diameter");
      const auto at = [&](double place) {
        return Section{"tube",
                       Tube{d, 0.15 * d * (1 - 0.5 * (static_cast<double>(e) + place) / n)}};
      };
      beam->sections[e] = at(0.5);
      beam->ends.push_back({at(0), at(1)});
    }
  }
  return study;
}

TEST(DerivativesOfTapers, AreRight) {
  const Study study = with_tapers(shipped_study("slider_crank_both"));
  const Mechanism& mechanism = study.scene.mechanism;
  const DerivativeReport report = check_study_derivatives<SE2>(mechanism, space_of<SE2>(mechanism),
                                                               study.scene.simulation, study.spec);
  EXPECT_GT(report.checks.size(), 10u);
  EXPECT_TRUE(report.right) << report.text(5);
}

INSTANTIATE_TEST_SUITE_P(BeamStatics, Derivatives,
                         testing::Values(Case{"Rod", "slider_crank_rod", false},
                                         Case{"RodInSpace", "slider_crank_rod", true},
                                         Case{"RodAndCrankWithStress", "slider_crank_both", false},
                                         Case{"Arms", "robot_arms", false},
                                         Case{"ArmsInSpace", "robot_arms", true}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Largest value of each constraint among the rows of the problem, and over the motion itself.
template <FrameGroup G>
void expect_exact_at_analysed_design(const Study& study) {
  const First<G> first(study);
  auto problem = first.problem();
  double f = 0;
  Eigen::VectorXd g(problem.constraints().size());
  problem.values(first.x, f, g);
  EXPECT_DOUBLE_EQ(f, mass_of(first.study.scene.mechanism, first.study.spec.mass_of));
  std::map<std::string, double> rows;
  for (int i = 0; i < g.size(); ++i) {
    const std::string& row = problem.constraints()[i].name;
    auto& value = rows.try_emplace(row.substr(0, row.find(" at t")), -1).first->second;
    value = std::max(value, g[i]);
  }
  const ResponseValues<G> values(first.study.scene.mechanism, first.motion.model);
  State<G> s = first.motion.model.initial_state();
  for (const auto& c : first.study.spec.constraints) {
    double largest = 0;
    for (int n = 0; n < first.motion.trajectory().size(); ++n) {
      first.motion.trajectory().read(n, s);
      largest = std::max(largest, values(c.response, s).norm());
    }
    ASSERT_EQ(rows.count(c.response.name), 1u);
    EXPECT_NEAR(rows[c.response.name], largest / c.limit - 1, 1e-12) << c.response.name;
  }
}

TEST(BeamStatics, IsExactAtTheAnalysedDesign) {
  expect_exact_at_analysed_design<SE2>(shipped_study("slider_crank_rod"));
  expect_exact_at_analysed_design<SE3>(shipped_study("slider_crank_rod"));
  expect_exact_at_analysed_design<SE2>(shipped_study("slider_crank_both"));
  expect_exact_at_analysed_design<SE2>(with_tapers(shipped_study("slider_crank_both")));
  expect_exact_at_analysed_design<SE3>(shipped_study("robot_arms"));
}

TEST(BeamStatics, ScreeningWithViolatorsAddedFindsTheOptimumOfAllCases) {
  const char* kThick =
      "design.arm1_walls.start=0.0035";  // within a move of what the limits ask for
  NlpOptions options;
  options.tolerance = options.feasibility = 1e-9;
  const First<SE2> few("robot_arms", {kThick, "cycle.screening=0", "cycle.min_cases=1"});
  auto screened = few.problem();
  const int kept_first = screened.load_cases();
  NlpResult answer = solve_ipopt(screened, options);
  int added = screened.add_violated(answer.x, 1e-9);
  EXPECT_GT(added, 0) << "nothing to test";
  for (int round = 0; added > 0 && round < 20; ++round) {
    answer = solve_ipopt(screened, options);
    added = screened.add_violated(answer.x, 1e-9);
  }
  EXPECT_EQ(added, 0);

  const First<SE2> every("robot_arms", {kThick, "cycle.screening=1", "cycle.min_cases=10"});
  auto all = every.problem();
  EXPECT_EQ(all.load_cases(), 2 * every.motion.trajectory().size());
  EXPECT_LT(kept_first, all.load_cases() / 10);
  const NlpResult reference = solve_ipopt(all, options);
  ASSERT_TRUE(reference.solved()) << reference.brief();
  EXPECT_NEAR(answer.f, reference.f, 1e-7 * reference.f);
  EXPECT_LT((answer.x - reference.x).norm(), 1e-5 * reference.x.norm());
  EXPECT_EQ(all.add_violated(reference.x, 1e-6), 0);
}

/// Gradients of the rows by constraint id.
template <FrameGroup G>
std::map<ConstraintId, Eigen::VectorXd> gradients(const First<G>& first, EslProblem& problem) {
  const auto m = static_cast<int>(problem.constraints().size());
  double f = 0;
  Eigen::VectorXd g(m), df(first.x.size());
  RowMatrix dg(m, first.x.size());
  problem.values(first.x, f, g);
  problem.gradients(first.x, df, dg);
  std::map<ConstraintId, Eigen::VectorXd> rows;
  for (int i = 0; i < m; ++i) rows[problem.constraints()[i].id] = dg.row(i);
  return rows;
}

TEST(BeamStatics, DirectAndAdjointFormsGiveTheSameGradients) {
  const First<SE2> few("slider_crank_both", {"cycle.screening=0", "cycle.min_cases=1"});
  const First<SE2> many("slider_crank_both", {"cycle.screening=0.5", "cycle.min_cases=20"});
  auto direct = few.problem(), adjoint = many.problem();
  const int outputs = 2 * 3 * 8;  // strains alone, for both ends of the elements
  const int variables = static_cast<int>(few.x.size());
  EXPECT_LT(direct.load_cases() * variables, outputs) << "not the direct form";
  EXPECT_GT(adjoint.load_cases() / 2 * variables, 2 * outputs) << "not the adjoint form";
  const auto by_adjoint = gradients(many, adjoint);
  const auto by_direct = gradients(few, direct);
  EXPECT_GE(by_direct.size(), 3u);
  for (const auto& [id, row] : by_direct) {
    ASSERT_EQ(by_adjoint.count(id), 1u);
    EXPECT_LT((row - by_adjoint.at(id)).norm(), 1e-9 * row.norm()) << id;
  }
}

/// A shipped scene's beam, sized under a limit on its compliance alone.
Study compliance_study(const std::string& scene, const std::string& design, const std::string& beam,
                       const std::string& limit) {
  return read_study("scene = \"" + scene + ".toml\"\n[design]\nx = { of = \"" + beam + "\", " +
                        design + " }\n[objective]\nof = [\"" + beam +
                        "\"]\n[constraints]\nenergy = { response = \"compliance\", of = \"" + beam +
                        "\", limit = " + limit + " }\n",
                    "compliance.toml", std::filesystem::path(kDataDir) / "scenes");
}

const char* kFourDiameters = "property = \"diameter\", groups = 4, bounds = [0.004, 0.020]";

TEST(Compliance, DerivativesAreRight) {
  const Study study = compliance_study("slider_crank", kFourDiameters, "rod", "1");
  const Mechanism& mechanism = study.scene.mechanism;
  const auto report = check_study_derivatives<SE2>(mechanism, space_of<SE2>(mechanism),
                                                   study.scene.simulation, study.spec);
  EXPECT_GT(report.checks.size(), 10u);
  EXPECT_TRUE(report.right) << report.text(5);
}

TEST(Compliance, IsTwiceTheElasticEnergyOfTheMotion) {
  const First<SE2> first(compliance_study("slider_crank", kFourDiameters, "rod", "1"));
  const ResponseValues<SE2> values(first.study.scene.mechanism, first.motion.model);
  State<SE2> s = first.motion.model.initial_state();
  for (int n = 0; n < first.motion.trajectory().size(); n += 50) {
    first.motion.trajectory().read(n, s);
    const BodyEnergy energy = first.motion.model.bodies[1]->energy(
        first.motion.model.body_state(s, 1), first.motion.model.gravity);
    EXPECT_DOUBLE_EQ(values(first.study.spec.constraints[0].response, s)[0], 2 * energy.elastic);
  }
}

TEST(Compliance, AsALimitGivesThePublishedOptimumOfTheTipDeflection) {
  // One load: compliance = 0.042 N times the tip deflection, at most 5 mm.
  const Study study = compliance_study(
      "svanberg_cantilever",
      "property = [\"width\", \"height\"], groups = 5, bounds = [0.01, 0.10]", "beam", "2.1e-4");
  const auto r = run_cycle<SE2>(study.scene.mechanism, space_of<SE2>(study.scene.mechanism),
                                study.scene.simulation, study.spec);
  ASSERT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_LT(std::abs(r.worst), 1e-4) << "the limit is not used";
  EXPECT_NEAR(r.mass, SvanbergBeam::optimum, 1e-4 * SvanbergBeam::optimum);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR((r.x[i] - 2e-5) / 0.01, SvanbergBeam::solution[i],
                1e-3 * SvanbergBeam::solution[i]);
}

TEST(BeamStatics, BoundsAreThoseOfTheMoveLimit) {
  const First<SE2> first("slider_crank_rod");
  const auto narrow = first.problem(0.1), wide = first.problem(10);
  EXPECT_DOUBLE_EQ(narrow.variables()[0].lower, 0.9 * first.x[0]);
  EXPECT_DOUBLE_EQ(narrow.variables()[0].upper, 1.1 * first.x[0]);
  EXPECT_EQ(wide.variables()[0].lower, 0.004);
  EXPECT_EQ(wide.variables()[0].upper, 0.020);
}

}  // namespace
}  // namespace liesl::test::beam_statics_test
