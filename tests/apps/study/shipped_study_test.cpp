/// @file
/// Shipped studies as they are read: those that tests of the libraries build by themselves, what
/// the library says of them, gradients of their motions.
#include <gtest/gtest.h>

#include "optim/cycle/motion_cycle.hpp"
#include "optim/problems/motion_problem.hpp"
#include "optim/study/study_errors.hpp"
#include "reference/shipped.hpp"
#include "reference/studies.hpp"

namespace liesl::test::shipped_study_test {
namespace {

using Eigen::VectorXd;

void expect_same(const CycleOptions& read, const CycleOptions& built) {
  EXPECT_EQ(read.method, built.method);
  EXPECT_EQ(read.approximation, built.approximation);
  EXPECT_EQ(read.max, built.max);
  EXPECT_EQ(read.tolerance, built.tolerance);
  EXPECT_EQ(read.objective_tolerance, built.objective_tolerance);
  EXPECT_EQ(read.feasibility, built.feasibility);
  EXPECT_EQ(read.move_limit, built.move_limit);
  EXPECT_EQ(read.screening, built.screening);
  EXPECT_EQ(read.min_cases, built.min_cases);
  EXPECT_EQ(read.restarts, built.restarts);
  EXPECT_EQ(read.continuation, built.continuation);
  EXPECT_EQ(read.optimizer, built.optimizer);
  EXPECT_EQ(read.model, built.model);
  EXPECT_EQ(read.optimality, built.optimality);
}

void expect_same(const ConstraintSpec& read, const ConstraintSpec& built) {
  EXPECT_EQ(read.response.name, built.response.name);
  EXPECT_EQ(read.response.kind, built.response.kind);
  EXPECT_EQ(read.limit, built.limit);
  EXPECT_EQ(read.has_image, built.has_image);
  EXPECT_EQ(read.treatment, built.treatment);
}

/// The same variables, and the same motion to the last bit.
void expect_same(const Study& read, const StudyCase& built) {
  SCOPED_TRACE(read.file);
  expect_same(read.spec.cycle, built.spec.cycle);
  EXPECT_EQ(read.spec.supports, built.spec.supports);
  ASSERT_EQ(read.spec.constraints.size(), built.spec.constraints.size());
  for (std::size_t c = 0; c < read.spec.constraints.size(); ++c)
    expect_same(read.spec.constraints[c], built.spec.constraints[c]);
  const auto& of = read.scene.mechanism;
  const Space<SE2> space = space_of<SE2>(of), same = space_of<SE2>(built.scene.mechanism);
  const DesignSimulator<SE2> file(of, space, read.scene.simulation, read.spec),
      api(built.scene.mechanism, same, built.scene.simulation, built.spec);
  const auto &variables = file.design().variables(), &others = api.design().variables();
  ASSERT_EQ(variables.size(), others.size());
  for (std::size_t i = 0; i < variables.size(); ++i) {
    EXPECT_EQ(variables[i].name, others[i].name);
    EXPECT_EQ(variables[i].lower, others[i].lower);
    EXPECT_EQ(variables[i].upper, others[i].upper);
    EXPECT_EQ(variables[i].start, others[i].start);
  }
  const VectorXd x = file.design().start();
  const auto a = file.run(x), b = api.run(x);
  ASSERT_TRUE(a.good() && b.good()) << a.reason() << b.reason();
  EXPECT_EQ(a.mass, b.mass);
  ASSERT_EQ(a.limits.size(), b.limits.size());
  for (std::size_t l = 0; l < a.limits.size(); ++l)
    EXPECT_EQ(a.limits[l].values, b.limits[l].values);
}

/// Those have beams of order 2, and the rod another start.
TEST(ShippedStudy, IsThatOfTheLibraryTests) {
  const auto of_order_2 = [](const std::vector<const char*>& beams) {
    Changes changes;
    for (const char* beam : beams)
      changes.push_back(std::string("bodies.") + beam + ".beam.order=2");
    return changes;
  };
  Changes rod = of_order_2({"crank", "rod"});
  rod.push_back("design.rod_diameters.start=0.01138");
  expect_same(shipped_study("slider_crank_rod", rod), slider_crank_rod());
  expect_same(shipped_study("svanberg_cantilever", of_order_2({"beam"})), svanberg_cantilever());
  expect_same(stability_study("esl_oscillates", of_order_2({"spring"})), esl_oscillates());
  expect_same(stability_study("esl_non_optimal",
                              of_order_2({"spring1", "spring2", "ballast1", "ballast2"})),
              esl_non_optimal());
}

TEST(ShippedStudy, HasNoErrors) {
  for (const char* name : {"slider_crank_rod", "slider_crank_both", "connecting_rod",
                           "four_bar_mixed", "cantilever_holes", "plate_with_hole"}) {
    const Study study = shipped_study(name);
    EXPECT_TRUE(study_errors(study.spec, study.scene.mechanism).empty()) << name;
  }
}

TEST(ShippedStudy, HasSidesAndFrequenciesReadIntoIt) {
  const Study side = shipped_study("slider_crank_rod", {"constraints.bending.side=\"up\""});
  EXPECT_EQ(side.spec.constraints[0].response.side, Side::Up);
  EXPECT_FALSE(side.spec.constraints[0].has_image);
  const auto frequencies =
      shipped_study("slider_crank_rod", {"frequencies.stiff={least=150, count=2, at=0.01}"})
          .spec.frequencies;
  ASSERT_EQ(frequencies.size(), 1u);
  EXPECT_EQ(frequencies[0].least, 150);
  EXPECT_EQ(frequencies[0].count, 2);
  EXPECT_EQ(frequencies[0].at, 0.01);
  EXPECT_THROW(shipped_study("connecting_rod", {"frequencies.stiff={least=150}"}), InputError);
}

TEST(ShippedStudy, RefusesTreatmentsThatItsMethodOrRangeHasNot) {
  const auto read = [](const Changes& changes) { shipped_study("slider_crank_rod", changes); };
  EXPECT_THROW(read({"cycle.method=esl", "constraints.bending.treatment=ks"}), InputError);
  EXPECT_NO_THROW(read({"cycle.method=esl", "constraints.bending.treatment=maxima"}));
  EXPECT_THROW(shipped_study("cantilever", {"constraints.sag.treatment=maxima"}), InputError);
  EXPECT_THROW(read({"constraints.bending.treatment=best"}), InputError);
  EXPECT_THROW(read({"constraints.bending.treatment=p_norm", "constraints.bending.p=0.5"}),
               InputError);
}

TEST(ShippedStudy, HasConstantsAndSections) {
  const auto design = [](const std::string& text) {
    return shipped_study("slider_crank_rod",
                         {"design.payload={" + text + "}", "objective.of=[\"rod\", \"slider\"]"});
  };
  const Study study = design("of=\"slider\", property=\"mass\", bounds=[0.1, 0.3]");
  ASSERT_EQ(study.spec.constants.size(), 1u);
  EXPECT_EQ(study.spec.constants[0].body, study.scene.mechanism.body("slider"));
  EXPECT_FALSE(study.spec.constants[0].start);
  EXPECT_THROW(design("of=\"slider\", property=\"mass\", bounds=[0.3, 0.4]"), std::exception);
  EXPECT_THROW(design("of=\"slider\", property=\"mass\", bounds=[-1, 0.4]"), std::exception);
  EXPECT_THROW(design("of=\"slider\", property=\"mas\", bounds=[0.1, 0.4]"), std::exception);
}

/// A study whose designs can be simulated; sensitivities need converged states.
struct Simulated {
  explicit Simulated(Study s) : study(std::move(s)) {
    study.spec.cycle.method = CycleMethod::Esl1;
    simulator.emplace(study.scene.mechanism, space, study.scene.simulation, study.spec);
  }
  Study study;
  Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  std::optional<DesignSimulator<SE2>> simulator;
};

/// Largest value of each limit of other kinds: tips of arms by walls, stress by diameters of
/// another body, the elongation of a meshed part by its outline.
TEST(ShippedMotionGradients, AreThoseOfDifferences) {
  struct Case {
    const char* study;
    double step;       ///< of a variable
    double tolerance;  ///< of the gradient's length
  };
  // The fractions of a meshed part have kinks, which differences step over.
  for (const Case& c : {Case{"robot_arms", 2e-4, 1e-4},
                        {"slider_crank_both", 2e-4, 1e-4},
                        {"connecting_rod", 1e-3, 0.05}}) {
    Simulated s(shipped_study(c.study, {"simulation.tolerance=1e-10"}));
    const VectorXd x = s.simulator->design().start(), unit = s.simulator->design().unit(x);
    const auto run = s.simulator->run(x);
    const auto statics = motion_problem(s.study.spec, *s.simulator, run, x, 0.5);
    const MotionGradients motion(s.simulator->design(), run, x, statics->responses());
    ASSERT_TRUE(motion.reason().empty()) << motion.reason();
    const auto limits = s.study.spec.constraints.size();
    std::vector<std::pair<int, int>> peak(limits, {-1, 0});  // response, record
    for (std::size_t r = 0; r < std::size_t(motion.responses()); ++r)
      for (int n = 0; n < motion.records(0); ++n) {
        auto& [response, record] = peak[motion.response(int(r)).constraint];
        const int number = static_cast<int>(r);
        if (response < 0 || motion.value(number, n) > motion.value(response, record)) {
          response = number;
          record = n;
        }
      }
    for (int j = 0; j < x.size(); ++j) {
      const double h = c.step * (unit.size() > 0 ? unit[j] : x[j]);
      VectorXd up = x, down = x;
      up[j] += h;
      down[j] -= h;
      const auto above = s.simulator->run(up), below = s.simulator->run(down);
      for (std::size_t l = 0; l < limits; ++l) {
        const auto [response, record] = peak[l];
        const VectorXd* dv = motion.gradient(response, record);
        ASSERT_TRUE(dv);
        const double d =
            (above.limits[l].values[record] - below.limits[l].values[record]) / (2 * h);
        const double scale = unit.size() > 0 ? dv->cwiseProduct(unit).norm() / unit[j] : dv->norm();
        EXPECT_NEAR((*dv)[j], d, c.tolerance * scale) << c.study << " " << l << " " << j;
      }
    }
  }
}

}  // namespace
}  // namespace liesl::test::shipped_study_test
