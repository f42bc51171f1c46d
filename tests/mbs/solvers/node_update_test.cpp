/// @file
/// Update of the nodes as a choice beside the element: bodies of se3 moved in R^3 x SO(3).

#include "mbs/run.hpp"
#include "reference/published.hpp"

namespace liesl::test::node_update_test {
namespace {

Mechanism updated(Mechanism m, NodeUpdate update) {
  m.update = update;
  return m;
}

/// A rigid body has no element: with the update of r3so3 it is that formalism, with 1/10 of the
/// error of the screw update on a fast top.
TEST(NodeUpdate, RigidBodyUpdatedAsR3SO3IsR3SO3) {
  const SimulationOptions o = test::options(1, 1e-3, 0.9, 1e-9);
  Mechanism other = test::heavy_top();
  other.formalism = Formalism::R3SO3;
  const auto screw = test::run_spatial(updated(test::heavy_top(), NodeUpdate::Screw), o);
  const auto decoupled = test::run_spatial(updated(test::heavy_top(), NodeUpdate::R3SO3), o);
  const auto chosen = test::run_spatial(test::heavy_top(), o);
  const auto formalism = test::run_spatial(other, o);
  for (const auto* r : {&screw, &decoupled, &chosen, &formalism})
    ASSERT_EQ(r->report().status, SolveStatus::Converged) << r->report().reason;
  const auto x = [](const auto& r) { return r.trajectory().frames(r.last())->x; };
  EXPECT_LT((x(decoupled) - x(formalism)).norm(), 1e-6);
  EXPECT_EQ((x(decoupled) - x(chosen)).norm(), 0);
  const double off = (x(decoupled) - test::heavy_top_one.x).norm();
  EXPECT_LT(10 * off, (x(screw) - test::heavy_top_one.x).norm());
  EXPECT_EQ(decoupled.report().factorizations.size(), screw.report().factorizations.size());
}

/// Largest deviation of linear momentum after the loads of the flying beam have ended, N s.
double drift(const Mechanism& m) {
  const auto r = test::run_spatial(m, test::options(8, 0.01));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  State<SE3> s = r.model->initial_state();
  double largest = 0;
  for (int i = 0; i < r.trajectory().size(); ++i) {
    r.trajectory().read(i, s);
    if (s.t < 5.1) continue;
    largest = std::max(
        largest, (momentum(*r.model, s).head<3>() - SE3::Tangent::Unit(0).head<3>() * 50).norm());
  }
  return largest;
}

TEST(NodeUpdate, FreeBeamKeepsItsLinearMomentum) {
  Mechanism m = test::flying_beam(8);
  std::get<BeamSpec>(m.bodies[0].kind).order = 4;
  EXPECT_LT(drift(updated(m, NodeUpdate::R3SO3)), 0.05 * drift(m));
}

TEST(NodeUpdate, IsWhatTheFormalismTakesUnlessChosen) {
  EXPECT_EQ(update_of(NodeUpdate::AsFormalism, Formalism::SE3), NodeUpdate::Screw);
  EXPECT_EQ(update_of(NodeUpdate::AsFormalism, Formalism::R3SO3), NodeUpdate::R3SO3);
  EXPECT_EQ(update_of(NodeUpdate::AsFormalism, Formalism::Classical), NodeUpdate::RotationVector);
  EXPECT_EQ(update_of(NodeUpdate::R3SO3, Formalism::SE3), NodeUpdate::R3SO3);
  EXPECT_EQ(Model<SE3>::build(test::flying_beam(2), {}).update, NodeUpdate::Screw);
  Mechanism m = test::flying_beam(2);
  m.formalism = Formalism::Rigid;
  EXPECT_EQ(Model<SE3>::build(m, {}).update, NodeUpdate::R3SO3);
}

}  // namespace
}  // namespace liesl::test::node_update_test
