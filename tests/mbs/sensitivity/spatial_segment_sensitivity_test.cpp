/// @file
/// Sensitivities of motions of chains of segments in space: direct form, adjoint form and
/// differences of simulations, of all that is known of their nodes and segments.

#include "mbs/sensitivity/response_histories.hpp"

namespace liesl::test::spatial_segment_sensitivity_test {
namespace {

constexpr int kSegments = 3;

/// A rod of a soft plastic on a spherical joint, thrown by a force at its end that turns, under its
/// weight and a load inside.
Mechanism pendulum_in_space(SegmentSpec spec = {}) {
  Mechanism m;
  m.formalism = Formalism::Segments;
  m.gravity = {2, -9.81, 1};
  m.bodies = {{"rod", straight_beam({0, 0, 0}, {0.3, 0, 0}, kSegments, round_section(0.016, 0.9),
                                    {"plastic", 7e8, 0.3, 1200})}};
  std::get<BeamSpec>(m.bodies[0].kind).segment = spec;
  m.joints = {{"ball", JointType::Spherical, {}, {0, 0}}};
  LoadSpec across, along;
  across.name = "across";
  across.port = {0, kSegments};
  across.force = {1, -3, 0};
  across.scale = TimeFunction::expression("sin(150*t)");
  along = across;
  along.name = "along";
  along.port = {0, 1};
  along.force = {0, 2, 4};
  along.scale = TimeFunction::expression("1-cos(200*t)");
  m.loads = {across, along};
  return m;
}

std::vector<Quantity> quantities_of(const Mechanism& m) {
  const auto beam = [](Mechanism& c) -> BeamSpec& { return std::get<BeamSpec>(c.bodies[0].kind); };
  return {{7e8,
           [beam](Mechanism& c, double p) { beam(c).material.E = p; },
           {"E", {by_youngs_modulus(m, 0)}}},
          {1200,
           [beam](Mechanism& c, double p) { beam(c).material.rho = p; },
           {"rho", {by_density(m, 0)}}},
          {0.016,
           [beam](Mechanism& c, double p) {
             for (auto& section : beam(c).sections) std::get<Circle>(section.shape).diameter = p;
           },
           {"diameter", {by_dimension(m, 0, {}, "diameter")}}}};
}

ResponseSpec response(ResponseKind kind) {
  ResponseSpec r;
  r.kind = kind;
  r.name = name_of(kind);
  r.body = 0;
  r.at = {0, 1, SE3(Mat3::Identity(), {0.01, 0.02, -0.01})};
  return r;
}

/// Of places, of the turns of nodes inside, of what is in their axes and those of segments.
std::vector<ResponseSpec> responses() {
  std::vector<ResponseSpec> all;
  for (const auto kind : {ResponseKind::Position, ResponseKind::Deflection, ResponseKind::Energy,
                          ResponseKind::Compliance, ResponseKind::Stress})
    all.push_back(response(kind));
  all.back().element = 1;  // the largest over all points would jump from one to the next
  all.back().point = 2;
  for (const Axes in : {Axes::Inertial, Axes::Body})
    for (const auto kind : {ResponseKind::Rotation, ResponseKind::Velocity,
                            ResponseKind::AngularVelocity, ResponseKind::Displacement}) {
      all.push_back(response(kind));
      all.back().in = in;
      all.back().at.node = 2;
    }
  for (const auto place : {ElementPlace::First, ElementPlace::Middle, ElementPlace::Last})
    for (const int component : {0, 2, 4, 5}) {
      all.push_back(response(ResponseKind::SectionForce));
      all.back().element = 1;
      all.back().place = place;
      all.back().component = component;
    }
  return all;
}

TEST(SpatialSegmentSensitivity, DirectEqualsAdjoint) {
  const Mechanism m = pendulum_in_space();
  for (const int steps : {10, 100, 1000})
    expect_response_forms(Taped<SE3>(m, tight(steps * 4e-4, 4e-4)), quantities_of(m), responses());
}

TEST(SpatialSegmentSensitivity, DirectAdjointAndDifferencesAreTheSame) {
  const Mechanism m = pendulum_in_space();
  expect_response_gradients<SE3>(m, tight(0.02, 4e-4), quantities_of(m), responses());
}

TEST(SpatialSegmentSensitivity, OfLumpedMassesAndTheHyperelasticPotentialToo) {
  for (const SegmentSpec& spec : {SegmentSpec{AxialPotential::Linear, true},
                                  SegmentSpec{AxialPotential::NeoHookean, false}}) {
    const Mechanism m = pendulum_in_space(spec);
    expect_response_gradients<SE3>(m, tight(0.012, 4e-4), quantities_of(m), responses());
  }
}

/// By its length, which moves all of its nodes.
TEST(SpatialSegmentSensitivity, ByGeometry) {
  const Mechanism m = pendulum_in_space();
  const Quantity length = by_nearby("length", m, 0.3, [](Mechanism& c, double p) {
    std::get<BeamSpec>(c.bodies[0].kind).nodes = straight({0, 0, 0}, {p, 0, 0}, kSegments);
  });
  expect_response_gradients<SE3>(m, tight(0.012, 4e-4), {length}, responses(), {.largest = 0.02});
}

/// In a plane they are those of the planar chain.
TEST(SpatialSegmentSensitivity, OfAPlaneAreThoseOfThePlane) {
  Mechanism m = pendulum_in_space();
  m.gravity.z() = m.loads[1].force.z() = 0;
  const auto gradient = [&]<class G>() {
    const Taped<G> run(m, tight(0.02, 4e-4));
    MatrixXd out;
    const auto end = direct_sensitivity<G>(
        run.model, run.tape, run.parameters(quantities_of(m)),
        [&](long, const State<G>& s, const auto& ds) {
          out = (s.H[kSegments].R * ds.eta.middleRows(G::dim * kSegments, G::space_dim)).topRows(2);
        });
    EXPECT_TRUE(end.complete()) << end.reason;
    return out;
  };
  const MatrixXd plane = gradient.operator()<SE2>(), space = gradient.operator()<SE3>();
  EXPECT_LT((plane - space).norm(), 1e-9 * plane.norm());
}

}  // namespace
}  // namespace liesl::test::spatial_segment_sensitivity_test
