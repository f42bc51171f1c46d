#include "mbs/solvers/initial_state.hpp"

#include <fmt/format.h>

#include "mbs/solvers/node_coordinates.hpp"
#include "mbs/system/constraint_rank.hpp"

namespace liesl {
namespace {

constexpr int kMaxAssembly = 50;
constexpr double kAssembled = 1e-12;  // of the mechanism's extent
constexpr double kGivenVelocity = 1e-6;
constexpr double kDriven = 1e-9;    // rad or of the length: a drive that starts elsewhere
constexpr double kPoseTime = 1;     // s: M/time^2 is small beside K, bodies are as good as rigid
constexpr double kFar = 1e-2;       // rad or m, a correction that is not small
constexpr double kRelaxed = 1e-11;  // rad or m, last correction
constexpr int kRefinements = 5;     // of the accelerations
constexpr double kRefined = 1e-12;

/// Each body must have mass, and a beam inertia in every direction: the joints act on it through
/// the inverse of its mass matrix. (For point masses see JointSystem.)
template <FrameGroup G>
bool has_inertia(const Model<G>& model, InitialState& out) {
  for (const auto& body : model.bodies) {
    const bool point = body->elements() == 0 && body->total_mass() > 0;
    if (point || BodyLU<G::dim>().factor(body->mass())) continue;
    out.status = SolveStatus::Singular;
    out.reason = fmt::format(
        "body '{}' has no inertia in some direction; give it a mass and moments of inertia",
        body->name);
    return false;
  }
  return true;
}

/// The coupling with the constraint that is farthest from closed.
template <FrameGroup G>
const std::string& most_open(const Equations<G>& eq) {
  const Coupling<G>* worst = &eq.model.couplings.front();
  const auto open = [&eq](const Coupling<G>& c) {
    return c.constraints > 0 ? eq.phi.segment(c.first_constraint, c.constraints)
                                   .template lpNorm<Eigen::Infinity>()
                             : 0;
  };
  for (const auto& c : eq.model.couplings)
    if (!(open(c) <= open(*worst))) worst = &c;
  return worst->name;
}

/// eq.r = elastic forces of the bodies alone, none of loads, springs or joints.
template <FrameGroup G>
void elastic_forces(const Model<G>& model, const State<G>& s, Equations<G>& eq) {
  ForceScale scale;
  eq.r.setZero();
  for (size_t b = 0; b < model.bodies.size(); ++b)
    model.bodies[b]->add_internal(model.body_state(s, static_cast<int>(b)),
                                  eq.r.data() + G::dim * model.first_node(static_cast<int>(b)),
                                  scale);
}

/// Positions go where the frames of their bodies carry them.
template <FrameGroup G>
void follow_frames(const Model<G>& model, const Frames<G>& start, State<G>& s) {
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const int first = model.first_node(static_cast<int>(b));
    model.bodies[b]->follow_frames(start.data() + first, s.H.data() + first);
  }
}

/// @param relax: what strains the way to the constraints has left is taken out again, in the same
/// metric: bodies are turned to where drives want them. @pre s.v = 0 then
template <FrameGroup G>
bool assemble_positions(const Model<G>& model, double time, bool relax, State<G>& s,
                        InitialState& out) {
  Equations<G> eq(model);
  JointSystem<G> system(model);
  system.factor({1 / (time * time), 0});
  Eigen::VectorXd delta = Eigen::VectorXd::Zero(model.size()), dlambda = s.lambda;
  const NodeCoordinates<G> coordinates(model, true);
  const auto start = s.H;
  for (int i = 0; i <= kMaxAssembly; ++i) {
    eq.evaluate(s, s.rows, {s.t, 1});
    eq.phi = eq.gap;
    if (!std::isfinite(eq.constraint_residual())) break;
    const bool relaxed = !relax || i == kMaxAssembly ||
                         (i > 0 && delta.template lpNorm<Eigen::Infinity>() <= kRelaxed);
    if (relaxed && eq.constraint_residual() <= kAssembled * model.extent) {
      for (size_t k = 0; k < start.size(); ++k)
        out.moved = std::max(out.moved, (s.H[k].x - start[k].x).norm());
      return true;
    }
    eq.r.setZero();
    if (relax) elastic_forces(model, s, eq);
    if (!system.solve(eq, delta, dlambda, false)) break;
    model.retract(s, delta);
    if (relax && delta.template lpNorm<Eigen::Infinity>() > kFar) follow_frames(model, start, s);
    coordinates.turn_positions(s, {});  // stiffness and mass are known in the axes of the body
    if (relax) eq.observe(s, s.rows, s.rows);
  }
  out.status = SolveStatus::Inconsistent;
  out.reason = fmt::format(
      "the joints cannot be assembled from the positions given: '{}' stays {:.3g} (m or rad) "
      "from closed; check the positions of the bodies and the joints' axes",
      most_open(eq), eq.constraint_residual());
  return false;
}

/// eq.phi = B v - target, with the gradients of the last evaluation.
template <FrameGroup G>
void constraint_rates(Equations<G>& eq, const Eigen::VectorXd& v, const Eigen::VectorXd& target) {
  eq.phi = -target;
  for (size_t i = 0; i < eq.couplings.size(); ++i) {
    const auto& c = eq.model.couplings[i];
    if (c.constraints == 0) continue;
    auto rate = eq.phi.segment(c.first_constraint, c.constraints);
    const auto B = eq.couplings[i].B.topRows(c.constraints);
    if (c.a.body >= 0)
      rate += B.template leftCols<G::dim>() * v.template segment<G::dim>(G::dim * c.a.node);
    if (c.b.body >= 0)
      rate += B.template rightCols<G::dim>() * v.template segment<G::dim>(G::dim * c.b.node);
  }
}

template <FrameGroup G>
bool project_velocities(const Model<G>& model, double time, State<G>& s, InitialState& out) {
  Equations<G> eq(model);
  JointSystem<G> system(model);
  system.factor({1 / (time * time), 0});
  Eigen::VectorXd delta = s.v, dlambda = s.lambda, target = s.lambda;
  const Eigen::VectorXd start = s.v;
  eq.evaluate(s, s.rows, {s.t, 1});
  eq.velocity_target(s.t, target);
  for (int i = 0; i < 4; ++i) {  // once, and again for what round-off left
    constraint_rates(eq, s.v, target);
    if (eq.constraint_residual() == 0) break;
    eq.r.setZero();
    if (!system.solve(eq, delta, dlambda, false)) {
      out.status = SolveStatus::Singular;
      out.reason = "the velocities cannot be made consistent: the joint equations are singular";
      return false;
    }
    s.v += delta;
  }
  for (int k = 0; k < model.nodes(); ++k)
    out.velocity_change = std::max(out.velocity_change,
                                   (s.v - start).template segment<G::space_dim>(G::dim * k).norm());
  if (start.norm() == 0 && out.velocity_change > kGivenVelocity * model.length / time)
    out.warnings.push_back(
        fmt::format("drives move at once at t = 0: bodies start with up to {:.3g} m/s and no "
                    "deformation, which makes them vibrate; a drive with a ramp starts from rest",
                    out.velocity_change));
  if (start.norm() > 0 && (s.v - start).norm() > kGivenVelocity * start.norm())
    out.warnings.push_back(
        fmt::format("the velocities given violate joints or drives: they were changed by up to "
                    "{:.3g} m/s, as little as rigid bodies allow",
                    out.velocity_change));
  return true;
}

template <FrameGroup G>
bool solve_accelerations(const Model<G>& model, State<G>& s, InitialState& out) {
  Equations<G> eq(model);
  JointSystem<G> system(model);
  s.vdot.setZero();
  s.lambda.setZero();
  Eigen::VectorXd target = s.lambda, dlambda = s.lambda, delta = s.vdot;
  eq.acceleration_target(s, s.t, target);
  const bool regular = system.factor({1, 0}, 0);
  for (int i = 0; i < kRefinements; ++i) {  // once, and again for what point masses leave
    eq.evaluate(s, s.rows, {s.t, 1});
    constraint_rates(eq, s.vdot, target);
    if (!regular || !system.solve(eq, delta, dlambda, false)) {
      out.status = SolveStatus::Singular;
      out.reason =
          "the accelerations at the start are not determined: the joint equations are singular";
      return false;
    }
    s.vdot += delta;
    s.lambda += dlambda;
    if (delta.norm() <= kRefined * s.vdot.norm()) break;
  }
  s.a = s.vdot;
  return true;
}

}  // namespace

