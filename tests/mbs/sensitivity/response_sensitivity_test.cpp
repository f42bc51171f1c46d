/// @file
/// Derivatives of responses by parameters over a motion: direct, adjoint and differences.

#include "mbs/sensitivity/response_histories.hpp"

namespace liesl::test::response_sensitivity_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Taped;

/// A clamped tube under a compressive load that pulses, and a small one across: compressed at all
/// times, most at its root, where its bending moment is largest.
Mechanism strut() {
  Section tube;
  tube.shape = Tube{0.03, 0.002};
  Mechanism m;
  m.bodies = {
      {"strut", straight_beam({0, 0, 0}, {0.4, 0, 0}, 3, tube, {"plastic", 7e8, 0.3, 1200})}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
  LoadSpec load;
  load.name = "load";
  load.port = {0, 3};
  load.force = {-40, -2, 0};
  load.scale = TimeFunction::expression("1.3-0.3*cos(80*t)");
  m.loads = {load};
  return m;
}

std::vector<ResponseSpec> responses_of_a_strut() {
  std::vector<ResponseSpec> all;
  for (const auto kind : {ResponseKind::Stress, ResponseKind::AxialStress, ResponseKind::Buckling,
                          ResponseKind::LocalBuckling, ResponseKind::Elongation,
                          ResponseKind::Compliance, ResponseKind::Energy}) {
    ResponseSpec r;
    r.kind = kind;
    r.name = name_of(kind);
    r.body = 0;
    r.at = {0, 0};
    r.to = {0, 3};
    all.push_back(r);
  }
  return all;
}

/// Not by its density, which hardly changes its forces: round-off would be left.
std::vector<Quantity> quantities_of_a_strut(const Mechanism& m) {
  const auto tube = [](Mechanism& c, std::size_t e) -> Tube& {
    return std::get<Tube>(std::get<BeamSpec>(c.bodies[0].kind).sections[e].shape);
  };
  const auto material = [](Mechanism& c) -> Material& {
    return std::get<BeamSpec>(c.bodies[0].kind).material;
  };
  return {{0.03,
           [tube](Mechanism& c, double p) {
             for (std::size_t e = 0; e < 3; ++e) tube(c, e).diameter = p;
           },
           {"diameter", {by_dimension(m, 0, {}, "diameter")}}},
          {0.002,
           [tube](Mechanism& c, double p) {
             for (std::size_t e = 0; e < 3; ++e) tube(c, e).thickness = p;
           },
           {"thickness", {by_dimension(m, 0, {}, "thickness")}}},
          {7e8,
           [material](Mechanism& c, double p) { material(c).E = p; },
           {"E", {by_youngs_modulus(m, 0)}}},
          {-40,
           [](Mechanism& c, double p) { c.loads[0].force.x() = p; },
           {"load", {LoadDerivative{0, 0, {}, {1, 0, 0}}}}}};
}

template <class G>
class ResponsesOfAMotion : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ResponsesOfAMotion, Groups);

TYPED_TEST(ResponsesOfAMotion, HaveTheDerivativesOfDifferencesAndOfTheAdjoint) {
  const Mechanism machine = test::sensitive_machine();
  expect_response_gradients<TypeParam>(machine, test::tight(0.02, 4e-4), test::quantities(machine),
                                       responses_of_the_machine());
}

TYPED_TEST(ResponsesOfAMotion, FurtherOnesHaveThem) {
  const Mechanism machine = test::sensitive_machine();
  expect_response_gradients<TypeParam>(machine, test::tight(0.02, 4e-4), test::quantities(machine),
                                       further_responses_of_the_machine(),
                                       {.linear = kLoadsOfTheMachine});
}

/// From equilibrium: waves from a load that strikes would be largest in other places. What E and
/// rho change of forces is little: extrapolations end at 1.4e-7.
TYPED_TEST(ResponsesOfAMotion, OfAMemberHaveThem) {
  const Mechanism machine = strut();
  auto o = test::tight(0.04, 4e-4);
  o.start = StartChoice::Equilibrium;
  expect_response_gradients<TypeParam>(machine, o, quantities_of_a_strut(machine),
                                       responses_of_a_strut(), {.samples = 24});
}

/// By its length. At a constant state a change of it strains the strut by up to 2e-3, more than its
/// motion does, and with the other sign. Not the mean stress, which its length hardly changes.
TYPED_TEST(ResponsesOfAMotion, OfAMemberHaveThemByGeometry) {
  const Mechanism machine = strut();
  auto o = test::tight(0.04, 4e-4);
  o.start = StartChoice::Equilibrium;
  const Quantity length = test::by_nearby("length", machine, 0.4, [](Mechanism& c, double p) {
    std::get<BeamSpec>(c.bodies[0].kind).nodes = straight({0, 0, 0}, {p, 0, 0}, 3);
  });
  auto responses = responses_of_a_strut();
  std::erase_if(responses, [](const auto& r) { return r.kind == ResponseKind::AxialStress; });
  expect_response_gradients<TypeParam>(machine, o, {length}, responses, {.largest = 0.02});
}

/// At a constant state, which is all there is where nodes do not move along the group, the strain
/// of another length leaves no digits of an energy: refused, not computed.
TEST(ResponsesByGeometry, EnergiesNeedNodesThatMoveAlongTheGroup) {
  Mechanism machine = strut();
  machine.formalism = Formalism::R3SO3;
  const Taped<SE2> run(machine, test::tight(0.002, 4e-4));
  const auto parameters =
      run.parameters({test::by_nearby("length", machine, 0.4, [](Mechanism& c, double p) {
        std::get<BeamSpec>(c.bodies[0].kind).nodes = straight({0, 0, 0}, {p, 0, 0}, 3);
      })});
  const ResponseValues<SE2> values(run.mechanism, run.model);
  int refused = 0;
  for (const ResponseSpec& r : responses_of_a_strut()) {
    const bool energy = r.kind == ResponseKind::Compliance || r.kind == ResponseKind::Energy;
    try {
      ResponseSensitivity<SE2>(run.model, values, r, parameters);
      EXPECT_FALSE(energy) << r.name;
    } catch (const std::invalid_argument& error) {
      EXPECT_TRUE(energy) << error.what();
      EXPECT_NE(std::string(error.what()).find("'length' changes the shape"), std::string::npos);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 2);
}

}  // namespace
}  // namespace liesl::test::response_sensitivity_test
