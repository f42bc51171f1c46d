#include <Eigen/Geometry>
#include <set>
#include <stdexcept>

#include "mbs/bodies/modal.hpp"
#include "mbs/bodies/rigid.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/model/parameter.hpp"
#include "mbs/system/body_law.hpp"
#include "mbs/system/constraint_rank.hpp"
#include "mbs/system/model.hpp"

namespace liesl {
namespace {

template <class G>
std::unique_ptr<Body<G>> make_body(const std::string& name, const BeamSpec& beam,
                                   const Space<G>& space, Formalism formalism,
                                   const std::vector<int>& held) {
  std::vector<G> nodes;
  for (const SE3& H : beam.nodes) nodes.push_back(space.reduce(H, space.alignment(H)));
  std::vector<SectionLaw> laws;
  for (const Section& section : beam.sections) laws.push_back(section_law(section, beam.material));
  const std::vector<ElementSection<G>> sections = reduce_laws(beam, laws, space);
  const bool rigid = beam.as == BeamModel::Rigid ||
                     (beam.as == BeamModel::AsFormalism && formalism == Formalism::Rigid);
  const bool modal = beam.as == BeamModel::Modal ||
                     (beam.as == BeamModel::AsFormalism && formalism == Formalism::Floating);
  if (rigid || modal) {
    auto linear = std::make_unique<Beam<G>>(name, std::move(nodes), sections, beam.damping);
    if (rigid) return std::make_unique<Rigid<G>>(name, std::move(linear));
    return std::make_unique<ModalBody<G>>(std::move(linear), held, beam.modes);
  }
  if (formalism == Formalism::Decoupled || formalism == Formalism::Classical)
    return std::make_unique<ReissnerBeam<G>>(name, std::move(nodes), sections, beam.damping);
  return std::make_unique<Beam<G>>(name, std::move(nodes), sections, beam.damping);
}

template <class G>
std::unique_ptr<Body<G>> make_body(const std::string& name, const RigidSpec& rigid,
                                   const Space<G>& space, Formalism, const std::vector<int>&) {
  const SE3 align = space.alignment(rigid.frame);
  return std::make_unique<Rigid<G>>(name, space.reduce(rigid.frame, align),
                                    space.reduce_law(generalized_inertia(rigid), align));
}

template <class G>
std::unique_ptr<Body<G>> make_body(const std::string& name, const SolidSpec& solid,
                                   const Space<G>& space, Formalism formalism,
                                   const std::vector<int>&) {
  if (solid.mesh.dim != G::space_dim)
    throw std::invalid_argument("the mesh of '" + name + "' has " + std::to_string(solid.mesh.dim) +
                                " dimensions, its mechanism " + std::to_string(G::space_dim));
  const SE3 align = space.alignment(solid.frame);
  std::vector<G> ports;
  for (size_t k = 0; k < solid.interfaces.size(); ++k)
    ports.push_back(space.reduce(solid.port(static_cast<int>(k)), align));
  if (formalism != Formalism::Rigid && (solid.modes > 0 || ports.size() > 1))
    return std::make_unique<SolidBody<G>>(name, solid, std::move(ports), align.R);
  SolidSpec plain = solid;
  plain.modes = 0;
  return std::make_unique<Rigid<G>>(
      name, std::make_shared<SolidBody<G>>(name, plain, std::move(ports), align.R));
}

/// Three unit axes, the first one given, the second one as given or any; in a plane each of them
/// is in it or normal to it.
template <class G>
Mat3 axes_of(const JointSpec& j, const Space<G>& space) {
  Mat3 e;
  e.col(0) = j.axis;
  e.col(1) = j.axis.unitOrthogonal();
  if constexpr (G::space_dim == 2) {
    const Vec3 n = space.frame.R.col(2);
    e.col(1) = std::abs(n.dot(j.axis)) > 0.5 ? Vec3(space.frame.R.col(0)) : n;
  }
  if (j.type == JointType::Universal) e.col(1) = j.axis2;
  e.col(2) = e.col(0).cross(e.col(1));
  return e;
}

/// Turns the rows of a joint, given by spatial directions, into equations on G; a row that is an
/// identity in the plane is left out.
template <class G>
class JointRows {
 public:
  using Vector = typename Row<G>::Vector;
  JointRows(const Space<G>& space, std::vector<Equation<G>>& out) : space_(space), out_(out) {}

