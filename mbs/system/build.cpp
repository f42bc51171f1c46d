#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <stdexcept>

#include "mbs/system/build_body.hpp"
#include "mbs/system/build_force.hpp"
#include "mbs/system/build_gear.hpp"
#include "mbs/system/build_joint.hpp"
#include "mbs/system/build_load.hpp"
#include "mbs/system/constraint_rank.hpp"
#include "mbs/system/model.hpp"
#include "mbs/system/penalty.hpp"
#include "mbs/system/retract.hpp"

namespace liesl {
namespace {

/// Nodes of each body that joints, forces and loads hold on to, in order.
std::vector<std::vector<int>> held_nodes(const Mechanism& m) {
  std::vector<std::set<int>> held(m.bodies.size());
  const auto add = [&held](const Port& p) {
    if (p.body >= 0) held[p.body].insert(p.node);
  };
  for (const auto& j : m.joints) {
    add(j.a);
    add(j.b);
  }
  for (const auto& f : m.forces)
    if (f.joint < 0) {
      add(f.a);
      add(f.b);
    }
  for (const auto& l : m.loads)
    if (!l.spread) add(l.port);
  std::vector<std::vector<int>> out;
  for (const auto& nodes : held) out.emplace_back(nodes.begin(), nodes.end());
  return out;
}

/// A node that is a position holds what acts on the place alone.
/// @throws std::invalid_argument
template <FrameGroup G>
void require_held_by_place(const Model<G>& model) {
  for (const auto& c : model.couplings)
    for (const auto* port : {&c.a, &c.b}) {
      if (port->body < 0) continue;
      const Body<G>& body = *model.bodies[port->body];
      if (body.kind(port->node - model.first_node(port->body)) != NodeKind::Position) continue;
      const auto turns = [](const CouplingRow<G>& e) {
        const RowKind kind = e.row.kind();
        const bool place =
            kind == RowKind::Distance || (kind == RowKind::Displacement && e.coordinate < 0);
        return e.role <= Role::Actuator && !place;
      };
      if (port->offset.x.norm() == 0 && std::none_of(c.rows.begin(), c.rows.end(), turns)) continue;
      throw std::invalid_argument(
          "'" + c.name + "' turns a node between the ends of '" + body.name +
          "', which has no rotation as a chain of segments: hold it by its place alone");
    }
}

bool deforms(const BodySpec& body) {
  const auto* beam = std::get_if<BeamSpec>(&body.kind);
  return beam ? beam->as != BeamModel::Rigid : !std::holds_alternative<RigidSpec>(body.kind);
}

/// Where no body deforms there are no strains that ask for screw motions: R^3 x SO(3).
NodeUpdate update_of(const Mechanism& m) {
  const bool rigid = m.formalism == Formalism::Rigid ||
                     (m.formalism == Formalism::SE3 && std::ranges::none_of(m.bodies, deforms));
  return rigid && m.update == NodeUpdate::AsFormalism ? NodeUpdate::R3SO3
                                                      : update_of(m.update, m.formalism);
}

}  // namespace

template <FrameGroup G>
Model<G> Model<G>::build(const Mechanism& mechanism, const Space<G>& space) {
  Model model;
  model.formalism = mechanism.formalism;
  model.update = update_of(mechanism);
  model.space = space;
  model.gravity = space.reduce_vector(mechanism.gravity);
  model.gravity_scale = mechanism.gravity_scale;
  model.length = mechanism.size() > 0 ? mechanism.size() : 1;
  const auto held = held_nodes(mechanism);
  for (const auto& spec : mechanism.bodies) {
    const auto& at = held[model.bodies.size()];
    model.first_node_.push_back(model.nodes_);
    model.bodies.push_back(build_body(spec, space, mechanism.formalism, at));
    for (int k = 0; k < model.bodies.back()->nodes(); ++k) {
      const NodeKind kind = model.bodies.back()->kind(k);
      if (kind == NodeKind::Frame) model.frames_.push_back(model.nodes_ + k);
      if (kind == NodeKind::Position) model.positions_.push_back(model.nodes_ + k);
      if (kind == NodeKind::Amplitudes) model.amplitudes_.push_back(model.nodes_ + k);
    }
    model.nodes_ += model.bodies.back()->nodes();
  }
  if ((model.update == NodeUpdate::RotationVector) != (model.formalism == Formalism::Classical))
    throw std::invalid_argument(
        "rotation vectors are the update of the classical formalism, and of no other");
  if (mechanism.update == NodeUpdate::R3SO3 && model.formalism != Formalism::R3SO3 &&
      !(model.positions_.empty() && model.amplitudes_.empty()))
    throw std::invalid_argument(
        "simulation.update = \"r3so3\" moves nodes that are frames; chains of segments and bodies "
        "with modes have others");
  const Ports<G> ports(mechanism, model);
  for (size_t j = 0; j < mechanism.joints.size(); ++j)
    model.couplings.push_back(build_joint(mechanism, static_cast<int>(j), space, ports));
  for (size_t f = 0; f < mechanism.forces.size(); ++f)
    if (mechanism.forces[f].joint < 0)
      model.couplings.push_back(build_force(mechanism, static_cast<int>(f), ports));
  for (const auto& l : mechanism.loads)
    model.loads.push_back(build_load(l, mechanism, model, ports));
  for (const GearSpec& gear : mechanism.gears) build_gear(mechanism, gear, model);
  std::erase_if(model.couplings, [](const Coupling<G>& c) { return c.rows.empty(); });
  model.extent = model.length;
  for (const auto& body : model.bodies)
    for (const G& H : body->reference)
      model.extent = std::max(model.extent, model.length + H.x.norm());
  model.set_initial_velocity(mechanism);
  require_held_by_place(model);
  model.finish();
  model.penalty = build_penalty(mechanism.penalty, model);
  model.leave_out_redundant_rows();
  return model;
}

template <FrameGroup G>
void Model<G>::set_initial_velocity(const Mechanism& mechanism) {
  initial_velocity_.setZero(size());
  for (size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto& spec = mechanism.bodies[b];
    const auto at = [&](int k) {
      return mechanism.frame({static_cast<int>(b), k, SE3::identity()});
    };
    const SE3 first = at(0);
    for (int k = 0; k < bodies[b]->nodes(); ++k) {
      const NodeKind kind = bodies[b]->kind(k);
      if (kind != NodeKind::Frame && kind != NodeKind::Position) continue;
      if (k >= bodies[b]->points()) {  // of a mesh, in the axes of the first node
        set_velocity_of_mesh(static_cast<int>(b), k);
        continue;
      }
      const SE3 H = at(k);
      SE3::Tangent v;
      v << H.R.transpose() * (spec.velocity + spec.angular_velocity.cross(H.x - first.x)),
          H.R.transpose() * spec.angular_velocity;
      initial_velocity_.template segment<G::dim>(G::dim * (first_node_[b] + k)) =
          space.reduce_local(v, space.alignment(H));
      if (kind == NodeKind::Position)
        initial_velocity_
            .template segment<G::rotation_dim>(G::dim * (first_node_[b] + k) + G::space_dim)
            .setZero();
    }
  }
}

/// As of one rigid piece with the first node.
template <FrameGroup G>
void Model<G>::set_velocity_of_mesh(int body, int node) {
  const G &first = bodies[body]->reference[0], &H = bodies[body]->reference[node];
  const typename G::Tangent v =
      initial_velocity_.template segment<G::dim>(G::dim * first_node_[body]);
  const Vector arm = first.R.transpose() * (H.x - first.x);
  initial_velocity_.template segment<G::space_dim>(G::dim * (first_node_[body] + node)) =
      H.R.transpose() * first.R *
      (v.template head<G::space_dim>() -
       RotationOf<G>::cross(arm) * v.template tail<G::rotation_dim>());
}

template <FrameGroup G>
void Model<G>::leave_out_redundant_rows() {
  RedundantRows found = redundant_rows(*this, initial_state());
  redundant = std::move(found.sentences);
  dead_point = std::move(found.dead_point);
  if (penalty.form != ConstraintForm::Multipliers || found.rows.empty()) return;
  for (const auto& [coupling, equation] : found.rows) {
    couplings[coupling].rows[equation].role = Role::Redundant;
    const std::size_t next = static_cast<std::size_t>(coupling) + 1;
    if (next < couplings.size() && couplings[next].continued)
      couplings[next].rows[0].role = Role::Redundant;
  }
  finish();
}

/// Numbers the rows, sorted by role within each coupling.
template <FrameGroup G>
void Model<G>::finish() {
  coupled_nodes.assign(bodies.size(), {});
  rows_ = constraints_ = 0;
  const auto place = [this](PortOf<G>& p) {
    if (p.body < 0) return;
    auto& nodes = coupled_nodes[p.body];
    const auto found = std::find(nodes.begin(), nodes.end(), p.node - first_node_[p.body]);
    p.slot = static_cast<int>(found - nodes.begin());
    if (found == nodes.end()) nodes.push_back(p.node - first_node_[p.body]);
  };
  int own = 0;  // first constraint of a coupling that continues none
  for (auto& c : couplings) {
    place(c.a);
    place(c.b);
    std::stable_sort(
        c.rows.begin(), c.rows.end(),
        [](const CouplingRow<G>& a, const CouplingRow<G>& b) { return a.role < b.role; });
    c.first_row = rows_;
    if (!c.continued) own = constraints_;
    c.first_constraint = own;
    c.constraints = c.active = c.acting = 0;
    for (const auto& e : c.rows) {
      c.constraints += e.role == Role::Constraint;
      c.active += e.role <= Role::Compliant;
      c.acting += e.role <= Role::Actuator;
    }
    rows_ += static_cast<int>(c.rows.size());
    if (!c.continued) constraints_ += c.constraints;
  }
}

template <FrameGroup G>
void Model<G>::retract(State<G>& s, Eigen::Ref<const Eigen::VectorXd> delta) const {
  liesl::retract(s, delta, NodeUpdate::Screw, {frames_, positions_, amplitudes_}, s);
}

template <FrameGroup G>
void Model<G>::complete(State<G>& s) const {
  if (static_cast<int>(frames_.size()) == nodes_) return;
  for (size_t b = 0; b < bodies.size(); ++b) {
    const int n = first_node_[b];
    bodies[b]->complete(s.H.data() + n, s.v.data() + G::dim * n, s.vdot.data() + G::dim * n,
                        s.w.data() + G::dim * n);
  }
}

template <FrameGroup G>
State<G> Model<G>::initial_state() const {
  State<G> s;
  for (const auto& body : bodies)
    s.H.insert(s.H.end(), body->reference.begin(), body->reference.end());
  s.v = initial_velocity_;
  s.vdot.setZero(size());
  s.a.setZero(size());
  s.w.setZero(size());
  s.lambda.setZero(constraints_);
  s.rows.setZero(rows_);
  return s;
}

template class Model<SE2>;
template class Model<SE3>;

}  // namespace liesl
