/// @file
/// Beams are refused order 4 for reasons that the default is taken from, too.
#include "mbs/model/beam_order.hpp"

#include <functional>

#include "mbs/run.hpp"
#include "mbs/static_cases.hpp"

namespace liesl::test::beam_order_test {
namespace {

using Change = std::function<void(Mechanism&, BeamSpec&)>;

Mechanism cantilever_of_order(int order, const Change& change) {
  BeamSpec spec;
  spec.nodes = straight({0, 0, 0}, {1, 0, 0}, 4);
  spec.sections.assign(4, Section{"circle", Circle{0.02}});
  spec.material = {"steel", 210e9, 0.3, 7850};
  spec.order = order;
  Mechanism m = test::cantilever(spec);
  change(m, std::get<BeamSpec>(m.bodies[0].kind));
  return m;
}

void spread(Mechanism& m, const Vec3& force, const Vec3& moment, bool follower) {
  LoadSpec load;
  load.name = "wind";
  load.port.body = 0;
  load.spread = true;
  load.force = force;
  load.moment = moment;
  load.follower = follower;
  m.loads.push_back(load);
}

void full(BeamSpec& beam, const SE3::Tangent& stiffness, const SE3::Tangent& inertia) {
  FullSection section;
  section.stiffness = stiffness.asDiagonal();
  section.inertia = inertia.asDiagonal();
  beam.sections.assign(4, Section{"full", section});
}

/// Models of order 4 are built exactly where the default is 4.
TEST(BeamOrder, DefaultAndRefusalAgree) {
  const SE3::Tangent stiff = SE3::Tangent::Constant(1e5), even = SE3::Tangent::Ones();
  const SE3::Tangent weak = (SE3::Tangent() << 1e5, -1, 1e5, 1e5, 1e5, 1e5).finished();
  const SE3::Tangent uneven = (SE3::Tangent() << 1, 2, 1, 1, 1, 1).finished();
  const std::pair<int, Change> cases[] = {
      {4, [](Mechanism&, BeamSpec&) {}},
      {4,
       [](Mechanism& m, BeamSpec&) {
         spread(m, {0, 5, 0}, {0, 0, 0}, false);
       }},
      {4, [&](Mechanism&, BeamSpec& b) { full(b, stiff, even); }},
      {2, [](Mechanism& m, BeamSpec&) { m.formalism = Formalism::R3SO3; }},
      {2, [](Mechanism& m, BeamSpec&) { m.formalism = Formalism::Classical; }},
      {2, [](Mechanism& m, BeamSpec&) { m.formalism = Formalism::Floating; }},
      {2, [](Mechanism& m, BeamSpec&) { m.formalism = Formalism::Rigid; }},
      {2, [](Mechanism& m, BeamSpec&) { m.formalism = Formalism::Segments; }},
      {2, [](Mechanism&, BeamSpec& b) { b.as = BeamModel::Rigid; }},
      {2, [](Mechanism&, BeamSpec& b) { b.as = BeamModel::Modal; }},
      {2, [](Mechanism&, BeamSpec& b) { b.as = BeamModel::Segments; }},
      {4,
       [](Mechanism& m, BeamSpec&) {
         spread(m, {0, 5, 0}, {0, 0, 0}, true);
       }},
      {2, [&](Mechanism&, BeamSpec& b) { full(b, weak, even); }},
      {2, [&](Mechanism&, BeamSpec& b) { full(b, stiff, uneven); }},
  };
  int number = 0;
  for (const auto& [order, change] : cases) {
    const Mechanism m = cantilever_of_order(4, change);
    EXPECT_EQ(default_order(m, 0), order) << number;
    if (order == 4)
      EXPECT_NO_THROW(Model<SE3>::build(m, {})) << number;
    else
      EXPECT_THROW(Model<SE3>::build(m, {}), std::invalid_argument) << number;
    ++number;
  }
}

/// By default only: their shear forces (LineLoad), and scenes as they were.
TEST(BeamOrder, MomentsAndDampingAreOfOrder2UnlessAskedFor) {
  const Change cases[] = {[](Mechanism&, BeamSpec& b) { b.damping = 1e-5; },
                          [](Mechanism& m, BeamSpec&) {
                            spread(m, {0, 5, 0}, {0, 0, 1}, false);
                          }};
  for (const Change& change : cases) {
    const Mechanism m = cantilever_of_order(4, change);
    EXPECT_EQ(default_order(m, 0), 2);
    EXPECT_NO_THROW(Model<SE3>::build(m, {}));
  }
}

}  // namespace
}  // namespace liesl::test::beam_order_test