  void along(const Vec3& m, int coordinate = -1) {
    if (seen(m)) add(Row<G>::along(space_.reduce_vector(m)), coordinate);
  }
  void normal(const Vec3& m, const Vec3& n) {
    if (seen(m) && seen(n))
      add(Row<G>::normal(space_.reduce_vector(m), space_.reduce_vector(n)), -1);
  }
  /// Angle about the third axis: sine m . R n, cosine m2 . R n2.
  void angle(const Vec3& m, const Vec3& n, const Vec3& m2, const Vec3& n2, int coordinate) {
    if (seen(m) && seen(n) && seen(m2) && seen(n2))
      add(Row<G>::angle(space_.reduce_vector(m), space_.reduce_vector(n), space_.reduce_vector(m2),
                        space_.reduce_vector(n2)),
          coordinate);
  }

 private:
  bool seen(const Vec3& m) const { return space_.reduce_vector(m).norm() > 0.5 * m.norm(); }
  void add(const Row<G>& row, int coordinate) {
    Equation<G> e{
        row, coordinate < 0 ? Role::Constraint : Role::Observed, TimeFunction(), {}, coordinate};
    out_.push_back(e);
  }
  const Space<G>& space_;
  std::vector<Equation<G>>& out_;
};

/// The rows of each joint type: constraints first, then the coordinates it leaves.
template <class G>
void add_joint_rows(const JointSpec& j, const Space<G>& space, JointRows<G> rows) {
  const Mat3 e = axes_of(j, space);
  const Vec3 e1 = e.col(0), e2 = e.col(1), e3 = e.col(2);
  const auto type = j.type;
  const bool centred = type == JointType::Fixed || type == JointType::Revolute ||
                       type == JointType::Spherical || type == JointType::Universal;
  const bool slides = type == JointType::Prismatic || type == JointType::Cylindrical;
  if (centred || type == JointType::Planar) rows.along(e1);
  if (centred || slides) {
    rows.along(e2);
    rows.along(e3);
  }
  if (type == JointType::Universal) rows.normal(e1, e2);
  if (type != JointType::Universal && type != JointType::Spherical) {
    rows.normal(e2, e1);
    rows.normal(e3, e1);
  }
  if (type == JointType::Fixed || type == JointType::Prismatic) rows.normal(e3, e2);

  if (slides) rows.along(e1, 0);
  if (type == JointType::Planar) {
    rows.along(e2, 0);
    rows.along(e3, 1);
  }
  const int angle = type == JointType::Cylindrical ? 1 : type == JointType::Planar ? 2 : 0;
  if (type == JointType::Revolute || type == JointType::Universal ||
      type == JointType::Cylindrical || type == JointType::Planar)
    rows.angle(e3, e2, e2, e2, angle);
  if (type == JointType::Universal) rows.angle(e1, e3, e1, e1, 1);
}

/// The part of a gap between the two ports that is a motion of the joint.
Vec3 free_gap(const JointSpec& j, const Vec3& gap) {
  const Vec3 along = j.axis * j.axis.dot(gap);
  if (j.type == JointType::Prismatic || j.type == JointType::Cylindrical) return along;
  if (j.type == JointType::Planar) return gap - along;
  return Vec3::Zero();
}

template <class G>
class Builder {
 public:
  Builder(const Mechanism& m, const Space<G>& space, const Model<G>& model)
      : m_(m), space_(space), model_(model) {}

  /// Port with the axes of the plane (or the inertial ones), at a place given in the scene.
  PortOf<G> port_at(const Port& port, const Vec3& place) const {
    SE3 H = SE3::identity();
    if constexpr (G::space_dim == 2) H.R = space_.frame.R;
    H.x = place;
    return port_with(port, space_.reduce(H, SE3::identity()));
  }
  /// Port with its own axes.
  PortOf<G> port_of(const Port& port) const {
    const SE3 H = m_.frame(port);
    return port_with(port, space_.reduce(H, space_.alignment(H)));
  }

