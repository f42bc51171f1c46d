/// @file
/// A meshed part in a study: its mesh is built once, whatever is made of it.
#include "optim/design/part_shape.hpp"

#include <gtest/gtest.h>

#include "mbs/bodies/solid_body.hpp"
#include "mbs/run.hpp"
#include "optim/problems/design_run.hpp"
#include "reference/meshed_rod.hpp"

namespace liesl::test::part_shape_test {
namespace {

using levelset::FeatureKind;

/// A slider-crank whose rod is a mesh with a hole in its middle.
Mechanism crank_with_hole() {
  Mechanism m = slider_crank_with_mesh(40, 6, 3);
  std::get<SolidSpec>(m.bodies[1].kind).outline = {
      2,
      {{"bar", FeatureKind::HalfSpace, {2, 0, 0}, {}},
       {"hole", FeatureKind::Circle, {0.1, 0, 0, 0.004}, {}},
       {"all", FeatureKind::Difference, {}, {"bar", "hole"}}}};
  return m;
}

StudySpec study_of_the_hole() {
  StudySpec study;
  ShapeDesignSpec shape;
  shape.variables = {{"radius", {{"hole.radius", 1}}, 0.002, 0.005, {}}};
  study.shapes[1] = shape;
  study.mass_of = {1};
  ResponseSpec longer;
  longer.name = "longer";
  longer.kind = ResponseKind::Elongation;
  longer.body = 1;
  longer.at = {1, 0};
  longer.to = {1, 1};
  study.constraints = {{longer, 1e-3}};
  return study;
}

/// The mechanism of a design, its bodies and the study refer to the mesh that was given; what is
/// reduced anew for a design is the body alone.
TEST(PartShape, NoEvaluationOfADesignBuildsTheMesh) {
  const Mechanism m = crank_with_hole();
  const SolidModel* built = std::get<SolidSpec>(m.bodies[1].kind).model.get();
  const StudySpec study = study_of_the_hole();
  const Space<SE2> plane = space_of<SE2>(m);
  const DesignSimulator<SE2> simulator(m, plane, options(4e-3, 1e-3), study);
  EXPECT_EQ(&simulator.design().part(0).model, built);
  double before = 0;
  for (const double radius : {0.003, 0.005}) {
    const auto run = simulator.run(Eigen::VectorXd::Constant(1, radius));
    ASSERT_TRUE(run.good()) << run.reason();
    EXPECT_EQ(std::get<SolidSpec>(run.mechanism.bodies[1].kind).model.get(), built);
    const SolidBody<SE2>& body = *SolidBody<SE2>::of(*run.model->bodies[1]);
    EXPECT_EQ(&body.model(), built);
    EXPECT_NEAR(body.total_mass(), built->total_mass(body.fractions()), 1e-14);
    EXPECT_NEAR(run.mass, body.total_mass(), 1e-12);
    EXPECT_TRUE(before == 0 || run.mass < before) << "a larger hole";
    before = run.mass;
  }
}

TEST(PartShape, RefusesABodyWithoutOutline) {
  const Mechanism m = slider_crank_with_mesh(10, 2, 1);
  EXPECT_THROW(PartShape(m, 1, {}), std::invalid_argument);
  EXPECT_THROW(PartShape(m, 0, {}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::part_shape_test