template <FrameGroup G>
double way_of_drives(const Model<G>& model, const State<G>& s) {
  double way = 0;
  for (const auto& c : model.couplings)
    for (size_t i = 0; i < c.rows.size(); ++i) {
      const auto& e = c.rows[i];
      if (e.role != Role::Constraint || e.coordinate < 0) continue;
      const bool length =
          e.row.kind() == RowKind::Displacement || e.row.kind() == RowKind::Distance;
      const double off = e.target(s.t) - s.rows[c.first_row + static_cast<int>(i)];
      way = std::max(way, std::abs(off) / (length ? model.length : 1));
    }
  return way;
}

template <FrameGroup G>
InitialState assemble(const Model<G>& model, double step, State<G>& s) {
  InitialState out;
  out.redundant = model.redundant;
  if (!model.dead_point.empty()) {
    out.status = SolveStatus::Singular;
    out.reason = model.dead_point;
    return out;
  }
  const Equations<G> eq(model);
  eq.observe(s, s.rows, s.rows);
  s.lambda.setZero(model.constraints());
  if (way_of_drives(model, s) > kDriven) {
    const Eigen::VectorXd v = s.v;
    s.v.setZero();
    const bool assembled = assemble_positions(model, kPoseTime, true, s, out);
    s.v = v;
    if (!assembled) return out;
  } else if (!assemble_positions(model, step, false, s, out)) {
    return out;
  }
  eq.observe(s, s.rows, s.rows);
  if (const auto why = contradiction(model, s, s.t); !why.empty()) {
    out.status = SolveStatus::Inconsistent;
    out.reason = why;
  }
  return out;
}

template <FrameGroup G>
InitialState make_consistent(const Model<G>& model, const SimulationOptions& options, State<G>& s) {
  InitialState out;
  if (!has_inertia(model, out)) return out;
  Equations<G>(model).observe(s, s.rows, s.rows);
  const double way = way_of_drives(model, s);
  out = assemble(model, options.step, s);
  if (out.status != SolveStatus::Converged) return out;
  if (way > kDriven)
    out.warnings.push_back(
        fmt::format("a drive is not at its joint's position at t = 0: before the motion starts the "
                    "bodies were moved by up to {:.3g} m, to where it is",
                    out.moved));
  if (project_velocities(model, options.duration, s, out)) solve_accelerations(model, s, out);
  return out;
}

template double way_of_drives(const Model<SE2>&, const State<SE2>&);
template double way_of_drives(const Model<SE3>&, const State<SE3>&);
template InitialState assemble(const Model<SE2>&, double, State<SE2>&);
template InitialState assemble(const Model<SE3>&, double, State<SE3>&);
template InitialState make_consistent(const Model<SE2>&, const SimulationOptions&, State<SE2>&);
template InitialState make_consistent(const Model<SE3>&, const SimulationOptions&, State<SE3>&);

}  // namespace liesl