  Coupling<G> joint(int index) const {
    const JointSpec& j = m_.joints[index];
    Coupling<G> c;
    c.name = j.name;
    Vec3 at_a = m_.frame(j.a).x, at_b = m_.frame(j.b).x;
    if (j.a.body < 0)
      at_a = at_b;
    else if (j.b.body < 0)
      at_b = at_a;
    else
      at_a += free_gap(j, at_b - at_a);
    c.a = port_at(j.a, at_a);
    c.b = port_at(j.b, at_b);
    add_joint_rows(j, space_, JointRows<G>(space_, c.equations));
    for (size_t d = 0; d < m_.drives.size(); ++d)
      if (m_.drives[d].joint == index)
        if (Equation<G>* e = coordinate(c, m_.drives[d].coordinate)) {
          e->role = Role::Constraint;
          e->target = m_.drives[d].motion;
          e->drive = static_cast<int>(d);
        }
    for (size_t i = 0; i < m_.forces.size(); ++i)
      if (const ForceSpec& f = m_.forces[i]; f.joint == index)
        if (const Equation<G>* e = coordinate(c, f.coordinate)) {
          Equation<G> force = *e;
          force.force = static_cast<int>(i);
          force.drive = -1;
          force.law = {f.stiffness, f.damping, f.rest, f.force};
          force.role = role_of(force.law);
          force.coordinate = -1;
          c.equations.push_back(force);
        }
    return c;
  }

  Coupling<G> force(int index) const {
    const ForceSpec& f = m_.forces[index];
    Coupling<G> c;
    c.name = f.name;
    c.is_joint = false;
    c.a = port_of(f.a);
    c.b = port_of(f.b);
    const ForceLaw law{f.stiffness, f.damping, f.rest, f.force};
    c.equations.push_back({Row<G>::distance(), role_of(law), TimeFunction(), law, 0, index});
    return c;
  }

  Load<G> load(const LoadSpec& l) const {
    Load<G> load;
    load.port = port_of(l.port);
    load.spread = l.spread;
    load.follower = l.follower;
    load.scale = l.scale;
    const SE3::Tangent wrench = (SE3::Tangent() << l.force, l.moment).finished();
    load.wrench = l.follower ? space_.reduce_local(wrench, space_.alignment(m_.frame(l.port)))
                             : space_.reduce_wrench(l.force, l.moment);
    if (l.spread) {
      const Body<G>& body = *model_.bodies[l.port.body];
      load.distribution = body.load_distribution();
      load.share = body.load_share(l.follower);
    }
    return load;
  }

 private:
  PortOf<G> port_with(const Port& port, const G& frame) const {
    if (port.body < 0) return PortOf<G>::ground(frame);
    Port on = port;  // the node that the port's node follows, if it does
    if (model_.bodies[port.body]->kind(port.node) != NodeKind::Frame) on.node = 0;
    const SE3 H = node_frame(on);
    const G node = space_.reduce(H, space_.alignment(H));
    G offset = node.inverse() * frame;
    if (G::log(offset).norm() < 1e-14) offset = G::identity();
    return PortOf<G>::on(port.body, model_.first_node(port.body) + on.node, offset);
  }
  SE3 node_frame(const Port& port) const {
    Port node = port;
    node.offset = SE3::identity();
    return m_.frame(node);
  }
  static Role role_of(const ForceLaw& law) {
    return law.stiffness == 0 && law.damping == 0 ? Role::Actuator : Role::Compliant;
  }
  static Equation<G>* coordinate(Coupling<G>& c, int coordinate) {
    for (auto& e : c.equations)
      if (e.coordinate == coordinate) return &e;
    return nullptr;
  }

