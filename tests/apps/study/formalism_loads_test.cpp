/// @file
/// Load sets and sized designs of the formalisms beside each other.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "esl/load_set.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::formalism_loads_test {
namespace {

Changes with(Changes changes, Formalism f) {
  changes.push_back(std::string("simulation.formalism=\"") + to_string(f) + "\"");
  return changes;
}

/// Formalisms are compared with elements of one order.
Changes of_order_2(Changes changes, const std::vector<std::string>& bodies) {
  for (const auto& b : bodies) changes.push_back("bodies." + b + ".beam.order=2");
  return changes;
}

Changes with_no_check(Changes changes) {
  changes.insert(changes.end(), {"cycle.optimality=\"never\"", "cycle.method=\"esl\""});
  return changes;
}

/// Loads of a body, and the deformation they cause in the linear part with its first node held.
struct Extracted {
  LoadSet loads;
  Eigen::MatrixXd deformation;  ///< degrees of freedom x steps; rotations times the length
};

constexpr double kLength = 0.3;  // m, that rotations and moments are compared with

Extracted extract(const std::string& scene, const char* body, const Changes& changes) {
  const Scene s = shipped_scene(scene, changes);
  const Motion<SE2> motion(s.mechanism, s.simulation);
  EXPECT_TRUE(motion.good()) << motion.simulation.report.reason;
  const int index = s.mechanism.body(body);
  Extracted out{extract_loads(motion.model, motion.trajectory(), index), {}};
  Mechanism linear = s.mechanism;
  linear.formalism = Formalism::SE3;
  const auto model = Model<SE2>::build(linear, space_of<SE2>(linear));
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
  const Extracted lie = extract(scene, body, with(changes, Formalism::SE3));
  const Extracted other = extract(scene, body, with(changes, f));
  return {load_change({other.loads}, {lie.loads}, 3, 2, kLength),
          (other.deformation - lie.deformation).norm() / lie.deformation.norm()};
}

Changes mesh(const std::vector<std::string>& bodies, int elements, double step) {
  Changes c = of_order_2({}, bodies);
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

/// Figures of docs/accuracy_and_speed.md, by --gtest_output=xml.
void record(const char* scene, Formalism f, int elements, const Off& off) {
  const std::string name = fmt::format("{}_{}_{}", scene, to_string(f), elements);
  testing::Test::RecordProperty(name + "_loads", fmt::format("{:.3g}", off.loads));
  testing::Test::RecordProperty(name + "_deformation", fmt::format("{:.3g}", off.deformation));
}

TEST(FormalismLoads, OfTheBeamsAgreeWithTheMesh) {
  for (const auto f : {Formalism::R3SO3, Formalism::Classical})
    for (const auto& [name, scene] :
         {std::pair{"two_link_robot", &robot}, std::pair{"slider_crank", &slider_crank}}) {
      SCOPED_TRACE(std::string(name) + " " + to_string(f));
      const Off coarse = scene(f, 8), fine = scene(f, 16);
      record(name, f, 8, coarse);
      record(name, f, 16, fine);
      EXPECT_LT(coarse.loads, 0.01);
      EXPECT_GT(std::log2(coarse.loads / fine.loads), 1);
      EXPECT_GT(std::log2(coarse.deformation / fine.deformation), 1.7);
    }
}

TEST(FormalismLoads, CauseTheSameDeformation) {
  for (const auto f : {Formalism::R3SO3, Formalism::Classical, Formalism::Floating})
    EXPECT_LT(robot(f, 8).deformation, 2e-3) << to_string(f);
}

/// A linear part knows the deformation to first order only: what is left between its loads and the
/// others does not fall with the mesh, but with the flexibility.
TEST(FormalismLoads, OfTheFloatingFrameAgreeToFirstOrderInTheFlexibility) {
  for (const auto& [name, scene] :
       {std::pair{"two_link_robot", &robot}, std::pair{"slider_crank", &slider_crank}}) {
    const Off off = scene(Formalism::Floating, 8);
    record(name, Formalism::Floating, 8, off);
    EXPECT_LT(off.loads, 0.02) << name;
    EXPECT_LT(off.deformation, 0.06) << name;
  }
  const auto at = [&](const char* modulus) {
    Changes c = mesh({"crank", "rod"}, 8, 1e-4);
    c.push_back(std::string("materials.steel.E=") + modulus);
    return off("slider_crank", "rod", c, Formalism::Floating).loads;
  };
  EXPECT_NEAR(std::log2(at("8.4e11") / at("3.36e12")) / 2, 1, 0.1);
}

TEST(FormalismLoads, OfARigidBodyAreRefusedByName) {
  const Scene s = shipped_scene("slider_crank", with({}, Formalism::Rigid));
  const Motion<SE2> motion(s.mechanism, s.simulation);
  ASSERT_TRUE(motion.good());
  EXPECT_THROW(extract_loads(motion.model, motion.trajectory(), 1), std::invalid_argument);
}

double sized_mass(Formalism f, const Changes& changes) {
  const Study study = shipped_study("slider_crank_rod",
                                    with(of_order_2(with_no_check(changes), {"crank", "rod"}), f));
  const auto r = run_cycle<SE2>(study.scene.mechanism, space_of<SE2>(study.scene.mechanism),
                                study.scene.simulation, study.spec, {}, {});
  EXPECT_EQ(r.status, CycleStatus::Converged) << to_string(f) << ": " << r.reason;
  return r.mass;
}

/// How far the rod sized by a formalism is from the one of the Lie group formalism.
double off_in_mass(Formalism f, const char* name, const Changes& changes) {
  const double lie = sized_mass(Formalism::SE3, changes);
  const double off = std::abs(sized_mass(f, changes) / lie - 1);
  testing::Test::RecordProperty(fmt::format("mass_{}_{}", to_string(f), name),
                                fmt::format("{:.3g}", off));
  return off;
}

TEST(FormalismLoads, SizeTheSameRodAsTheMeshRefines) {
  for (const auto f : {Formalism::R3SO3, Formalism::Classical}) {
    const auto off = [&](const char* n) {
      return off_in_mass(f, n,
                         {std::string("bodies.rod.beam.elements=") + n,
                          std::string("bodies.crank.beam.elements=") + n});
    };
    const double coarse = off("8"), fine = off("16");
    EXPECT_LT(coarse, 0.02) << to_string(f);
    EXPECT_GT(std::log2(coarse / fine), 1.7) << to_string(f);
  }
}

TEST(FormalismLoads, OfTheFloatingFrameSizeTheSameRodAsItStiffens) {
  const double soft = off_in_mass(Formalism::Floating, "E", {});
  const double stiff = off_in_mass(
      Formalism::Floating, "4E", {"materials.steel.E=8.4e11", "constraints.bending.limit=0.25e-3"});
  EXPECT_LT(soft, 0.06);
  EXPECT_NEAR(std::log2(soft / stiff) / 2, 1, 0.1);
}

}  // namespace
}  // namespace liesl::test::formalism_loads_test
