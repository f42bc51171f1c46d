#pragma once
/// @file
/// A meshed block under forces of all kinds: what the tests of bodies whose nodes all move
/// evaluate.

#include "mbs/run.hpp"
#include "reference/continuum.hpp"

namespace liesl::test {

inline const Material kSoftBlock = {"soft", 2e6, 0.3, 1000};

/// It has both ends held, the first driven, with a spring at the other, and is turned.
template <class G>
Mechanism driven(SolidSpec block) {
  Mechanism m;
  block.frame = SE3(SO3::exp({0, 0, 0.4}).R, {0.1, 0.2, 0});
  m.bodies = {{"block", block}};
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}}};
  m.drives = {{0, 0, TimeFunction::rate(30, 0.02)}};
  m.gravity = {1, -9.81, G::space_dim == 3 ? 2.0 : 0.0};
  LoadSpec push;
  push.name = "push";
  push.port = {0, 1};
  push.force = {40, -60, G::space_dim == 3 ? 25.0 : 0.0};
  m.loads = {push};
  ForceSpec spring;
  spring.name = "spring";
  spring.a = {-1, 0, SE3(Mat3::Identity(), {0.6, 0.8, 0})};
  spring.b = {0, 1};
  spring.stiffness = 200;
  spring.rest = 0.3;
  m.forces = {spring};
  return m;
}

/// Its state with all its nodes off and moving; positions do not turn.
template <FrameGroup G>
State<G> disturbed(const Model<G>& model, double size) {
  constexpr int dim = G::dim, sd = G::space_dim;
  Random random(5);
  State<G> s = model.initial_state();
  Eigen::VectorXd h = size * random.vector(model.size());
  s.v = random.vector(model.size());
  s.vdot = random.vector(model.size());
  for (const int k : model.positions())
    for (auto* x : {&h, &s.v, &s.vdot}) x->segment(dim * k + sd, dim - sd).setZero();
  model.retract(s, h);
  return s;
}

}  // namespace liesl::test