  const Mechanism& m_;
  const Space<G>& space_;
  const Model<G>& model_;
};

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

}  // namespace

template <class G>
Model<G> Model<G>::build(const Mechanism& mechanism, const Space<G>& space) {
  Model model;
  model.formalism = mechanism.formalism;
  model.space = space;
  model.gravity = space.reduce_vector(mechanism.gravity);
  model.length = mechanism.size() > 0 ? mechanism.size() : 1;
  const auto held = held_nodes(mechanism);
  for (const auto& spec : mechanism.bodies) {
    const auto& at = held[model.bodies.size()];
    model.first_node_.push_back(model.nodes_);
    model.bodies.push_back(std::visit(
        [&](const auto& kind) {
          return make_body<G>(spec.name, kind, space, mechanism.formalism, at);
        },
        spec.kind));
    for (int k = 0; k < model.bodies.back()->nodes(); ++k) {
      const NodeKind kind = model.bodies.back()->kind(k);
      if (kind == NodeKind::Frame) model.frames_.push_back(model.nodes_ + k);
      if (kind == NodeKind::Amplitudes) model.amplitudes_.push_back(model.nodes_ + k);
    }
    model.nodes_ += model.bodies.back()->nodes();
  }
  const Builder<G> builder(mechanism, space, model);
  for (size_t j = 0; j < mechanism.joints.size(); ++j)
    model.couplings.push_back(builder.joint(static_cast<int>(j)));
  for (size_t f = 0; f < mechanism.forces.size(); ++f)
    if (mechanism.forces[f].joint < 0)
      model.couplings.push_back(builder.force(static_cast<int>(f)));
  for (const auto& l : mechanism.loads) model.loads.push_back(builder.load(l));
  std::erase_if(model.couplings, [](const Coupling<G>& c) { return c.equations.empty(); });
  model.reach = model.length;
  for (const auto& body : model.bodies)
    for (const G& H : body->reference)
      model.reach = std::max(model.reach, model.length + H.x.norm());

  model.initial_velocity_.setZero(model.size());
  for (size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto& spec = mechanism.bodies[b];
    const auto at = [&](int k) {
      return mechanism.frame({static_cast<int>(b), k, SE3::identity()});
    };
    const SE3 first = at(0);
    for (int k = 0; k < model.bodies[b]->nodes(); ++k) {
      if (model.bodies[b]->kind(k) != NodeKind::Frame) continue;
      const SE3 H = at(k);
      SE3::Tangent v;
      v << H.R.transpose() * (spec.velocity + spec.angular_velocity.cross(H.x - first.x)),
          H.R.transpose() * spec.angular_velocity;
      model.initial_velocity_.template segment<G::dim>(G::dim * (model.first_node_[b] + k)) =
          space.reduce_local(v, space.alignment(H));
    }
  }
  model.finish();
  model.leave_out_redundant_rows();
  return model;
}

template <class G>
void Model<G>::leave_out_redundant_rows() {
  RedundantRows found = redundant_rows(*this, initial_state());
  redundant = std::move(found.sentences);
  dead_point = std::move(found.dead_point);
  if (found.rows.empty()) return;
  for (const auto& [coupling, equation] : found.rows)
    couplings[coupling].equations[equation].role = Role::Redundant;
  finish();
}

/// Numbers the rows, sorted by role within each coupling.
template <class G>
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
  for (auto& c : couplings) {
    place(c.a);
    place(c.b);
    std::stable_sort(c.equations.begin(), c.equations.end(),
                     [](const Equation<G>& a, const Equation<G>& b) { return a.role < b.role; });
    c.first_row = rows_;
    c.first_constraint = constraints_;
    c.constraints = c.active = c.acting = 0;
    for (const auto& e : c.equations) {
      c.constraints += e.role == Role::Constraint;
      c.active += e.role <= Role::Compliant;
      c.acting += e.role <= Role::Actuator;
    }
    rows_ += static_cast<int>(c.equations.size());
    constraints_ += c.constraints;
  }
}

template <class G>
void Model<G>::retract(State<G>& s, Eigen::Ref<const Eigen::VectorXd> delta) const {
  for (const int k : frames_) s.H[k] = s.H[k] * G::exp(delta.template segment<G::dim>(G::dim * k));
  for (const int k : amplitudes_)
    s.w.template segment<G::dim>(G::dim * k) += delta.template segment<G::dim>(G::dim * k);
}

template <class G>
void Model<G>::complete(State<G>& s) const {
  if (static_cast<int>(frames_.size()) == nodes_) return;
  for (size_t b = 0; b < bodies.size(); ++b) {
    const int n = first_node_[b];
    bodies[b]->complete(s.H.data() + n, s.v.data() + G::dim * n, s.vdot.data() + G::dim * n,
                        s.w.data() + G::dim * n);
  }
}

template <class G>
State<G> Model<G>::initial_state() const {
  State<G> s;
  for (const auto& body : bodies)
    s.H.insert(s.H.end(), body->reference.begin(), body->reference.end());
  s.v = initial_velocity_;
  s.vdot.setZero(size());
  s.a.setZero(size());
  s.w.setZero(size());
  s.lambda.setZero(constraints_);
  s.q.setZero(rows_);
  return s;
}

template class Model<SE2>;
template class Model<SE3>;

}  // namespace liesl
