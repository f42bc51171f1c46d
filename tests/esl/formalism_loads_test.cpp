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

/// Loads of a body, and the deformation they cause in the linear part with its first node held.
struct Extracted {
  LoadSet loads;
  Eigen::MatrixXd deformation;  ///< degrees of freedom x steps; rotations times the length
};

constexpr double kLength = 0.3;  // m, that rotations and moments are compared with

Extracted extract(const std::string& scene, const char* body, const Changes& changes) {
  const Scene s = test::shipped_scene(scene, changes);
  const test::Motion<SE2> motion(s.mechanism, s.simulation);
  EXPECT_TRUE(motion.good()) << motion.simulation.report.reason;
  const int index = s.mechanism.body(body);
  Extracted out{extract_loads(motion.model, motion.trajectory(), index), {}};
  Mechanism linear = s.mechanism;
  linear.formalism = Formalism::Lie;
  const auto model = Model<SE2>::build(linear, test::space_of<SE2>(linear));
  const auto& K = model.bodies[index]->stiffness();
  Eigen::MatrixXd free = Eigen::MatrixXd::Zero(K.size(), K.size());
  for (int k = 0; k < K.size(); ++k)
    K.multiply_add(Eigen::VectorXd::Unit(K.size(), k).eval().data(), free.col(k).data());
  const auto n = K.size() - 3;
  out.deformation = free.bottomRightCorner(n, n).ldlt().solve(out.loads.f.bottomRows(n));
  for (int k = 2; k < n; k += 3) out.deformation.row(k) *= kLength;
  return out;
}

/// How far a formalism is from the Lie group one: in the loads, and in the deformation they cause.
struct Off {
  double loads, deformation;
};

Off off(const std::string& scene, const char* body, const Changes& changes, Formalism f) {
  const Extracted lie = extract(scene, body, with(changes, Formalism::Lie));
  const Extracted other = extract(scene, body, with(changes, f));
  return {load_change({other.loads}, {lie.loads}, 3, 2, kLength),
          (other.deformation - lie.deformation).norm() / lie.deformation.norm()};
}

Changes mesh(const std::vector<std::string>& bodies, int elements, double step) {
  Changes c;
  for (const auto& b : bodies)
    c.push_back("bodies." + b + ".beam.elements=" + std::to_string(elements));
  c.push_back("simulation.step=" + std::to_string(step));
  c.push_back("simulation.tolerance=1e-8");
  return c;
}

Off robot(Formalism f, int elements) {
  return off("two_link_robot", "arm1", mesh({"arm1", "arm2"}, elements, 5e-4), f);
}

Off slider_crank(Formalism f, int elements) {
  return off("slider_crank", "rod", mesh({"crank", "rod"}, elements, 5e-5), f);
}

TEST(FormalismLoads, OfBothBeamsAgreeWithTheMesh) {
  for (const auto& scene : {robot, slider_crank}) {
    const Off coarse = scene(Formalism::Decoupled, 8), fine = scene(Formalism::Decoupled, 16);
    EXPECT_LT(coarse.loads, 0.01);
    EXPECT_GT(std::log2(coarse.loads / fine.loads), 1);
    EXPECT_GT(std::log2(coarse.deformation / fine.deformation), 1.7);
  }
}

TEST(FormalismLoads, CauseTheSameDeformation) {
  for (const auto f : {Formalism::Decoupled, Formalism::Classical, Formalism::Floating})
    EXPECT_LT(robot(f, 8).deformation, 2e-3) << to_string(f);
}

/// Loads by a reference stiffness know the deformation to first order only: classical ones hold
/// the axial force EA w'^2 / 2 that the bent axis, not shortened, would need.
TEST(FormalismLoads, ByAReferenceStiffnessAgreeToFirstOrderInTheFlexibility) {
  for (const auto f : {Formalism::Classical, Formalism::Floating}) {
    const auto at = [&](const char* modulus) {
      Changes c = mesh({"crank", "rod"}, 8, 1e-4);
      c.push_back(std::string("materials.steel.E=") + modulus);
      return off("slider_crank", "rod", c, f).loads;
    };
    EXPECT_NEAR(std::log2(at("8.4e11") / at("3.36e12")) / 2, 1, 0.1) << to_string(f);
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
