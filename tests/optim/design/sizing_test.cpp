/// @file
/// Design variables: where they act, what they weigh, what they change.
#include "optim/design/sizing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mbs/sections/section_law.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "reference/studies.hpp"

namespace liesl::test::sizing_test {
namespace {

DesignSpec design(const char* name, std::vector<int> bodies, int groups) {
  DesignSpec spec;
  spec.name = name;
  spec.bodies = std::move(bodies);
  spec.properties = {"diameter"};
  spec.groups = groups;
  spec.lower = 0.004;
  spec.upper = 0.02;
  return spec;
}

double diameter(const Mechanism& m, int body, int element) {
  return dimension(std::get<BeamSpec>(m.bodies[body].kind).sections[element].shape, "diameter");
}

TEST(Sizing, GroupsDivideTheElementsAsEvenlyAsPossible) {
  const Sizing sizing({design("rod", {1}, 3)}, slider_crank());
  ASSERT_EQ(sizing.size(), 3);
  EXPECT_EQ(sizing.variables()[2].name, "rod[2]");
  EXPECT_EQ(sizing.variables()[0].start, 0.010);
  EXPECT_EQ(sizing.variables()[0].upper, 0.02);
  const size_t counts[] = {2, 3, 3};
  int next = 0;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(sizing.elements(i).size(), counts[i]);
    for (const auto& at : sizing.elements(i)) EXPECT_EQ(at.element, next++);
  }
  EXPECT_EQ(Sizing({design("rod", {1}, 1)}, slider_crank()).variables()[0].name, "rod");
}

TEST(Sizing, LinkedBeamsTakeTheSameValues) {
  const Mechanism mechanism = slider_crank();
  const Sizing sizing({design("both", {0, 1}, 2)}, mechanism);
  Mechanism sized = mechanism;
  sizing.apply(Eigen::Vector2d(0.012, 0.015), sized);
  for (const int body : {0, 1}) {
    EXPECT_EQ(diameter(sized, body, 0), 0.012);
    EXPECT_EQ(diameter(sized, body, 3), 0.012);
    EXPECT_EQ(diameter(sized, body, 4), 0.015);
  }
}

TEST(Sizing, StartMayBeGivenByGroup) {
  DesignSpec spec = design("rod", {1}, 2);
  spec.start = {0.006, 0.007};
  const Sizing sizing({spec}, slider_crank());
  EXPECT_EQ(sizing.variables()[0].start, 0.006);
  EXPECT_EQ(sizing.variables()[1].start, 0.007);
}

TEST(Sizing, MassIsDensityTimesVolume) {
  const Mechanism mechanism = slider_crank();
  const Sizing sizing({design("rod", {1}, 2)}, mechanism);
  Mechanism sized = mechanism;
  sizing.apply(Eigen::Vector2d(0.008, 0.012), sized);
  const double rod = 7850 * M_PI / 4 * 0.15 * (0.008 * 0.008 + 0.012 * 0.012);
  EXPECT_NEAR(mass_of(sized, {1}), rod, 1e-14);
  EXPECT_NEAR(mass_of(sized, {1, 2}), rod + 0.2, 1e-14);
}

TEST(Sizing, DerivativesAgreeWithDifferences) {
  const Mechanism cantilever = svanberg_cantilever_beam();
  DesignSpec spec = design("side", {0}, 5);
  spec.properties = {"width", "height"};  // one variable moves both
  const Sizing sizing({spec}, cantilever);
  const SizedElement at{0, 30};
  const int variable = 1;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(5, 0.05);
  const auto law = [&](double step) {
    Eigen::VectorXd moved = x;
    moved[variable] += step;
    Mechanism m = cantilever;
    sizing.apply(moved, m);
    const auto& beam = std::get<BeamSpec>(m.bodies[0].kind);
    return section_law(beam.sections[at.element], beam.material);
  };
  Mechanism m = cantilever;
  sizing.apply(x, m);
  const SectionLaw d = sizing.derivative(m, variable, at);
  const SectionLaw d2 = sizing.second_derivative(m, variable, variable, at);
  const auto error = [&](double h) {
    return ((law(h).K - law(-h).K) / (2 * h) - d.K).norm() / d.K.norm();
  };
  EXPECT_LT(error(1e-6), 1e-8);
  EXPECT_NEAR((law(1e-6).M(0, 0) - law(-1e-6).M(0, 0)) / 2e-6, d.M(0, 0), 1e-8 * d.M(0, 0));
  const double h = 1e-4;
  const Eigen::Matrix<double, 6, 6> by_values = (law(h).K - 2 * law(0).K + law(-h).K) / (h * h);
  EXPECT_LT((by_values - d2.K).norm(), 1e-4 * d2.K.norm());
}

std::string refusal(const DesignSpec& spec) {
  try {
    Sizing({spec}, slider_crank());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Sizing, RefusesRigidBodiesAndTooManyGroups) {
  EXPECT_NE(refusal(design("x", {2}, 1)).find("'slider' is rigid"), std::string::npos);
  EXPECT_NE(refusal(design("x", {1}, 9)).find("9 groups on the 8 elements"), std::string::npos);
}

}  // namespace
}  // namespace liesl::test::sizing_test
