/// @file
/// Load sets and sized designs of the formalisms beside each other.

#include <gtest/gtest.h>

#include <cmath>

#include "esl/load_set.hpp"
#include "optim/cycle/esl_cycle.hpp"
#include "reference/shipped.hpp"

namespace liesl {
namespace {

using test::Changes;

Changes with(Changes changes, Formalism f) {
  changes.push_back(std::string("simulation.formalism=\"") + to_string(f) + "\"");
  return changes;
}

LoadSet loads(const std::string& scene, const char* body, const Changes& changes) {
  const Scene s = test::shipped_scene(scene, changes);
  const test::Motion<SE2> motion(s.mechanism, s.simulation);
  EXPECT_TRUE(motion.good()) << motion.simulation.report.reason;
  return extract_loads(motion.model, motion.trajectory(), s.mechanism.body(body));
}

/// Relative difference of the loads of a body between a formalism and the Lie group one.
double off(const std::string& scene, const char* body, const Changes& changes, Formalism f) {
  const LoadSet lie = loads(scene, body, with(changes, Formalism::Lie));
  return load_change({loads(scene, body, with(changes, f))}, {lie}, 3, 2, 0.3);
}

Changes mesh(const std::vector<std::string>& bodies, int elements, double step) {
  Changes c;
  for (const auto& b : bodies)
    c.push_back("bodies." + b + ".beam.elements=" + std::to_string(elements));
  c.push_back("simulation.step=" + std::to_string(step));
  c.push_back("simulation.tolerance=1e-8");
  return c;
}

TEST(FormalismLoads, OfBothBeamsAgreeWithTheMesh) {
  for (const auto f : {Formalism::Decoupled, Formalism::Classical}) {
    const double robot = off("two_link_robot", "arm1", mesh({"arm1", "arm2"}, 8, 5e-4), f);
    EXPECT_LT(robot, 0.02) << to_string(f);
  }
  const std::vector<std::string> links{"crank", "rod"};
  const double coarse = off("slider_crank", "rod", mesh(links, 8, 5e-5), Formalism::Decoupled);
  const double fine = off("slider_crank", "rod", mesh(links, 16, 5e-5), Formalism::Decoupled);
  EXPECT_LT(coarse, 0.02);
  EXPECT_GT(std::log2(coarse / fine), 1);
}

/// Loads by a reference stiffness (classical, floating) know the deformation to first order only.
TEST(FormalismLoads, ByAReferenceStiffnessAgreeToFirstOrderInTheFlexibility) {
  for (const auto f : {Formalism::Classical, Formalism::Floating}) {
    const auto at = [&](const char* modulus) {
      Changes c = mesh({"crank", "rod"}, 8, 1e-4);
      c.push_back(std::string("materials.steel.E=") + modulus);
      return off("slider_crank", "rod", c, f);
    };
    const double soft = at("8.4e11"), stiff = at("3.36e12");
    EXPECT_LT(soft, 0.1) << to_string(f);
    EXPECT_GT(std::log2(soft / stiff) / 2, 0.6) << to_string(f);
  }
}

TEST(FormalismLoads, OfARigidBodyAreRefusedByName) {
  const Scene s = test::shipped_scene("slider_crank", with({}, Formalism::Rigid));
  const test::Motion<SE2> motion(s.mechanism, s.simulation);
  ASSERT_TRUE(motion.good());
  EXPECT_THROW(extract_loads(motion.model, motion.trajectory(), 1), std::invalid_argument);
}

TEST(FormalismLoads, SizeTheSameRod) {
  std::vector<double> masses;
  for (const auto f : {Formalism::Lie, Formalism::Decoupled, Formalism::Classical}) {
    const Study study =
        test::shipped_study("slider_crank_rod", with({"cycle.optimality=\"never\""}, f));
    const auto r = run_cycle<SE2>(study.scene.mechanism, test::space_of<SE2>(study.scene.mechanism),
                                  study.scene.simulation, study.spec, {}, {});
    EXPECT_EQ(r.status, CycleStatus::Converged) << to_string(f) << ": " << r.reason;
    masses.push_back(r.mass);
  }
  for (const double m : masses) EXPECT_NEAR(m, masses[0], 0.02 * masses[0]);
}

}  // namespace
}  // namespace liesl
